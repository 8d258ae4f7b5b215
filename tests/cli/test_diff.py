"""`asemec diff`: what it says of versions that do and do not behave alike, with exit codes and bounds."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest

from tests.cli.support import Done, Here

KICK = """\
system Team
message Ball { double distance  bool visible }
topic vision { state Ball from outside }
topic voice { signal Ball }
srm player {
  liveness {
    player = Look~ || play~
    play   = Search . [Kick]
  }
  let close = vision.state.Ball.distance < 30 && vision.state.Ball.visible
  activities { Kick takes 200ms }
  control play {
    enter [Kick] : [has(vision.state.Ball)]
    enter Kick   : [close] / write_messages.voice.signal.Ball
    skip  Kick   : else
  }
}
"""

ASK = """\
system Shop
message Order { string what }
message Price { int euros }
aip buy {
  participant buyer {
    sends    request Order
    receives inform Price, refuse Order
    process  = Choose . Wait . (Pay | GoHome)
  }
  participant seller {
    sends    inform Price, refuse Order
    receives request Order
    process  = Look . Close
  }
  control buyer {
    enter Wait   : / send request Order { .. } to seller
    enter Pay    : inform Price from seller
    enter GoHome : refuse Order from seller or after(10s)
  }
  control seller {
    enter Look  : request Order from buyer
    enter Close : / send inform Price { euros = 5 } to buyer
  }
}
srm customer { plays buy.buyer liveness { customer = buyer } }
srm clerk { plays buy.seller liveness { clerk = seller~ } }
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def compare(here: Here, old: str, new: str, *options: str) -> Done:
    Path("old.aseme").write_text(old, "utf-8")
    Path("new.aseme").write_text(new, "utf-8")
    return here("diff", "old.aseme", "new.aseme", *options)


def changed(text: str, *pairs: tuple[str, str]) -> str:
    for before, after in pairs:
        assert before in text, before
        text = text.replace(before, after)
    return text


def runs(done: Done) -> dict[str, list[tuple[list[str], list[str], list[str]]]]:
    """Of each part the runs: the inputs, and what only the old and only the new version does then."""
    return {
        item["what"]: [
            (
                [event["input"] for event in one["run"]],
                [seen["text"] for seen in one["old"]],
                [seen["text"] for seen in one["new"]],
            )
            for one in item["differences"]
        ]
        for item in json.loads(done.out)["results"]
    }


@pytest.mark.parametrize(
    "pairs",
    [
        [("let close", "// nearby\n  let   close")],
        [("[close]", "[vision.state.Ball.distance < 30 && vision.state.Ball.visible]")],
        [("[close]", "[vision.state.Ball.visible && vision.state.Ball.distance < 30]")],
        [("[close]", "[!(!vision.state.Ball.visible || vision.state.Ball.distance >= 30)]")],
        [("close", "nearby")],
        [("play~", "match~"), ("play   =", "match  ="), ("control play", "control match")],
        [("Look~ || play~", "play~ || Look~")],
        [("play   = Search . [Kick]", "play = Search . shoot shoot = [Kick]"),
         ("enter [Kick] :", "enter shoot :"),
         ("    enter Kick ", "  }\n  control shoot {\n    enter Kick ")],
        [("message Ball", "message Extra { int n }\nmessage Ball"), ("message Extra { int n }\n", "")],
    ],
    ids="format let-inlined operands-swapped negated let-renamed formula-renamed regions-swapped"
    " formula-divided nothing".split(),
)  # fmt: skip
def test_what_only_says_it_otherwise_is_equal(here: Here, pairs: list[tuple[str, str]]) -> None:
    done = compare(here, KICK, changed(KICK, *pairs))
    assert (done.code, done.err) == (0, ""), done.out
    assert "no difference in behaviour" in done.out.splitlines()[0]


