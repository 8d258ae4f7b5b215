"""`asemec test --coverage` and `asemec coverage`: what is counted, and from what."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from aseme_dsl.play.coverage.seen import Seen
from aseme_dsl.project.building.build import Choice
from aseme_dsl.project.testing.coverage import model_of, read_runs
from tests.cli.support import Here
from tests.faults.changing import version
from tests.play.test_replay import recorded
from tests.runtime.playing import MS
from tests.support.generated import generate
from tests.support.traces import records_of, texts_of

LIFT = """\
system Lift
message Call { int floor  bool urgent }
topic panel { state Call }
sag { actor lift { goal ride "One is taken to the floor."  goal rest "It does not burn."  goal fly "No." } }
suc { usecase ride realises Travel  usecase rest realises Wait }
srm lift {
  liveness { lift = (Wait . [Travel])~ }
  activities { Wait takes 1s simulated  Travel takes 3s simulated ends arrived, stuck }
  control lift {
    enter Travel : [panel.state.Call.floor > 3 && !panel.state.Call.urgent || false]
    skip  Travel : else
    exit  Travel : / start_timer(t, 1s)
  }
}
scenario "high" { one : lift  at 100ms one receives panel.state.Call { floor = 4 }  by 2s one in Travel }
scenario "urgent" {
  one : lift
  at 100ms one receives panel.state.Call { floor = 4  urgent = true }
  never one in Travel
  for 5s
}
scenario "low" {
  one : lift
  at 100ms one receives panel.state.Call { floor = 1 }
  never one in Travel
  for 5s
}
"""


@pytest.fixture
def lift(here: Here, folder: Path) -> Here:
    (folder / "lift.aseme").write_text(LIFT)
    return here


def shares(found: Any) -> dict[str, tuple[int, int, int, int]]:
    return {
        kind: (item["covered"], item["total"], item["never"], item["not_measured"])
        for kind, item in found["coverage"]["shares"].items()
    }


def statuses(found: Any, kind: str) -> dict[str, tuple[str, int]]:
    items = found["coverage"]["items"]
    return {item["name"]: (item["status"], item["times"]) for item in items if item["kind"] == kind}


def test_scenarios_cover_parts_of_all_models(lift: Here) -> None:
    done = lift("test", "lift.aseme", "--coverage", "--json")
    assert done.code == 0
    assert shares(done.json) == {
        "goals": (2, 2, 1, 0),
        "use_cases": (2, 2, 1, 0),
        "formulas": (1, 1, 0, 0),
        "states": (5, 5, 0, 0),
        "transitions": (8, 10, 0, 0),
        "conditions": (2, 2, 1, 0),
        "outcomes": (0, 2, 0, 0),
    }
    goals = statuses(done.json, "goal")
    assert (goals["ride"], goals["fly"]) == (("covered", 1), ("never", 0))
    assert goals["rest"] == statuses(done.json, "state")["Wait"]
    assert statuses(done.json, "outcome")["arrived of Travel"] == ("missed", 0)


def test_a_part_is_covered_once_it_is_shown_to_decide(lift: Here) -> None:
    def conditions(name: str) -> list[tuple[str, str]]:
        done = lift("test", "lift.aseme", "--coverage", "--json", "-k", name)
        items = done.json["coverage"]["items"]
        return [(item["status"], item["reason"]) for item in items if item["kind"] == "condition"]

    always, never, unasked = "it always held", "it never held", "it was never evaluated"
    constant = ("never", "it is constant")
    assert conditions("low") == [("missed", never), ("missed", unasked), constant]
    assert conditions("high") == [("missed", always), ("missed", always), constant]
    assert conditions("urgent") == [("missed", always), ("missed", never), constant]


def test_traces_and_scenarios_count_together(lift: Here, folder: Path) -> None:
    assert lift("run", "lift.aseme", "--for", "5s", "--quiet", "--allow", "waiting").code == 0
    alone = lift("coverage", "out/trace.jsonl.gz", "--json")
    assert (alone.code, alone.json["coverage"]["traces"]) == (0, 1)
    assert shares(alone.json)["conditions"] == (0, 2, 1, 0)
    assert lift("test", "lift.aseme", "--coverage-file", "some.json", "-k", "high").code == 0
    both = lift("coverage", "some.json", "out/trace.jsonl.gz", "--json")
    assert shares(both.json)["states"] == (5, 5, 0, 0)
    once = lift("coverage", "some.json", "--json")
    waits = [statuses(item.json, "state")["Wait"][1] for item in (alone, once, both)]
    assert waits[2] == waits[0] + waits[1] > waits[0] > 1
    # A file, a project and an output directory stand for their last run.
    assert lift("coverage", "lift.aseme", "--json").json == alone.json
    assert lift("coverage", "out", "--json").json == alone.json
    # By hand: a state is entered when a step takes a transition into it.
    records = records_of(folder / "out/trace.jsonl.gz")
    ways = [way for record in records if record["kind"] == "step" for way in record["taken"]]
    label = next(item["label"] for item in records if item.get("activity") == "Wait")
    assert waits[0] == sum(way["target"] == label for way in ways)


def without_model(trace: Path, path: Path) -> None:
    """Write a trace as of an earlier version, which cannot be replayed."""
    header, *others = texts_of(trace)
    record = json.loads(header)
    del record["sources"]
    path.write_text("\n".join((json.dumps(record), *others, "")))


def test_conditions_of_a_trace_are_those_of_its_replay(lift: Here, folder: Path) -> None:
    calls = ((0, {"floor": 1}), (3, {"floor": 4, "urgent": True}), (8, {"floor": 4}))
    inputs = [{"at": f"{at}s", "channel": "panel.state.Call", "message": call} for at, call in calls]
    (folder / "calls.jsonl").write_text("".join(f"{json.dumps(item)}\n" for item in inputs))
    arguments = ("--input", "calls.jsonl", "--for", "15s", "--quiet", "--allow", "waiting")
    assert lift("run", "lift.aseme", *arguments).code == 0
    assert shares(lift("coverage", "out", "--json").json)["conditions"] == (2, 2, 1, 0)
    without_model(folder / "out/trace.jsonl.gz", folder / "old.jsonl")
    old = lift("coverage", "old.jsonl", "--json")
    assert (old.code, shares(old.json)["conditions"]) == (0, (0, 2, 1, 2))
    assert old.json["coverage"]["shares"]["conditions"]["percent"] is None
    assert "it does not hold the model" in old.json["coverage"]["notes"][0]


def test_less_than_wanted_is_an_error(lift: Here, folder: Path) -> None:
    def under(*words: str) -> tuple[int, str]:
        options = [item for word in words for item in ("--fail-under", word)]
        done = lift("test", "lift.aseme", "-k", "low", *options)
        return done.code, done.err

    assert under("60") == (0, "")
    assert under("80") == (0, "")
    assert under("80.1") == (1, "80.0% of the states are covered, but 80.1% are wanted\n")
    assert under("60", "use-cases=90")[1] == "50.0% of the use cases are covered, but 90% are wanted\n"
    assert lift("run", "lift.aseme", "--for", "5s", "--quiet", "--allow", "waiting").code == 0
    without_model(folder / "out/trace.jsonl.gz", folder / "old.jsonl")
    done = lift("coverage", "old.jsonl", "--fail-under", "conditions=1")
    assert (done.code, done.err) == (1, "conditions were not measured, but 1% of them are wanted\n")
    assert [under(word)[0] for word in ("x", "101", "colours=3")] == [2, 2, 2]
    assert "Did you mean 'states'?" in under("state=3")[1]


def test_what_cannot_be_counted_is_said(lift: Here, folder: Path) -> None:
    assert lift("run", "lift.aseme", "--for", "2s", "--quiet", "--allow", "waiting").code == 0
    assert lift("test", "lift.aseme", "--coverage-file", "some.json").code == 0
    (folder / "lift.aseme").write_text(LIFT.replace("> 3", "> 4"))
    for file, who in (("out/trace.jsonl.gz", "lift"), ("some.json", "lift")):
        done = lift("coverage", file, "--source", "lift.aseme")
        assert (done.code, done.out) == (1, "")
        assert f"{file}: error[E035]: `{who}` ran another version of `Lift`" in done.err
    for text in ("", "{}", "[1]", '{"kind": "asemec coverage", "format": 9}', "[" * 100_000, "\x00"):
        (folder / "some.json").write_text(text)
        done = lift("coverage", "some.json", "--source", "lift.aseme")
        assert (done.code, done.err.count("error[E035]"), "Traceback" in done.err) == (1, 1, False)
    assert "there is no file no.json" in lift("coverage", "no.json", "--source", "lift.aseme").err
    assert lift("test", "lift.aseme", "--coverage-file", "cover.txt").code == 2
    assert lift("test", "lift.aseme", "--coverage-file", "lift.aseme").code == 2


def test_a_page_has_the_statecharts_in_colours(lift: Here, folder: Path) -> None:
    assert lift("test", "lift.aseme", "-k", "low", "--html", "page.html").code == 0
    text = (folder / "page.html").read_text("utf-8")
    assert not re.search(r"<script|https?://(?!www.w3.org/)|<link|@import|url[(]", text)
    assert text.count("prefers-color-scheme:dark") == 2
    drawing = ElementTree.fromstring(re.findall(r"<svg.*?</svg>", text, re.DOTALL)[0])
    groups = [item for item in drawing.iter("{http://www.w3.org/2000/svg}g") if item.get("class")]
    titles = [(item.findtext("{*}title", "").split(), item.get("class")) for item in groups]
    states = {words[2]: name for words, name in titles if words[1:2] == ["BASIC"]}
    assert (states["Wait"], states["Travel"]) == ("state covered", "state missed")
    tips = {item.get("class"): item.findtext("{*}title", "") for item in groups if item.get("data-c")}
    assert {"line covered", "line missed"} <= set(tips)
    # Colours reach the lines inside groups, too.
    assert ".line.missed path{" in text and ">path" not in text and ">rect" not in text
    assert "it never held" in tips["line missed"] or "taken 0 times" in tips["line missed"]
    # Again over its own, but not over the user's.
    assert lift("test", "lift.aseme", "-k", "low", "--html", "page.html").code == 0
    (folder / "page.html").write_text("<p>mine</p>")
    assert lift("test", "lift.aseme", "--html", "page.html").code == 2
    assert lift("coverage", "out", "--html", "page.svg").code != 0
    done = lift("test", "lift.aseme", "--html", "no/page.html")
    assert (done.code, "Traceback" in done.err) in ((0, False), (1, False))


def test_goals_have_what_serves_them(lift: Here) -> None:
    found = lift("goals", "lift.aseme", "--json").json["goals"]
    ride, rest, fly = found["goals"]
    assert [item["name"] for item in ride["states"]] == ["Travel"]
    assert [item["name"] for item in ride["scenarios"]] == ["high", "urgent", "low"]
    assert [item["name"] for item in ride["formulas"]] == ["lift"]
    assert ([item["name"] for item in rest["states"]], rest["scenarios"]) == (["Wait"], [])
    assert fly["states"] == []
    dangling = [(item["kind"], item["name"], item["reason"]) for item in found["dangling"]]
    assert dangling == [
        ("goal", "fly", "no state serves it"),
        ("goal", "rest", "no scenario names a state that serves it"),
    ]
    assert lift("run", "lift.aseme", "--for", "5s", "--quiet", "--allow", "waiting").code == 0
    assert lift("test", "lift.aseme", "--coverage-file", "some.json", "-k", "high").code == 0
    found = lift("goals", "lift.aseme", "out", "some.json", "--json").json["goals"]
    assert found["runs"] == 2
    assert [(goal["name"], goal["runs"]) for goal in found["goals"]] == [("ride", 1), ("rest", 2), ("fly", 0)]
    assert "  reached once, in 1 of 2 runs\n" in lift("goals", "lift.aseme", "out", "some.json").out
    assert lift("test", "lift.aseme", "--coverage-file", "some.json").code == 0
    said = lift("goals", "lift.aseme", "some.json").out
    assert ("in 1 of 1 file with 3 runs" in said, "never reached in 3 runs" in said) == (True, True), said


def test_the_list_is_short_and_begins_with_the_own_files(here: Here, folder: Path) -> None:
    states = " | ".join(f"S{n}" for n in range(40))
    lines = "\n".join(f"    enter S{n} : [panel.state.Call.floor == {n}]" for n in range(39))
    (folder / "many.aseme").write_text(f"""\
