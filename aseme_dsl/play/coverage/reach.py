"""Reach: which states of a statechart can be entered at all, and which transitions taken."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.expression import Literal, Logic, Named, Value
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Reach:
    """The labels of states, and the numbers of transitions, that some path leads to."""

    states: frozenset[str]
    transitions: frozenset[int]


def reach_of(chart: Statechart) -> Reach:
    """What can be reached if each condition may hold but those that are constantly false.

    What is left out is never reached. What is in it may be, as far as paths say.
    """
    by_source: dict[str, list[int]] = {}
    for number, item in enumerate(chart.transitions):
        if not never_holds(item.expression.condition):
            by_source.setdefault(item.source, []).append(number)
    reached: set[str] = set()
    taken: set[int] = set()
    waiting = [chart.root.label]
    while waiting:
        label = waiting.pop()
        if label in reached:
            continue
        reached.add(label)
        waiting += (other.label for other in _entered_with(chart, chart.by_label[label]))
        waiting += (other.label for other in chart.ancestors(label))
        for number in by_source.get(label, ()):
            taken.add(number)
            waiting += (chart.transitions[number].target, *chart.entries_of(chart.transitions[number]))
    return Reach(frozenset(reached), frozenset(_possible(chart, reached, taken)))


def _entered_with(chart: Statechart, state: State) -> Iterator[State]:
    """The states that are entered with one, unless a transition names others inside it."""
    if state.type is StateType.AND:
        yield from chart.children(state.label)
    elif state.type is StateType.OR and (start := chart.start_of(state.label)) is not None:
        yield start


def _possible(chart: Statechart, reached: set[str], taken: set[int]) -> Iterator[int]:
    """Those of the transitions whose source can be complete, where they wait for that."""
    for number in taken:
        item = chart.transitions[number]
        if not _waits_for_end(chart, item) or _can_complete(chart, chart.by_label[item.source], reached):
            yield number


def _waits_for_end(chart: Statechart, item: Transition) -> bool:
    expression = item.expression
    return item.kind is TransitionKind.EXTERNAL and not (item.first or expression.when or expression.events)


def _can_complete(chart: Statechart, state: State, reached: set[str]) -> bool:
    match state.type:
        case StateType.OR:
            end = chart.end_of(state.label)
            return end is not None and end.label in reached
        case StateType.AND:
            return all(_can_complete(chart, part, reached) for part in chart.children(state.label))
        case StateType.BASIC:
            return not state.waits
    return True


def never_holds(value: Value | None) -> bool:
    """Whether a condition is constantly false."""
    match value:
        case Named(expression=inner):
            return never_holds(inner)
        case Literal(value=False):
            return True
        case Logic(operator="&&", operands=parts):
            return any(map(never_holds, parts))
        case Logic(operator="||", operands=parts):
            return all(map(never_holds, parts))
    return False


__all__ = ["Reach", "never_holds", "reach_of"]
