"""What a robot sees, and with what error."""

from __future__ import annotations

import random
from statistics import fmean, pstdev

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.worlds.field import vision
from aseme_dsl.worlds.field.ball import Ball
from aseme_dsl.worlds.field.geometry import Point, Pose, bearing, distance, place_of, turned, wrap
from aseme_dsl.worlds.field.match import HEADING_NOISE, PLACE_NOISE, Match
from aseme_dsl.worlds.field.noise import BOUND, bell
from aseme_dsl.worlds.field.percept import BallSeen, Posture
from aseme_dsl.worlds.field.robot import Robot

SAMPLES = 3000


def robot_at(pose: Pose, head: float = 0.0, name: str = "r", team: int = 0, jersey: int = 1) -> Robot:
    return Robot(name, team, jersey, False, x=pose.x, y=pose.y, heading=pose.heading, head=head)


def looks(observer: Robot, ball: Ball, robots: list[Robot] | None = None) -> list[BallSeen]:
    chance = random.Random(7)
    pictures = [vision.look(observer, ball, robots or [observer], chance) for _ in range(SAMPLES)]
    return [picture.ball for picture in pictures if picture.ball is not None]


@given(
    st.floats(-400, 400), st.floats(-250, 250), st.floats(-180, 180), st.floats(-119, 119), st.integers(0, 99)
)
def test_nothing_outside_the_cone_is_ever_seen(
    x: float, y: float, heading: float, head: float, seed: int
) -> None:
    chance = random.Random(seed)
    observer = robot_at(Pose(x, y, heading), head)
    ball = Ball(chance.uniform(-450, 450), chance.uniform(-300, 300))
    other = robot_at(Pose(chance.uniform(-450, 450), chance.uniform(-300, 300)), name="o", team=1)
    picture = vision.look(observer, ball, [observer, other], chance)
    for thing, seen in (
        (Point(ball.x, ball.y), picture.ball),
        (other.pose, next(iter(picture.robots), None)),
    ):
        aside = wrap(bearing(observer.pose, thing) - head)
        if abs(aside) > vision.HALF_ANGLE + 0.001 or distance(observer.pose, thing) > vision.RANGE:
            assert seen is None


def test_a_robot_cannot_see_behind_itself() -> None:
    for aside in range(0, 360, 5):
        spot = place_of(Pose(0, 0, 0), 200, aside)
        seen = looks(robot_at(Pose(0, 0, 0)), Ball(spot.x, spot.y))
        if abs(wrap(aside)) > 30:
            assert seen == []
        elif abs(wrap(aside)) < 30:
            assert len(seen) > SAMPLES / 2


def test_turning_the_head_moves_the_cone_and_bearings_stay_those_of_the_body() -> None:
    ball = Ball(0, 200)
    assert looks(robot_at(Pose(0, 0, 0)), ball) == []
    seen = looks(robot_at(Pose(0, 0, 0), head=80), ball)
    assert fmean(one.bearing for one in seen) == pytest.approx(90, abs=0.2)


@pytest.mark.parametrize("away", [20.0, 150.0, 400.0])
def test_the_error_has_the_stated_spread(away: float) -> None:
    seen = looks(robot_at(Pose(0, 0, 10)), Ball(*_xy(Pose(0, 0, 10), away, 15), vx=30, vy=-20))
    error = vision.distance_noise(away)
    assert fmean(one.distance for one in seen) == pytest.approx(away, abs=error / 10)
    assert pstdev(one.distance for one in seen) == pytest.approx(error, rel=0.08)
    error = vision.bearing_noise(away)
    assert fmean(one.bearing for one in seen) == pytest.approx(15, abs=error / 10)
    assert pstdev(one.bearing for one in seen) == pytest.approx(error, rel=0.08)
    assert pstdev(one.velocity_left for one in seen) == pytest.approx(vision.SPEED_NOISE, rel=0.08)
    missed = 1 - len(seen) / SAMPLES
    assert missed == pytest.approx(vision.miss_probability(away), abs=0.02)


def _xy(pose: Pose, away: float, aside: float) -> tuple[float, float]:
    spot = place_of(pose, away, aside)
    return spot.x, spot.y


