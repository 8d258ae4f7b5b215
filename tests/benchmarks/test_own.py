"""Anybody's file beside the peers: what they are told of it means what the reference interpreter does."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from aseme_dsl.project.studying.course import Course
from aseme_dsl.project.studying.drawn import drawn
from aseme_dsl.project.studying.recorded import recorded
from aseme_dsl.runtime.version.loading import importing
from benchmarks.behaviours.counts import counts_of
from benchmarks.behaviours.description import (
    Behaviour,
    as_json,
    entered,
    from_json,
    instrumented,
    left,
    walk,
)
from benchmarks.behaviours.own import Refused, described, identifier, one_by_one
from benchmarks.peers import own_report
from benchmarks.peers.adapters.python_code import know_functions
from benchmarks.peers.contenders import CORE_TYPED, SEND, SISMIC, TRANSITIONS
from benchmarks.peers.measuring import Series
from benchmarks.peers.own import Found, Role, measured
from tests.benchmarks.following import Follower
from tests.runtime.playing import SECOND, make
from tests.support.generated import Generated, generate
from tests.support.lamp import LAMP

ROOT = Path(__file__).parents[2]


WORKER = """
system Par
message S { int n  optional int m }
topic t { state S }
srm worker {
  var n : int = 0
  liveness {
    worker = eyes || hands
    eyes = (Look | Blink)~
    hands = (Grasp . [Lift] . Drop)~
  }
  activities { Grasp takes 1s writes n  Look takes 1s  Blink takes 1s  Lift takes 1s  Drop takes 1s }
  control eyes {
    enter Look : [t.state.S.n > 3]
    enter Blink : else
    repeat (Look | Blink) : else
  }
  control hands {
    enter Grasp : / start_timer(rest, 20ms)
    enter Lift : [t.state.S.m == 2 || n > 3] / n = n + 1
    skip Lift : else
    leave Drop : stop / n = 0
    leave Drop : [n % 2 == 0 && expired(rest)]
  }
}
"""


def told(made: Generated, role: str, course: Course | None = None) -> tuple[Behaviour, Course]:
    """The description of a role, with the course that its steps are of."""
    chart = next(chart for chart in made.system.iacs if chart.name == role)
    kind = made.charts[role]
    course = course or drawn(made.system, chart, kind, vars(made.messages), 300, 1)
    course = one_by_one(kind, course)
    return described(made.system, chart, kind, course), course


def differences(made: Generated, role: str, behaviour: Behaviour, course: Course) -> list[str]:
    """The counters that a reading of the description has otherwise than the reference interpreter."""
    whole = instrumented(behaviour)
    machine = Follower(whole)
    machine.follow(whole)
    entries, exits, trail = counts_of(made.plan(role), course, vars(made.messages))
    assert tuple(trail) == course.trail
    chart = next(chart for chart in made.system.iacs if chart.name == role)
    label = {identifier(node): node.label for node in chart.states}
    return [
        f"{counter(state.name)}: {machine.bb[counter(state.name)]}"
        for state in list(walk(behaviour.root))[1:]
        for counter, known in ((entered, entries), (left, exits))
        if machine.bb[counter(state.name)] != known.get(label[state.name], 0)
    ]


@pytest.mark.parametrize(
    ("text", "role"),
    [
        (LAMP, "lamp"),
        (WORKER, "worker"),
        ((ROOT / "tests" / "acceptance" / "testbehavior.aseme").read_text("utf-8"), "TestBehavior"),
    ],
    ids=["lamp", "worker", "testbehavior"],
)
def test_a_description_enters_and_leaves_every_state_as_often(text: str, role: str) -> None:
    made = generate(text)
    behaviour, course = told(made, role)
    assert len(behaviour.steps) == len(course.steps) - 1 > 10
    assert differences(made, role, behaviour, course) == []
    assert from_json(json.loads(json.dumps(as_json(behaviour)))).steps == behaviour.steps
    assert from_json(as_json(behaviour)).root == behaviour.root


def test_functions_of_the_file_are_called(tmp_path: Path) -> None:
    (tmp_path / "weights.py").write_text("def is_heavy(thing):\n    return thing.kilos > 3\n", "utf-8")
    text = """
