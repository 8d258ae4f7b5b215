"""Carrying: where places in a text are after it has been edited, and where they were before."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable

from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Carry:
    """The one stretch in which a text differs from what it was; all around it is the same.

    It begins at `start`, and ends before `old_end` in the text that was, before `new_end` in the one that is.
    """

    start: int
    old_end: int
    new_end: int

    def back(self, offset: int) -> int:
        """Where the place was; for one inside of the stretch, a place in it."""
        if offset <= self.start:
            return offset
        if offset >= self.new_end:
            return offset - self.new_end + self.old_end
        return min(offset, self.old_end)

    def forward(self, offset: int) -> int:
        """Where the place is now; for one inside of the stretch, a place in it."""
        if offset <= self.start:
            return offset
        if offset >= self.old_end:
            return offset - self.old_end + self.new_end
        return min(offset, self.new_end)

    def span(self, span: Span, source: Source) -> Span:
        """A span of the text that was, in `source`, which has the text that is."""
        if span.start >= self.old_end:  # what is typed right before it does not belong to it
            shift = self.new_end - self.old_end
            return Span(source, span.start + shift, span.end + shift)
        return Span(source, self.forward(span.start), self.forward(span.end))


def carry(before: str, after: str) -> Carry:
    """What has changed from one text to the other; they are not the same."""
    shorter = min(len(before), len(after))
    start = _longest(shorter, lambda length: before[:length] == after[:length])
    rest = shorter - start
    same = _longest(rest, lambda length: before[len(before) - length :] == after[len(after) - length :])
    return Carry(start, len(before) - same, len(after) - same)


def _longest(most: int, is_same: Callable[[int], bool]) -> int:
    """The greatest length up to `most` for which two texts are the same, as for all that are less."""
    return bisect_left(range(1, most + 1), True, key=lambda length: not is_same(length))


__all__ = ["Carry", "carry"]
