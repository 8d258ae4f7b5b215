"""Model: what a log is observed against: the protocols, statements and statecharts of a system."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

from aseme_dsl.amola.system import System
from aseme_dsl.play.scenario import Refused, Script
from aseme_dsl.project.building.project import Compiled
from aseme_dsl.project.observing.contract import Contract, contracts_of
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.testing.replaying import compiled, generated
from aseme_dsl.project.testing.watching import may_say_something, script_for, script_in
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan

Team = Mapping[str, str]
"""The roles of agents, by name."""


@dataclass(frozen=True, slots=True)
class Model:
    """What a log is observed against. `script` says what its statements are about a team, if it has any."""

    system: System
    contracts: Mapping[str, Contract | None]
    script: Callable[[Team], Script | Refused | None]

    @property
    def team(self) -> Team:
        """Its agents; without a team, one for each role."""
        return self.system.agents

    @property
    def topics(self) -> frozenset[str]:
        """The types of the messages on topics."""
        names = (str(rules.channel) for topic in self.system.topics for rules in topic.channels)
        return frozenset(name.rpartition(".")[2] for name in names)

    def plans(self) -> dict[tuple[str, str], Plan]:
        """The plans of its roles, by role and the model's hash. Raises NotReplayable."""
        return _plans_of(self.system)


def plans_in(sources: Mapping[str, str]) -> dict[tuple[str, str], Plan]:
    """The plans of the roles of a model that a trace has in it. Raises NotReplayable."""
    return _plans_of(compiled(sources))


def _plans_of(system: System) -> dict[tuple[str, str], Plan]:
    with ExitStack() as stack:
        charts, _ = generated(system, stack)
        return {(chart.PLAN.name, chart.PLAN.model): chart.PLAN for chart in charts.values()}


def are_alike(one: Plan, other: Plan) -> bool:
    """Whether the steps of one are those of the other; places and conditions of lines may differ."""
    if [replace(item, at="") for item in one.states] != [replace(item, at="") for item in other.states]:
        return False
    ways = [
        [(item.source, item.target, item.into, item.kind) for item in plan.transitions]
        for plan in (one, other)
    ]
    return ways[0] == ways[1]


def model_in(sources: Mapping[str, str]) -> Model:
    """The model that a trace has in it. Raises NotReplayable: this version of asemec does not compile it."""
    system = compiled(sources)
    return Model(system, contracts_of(system), lambda team: script_in(sources, Configuration(Path()), team))


def model_of(found: Compiled) -> Model:
    """The model of a file without errors."""
    system = found.system
    assert system is not None
    sources = {item.path: item.text for item in system.sources}

    def script(team: Team) -> Script | Refused | None:
        says_something = may_say_something(sources)
        return script_for(found.root, None, found.configuration, team) if says_something else None

    return Model(system, contracts_of(system), script)


__all__ = ["Model", "Team", "are_alike", "model_in", "model_of", "plans_in"]