@pytest.mark.parametrize(
    ("pairs", "inputs", "old", "new"),
    [
        (
            [("distance < 30", "distance < 20")],
            ["it begins", "Search ends"],
            ["publishes voice.signal.Ball { distance = 0.0, visible = false }", "starts Kick"],
            ["starts Search"],
        ),
        (
            [("Search . [Kick]", "[Kick] . Search"), ("[has(vision.state.Ball)]", "")],
            ["it begins"],
            ["starts Search"],
            [],
        ),
        (
            [("Search . [Kick]", "Search . [Kick] . Rest")],
            ["it begins", "Search ends"],
            ["starts Search"],
            ["starts Rest"],
        ),
        (
            [(" / write_messages.voice.signal.Ball", "")],
            ["it begins", "Search ends"],
            ["publishes voice.signal.Ball { distance = 0.0, visible = false }"],
            [],
        ),
    ],
    ids="threshold order activity message".split(),
)
def test_the_shortest_run_that_shows_a_difference(
    here: Here, pairs: list[tuple[str, str]], inputs: list[str], old: list[str], new: list[str]
) -> None:
    done = compare(here, KICK, changed(KICK, *pairs), "--json")
    assert done.code == 1, done.err
    first = runs(done)["role player"][0]
    assert first[0] == inputs
    assert set(old) <= set(first[1])
    assert set(new) <= set(first[2])


@pytest.mark.parametrize("format", ["text", "github"])
def test_a_let_that_is_another_one_is_shown_where_it_is_used(here: Here, format: str) -> None:
    done = compare(here, KICK, changed(KICK, ("distance < 30", "distance < 20")), "--format", format)
    for limit in (30, 20):
        near = f"enter Kick : [vision.state.Ball.distance < {limit} && vision.state.Ball.visible]"
        assert near in done.out, done.out
    far = ("let close = ", f"let close = {'vision.state.Ball.distance > 1 && ' * 5}")
    done = compare(here, changed(KICK, far), changed(KICK, far, ("distance < 30", "distance < 20")))
    assert "distance < 30 && vis" in done.out and "distance < 20 && vis" in done.out, done.out


def test_a_longer_wait_is_seen_when_the_time_has_passed(here: Here) -> None:
    done = compare(here, ASK, changed(ASK, ("after(10s)", "after(20s)")), "--json")
    assert done.code == 1
    found = runs(done)
    inputs, old, new = found["protocol buy: buyer"][0]
    assert inputs == ["it begins", "Choose ends", "Wait ends", "10 s pass"]
    assert (old, new) == (["starts GoHome"], [])
    assert found["protocol buy: seller"] == []
    assert found["role customer"][0][1] == ["starts GoHome"]


def test_a_message_that_says_something_else(here: Here) -> None:
    done = compare(here, ASK, changed(ASK, ("euros = 5", "euros = 6")), "--json")
    assert done.code == 1
    inputs, old, new = runs(done)["protocol buy: seller"][0]
    assert inputs == ["it begins", 'request Order { what = "" } arrives from buyer', "Look ends"]
    assert old == ["sends inform Price to buyer { euros = 5 }"]
    assert new == ["sends inform Price to buyer { euros = 6 }"]


def test_a_rename_is_called_so_and_hides_nothing(here: Here) -> None:
    renamed = changed(KICK, ("Kick", "Shoot"))
    done = compare(here, KICK, renamed)
    assert (done.code, done.out.splitlines()[0]) == (
        0,
        "old.aseme -> new.aseme: no difference in behaviour, but in names",
    )
    assert "= activity Kick is called Shoot now  (old.aseme:11 -> new.aseme:11)" in done.out
    done = compare(here, KICK, changed(renamed, ("distance < 30", "distance < 20")), "--json")
    inputs, old, new = runs(done)["role player"][0]
    assert inputs == ["it begins", "Search ends"]
    assert "starts Shoot" in old
    assert new == ["starts Search"]


