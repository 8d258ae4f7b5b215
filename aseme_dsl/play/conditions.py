"""Conditions in parts, and probes around these, which tell in the running code whether they hold.

A condition is read in negation normal form: `!(a && b)` is `!a || !b`. Its parts are what `&&` and `||` join,
each with its negation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from aseme_dsl.amola.expression import Call, Literal, Logic, Named, Not, Value
from aseme_dsl.amola.messages import BOOL, INT, PROBE, Function
from aseme_dsl.source import Source, Span

_PROBE = Function("probe", (("number", INT), ("holds", BOOL)), BOOL, PROBE, Span(Source("", ""), 0, 0))


def normal_form(value: Value, *, negated: bool = False) -> Value:
    """The same condition, with `!` before parts only."""
    match value:
        case Named() if isinstance(meant(value), Logic | Not):
            return normal_form(meant(value), negated=negated)
        case Not(operand=operand):
            return normal_form(operand, negated=not negated)
        case Logic(operator=word, operands=operands):
            other = {"&&": "||", "||": "&&"}[word]
            parts = tuple(normal_form(item, negated=negated) for item in operands)
            return replace(value, operator=other if negated else word, operands=parts)
    return Not(value, value.span) if negated else value


def parts_of(normal: Value) -> Iterator[Value]:
    """The parts of a condition in normal form, from left to right."""
    if isinstance(normal, Logic):
        for item in normal.operands:
            yield from parts_of(item)
    else:
        yield normal


def meant(value: Value) -> Value:
    """What a name stands for."""
    while isinstance(value, Named):
        value = value.expression
    return value


def around(value: Value, number: int) -> Value:
    """The value with a probe of this number around it, which changes nothing."""
    return Call(_PROBE, (Literal(number, INT, value.span), value), BOOL, value.span)


def shown_as(value: Value, text: str) -> Value:
    """The value, which texts show so: what has probes in it is shown as it was written."""
    return Named(text, value, BOOL, value.span)


def is_probe(value: Value) -> bool:
    """Whether a value is a probe, with what it is around."""
    return isinstance(value, Call) and value.function is _PROBE


__all__ = ["around", "is_probe", "meant", "normal_form", "parts_of", "shown_as"]
