"""Zones: what is known of the times that have passed since some moments: bounds of their differences.

A zone has a clock for each moment: the time since then. It is a matrix of bounds, a difference bound matrix.
Each bound is the tightest that follows from all of them. Row and column 0 stand for 0. A bound is a whole
number: `2 * c + 1` for "at most c", `2 * c` for "less than c".
"""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.records import dataclass

FREE = 1 << 200
"""The bound that is none."""

AT_MOST_0 = 1
"""The bound "at most 0"."""


def at_most(value: int) -> int:
    """The bound "at most so much"."""
    return 2 * value + 1


def less_than(value: int) -> int:
    """The bound "less than so much"."""
    return 2 * value


def added(one: int, other: int) -> int:
    """The bound of a sum."""
    return FREE if one == FREE or other == FREE else one + other - ((one | other) & 1)


@dataclass(frozen=True, slots=True)
class Zone:
    """The times that clocks may show: `rows[i][j]` bounds clock i - clock j."""

    clocks: tuple[int, ...] = ()
    """The name of the clock of each further row."""
    rows: tuple[tuple[int, ...], ...] = ((AT_MOST_0,),)

    def place(self, clock: int) -> int | None:
        """The row of a clock; None if there is none of this name."""
        return self.clocks.index(clock) + 1 if clock in self.clocks else None


def later(zone: Zone) -> Zone:
    """Any time may have passed."""
    first, *rest = zone.rows
    return Zone(zone.clocks, (first, *((FREE, *row[1:]) for row in rest)))


def begun(zone: Zone, clock: int) -> Zone:
    """With a new clock, which shows 0."""
    rows = tuple((*row, row[0]) for row in zone.rows)
    return Zone((*zone.clocks, clock), (*rows, (*zone.rows[0], AT_MOST_0)))


def unbounded(zone: Zone, clock: int) -> Zone:
    """With a new clock, which shows any number, also less than 0."""
    rows = tuple((*row, FREE) for row in zone.rows)
    return Zone((*zone.clocks, clock), (*rows, (*(FREE for _ in zone.rows[0]), AT_MOST_0)))


def begun_before(zone: Zone, clock: int, least: int, most: int | None) -> Zone:
    """With a new clock, which shows any time from `least` to `most` (None: any)."""
    high, low = FREE if most is None else at_most(most), at_most(-least)
    rows = tuple((*row, added(row[0], low)) for row in zone.rows)
    return Zone((*zone.clocks, clock), (*rows, (*(added(high, bound) for bound in zone.rows[0]), AT_MOST_0)))


def narrowed(zone: Zone, one: int, other: int, bound: int) -> Zone | None:
    """The times at which row `one` - row `other` keeps a bound, too; None if there are none."""
    rows = zone.rows
    if bound >= rows[one][other]:
        return zone
    if added(rows[other][one], bound) < AT_MOST_0:
        return None
    behind = [added(bound, after) for after in rows[other]]
    made = []
    for row in rows:
        before = row[one]
        if before == FREE:
            made.append(row)
            continue
        made.append(tuple([min(known, added(before, new)) for known, new in zip(row, behind, strict=True)]))
    return Zone(zone.clocks, tuple(made))


def kept(zone: Zone, clocks: Sequence[int]) -> Zone:
    """With these clocks alone, in this order."""
    places = [0, *(zone.clocks.index(clock) + 1 for clock in clocks)]
    return Zone(tuple(clocks), tuple(tuple([zone.rows[i][j] for j in places]) for i in places))


def shown(zone: Zone, marks: Sequence[tuple[int, int]]) -> tuple[tuple[int, ...], ...]:
    """The bounds of the times since other moments, each by a clock and how long after its start it is."""
    places = [(0, 0), *((zone.clocks.index(clock) + 1, offset) for clock, offset in marks)]
    return tuple(tuple([_moved(zone.rows[i][j], then - since) for j, then in places]) for i, since in places)


def _moved(bound: int, by: int) -> int:
    return bound if bound == FREE else bound + 2 * by


def covers(one: Sequence[Sequence[int]], other: Sequence[Sequence[int]]) -> bool:
    """Whether bounds allow all that others, of the same clocks, allow."""
    return all(
        wide >= narrow
        for row, inner in zip(one, other, strict=True)
        for wide, narrow in zip(row, inner, strict=True)
    )


__all__ = [
    "AT_MOST_0",
    "FREE",
    "Zone",
    "added",
    "at_most",
    "begun",
    "begun_before",
    "covers",
    "kept",
    "later",
    "less_than",
    "narrowed",
    "shown",
    "unbounded",
]
