"""Contradicting: assumptions about values that cannot be true together, so that there is no run at all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import cast

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import Kind
from aseme_dsl.play.scenario import ValueAssumed

_OPPOSITE = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_TURNED = {"==": "==", "!=": "!=", "<": ">", ">": "<", "<=": ">=", ">=": "<="}

Constant = bool | int | float | str
"""A constant of an enum is its name."""

Asked = tuple[str, Constant]
"""A comparison with a constant: its sign and the constant."""


def contradiction_in(assumed: Iterable[ValueAssumed]) -> str:
    """Why assumptions cannot be true together; empty if nothing is found.

    Values that are compared with constants are looked at, each for itself, and no other conditions.
    """
    known: dict[tuple[str, str], dict[Asked, str]] = {}
    for item in assumed:
        text = " ".join(item.span.text.split())
        for value, asked in _comparisons(item.value, is_true=True):
            others = known.setdefault((item.agent, e.value_text(value, expand=True)), {})
            others.setdefault(asked, text)
            if not _is_possible([*others], value.type.kind):
                is_alone = set(others.values()) == {text}
                return (
                    f"`{text}` is never true"
                    if is_alone
                    else f"`{text}` and another assumption exclude each other"
                )
    return ""


def _comparisons(value: e.Value, is_true: bool) -> Iterator[tuple[e.Value, Asked]]:
    """The values that a condition compares with constants, where it has to be true, or not to be."""
    match value:
        case e.Named(expression=inner):
            yield from _comparisons(inner, is_true)
        case e.Not(operand=inner):
            yield from _comparisons(inner, not is_true)
        case e.Logic(operator=word, operands=parts) if (word == "&&") is is_true:
            for part in parts:
                yield from _comparisons(part, is_true)
        case e.Compare(operator=sign, left=left, right=right):
            sign = sign if is_true else _OPPOSITE[sign]
            for one, other, turned in ((left, right, sign), (right, left, _TURNED[sign])):
                constant = _constant(other)
                if constant is not None and isinstance(one, e.Member | e.VariableValue):
                    yield one, (turned, constant)
        case e.Member() | e.VariableValue():
            yield value, ("==", is_true)
        case _:
            pass


def _constant(value: e.Value) -> Constant | None:
    match value:
        case e.Named(expression=inner):
            return _constant(inner)
        case e.EnumConstant(constant=name):
            return name
        case e.Literal(value=constant) if isinstance(constant, bool | int | float | str):
            return constant
        case e.Negate(operand=inner):
            number = _constant(inner)
            return -number if isinstance(number, int | float) else None
        case _:
            return None


def _is_possible(asked: list[Asked], kind: Kind) -> bool:
    """Whether some value meets all comparisons."""
    if kind in (Kind.INT, Kind.DURATION, Kind.DOUBLE):
        numbers = sorted({constant for _, constant in asked if isinstance(constant, int | float)})
        tried: list[Constant] = [end + by for end in numbers for by in (-1, 0, 1)]
        if kind is Kind.DOUBLE:
            tried += [(one + other) / 2 for one, other in pairwise(numbers)]
    elif kind is Kind.BOOL:
        tried = [False, True]
    elif all(sign in ("==", "!=") for sign, _ in asked):
        tried = [
            *(constant for _, constant in asked),
            "".join(map(str, (constant for _, constant in asked))) + "+",
        ]
    else:
        return True
    return any(
        all(e.COMPARE[sign](cast(float, one), cast(float, other)) for sign, other in asked) for one in tried
    )


__all__ = ["contradiction_in"]