def test_participants_are_compared_by_their_new_names(here: Here) -> None:
    renamed = re.sub(r"\bseller\b", "trader", ASK)
    done = compare(here, ASK, changed(renamed, ("after(10s)", "after(5s)")), "--json")
    found = {what: items for what, items in runs(done).items() if items}
    assert set(found) == {"role customer", "protocol buy: buyer"}
    ((inputs, old, new),) = found["role customer"]
    assert (inputs[-1], old, new) == ("5 s pass", [], ["starts GoHome"])
    done = compare(here, ASK, changed(renamed, ("euros = 5", "euros = 6")), "--json")
    found = {what: items for what, items in runs(done).items() if items}
    assert set(found) == {"role clerk", "protocol buy: trader"}


MOODS = """\
system Moods
enum Mood { CALM BUSY }
message Note { int size  repeated string words }
topic wall { state Note from outside }
srm robot {
  var mood : Mood = Mood.CALM
  liveness { robot = Look . (Work | Rest) }
  activities { Look writes mood }
  control robot {
    enter Work : [mood == Mood.BUSY && has(wall.state.Note)]
    enter Rest : else
  }
}
"""


def test_enums_and_messages_show_what_has_changed(here: Here) -> None:
    done = compare(
        here, MOODS, changed(MOODS, ("CALM BUSY }", "CALM BUSY IDLE }"), ("int size", "double size"))
    )
    assert "  - { CALM BUSY }\n  + { CALM BUSY IDLE }\n" in done.out, done.out
    assert "  - { int size repeated string words }\n  + { double size repeated string words }\n" in done.out
    done = compare(here, MOODS, changed(MOODS, ("mood == Mood.BUSY", "mood != Mood.BUSY")))
    assert "(mood is CALM" in done.out or "(mood is BUSY" in done.out, done.out


def test_an_outcome_that_comes_otherwise_shows_when(here: Here) -> None:
    ends = changed(ASK, ("  control buyer", '  outcome "It is paid." when Pay@buyer\n  control buyer'))
    done = compare(here, ends, changed(ends, ("when Pay@buyer", "when Close@seller")))
    assert "  - when Pay@buyer\n  + when Close@seller\n" in done.out


def test_what_charts_do_not_show_is_a_difference_too(here: Here) -> None:
    done = compare(here, KICK, changed(KICK, ("takes 200ms", "takes 300ms")))
    assert done.code == 1
    assert "~ activity Kick  (old.aseme:11 -> new.aseme:11)\n  - takes 200ms\n  + takes 300ms\n" in done.out


def test_a_search_that_was_cut_is_never_equal(here: Here) -> None:
    new = changed(ASK, ("enter Close :", "enter Close : [1 < 2]"))
    assert compare(here, ASK, new).code == 0
    done = compare(here, ASK, new, "--states", "1")
    assert done.code == 3, done.out
    assert "no difference in behaviour was found, but not all was compared" in done.out
    assert re.search(
        r"role clerk: undecided, no difference was found, cut after 1 state \(2 states\)", done.out
    )


def test_as_a_comment_on_a_change(here: Here) -> None:
    done = compare(here, KICK, changed(KICK, ("distance < 30", "distance < 20")), "--format", "github")
    lines = done.out.splitlines()
    assert lines[0] == "<!-- asemec diff -->"
    assert lines[1] == "### ⚠️ `old.aseme` → `new.aseme`: the behaviour is different"
    assert done.out.count("<details>") == done.out.count("</details>") == 2
    assert "| changed | transition enter Kick of player |" in done.out


def test_the_picture_marks_what_was_added_changed_and_removed(here: Here, tmp_path: Path) -> None:
    new = changed(KICK, ("Search . [Kick]", "Search . [Kick] . Rest"), ("distance < 30", "distance < 20"))
    new = changed(new, ("    enter [Kick] : [has(vision.state.Ball)]\n", ""))
    done = compare(here, KICK, new, "-o", "drawn")
    assert "drawn: drawn/iac.player.diff.svg" in done.out
    tree = Xml.fromstring((tmp_path / "drawn" / "iac.player.diff.svg").read_text("utf-8"))
    names = [item.get("id") for item in tree.iter() if item.get("id")]
    assert len(names) == len(set(names))
    signs = [
        (item.get("class"), "".join(item.itertext()))
        for item in tree.iter()
        if (item.get("class") or "").startswith("badge")
    ]
    assert ("badge diff-added", "+") in signs
    assert ("badge diff-changed", "~") in signs
    assert ("badge diff-removed", "-") in signs


