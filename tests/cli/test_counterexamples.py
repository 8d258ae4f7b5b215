"""Counterexamples of `asemec prove`: scenarios that show on the real runtime what the search has found."""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

import pytest

from tests.cli.support import Here
from tests.cli.test_prove import BUY, CENTRES, FORGED, LATE, MEET
from tests.proofs.random_talks import talk_of

OPENS = """\
system Opens
message Job { int number }
message Done { int number }
aip talk {
  participant boss { sends request Job  receives inform Done  process = Wait . Close }
  participant hand { receives request Job  sends inform Done  process = Rest . Work . Tell }
  control boss { enter Wait : / send request Job to hand  enter Close : inform Done from hand }
  control hand { enter Work : request Job from boss  enter Tell : / send inform Done { number = 1 } to boss }
}
srm boss_role { plays talk.boss liveness { boss_role = boss } activities { Wait waits  Close takes 1s } }
srm hand_role { plays talk.hand liveness { hand_role = hand } activities { Rest waits } }
team T { ann : boss_role  bob : hand_role }
property "none closes" { never ann in Close }
"""
"""Its first message is sent before any activity has run: without code it says what a new message says."""

ROUND = """system Round
message Sun { bool up }
topic sky { state Sun from outside }
srm robot {
  liveness { robot = (Walk | Rest)~ }
  activities { Walk takes 1s  Rest takes 1s }
  control robot { enter Rest : [!sky.state.Sun.up]  enter Walk : else }
}
team T { x : robot }
property "it rests" { every x in Walk leads to x in Rest }
"""
"""It may walk for ever, as the sun need not set."""

TALKS = sorted({19, *range(int(os.environ.get("REPLAYED_TALKS", "6")))})
"""Random protocols whose counterexamples are played. In 19, an answer to an agent that has ended is dropped,
and a message behind it comes."""


@pytest.mark.parametrize(
    ("text", "refuted", "more"),
    [
        pytest.param(MEET, {"deadlock", "non-local choice"}, (), id="both wait"),
        pytest.param(LATE, {"agreement"}, (), id="a deadline crosses the answer"),
        pytest.param(
            FORGED,
            {"Carry@carrier before Settle@manager", "deadlock", "orphan messages"},
            (),
            id="an activity sends too early, or not, or twice",
        ),
        pytest.param(CENTRES, {"one centre", "deadlock"}, ("--states", "1000"), id="two beliefs"),
    ],
)
def test_what_is_refuted_fails_when_it_is_played(
    here: Here, folder: Path, text: str, refuted: set[str], more: tuple[str, ...]
) -> None:
    (folder / "a.aseme").write_text(text)
    proved = here("prove", "a.aseme", "--save", "found.aseme", "--stories", "stories", "--json", *more)
    found = [item for item in proved.json["results"] if item["verdict"] == "REFUTED"]
    assert {item["name"] for item in found} == refuted
    played = here("test", "found.aseme", "--json")
    assert played.code == 1
    verdicts = {item["name"]: item["verdict"] for item in played.json["scenarios"]}
    assert verdicts == {f"{item['name']} of {item['of']}": "failed" for item in found}
    drawn = [path.read_text() for path in (folder / "stories").glob("*.svg")]
    assert len(drawn) == len(found)
    agents = [line.split(" : ")[0].strip() for line in found[0]["scenario"].splitlines() if " : " in line]
    assert all(any(f">{name}<" in svg for name in agents) and svg.count("<text") > 5 for svg in drawn)
    ended = {name for item in found for name in re.findall(r" ends (\w+)", item["scenario"])}
    assert ended and all(f"{name} returns" in "".join(drawn) for name in ended)


