"""Histories: the messages that are kept of a data channel, and what they say of a moment or span of time."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Reversible, Sequence
from functools import reduce
from operator import add
from typing import cast

from aseme_dsl.runtime.chart.inputs import Sample


class History:
    """The messages of a data channel, oldest first: those in a window of time, one of each sender before it.

    To add one costs the same however many there are; only for one that comes late a place is sought.
    """

    __slots__ = ("_before", "_newest", "_shown", "_window")

    def __init__(self, items: Iterable[Sample] = (), before: Iterable[Sample] = ()) -> None:
        """With these in the window, and one of some senders before it, oldest first."""
        self._window = deque(items)
        self._before = {item.sender: item for item in before}
        """Of each sender the newest that is older than the window, in the order of their times."""
        self._newest = {item.sender: item for item in self}
        self._shown: tuple[Sample, ...] | None = None

    def save(self) -> tuple[tuple[Sample, ...], tuple[Sample, ...]]:
        """Those before the window, and those in it."""
        return tuple(self._before.values()), tuple(self._window)

    def copy(self) -> History:
        """The same messages, to be added to apart."""
        made = History()
        made._window, made._before, made._newest = (
            self._window.copy(),
            self._before.copy(),
            self._newest.copy(),
        )
        made._shown = self._shown
        return made

    def add(self, item: Sample, oldest: int) -> None:
        """Add a message in its place in time; the window begins at `oldest`, which never goes back."""
        self._shown = None
        window, before = self._window, self._before
        while window and window[0].time < oldest:
            first = window.popleft()
            before.pop(first.sender, None)
            before[first.sender] = first
        moment, sender = item.time, item.sender
        newest = self._newest.get(sender)
        if newest is None or newest.time <= moment:
            self._newest[sender] = item
        if moment < oldest:
            known = before.get(sender)
            if known is None or known.time <= moment:
                before.pop(sender, None)
                later = [other for other in before.values() if other.time > moment]
                before[sender] = item
                for other in later:
                    before[other.sender] = before.pop(other.sender)
        elif not window or window[-1].time <= moment:
            window.append(item)
        else:
            place = len(window)
            while place and window[place - 1].time > moment:
                place -= 1
            window.insert(place, item)

    def newest(self, host: str | None = None) -> Sample | None:
        """The newest of all, or of a sender, or None."""
        if host is not None:
            return self._newest.get(host)
        return next(reversed(self), None)

    def of(self, host: str | None = None) -> tuple[Sample, ...]:
        """All that is kept, or what is of a sender."""
        if self._shown is None:
            self._shown = (*self._before.values(), *self._window)
        return self._shown if host is None else tuple(item for item in self._shown if item.sender == host)

    def __iter__(self) -> Iterator[Sample]:
        yield from self._before.values()
        yield from self._window

    def __reversed__(self) -> Iterator[Sample]:
        yield from reversed(self._window)
        yield from reversed(self._before.values())


def at(items: Reversible[Sample], moment: int) -> Sample | None:
    """The newest that was measured by then, or None."""
    return next((item for item in reversed(items) if item.time <= moment), None)


def since(items: Sequence[Sample], moment: int) -> tuple[Sample, ...]:
    """What was measured at that moment or later."""
    return tuple(item for item in items if item.time >= moment)


def mean(items: Sequence[Sample], moment: int, member: str) -> float | None:
    """The mean of a member (`pose.x`) over what was measured since then, or None.

    A message in which the member is absent does not count.
    """
    path = member.split(".")
    found = (value_of(item.message, path) for item in items if item.time >= moment)
    values = cast("list[float]", [value for value in found if value is not None])
    # `sum` adds floats differently from one version of Python to another
    return reduce(add, values) / len(values) if values else None


def interpolated(items: Sequence[Sample], moment: int, member: str) -> float | None:
    """A member (`pose.x`) at a moment, on the straight line between the measurements before and after.

    None before the first and after the last measurement in which the member is there. Raises TypeError for a
    member that is not a number.
    """
    path = member.split(".")
    before: tuple[int, float] | None = None
    for item in items:
        value = value_of(item.message, path)
        if value is None:
            continue
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise TypeError(f"{member} is not a number: {value!r}")
        if item.time == moment:
            return value
        if item.time > moment:
            if before is None:
                return None
            share = (moment - before[0]) / (item.time - before[0])
            return before[1] + share * (value - before[1])
        before = (item.time, value)
    return None


def value_of(message: object, path: Sequence[str]) -> object:
    """A member of a member …, or None where one on the way is absent."""
    for step in path:
        if message is None:
            return None
        message = getattr(message, step)
    return message