def test_a_drawing_that_cannot_be_written_is_an_error(here: Here) -> None:
    done = compare(here, KICK, changed(KICK, ("distance < 30", "distance < 20")), "-o", "old.aseme")
    assert (done.code, done.out) == (1, "")
    assert "error[E" in done.err


def test_two_revisions(here: Here, tmp_path: Path) -> None:
    def git(*words: str) -> None:
        settings = ["-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", *settings, *words], cwd=tmp_path, check=True, capture_output=True)

    file = tmp_path / "team.aseme"
    git("init", "-q")
    file.write_text(KICK, "utf-8")
    git("add", "team.aseme")
    git("commit", "-qm", "one")
    file.write_text(changed(KICK, ("distance < 30", "distance < 20")), "utf-8")
    for words in (["HEAD"], ["HEAD", "team.aseme"], ["HEAD:team.aseme", "team.aseme"]):
        done = here("diff", *words)
        assert done.code == 1, (words, done.err)
        assert "starts Kick" in done.out
    git("commit", "-qam", "two")
    assert here("diff", "HEAD~1", "HEAD").code == 1
    assert here("diff", "HEAD~1", "HEAD", "team.aseme").code == 1
    assert here("diff", "HEAD").code == 0
    done = here("diff", "nowhere", "HEAD")
    assert done.code == 2
    assert "there is no file nowhere, and no revision nowhere" in done.err
    done = here("diff", "HEAD:other.aseme", "team.aseme")
    assert (done.code, "HEAD has no other.aseme" in done.err) == (2, True)


def test_what_is_wrong_in_a_revision_has_its_name(here: Here, tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/ball.aseme").write_text("message Ball { doubel x }\n", "utf-8")
    (tmp_path / "team.aseme").write_text('system T\nimport "parts/ball.aseme"\n', "utf-8")
    for words in (["init", "-q"], ["add", "."], ["commit", "-qm", "one"]):
        settings = ["-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", *settings, *words], cwd=tmp_path, check=True, capture_output=True)
    done = here("diff", "HEAD", "team.aseme")
    assert (done.code, done.err.splitlines()[0][:34]) == (1, "HEAD:parts/ball.aseme:1:16: error["), done.err
    done = here("diff", "HEAD:parts/ball.aseme", "team.aseme")
    assert "HEAD:parts/ball.aseme declares no system" in done.err, done.err


def test_outside_of_a_repository(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(Path().resolve().parent))
    done = here("diff", "HEAD~1", "HEAD")
    assert done.code == 2
    assert "there is no file HEAD~1, and no revision of that name" in done.err
    monkeypatch.setenv("PATH", "/nowhere")
    assert "git is not installed" in here("diff", "HEAD~1", "HEAD").err


def test_a_version_with_errors(here: Here) -> None:
    done = compare(here, KICK, changed(KICK, ("[close]", "[clos]")))
    assert done.code == 1
    assert "new.aseme" in done.err
    assert "error[E" in done.err


TURNS = """\
system Turns
sag { actor coach { goal win "We win." } }
message Note { int size }
topic wall { state Note }
srm robot {
  var n : int = 0
  liveness { robot = Look~ || play  play = (A . (B | C))~ }
  control play { enter B : [n > 0]  enter C : else }
}
srm writer {
  liveness { writer = Start . (Wait . (Soon | Late))~ }
  control writer {
    enter (Wait . (Soon | Late))~ : / write_messages.wall.state.Note
    enter (Soon | Late)           : after(3s)
    enter Soon                    : [age(wall.state.Note) < 5s]
    enter Late                    : else
  }
}
srm sided {
  var is_left : bool = false
  liveness { sided = Wait . (Left | Right) }
  control sided { enter Left : [is_left]  enter Right : else }
}
srm cell {
  liveness { cell = Wait . (First | Second) }
  control cell { enter First : [index == 1]  enter Second : else }
}
team T { cell[1..2] : cell  one : robot  two : writer  three : sided  four : sided with is_left = true }
"""


