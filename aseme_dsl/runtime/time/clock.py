"""Clocks: what time it is in a run, in nanoseconds since the run began."""

from __future__ import annotations

import time
from typing import Protocol

SECOND = 1_000_000_000
MILLISECOND = 1_000_000
UNITS = {"ms": MILLISECOND, "s": SECOND, "min": 60 * SECOND}
"""The units in which people write durations, in ns."""

USUAL_LENGTH = 60 * SECOND
"""How long a run in virtual time is if nothing says when it ends."""


class Clock(Protocol):
    """The time of a run. It never goes back."""

    @property
    def virtual(self) -> bool:
        """Whether time passes only when nothing is left to do."""
        ...

    def now(self) -> int:
        """The time in ns since the run began."""
        ...


class RealClock:
    """The machine's monotonic clock; it begins when it is made, or at `origin` of that clock (ns)."""

    __slots__ = ("origin",)

    virtual = False

    def __init__(self, origin: int | None = None) -> None:
        self.origin = time.monotonic_ns() if origin is None else origin

    def now(self) -> int:
        """The time in ns since the clock began."""
        return time.monotonic_ns() - self.origin


class VirtualClock:
    """A clock that stands still until its driver sets it to the next moment at which something is due."""

    __slots__ = ("_now",)

    virtual = True

    def __init__(self) -> None:
        self._now = 0

    def now(self) -> int:
        """The time in ns to which the clock has jumped."""
        return self._now

    def jump(self, moment: int) -> None:
        """Make it `moment`. Raises ValueError for a moment that has passed."""
        if moment < self._now:
            raise ValueError(f"{moment} ns has passed: it is {self._now} ns")
        self._now = moment


def nanoseconds(seconds: float) -> int:
    """A duration as people write it in Python, rounded to whole ns. Raises ValueError if it means nothing."""
    if not 0 <= seconds < 1e9:
        raise ValueError(f"a duration in seconds is wanted, not {seconds}")
    return round(seconds * SECOND)


def shown(moment: int) -> str:
    """A moment or duration for people: `1.25 s`."""
    return f"{moment / SECOND:.9f}".rstrip("0").rstrip(".") + " s"


def at_text(moment: int) -> str:
    """A moment as `--at` takes it: `1.25s`."""
    return shown(moment).replace(" ", "")


def readable(moment: int) -> str:
    """A moment for people who need no single nanoseconds, to the microsecond: `12 s`."""
    return shown(round(moment, -3))
