"""Reader: the tokens of an expression, where one is, and what can be wrong there."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TypeVar

from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import formulas as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.grammar.formulas.words import RESERVED, Malformed, is_hyphen
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.runtime.time.clock import UNITS
from aseme_dsl.source import Source, Span

DEEPEST = 100
"""How many operators, calls and parentheses may stand one in the other."""

_MEANT = {"&": "&&", "|": "||", "=": "==", "and": "&&", "or": "||", "^": None, "?": None}
"""Operators of other languages, with what they mean."""

_SEGMENT = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_DIGITS = re.compile(r"[0-9]+\b")

Made = TypeVar("Made", bound=tree.Expression)


class Reader:
    """Goes through tokens; `index` is the next one."""

    def __init__(self, source: Source, tokens: Sequence[Token]) -> None:
        self.source = source
        self.tokens = tokens
        self.index = 0
        self.depth = 0
        self.heights: dict[int, int] = {}

    @property
    def next(self) -> str:
        return self.tokens[self.index] if self.index < len(self.tokens) else ""

    def take(self) -> Token:
        taken = self.tokens[self.index]
        self.index += 1
        return taken

    def need(self, text: str, opener: Token | None = None) -> Token:
        if self.next == text:
            return self.take()
        if opener is not None and self.index == len(self.tokens):
            raise self.unexpected(text, related=(self.still_open(opener),))
        raise self.unexpected(Wanted.OPERATOR, text, related=(self.still_open(opener),) if opener else ())

    def need_name(self, wanted: Wanted) -> tree.Name:
        if self.index == len(self.tokens) or not is_word(self.next) or self.next in RESERVED:
            raise self.unexpected(wanted)
        taken = self.tokens[self.index]
        if "." in taken:
            raise self.error(problems.UnexpectedInExpression((wanted,), None, taken), taken)
        self.index += 1
        return tree.Name(str(taken), self.span(taken))

    def span(self, text: Token) -> Span:
        return Span(self.source, text.start, text.end)

    def path(self, text: Token) -> tree.Path:
        """A dotted name that the grammar has recognised."""
        segments = tuple(
            tree.Name(found.group(), Span(self.source, text.start + found.start(), text.start + found.end()))
            for found in _SEGMENT.finditer(text)
        )
        return tree.Path(segments, self.span(text))

    def since(self, start: int) -> Span:
        return Span(self.source, start, self.tokens[self.index - 1].end)

    def grown(self, made: Made, *parts: tree.Expression) -> Made:
        """`made` of `parts`, with its height remembered and bounded."""
        height = 1 + max((self.heights.pop(id(part), 0) for part in parts), default=0)
        if height > DEEPEST:
            raise Malformed(self._deep(made.span))
        self.heights[id(made)] = height
        return made

    def error(
        self,
        problem: Problem,
        at: Token,
        fix: str | None = None,
        related: tuple[Related, ...] = (),
        edits: tuple[Edit, ...] = (),
    ) -> Malformed:
        return Malformed(Diagnostic(problem, self.span(at), related, fix, edits=edits))

    def unexpected(self, *wanted: Wanted | str, related: tuple[Related, ...] = ()) -> Malformed:
        """Something else stands here than one of `wanted`, of which strings are words of the language."""
        if Wanted.VALUE in wanted and (counted := self._counted_up()) is not None:
            return counted
        if self.index == len(self.tokens):
            last = self.tokens[-1]
            return self.error(problems.UnexpectedInExpression(wanted, last, None), last, related=related)
        found = self.tokens[self.index]
        previous = self.tokens[self.index - 1] if self.index else None
        if previous is None:
            kind = problems.ReservedWord if found in RESERVED else problems.UnexpectedInExpression
            return self.error(kind(wanted, None, found), found, related=related)
        problem, fix = self._unexpected_after(previous, found, wanted)
        return self.error(problem, found, fix, related)

    def _counted_up(self) -> Malformed | None:
        """`n++` and `n--` of other languages, where the next token should be a value."""
        if self.index < 3:
            return None
        name, first, second = self.tokens[self.index - 3 : self.index]
        if first != second or first not in ("+", "-") or first.end != second.start or not is_word(name):
            return None
        span = Span(self.source, name.start, second.end)
        problem = problems.CountedUp(name, first)
        return Malformed(Diagnostic(problem, span, fix=f"{name} {first}= 1"))

    def _unexpected_after(
        self, previous: Token, found: Token, wanted: tuple[Wanted | str, ...]
    ) -> tuple[Problem, str | None]:
        """What may be meant by the next token, and what to write instead."""
        following = self.tokens[self.index + 1] if self.index + 1 < len(self.tokens) else None
        digits = _DIGITS.match(self.source.text, found.end)
        if found == "." and digits is not None and Wanted.VALUE in wanted:
            return problems.NumberWithoutNought(wanted, previous, found, number=f"0.{digits[0]}"), "0."
        if found in ("+=", "-=", "*=") and "]" in wanted:
            return problems.ChangeInCondition(wanted, previous, found), None
        if found == "=" and (following in ("<", ">") or previous in ("<", ">", "==", "!=")):
            return problems.ComparisonOfOthers(wanted, previous, found), None
        if found == "=" and ")" in wanted and self._names_member():
            return problems.MessageLikeCall(wanted, previous, found), None
        if previous == "after" and found[:1].isdigit():
            return problems.AfterWithoutParentheses(wanted, previous, found), None
        if found == "or" and previous == "]":
            return problems.ConditionOfOneEvent(wanted, previous, found), None
        if found in RESERVED:
            return problems.ReservedWord(wanted, previous, found), None
        if found == "-" and following is not None and is_hyphen(previous, found, following):
            return problems.HyphenInOperandName(wanted, previous, found, rest=following), "_"
        if found in UNITS and previous[0].isdigit():
            return problems.BlankBeforeUnitOfEvent(wanted, previous, found), None
        name = re.compile(r"\s+([A-Za-z_]\w*)").match(self.source.text, found.end)
        if found in BUILT_IN and name is not None:
            return problems.TypeBeforeName(wanted, previous, found, name=name[1]), None
        if found.lower() in _MEANT:
            return problems.OperatorOfOtherLanguages(wanted, previous, found), _MEANT[found.lower()]
        return problems.UnexpectedInExpression(wanted, previous, found), None

    def _names_member(self) -> bool:
        """Whether `Order(id` is before the next token, of which a message may be meant."""
        words = self.tokens[max(self.index - 3, 0) : self.index]
        return len(words) == 3 and words[0][0].isupper() and words[1] == "(" and is_word(words[2])

    def still_open(self, opener: Token) -> Related:
        return Related(self.span(opener), f"this '{opener}' is still open")

    def too_deep(self, at: Token) -> Malformed:
        return Malformed(self._deep(self.span(at)))

    def _deep(self, span: Span) -> Diagnostic:
        return Diagnostic(characters.ExpressionTooDeep(DEEPEST), span)


def is_word(text: str) -> bool:
    """Whether a token is a word, dotted or not."""
    return text[:1].isalpha() or text[:1] == "_"
