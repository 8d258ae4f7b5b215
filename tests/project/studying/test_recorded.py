"""Inputs that agents got in a run, read from its trace: the charts go the same way with them again."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.grammar.text.network_words import read_network
from aseme_dsl.project.studying.bench import recordings_of
from aseme_dsl.project.studying.course import Course
from aseme_dsl.project.studying.recorded import NotPlayable, recorded
from aseme_dsl.runtime import Context
from aseme_dsl.runtime.trace.trace import Record
from tests.cli.support import asemec
from tests.runtime.conversation.test_losses import TEXT as KITCHEN
from tests.runtime.held import play_held
from tests.runtime.playing import MS, SECOND, make
from tests.support.generated import Generated, generate

EXAMPLES = Path(__file__).parents[3] / "examples"

TEXT = """
system S
enum Mood { GOOD BAD }
message M { int n  Mood mood }
topic t { signal M  state M }
srm R {
  var mood : Mood = Mood.GOOD
  liveness { R = ((A . B)+ . C) || (D . E)~ }
  activities {
    A takes 10ms reads t.signal.M writes mood ends well, ill
    B takes 30ms  C takes 20ms  D takes 25ms writes t.signal.M  E takes 5ms
  }
  control R {
    enter B : [outcome(A) == well && mood == Mood.BAD]
    enter B : tick
    enter B : after(15ms)
    enter E : error
    enter E : else
    repeat (A . B) : [t.state.M.n < 5]
    leave  (A . B) : else
  }
}
team T { ann, bob : R }
"""

MADE = generate(TEXT)
OTHERS: tuple[Any, ...] = ([[[]]], "x", None, {"n": "x"})


class A:
    def execute(self, context: Context) -> str:
        signal = context.consume("t.signal.M")
        is_odd = signal is not None and signal.n % 2
        context.set_variable("mood", MADE.messages.Mood.BAD if is_odd else MADE.messages.Mood.GOOD)
        if signal is not None and signal.n == 2:
            context.raise_event("tick")
        return "ill" if signal is None else "well"


class D:
    def execute(self, context: Context) -> None:
        n = context.random.randrange(6)
        if n == 5:
            raise ValueError("it rains")
        context.publish("t.signal.M", MADE.message("M", n=n))


def written(path: Path, records: list[Record]) -> Path:
    path.write_text("".join(f"{json.dumps(record)}\n" for record in records), "utf-8")
    return path


def read(path: Path, made: Generated, **options: Any) -> Mapping[str, tuple[Course, ...]]:
    return recorded(path, made.system.name, made.charts, vars(made.messages), **options).courses


def run_of(tmp_path: Path, **options: Any) -> tuple[Path, list[Record]]:
    """The trace of a run of the text above."""
    script = [{"at": f"{100 * n}ms", "channel": "t.state.M", "message": {"n": n}} for n in range(6)]
    team, records = make(MADE, {"A": A, "D": D}, script=script, until=2 * SECOND, **options)
    team.run()
    return written(tmp_path / "run.jsonl", records), records


@pytest.mark.parametrize("name", ["auction", "cell"])
def test_every_agent_of_an_example_goes_its_way_again(name: str, tmp_path: Path) -> None:
    trace = tmp_path / "run.jsonl"
    run = ("run", EXAMPLES / name, "-o", tmp_path / "out", "--for", "2s", "--trace", trace, "--quiet")
    assert asemec(*run, cwd=tmp_path).code == 0
    done = asemec("bench", EXAMPLES / name, "--inputs", trace, "--rounds", "1", "--json", cwd=tmp_path)
    assert done.code == 0, done.err
    steps: dict[str, int] = {}
    for line in trace.read_text("utf-8").splitlines():
        record = json.loads(line)
        if record["kind"] == "step":
            steps[record["agent"]] = steps.get(record["agent"], 0) + 1
    played = [agent for role in done.json["roles"] for agent in role["agents"]]
    assert {agent["agent"]: agent["steps"] + 1 for agent in played} == steps
    assert [agent["until"] for agent in played] == [""] * len(played)
    assert all(role["ways"] and not role["left_out"] for role in done.json["roles"])


def test_signals_variables_events_outcomes_and_failures_of_activities(tmp_path: Path) -> None:
    trace, records = run_of(tmp_path)
    kinds = {(r["kind"], r.get("what")) for r in records}
    assert {("consumed", None), ("variable", None), ("event", None), ("activity", "crash")} <= kinds
    ann, bob = read(trace, MADE)["R"]
    for course in (ann, bob):
        steps = [r for r in records if r["kind"] == "step" and r["agent"] == course.agent]
        assert (course.until, len(course.steps)) == ("", len(steps))
        assert course.inputs == sum(len(r["inputs"]) for r in steps)
        assert course.taken == {n for r in steps for way in r["taken"] for n in way["transitions"]}
    assert [len(course.steps) for course in read(trace, MADE, most=10)["R"]] == [11, 11]


def test_what_arrives_during_a_step(tmp_path: Path) -> None:
    """`read_messages` in real time: the trace says what it has shown."""
    made, _, records = play_held(tmp_path)
    assert any("ahead" in record for record in records)
    (course,) = read(written(tmp_path / "run.jsonl", records), made)["R"]
    assert course.until == "" and len(course.steps) == sum(r["kind"] == "step" for r in records)


def test_a_course_ends_where_the_trace_does_not_say_what_came_or_what_follows(tmp_path: Path) -> None:
    _, records = run_of(tmp_path)

    def first(changed: list[Record]) -> tuple[int, str]:
        course = read(written(tmp_path / "changed.jsonl", changed), MADE)["R"][0]
        return len(course.steps), course.until

    steps = [r for r in records if r["kind"] == "step" and r["agent"] == "ann"]
    third = records.index(steps[2])
    assert first([*records[:third], *records[third + 1 :]]) == (2, "the trace does not have step 3")
    number, why = first([r for r in records if r["kind"] != "variable" or r["time"] < 100 * MS])
    assert "does not say what input" in why and number > 3
    elsewhere = {**steps[2], "configuration": ["0.9"]}
    number, why = first([elsewhere if r is steps[2] else r for r in records])
    assert number == 2 and why.startswith("step 3 does not go as it did in the run: it leads to ")
    swap = {"kind": "swap", "time": 0, "what": "done", "agent": "ann"}
    assert first([*records[:third], swap, *records[third:]]) == (2, "then it changed its plan")
    refused = {"kind": "swap", "time": 0, "what": "refused", "reasons": ["no"]}
    assert first([*records[:third], refused, *records[third:]])[1] == ""


def test_of_several_traces_one_has_to_have_the_role(tmp_path: Path) -> None:
    trace, records = run_of(tmp_path)
    strangers = [{**item, "role": "Q"} for item in records[0]["agents"]]
    other = written(tmp_path / "other.jsonl", [{**records[0], "agents": strangers}])
    given = "S", MADE.charts, vars(MADE.messages)
    for traces in ([trace, other], [other, trace]):
        assert [item.path for item in recordings_of(traces, *given)] == [trace]
    with pytest.raises(NotPlayable, match="has no agent of R, only of Q"):
        recordings_of([other, other], *given)


def test_a_trace_that_cannot_be_played_says_why(tmp_path: Path) -> None:
    trace, records = run_of(tmp_path)

    def refused(changed: list[Record] | bytes) -> str:
        path = tmp_path / "changed.jsonl"
        path.write_bytes(changed) if isinstance(changed, bytes) else written(path, changed)
        with pytest.raises(NotPlayable) as problem:
            read(path, MADE)
        return str(problem.value)

    head, rest = records[0], records[1:]
    assert "is the trace of a run of Other, not of S" in refused([{**head, "system": "Other"}, *rest])
    older = [{**item, "model": "0123"} for item in head["agents"]]
    said = refused([{**head, "agents": older}, *rest])
    assert f"the model of R was 0123 then, and is {MADE.plan('R').model} now" in said and "Record" in said
    strangers = [{**item, "role": "Q"} for item in head["agents"]]
    assert "has no agent of R, only of Q" in refused([{**head, "agents": strangers}, *rest])
    assert "format 9" in refused([{**head, "format": 9}, *rest])
    assert "nothing of it can be played" in refused([head])
    assert "the header of a trace is wanted" in refused(b"\x93\x00\xff\n" * 99)
    assert "is not a whole line" in refused(b"\x93\x00\xff" * 99)
    assert "is empty" in refused(b"")
    seen: dict[tuple[str, Any], int] = {}
    for number, record in enumerate(records):
        seen.setdefault((record["kind"], record.get("what")), number)
    for number in seen.values():  # whatever a line has instead of what it should
        for member in records[number].keys() - {"kind", "time"}:
            for other in OTHERS:
                changed = {**records[number], member: other}
                around = [*records[:number], changed, *records[number + 1 : number + 20]]
                path = written(tmp_path / "changed.jsonl", around)
                try:
                    read(path, MADE)
                except NotPlayable as problem:
                    assert str(path) in str(problem)
    torn = trace.read_bytes()[: trace.stat().st_size // 2]
    trace.write_bytes(torn)
    assert "the trace breaks off" in str(recorded(trace, "S", MADE.charts, vars(MADE.messages)).problem)


def test_why_an_agent_was_lost(tmp_path: Path) -> None:
    control = "control robot { enter Flee : after(2s) }"
    made = generate(KITCHEN.format(robot="robot = cook [> Flee", control=control, rings="true"))
    team, records = make(made, {}, until=20 * SECOND)
    team.run()
    (course,) = read(written(tmp_path / "kitchen.jsonl", records), made)["human"]
    steps = [r for r in records if r["kind"] == "step" and r["agent"] == "ann"]
    assert (course.until, len(course.steps)) == ("", len(steps))
    assert course.taken == {n for r in steps for way in r["taken"] for n in way["transitions"]}


LATE = generate("""
system S
message Order { string dish }
aip kitchen {
  participant guest {
    engage   "Hungry."
    sends    request Order
    receives agree Order
    process  = Ask . Eat
  }
  participant cook {
    engage   "Asked."
    receives request Order
    sends    agree Order
    process  = Look . Cook
  }
  outcome "There is a meal."
  control guest {
    enter Ask : / send request Order { dish = "soup" } to cook
    enter Eat : agree Order from cook
  }
  control cook { enter Cook : request Order o from guest [age(o) >= 3s] / send agree Order { ..o } to guest }
}
srm visitor { plays kitchen.guest  liveness { visitor = guest }  activities { Ask waits  Eat takes 1s } }
srm chef { plays kitchen.cook  liveness { chef = cook }  activities { Look waits  Cook takes 1s } }
team T { tom : visitor  pat : chef }
""")


def test_the_age_of_an_agent_message_is_as_it_was(tmp_path: Path) -> None:
    faults = read_network("delay=1s..1s").faults(1)
    team, records = make(LATE, faults=faults)
    team.run()
    assert [r["time"] for r in records if r["kind"] == "agent_message"] == [0, 3 * SECOND]
    for role in ("visitor", "chef"):
        (course,) = read(written(tmp_path / "run.jsonl", records), LATE)[role]
        steps = [r for r in records if r["kind"] == "step" and r["agent"] == course.agent]
        assert (course.until, len(course.steps)) == ("", len(steps))
