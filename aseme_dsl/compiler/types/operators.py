"""Operators: which kinds of value they take and what kind they give."""

from __future__ import annotations

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, STRING, Kind, Type
from aseme_dsl.compiler.names.checker import Checker, a, is_number
from aseme_dsl.grammar.text import tree

COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")


def compare(checker: Checker, written: tree.Binary, left: Value, right: Value) -> Value | None:
    """`== !=` on values of one kind, the others on numbers, durations and strings (E509)."""
    first, second = left.type, right.type
    operator = written.operator
    problem = hint = None
    if first != second and not (is_number(first) and is_number(second)):
        problem = f"{a(first)} and {a(second)} cannot be compared"
        hint = _comparison_hint(first, second)
    elif first.kind is Kind.MESSAGE:
        problem, hint = f"two messages ({first}) cannot be compared", "compare their members"
    elif first.kind is Kind.LIST:
        problem = "two lists cannot be compared"
        hint = "compare their sizes or elements: `size(x)`, `x[0]`"
    elif operator not in ("==", "!=") and not (is_number(first) or first in (DURATION, STRING)):
        problem = f"`{operator}` does not order {_plural(first)}"
        hint = "`<`, `<=`, `>`, `>=` are for numbers, durations and strings"
    if problem is not None:
        checker.report("E509", problem, written.span, hint)
        return None
    return amola.Compare(operator, left, right, written.span)


def _comparison_hint(first: Type, second: Type) -> str | None:
    kinds = {first.kind, second.kind}
    if Kind.LIST in kinds:
        return "compare its size or an element, `size(x)`, `x[0]`, or ask `contains(x, …)`"
    if Kind.MESSAGE in kinds:
        message = first if first.kind is Kind.MESSAGE else second
        return f"name a member of `{message}`, or write `has(…)` to ask whether it is there"
    if Kind.DURATION in kinds and kinds & {Kind.INT, Kind.DOUBLE}:
        return "a duration has a unit: 200ms, 1.5s, 2min"
    if Kind.ENUM in kinds and kinds & {Kind.INT, Kind.DOUBLE}:
        enum = first if first.kind is Kind.ENUM else second
        return f"compare it with a constant of `{enum}`"
    if kinds == {Kind.ENUM}:
        return f"the constants of `{first}` and those of `{second}` are different things"
    if Kind.ENUM in kinds and Kind.STRING in kinds:
        enum = first if first.kind is Kind.ENUM else second
        return f"a constant of `{enum}` is written without quotes: `{enum}.…`"
    if Kind.STRING in kinds and kinds & {Kind.INT, Kind.DOUBLE}:
        return "a text stands in double quotes, a number does not"
    if Kind.BOOL in kinds:
        return "a bool is a condition as it stands: `x` or `!x`"
    return None


def _plural(kind: Type) -> str:
    return f"constants of `{kind}`" if kind.kind is Kind.ENUM else f"values of type {kind}"


def arithmetic(checker: Checker, written: tree.Binary, left: Value, right: Value) -> Value | None:
    """Numbers give numbers (`/` a double), durations add and scale (E500)."""
    result = _result(written.operator, left.type, right.type)
    if result is None:
        problem = f"`{written.operator}` does not take {a(left.type)} and {a(right.type)}"
        checker.report(
            "E500", problem, written.span, _arithmetic_hint(written.operator, left.type, right.type)
        )
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


def _arithmetic_hint(operator: str, left: Type, right: Type) -> str | None:
    if operator in "+-" and DURATION in (left, right) and (is_number(left) or is_number(right)):
        return "a duration has a unit: 200ms, 1.5s, 2min"
    if (operator, left, right) == ("/", DURATION, DOUBLE):
        return "a duration is divided by an int; multiply it by a double"
    return None


def negate(checker: Checker, written: tree.Unary, operand: Value) -> Value | None:
    """The sign of a number or duration (E500); that of a constant becomes a part of it."""
    kind = operand.type
    if not (is_number(kind) or kind == DURATION):
        checker.report("E500", f"`{written.operator}` does not take {a(kind)}", written.span)
        return None
    if written.operator == "+":
        return operand
    if isinstance(operand, amola.Literal):
        assert not isinstance(operand.value, str)
        return amola.Literal(-operand.value, kind, written.span)
    return amola.Negate(operand, kind, written.span)


def is_condition(checker: Checker, value: Value | None, what: str) -> bool:
    """Whether a value is a bool (E505), which is silent about what is wrong already."""
    if value is None:
        return False
    if value.type == BOOL:
        return True
    hint = None
    if value.type.kind is Kind.MESSAGE:
        hint = "write `has(…)` to ask whether the message is there"
    elif is_number(value.type):
        hint = "compare it with something: `… > 0`"
    checker.report("E505", f"{what} must be a bool, not {a(value.type)}", value.span, hint)
    return False
