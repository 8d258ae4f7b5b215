"""Source: a text (from disk or from an editor's buffer) and a span in it."""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import field

from aseme_dsl.records import dataclass

STANDARD_INPUT = "<stdin>"
"""The path by which people know what came from `-`."""

_NEWLINE = re.compile("\n")
_LIBRARY = "<stdlib>/"
"""Where files of the standard library are said to be: no folder of a user is called so."""


def library_path(name: str) -> str:
    """The path that people know a file of the standard library by, the same wherever it is installed."""
    return f"{_LIBRARY}{name}"


def without_column(place: str) -> str:
    """`file:line` of `file:line:column`."""
    return re.sub(r"(:\d+):\d+$", r"\1", place)


def is_library_path(path: str) -> bool:
    """Whether a path is that of a file of the standard library."""
    return path.startswith(_LIBRARY)


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """A text with the path that people know it by (`<stdin>`, an editor's buffer or a file)."""

    path: str
    text: str
    _line_starts: list[int] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        starts = [0, *(found.end() for found in _NEWLINE.finditer(self.text))]
        object.__setattr__(self, "_line_starts", starts)

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of `offset`, both counted from 1 in code points."""
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def line_start(self, number: int) -> int:
        """The offset at which line `number` (from 1) begins."""
        return self._line_starts[number - 1]

    def line(self, number: int) -> str:
        """The text of line `number` (from 1), without its line ending."""
        start = self._line_starts[number - 1]
        end = self._line_starts[number] if number < len(self._line_starts) else len(self.text)
        return self.text[start:end].rstrip("\r\n")


@dataclass(frozen=True, slots=True)
class Span:
    """The half-open range `start … end` of a source, in code points."""

    source: Source
    start: int
    end: int

    @property
    def line(self) -> int:
        return self.source.position(self.start)[0]

    @property
    def column(self) -> int:
        return self.source.position(self.start)[1]

    @property
    def text(self) -> str:
        return self.source.text[self.start : self.end]

    def to(self, other: Span) -> Span:
        """From the start of this span to the end of `other`, which is in the same source."""
        return Span(self.source, self.start, other.end)

    def __str__(self) -> str:
        line, column = self.source.position(self.start)
        return f"{self.source.path}:{line}:{column}"

    def __repr__(self) -> str:
        return f"<{self}>"
