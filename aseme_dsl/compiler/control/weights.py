"""Weights: choices by chance, in which each branch has a weight."""

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
    Weight,
)
from aseme_dsl.amola.messages import DOUBLE, INT
from aseme_dsl.amola.statechart import Transition
from aseme_dsl.source import Span


def with_draws(transitions: Sequence[Transition]) -> tuple[Transition, ...]:
    """The transitions, of which those with weights are taken by chance.

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
            written = item.expression.weight
            assert written is not None
            # The condition of the expression has the names of the chart, the weight's those of the text.
            weight = replace(written, condition=item.expression.condition)
            condition = _drawn(weight, behind, item.span)
            behind = (_share(weight, item.span), *behind)
            found[index] = replace(
                item, expression=replace(item.expression, condition=condition, weight=weight)
            )
    return tuple(found)


def _share(weight: Weight, span: Span) -> Value:
    """The weight of a branch, 0 if it is not open."""
    value = Literal(weight.value, INT, span)
    if weight.condition is None:
        return value
    return Conditional(Holds(weight.condition, span), value, Literal(0, INT, span), INT, span)


def _drawn(weight: Weight, behind: Sequence[Value], span: Span) -> Value:
    """Whether a branch is open and drawn before those behind it."""
    rest: Value = Literal(weight.value, INT, span)
    for share in behind:
        rest = Arithmetic("+", rest, share, INT, span)
    number = Arithmetic("*", Random(span), rest, DOUBLE, span)
    drawn = Compare("<", number, Literal(weight.value, INT, span), span)
    if weight.condition is None:
        return drawn
    return Logic("&&", (Holds(weight.condition, span), drawn), span)


__all__ = ["with_draws"]
