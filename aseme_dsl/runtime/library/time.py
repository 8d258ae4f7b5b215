"""Time: the functions of `import time`. A duration is an int of nanoseconds."""

from __future__ import annotations

SECOND = 1_000_000_000


def seconds(time: int) -> float:
    """A duration in seconds."""
    return time / SECOND


def milliseconds(time: int) -> float:
    """A duration in milliseconds."""
    return time * 1000 / SECOND


def minutes(time: int) -> float:
    """A duration in minutes."""
    return time / (60 * SECOND)


def from_seconds(number: float) -> int:
    """The duration of so many seconds, to the nearest nanosecond."""
    return round(number * SECOND)
