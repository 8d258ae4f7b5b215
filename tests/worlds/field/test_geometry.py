"""Places and directions."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.worlds.field.field import HALF_LENGTH, HALF_WIDTH, in_own_penalty_area, on_field
from aseme_dsl.worlds.field.geometry import (
    Point,
    Pose,
    bearing,
    clamp,
    direction,
    distance,
    place_of,
    towards,
    turned,
    unit,
    wrap,
)

CM = st.floats(-600, 600)
DEGREES = st.floats(-720, 720)
POSES = st.builds(Pose, CM, CM, st.floats(-180, 180))


@given(DEGREES)
def test_wrapping_keeps_the_direction(angle: float) -> None:
    assert -180 < wrap(angle) <= 180
    assert math.cos(math.radians(wrap(angle))) == pytest.approx(math.cos(math.radians(angle)), abs=1e-9)
    assert wrap(wrap(angle)) == wrap(angle)


@given(DEGREES)
def test_a_unit_vector_points_where_it_should(angle: float) -> None:
    x, y = unit(angle)
    assert math.hypot(x, y) == pytest.approx(1, abs=1e-8)
    assert wrap(direction(x, y) - angle) == pytest.approx(0, abs=1e-5)


@given(POSES, st.floats(1, 900), st.floats(-179, 179))
def test_what_is_seen_at_a_place_is_there(pose: Pose, away: float, aside: float) -> None:
    place = place_of(pose, away, aside)
    assert distance(pose, place) == pytest.approx(away, abs=1e-3)
    assert wrap(bearing(pose, place) - aside) == pytest.approx(0, abs=1e-3)


@given(POSES)
def test_the_other_team_of_the_other_team_is_the_own(pose: Pose) -> None:
    twice = turned(turned(pose))
    assert (twice.x, twice.y) == (pose.x, pose.y)
    assert wrap(twice.heading - pose.heading) == pytest.approx(0, abs=1e-9)


@given(POSES, POSES)
def test_both_teams_see_the_same_distances_and_bearings(one: Pose, other: Pose) -> None:
    assert distance(turned(one), turned(other)) == distance(one, other)
    if distance(one, other) > 1:
        assert wrap(bearing(turned(one), turned(other)) - bearing(one, other)) == pytest.approx(0, abs=1e-5)


def test_left_is_positive_and_x_goes_to_the_opponents_goal() -> None:
    assert towards(Point(0, 0), Point(100, 0)) == 0
    assert towards(Point(0, 0), Point(0, 100)) == 90
    assert bearing(Pose(0, 0, 90), Point(100, 0)) == -90
    assert direction(0, 0) == 0


def test_the_field_has_the_league_s_size() -> None:
    assert (2 * HALF_LENGTH, 2 * HALF_WIDTH) == (900, 600)
    assert on_field(Point(450, -300))
    assert not on_field(Point(451, 0))
    assert on_field(Point(451, 0), beyond=1)
    assert in_own_penalty_area(Point(-300, 199))
    assert not in_own_penalty_area(Point(300, 0))
    assert clamp(-7, 5) == -5
