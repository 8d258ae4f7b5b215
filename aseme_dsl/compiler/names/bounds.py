"""Bounds of variables: `var n : int 0..10`, and the constants that are outside of them."""

from __future__ import annotations

from aseme_dsl.amola.expression import Literal, Value, VariableValue
from aseme_dsl.amola.messages import AGENT, DOUBLE, INT, Bounds, Type, list_of
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.expressions import bounds as problems
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def bounds_of(
    written: tree.Var, kind: Type, initial: Literal
) -> tuple[Bounds | None, tuple[Diagnostic, ...]]:
    """The bounds of a variable of this type, in which its first value is (E516, E518)."""
    said = written.bounds
    if said is None:
        return None, ()
    if kind not in (INT, DOUBLE):
        return None, (Diagnostic(problems.BoundsOfOther(str(kind)), said.span),)
    if kind == INT and not (isinstance(said.least, int) and isinstance(said.most, int)):
        return None, (Diagnostic(problems.FractionAsBound(written.name.text), said.span),)
    found = Bounds(said.least, said.most) if kind == INT else Bounds(float(said.least), float(said.most))
    if found.least > found.most:
        turned = f"{said.most}..{said.least}"
        return None, (Diagnostic(problems.BoundsReversed(str(found), turned), said.span, fix=turned),)
    if not found.hold(initial.value):
        place = said.span if written.initial is None else written.initial.span
        given = written.initial is not None
        return None, (_outside(written.name.text, initial.value, found, place, given),)
    return found, ()


LENGTH = 1000
"""How many elements a list has at most, where nothing is said."""
LONGEST = 100_000


def list_variable(written: tree.Var, element: Type) -> tuple[Type, int, tuple[Diagnostic, ...]]:
    """The type of a variable that is a list, how long it may be, and what is wrong."""
    kind = list_of(element)
    found: list[Diagnostic] = []
    if element == AGENT:
        found.append(Diagnostic(problems.ListOfAgents(), written.type.span))
    length = LENGTH if written.length is None else int(written.length.value)
    if not 1 <= length <= LONGEST and written.length is not None:
        found.append(Diagnostic(problems.LengthOfList(length, LONGEST), written.length.span))
    if written.bounds is not None:
        found.append(
            Diagnostic(problems.BoundsOfElements(written.name.text, str(element)), written.bounds.span)
        )
    initial = written.initial
    if initial is not None and not (isinstance(initial, tree.List) and not initial.elements):
        found.append(Diagnostic(problems.ListNotEmpty(written.name.text), initial.span))
    return kind, length, tuple(found)


def stays_inside(checker: Checker, target: VariableValue, value: Value) -> bool:
    """Whether what is assigned is not a constant outside of the bounds of the variable (E516)."""
    if target.bounds is None:
        return True
    try:
        constant = fold(value)
    except (NotConstant, ArithmeticError):
        return True
    if target.bounds.hold(constant):
        return True
    checker.diagnostics.append(_outside(target.name, constant, target.bounds, value.span))
    return False


def outside(name: str, bounds: Bounds | None, literal: Literal) -> Diagnostic | None:
    """What is wrong with a value that an agent is given (E516)."""
    if bounds is None or bounds.hold(literal.value):
        return None
    return _outside(name, literal.value, bounds, literal.span)


def _outside(name: str, value: object, bounds: Bounds, place: Span, given: bool = True) -> Diagnostic:
    least = str(bounds.least)
    return Diagnostic(problems.OutsideBounds(name, str(value), str(bounds), least, given), place)


__all__ = ["bounds_of", "list_variable", "outside", "stays_inside"]