def test_what_never_comes_is_shown_with_the_round_that_repeats(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(ROUND)
    done = here("prove", "a.aseme", "it rests", "--json")
    (found,) = done.json["results"]
    assert found["verdict"] == "REFUTED"
    assert found["counterexample"][-1].startswith("from here on, again and again: x: Walk ends")
    assert "x ends Walk" in found["scenario"]


def test_what_opens_a_conversation_may_have_been_prepared_by_nobody(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(OPENS)
    done = here("prove", "a.aseme", "none closes", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED"], done.out


@pytest.mark.parametrize(("number", "verdict"), [(0, "REFUTED"), (7, "UNDECIDED")])
def test_what_nobody_has_prepared_says_what_a_new_message_says(
    here: Here, folder: Path, number: int, verdict: str
) -> None:
    only = f"enter Work : request Job job from boss [job.number == {number}]"
    (folder / "a.aseme").write_text(OPENS.replace("enter Work : request Job from boss", only))
    done = here("prove", "a.aseme", "none closes", "--json")
    assert [item["verdict"] for item in done.json["results"]] == [verdict], done.out


def test_what_holds_leaves_no_file(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(BUY)
    done = here("prove", "a.aseme", "--save", "found.aseme")
    assert (done.code, done.err) == (0, "found.aseme: nothing to save: there is no counterexample\n")
    assert not (folder / "found.aseme").exists()


def test_it_says_what_was_saved(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(LATE)
    asked = "prove", "a.aseme", "agreement", "--save", "found.aseme"
    assert here(*asked).err == "found.aseme: 1 scenario added\n"
    assert here(*asked).err == "found.aseme: it has these scenarios already\n"
    assert here(*asked, "--json").err == ""


@pytest.mark.parametrize("command", ["prove", "test"])
def test_a_folder_is_no_file_to_save_in(here: Here, folder: Path, command: str) -> None:
    (folder / "a.aseme").write_text(LATE)
    (folder / "found").mkdir()
    done = here(command, "a.aseme", "--save", "found")
    assert (done.code, done.out) == (2, "")
    assert "Invalid value for '--save': File 'found' is a directory." in done.err


def test_a_story_names_no_line_that_the_file_does_not_have(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(LATE)
    here("prove", "a.aseme", "agreement", "--stories", "stories")
    (drawn,) = (path.read_text() for path in (folder / "stories").glob("*.svg"))
    assert "start of " in drawn
    last = len(LATE.splitlines())
    assert all(int(line) <= last for line in re.findall(r"a\.aseme:(\d+)", drawn))


def test_a_clause_of_a_file_with_an_alias_is_played(here: Here, folder: Path) -> None:
    text = LATE.replace("system Office", "").replace(
        "  outcome", "  clause every Rest@worker leads to Praise@boss\n  outcome", 1
    )
    (folder / "parts").mkdir()
    (folder / "parts/talk.aseme").write_text(text)
    (folder / "a.aseme").write_text('system A\nimport "parts/talk.aseme" as talk\n')
    clause = "every Rest@worker leads to Praise@boss"
    done = here("prove", "a.aseme", clause, "--save", "found.aseme")
    first = done.out.splitlines()[0]
    assert first.startswith(f"REFUTED   {clause} of protocol talk_ask (parts/talk.aseme:"), done.out
    assert f"failed   {clause} of protocol talk_ask" in here("test", "found.aseme").out
    alone = here("prove", "a.aseme", "talk.ask", clause)
    assert (alone.code, alone.out.splitlines()[0]) == (1, first)


def test_an_activity_that_may_fail_does_so_as_is_assumed(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(
        "system A\nsrm robot { liveness { robot = Grasp . Rest } }\nteam T { one : robot }\n"
        'property "it rests" { assume Grasp may fail  never one in Rest }\n'
    )
    done = here("prove", "a.aseme", "failures", "it rests", "--stories", "stories")
    assert "one fails: activity Grasp of state 0.2 fails, as is assumed [" in done.out
    drawn = (folder / "stories/it-rests-of-team.svg").read_text()
    assert "a.aseme:4:46: it is broken here" in drawn


def test_one_state_is_no_states(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(LATE)
    done = here("prove", "a.aseme", "agreement", "--states", "1")
    assert "the search was cut after 1 state [" in done.out
    assert "hint: to decide it, ask for it alone, with a larger limit: asemec prove" in done.out
    assert "--states 5" in done.out


def test_the_file_itself_may_take_them_once(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(LATE)
    here("prove", "a.aseme", "agreement", "--save", "a.aseme")
    first = (folder / "a.aseme").read_text()
    assert 'scenario "agreement of protocol ask"' in first
    assert here("test", "a.aseme").code == 1
    here("prove", "a.aseme", "agreement", "--save", "a.aseme")
    assert (folder / "a.aseme").read_text() == first


def test_a_run_whose_times_exclude_each_other_is_no_counterexample(here: Here, folder: Path) -> None:
    text = (
        "system S\n"
        "srm one { liveness { one = A . B } control one { enter B : after(1s) } }\n"
        "srm two { liveness { two = C . D } control two { enter D : after(10s) } }\n"
        "team t { one : one  two : two }\n"
        'property "order" { B before D }\n'
    )
    (folder / "a.aseme").write_text(text)
    (item,) = here("prove", "a.aseme", "order", "--json").json["results"]
    assert (item["verdict"], "all times" in item["bounds"]) == ("PROVED", True)
    (folder / "a.aseme").write_text(text.replace("after(1s)", "after(20s)"))
    done = here("prove", "a.aseme", "order", "--save", "found.aseme")
    assert "REFUTED" in done.out
    assert here("test", "found.aseme").code == 1


def test_what_is_decided_when_agents_begin_is_tried(here: Here, folder: Path) -> None:
    """The first step has as many ways as any other one."""
    (folder / "luck.py").write_text("def lucky() -> bool:\n    return False\n")
    (folder / "a.aseme").write_text(
        'system S\nfunction lucky() : bool = "luck:lucky"\n'
        "srm robot {\n  liveness { robot = (A | B) . C~ }\n"
        "  control robot { enter A : [lucky()]  enter B : else }\n}\n"
        'property "no A" { never robot in A }\n',
    )
    done = here("prove", "a.aseme", "--save", "found.aseme", "--json")
    verdicts = {item["name"]: item["verdict"] for item in done.json["results"]}
    assert (verdicts["no A"], verdicts["dead states"]) == ("REFUTED", "PROVED")
    assert "robot computes lucky = true" in (folder / "found.aseme").read_text()
    assert here("test", "found.aseme").code == 1


@pytest.mark.parametrize("seed", TALKS)
def test_what_is_refuted_of_a_random_protocol_fails_when_it_is_played(
    here: Here, folder: Path, seed: int
) -> None:
    (folder / "a.aseme").write_text(talk_of(random.Random(seed)))
    proved = here("prove", "a.aseme", "--states", "3000", "--save", "found.aseme", "--json")
    found = {
        f"{item['name']} of {item['of']}"
        for item in proved.json["results"]
        if item["verdict"] == "REFUTED" and item["name"] != "dead states"
    }
    assert not [item for item in proved.json["results"] if "abstract" in item["reason"]]
    if found:
        played = here("test", "found.aseme", "--json")
        assert {item["name"] for item in played.json["scenarios"] if item["verdict"] == "failed"} == found


# ---- stepwise scenarios -----------------------------------------------------------------------------

PASS = """\
system Pass
enum Where { HERE, THERE }
message Ball { int number }
topic field { state Ball  data Ball }
srm one {
  var tries : int
  liveness { one = Kick . Rest }
  activities { Kick writes field.state.Ball, field.data.Ball, tries ends hit, missed }
}
srm two {
  liveness { two = Wait . Catch }
  control two { enter Catch : [field.state.Ball.number == 3] }
}
team t { one : one  two : two }
"""


def _played(here: Here, folder: Path, *lines: str) -> tuple[int, str]:
    (folder / "a.aseme").write_text(
        PASS + 'scenario "s" {\n' + "".join(f"  {line}\n" for line in lines) + "}\n"
    )
    done = here("test", "a.aseme")
    return done.code, done.out + done.err


WAITS = """\
system Pair
message Go { int n }
aip pair {
  participant lead { sends request Go  receives agree Go  process = Call . Run }
  participant mate {
    var likes : bool
    sends agree Go
    receives request Go
    process = Wait . [Follow]
  }
  clause every Wait@mate leads to (Run@lead or Follow@mate)
  control lead {
    enter Call : / send request Go { n = 1 } to mate
    enter Run : agree Go from mate
  }
  control mate {
    enter Wait : request Go from lead
    enter Follow : [likes] / send agree Go { n = 1 } to lead
    skip Follow : else
  }
}
"""


@pytest.mark.parametrize(
    "team", ["", "srm one { plays pair.mate liveness { one = mate } } team T { mate : one }"]
)
def test_what_a_conversation_awaits_for_ever_has_not_come(here: Here, folder: Path, team: str) -> None:
    """Also if an agent of the team is called like a participant."""
    (folder / "a.aseme").write_text(WAITS + team)
    clause = "every Wait@mate leads to (Run@lead or Follow@mate)"
    done = here("prove", "a.aseme", clause, "--save", "found.aseme", "--json")
    verdicts = {item["of"]: item["verdict"] for item in done.json["results"]}
    assert verdicts["protocol pair"] == "REFUTED", done.out
    assert here("test", "found.aseme").code == 1


def test_what_a_conversation_of_a_team_awaits_when_all_have_left_has_not_come(
    here: Here, folder: Path
) -> None:
    """One of them has crashed."""
    text = (
        (
            WAITS.replace("[likes]", "[true]")
            + "srm one { plays pair.lead liveness { one = lead } }\n"
            + "srm two { plays pair.mate liveness { two = mate } }\n"
            + "team T { ann : one  bob : two }\n"
            + 'property "it" { assume at most 1 of one crash  never ann fails }\n'
        )
        .replace("leads to (Run@lead or Follow@mate)", "leads to Run@lead")
        .replace("never ann fails", "never fault")
    )
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", "every Wait@mate leads to Run@lead", "--json")
    verdicts = {item["of"]: item["verdict"] for item in done.json["results"]}
    assert verdicts == {"team": "REFUTED", "protocol pair": "PROVED"}, done.out


CROSSING = """\
system Crossing
message Press { bool on }
topic button { signal Press from outside }
srm lights {
  var asked : bool = false
  liveness { lights = (Cars . Gap . [Walk])~ || (Listen . Note)~ }
  activities { Cars takes 10s  Gap takes 2s  Walk takes 5s  Listen waits  Note takes 100ms }
  control lights {
    enter Walk : [asked] / asked = false
    skip  Walk : else
    enter Note : when [button.signal.Press.on] / asked = true
    repeat (Listen . Note) : [!asked]
  }
}
team Street { one : lights }
property "the lamp goes out" { every one in Note leads to not one in Note }
"""


def test_a_round_is_played_whose_activities_begin_in_another_order(here: Here, folder: Path) -> None:
    """Who presses again meanwhile finds the lamp on: it goes out and on within one step."""
    (folder / "a.aseme").write_text(CROSSING)
    done = here("prove", "a.aseme", "the lamp goes out", "--save", "found.aseme", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED"], done.out
    assert here("test", "found.aseme").code == 1


PICKS = """\
system Picks
message Job { int shelf }
topic desk { signal Job from outside }
srm picker {
  liveness { picker = (Tidy . Fetch)~ }
  activities { Tidy takes 5s reads desk.signal.Job  Fetch takes 10s }
  control picker { enter Fetch : [has(desk.signal.Job)] }
}
team Shop { ann : picker }
property "each job is fetched" { every ann has [has(desk.signal.Job)] leads to ann in Fetch }
"""
"""Who tidies may read the job itself: then it is gone when it has tidied."""
REPLACED = PICKS.replace("reads desk.signal.Job", "").replace(
    "has(desk.signal.Job)", "desk.signal.Job.shelf > 0"
)
"""A job that comes later takes the place of one that waits."""
TWICE = """\
system Bell
message Ring { int n }
topic door { signal Ring from outside }
srm host {
  var heard : int = 0
  liveness { host = Hear || (Cook . Rest . Open) }
  activities { Hear waits  Cook takes 5s  Rest takes 5s  Open takes 1s }
  control host {
    on    Hear : when [has(door.signal.Ring) && heard < 2] / heard = heard + 1
    enter Open : [has(door.signal.Ring)]
  }
}
team Home { ann : host }
property "who cooks hears one" { never (ann in Cook and ann has [heard > 1]) }
"""
"""One region hears each ring at once, the other one when it has cooked."""
LINE = """\
system Line
message Job { int shelf }
topic desk { signal Job queued from outside }
srm picker {
  var taken : int = 0
  liveness { picker = Tidy . Look . Fetch }
  activities { Tidy takes 5s  Look waits  Fetch takes 1s }
  control picker {
    on    Look  : when [has(desk.signal.Job) && taken < 2] / taken = taken + 1
    enter Fetch : when [!has(desk.signal.Job) || taken == 2]
  }
}
team Shop { ann : picker }
property "one job" { never (ann in Fetch and ann has [taken > 1]) }
"""
"""It takes all jobs that wait when it has tidied, in one step."""


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        pytest.param(PICKS, "REFUTED", id="its code reads it"),
        pytest.param(PICKS.replace("reads desk.signal.Job", ""), "PROVED", id="it may not read it"),
        pytest.param(
            PICKS.replace("enter Fetch :", "enter Fetch : when"), "PROVED", id="a condition is first"
        ),
    ],
)
def test_an_activity_may_take_the_signal_that_a_condition_waits_for(
    here: Here, folder: Path, text: str, verdict: str
) -> None:
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", "each job is fetched", "--save", "found.aseme", "--json")
    assert [item["verdict"] for item in done.json["results"]] == [verdict], done.out
    if verdict == "REFUTED":
        assert "ann does Tidy takes desk.signal.Job" in (folder / "found.aseme").read_text()
        assert here("test", "found.aseme").code == 1


@pytest.mark.parametrize(
    ("text", "name"),
    [
        pytest.param(REPLACED, "each job is fetched", id="it takes the place of the first"),
        pytest.param(TWICE, "who cooks hears one", id="another region has taken the first"),
        pytest.param(LINE, "one job", id="they queue"),
    ],
)
def test_a_signal_comes_while_one_waits(here: Here, folder: Path, text: str, name: str) -> None:
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", name, "--save", "found.aseme", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED"], done.out
    assert here("test", "found.aseme").code == 1


LEAVES = """\
system Leaves
message Job { int number }
aip talk {
  participant boss { process = Ask . Wait }
  participant hand [1..*] { process = Work }
  control boss {
    enter Wait : / send request Job { number = 1 } to hand
    on    Wait : inform Job from hand
    leave Wait : when [all_answered(hand)]
  }
  control hand { enter Work : request Job from boss  leave Work : / send inform Job { number = 1 } to boss }
}
srm chief { plays talk.boss  liveness { chief = boss } }
srm helper {
  plays talk.hand
  liveness { helper = hand [> GoHome }
  control helper { enter GoHome : evening }
}
team Office { ann : chief  bob, cem : helper }
property "she goes on" { every ann in Ask leads to not ann in Ask and not ann in Wait }
"""
"""Where both have gone home before, nobody is asked: nothing comes, and nobody is lost."""


def test_where_all_have_ended_nobody_is_asked(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(LEAVES)
    done = here("prove", "a.aseme", "she goes on", "--save", "found.aseme", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED"], done.out
    assert here("test", "found.aseme").code == 1


def test_in_a_stepwise_scenario_nothing_ends_or_arrives_by_itself(here: Here, folder: Path) -> None:
    assert _played(here, folder, "stepwise", "at 60s one in Kick and two in Wait")[0] == 0
    lines = (
        "stepwise",
        "at 1s two ends Wait",
        "at 2s one ends Kick with missed sets tries = 2 writes field.state.Ball { number = 3 }",
        "at 3s two in Wait and one has [tries == 2]",
        "at 4s two gets field.state.Ball from one",
        "at 5s two in Catch",
    )
    code, said = _played(here, folder, *lines)
    assert code == 0, said


def test_until_a_moment_a_scenario_is_stepwise(here: Here, folder: Path) -> None:
    assert _played(here, folder, "stepwise until 5s", "at 4s one in Kick", "by 6s one in Rest")[0] == 0


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (("stepwise", "at 1s two gets field.state.Ball from one"), "it is not the next on its way from one"),
        (("stepwise", "at 1s one ends Rest"), "Rest does not run in one then"),
        (("at 1s one ends Kick",), "`ends` in a scenario that is not stepwise"),
        (("stepwise", "network delay 1s"), "`network` in a scenario that is stepwise"),
        (("stepwise", "at 1s one ends Kick with hot"), "`Kick` has no outcome `hot`"),
        (("stepwise", "at 1s one does Kik"), "there is no activity `Kik`"),
        (("stepwise", "at 1s one computes far = 3"), "there is no function `far`"),
        (("stepwise", "at 1s two gets infrom Ball from one"), "infrom"),
        (("stepwise", "one ends Kick"), "`ends` without a moment"),
    ],
)
def test_what_cannot_be_done_by_hand_is_said(
    here: Here, folder: Path, lines: tuple[str, ...], said: str
) -> None:
    code, text = _played(here, folder, *lines)
    assert code == 1
    assert said in text


def test_what_is_missed_does_not_come(here: Here, folder: Path) -> None:
    lines = (
        "stepwise",
        "at 1s two ends Wait",
        "at 2s one ends Kick writes field.state.Ball { number = 3 } writes field.state.Ball { number = 4 }",
        "at 3s two misses field.state.Ball from one",
        "at 4s two gets field.state.Ball from one",
        "at 5s two in Wait",
    )
    code, said = _played(here, folder, *lines)
    assert code == 0, said


DURATIONS = """system Long
message Rest { duration least  optional Rest next }
message Plan { duration lease  Rest rest }
topic desk { state Plan from outside }
suc { role other : external }
srm one {
  var left : duration = 0s
  liveness { one = Look . (Long | Short) }
  activities { Look writes left }
  control one {
    enter Long  : [desk.state.Plan.lease > 2s && desk.state.Plan.rest.least < 5s && left == 3s]
    enter Short : else
  }
}
team T { ann : one }
property "short" { never ann in Long }
"""


def test_durations_are_written_with_their_units(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(DURATIONS)
    (found,) = here("prove", "a.aseme", "short", "--json").json["results"]
    assert found["verdict"] == "REFUTED", found["reason"]
    assert "{ lease = 2000.000001ms  rest.least = 4999.999999ms }" in found["scenario"]
    assert "sets left = 3s" in found["scenario"]
