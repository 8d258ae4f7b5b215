"""Stamps: moments in a team that is explored with times.

Such a team stands still, at one number (`NOW`). A stamp is a moment that was read from its clock, or
calculated from one: a number like any other, which knows the move in which the clock was read.
"""

from __future__ import annotations

from aseme_dsl.records import dataclass


class Stamp(int):
    """A moment: `offset` ns after the move `origin`. As a number, it is where the team takes it to be."""

    origin: int
    offset: int

    def __add__(self, duration: int) -> Stamp:
        return stamp(int(self) + duration, self.origin, self.offset + duration)

    __radd__ = __add__

    def __sub__(self, other: int) -> int:
        """The time between two moments, as a number; an earlier moment if `other` is a duration."""
        if isinstance(other, Stamp):
            return int(self) - int(other)
        return stamp(int(self) - other, self.origin, self.offset - other)

    def __reduce__(self) -> tuple[object, ...]:
        return stamp, (int(self), self.origin, self.offset)


def stamp(value: int, origin: int, offset: int = 0) -> Stamp:
    """A moment that stands at a number."""
    made = Stamp(value)
    made.origin, made.offset = origin, offset
    return made


def standing(moment: int, value: int) -> int:
    """The same moment, standing at another number."""
    return stamp(value, moment.origin, moment.offset) if isinstance(moment, Stamp) else value


@dataclass(frozen=True, slots=True)
class Window:
    """From `low` to `high` ns after the move `origin`; `high` is None where there is no end."""

    origin: int
    low: int
    high: int | None


@dataclass(frozen=True, slots=True)
class Mark:
    """A moment from which something is counted: `offset` ns after the move `origin`."""

    name: str
    origin: int
    offset: int


def marked(name: str, since: int) -> Mark | None:
    """A moment as a mark; None if it is not known when that was."""
    return Mark(name, since.origin, since.offset) if isinstance(since, Stamp) else None


def window(since: int, low: int, high: int | None) -> Window | None:
    """So long after a moment; None if it is not known when that was."""
    if not isinstance(since, Stamp):
        return None
    return Window(since.origin, since.offset + low, None if high is None else since.offset + high)


__all__ = ["Mark", "Stamp", "Window", "marked", "stamp", "standing", "window"]
