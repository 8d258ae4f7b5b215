"""Positions: places as editors count them (lines from 0, UTF-16 units) and as we do (code points)."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable

from aseme_dsl.records import dataclass

_END_OF_LINE = re.compile(r"\r\n|\n|\r")

_WIDTHS: dict[str, Callable[[str], int]] = {
    "utf-8": lambda char: len(char.encode("utf-8", "surrogatepass")),
    "utf-16": lambda char: 2 if ord(char) > 0xFFFF else 1,
    "utf-32": lambda char: 1,
}
"""What a character counts, by the encoding that editor and server have agreed on."""


@dataclass(frozen=True, slots=True, order=True)
class Position:
    """A place between two characters: the line from 0, and the units before it on the line."""

    line: int
    character: int


class Lines:
    """Where the lines of a text begin. As editors have it, `\\r` ends a line, too, alone or before `\\n`."""

    def __init__(self, text: str, encoding: str = "utf-16") -> None:
        self._text = text
        self._narrow = text.isascii() or encoding == "utf-32"
        self._width = _WIDTHS[encoding]
        self._ends = [found.span() for found in _END_OF_LINE.finditer(text)]
        self._starts = [0, *(end for _, end in self._ends)]

    @property
    def count(self) -> int:
        """How many lines there are; an empty text has one."""
        return len(self._starts)

    def offset(self, position: Position) -> int:
        """The code points before `position`; beyond the end of its line or of the text, before that end."""
        if position.line < 0:
            return 0
        if position.line >= len(self._starts):
            return len(self._text)
        start, end = self.line(position.line)
        units = max(position.character, 0)
        if self._narrow:
            return min(start + units, end)
        offset = start
        while offset < end and units > 0:
            units -= self._width(self._text[offset])
            if units < 0:
                break  # inside a character
            offset += 1
        return offset

    def position(self, offset: int) -> Position:
        """The place before which `offset` code points stand."""
        offset = max(0, min(offset, len(self._text)))
        line = bisect_right(self._starts, offset) - 1
        start = self._starts[line]
        if self._narrow:
            return Position(line, offset - start)
        return Position(line, sum(map(self._width, self._text[start:offset])))

    def line(self, number: int) -> tuple[int, int]:
        """Where line `number` (from 0) begins and ends, without its line ending."""
        end = self._ends[number][0] if number < len(self._ends) else len(self._text)
        return self._starts[number], end


@dataclass(frozen=True, slots=True)
class Change:
    """A change of a text as an editor tells it; without a range, the text is all of the new one."""

    text: str
    start: Position | None = None
    end: Position | None = None


def changed(text: str, changes: tuple[Change, ...], encoding: str = "utf-16") -> str:
    """A text after changes, each of which counts in the text that the one before it has left."""
    for change in changes:
        if change.start is None or change.end is None:
            text = change.text
            continue
        lines = Lines(text, encoding)
        start, end = lines.offset(change.start), lines.offset(change.end)
        text = text[:start] + change.text + text[max(start, end) :]
    return text


__all__ = ["Change", "Lines", "Position", "changed"]
