"""Timers: calls that are due at a moment; those of one moment in the order of their making."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from heapq import heapify, heappop, heappush
from typing import Protocol

from aseme_dsl.runtime.time.clock import Clock

_FEW = 64
"""So many cancelled timers may always wait for their moment."""


class Timer:
    """A call that is due at `moment`. A timer of the `background` keeps no run alive."""

    __slots__ = ("_timers", "background", "call", "moment")

    def __init__(self, timers: Timers, moment: int, call: Callable[[], None], background: bool) -> None:
        self._timers = timers
        self.moment = moment
        self.call: Callable[[], None] | None = call
        self.background = background

    def ring(self) -> None:
        """Make the call, unless it is cancelled; it is forgotten before, with all that it holds."""
        call, self.call = self.call, None
        if call is not None:
            call()

    def cancel(self) -> None:
        """Forget the call."""
        if self.call is not None:
            self.call = None
            self._timers.cancelled += 1


class Timers:
    """All timers of a run. Not for several threads at once, but that any may cancel a timer."""

    __slots__ = ("_heap", "_made", "cancelled")

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, Timer]] = []
        self._made = 0
        self.cancelled = 0
        """About how many of those that wait are cancelled."""

    def __len__(self) -> int:
        return len(self._heap)

    def add(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """A new timer."""
        heap = self._heap
        if self.cancelled > _FEW and self.cancelled > len(heap) // 2:
            # Most would have been due much later, and would fill the memory until then.
            self.cancelled = 0
            heap[:] = [item for item in heap if item[2].call is not None]
            heapify(heap)
        self._made += 1
        timer = Timer(self, moment, call, background)
        heappush(heap, (moment, self._made, timer))
        return timer

    def next(self) -> int | None:
        """The moment of the earliest timer, or None."""
        heap = self._heap
        while heap and heap[0][2].call is None:
            heappop(heap)
            self.cancelled -= 1
        return heap[0][0] if heap else None

    def take(self, now: int) -> Timer | None:
        """The earliest timer that is due by `now`, which is taken out, or None."""
        moment = self.next()
        return heappop(self._heap)[2] if moment is not None and moment <= now else None

    def only_background(self) -> bool:
        """Whether no timer waits but those of the background."""
        return all(timer.background or timer.call is None for _, _, timer in self._heap)


class Scheduler(Protocol):
    """The time of a run, and calls at moments of it, for all who need no more of a driver."""

    @property
    def clock(self) -> Clock:
        """The time of the run."""
        ...

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment; at once, if that has passed."""
        ...

    def holding(self) -> AbstractContextManager[object]:
        """Agents that are woken meanwhile step only afterwards: for who holds a lock."""
        ...
