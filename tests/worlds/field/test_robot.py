"""What a robot's body can do, and what it cannot."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from aseme_dsl.worlds.field import robot as limits
from aseme_dsl.worlds.field.ball import Ball, roll
from aseme_dsl.worlds.field.command import Command, Dive, Kick, Motion, Sit, Stand, Walk
from aseme_dsl.worlds.field.event import EventKind
from aseme_dsl.worlds.field.geometry import Point, Pose, direction, distance, length, place_of, unit, wrap
from aseme_dsl.worlds.field.match import NOBODY, STEP_NS, Match
from aseme_dsl.worlds.field.percept import Posture
from aseme_dsl.worlds.field.referee import Rules
from aseme_dsl.worlds.field.robot import Robot, at_feet, fall, move, obey
from aseme_dsl.worlds.field.skills import strength_for
from aseme_dsl.worlds.field.team import team_sheet

SECOND = 1_000_000_000
SPEEDS = st.floats(-500, 500)


def live(robot: Robot, motion: Motion | None, seconds: float, free: bool = True, start_ns: int = 0) -> int:
    """Let a robot carry out a motion for a while; the time afterwards."""
    if motion is not None:
        obey(robot, Command(motion))
    now_ns = start_ns
    for _ in range(round(seconds * 100)):
        now_ns += STEP_NS
        move(robot, now_ns, 0.01, free)
    return now_ns


def posture(robot: Robot) -> Posture:
    return robot.posture


@given(SPEEDS, SPEEDS, SPEEDS)
def test_no_walk_is_faster_than_the_robot(forward: float, left: float, turn: float) -> None:
    robot = Robot("r", 0, 1, False)
    obey(robot, Command(Walk(forward, left, turn)))
    for step in range(1, 120):
        x, y, heading, ahead, aside = robot.x, robot.y, robot.heading, robot.forward, robot.left
        move(robot, step * STEP_NS, 0.01, True)
        assert -limits.BACKWARD_SPEED <= robot.forward <= limits.FORWARD_SPEED
        assert abs(robot.left) <= limits.SIDE_SPEED
        assert abs(wrap(robot.heading - heading)) <= limits.TURN_SPEED * 0.01 + 1e-9
        assert abs(robot.forward - ahead) <= limits.ACCELERATION * 0.01 + 1e-9
        assert abs(robot.left - aside) <= limits.ACCELERATION * 0.01 + 1e-9
        most = length(limits.FORWARD_SPEED, limits.SIDE_SPEED)
        assert length(robot.x - x, robot.y - y) <= most * 0.01 + 1e-9


def test_it_walks_where_it_looks() -> None:
    robot = Robot("r", 0, 1, False, heading=90.0)
    live(robot, Walk(forward=20), 5)
    assert robot.x == pytest.approx(0, abs=0.01)
    assert 95 < robot.y < 100
    live(robot, Walk(left=10), 5)
    assert -50 < robot.x < -45


def test_the_head_turns_as_far_and_as_fast_as_it_can() -> None:
    robot = Robot("r", 0, 1, False)
    obey(robot, Command(head=300))
    move(robot, STEP_NS, 0.01, False)
    assert robot.head == pytest.approx(limits.HEAD_SPEED * 0.01)
    live(robot, None, 2)
    assert robot.head == limits.HEAD_LIMIT


def test_it_does_not_leave_the_spot_unless_it_may() -> None:
    robot = Robot("r", 0, 1, False)
    now_ns = live(robot, Walk(forward=30), 1, free=False)
    assert (robot.x, robot.y) == (0, 0)
    live(robot, None, 1, start_ns=now_ns)
    assert robot.x > 10


def test_sitting_and_lying_robots_get_up_before_they_walk() -> None:
    robot = Robot("r", 0, 1, False)
    now_ns = live(robot, Sit(), 2)
    assert posture(robot) is Posture.SITTING
    now_ns = live(robot, Walk(forward=30), 2, start_ns=now_ns)
    assert (posture(robot), robot.x) == (Posture.SITTING, 0)
    now_ns = live(robot, Stand(), 2, start_ns=now_ns)
    assert posture(robot) is Posture.STANDING
    fall(robot)
    now_ns = live(robot, Stand(), 2, start_ns=now_ns)
    assert posture(robot) is Posture.FALLEN
    now_ns = live(robot, None, 2, start_ns=now_ns)
    assert posture(robot) is Posture.STANDING
    live(robot, Walk(forward=30), 2, start_ns=now_ns)
    assert robot.x > 30


def test_who_dives_lies_there() -> None:
    robot = Robot("r", 0, 1, True)
    now_ns = live(robot, Dive(left=True), 0.2)
    assert limits.covers(robot, 0, 100) == (0, limits.DIVE_REACH)
    assert limits.covers(robot, 0, -100) == (0, 0)
    now_ns = live(robot, None, 1, start_ns=now_ns)
    assert posture(robot) is Posture.FALLEN
    live(robot, Stand(), 4, start_ns=now_ns)
    assert posture(robot) is Posture.STANDING
    assert limits.covers(robot, 0, 100) == (0, 0)


@given(st.floats(0, 80), st.floats(-180, 180), st.floats(-180, 180))
def test_at_the_feet_is_near_and_in_front(away: float, aside: float, heading: float) -> None:
    robot = Robot("r", 0, 1, False, heading=heading)
    ball = place_of(robot.pose, away, aside)
    inside = away < limits.TOUCH + limits.FEET_REACH - 0.01 and abs(aside) < limits.FEET_ANGLE - 0.01
    outside = away > limits.TOUCH + limits.FEET_REACH + 0.01 or abs(aside) > limits.FEET_ANGLE + 0.01
    if inside and away > 0.1:
        assert at_feet(robot, ball.x, ball.y)
    if outside and away > 0.1:
        assert not at_feet(robot, ball.x, ball.y)


def training(*names: str, seed: int = 1) -> Match:
    """A match without another team, and without waiting for the whistle."""
    sheet = team_sheet(1, "Home", names or ("r",))
    match = Match(seed, sheet, NOBODY, Rules(initial_ns=0, ready_ns=0, set_ns=0, half_ns=600 * SECOND))
    match.advance(3 * STEP_NS)
    return match


def kick_ball_at(away: float, aside: float, kick: Kick, seed: int = 1) -> Match:
    match = training(seed=seed)
    pose = Pose(-300, 0, 0)
    match.put_robot("r", pose)
    match.put_ball(place_of(pose, away, aside))
    match.bodies["r"].act(Command(kick))
    match.advance(match.now_ns + 8 * SECOND)
    return match


def events(match: Match, kind: EventKind) -> list[str]:
    return [event.robot for event in match.events if event.kind is kind]


def test_a_kick_works_only_at_the_feet() -> None:
    match = kick_ball_at(18, 10, Kick(0.6))
    assert events(match, EventKind.KICK) == ["r"]
    assert match.truth().ball.x > -100
    for away, aside in ((30, 0), (18, 60), (18, 180), (18, -90)):
        match = kick_ball_at(away, aside, Kick(0.6))
        assert events(match, EventKind.KICK) == []
        assert events(match, EventKind.MISSED_KICK) == ["r"]
        assert match.truth().ball.vx == 0
        assert distance(Point(-300, 0), Point(match.truth().ball.x, match.truth().ball.y)) < 31


def test_a_kick_is_done_once_for_a_command() -> None:
    match = training()
    match.put_robot("r", Pose(-300, 0, 0))
    match.put_ball(Point(-282, 0))
    match.bodies["r"].act(Command(Kick(0.2)))
    match.advance(match.now_ns + 3 * SECOND)
    match.put_ball(Point(-282, 0))
    match.advance(match.now_ns + 3 * SECOND)
    assert events(match, EventKind.KICK) == ["r"]
    assert match.truth().ball.x == -282


def test_a_kick_goes_on_although_another_motion_is_told() -> None:
    match = training()
    match.put_robot("r", Pose(-300, 0, 0))
    match.put_ball(Point(-282, 0))
    body = match.bodies["r"]
    body.act(Command(Kick(0.5)))
    match.advance(match.now_ns + SECOND // 10)
    body.act(Command(Walk(turn=90)))
    match.advance(match.now_ns + SECOND // 5)
    assert body.sense().busy
    assert body.sense().walk == Walk()
    match.advance(match.now_ns + SECOND)
    assert events(match, EventKind.KICK) == ["r"]
    assert body.sense().walk.turn > 0


@pytest.mark.parametrize("turn", [-30.0, 0.0, 30.0])
def test_kicks_scatter_round_the_wanted_direction_and_distance(turn: float) -> None:
    ways: list[float] = []
    turns: list[float] = []
    for seed in range(60):
        ball = kick_ball_at(18, 0, Kick(strength_for(250), turn), seed).truth().ball
        ways.append(length(ball.x + 282, ball.y))
        turns.append(direction(ball.x + 282, ball.y))
    assert sum(turns) / 60 == pytest.approx(turn, abs=3 * limits.KICK_ANGLE_NOISE / 60**0.5)
    assert sum(ways) / 60 == pytest.approx(250, abs=15)
    assert max(ways) - min(ways) > 20


def test_a_robot_does_not_kick_further_round_than_it_can() -> None:
    ball = kick_ball_at(18, 0, Kick(0.5, 170)).truth().ball
    assert 30 < direction(ball.x + 282, ball.y) < 60


@given(st.floats(1, limits.KICK_SPEED), st.floats(-180, 180))
@example(233.0, 10.0)
def test_the_ball_rolls_straight_and_comes_to_rest(speed: float, heading: float) -> None:
    c, s = unit(heading)
    ball = Ball(0, 0, speed * c, speed * s)
    furthest = 0.0
    for _ in range(1000):
        roll(ball, 0.01)
        furthest = max(furthest, abs(ball.x))
    assert ball.speed == 0
    away = length(ball.x, ball.y)
    if furthest < 400:  # no post in its way, from which it would have come back
        assert away == pytest.approx(speed * speed / 90, rel=0.05, abs=3)
        assert ball.x * s - ball.y * c == pytest.approx(0, abs=0.01)


def test_walking_robots_push_the_ball_and_do_not_pass_through_it() -> None:
    match = training()
    match.put_robot("r", Pose(-300, 0, 0))
    match.put_ball(Point(-250, 3))
    match.bodies["r"].act(Command(Walk(forward=40)))
    for _ in range(300):
        match.advance(match.now_ns + STEP_NS)
        truth = match.truth()
        pose, ball = truth.robots[0].pose, truth.ball
        # At the end of a step they touch at most as deep as a step is long.
        assert length(ball.x - pose.x, ball.y - pose.y) > limits.TOUCH - 0.5
    assert match.truth().ball.x > -230


def test_robots_do_not_stand_in_each_other() -> None:
    match = training("a", "b", "c")
    for name, x in (("a", 0.0), ("b", 60.0), ("c", 90.0)):
        match.put_robot(name, Pose(x - 300, 200, 0.0 if name == "a" else 180.0))
        match.bodies[name].act(Command(Walk(forward=40)))
    for _ in range(400):
        match.advance(match.now_ns + STEP_NS)
        poses = [robot.pose for robot in match.truth().robots]
        for index, pose in enumerate(poses):
            for other in poses[index + 1 :]:
                assert distance(pose, other) > 2 * limits.RADIUS - 1.5


def test_robots_that_run_into_each_other_fall_now_and_then() -> None:
    falls = 0
    for seed in range(20):
        match = training("a", "b", seed=seed)
        for name, x, heading in (("a", -330.0, 0.0), ("b", -270.0, 180.0)):
            match.put_robot(name, Pose(x, 200, heading))
            match.bodies[name].act(Command(Walk(forward=40)))
        match.advance(match.now_ns + 4 * SECOND)
        fallen = [r.name for r in match.truth().robots if r.posture is Posture.FALLEN]
        assert set(fallen) <= set(events(match, EventKind.FALL))
        falls += bool(fallen)
    assert 5 < falls < 20
