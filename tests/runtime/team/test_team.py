"""Teams: what can be run, and how a run ends."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.runtime import Context, Setup, Team, TeamError
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.worlds.field.match import Match
from tests.runtime.playing import MS, SECOND, make, play
from tests.support.generated import generate

ONE = "system S srm R { liveness { R = A~ } activities { A takes 100ms } }"


def test_what_cannot_run_is_said_before_it_does() -> None:
    generated = generate(ONE)
    chart: type[Chart] = generated.charts["R"]
    cases: list[tuple[list[Any], dict[str, Any], str]] = [
        ([], {}, "at least one agent"),
        ([("a", chart), ("a", chart)], {}, "two agents are called a"),
        ([("a", chart)], {"clock": "sundial"}, "the clock is virtual or real"),
        ([("a", chart)], {"world": Match(1)}, "say how long the run is"),
    ]
    for agents, options, reason in cases:
        with pytest.raises(TeamError, match=reason):
            Team(agents, {}, Setup(**options))


def test_a_team_runs_once() -> None:
    team, _ = make(ONE, until=SECOND)
    team.run()
    with pytest.raises(TeamError, match="runs once"):
        team.run()


def test_one_agent_that_fails_does_not_stop_the_others() -> None:
    class A:
        def execute(self, context: Context) -> None:
            if context.agent == "ann":
                raise ValueError("no battery")

    text = "system S srm R { liveness { R = A . B } activities { B takes 1s } } team T { ann, bob : R }"
    run = play(text, {"A": A})
    assert [(a.name, a.finished, a.failure is None) for a in run.result.agents] == [
        ("ann", False, False),
        ("bob", True, True),
    ]
    assert run.result.failed and run.result.end_ns == SECOND


def test_a_world_goes_on_while_all_agents_sleep_and_may_end_the_run() -> None:
    world = Match(1)
    text = (
        "system S srm R { liveness { R = A . B } control R { enter B : bell } activities { A takes 10ms } }"
    )
    run = play(text, world=world, stop=lambda team: "far" if world.now_ns >= 200 * MS else None)
    assert (run.result.reason, run.result.end_ns) == ("far", 200 * MS)


def test_a_world_goes_with_the_real_clock() -> None:
    world = Match(1)
    run = play(ONE, world=world, clock="real", stop=lambda team: "far" if world.now_ns >= 50 * MS else None)
    assert run.result.reason == "far"
    assert run.result.end_ns >= 50 * MS


def test_activities_reach_the_body_of_their_agent() -> None:
    text = "system S srm R { liveness { R = A } } team T { robot1, keeper : R }"

    class A:
        def execute(self, context: Context) -> None:
            context.log(f"{context.body.name} {context.body.sense().goalie}")

    run = play(text, {"A": A}, world=Match(1), until=SECOND)
    assert [record["text"] for record in run.of("log")] == ["robot1 False", "keeper True"]


def test_a_chart_that_breaks_stops_its_agent_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    generated = generate(ONE + " team T { ann, bob : R }")
    chart = generated.charts["R"]
    step = chart.step

    def broken(self: Chart, now: int, inputs: Any) -> Any:
        if self.agent == "ann" and now:
            raise ZeroDivisionError
        return step(self, now, inputs)

    monkeypatch.setattr(chart, "step", broken)
    run = play(generated, until=SECOND)
    assert "the step raised ZeroDivisionError" in (run.result.agents[0].failure or "")
    assert run.result.agents[1].failure is None
    assert run.of("error")[0]["traceback"][-1]["function"] == "broken"


def test_an_error_of_a_listener_ends_the_run_with_the_trace_closed(tmp_path: Any) -> None:
    def listen(record: Any) -> None:
        if record.get("what") == "end":
            raise BrokenPipeError("nobody listens")

    for clock in ("virtual", "real"):
        path = tmp_path / f"{clock}.jsonl"
        with pytest.raises(BrokenPipeError):
            play(ONE, listeners=[listen], trace=path, clock=clock)
        assert path.read_text().count("\n") >= 3
