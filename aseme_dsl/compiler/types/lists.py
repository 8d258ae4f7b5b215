"""Lists: `[a, b]`, `x.items[i]`, `size(…)`, `contains(…)` and `find(…)`, typed."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import DOUBLE, INT, Kind, Type, list_of
from aseme_dsl.compiler.names.checker import Checker, is_number
from aseme_dsl.compiler.names.paths import member_path, unnamed, value_of_path
from aseme_dsl.compiler.read.builtins import FORMS
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.types.calls import assignable, fits, is_given
from aseme_dsl.compiler.types.operators import arithmetic
from aseme_dsl.diagnostics import Related
from aseme_dsl.diagnostics.problems.expressions import values as problems
from aseme_dsl.diagnostics.problems.expressions.arguments import OtherKind, OtherThanElements
from aseme_dsl.diagnostics.problems.expressions.bounds import ChangeOfOther, NeverEmpty
from aseme_dsl.diagnostics.problems.expressions.paths import MemberOfVariable
from aseme_dsl.diagnostics.wording import a
from aseme_dsl.grammar.text import tree


def literal(checker: Checker, written: tree.List, elements: Sequence[Value]) -> Value | None:
    """`[a, b]`: values of one type, ints among doubles (E536)."""
    if not elements:
        return amola.ListValue((), list_of(None), written.span)
    first = elements[0]
    for item in elements:
        if item.type.kind is Kind.LIST:
            checker.report(problems.ListInList(), item.span)
            return None
        if item.type != first.type and not (is_number(item.type) and is_number(first.type)):
            related = (Related(first.span, a(first.type)),)
            checker.report(problems.MixedList(str(first.type), str(item.type)), item.span, related)
            return None
    kind = DOUBLE if any(item.type == DOUBLE for item in elements) else first.type
    return amola.ListValue(tuple(elements), list_of(kind), written.span)


def is_empty(checker: Checker, value: Value | None) -> bool:
    """Whether it is `[]` where nothing says of what (E536)."""
    found = value is not None and value.type == list_of(None)
    if found and value is not None:
        checker.report(problems.EmptyList(), value.span)
    return found


def element(checker: Checker, written: tree.Element, whole: Value, index: Value) -> Value | None:
    """`list[index]`, and what follows: E535, E501, W552."""
    if whole.type.kind is not Kind.LIST:
        checker.report(problems.ElementOfOther(written.list.span.text, str(whole.type)), written.span)
        return None
    if is_empty(checker, whole):
        return None
    if index.type != INT:
        checker.report(problems.IndexNotInt(str(index.type)), index.span)
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
        checker.report(problems.NoElement(number, None), index.span)
    elif count is not None and number >= count:
        checker.report(problems.NoElement(number, count - 1), index.span)


def size(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """`size(list)` (E504)."""
    if not _is_of_list(checker, "size", written, arguments, 1):
        return None
    return amola.Size(arguments[0], written.span)


SEARCHES = ("contains", "find")
"""The forms that look for an element."""


def searched(
    checker: Checker, written: tree.Call, arguments: Sequence[Value], members: tuple[tree.Name, ...]
) -> Value | None:
    """`contains(list, value)` and `find(list, value)`, perhaps by a member of the elements (E504, E501)."""
    word = written.function.text
    if not _is_of_list(checker, word, written, arguments, 2):
        return None
    whole, wanted = arguments
    assert whole.type.element is not None
    found = member_path(checker, whole.type.element, (), members)
    if found is None:
        return None
    path, kind = found
    if not fits(wanted.type, kind):
        of = OtherThanElements(word, FORMS[word], str(kind), str(wanted.type), ".".join(path))
        checker.report(of, wanted.span)
        return None
    kind_of_search = amola.Find if word == "find" else amola.Contains
    return kind_of_search(whole, wanted, written.span, path)


CHANGES = ("append", "remove", "clear")
"""The actions that change a list or empty a variable."""

Typed = Callable[[Checker, tree.Expression], Value | None]


def change(checker: Checker, written: tree.Call, typed: Typed) -> amola.Assign | None:
    """`append(xs, v)`, `remove(xs, v)`, `remove(xs[i])` (E504, E535) and `clear(now)` (E507)."""
    word, arguments = written.function.text, written.arguments
    if word == "clear":
        return _clear(checker, written)
    if word == "remove" and len(arguments) == 1 and isinstance(arguments[0], tree.Element):
        return _drop(checker, written, arguments[0], typed)
    if not is_given(checker, word, written, 2):
        return None
    target = _variable(checker, word, arguments[0])
    if target is None or target.type.element is None:
        return None
    value = _given(checker, arguments[1], target.type.element, typed)
    if value is None:
        return None
    changed = amola.Changed(amola.Change(word), target, value, None, target.type, written.span)
    return amola.Assign(target, changed, written.span)


def _clear(checker: Checker, written: tree.Call) -> amola.Assign | None:
    """`clear(now)`: the variable holds nothing again."""
    if not is_given(checker, "clear", written, 1):
        return None
    place = written.arguments[0]
    name = place.segments[0].text if isinstance(place, tree.Path) else ""
    known = None if name in checker.scope.parameters else checker.scope.variables.get(name)
    whole = isinstance(place, tree.Path) and len(place.segments) == 1
    if known is None and isinstance(place, tree.Path) and value_of_path(checker, place) is None:
        return None
    if known is None or not whole or not known[1].begins_unset:
        kind = None if known is None or not whole else str(known[1])
        is_list = known is not None and whole and known[1].kind is Kind.LIST
        fix = f"{name} = []" if is_list else None
        checker.report(NeverEmpty(place.span.text, kind, fix), written.span, fix=fix)
        return None
    target = amola.VariableValue(*known, place.span)
    return amola.Assign(target, amola.Literal("", target.type, written.span), written.span)


def _drop(checker: Checker, written: tree.Call, place: tree.Element, typed: Typed) -> amola.Assign | None:
    word = written.function.text
    target = _variable(checker, word, place.list)
    if target is None:
        return None
    if place.members:
        checker.report(ChangeOfOther(word, place.span.text), place.span)
        return None
    index = _given(checker, place.index, INT, typed)
    if index is None:
        return None
    changed = amola.Changed(amola.Change.DROP, target, None, index, target.type, written.span)
    return amola.Assign(target, changed, written.span)


def put(checker: Checker, written: tree.Assign, typed: Typed) -> amola.Assign | None:
    """`xs[i] = v`, `xs[i] += v` (E507, E535)."""
    assert written.index is not None
    target = _variable(checker, "xs[i] = v", written.target)
    if target is None or target.type.element is None:
        return None
    if written.members:
        name = f"{written.target.text}[{written.index.span.text}]"
        checker.report(MemberOfVariable(name, str(target.type.element)), written.target.span)
        return None
    index = _given(checker, written.index, INT, typed)
    value = typed(checker, written.value)
    if index is None or value is None:
        return None
    if written.operator is not None:
        before = amola.Element(target, index, (), target.type.element, written.target.span)
        operator = written.operator
        sides = tree.Binary(operator.text, written.target, written.value, operator.span, written.span)
        value = arithmetic(checker, sides, before, value)
    if value is None or not assignable(checker, value, target.type.element):
        return None
    changed = amola.Changed(amola.Change.PUT, target, value, index, target.type, written.span)
    return amola.Assign(target, changed, written.span)


def _variable(checker: Checker, word: str, place: tree.Expression) -> amola.VariableValue | None:
    """The variable with the list that is changed (E535)."""
    name = place.segments[0].text if isinstance(place, tree.Path) and len(place.segments) == 1 else ""
    known = checker.scope.variables.get(name)
    if known is not None and known[1].element is not None and name not in checker.scope.parameters:
        return amola.VariableValue(known[0], known[1], place.span)
    checker.report(ChangeOfOther(word, place.span.text), place.span)
    return None


def _given(checker: Checker, written: tree.Expression, kind: Type, typed: Typed) -> Value | None:
    value = typed(checker, written)
    return value if value is not None and assignable(checker, value, kind) else None


def _is_of_list(
    checker: Checker, name: str, written: tree.Call, arguments: Sequence[Value], count: int
) -> bool:
    if not is_given(checker, name, written, count):
        return False
    if arguments[0].type.kind is not Kind.LIST:
        no_list = OtherKind(name, FORMS[name], "list", str(arguments[0].type))
        checker.report(no_list, arguments[0].span)
        return False
    return not is_empty(checker, arguments[0])


__all__ = ["CHANGES", "SEARCHES", "change", "element", "is_empty", "literal", "put", "searched", "size"]
