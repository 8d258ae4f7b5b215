"""Lists: `[a, b]`, `x.items[i]`, `size(…)` and `contains(…)`, typed."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import DOUBLE, INT, Kind, Type, list_of
from aseme_dsl.compiler.names.checker import Checker, a, is_number
from aseme_dsl.compiler.names.paths import member_path, unnamed
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.types.calls import fits, is_given, wrong_form
from aseme_dsl.diagnostics import Related
from aseme_dsl.grammar.text import tree


def literal(checker: Checker, written: tree.List, elements: Sequence[Value]) -> Value | None:
    """`[a, b]`: values of one type, ints among doubles (E536)."""
    if not elements:
        return amola.ListValue((), list_of(None), written.span)
    first = elements[0]
    for item in elements:
        if item.type.kind is Kind.LIST:
            checker.report("E536", "a list does not hold lists", item.span, "write its elements")
            return None
        if item.type != first.type and not (is_number(item.type) and is_number(first.type)):
            problem = f"the elements of a list are of one type: {a(first.type)}, not {a(item.type)}"
            related = (Related(first.span, f"{a(first.type)}"),)
            checker.report("E536", problem, item.span, related=related)
            return None
    kind = DOUBLE if any(item.type == DOUBLE for item in elements) else first.type
    return amola.ListValue(tuple(elements), list_of(kind), written.span)


def is_empty(checker: Checker, value: Value | None) -> bool:
    """Whether it is `[]` where nothing says of what (E536)."""
    found = value is not None and value.type == list_of(None)
    if found and value is not None:
        hint = "`[]` stands where a repeated member is filled: `items = []`"
        checker.report("E536", "nothing says what this list would hold", value.span, hint)
    return found


def element(checker: Checker, written: tree.Element, whole: Value, index: Value) -> Value | None:
    """`list[index]`, and what follows: E535, E501, W552."""
    if whole.type.kind is not Kind.LIST:
        problem = f"`{written.list.span.text}` is {a(whole.type)}: only a list has elements"
        hint = "a repeated member of a message is a list, and so is `[a, b]`"
        checker.report("E535", problem, written.span, hint)
        return None
    if is_empty(checker, whole):
        return None
    if index.type != INT:
        hint = "round it: `floor`, `ceil` and `round` of `import math` give an int"
        problem = f"an element is chosen by an int, not by {a(index.type)}"
        checker.report("E535", problem, index.span, hint if index.type == DOUBLE else None)
        return None
    assert whole.type.element is not None
    found = member_path(checker, whole.type.element, (), written.members)
    if found is None:
        return None
    _warn(checker, whole, index)
    return amola.Element(whole, index, *found, written.span)


def _warn(checker: Checker, whole: Value, index: Value) -> None:
    """W552 where a constant chooses an element that there cannot be."""
    try:
        number = fold(index)
    except (NotConstant, ArithmeticError):
        return
    assert isinstance(number, int)
    written = unnamed(whole)
    count = len(written.elements) if isinstance(written, amola.ListValue) else None
    if number < 0:
        hint = "the first element is 0; the last one of `x` is `x[size(x) - 1]`"
        checker.report("W552", f"there is no element {number}: this is always absent", index.span, hint)
    elif count is not None and number >= count:
        hint = f"the last one is {count - 1}: the first is 0"
        checker.report("W552", f"there is no element {number}: this is always absent", index.span, hint)


def size(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """`size(list)` (E504)."""
    if not _is_of_list(checker, "size", written, arguments, 1):
        return None
    return amola.Size(arguments[0], written.span)


def contains(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """`contains(list, value)` (E504)."""
    if not _is_of_list(checker, "contains", written, arguments, 2):
        return None
    whole, wanted = arguments
    kind: Type | None = whole.type.element
    assert kind is not None
    if kind.kind is Kind.MESSAGE:
        problem = f"the list holds messages (`{kind}`), which cannot be compared"
        wrong_form(checker, "contains", wanted.span, problem)
        return None
    if not fits(wanted.type, kind):
        problem = f"the list holds values of type {kind}: {a(wanted.type)} is not among them"
        wrong_form(checker, "contains", wanted.span, problem)
        return None
    return amola.Contains(whole, wanted, written.span)


def _is_of_list(
    checker: Checker, name: str, written: tree.Call, arguments: Sequence[Value], count: int
) -> bool:
    if not is_given(checker, name, written, count):
        return False
    if arguments[0].type.kind is not Kind.LIST:
        problem = f"`{name}` wants a list, not {a(arguments[0].type)}"
        wrong_form(checker, name, arguments[0].span, problem)
        return False
    return not is_empty(checker, arguments[0])


__all__ = ["contains", "element", "is_empty", "literal", "size"]
