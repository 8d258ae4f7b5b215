"""Constants: what an expression of literals, enum constants and lets comes to."""

from __future__ import annotations

import math
from typing import cast

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Value
from aseme_dsl.amola.messages import DOUBLE, DURATION

LARGEST_INT = 2**63 - 1

Constant = bool | int | float | str


class NotConstant(Exception):
    """A part of the expression is known only at run time; `value` is that part."""

    def __init__(self, value: Value) -> None:
        super().__init__()
        self.value = value


def fold(value: Value) -> Constant:
    """The constant that `value` comes to: an enum constant's name, a duration in ns.

    Raises:
        NotConstant: It reads something.
        ArithmeticError: It divides by zero, or a part of it fits neither an int of 64 bits nor a double.
    """
    match value:
        case Literal(value=constant):
            return constant
        case amola.EnumConstant(constant=name):
            return name
        case amola.Named(expression=inner):
            return fold(inner)
        case amola.Negate(operand=operand):
            inner_value = fold(operand)
            assert not isinstance(inner_value, str)
            return -inner_value
        case amola.Not(operand=operand):
            return not fold(operand)
        case amola.Logic(operator=operator, operands=parts):
            truths = [fold(part) for part in parts]
            return all(truths) if operator == "&&" else any(truths)
        case amola.Conditional(condition=condition, yes=yes, no=no, type=kind):
            chosen = fold(yes if fold(condition) else no)
            return float(chosen) if kind == DOUBLE else chosen
        case amola.Compare(operator=operator, left=left, right=right):
            return amola.COMPARE[operator](cast(float, fold(left)), cast(float, fold(right)))
        case amola.Arithmetic(operator=operator, left=left, right=right, type=kind):
            first, second = fold(left), fold(right)
            assert not isinstance(first, str) and not isinstance(second, str)
            result = amola.COMPUTE[operator](first, second)
            if kind == DOUBLE:
                result = float(result)
            if not (abs(result) <= LARGEST_INT if kind != DOUBLE else math.isfinite(result)):
                raise OverflowError("it is too large")
            return round(result) if kind == DURATION else result
    raise NotConstant(value)
