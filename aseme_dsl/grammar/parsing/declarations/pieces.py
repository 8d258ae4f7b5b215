"""Pieces: names, numbers, texts and places, of which declarations are made; and what is wrong in them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TypeGuard, TypeVar, cast

from aseme_dsl.diagnostics import Diagnostic, Problem, Related
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.formulas.expression import read_duration, read_text
from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES, RESERVED, Malformed
from aseme_dsl.grammar.parsing.nodes import Node
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source, Span

_T = TypeVar("_T")
_N = TypeVar("_N", bound=Node)

_LONGEST_INTEGER = 18


class Pieces:
    """Makes pieces of one file, and collects what is wrong."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.diagnostics: list[Diagnostic] = []

    def all(self, make: Callable[[Pieces, _N], _T | None], nodes: Iterable[_N | Token]) -> tuple[_T, ...]:
        """What `make` makes of the nodes; junk, and what it cannot make, is left out."""
        made = (make(self, node) for node in nodes if not isinstance(node, str))
        return tuple(item for item in made if item is not None)

    def span(self, node: Node) -> Span:
        return Span(self.source, node._tx_position, node._tx_position_end)

    def spot(self, text: Token) -> Span:
        return Span(self.source, text.start, text.end)

    def name(self, text: Token) -> tree.Name:
        """A name that is used."""
        return tree.Name(str(text), Span(self.source, text.start, text.start + len(text)))

    def new_name(self, text: Token, kind: str, words: Sequence[str] = ()) -> tree.Name:
        """A name that is declared, and is none of the words of its block nor of those that no name can be."""
        return self.checked_name(text, kind, (*RESERVED, *BUILT_IN_TYPES, *words))

    def checked_name(self, text: Token, kind: str, words: Sequence[str]) -> tree.Name:
        """A name that is declared, and is none of `words`; the compiler refuses what no name can be."""
        made = self.name(text)
        if text in words:
            self.report(characters.WordAsName(made.text, kind, text in BUILT_IN_TYPES), made.span)
        return made

    def names(self, texts: Iterable[Token]) -> tuple[tree.Name, ...]:
        return tuple(self.name(text) for text in texts)

    def integer(self, text: Token) -> int | None:
        digits = text.replace(" ", "")
        if len(digits) > _LONGEST_INTEGER:
            self.report(characters.TooManyDigits(str(text)), self.spot(text))
            return None
        return int("".join(text.split()))

    def integer_number(self, text: Token) -> tree.Number | None:
        value = self.integer(text)
        return tree.Number(value, self.spot(text)) if value is not None else None

    def signed(self, text: Token) -> int | float | None:
        """A number with or without a sign and a fraction."""
        if "." not in text:
            return self.integer(text)
        number = "".join(text.split())
        if len(number) > _LONGEST_INTEGER:
            self.report(characters.TooManyDigits(str(text)), self.spot(text))
            return None
        return float(number)

    def tried(self, make: Callable[[], _T]) -> _T | None:
        try:
            return make()
        except Malformed as malformed:
            self.diagnostics.append(malformed.diagnostic)
            return None

    def text(self, text: Token) -> tree.Text:
        return read_text(self.source, text)

    def duration(self, text: Token) -> tree.Duration | None:
        return self.tried(lambda: read_duration(self.source, text))

    def again(self, clause: str | None, first: Span, second: Span) -> None:
        """E114 for a clause that begins with the same word as one before it; a requirement has no word."""
        self.report(problems.SaidTwice(clause), second, (Related(first, "first said here"),))

    def report(
        self, problem: Problem, span: Span, related: tuple[Related, ...] = (), fix: str | None = None
    ) -> None:
        self.diagnostics.append(Diagnostic(problem, span, related, fix))


class Once:
    """Reports what is said twice in one entry."""

    def __init__(self, pieces: Pieces) -> None:
        self.pieces = pieces
        self.said: dict[str | None, Span] = {}

    def check(self, clause: str | None, span: Span) -> None:
        first = self.said.setdefault(clause, span)
        if first is not span:
            self.pieces.again(clause, first, span)


def is_a(node: Node, kind: type[_N]) -> TypeGuard[_N]:
    """Whether an object is of a rule of the grammar: textX has classes of its own, of the same names."""
    return type(node).__name__ == kind.__name__


class Kinds:
    """The entries of a block by the rule of the grammar that they are of."""

    def __init__(self, entries: Iterable[Node | Token]) -> None:
        self._found: dict[str, list[Node]] = {}
        for entry in entries:
            if not isinstance(entry, str):
                self._found.setdefault(type(entry).__name__, []).append(entry)

    def of(self, kind: type[_N]) -> list[_N]:
        """Those of a rule."""
        return cast("list[_N]", self._found.get(kind.__name__, []))
