"""States: which of the states that conditions ask after exclude each other, by the shape of the chart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.statechart import State, Statechart, StateType


def facts_of_states(chart: Statechart, source: str, conditions: Sequence[e.Value]) -> tuple[e.Value, ...]:
    """What always holds between `in(T)` and `done(T)` of these conditions, looked at from `source`."""
    asked = {
        (part.question, part.state): part
        for condition in conditions
        for part in e.walk(condition)
        if isinstance(part, e.StateValue) and part.question in ("in", "done")
    }
    found: list[e.Value] = []
    for one, other in permutations(asked.values(), 2):
        first, second = (states_meant(chart, source, part.state) for part in (one, other))
        if not first or not second:
            continue
        if other.question == "in" and all(any(_holds(y, x) for y in second) for x in first):
            found.append(_not_together(one, e.Not(other, other.span)))
        if all(_exclude(chart, x, y) for x in first for y in second):
            found.append(_not_together(one, other))
    return tuple(found)


def _not_together(one: e.Value, other: e.Value) -> e.Value:
    return e.Not(e.Logic("&&", (one, other), one.span), one.span)


def _holds(outer: State, inner: State) -> bool:
    return inner.label == outer.label or inner.label.startswith(f"{outer.label}.")


def _exclude(chart: Statechart, one: State, other: State) -> bool:
    """Whether two states are never active together: neither holds the other, and one OR holds both."""
    if _holds(one, other) or _holds(other, one):
        return False
    around = set(_around(chart, one))
    lowest = next(label for label in _around(chart, other) if label in around)
    return chart.node(lowest).type is StateType.OR


def _around(chart: Statechart, node: State) -> Iterator[str]:
    return (item.label for item in chart.ancestors(node.label))


__all__ = ["facts_of_states"]
