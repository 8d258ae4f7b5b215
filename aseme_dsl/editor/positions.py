"""Positions: places as editors count them (lines from 0, UTF-16 units) and as we do (code points)."""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass

_END_OF_LINE = re.compile(r"\r\n|\n|\r")


@dataclass(frozen=True, slots=True, order=True)
class Position:
    """A place between two characters: the line from 0, and the UTF-16 units before it on the line."""

    line: int
    character: int


class Lines:
    """Where the lines of a text begin. As editors have it, `\\r` ends a line, too, alone or before `\\n`."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._narrow = text.isascii()
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
            units -= 2 if ord(self._text[offset]) > 0xFFFF else 1
            if units < 0:
                break  # between the halves of a character
            offset += 1
        return offset

    def position(self, offset: int) -> Position:
        """The place before which `offset` code points stand."""
        offset = max(0, min(offset, len(self._text)))
        line = bisect_right(self._starts, offset) - 1
        start = self._starts[line]
        if self._narrow:
            return Position(line, offset - start)
        wide = sum(1 for char in self._text[start:offset] if ord(char) > 0xFFFF)
        return Position(line, offset - start + wide)

    def line(self, number: int) -> tuple[int, int]:
        """Where line `number` (from 0) begins and ends, without its line ending."""
        end = self._ends[number][0] if number < len(self._ends) else len(self._text)
        return self._starts[number], end


__all__ = ["Lines", "Position"]
