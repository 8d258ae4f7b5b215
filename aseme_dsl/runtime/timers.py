"""Timers: calls that are due at a moment; those of one moment in the order of their making."""

from __future__ import annotations

from collections.abc import Callable
from heapq import heappop, heappush


class Timer:
    """A call that is due at `moment`. A timer of the `background` keeps no run alive."""

    __slots__ = ("background", "call", "moment")

    def __init__(self, moment: int, call: Callable[[], None], background: bool) -> None:
        self.moment = moment
        self.call: Callable[[], None] | None = call
        self.background = background

    def cancel(self) -> None:
        """Forget the call."""
        self.call = None


class Timers:
    """All timers of a run. Not for several threads at once."""

    __slots__ = ("_heap", "_made")

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, Timer]] = []
        self._made = 0

    def add(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """A new timer."""
        self._made += 1
        timer = Timer(moment, call, background)
        heappush(self._heap, (moment, self._made, timer))
        return timer

    def next(self) -> int | None:
        """The moment of the earliest timer, or None."""
        heap = self._heap
        while heap and heap[0][2].call is None:
            heappop(heap)
        return heap[0][0] if heap else None

    def take(self, now: int) -> Timer | None:
        """The earliest timer that is due by `now`, which is taken out, or None."""
        moment = self.next()
        return heappop(self._heap)[2] if moment is not None and moment <= now else None

    def only_background(self) -> bool:
        """Whether no timer waits but those of the background."""
        return all(timer.background or timer.call is None for _, _, timer in self._heap)
