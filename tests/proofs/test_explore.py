"""Exploring: whatever happens in a run is among what is explored, whatever the seed, delays and durations."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from aseme_dsl.compiler.phases import inspect_files, scenarios_of
from aseme_dsl.play.run import play
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root, options_of
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.search import Clock, Eyes, Graph, Limits, search
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.version.loading import Loaded, load_system
from tests.cli.test_prove import BUY, LATE, MEET

TEAMS = {
    "buy": (
        BUY + "srm shop { plays buy.seller liveness { shop = seller } }\n"
        "srm client { plays buy.buyer liveness { client = buyer } }\n",
        "ann : client  bob : shop",
        ("Choose", "Wait", "Pay", "GoHome", "Look", "Close"),
    ),
    "ask": (
        LATE + "srm chief { plays ask.boss liveness { chief = boss } }\n"
        "srm clerk { plays ask.worker liveness { clerk = worker~ } }\n",
        "ann : chief  bob : clerk",
        ("Think", "Wait", "Praise", "GiveUp", "Work", "Rest"),
    ),
    "watch": (
        """\
system Watch
message Ball { bool near  int size }
message Note { int size }
topic eye { state Ball }
topic team { state Note from coach }
srm coach {
  liveness { coach = Speak . Sleep }
  activities { Speak writes team.state.Note }
}
srm robot {
  var seen : int = 0
  liveness {
    robot = (LookNear . LookFar)~ || (Wait . (Kick | Rest | Help))~
  }
  activities {
    LookNear writes eye.state.Ball
    LookFar  writes eye.state.Ball
  }
  control robot {
    enter Help : [team.state.Note.size > 1]
    enter Kick : [eye.state.Ball.near && eye.state.Ball.size > seen] / seen = 2
    enter Rest : else / seen = 0
  }
}
""",
        "ann : robot  bob : coach",
        (
            "Speak writes team.state.Note { size = 2 } every 4s",
            "LookNear writes eye.state.Ball { near = true  size = 3 } every 2s",
            "LookFar writes eye.state.Ball { near = true  size = 1 } every 3s",
            *("Wait", "Kick", "Rest", "Help", "Sleep"),
        ),
    ),
    "meet": (
        MEET + "srm one { plays meet.left liveness { one = left } }\n"
        "srm two { plays meet.right liveness { two = right } }\n",
        "ann : one  bob : two",
        ("Come", "Wait", "Serve"),
    ),
}


@pytest.fixture(params=TEAMS)
def system(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[tuple[Path, Loaded, tuple[str, ...]]]:
    text, team, activities = TEAMS[request.param]
    lines = "".join(
        f"  activity {name} takes 0ms..15s {more}\n"
        for name, _, more in (item.partition(" ") for item in activities)
    )
    scenario = f'scenario "any" {{\n  {team}\n  network delay 0..3s\n{lines}  for 60s\n}}\n'
    file = tmp_path / "it.aseme"
    file.write_text(f"{text}team T {{ {team} }}\n{scenario}")
    compiled = compile_root(file)
    assert compiled.system is not None, compiled.diagnostics
    package, _ = generate_version(compiled.system, tmp_path / "made", choose(compiled.configuration))
    yield file, load_system(package), tuple(activities)


def explored(loaded: Loaded) -> tuple[Explored, Graph]:
    eyes = Eyes()
    team = Explored(loaded, loaded.team, Assumed(), [eyes])
    graph = search(team, eyes, None, Limits())
    assert graph.cut is None
    return team, graph


def test_each_configuration_and_transition_of_a_run_is_explored(
    system: tuple[Path, Loaded, tuple[str, ...]],
) -> None:
    file, loaded, _ = system
    team, graph = explored(loaded)
    leaves = {agent.name: agent.chart.LEAVES for agent in team.agents}
    known = {
        tuple(
            frozenset(leaves[agent.name][region][leaf] for region, leaf in enumerate(where) if leaf >= 0)
            for agent, where in zip(team.agents, places, strict=True)
        )
        for places in graph.places
    }
    script = scenarios_of(inspect_files(file, None, options_of(compile_root(file).configuration)), {})[0]
    seen = 0
    for seed in range(1, 41):
        where = {agent.name: frozenset[str]() for agent in team.agents}
        roles = dict(loaded.team)
        steps: list[tuple[int, str, frozenset[str]]] = []

        def listen(record: Record) -> None:
            if record["kind"] == "step":
                for way in record["taken"]:
                    assert set(way["transitions"]) <= graph.taken[roles[record["agent"]]]  # noqa: B023
                if "configuration" in record:
                    steps.append(  # noqa: B023
                        (record["time"], record["agent"], frozenset(record["configuration"]))
                    )

        play(loaded, script.scripts[0], seed, {}, lambda name: None, 60_000_000_000, listeners=[listen])
        for place, (moment, agent, configuration) in enumerate(steps):
            where[agent] = configuration
            if place + 1 < len(steps) and steps[place + 1][0] == moment:
                continue  # the others make their steps at the same moment
            seen += 1
            now = tuple(where[item.name] for item in team.agents)
            assert any(
                all(one == other or not other for one, other in zip(now, states, strict=True))
                for states in known
            ), (seed, moment, now)
    assert seen > 100


def test_a_search_whose_time_is_over_stays_so() -> None:
    """Who asks next, at once, is told the same: else the search goes on."""
    clock = Clock(-1.0)
    assert [clock.is_over() for _ in range(3)] == [True] * 3
