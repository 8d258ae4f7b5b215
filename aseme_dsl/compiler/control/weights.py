"""Weights: random choices, in which each branch has a weight."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from aseme_dsl.amola.expression import (
    Arithmetic,
    Compare,
    Conditional,
    Holds,
    Literal,
    Logic,
    Random,
    Value,
)
from aseme_dsl.amola.messages import DOUBLE, INT
from aseme_dsl.amola.statechart import Transition


def with_draws(transitions: Sequence[Transition]) -> tuple[Transition, ...]:
    """The transitions, of which those with weights are drawn at random.

    The conditions of one choice are looked at in order. That of an open branch holds with its weight's share
    of those open branches which have not been passed by. So the last of these always holds, and every open
    branch is taken as often as its weight says. A number is drawn only for an open branch.
    """
    by_source: dict[str, list[int]] = {}
    for index, item in enumerate(transitions):
        if item.expression.weight is not None:
            by_source.setdefault(item.source, []).append(index)
    found = list(transitions)
    for indices in by_source.values():
        indices.sort(key=lambda index: transitions[index].priority)
        behind: tuple[Value, ...] = ()
        for index in reversed(indices):
            item = transitions[index]
            draw = _draw(item, behind)
            behind = (_share(item), *behind)
            found[index] = replace(item, expression=replace(item.expression, draw=draw))
    return tuple(found)


def _weight(branch: Transition) -> Value:
    weight = branch.expression.weight
    assert weight is not None
    return Literal(weight, INT, branch.span)


def _share(branch: Transition) -> Value:
    """The weight of a branch, 0 if it is not open."""
    condition, span = branch.expression.condition, branch.span
    if condition is None:
        return _weight(branch)
    return Conditional(Holds(condition, span), _weight(branch), Literal(0, INT, span), INT, span)


def _draw(branch: Transition, behind: Sequence[Value]) -> Value:
    """Whether a branch is open and drawn before those behind it."""
    condition, span = branch.expression.condition, branch.span
    rest = _weight(branch)
    for share in behind:
        rest = Arithmetic("+", rest, share, INT, span)
    number = Arithmetic("*", Random(span), rest, DOUBLE, span)
    drawn = Compare("<", number, _weight(branch), span)
    if condition is None:
        return drawn
    return Logic("&&", (Holds(condition, span), drawn), span)


__all__ = ["with_draws"]
