"""Exploring random charts: whatever a run of one does at a moment, moves of the explored one do, too.

The charts are those of `tests/oracle`. A run on the real runtime is given random inputs, at random moments.
It is followed among the states that were explored, moment by moment: some moves take the same transitions,
and lead to the same configuration. `EXPLORED_CHARTS=1000` looks at more charts.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path

import pytest

from aseme_dsl.compiler.phases import inspect_files, scenarios_of
from aseme_dsl.diagnostics import Severity
from aseme_dsl.play.run import play
from aseme_dsl.play.scenario import Script
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import Compiled, compile_root, options_of
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.proofs.explore.deciding.staging import events
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.version.loading import load_system
from tests.oracle.charts import text
from tests.oracle.choices import Choices

FEW = (6, 8, 11, 22, 25, 66, 73, 107)
"""Seeds of charts that are small enough, and of which nothing is left out."""
SEEDS = range(int(os.environ["EXPLORED_CHARTS"])) if "EXPLORED_CHARTS" in os.environ else FEW
GROUPS = 4
RUNS = 6
"""So many runs of each chart, each with other inputs and durations."""
TEAM = (("me", "R"),)
STATES = 600
"""Charts with more states are left out."""
LASTS = 600
"""So long a run lasts (ms)."""

Way = tuple[str, tuple[int, ...]]
"""An agent, and transitions that it takes together."""
Moment = tuple[int, frozenset[Way], frozenset[str]]
"""When (ns), what is taken then, and the configuration at the end of it."""


class Timeless(Choices):
    """Decisions for charts in which ages are compared with constants only, and nothing asks for a history.

    What is done with others is not explored, which answers say.
    """

    def weighted(self, **weights: int) -> str:
        kept = {name: weight for name, weight in weights.items() if name not in ("age", "at", "mean")}
        return super().weighted(**(kept or weights))


def scenario_of(choices: Choices, team: Explored, number: int) -> str:
    """A scenario in which much comes to one agent: what may come from outside."""
    (agent,) = team.agents
    plan, channels, names = agent.plan, team.coming.inputs[agent.name], sorted(events(agent.plan))
    lines = [f"  activity {name} takes 1ms..{choices.one_of((2, 20, 60))}ms" for name in activities_of(plan)]
    for _ in range(choices.number(4, 16)):
        at = f"  at {choices.number(1, LASTS)}ms me"
        if channels and (not names or choices.one_in(2)):
            channel = choices.one_of(channels)
            content = members_of(choices, channel.rpartition(".")[2])
            lines.append(f"{at} receives {channel} {{ {content} }}")
        elif names:
            lines.append(f"{at} raises {choices.one_of(names)}")
    body = "\n".join(lines)
    return f'scenario "{number}" {{\n  me : R\n{body}\n  for {LASTS}ms\n}}\n'


def activities_of(plan: Plan) -> list[str]:
    return sorted({state.activity for state in plan.states if state.activity})


def members_of(choices: Choices, message: str) -> str:
    n = choices.number
    if message == "Note":
        return f'text = "{choices.one_of(("", "a", "b"))}", n = {n(0, 3)}'
    on = choices.one_of(("true", "false"))
    return f'x = {n(0, 3)}, on = {on}, d = {n(0, 3) / 2}, s = "{choices.one_of(("", "a", "b"))}"'


def explored(compiled: Compiled, folder: Path) -> tuple[Explored, Graph]:
    assert compiled.system is not None
    package, _ = generate_version(compiled.system, folder, choose(compiled.configuration))
    eyes = Eyes()
    team = Explored(load_system(package), TEAM, Assumed(), [eyes])
    return team, search(team, eyes, None, Limits(STATES, 4.0))


def configurations(team: Explored, graph: Graph) -> list[frozenset[str]]:
    """Where the agent is, by state; empty if it is over."""
    (agent,) = team.agents
    leaves = agent.chart.LEAVES
    return [
        frozenset(leaves[region][leaf] for region, leaf in enumerate(where) if leaf >= 0)
        for (where,) in graph.places
    ]


def moments_of(compiled: Compiled, package: Path, script: Script, seed: int) -> list[Moment]:
    """What happens in a run."""
    found: list[Moment] = []
    is_over = False

    def listen(record: Record) -> None:
        nonlocal is_over
        is_over = is_over or record["kind"] in ("error", "finish")
        if record["kind"] != "step" or is_over:
            return
        ways = {(record["agent"], tuple(way["transitions"])) for way in record["taken"]}
        before = found[-1] if found else (-1, frozenset(), frozenset[str]())
        where = frozenset(record["configuration"]) if "configuration" in record else before[2]
        if before[0] == record["time"]:
            found[-1] = record["time"], before[1] | ways, where
        else:
            found.append((record["time"], frozenset(ways), where))

    loaded = load_system(package)
    play(loaded, script, seed, {}, lambda name: None, LASTS * 1_000_000, listeners=[listen])
    return found


def followed(
    graph: Graph, where: Sequence[frozenset[str]], states: Collection[int], moment: Moment
) -> set[int]:
    """The states in which the explored agent may be after a moment."""
    _, ways, target = moment
    todo = [(state, frozenset[Way]()) for state in states]
    known = set(todo)
    found: set[int] = set()
    while todo:
        state, taken = todo.pop()
        if taken == ways and (where[state] == target or not where[state]):
            found.add(state)
        for edge in graph.edges.get(state, ()):
            if edge.taken <= ways and (after := (edge.target, taken | edge.taken)) not in known:
                known.add(after)
                todo.append(after)
    return found


def looked_at(seed: int, folder: Path) -> Iterator[str]:
    """What came of a chart, and of each of its runs."""
    choices = Timeless(seed)
    file = folder / "it.aseme"
    written = text(choices)
    file.write_text(written)
    compiled = compile_root(file)
    if compiled.system is None:
        yield "not a chart"
        return
    team, graph = explored(compiled, folder / "made")
    if graph.cut is not None or team.left_out:
        yield "too large" if graph.cut is not None else team.left_out
        return
    file.write_text(written + "".join(scenario_of(choices, team, number) for number in range(RUNS)))
    again = compile_root(file)
    assert again.system is not None, (
        [item for item in again.diagnostics if item.severity is Severity.ERROR],
        file.read_text(),
    )
    package, _ = generate_version(again.system, folder / "played", choose(again.configuration))
    where = configurations(team, graph)
    for scenario in scenarios_of(inspect_files(file, None, options_of(again.configuration)), {}):
        run = moments_of(again, package, scenario.scripts[0], seed)
        states: Collection[int] = {0}
        is_begun = all(edge.kind != ("begin",) for edge in graph.edges.get(0, ()))
        for place, moment in enumerate(run):
            if place == 0 and is_begun:
                moment = moment[0], frozenset(), moment[2]
            after = followed(graph, where, states, moment)
            assert after, (
                f"{seed}, scenario {scenario.name}, {moment} after {run[:place]}:\n{file.read_text()}"
            )
            states = after
            yield "followed"
        yield "run"


@pytest.mark.parametrize("group", range(GROUPS))
def test_what_a_run_does_at_a_moment_is_explored(group: int, tmp_path: Path) -> None:
    found: Counter[str] = Counter()
    for seed in SEEDS[group::GROUPS]:
        folder = tmp_path / str(seed)
        folder.mkdir()
        found.update(looked_at(seed, folder))
    print(dict(found))
    assert found["followed"] > found["run"] > 0, found
