"""Pieces: a file as blocks of lines, each line as pieces, with the comments where they belong."""

from __future__ import annotations

import re
from dataclasses import field

from aseme_dsl.records import dataclass

GLUED = 1 << 30
"""The level of a place at which no line is broken."""


ORDER = re.compile(r"asemec\s*:")
"""What is in a comment that speaks to asemec: at the end of a line, about what begins on that line."""


@dataclass(slots=True)
class Piece:
    """A token, with what stands between it and the one before it.

    `level` says how tightly it is bound to the piece before it: where a line must be broken, that is done at
    the lowest levels first. `depth` counts the brackets and lists around it: what is broken off is aligned
    with the first piece of its depth.
    """

    text: str
    blanks: int = 1
    level: int = GLUED
    depth: int = 0
    column: int | None = None
    """The column of the table that begins here."""
    starts_line: bool = False
    """The author began a line with it."""
    above: tuple[str, ...] = ()
    """Comments that stand alone on the lines before it; they force a new line."""
    after: tuple[str, ...] = ()
    """Comments that end its line; they force a new line behind it."""
    loose: bool = False
    """Its cell may be longer than the column."""

    @property
    def is_hard(self) -> bool:
        """Whether it cannot stand in the middle of one line."""
        return bool(self.above) or bool(self.after) or "\n" in self.text


@dataclass(slots=True)
class Gap:
    """What stands between two tokens."""

    trailing: tuple[str, ...] = ()
    """Comments on the line of the token before."""
    hanging: tuple[str, ...] = ()
    """Comments on the next lines that begin in the same column, and so continue the trailing ones."""
    own: tuple[tuple[bool, str], ...] = ()
    """Comments on lines of their own, each with whether a blank line is before it."""
    leading: tuple[str, ...] = ()
    """Comments directly before the next token, on its line."""
    blank: bool = False
    """A blank line is before the next token's line."""
    newline: bool = False


@dataclass(slots=True)
class Row:
    """An entry that has no block: its pieces, the comments above it, and those at the end of its last line.

    The first comment in `trailing` is on that line; the others continue it on the lines below.
    """

    rule: str
    pieces: list[Piece] = field(default_factory=list)
    above: tuple[tuple[bool, str], ...] = ()
    blank: bool = False
    trailing: list[str] = field(default_factory=list)


@dataclass(slots=True)
class Block:
    """An entry with braces; `header` are the pieces before its `{`, which is the last of them."""

    rule: str
    header: Row
    entries: list[Row | Block] = field(default_factory=list)
    after_open: list[str] = field(default_factory=list)
    """Comments at the end of the line of its `{`."""
    before_close: tuple[tuple[bool, str], ...] = ()
    inside_empty: tuple[str, ...] = ()
    """Comments before the `}` on its line, with no new line before them."""
    one_line: bool = False
    """The author went on behind its `{` on the same line."""

    @property
    def above(self) -> tuple[tuple[bool, str], ...]:
        return self.header.above

    @property
    def blank(self) -> bool:
        return self.header.blank

    @property
    def trailing(self) -> list[str]:
        return self.header.trailing
