"""Charts: the statecharts of protocols (EAC) and roles (IAC), and what is wrong with each alone."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.chart.aip_to_eac import aip_to_eac
from aseme_dsl.compiler.chart.chart import Protocol, World
from aseme_dsl.compiler.chart.flow import check_flow, check_reach
from aseme_dsl.compiler.chart.srm_to_iac import Role, srm_to_iac
from aseme_dsl.compiler.chart.statecharts import GivenChart, build_statechart
from aseme_dsl.compiler.checks.conditions import contradiction, vocabulary_of
from aseme_dsl.compiler.checks.outcomes import check_outcomes
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.stages.declarations import Declarations
from aseme_dsl.compiler.stages.found import Found, Stage
from aseme_dsl.compiler.stages.processes import Described, Processes
from aseme_dsl.compiler.types.state_values import check_rounds, check_states
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Charts:
    """The charts by name; one that could not be built is None. `prover` compares their conditions."""

    eacs: Mapping[str, Statechart | None]
    iacs: Mapping[str, Statechart | None]
    prover: Prover

    @property
    def of_protocols(self) -> tuple[Statechart, ...]:
        """Those that could be built."""
        return tuple(chart for chart in self.eacs.values() if chart is not None)

    @property
    def of_roles(self) -> tuple[Statechart, ...]:
        """Those that could be built."""
        return tuple(chart for chart in self.iacs.values() if chart is not None)

    @property
    def are_complete(self) -> bool:
        """Whether every chart could be built."""
        return None not in self.eacs.values() and None not in self.iacs.values()


def build_charts(
    declared: Declarations, processes: Processes, described: Described, memory: Memory
) -> Stage[Charts]:
    """Every chart, checked by itself: its flow, its outcomes, the states that it names."""
    found, each = Found(), memory.each_in_pieces
    protocols, roles, given = processes.protocols, processes.roles, processes.given
    world = (declared.system, declared.symbols, described.activities, described.modules)
    built = yield from each(_eac, zip(protocols.values()), *world)
    eacs = {item.name: chart for item, chart in zip(protocols.values(), built, strict=True)}
    built = yield from each(_iac, zip(roles.values()), *world)
    iacs = {item.name: chart for item, chart in zip(roles.values(), built, strict=True)}
    built = yield from each(_given_chart, zip(given), *world)
    iacs |= {item.name: chart for item, chart in zip(given, built, strict=True)}
    prover = memory.recall(Prover, memory.same("vocabulary", vocabulary_of(declared.resolved)))
    made = Charts(eacs, iacs, prover)
    charts = (*made.of_protocols, *made.of_roles)
    for problems in (yield from each(_flow, zip(charts), prover)):
        found.add(problems)
    found.add((yield from check_outcomes(charts, described.activities, memory)))
    found.add((yield from check_states(charts, memory)))
    found.add((yield from check_rounds(charts, memory)))
    return found.of(made)


_Charted = tuple[str, Symbols, Mapping[str, Activity], Mapping[str, tuple[Module, ...]]]


def _eac(protocol: Protocol, *world: *_Charted) -> Statechart | None:
    return aip_to_eac(protocol, World(*world))


def _iac(role: Role, *world: *_Charted) -> Statechart | None:
    return srm_to_iac(role, World(*world))


def _given_chart(chart: GivenChart, *world: *_Charted) -> Statechart | None:
    return build_statechart(chart, World(*world))


def _flow(chart: Statechart, prover: Prover) -> tuple[Diagnostic, ...]:
    return (*check_flow(chart, contradiction(prover)), *check_reach(chart))


__all__ = ["Charts", "build_charts"]