@pytest.mark.parametrize(
    ("pairs", "role", "inputs"),
    [
        ([("int = 0", "int = 1")], "role robot", ["it begins", "A ends"]),
        (
            [("< 5s", "< 8s")],
            "role writer",
            ["it begins", "Start ends", "3 s pass", "Soon ends", "3 s pass"],
        ),
        (
            [("(Left | Right)", "(Left . Back | Right)"), ("enter Left", "enter (Left . Back)")],
            "role sided",
            ["it begins", "Wait ends", "Left ends"],
        ),
        (
            [("(First | Second)", "(First | Second . Back)"), ("enter Second", "enter (Second . Back)")],
            "role cell",
            ["it begins", "Wait ends", "Second ends"],
        ),
    ],
    ids="initial-value age settings index".split(),
)
def test_what_is_never_equal(here: Here, pairs: list[tuple[str, str]], role: str, inputs: list[str]) -> None:
    done = compare(here, TURNS, changed(TURNS, *pairs), "--json")
    assert (done.code, done.err) == (1, "")
    assert runs(done)[role][0][0] == inputs


BOTH = """\
system Both
message Bell { int n }
topic door { signal Bell  signal Knock from outside }
topic hall { signal Bell from outside }
message Knock { int n }
srm host {
  liveness { host = (Rest . Open)~ }
  activities { Rest ends woken, tired }
  control host { enter Open : when [hall.signal.Bell.n == 1 && door.signal.Knock.n == 1] }
}
team T { ann : host }
"""


@pytest.mark.parametrize("new", ["door.signal.Knock.n == 2", "outcome(Rest) == woken"])
def test_what_comes_at_one_moment_is_compared(here: Here, new: str) -> None:
    done = compare(here, BOTH, changed(BOTH, ("door.signal.Knock.n == 1", new)), "--json")
    assert done.code == 1
    assert any("; at the same moment " in way[0][-1] for way in runs(done)["role host"]), done.out


def test_a_role_that_is_called_as_an_actor_is_added(here: Here) -> None:
    new = changed(TURNS, ("team T {", "srm coach { liveness { coach = A } }\nteam T {"))
    done = compare(here, TURNS, new)
    assert (done.code, "+ role coach" in done.out) == (1, True), done.out


CHART = """\
system D
statechart s {
  state 0 OR  state 0.1 START  state 0.2 AND
  state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A1  state 0.2.1.3 BASIC A2
  state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC B1  state 0.2.2.3 BASIC B2
  0.1 -> (0.2.1.3, 0.2.2.3) :
  0.2.1.1 -> 0.2.1.2 :  0.2.1.2 -> 0.2.1.3 :  0.2.2.1 -> 0.2.2.2 :  0.2.2.2 -> 0.2.2.3 :
  0.2 -> 0.2 : after(9s)
}
"""


@pytest.mark.parametrize("instead", ["(0.2.1.3, 0.2.2.2)", "0.2", "0.2.2.3"])
def test_statecharts_are_compared_as_the_roles_of_formulas(here: Here, instead: str) -> None:
    done = compare(here, CHART, CHART.replace("(0.2.1.3, 0.2.2.3)", instead))
    assert done.code == 1
    assert "the behaviour is different" in done.out
    assert "role s: different" in done.out


def test_the_order_of_several_targets_is_no_difference(here: Here) -> None:
    done = compare(here, CHART, CHART.replace("(0.2.1.3, 0.2.2.3)", "(0.2.2.3, 0.2.1.3)"))
    assert "no difference in behaviour" in done.out
