"""Progress: what the parser of one text knows; and what is used of Arpeggio, which has no types itself.

A parser is made of parsing expressions, and makes of a text a tree of nodes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import field
from typing import Protocol

from aseme_dsl.grammar.parsing.nodes import Node
from aseme_dsl.grammar.text.lexer import Lexed
from aseme_dsl.grammar.text.recovery import is_stray_brace
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.records import dataclass


class GrammarRule(Protocol):
    """A rule as `rules.Rule` has it."""

    @property
    def kind(self) -> str: ...
    @property
    def attributes(self) -> dict[str, str]: ...


class Parsed(Node):
    """What was read by a rule; each rule has a class of its own, of the rule's name."""

    rule: GrammarRule


class ParsingExpression(Protocol):
    """A part of the grammar. Which members it has besides its name depends on its class."""

    rule_name: str
    root: bool
    suppress: bool
    nodes: list[ParsingExpression]
    sep: ParsingExpression | None
    to_match: str
    to_match_regex: str
    regex: re.Pattern[str]
    kind: type[Parsed]
    _attr_name: str
    _parse: Callable[[TextParser], object]
    parse: Callable[[TextParser], object]

    def compile(self) -> None: ...


class TextParser(Protocol):
    """A parser in the middle of a text."""

    input: str
    position: int
    progress: Progress


class ParseNode(Protocol):
    """A node of the parse tree; one without nodes inside is a terminal and has a `value`."""

    rule: ParsingExpression
    rule_name: str
    position: int
    position_end: int
    value: Token

    def __iter__(self) -> Iterator[ParseNode]: ...
    def __getitem__(self, index: int, /) -> ParseNode: ...
    def __len__(self) -> int: ...


@dataclass(frozen=True, slots=True)
class Mistake:
    """Where the text was left and taken up again, and what would have been right at `place`."""

    kind: str  # the name of the Junk terminal
    start: int
    end: int
    place: int
    expected: tuple[ParsingExpression, ...]  # terminals, in the order in which they were tried
    opener: int | None  # where the block was opened


@dataclass
class Progress:
    """What the parser of one text knows beyond textX's."""

    lexed: Lexed
    farthest: int = -1
    expected: list[ParsingExpression] = field(default_factory=list)
    blank_from: int = -1
    blank_to: int = -1
    quiet_before: int = -1
    openers: list[int] = field(default_factory=list)
    mistakes: list[Mistake] = field(default_factory=list)

    def fail(self, rule: ParsingExpression, position: int) -> None:
        """Remember that `rule` has not matched at `position`."""
        if position > self.farthest:
            self.farthest = position
            self.expected = [rule]
        elif position == self.farthest:
            self.expected.append(rule)

    def is_stray(self, brace: int) -> bool:
        """Whether the `}` at `brace` is too much: see `is_stray_brace`."""
        text = self.lexed.text
        opener = self.openers[-1] if self.openers else 0
        line = text.rfind("\n", 0, brace) + 1
        if line <= opener or not text[line:brace].strip():
            return False
        return is_stray_brace(self.lexed.tokens, self.lexed.tokens.at(brace))

    def note(
        self, kind: str, start: int, end: int, place: int, expected: tuple[ParsingExpression, ...]
    ) -> None:
        """Remember a mistake, unless nothing has been understood since the last one."""
        tokens = self.lexed.tokens
        if tokens.at(place) != self.quiet_before:
            opener = self.openers[-1] if self.openers else None
            self.mistakes.append(Mistake(kind, start, end, place, expected, opener))
        self.quiet_before = tokens.at(end)
        self.farthest = -1