system S
message Thing { int kilos  optional int parts }
topic t { state Thing }
function is_heavy(Thing thing) : bool = "weights:is_heavy"
srm r { liveness { r = (Wait . Lift)~ } control r { enter Lift : when [is_heavy(t.state.Thing)] } }
"""
    made = generate(text)
    with importing([tmp_path]):
        course = told(made, "r")[1]
        chart = made.system.iacs[0]
        behaviour = described(made.system, chart, made.charts["r"], course, [tmp_path])
        assert behaviour.functions == (("call_1", "weights:is_heavy"),)
        assert from_json(as_json(behaviour)).functions == behaviour.functions
        know_functions(behaviour)
        assert differences(made, "r", behaviour, course) == []


def test_what_an_agent_got_in_a_run_is_told_one_by_one(tmp_path: Path) -> None:
    made = generate(WORKER + "team T { ann : worker }")
    script = [
        {"at": f"{100 * n}ms", "channel": "t.state.S", "message": {"n": n, "m": n % 3}} for n in range(9)
    ]
    team, records = make(made, {}, script=script, until=6 * SECOND)
    team.run()
    trace = tmp_path / "run.jsonl"
    trace.write_text("".join(f"{json.dumps(record)}\n" for record in records), "utf-8")
    (course,) = recorded(trace, "Par", made.charts, vars(made.messages)).courses["worker"]
    assert max(len(given.inputs) for given in course.steps) > 1
    behaviour, alone = told(made, "worker", course)
    assert all(sum(not hasattr(i, "channel") for i in given.inputs) <= 1 for given in alone.steps)
    assert len(alone.steps) > len(course.steps)
    assert differences(made, "worker", behaviour, alone) == []


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (
            "system S\nsrm r { liveness { r = (A . B)~ }\n control r { enter B : [in(A)] } }",
            r"`in\(A\)` \(test.aseme:3:14\)",
        ),
        ("system S\nsrm r { liveness { r = (A . B) [> C }\ncontrol r { enter C : go } }", "cutting short"),
        (
            "system S\nmessage M { int n }\ntopic t { signal M }\nsrm r { liveness { r = A . B }\n"
            "control r { enter B : [t.signal.M.n > 1] } }",
            "it is no plain statechart",
        ),
    ],
)
def test_what_is_not_told_is_refused_with_its_place(text: str, why: str) -> None:
    made = generate(text)
    with pytest.raises(Refused, match=why) as refused:
        told(made, "r")
    if "plain" in why:
        assert "E320" in refused.value.places and "signals" in refused.value.places


def test_a_file_with_mistakes_or_without_the_role(tmp_path: Path) -> None:
    (tmp_path / "bad.aseme").write_text("system S\nsrm r { liveness { r = A . . } }", "utf-8")
    (tmp_path / "lamp.aseme").write_text(LAMP, "utf-8")
    with pytest.raises(ValueError, match=r"bad\.aseme:2"):
        measured(tmp_path / "bad.aseme", [], [], 1, print)
    with pytest.raises(ValueError, match="no role lamb; there are lamp"):
        measured(tmp_path / "lamp.aseme", ["lamb"], [], 1, print)
    with pytest.raises(ValueError, match="cannot be read"):
        measured(tmp_path / "lamp.aseme", [], [tmp_path / "nowhere.jsonl"], 1, print)


def test_a_role_that_does_nothing_in_the_trace_is_not_compared(tmp_path: Path) -> None:
    text = """
system S
srm r { liveness { r = A . B } activities { A takes 1ms } control r { enter B : [count(A) > 0] } }
srm q { liveness { q = A } }
"""
    made = generate(text + "team T { ann : r }")
    team, records = make(made, {}, until=SECOND)
    team.run()
    (tmp_path / "test.aseme").write_text(text + "team T { ann : r }", "utf-8")
    (tmp_path / "run.jsonl").write_text("".join(f"{json.dumps(record)}\n" for record in records), "utf-8")
    found = measured(tmp_path / "test.aseme", [], [tmp_path / "run.jsonl"], 1, print)
    assert [(role.name, role.refused.partition(" (")[0]) for role in found.roles] == [
        ("r", "`count(A)`"),
        ("q", "it does nothing in the trace"),
    ]


def test_the_report_names_who_is_left_out_and_why(tmp_path: Path) -> None:
    role = Role("lamp", 7, 6, 500)
    for key, seconds in ((CORE_TYPED.key, 5e-7), (SEND.key, 1e-6), (SISMIC.key, 7e-5)):
        role.series[key] = Series([seconds], [seconds / 1e-6])
    role.left_out[TRANSITIONS.key] = "x is entered 1 times, not 2"
    other = Role("keeper", refused="it is no plain statechart", places="keeper.aseme:3:1: error[E320]: …")
    found = Found("Lamp", "500 drawn inputs", [role, other], {SISMIC.key: "1.6"})
    text = own_report.written(found, tmp_path).read_text("utf-8")
    assert "| sismic 1.6 " in text and "|  70 µs |            70 |" in text
    assert "- transitions is left out: x is entered 1 times, not 2." in text
    assert "## keeper\n\nNot compared: it is no plain statechart.\n\n```text\nkeeper.aseme:3:1" in text
    plot = (tmp_path / "lamp.svg").read_text("utf-8")
    assert "Lamp, lamp" in plot and "sismic" in plot and "keeper" not in plot
    assert json.loads((tmp_path / "lamp.json").read_text("utf-8"))["roles"][1]["refused"]
