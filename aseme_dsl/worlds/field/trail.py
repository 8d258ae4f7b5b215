"""The trail: where the ball was lately, in memory that is taken once."""

from __future__ import annotations

from array import array
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class TrailPoint:
    """Where the ball was; after a point that is not ``rolling`` it was carried, not played."""

    time_ns: int
    x: float
    y: float
    rolling: bool


class Trail:
    """The newest of the points that were added, so many at the most."""

    def __init__(self, most: int) -> None:
        # All at once: a match that grows for its first half an hour cannot be told from one with a leak.
        self._times = array("q", bytes(8 * most))
        self._xs = array("d", bytes(8 * most))
        self._ys = array("d", bytes(8 * most))
        self._rolling = bytearray(most)
        self._added = 0

    def add(self, time_ns: int, x: float, y: float, rolling: bool) -> None:
        """Add a point; the oldest goes when there are too many."""
        place = self._added % len(self._times)
        self._times[place] = time_ns
        self._xs[place] = x
        self._ys[place] = y
        self._rolling[place] = rolling
        self._added += 1

    @property
    def points(self) -> tuple[TrailPoint, ...]:
        """The points, oldest first."""
        most = len(self._times)
        return tuple(self._point(number % most) for number in range(max(0, self._added - most), self._added))

    @property
    def last(self) -> TrailPoint:
        """The newest point. Raises IndexError if there is none."""
        if not self._added:
            raise IndexError("the trail has no points")
        return self._point((self._added - 1) % len(self._times))

    def _point(self, place: int) -> TrailPoint:
        return TrailPoint(self._times[place], self._xs[place], self._ys[place], bool(self._rolling[place]))
