"""What nobody takes does not grow for ever: queues have a bound, and the first time it is met is told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.chart.input_queue import CROWD, Intake, Posted
from aseme_dsl.runtime.chart.inputs import Happened, Sample, Written
from aseme_dsl.runtime.driver.real_time import RealTime
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.support.generated import generate
from tests.support.waiting import LONG

FEW = RealTime(queue=50)


def faults(run: Played) -> list[str]:
    return [r["reason"] for r in run.of("fault") if "code" not in r]


PILING = """
system S
message M { int n }
topic t { signal M queued }
srm R {
  var taken : int = 0
  var late : int = 0
  liveness { R = Take~ || (Idle . Use~) }
  activities { Take takes 60min  Idle takes 10s  Use takes 60min }
  control R {
    repeat Take : when [t.signal.M.n > 0] / taken = taken + 1
    repeat Use : when [t.signal.M.n > 0] / late = late + 1
  }
}
"""


def test_signals_that_a_region_does_not_take_are_bounded_and_another_region_gets_all() -> None:
    signals = [
        {"at": f"{10 * n}ms", "channel": "t.signal.M", "message": {"n": n}, "sender": "ann"}
        for n in range(1, 201)
    ]
    run = play(PILING, script=signals, until=12 * SECOND, real_time=FEW)
    chart = run.team.agent("me").chart
    assert (chart.variable("taken"), chart.variable("late")) == (200, 50)
    (fault,) = (r for r in run.of("fault") if "t.signal.M" in r["reason"])
    text = "50 t.signal.M wait in `(Idle . Use~)` of me and are not taken: what comes now is left out there"
    assert (fault["reason"], fault["at"]) == (text, "test.aseme:8:27")
    assert run.of("header")[0]["queue"] == 50  # so that the run can be repeated from its trace
    crowds = run.of("overload", channel="t.signal.M")
    assert sum(record["left_out"] for record in crowds) == 150
    assert {record["agent"] for record in crowds} == {"me"}


def test_the_bound_is_generous_if_nothing_else_is_said() -> None:
    generated = generate(PILING)
    chart = generated.chart("R")
    message = generated.messages.M
    chart.step(0, [])
    for n in range(1, 10_003):
        chart.step(n, [Sample("t.signal.M", message(n=n), "ann", n, ("ann", n))])
    boards = [board for board in chart.boards() if board is not None and board.CHANNELS]
    assert max(len(board._signals["t.signal.M"]) for board in boards) == 10_000
    assert chart.variable("taken") == 10_002


def arrived(number: int) -> Posted:
    return Posted(("ann", number), Sample("t.signal.M", number, "ann", 0, ("ann", number)))


def test_signals_that_wait_for_a_step_that_lasts_are_bounded() -> None:
    intake = Intake(frozenset({"t.signal.M"}), bounded=True, queue=50)
    for number in range(CROWD + 200):
        intake.append(arrived(number))
    assert intake.refused == {"t.signal.M": 150}
    taken = intake.take()
    assert [item.identity[1] for item in taken if isinstance(item, Posted)] == list(range(CROWD + 50))
    for number in range(CROWD + 10):
        intake.append(arrived(number))
    assert len(intake) == CROWD + 10


def test_events_and_variables_that_wait_are_no_more_than_there_are_names() -> None:
    intake = Intake(frozenset(), bounded=True, queue=50)
    for number in range(CROWD):
        intake.append(arrived(number))
    for number in range(5000):
        intake.append(Posted(("me", 2 * number), Happened(f"event{number % 3}")))
        intake.append(Posted(("me", 2 * number + 1), Written("x", number)))
    assert len(intake) == CROWD + 4
    last = [item.input for item in intake.take() if isinstance(item, Posted)][CROWD:]
    assert set(last) == {*(Happened(f"event{n}") for n in range(3)), Written("x", 4999)}


def test_a_step_that_lasts_under_a_flood_of_queued_signals_is_told() -> None:
    team, records = make(
        PILING, clock="real", until=round(LONG) * SECOND, real_time=FEW, stop=lambda team: over()
    )
    (agent,) = team.agents
    message = team._messages["M"]

    def over() -> str | None:
        return "taken" if agent.chart.variable("taken") == 50 else None

    def flood() -> None:
        with team.driver.guard(agent):
            for number in range(1, CROWD + 201):
                identity = ("input", number)
                agent.post(identity, Sample("t.signal.M", message(n=1), "ann", 0, identity))

    team.driver.at(20 * MS, flood)
    assert team.run().reason == "taken"
    told = [r["reason"] for r in records if r["kind"] == "fault" and "next step" in r["reason"]]
    assert told == [
        "50 queued signals wait for the next step of me: of t.signal.M, what comes now is left out"
    ]
    at_the_door = [r for r in records if r["kind"] == "overload" and "channel" in r and "region" not in r]
    assert sum(r["left_out"] for r in at_the_door) == 150


ASKING = """
system S
message Task { int n }
aip ask {
  participant asker { sends request Task by Ask repeatedly  receives not_understood Task  process = Ask }
  participant teller { receives request Task  process = Sleep }
}
srm boss { plays ask.asker  liveness { boss = asker }  activities { Ask takes 1s } }
srm worker { plays ask.teller  liveness { worker = teller }  activities { Sleep takes 1min } }
team T { boss1 : boss  worker1 : worker }
"""


def test_mail_that_a_participant_does_not_take_is_bounded_and_answered() -> None:
    task = generate(ASKING)

    class Ask:
        def execute(self, context: Context) -> None:
            for n in range(200):
                context.send("request", task.messages.Task(n=n), "teller")
                context.wait(0.001)

    run = play(task, {"Ask": Ask}, until=3 * SECOND, real_time=FEW)
    asked = len(run.of("agent_message", agent="boss1"))
    refused = run.of("unexpected", agent="worker1")
    assert asked >= 200 and len(refused) == asked - 50
    assert {r["reason"] for r in refused} == {"50 messages wait already for teller"}
    assert len(run.of("agent_message", performative="not_understood")) == len(refused)
    assert [text for text in faults(run) if "teller" in text] == [
        "50 messages wait for teller of worker1 and are not taken: what comes now is refused"
    ]


EVERY = """
system S
message M { int n }
topic t { signal M queued every 1s }
srm R { liveness { R = Say~ }  activities { Say takes 10ms writes t.signal.M } }
srm Q { liveness { Q = Hear~ }  activities { Hear takes 1s reads t.signal.M } }
team T { ann : R  bob : Q }
"""


def test_signals_that_are_held_back_are_bounded() -> None:
    generated = generate(EVERY)

    class Say:
        def execute(self, context: Context) -> None:
            context.publish("t.signal.M", generated.messages.M(n=1))

    run = play(generated, {"Say": Say}, until=3 * SECOND, real_time=FEW)
    refused: list[Any] = run.of("refused", channel="t.signal.M")
    assert len(refused) > 100
    assert {r["reason"] for r in refused} == {"50 wait already for their turn"}
    assert [text for text in faults(run) if "t.signal.M" in text] == [
        "50 t.signal.M of ann wait for their turn: what comes now is refused"
    ]


def test_a_project_says_how_many(tmp_path: Path) -> None:
    from aseme_dsl.project.settings.configuration import read_configuration

    path = tmp_path / "pyproject.toml"
    path.write_text("[tool.asemec.run]\nqueue = 500\n")
    configuration, problems = read_configuration(path)
    assert not problems and configuration.run is not None and configuration.run.queue == 500
