"""The trail of the ball: the newest points, in memory that does not grow."""

from __future__ import annotations

import tracemalloc

import pytest

from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.trail import Trail, TrailPoint


def test_the_newest_points_are_kept() -> None:
    trail = Trail(3)
    with pytest.raises(IndexError):
        _ = trail.last
    for number in range(5):
        trail.add(number, number / 2, -number, number % 2 == 0)
        assert trail.last == trail.points[-1]
    assert trail.points == (
        TrailPoint(2, 1.0, -2.0, True),
        TrailPoint(3, 1.5, -3.0, False),
        TrailPoint(4, 2.0, -4.0, True),
    )


def test_it_takes_its_memory_at_once() -> None:
    trail = Trail(1000)
    tracemalloc.start()
    try:
        for number in range(2000):
            trail.add(10**12 + number, 1.0 + number, 2.0 + number, True)
        kept = tracemalloc.take_snapshot()
    finally:
        tracemalloc.stop()
    # Only what is its own: other threads of the tests take memory, too.
    own = tracemalloc.Filter(True, Trail.add.__code__.co_filename)
    assert sum(trace.size for trace in kept.filter_traces([own]).traces) < 1000


def test_two_matches_have_each_their_own() -> None:
    one, other = Match(1), Match(1)
    one.advance(1_000_000_000)
    assert len(one.trail) > len(other.trail) == 1