system Many
import protocols
message Call {{ int floor }}
topic panel {{ state Call }}
srm clerk {{
  plays request.responder
  liveness {{
    clerk = (responder~)[3] || choice~
    choice = {states}
  }}
  control choice {{
{lines}
    enter S39 : else
  }}
}}
scenario "one" {{ one : clerk  at 1s one receives panel.state.Call {{ floor = 3 }}  by 2s one in S3 }}
""")
    done = here("test", "many.aseme", "--coverage")
    missing = done.out.partition("not covered\n")[2].partition("\n\n")[0].splitlines()
    assert len(missing) == 21, done.out
    assert "S0" in missing[0] and "many.aseme:9" in missing[0], done.out
    assert re.fullmatch(r"  \.\.\. and \d+ states, .*\(all: --json\)", missing[-1]), done.out
    assert sum("<stdlib>" in line for line in missing) == 0, done.out
    found = here("test", "many.aseme", "--coverage", "--json").json["coverage"]["items"]
    assert sum(item["status"] == "missed" for item in found) > 60


def test_what_reads_alike_is_one_line(here: Here, folder: Path) -> None:
    (folder / "desk.aseme").write_text("""\
system Desks
srm clerk { liveness { clerk = (desk~)[3]  desk = Wait . [Serve] }
  control desk { enter Serve : [count(Wait) > 99]  skip Serve : else }
}
scenario "one" { one : clerk  by 2s one in Wait }
""")
    done = here("test", "desk.aseme", "--coverage")
    assert "  state      clerk: Serve, with 1 transition inside, in 3 instances  desk.aseme:2:" in done.out


def test_people_read_what_is_missing_with_its_place(lift: Here) -> None:
    done = lift("test", "lift.aseme", "--coverage", "-k", "low")
    assert done.out.endswith("""\
