"""Stopping: transitions that are taken only after time has passed or something has arrived."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from aseme_dsl.amola.expression import (
    After,
    Event,
    Expired,
    Literal,
    Logic,
    Lost,
    StartTimer,
    TransitionExpression,
    Value,
)
from aseme_dsl.compiler.control.control import Line
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.formulas import Stops


def stops_of(by_way: Mapping[Way, Sequence[Line]]) -> Stops:
    """Whether every line of a way waits, so that a loop through it comes to rest in each round.

    A way without a line does not. Of an event that could not be read, it is already said what is wrong.
    """

    def stops(way: Way) -> bool:
        lines = by_way.get(way, ())
        return bool(lines) and all(
            _waits(line.expression) or bool(line.written.events and not line.expression.events)
            for line in lines
        )

    return stops


def _waits(expression: TransitionExpression) -> bool:
    if expression.every:
        return True
    if expression.events:
        return not any(_may_be_there(event) for event in expression.events)
    started = {
        action.timer
        for action in expression.actions
        if isinstance(action, StartTimer) and _is_positive(action.duration)
    }
    return expression.condition is not None and any(
        isinstance(item, Expired) and item.timer in started for item in _conjuncts(expression.condition)
    )


def _may_be_there(event: Event) -> bool:
    """Whether an event may be there as soon as the source is entered, in every round."""
    return isinstance(event, Lost) or (isinstance(event, After) and event.duration == 0)


def _is_positive(duration: Value) -> bool:
    return isinstance(duration, Literal) and isinstance(duration.value, int | float) and duration.value > 0


def _conjuncts(condition: Value) -> Sequence[Value]:
    """What has to hold together."""
    if isinstance(condition, Logic) and condition.operator == "&&":
        return condition.operands
    return (condition,)


__all__ = ["stops_of"]
