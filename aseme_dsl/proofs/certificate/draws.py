"""Draws: each open branch of a choice with weights is taken as often as its weight says."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola.expression import Arithmetic, Compare, Conditional, Holds, Literal, Logic, Random, Value
from aseme_dsl.amola.statechart import Transition
from aseme_dsl.proofs.certificate.meaning import same


def draw_problem(ways: Sequence[Transition]) -> str | None:
    """What is wrong with the draws of a choice, whose transitions are given in their order."""
    weighted = [way for way in ways if way.expression.weight is not None]
    for place, way in enumerate(ways):
        if way.expression.weight is None and way.expression.draw is not None:
            return "a transition without a weight is drawn"
        if way.expression.weight is not None and not _is_drawn(way, weighted[weighted.index(way) :]):
            return f"the draw of its transition {place + 1} is not by the weights"
    return None


def _is_drawn(way: Transition, open_ones: Sequence[Transition]) -> bool:
    """Whether the draw is `random() * (own weight + those of the open ones behind) < own weight`."""
    draw, condition = way.expression.draw, way.expression.condition
    if condition is not None:
        match draw:
            case Logic(operator="&&", operands=(Holds(operand=asked), drawn)) if same(asked, condition):
                draw = drawn
            case _:
                return False
    match draw:
        case Compare(
            operator="<",
            left=Arithmetic(operator="*", left=Random(), right=total),
            right=Literal(value=number),
        ):
            return number == way.expression.weight and _is_total(total, open_ones)
    return False


def _is_total(total: Value, ways: Sequence[Transition]) -> bool:
    """Whether a sum has the weight of each way that is open, the first in any case."""
    parts: list[Value] = []
    while isinstance(total, Arithmetic) and total.operator == "+":
        parts.insert(0, total.right)
        total = total.left
    parts.insert(0, total)
    return len(parts) == len(ways) and all(
        _is_share(part, way, always=place == 0)
        for place, (part, way) in enumerate(zip(parts, ways, strict=True))
    )


def _is_share(part: Value, way: Transition, *, always: bool) -> bool:
    condition = way.expression.condition
    match part:
        case Literal(value=number):
            return number == way.expression.weight and (always or condition is None)
        case Conditional(condition=Holds(operand=asked), yes=Literal(value=number), no=Literal(value=0)):
            return number == way.expression.weight and condition is not None and same(asked, condition)
    return False


__all__ = ["draw_problem"]