coverage of Lift: 1 scenario
             covered     of
goals              1      2   50%   1 can never be reached
use cases          1      2   50%   1 can never be reached
formulas           1      1  100%
states             4      5   80%
transitions        7     10   70%
conditions         0      2    0%   1 can never be reached
outcomes           0      2    0%

not covered
  goal       lift: ride  lift.aseme:5:15
  use case   lift: ride  lift.aseme:5:15
  state      lift: Travel, with 2 transitions inside  lift.aseme:7:30
  transition lift: choice in [Travel] -> Travel [panel.state.Call.floor > 3 && \
!panel.state.Call.urgent || false]  lift.aseme:10:5
  condition  lift: panel.state.Call.floor > 3 (choice in [Travel] -> Travel): \
it never held  lift.aseme:10:21
  condition  lift: !panel.state.Call.urgent (choice in [Travel] -> Travel): \
it was never evaluated  lift.aseme:10:52
  outcome    lift: arrived of Travel  lift.aseme:8:41
  outcome    lift: stuck of Travel  lift.aseme:8:41

can never be reached
  goal       lift: fly: no state serves it  lift.aseme:4:96
  use case   lift: fly: no state serves it  lift.aseme:4:96
  condition  lift: false (choice in [Travel] -> Travel): it is constant  lift.aseme:10:79
