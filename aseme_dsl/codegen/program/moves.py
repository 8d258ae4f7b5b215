"""Compound transitions: where they act, what they leave and enter, what they write; and what may raise."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.expression import (
    Arithmetic,
    Assign,
    Call,
    Literal,
    Named,
    Negate,
    NewMessage,
    Random,
    TransitionExpression,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.messages import DOUBLE, DURATION
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Move:
    """A compound transition: its segments, what it leaves and enters.

    `scope` is the lowest OR state that holds all sources and targets, `region` the one in which that is: what
    the segments do counts there. With `stays` nothing is left or entered. `into` are the states in regions of
    the target, an AND, that are entered instead of the STARTs there.
    """

    taken: tuple[int, ...]
    segments: tuple[Transition, ...]
    scope: str
    region: int
    target: str
    stays: bool
    resume: bool
    into: tuple[str, ...]


def move_of(flat: FlatChart, taken: tuple[int, ...]) -> Move:
    """The compound transition of some segments, given by their numbers."""
    segments = tuple(flat.transition(number) for number in taken)
    scope = min((flat.chart.scope_of(segment) for segment in segments), key=len)
    last = segments[-1]
    stays = segments[0].kind is TransitionKind.ON
    region = flat.region_number[scope]
    return Move(taken, segments, scope, region, last.target, stays, last.resume, last.into)


def path(chart: Statechart, scope: str, target: str) -> list[str]:
    """A state and those around it that are inside `scope`, innermost first."""
    found = [target]
    while (parent := chart.node(found[-1]).parent) not in (scope, None):
        assert parent is not None
        found.append(parent)
    return found


def left_with(flat: FlatChart, leaf: State, scope: str) -> Iterator[State]:
    """The states that are left with an active leaf, innermost first, if everything inside `scope` is left.

    Of these only states that may have an `exit` count.
    """
    if leaf.type in (StateType.BASIC, StateType.AND) and len(leaf.label) > len(scope):
        yield leaf
    for around in flat.around(leaf.label):
        if len(around.label) > len(scope):
            yield around


def completing_ends(flat: FlatChart, node: State) -> tuple[tuple[int, str], ...] | None:
    """The regions of an AND, each with the END at which it must be for the AND to be complete.

    None if one of them never is: it has no END, or no number for it.
    """
    found: list[tuple[int, str]] = []
    for region in flat.regions_of(node.label):
        end = flat.chart.end_of(region.label)
        if end is None or end.label not in flat.leaf:
            return None
        found.append((region.number, end.label))
    return tuple(found)


def assigned(expression: TransitionExpression) -> tuple[str, ...]:
    """The variables that an expression assigns, each once."""
    return tuple(
        dict.fromkeys(
            action.target.name
            for action in expression.actions
            if isinstance(action, Assign) and isinstance(action.target, VariableValue)
        )
    )


def raises(value: Value) -> bool:
    """Whether something in a value may raise: a function of the document, numbers that have no result, or a
    new message, whose members may have narrower types."""
    return any(
        isinstance(part, NewMessage)
        or (isinstance(part, Call) and part.function.is_of_document)
        or (isinstance(part, Arithmetic) and may_raise(part))
        for part in walk(value)
    )


def draws(value: Value) -> bool:
    """Whether computing a value draws a random number."""
    return any(isinstance(part, Random) for part in walk(value))


def may_raise(value: Arithmetic) -> bool:
    """Whether some operands make this raise: a divisor of zero, or an infinite factor of a duration.

    An `int` and a `duration` have 64 bits, so a `double` can always hold them. A duration that is multiplied
    by a literal never overflows a `double` either.
    """
    if value.operator in ("/", "%"):
        return not _number(value.right)
    factors = [_number(item) for item in (value.left, value.right) if item.type == DOUBLE]
    return value.type == DURATION and None in factors


def _number(value: Value) -> float | None:
    """The number that a value always is, but for its sign; None if that is not known."""
    while isinstance(value, Named | Negate):
        value = value.expression if isinstance(value, Named) else value.operand
    if isinstance(value, Literal) and isinstance(value.value, int | float):
        return value.value
    return None


__all__ = [
    "Move",
    "assigned",
    "completing_ends",
    "draws",
    "left_with",
    "may_raise",
    "move_of",
    "path",
    "raises",
]
