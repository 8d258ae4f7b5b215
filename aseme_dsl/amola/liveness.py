"""Liveness formulas: the Gaia operators over activities, as an immutable tree.

Formulas may be nested hundreds deep, so nothing here recurses and trees are compared by their canonical
spelling, never by `==`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TypeVar, assert_never

from aseme_dsl.amola.operators import Fixity, Operator, with_number
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_T = TypeVar("_T")


@dataclass(frozen=True, slots=True)
class Argument:
    """What an activity or formula is given: as canonical text, and (`value`) as the grammar's expression."""

    text: str
    value: object
    span: Span


@dataclass(frozen=True, slots=True, eq=False)
class Formula:
    """An operator over operands; a NAME has `name` and may have `arguments`, a counted one has `count`.

    Infix operators have two or more operands, all others but NAME have exactly one. DISABLING has two, and
    `A [> B [> C` is `(A [> B) [> C` without its parentheses. HOLE is an operator that is still to be chosen;
    no model has one. GROUP keeps the parentheses of the source, because terms and states are named as they
    are written. Several pairs around the same operand count as one.
    """

    operator: Operator
    operands: tuple[Formula, ...]
    span: Span
    name: str = ""
    count: int = 0
    arguments: tuple[Argument, ...] = ()

    def __repr__(self) -> str:
        return f"<formula {canonical(self)}>"


def walk(formula: Formula) -> Iterator[Formula]:
    """The formula and everything in it, from left to right, each before its operands."""
    stack = [formula]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(node.operands))


def fold(formula: Formula, combine: Callable[[Formula, Sequence[_T]], _T]) -> _T:
    """The value of a formula whose nodes' values follow from those of their operands."""
    values: dict[Formula, _T] = {}
    for node in reversed(list(walk(formula))):
        values[node] = combine(node, [values[operand] for operand in node.operands])
    return values[formula]


def rewritten(formula: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """The formula with each node changed, operands first; what does not change is the same object."""

    def combine(node: Formula, operands: Sequence[Formula]) -> Formula:
        is_same = all(before is after for before, after in zip(node.operands, operands, strict=True))
        return change(node if is_same else replace(node, operands=tuple(operands)))

    return fold(formula, combine)


def names(formula: Formula) -> Iterator[Formula]:
    """The NAME nodes of the formula from left to right."""
    return (node for node in walk(formula) if node.operator is Operator.NAME)


def ungrouped(formula: Formula) -> Formula:
    """The formula without the parentheses around it."""
    while formula.operator is Operator.GROUP:
        formula = formula.operands[0]
    return formula


def called(name: str, arguments: Iterable[str]) -> str:
    """A name with what it is given: `MoveTo(Place.TRAY, 2)`, or only the name."""
    given = ", ".join(arguments)
    return f"{name}({given})" if given else name


def canonical(formula: Formula, longest: int | None = None) -> str:
    """The formula in canonical spelling: blanks around infix operators, none elsewhere.

    With `longest` only its beginning, if it is longer: at least one character more than that.
    """
    parts: list[str] = []
    stack: list[Formula | str] = [formula]
    length = 0
    while stack and (longest is None or length <= longest):
        item = stack.pop()
        if isinstance(item, str):
            parts.append(item)
            length += len(item)
            continue
        sign, row = item.operator.value, item.operator.row
        match row.fixity:
            case Fixity.OPERAND:
                stack.append(called(item.name, (argument.text for argument in item.arguments)))
            case Fixity.BRACKET:
                opening, closing = sign.split()
                stack += [closing, item.operands[0], opening]
            case Fixity.POSTFIX:
                stack += [with_number(sign, item.count) if row.counted else sign, item.operands[0]]
            case Fixity.INFIX:
                for index in range(len(item.operands) - 1, -1, -1):
                    stack.append(item.operands[index])
                    if index:
                        stack.append(f" {sign} ")
            case _:
                assert_never(row.fixity)
    return "".join(parts)


def term_key(formula: Formula) -> str:
    """The spelling by which `control` finds a term: canonical, without outer parentheses."""
    return canonical(ungrouped(formula))