""")


WALKER = """\
system Walker
message Ball { double distance  bool seen }
topic eyes { state Ball }
srm r {
  var n : int = 0
  let near = !(eyes.state.Ball.distance > 2 || !eyes.state.Ball.seen)
  liveness { r = Walk . (Kick | Stand) . Rest }
  activities { Walk takes 1s  Kick takes 1s  Stand takes 1s  Rest takes 1s }
  control r {
    enter Kick  : [near && !(n > 3)]
    enter Stand : else
    enter Rest  : [!(n > 3 && n < 2) && eyes.state.Ball.distance > 4]
  }
}
team T { bob : r }
scenario "rests" {
  at 500ms bob receives eyes.state.Ball { distance = 1  seen = true }
  by 3s bob in Rest
}
"""


def test_stories_have_conditions_as_written_also_under_coverage(here: Here, folder: Path) -> None:
    (folder / "walker.aseme").write_text(WALKER)
    story = here("test", "walker.aseme").out.partition("1 scenario: ")[0]
    assert "Walk -> Kick : [near && !(n > 3)]" in story
    assert here("test", "walker.aseme", "--coverage").out.startswith(story)


def test_a_run_that_changes_to_the_model_is_counted_from_there_on(tmp_path: Path) -> None:
    old = "system W  srm r { liveness { r = (A . B)+ }  activities { A takes 70ms  B takes 30ms } }"
    new = old.replace(
        "B takes 30ms }",
        "B takes 30ms  C takes 10ms }  var n : int = 0\n"
        "  control r { leave (A . C . B) : [n > 3 || n < -1]  repeat (A . C . B) : / n += 1 }",
    )
    new = new.replace("(A . B)", "(A . C . B)")
    recorded(old, tmp_path, lambda team: team.swap(version(new), at=210 * MS), until=600 * MS)
    found = {}
    for name, text in (("old", old), ("new", new)):
        seen, model = Seen(), model_of(generate(text).system, Choice())
        assert read_runs(model, [tmp_path / "trace.jsonl"], seen, conditions=True) == ()
        assert seen.evaluated == 1, seen.left_out
        states = seen.roles["r"].entered
        found[name] = {state.name: states[state.label] for state in model.system.iacs[0].states}
        assert bool(seen.evaluations) is (name == "new")
    assert (found["old"]["A"], found["old"]["B"]) == (3, 2)
    assert found["new"]["A"] + found["old"]["A"] == 6 and found["new"]["C"] == 4