def test_the_error_grows_with_the_distance() -> None:
    for error in (vision.distance_noise, vision.bearing_noise, vision.miss_probability):
        values = [error(away) for away in range(0, 450, 10)]
        assert values == sorted(values)
        assert values[0] < values[-1] / 2


def test_a_velocity_is_along_and_across_the_robot() -> None:
    seen = looks(robot_at(Pose(0, 0, 90)), Ball(0, 200, vx=50, vy=-100))
    assert fmean(one.velocity_forward for one in seen) == pytest.approx(-100, abs=1)
    assert fmean(one.velocity_left for one in seen) == pytest.approx(-50, abs=1)
    assert fmean(one.speed for one in seen) == pytest.approx(111.8, abs=1)


def test_a_robot_in_the_line_of_sight_hides_the_ball() -> None:
    observer, ball = robot_at(Pose(0, 0)), Ball(200, 0)
    assert looks(observer, ball, [observer, robot_at(Pose(100, 5), name="wall")]) == []
    for beside in (Pose(100, 20), Pose(230, 0), Pose(-50, 0)):
        assert looks(observer, ball, [observer, robot_at(beside, name="beside")])


def test_who_lies_or_is_penalised_sees_nothing() -> None:
    lying = robot_at(Pose(0, 0))
    lying.posture = Posture.FALLEN
    out = robot_at(Pose(0, 0))
    out.penalised_until_ns = 1
    assert looks(lying, Ball(100, 0)) == looks(out, Ball(100, 0)) == []


def test_posts_and_robots_are_named_as_the_own_team_names_them() -> None:
    chance = random.Random(1)
    for team in (0, 1):
        pose = Pose(300, 0, 0)
        observer = robot_at(pose if team == 0 else turned(pose), team=team)
        mate = robot_at(Pose(350, 10) if team == 0 else turned(Pose(350, 10)), name="m", team=team, jersey=4)
        foe = robot_at(Pose(350, -20) if team == 0 else turned(Pose(350, -20)), name="f", team=1 - team)
        pictures = [vision.look(observer, Ball(), [observer, mate, foe], chance) for _ in range(50)]
        posts = {(post.opponents, post.left) for picture in pictures for post in picture.posts}
        assert posts == {(True, True), (True, False)}
        for picture in pictures:
            assert all((post.bearing > 0) == post.left for post in picture.posts)
            assert all((seen.own_team, seen.jersey) in ((True, 4), (False, 1)) for seen in picture.robots)
            assert all((seen.bearing > 0) == seen.own_team for seen in picture.robots)
        assert observer.name not in {"m", "f"}


def test_the_pose_is_wrong_by_as_much_as_stated() -> None:
    places: list[float] = []
    headings: list[float] = []
    steps: list[float] = []
    for seed in range(40):
        match = Match(seed)
        before = None
        for second in range(1, 11):
            match.advance(second * 990_000_000)
            for robot in match.truth().robots[:4]:
                percept = match.bodies[robot.name].sense()
                places += [percept.pose.x - robot.pose.x, percept.pose.y - robot.pose.y]
                headings.append(wrap(percept.pose.heading - robot.pose.heading))
        match.advance(match.now_ns + 30_000_000)
        before = match.bodies["robot1"].sense().pose
        match.advance(match.now_ns + 30_000_000)
        steps.append(distance(before, match.bodies["robot1"].sense().pose))
    assert pstdev(places) == pytest.approx(PLACE_NOISE, rel=0.1)
    assert pstdev(headings) == pytest.approx(HEADING_NOISE, rel=0.1)
    assert abs(fmean(places)) < 1
    # It wanders rather than jumps.
    assert fmean(steps) < PLACE_NOISE / 2


def test_the_bell_has_the_shape_it_promises() -> None:
    chance = random.Random(3)
    values = [bell(chance) for _ in range(20000)]
    assert abs(fmean(values)) < 0.03
    assert pstdev(values) == pytest.approx(1, abs=0.02)
    assert max(abs(value) for value in values) <= BOUND
    within = sum(abs(value) < 1 for value in values) / len(values)
    assert within == pytest.approx(0.68, abs=0.03)
