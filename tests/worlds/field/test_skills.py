"""The calculations that a player's activities build on lead where they say."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from aseme_dsl.worlds.field import robot as limits
from aseme_dsl.worlds.field.ball import Ball, roll
from aseme_dsl.worlds.field.command import Command, Dive, Kick, Stand, Walk
from aseme_dsl.worlds.field.field import (
    GOAL_HALF_WIDTH,
    HALF_LENGTH,
    OPPONENTS_GOAL,
    in_own_penalty_area,
    on_field,
)
from aseme_dsl.worlds.field.geometry import Point, Pose, bearing, distance, length, unit, wrap
from aseme_dsl.worlds.field.match import NOBODY, STEP_NS, Match
from aseme_dsl.worlds.field.percept import (
    BallSeen,
    GameSeen,
    Percept,
    PlayerState,
    Posture,
    RobotSeen,
    SetPlay,
)
from aseme_dsl.worlds.field.referee import Rules
from aseme_dsl.worlds.field.robot import Robot, at_feet, move, obey
from aseme_dsl.worlds.field.skills import (
    AIM_ERROR,
    aim,
    aim_error,
    at_place,
    attack,
    avoid,
    ball_place,
    can_kick,
    clear,
    crossing,
    gap,
    keeper_place,
    kick,
    line_up,
    look_at,
    pass_to,
    recover,
    save,
    scan,
    search,
    seconds_to_ball,
    shoot,
    strength_for,
    support_place,
    walk_to,
)
from aseme_dsl.worlds.field.team import team_sheet
from aseme_dsl.worlds.field.vision import HALF_ANGLE, RANGE

SECOND = 1_000_000_000
X = st.floats(-420, 420)
Y = st.floats(-270, 270)
HEADING = st.floats(-180, 180)
POSES = st.builds(Pose, X, Y, HEADING)
MIDDLE = Pose(0, 0)
GAME = GameSeen(PlayerState.PLAYING, PlayerState.PLAYING, 1, 60, 0, 0, True, SetPlay.NONE, False)


def percept(
    pose: Pose = MIDDLE,
    ball: BallSeen | None = None,
    at_feet: bool = False,
    posture: Posture = Posture.STANDING,
    busy: bool = False,
    robots: tuple[RobotSeen, ...] = (),
    game: GameSeen = GAME,
) -> Percept:
    return Percept(
        time_ns=0,
        name="r",
        team=1,
        jersey=1,
        goalie=False,
        pose=pose,
        walk=Walk(),
        head=0.0,
        posture=posture,
        busy=busy,
        ball=ball,
        ball_at_feet=at_feet,
        robots=robots,
        posts=(),
        game=game,
        kick_off_place=Pose(-30, 0),
    )


@settings(max_examples=40)
@given(POSES, POSES)
def test_walking_to_a_place_arrives_there(start: Pose, goal: Pose) -> None:
    robot = Robot("r", 0, 1, False, x=start.x, y=start.y, heading=start.heading)
    for step in range(1, 4001):
        if step % 5 == 0:
            obey(robot, Command(walk_to(robot.pose, goal, goal.heading)))
        move(robot, step * STEP_NS, 0.01, True)
        if step % 50 == 0 and at_place(robot.pose, goal, 5, 5):
            return
    pytest.fail(f"after 40 s it is at {robot.pose}")


@settings(max_examples=40)
@given(POSES, st.builds(Point, X, Y), st.builds(Point, X, Y))
def test_lining_up_brings_the_ball_to_the_feet_and_the_target_in_front(
    start: Pose, ball: Point, target: Point
) -> None:
    assume(distance(start, ball) > limits.TOUCH and distance(ball, target) > 50)
    robot = Robot("r", 0, 1, False, x=start.x, y=start.y, heading=start.heading)
    for step in range(1, 4001):
        if step % 5 == 0:
            obey(robot, Command(line_up(robot.pose, ball, target)))
        move(robot, step * STEP_NS, 0.01, True)
        # The ball does not move here: a robot that got there by walking through it would have moved it.
        ready = at_feet(robot, ball.x, ball.y) and abs(aim_error(robot.pose, ball, target)) < AIM_ERROR
        if ready:
            return
        if distance(start, ball) > limits.TOUCH + 25:
            assert distance(robot.pose, ball) > limits.TOUCH - 4
    pytest.fail(f"after 40 s it is at {robot.pose}")


@pytest.mark.parametrize("seed", range(12))
def test_an_attacker_alone_scores_from_anywhere(seed: int) -> None:
    rules = Rules(initial_ns=0, ready_ns=0, set_ns=0, half_ns=120 * SECOND, halves=1)
    match = Match(seed, team_sheet(1, "Home", ["r"]), NOBODY, rules)
    match.advance(3 * STEP_NS)
    spot = Point(-400 + 65 * seed, -250 + 45 * seed)
    match.put_ball(spot)
    match.put_robot("r", Pose(-spot.x, -spot.y, 30 * seed))
    body = match.bodies["r"]
    remembered, seen_ns = Point(0, 0), -5 * SECOND
    while not match.over and match.result().score == (0, 0):
        seen = body.sense()
        place = ball_place(seen)
        if place is not None:
            remembered, seen_ns = place, seen.time_ns
        if seen.time_ns - seen_ns > 3 * SECOND:
            body.act(Command(search(seen.pose, seen.time_ns), scan(seen.time_ns)))
        else:
            head = look_at(seen.pose, remembered) if seen.ball else scan(seen.time_ns)
            body.act(Command(attack(seen, remembered, aim(seen, remembered)), head))
        match.advance(match.now_ns + 6 * STEP_NS)
    assert match.result().score == (1, 0)


@given(st.floats(10, 600))
def test_a_ball_kicked_with_the_strength_for_a_distance_rolls_so_far(way: float) -> None:
    ball = Ball(-300, 200, vx=strength_for(way) * limits.KICK_SPEED)
    for _ in range(800):
        roll(ball, 0.01)
    assert ball.x + 300 == pytest.approx(way, rel=0.03, abs=3)


def test_no_kick_is_stronger_than_one_or_weaker_than_nothing() -> None:
    assert strength_for(100_000) == 1
    assert 0 < strength_for(0) <= 0.05
    assert 0 < strength_for(-5) <= 0.05


@given(st.floats(40, 300), st.floats(-60, 60), st.floats(-200, 100), st.floats(-100, 100))
def test_where_a_ball_will_pass_is_where_it_passes(
    away: float, aside: float, ahead: float, left: float
) -> None:
    foretold = crossing(BallSeen(away, aside, ahead, left))
    c, s = unit(aside)
    # On a field of its own: no posts near.
    ball = Ball(away * c, away * s, ahead, left)
    seconds = 0.0
    while ball.speed > 0 and ball.x > 0 and abs(ball.x) < 400:
        roll(ball, 0.001)
        seconds += 0.001
    if foretold is None:
        # It comes to rest before, goes elsewhere, or is so slow that nobody would dive.
        assert ball.x > 0 or ahead >= -20
    elif ball.x <= 0:
        assert seconds == pytest.approx(foretold[0], abs=0.05)
        assert ball.y == pytest.approx(foretold[1], abs=2)
    else:
        assert ball.x < 2, "it stopped just before"


def test_a_keeper_dives_before_a_ball_that_it_can_reach_and_only_then() -> None:
    def dive(ball: BallSeen | None, busy: bool = False) -> Dive | None:
        return save(percept(ball=ball, busy=busy))

    assert dive(BallSeen(100, 20, -150, 0)) == Dive(left=True)
    assert dive(BallSeen(100, -20, -150, 0)) == Dive(left=False)
    assert dive(BallSeen(100, 0, -150, 0)) is None, "it comes to the feet"
    assert dive(BallSeen(100, 80, -150, 0)) is None, "too far"
    assert dive(BallSeen(300, 5, -180, 0)) is None, "too early"
    assert dive(BallSeen(100, 20, 150, 0)) is None, "it goes away"
    assert dive(None) is None
    assert dive(BallSeen(100, 20, -150, 0), busy=True) is None


def test_the_head_scans_from_side_to_side_once_a_period() -> None:
    angles = [scan(tenth * SECOND // 10) for tenth in range(40)]
    assert max(angles) == limits.HEAD_LIMIT
    assert min(angles) == -limits.HEAD_LIMIT
    assert scan(4 * SECOND) == scan(0)
    steps = [abs(one - other) for one, other in pairwise(angles)]
    assert max(steps) < limits.HEAD_SPEED / 10


def test_a_search_sees_the_whole_field() -> None:
    for spot in (Point(x, y) for x in (-440, -200, 0, 200, 440) for y in (-290, 0, 290)):
        robot = Robot("r", 0, 1, False, x=-400, y=280)
        seen = False
        for step in range(1, 4000):
            if step % 5 == 0:
                obey(robot, Command(search(robot.pose, step * STEP_NS), scan(step * STEP_NS)))
            move(robot, step * STEP_NS, 0.01, True)
            aside = wrap(bearing(robot.pose, spot) - robot.head)
            seen = seen or (abs(aside) < HALF_ANGLE and distance(robot.pose, spot) < RANGE)
        assert seen, spot


def test_the_head_looks_at_a_place_as_far_as_it_turns() -> None:
    assert look_at(Pose(0, 0, 0), Point(0, 50)) == 90
    assert look_at(Pose(0, 0, 90), Point(0, 50)) == 0
    assert look_at(Pose(0, 0, 0), Point(-50, 1)) == limits.HEAD_LIMIT


def test_where_the_ball_is_on_the_field() -> None:
    assert ball_place(percept()) is None
    place = ball_place(percept(Pose(100, 0, 90), BallSeen(50, 90)))
    assert place is not None
    assert (place.x, place.y) == pytest.approx((50, 0))
    assert gap(limits.TOUCH + 3) == pytest.approx(3)
    assert gap(5) == 0


def test_a_shot_goes_where_there_is_room() -> None:
    ball = Point(300, 0)
    assert aim(percept(Pose(280, 0)), ball) == OPPONENTS_GOAL
    keeper = RobotSeen(False, 1, 150, 0)
    beside = aim(percept(Pose(280, 0), robots=(keeper,)), ball)
    assert beside.x == HALF_LENGTH
    assert 20 < abs(beside.y) < GOAL_HALF_WIDTH
    behind = RobotSeen(False, 1, 150, 180)
    assert aim(percept(Pose(280, 0), robots=(behind,)), ball) == OPPONENTS_GOAL
    cross = aim(percept(Pose(440, 280)), Point(445, 295))
    assert cross == Point(320, 0)


def test_an_attacker_kicks_when_it_can_and_gets_up_when_it_must() -> None:
    ball, behind = Point(18, 0), Pose(0, 0, 0)
    assert isinstance(attack(percept(behind, at_feet=True), ball), Kick)
    assert isinstance(attack(percept(behind), ball), Walk)
    assert isinstance(attack(percept(behind, at_feet=True, busy=True), ball), Walk)
    assert isinstance(attack(percept(Pose(36, 0, 180), at_feet=True), ball), Walk)
    assert attack(percept(behind, at_feet=True, posture=Posture.FALLEN), ball) == Stand()
    assert recover(percept()) is None
    assert recover(percept(posture=Posture.SITTING)) == Stand()
    assert recover(percept(posture=Posture.FALLEN, busy=True)) is None
    assert can_kick(percept(behind, at_feet=True), ball, OPPONENTS_GOAL)
    off = GameSeen(PlayerState.PLAYING, PlayerState.PLAYING, 1, 60, 0, 0, True, SetPlay.KICK_OFF, True)
    straight = attack(percept(behind, at_feet=True), ball)
    gentle = attack(percept(behind, at_feet=True, game=off), ball)
    assert isinstance(straight, Kick) and isinstance(gentle, Kick)
    assert gentle.strength < 0.7 < straight.strength


def test_kicks_for_every_purpose() -> None:
    pose, ball = Pose(0, 0, 10), Point(18, 0)
    assert kick(pose, ball, Point(118, 0)).direction == pytest.approx(-10)
    assert shoot(pose, ball).strength == 1
    gentle = pass_to(pose, ball, Pose(100, 50, 0))
    assert gentle.strength < 0.6
    assert gentle.direction == pytest.approx(21.4, abs=0.1)
    assert clear(Pose(-400, 0, 0), Point(-380, 100)).direction == limits.KICK_ANGLE
    assert kick(Pose(0, 0, 180), ball, Point(118, 0)).direction in (limits.KICK_ANGLE, -limits.KICK_ANGLE)


def test_a_robot_in_the_way_is_passed() -> None:
    walk = Walk(40, 0, 0)
    left, right = (RobotSeen(False, 1, 35, aside) for aside in (10.0, -10.0))
    assert avoid(walk, (left,)).left < 0
    assert avoid(walk, (right,)).left > 0
    assert avoid(walk, ()) == walk
    assert avoid(walk, (RobotSeen(False, 1, 100, 0),)) == walk
    assert avoid(walk, (RobotSeen(False, 1, 35, 120),)) == walk
    assert avoid(walk, (left,), ball_distance=20) == walk
    assert avoid(Walk(-10), (left,)) == Walk(-10)


@given(POSES, st.builds(Point, X, Y))
def test_the_nearer_the_sooner(pose: Pose, ball: Point) -> None:
    assert seconds_to_ball(pose, ball) >= distance(pose, ball) / limits.FORWARD_SPEED
    facing = Pose(pose.x, pose.y, wrap(pose.heading + 180))
    assert abs(seconds_to_ball(pose, ball) - seconds_to_ball(facing, ball)) <= 2.01


@given(st.builds(Point, st.floats(-455, 455), st.floats(-305, 305)), st.integers(0, 20))
def test_players_wait_on_the_field_and_keepers_before_their_goal(ball: Point, number: int) -> None:
    place = support_place(ball, number)
    assert on_field(place.point)
    keeper = keeper_place(ball)
    assert in_own_penalty_area(keeper.point)
    assert abs(keeper.y) < GOAL_HALF_WIDTH
    others = {support_place(ball, one).point for one in range(3)}
    assert len(others) == 3
    assert length(place.x, place.y) > 0 or place.x == 0
