"""Serving: which states of the statecharts serve a use case, and so the goal of its name.

A use case is served by the states that have its name, or a name that it `realises`. The name may also be that
of the protocol, participant or formula that a state comes from. Without such a state, it is served by the use
cases that it includes: it is reached if each of them is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from aseme_dsl.amola.statechart import OriginKind, State, Statechart, StateType
from aseme_dsl.amola.suc import RoleType, UseCase, folded
from aseme_dsl.amola.system import System
from aseme_dsl.play.coverage.reach import Reach
from aseme_dsl.play.coverage.seen import Seen
from aseme_dsl.records import dataclass

Place = tuple[str, str]
"""A state: its role and its label."""


@dataclass(frozen=True, slots=True)
class Serving:
    """What serves a use case: its own `states`, else the `included` use cases."""

    states: tuple[Place, ...]
    included: tuple[Serving, ...]
    is_outside: bool
    """Whether all its participants are people or other systems."""

    @property
    def is_served(self) -> bool:
        return bool(self.states) or (bool(self.included) and all(item.is_served for item in self.included))

    def times(self, seen: Seen) -> int:
        """How often it was reached: how often its states were entered."""
        if self.states:
            return sum(seen.roles[role].entered[label] for role, label in self.states if role in seen.roles)
        return min((item.times(seen) for item in self.included), default=0)

    def can_be(self, reaches: Mapping[str, Reach]) -> bool:
        """Whether some path leads to it."""
        if self.states:
            return any(label in reaches[role].states for role, label in self.states)
        return all(item.can_be(reaches) for item in self.included)


def serving(system: System) -> dict[str, Serving]:
    """What serves each use case, by its name."""
    cases = {folded(case.name): case for case in system.suc.usecases}
    outside = {
        role.name for role in system.suc.roles if role.type not in (RoleType.SYSTEM, RoleType.ABSTRACT)
    }
    found: dict[str, Serving] = {}

    def of(case: UseCase, around: frozenset[str]) -> Serving:
        if case.name in found:
            return found[case.name]
        inside = around | {case.name}
        parts = [cases[folded(name)] for name in case.includes]
        made = Serving(
            tuple(_states(system, case)),
            tuple(of(part, inside) for part in parts if part.name not in inside),
            bool(case.participants) and outside.issuperset(case.participants),
        )
        found[case.name] = made
        return made

    return {case.name: of(case, frozenset()) for case in system.suc.usecases}


def _states(system: System, case: UseCase) -> Iterator[Place]:
    names = {folded(name) for name in (case.name, *case.realises)}
    for chart in system.iacs:
        bound = _bound(system, chart.name, names)
        inside: list[str] = []
        for state in chart.states:
            if any(state.label.startswith(f"{label}.") for label in inside):
                continue  # the state around it serves already
            if state.type not in (StateType.START, StateType.END, StateType.CONDITION) and any(
                folded(name) in names | bound for name in _names(chart, state)
            ):
                inside.append(state.label)
                yield chart.name, state.label


def _bound(system: System, role: str, names: set[str]) -> set[str]:
    """What a role does in place of the activities of a protocol that have these names."""
    pairs = (pair for srm in system.srms if srm.name == role for item in srm.plays for pair in item.bindings)
    return {folded(own) for abstract, own in pairs if folded(abstract) in names}


def _names(chart: Statechart, state: State) -> Iterator[str]:
    """How a state is called: its own name, its activity, and what it is the whole of."""
    yield state.name.partition("(")[0]
    if state.activity is not None:
        yield state.activity
    parent = None if state.parent is None else chart.by_label[state.parent]
    if parent is None or parent.origin != state.origin:
        yield state.origin.name
        if state.origin.kind is OriginKind.PROTOCOL:
            yield state.origin.owner


__all__ = ["Place", "Serving", "serving"]
