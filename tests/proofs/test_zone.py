"""Zones say of all times at once what a search through moments says of each."""

from __future__ import annotations

from itertools import combinations_with_replacement

from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.proofs.timed.zone import (
    FREE,
    Zone,
    at_most,
    begun,
    covers,
    kept,
    later,
    less_than,
    narrowed,
    shown,
)

STEPS = 4
"""Moments lie this close: so many in a unit."""
MOST = 9
"""The last moment: three moves, each with at most three units before it."""

Limit = tuple[int, int, int, bool]
"""At a move: the earlier move from which it is counted, the least and most time since then; whether the ends
are left out."""
limits = st.lists(
    st.tuples(st.integers(0, 3), st.integers(0, 2), st.integers(0, 3), st.booleans()), max_size=3
)
runs = st.lists(limits, min_size=1, max_size=3)


def zone_of(run: list[list[Limit]]) -> Zone | None:
    """The zone after moves, each with its limits: all clocks are kept."""
    zone = begun(Zone(), 0)
    for number, found in enumerate(run, 1):
        zone = later(zone)
        for since, least, most, is_open in found:
            place = min(since, number - 1) + 1
            for one, other, value in ((place, 0, most), (0, place, -least)):
                after = narrowed(zone, one, other, less_than(value) if is_open else at_most(value))
                if after is None:
                    return None
                zone = after
        zone = begun(zone, number)
    return zone


def moments_of(run: list[list[Limit]]) -> list[tuple[int, ...]]:
    """All moments of the moves, as far as they lie on a grid."""
    found = []
    for moments in combinations_with_replacement(range(MOST * STEPS + 1), len(run)):
        times = (0, *moments)
        if all(
            least * STEPS < passed < most * STEPS if is_open else least * STEPS <= passed <= most * STEPS
            for number, some in enumerate(run, 1)
            for since, least, most, is_open in some
            for passed in (times[number] - times[min(since, number - 1)],)
        ):
            found.append(times)
    return found


@settings(max_examples=60, deadline=None)
@given(runs)
def test_a_zone_has_the_times_that_moves_can_have(run: list[list[Limit]]) -> None:
    zone, found = zone_of(run), moments_of(run)
    assert (zone is None) == (not found)
    if zone is None:
        return
    now = [times[-1] for times in found]
    for i, row in enumerate(zone.rows):
        for j, bound in enumerate(row):
            widest = max(
                (0 if i == 0 else end - times[i - 1]) - (0 if j == 0 else end - times[j - 1])
                for times, end in zip(found, now, strict=True)
            )
            if bound != FREE:
                assert widest < bound / 2 * STEPS  # "at most c" is c + 1/2 here, "less than c" is c
            if bound != FREE and abs(bound) <= 6:  # those that the grid reaches are reached
                assert widest > (bound // 2 - 1) * STEPS


@given(runs, runs)
def test_a_zone_covers_another_if_each_bound_is_as_wide(
    one: list[list[Limit]], other: list[list[Limit]]
) -> None:
    first, second = zone_of(one), zone_of(other[: len(one)] + one[len(other) :])
    if first is None or second is None:
        return
    if covers(first.rows, second.rows):
        for i, j in ((i, j) for i in range(len(first.rows)) for j in range(len(first.rows))):
            assert narrowed(second, i, j, first.rows[i][j]) is second
    assert covers(first.rows, first.rows)


@given(runs)
def test_clocks_that_are_dropped_and_marks_change_no_other_bound(run: list[list[Limit]]) -> None:
    zone = zone_of(run)
    if zone is None:
        return
    last = zone.clocks[-1]
    assert kept(zone, (last, 0)).rows[2][1] == zone.rows[1][len(run) + 1]
    marks = shown(zone, [(0, 0), (0, 2)])
    assert marks[1][2] == at_most(2) and marks[2][1] == at_most(-2)
    assert marks[1][0] == zone.rows[1][0]
