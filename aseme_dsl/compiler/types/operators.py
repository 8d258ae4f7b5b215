"""Operators: which kinds of value they take and what kind they give."""

from __future__ import annotations

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, STRING, Kind, Type
from aseme_dsl.compiler.names.checker import Checker, is_number
from aseme_dsl.diagnostics import Problem
from aseme_dsl.diagnostics.problems.expressions import values as problems
from aseme_dsl.grammar.text import tree

COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")


def compare(checker: Checker, written: tree.Binary, left: Value, right: Value) -> Value | None:
    """`== !=` on values of one kind, the others on numbers, durations and strings (E509).

    Messages are equal if all their members are.
    """
    first, second = left.type, right.type
    operator = written.operator
    problem: Problem | None = None
    if first != second and not (is_number(first) and is_number(second)):
        problem = problems.NotComparable((str(first), str(second)), (str(first.kind), str(second.kind)))
    elif first.kind is Kind.LIST:
        problem = problems.ListsCompared()
    elif operator not in ("==", "!=") and not (is_number(first) or first in (DURATION, STRING)):
        problem = problems.NotOrdered(operator, str(first), first.kind is Kind.ENUM)
    if problem is not None:
        checker.report(problem, written.span)
        return None
    return amola.Compare(operator, left, right, written.span)


def arithmetic(checker: Checker, written: tree.Binary, left: Value, right: Value) -> Value | None:
    """Numbers give numbers (`/` a double), durations add and scale (E500)."""
    result = _result(written.operator, left.type, right.type)
    if result is None:
        types = (str(left.type), str(right.type))
        checker.report(problems.OperandTypes(written.operator, types), written.span)
        return None
    return amola.Arithmetic(written.operator, left, right, result, written.span)


def _result(operator: str, left: Type, right: Type) -> Type | None:
    if is_number(left) and is_number(right):
        return DOUBLE if operator == "/" or DOUBLE in (left, right) else INT
    match operator:
        case "+" | "-" if left == right == DURATION:
            return DURATION
        case "*" if DURATION in (left, right) and (is_number(left) or is_number(right)):
            return DURATION
        case "/" if left == DURATION and right == INT:
            return DURATION
        case "/" if left == right == DURATION:
            return DOUBLE
    return None


def common_type(first: Type, second: Type) -> Type | None:
    """The type of a value that is one of two: an int may be a double. Lists are none."""
    if Kind.LIST in (first.kind, second.kind):
        return None
    if first == second:
        return first
    return DOUBLE if is_number(first) and is_number(second) else None


def negate(checker: Checker, written: tree.Unary, operand: Value) -> Value | None:
    """The sign of a number or duration (E500); that of a constant becomes a part of it."""
    kind = operand.type
    if not (is_number(kind) or kind == DURATION):
        checker.report(problems.OperandTypes(written.operator, (str(kind),)), written.span)
        return None
    if written.operator == "+":
        return operand
    if isinstance(operand, amola.Literal):
        assert not isinstance(operand.value, str)
        return amola.Literal(-operand.value, kind, written.span)
    return amola.Negate(operand, kind, written.span)


def is_condition(checker: Checker, value: Value | None, operator: str | None) -> bool:
    """Whether a condition, or an operand, is a bool (E505), which is silent about what is wrong already."""
    if value is None:
        return False
    if value.type == BOOL:
        return True
    not_a_bool = problems.NotABool(operator, str(value.type), value.type.kind is Kind.MESSAGE)
    checker.report(not_a_bool, value.span)
    return False
