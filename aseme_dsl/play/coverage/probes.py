"""Probes: a system whose conditions tell what they evaluate, and which does the same as before."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from typing import cast

from aseme_dsl.amola.expression import Logic, Value, value_text
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.play.conditions import around, shown_as
from aseme_dsl.play.coverage.decisions import HELD, NOT_ASKED, NOT_HELD, Decision, decisions_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart

Evaluations = dict[tuple[str, int], set[str]]
"""The evaluations of the decisions of roles, by role and transition number."""


@dataclass(frozen=True, slots=True)
class Probe:
    """What a probe is around: a part of a decision, by its place, or (None) the whole."""

    role: str
    decision: Decision
    place: int | None


@dataclass(frozen=True, slots=True)
class Probed:
    """A system with probes, and what their numbers mean."""

    system: System
    probes: tuple[Probe, ...]


@dataclass(slots=True)
class Recorder:
    """Takes what the probes of charts tell, one chart after the other."""

    probes: Sequence[Probe]
    evaluations: Evaluations = field(default_factory=dict)
    _parts: dict[int, bool] = field(default_factory=dict)

    def tell(self, number: int, holds: bool) -> None:
        """A probe has this number, and what it is around holds or does not."""
        probe = self.probes[number]
        if probe.place is None:
            letters = [_LETTERS[self._parts.get(place)] for place in range(len(probe.decision.parts))]
            found = self.evaluations.setdefault((probe.role, probe.decision.transition), set())
            found.add("".join((*letters, _LETTERS[holds])))
            return
        if probe.place == 0:
            self._parts.clear()  # a new evaluation begins
        self._parts[probe.place] = holds

    def listening(self, chart: type[Chart], model: str | None = None) -> type[Chart]:
        """The chart, whose probes tell this recorder; `model` is the hash of the model without probes."""

        def probe(_: Chart, number: int, holds: bool) -> bool:
            self.tell(number, holds)
            return holds

        plan = chart.PLAN if model is None else replace(chart.PLAN, model=model)
        members = {"__slots__": (), "probe": probe, "PLAN": plan}
        return cast("type[Chart]", type(chart.__name__, (chart,), members))


_LETTERS = {True: HELD, False: NOT_HELD, None: NOT_ASKED}


def probed(system: System) -> Probed:
    """The system with a probe around each condition of its roles, and around each part of it."""
    probes: list[Probe] = []
    charts = tuple(_probed(chart, probes) for chart in system.iacs)
    return Probed(replace(system, iacs=charts), tuple(probes))


def _probed(chart: Statechart, probes: list[Probe]) -> Statechart:
    transitions = list(chart.transitions)
    for decision in decisions_of(chart):
        first = len(probes)
        probes += (Probe(chart.name, decision, place) for place in range(len(decision.parts)))
        parts = iter(range(first, len(probes)))
        inside = _with_parts(decision.condition, parts)
        condition = around(inside, len(probes))
        probes.append(Probe(chart.name, decision, None))
        item = transitions[decision.transition]
        written = item.expression.condition
        assert written is not None  # else there is no decision
        condition = shown_as(condition, value_text(written))
        changed = replace(item.expression, condition=condition)
        transitions[decision.transition] = replace(item, expression=changed)
    return replace(chart, transitions=tuple(transitions))


def _with_parts(normal: Value, numbers: Iterator[int]) -> Value:
    if isinstance(normal, Logic):
        return replace(normal, operands=tuple(_with_parts(item, numbers) for item in normal.operands))
    return around(normal, next(numbers))


__all__ = ["Evaluations", "Probe", "Probed", "Recorder", "probed"]
