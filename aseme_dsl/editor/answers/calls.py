"""Calls: which formulas use which formulas and activities, as an editor's call hierarchy."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.editor.files.index import Kind, Occurrence, Symbol, Use
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_CALLED = (Kind.FORMULA, Kind.ACTIVITY, Kind.PARTICIPANT, Kind.ALIAS)


@dataclass(frozen=True, slots=True)
class Caller:
    """A formula, activity or participant in the hierarchy: all of it and its name (whole), in a file."""

    symbol: Symbol
    path: str
    span: Span
    name_span: Span


@dataclass(frozen=True, slots=True)
class Call:
    """Who uses, or is used; and where the names stand, in the file of the user."""

    other: Caller
    places: tuple[Span, ...]


def prepared(view: View, offset: int) -> Caller | None:
    """What the hierarchy begins with at `offset`."""
    found = view.occurrence_at(offset)
    if found is None or found.symbol.kind not in _CALLED:
        return None
    return caller(view.program, found.symbol)


def caller(program: Program, symbol: Symbol) -> Caller | None:
    """Where something is declared; an activity that nothing describes, where it is used first."""
    found = program.index.declarations(symbol) or program.index.of(symbol)[:1]
    for item in found:
        span = program.whole(item.span)
        node = getattr(item.node, "span", item.span)
        declared = item.use is Use.DECLARATION
        return Caller(symbol, program.path_of(span.source), program.whole(node) if declared else span, span)
    return None


def incoming(program: Program, symbol: Symbol) -> tuple[Call, ...]:
    """The formulas in which something stands."""
    found: dict[Symbol, list[Span]] = {}
    for item in program.index.of(symbol):
        if isinstance(item.node, tree.NamedFormula) and item.use is Use.READ:
            user = _formula_around(program, item)
            if user is not None:
                found.setdefault(user, []).append(program.whole(item.span))
    return tuple(_calls(program, found))


def outgoing(program: Program, symbol: Symbol) -> tuple[Call, ...]:
    """What stands in a formula, or in the process of a participant."""
    if symbol.kind is Kind.PARTICIPANT:
        symbol = Symbol(Kind.FORMULA, "process", f"{symbol.owner}.{symbol.name}")
    if symbol.kind is Kind.ALIAS:
        for item in program.index.declarations(symbol):
            if isinstance(item.node, tree.Plays):
                owner = f"{item.node.protocol}.{item.node.participant}"
                symbol = Symbol(Kind.FORMULA, "process", owner)
    found: dict[Symbol, list[Span]] = {}
    for item in program.index.declarations(symbol):
        if not isinstance(item.node, tree.NamedFormula):
            continue
        for other in program.index.part(item.span.source):
            if other.node is item.node and other.use is Use.READ:
                found.setdefault(other.symbol, []).append(program.whole(other.span))
    return tuple(_calls(program, found))


def _calls(program: Program, found: dict[Symbol, list[Span]]) -> Iterator[Call]:
    for symbol, places in found.items():
        other = caller(program, symbol)
        if other is not None:
            yield Call(other, tuple(places))


def _formula_around(program: Program, item: Occurrence) -> Symbol | None:
    for other in program.index.part(item.span.source):
        if other.node is item.node and other.use is Use.DECLARATION:
            return other.symbol
    return None
