"""Tokens: the names of a file with what they are, for colours that know more than a grammar can."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.editor.files.index import Kind, Occurrence, Use
from aseme_dsl.editor.files.positions import Lines
from aseme_dsl.editor.files.view import View
from aseme_dsl.records import dataclass

TYPES = (
    "namespace",
    "type",
    "class",
    "enum",
    "interface",
    "struct",
    "parameter",
    "variable",
    "property",
    "enumMember",
    "event",
    "function",
    "method",
    "keyword",
)
"""The types of tokens, as the protocol names them; a token has the index of one."""

MODIFIERS = ("declaration", "readonly", "modification", "defaultLibrary")

_TYPE_OF = {
    Kind.SYSTEM: "namespace",
    Kind.LIBRARY: "namespace",
    Kind.ENUM: "enum",
    Kind.CONSTANT: "enumMember",
    Kind.MESSAGE: "struct",
    Kind.FIELD: "property",
    Kind.TOPIC: "namespace",
    Kind.COMM: "keyword",
    Kind.TYPE: "type",
    Kind.FUNCTION: "function",
    Kind.PARAMETER: "parameter",
    Kind.LET: "variable",
    Kind.VARIABLE: "variable",
    Kind.TIMER: "variable",
    Kind.EVENT: "event",
    Kind.PERFORMATIVE: "keyword",
    Kind.USE_CASE: "interface",
    Kind.ROLE: "class",
    Kind.PROTOCOL: "interface",
    Kind.PARTICIPANT: "class",
    Kind.ALIAS: "class",
    Kind.FORMULA: "method",
    Kind.ACTIVITY: "function",
    Kind.OUTCOME: "enumMember",
    Kind.FUNCTIONALITY: "property",
    Kind.CAPABILITY: "property",
    Kind.STATE: "enumMember",
    Kind.TEAM: "namespace",
    Kind.AGENT: "variable",
}


_NUMBER = {kind: TYPES.index(name) for kind, name in _TYPE_OF.items()}


@dataclass(frozen=True, slots=True)
class Token:
    """A name of a file: where it begins, its length, and the numbers of its type and modifiers."""

    start: int
    end: int
    type: int
    modifiers: int


AT_ONCE = 1000
"""How many names are looked at in one piece: others want answers meanwhile."""


def tokens(view: View) -> InPieces[tuple[Token, ...]]:
    """The names of a file in the order of the text; none overlaps another."""
    found: list[Token] = []
    behind = 0
    for number, item in enumerate(view.occurrences):
        if number % AT_ONCE == AT_ONCE - 1:
            yield
        span = view.whole(item.span)
        if span.end > span.start >= behind:
            found.append(Token(span.start, span.end, _NUMBER[item.symbol.kind], _modifiers(item)))
            behind = span.end
    return tuple(found)


def _modifiers(item: Occurrence) -> int:
    bits = 0
    if item.use is Use.DECLARATION:
        bits |= 1
    if item.symbol.kind in (Kind.LET, Kind.CONSTANT, Kind.OUTCOME):
        bits |= 2
    if item.use is Use.WRITE:
        bits |= 4
    if item.symbol.kind is Kind.TYPE:
        bits |= 8
    return bits


def encoded(lines: Lines, found: Sequence[Token]) -> InPieces[list[int]]:
    """As the protocol wants them: five numbers each, places relative to the token before."""
    data: list[int] = []
    line = character = 0
    for number, item in enumerate(found):
        if number % AT_ONCE == AT_ONCE - 1:
            yield
        begin, end = lines.position(item.start), lines.position(item.end)
        if begin.line != end.line:
            continue
        if begin.line != line:
            character = 0
        data += (begin.line - line, begin.character - character, end.character - begin.character)
        data += (item.type, item.modifiers)
        line, character = begin.line, begin.character
    return data


def difference(before: Sequence[int], after: Sequence[int]) -> tuple[int, int, list[int]]:
    """What turns one list into the other: where to begin, how many to delete, and what to insert there."""
    start = 0
    shorter = min(len(before), len(after))
    while start < shorter and before[start] == after[start]:
        start += 1
    end = 0
    while end < shorter - start and before[-1 - end] == after[-1 - end]:
        end += 1
    return start, len(before) - start - end, list(after[start : len(after) - end])
