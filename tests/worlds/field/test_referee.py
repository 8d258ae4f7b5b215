"""The rules of the game, as a whole match shows them."""

from __future__ import annotations

import random

import pytest

from aseme_dsl.worlds.field.ball import RADIUS
from aseme_dsl.worlds.field.command import Command, Dive, Kick, Motion, Sit, Stand, Walk
from aseme_dsl.worlds.field.event import Event, EventKind, clock
from aseme_dsl.worlds.field.field import GOAL_HALF_WIDTH, HALF_LENGTH, HALF_WIDTH
from aseme_dsl.worlds.field.geometry import Point, Pose, distance, length
from aseme_dsl.worlds.field.match import NOBODY, STEP_NS, Match
from aseme_dsl.worlds.field.percept import PlayerState, Posture, SetPlay
from aseme_dsl.worlds.field.referee import CORNER_INSET, KEEP_OUT, Rules
from aseme_dsl.worlds.field.team import TeamSheet, team_sheet

SECOND = 1_000_000_000
HOME = team_sheet(1, "Home", ["h1", "h2"], "hk")
AWAY = team_sheet(2, "Away", ["a1", "a2"], "ak")
LONG = Rules(initial_ns=0, ready_ns=0, set_ns=0, half_ns=600 * SECOND)


def playing(home: TeamSheet = HOME, away: TeamSheet = AWAY, rules: Rules = LONG, seed: int = 1) -> Match:
    """A match that has been kicked off, with everybody far from the ball, which nobody has touched."""
    match = Match(seed, home, away, rules)
    while match.truth().state is not PlayerState.PLAYING:
        match.advance(match.now_ns + STEP_NS)
    for index, robot in enumerate(match.truth().robots):
        side = -1 if robot.team == 0 else 1
        match.put_robot(robot.name, Pose(side * (100 + 50 * index), 280 * side))
    match.put_ball(Point(0, 0))
    return match


def touch(match: Match, name: str, spot: Point, heading: float) -> None:
    """Let a robot touch the ball: it stands right at it and pushes it a little."""
    x, y = spot.x, spot.y
    match.put_robot(name, Pose(x - 16.9, y, 0) if heading == 0 else Pose(x + 16.9, y, 180))
    match.put_ball(spot)
    match.advance(match.now_ns + STEP_NS)
    side = -1 if name.startswith("h") else 1
    match.put_robot(name, Pose(side * 100, -200))


def roll_after_touch(match: Match, name: str, spot: Point, vx: float, vy: float) -> list[Event]:
    """Let a robot touch the ball, then let it roll; what the referee notes about it."""
    touch(match, name, spot, 0)
    noted = len(match.events)
    # Not put_ball: the touch must count.
    match._ball.vx, match._ball.vy = vx, vy
    match.advance(match.now_ns + 4 * SECOND)
    return list(match.events[noted:])


def kinds(events: list[Event]) -> list[EventKind]:
    return [event.kind for event in events]


# ---- the states of the game -----------------------------------------------------------------------------


def test_a_match_goes_through_its_states_in_time_and_ends() -> None:
    rules = Rules(
        initial_ns=2 * SECOND, ready_ns=5 * SECOND, set_ns=3 * SECOND, half_ns=20 * SECOND, halves=2
    )
    match = Match(1, HOME, NOBODY, rules)
    match.advance(rules.match_ns - STEP_NS)
    assert not match.over
    match.advance(rules.match_ns)
    assert match.over
    match.advance(rules.match_ns + 10 * SECOND)
    states = [(e.time_ns // SECOND, e.detail) for e in match.events if e.kind is EventKind.STATE]
    assert states == [
        (0, "INITIAL"),
        (2, "READY"),
        (7, "SET"),
        (10, "PLAYING"),
        (30, "INITIAL"),
        (32, "READY"),
        (37, "SET"),
        (40, "PLAYING"),
        (60, "FINISHED"),
    ]
    assert kinds(list(match.events)).count(EventKind.HALF_TIME) == 1
    assert match.events[-2].kind is EventKind.FULL_TIME
    kick_offs = [e.team for e in match.events if e.kind is EventKind.KICK_OFF]
    assert kick_offs == ["Home", "Nobody"]


def test_the_players_see_the_state_of_the_game_and_the_clock() -> None:
    match = Match(1, HOME, AWAY, Rules(half_ns=20 * SECOND))
    body = match.bodies["a1"]
    seen: list[tuple[PlayerState, int, int]] = []
    while not match.over:
        match.advance(match.now_ns + 3 * STEP_NS)
        game = body.sense().game
        if not seen or seen[-1] != (game.state, game.half, game.seconds_remaining):
            seen.append((game.state, game.half, game.seconds_remaining))
    played = [remaining for state, half, remaining in seen if state is PlayerState.PLAYING and half == 2]
    assert played == list(range(20, 0, -1))
    assert seen[0] == (PlayerState.INITIAL, 1, 20)
    assert seen[-1][0] is PlayerState.FINISHED


def test_nobody_walks_before_the_game_or_after_it() -> None:
    match = Match(1, HOME, AWAY, Rules(half_ns=2 * SECOND, halves=1))
    for body in match.bodies.values():
        body.act(Command(Walk(forward=30)))
    before = match.truth()
    match.advance(900_000_000)
    assert [r.pose for r in match.truth().robots] == [r.pose for r in before.robots]
    match.advance(8 * SECOND)
    assert [r.pose for r in match.truth().robots] != [r.pose for r in before.robots]
    match.advance(9 * SECOND + 500_000_000)
    placed = match.truth()
    assert placed.state is PlayerState.SET
    match.advance(9 * SECOND + 900_000_000)
    assert [r.pose for r in match.truth().robots] == [r.pose for r in placed.robots]
    match.advance(match.rules.match_ns + SECOND)
    end = match.truth()
    match.advance(match.now_ns + 3 * SECOND)
    assert [r.pose for r in match.truth().robots] == [r.pose for r in end.robots]


def test_whoever_sleeps_in_ready_is_placed_legally_and_who_walked_stays() -> None:
    match = Match(1, HOME, AWAY, Rules())
    match.advance(4 * SECOND)
    match.put_robot("h2", Pose(-200, 33, 5))
    match.advance(9 * SECOND + STEP_NS)
    assert sorted(e.robot for e in match.events if e.kind is EventKind.PLACED) == [
        "a1",
        "a2",
        "ak",
        "h1",
        "hk",
    ]
    truth = match.truth()
    for robot in truth.robots:
        x = robot.pose.x if robot.team == 0 else -robot.pose.x
        assert x <= 0
        if robot.team == 1:
            assert length(robot.pose.x, robot.pose.y) >= 75
        if robot.name == "h2":
            assert robot.pose == Pose(-200, 33, 5)
        else:
            assert (
                distance(robot.pose, match.bodies[robot.name].sense().kick_off_place) < 1 or robot.team == 1
            )


# ---- goals ----------------------------------------------------------------------------------------------


def test_a_goal_counts_for_who_shot_it_and_the_others_kick_off() -> None:
    match = playing()
    noted = roll_after_touch(match, "h1", Point(300, 20), 150, 0)
    assert kinds(noted)[:2] == [EventKind.GOAL, EventKind.STATE]
    goal = noted[0]
    assert (goal.team, goal.robot, goal.detail, goal.score) == ("Home", "h1", "", (1, 0))
    assert goal.x > HALF_LENGTH + RADIUS
    assert str(goal) == f"{clock(goal.time_ns)} goal for Home by h1 1:0"
    result = match.result()
    assert (str(result), result.goals, result.over) == ("Home 1:0 Away", (goal,), False)
    assert noted[-1].kind is EventKind.KICK_OFF
    assert noted[-1].team == "Away"
    own, other = match.bodies["h1"].sense().game, match.bodies["a1"].sense().game
    assert (own.own_score, own.other_score, own.own_kick_off) == (1, 0, False)
    assert (other.own_score, other.other_score, other.own_kick_off) == (0, 1, True)


def test_a_goal_off_a_defender_is_the_attacker_s_and_an_own_goal_is_not() -> None:
    match = playing()
    touch(match, "a1", Point(-250, 0), 180)
    assert match._referee.touched_by is not None
    match._referee.touched_before_by, match._referee.touched_by = match._referee.touched_by, match._robots[2]
    match._ball.x, match._ball.vx = -400, -200
    match.put_robot("hk", Pose(-300, 200))
    match.advance(match.now_ns + SECOND)
    goal = match.result().goals[0]
    assert (goal.team, goal.robot, goal.detail) == ("Away", "a1", "off hk")

    match = playing()
    noted = roll_after_touch(match, "h2", Point(-350, 0), -200, 0)
    assert (noted[0].team, noted[0].robot, noted[0].detail) == ("Away", "h2", "own goal")


def test_a_shot_straight_from_the_kick_off_does_not_count() -> None:
    rules = Rules(half_ns=60 * SECOND)
    match = Match(1, team_sheet(1, "Home", ["h1"]), NOBODY, rules)
    match.advance(9 * SECOND)
    match.put_robot("h1", Pose(-18, 0, 0))
    match.bodies["h1"].act(Command(Kick(1.0)))
    match.advance(16 * SECOND)
    noted = kinds(list(match.events))
    assert EventKind.NO_GOAL in noted
    assert EventKind.GOAL not in noted
    assert match.result().score == (0, 0)
    assert match.bodies["h1"].sense().game.set_play is SetPlay.GOAL_KICK


@pytest.mark.parametrize("y", [-70.0, -40.0, 0.0, 69.0])
def test_the_goal_is_between_the_posts(y: float) -> None:
    match = playing(away=NOBODY)
    match.put_ball(Point(420, y), 150, 0)
    match.advance(match.now_ns + SECOND)
    assert match.result().score == ((1, 0) if abs(y) < GOAL_HALF_WIDTH - 10 else (0, 0))


def test_a_ball_that_hits_a_post_comes_back() -> None:
    match = playing(away=NOBODY)
    match.put_ball(Point(400, GOAL_HALF_WIDTH), 150, 0)
    match.advance(match.now_ns + 2 * SECOND)
    assert match.result().score == (0, 0)
    assert EventKind.OUT not in kinds(list(match.events))
    assert match.truth().ball.x < 440


# ---- out of bounds --------------------------------------------------------------------------------------


def test_over_the_side_line_the_other_team_kicks_in() -> None:
    match = playing()
    noted = roll_after_touch(match, "h1", Point(120, 200), 10, 150)
    assert kinds(noted) == [EventKind.OUT, EventKind.SET_PLAY]
    assert (noted[0].team, noted[0].robot, noted[0].detail) == ("Home", "h1", "side line")
    assert (noted[1].team, noted[1].detail) == ("Away", "kick in")
    ball = match.truth().ball
    assert ball.y == HALF_WIDTH
    assert 120 < ball.x < 140
    assert (ball.vx, ball.vy) == (0, 0)
    game = match.bodies["a1"].sense().game
    assert (game.set_play, game.own_set_play) == (SetPlay.KICK_IN, True)
    assert not match.bodies["h1"].sense().game.own_set_play


@pytest.mark.parametrize(
    ("name", "x", "detail", "taker"),
    [
        ("h1", 1, "goal kick", "Away"),
        ("a1", 1, "corner kick", "Home"),
        ("h1", -1, "corner kick", "Away"),
        ("a1", -1, "goal kick", "Home"),
    ],
)
def test_over_the_goal_line_it_is_a_corner_or_a_goal_kick(name: str, x: int, detail: str, taker: str) -> None:
    match = playing()
    noted = roll_after_touch(match, name, Point(x * 380, -200), x * 150, -20)
    assert kinds(noted) == [EventKind.OUT, EventKind.SET_PLAY]
    assert (noted[1].team, noted[1].detail) == (taker, detail)
    ball = match.truth().ball
    if detail == "corner kick":
        assert (ball.x, ball.y) == (x * (HALF_LENGTH - CORNER_INSET), -(HALF_WIDTH - CORNER_INSET))
    else:
        assert (ball.x, ball.y) == (x * 390, -110)


def test_in_a_set_play_the_others_keep_their_distance_until_the_ball_is_touched_or_time_is_up() -> None:
    match = playing()
    roll_after_touch(match, "h1", Point(120, 200), 10, 150)
    spot = match.truth().ball
    match.put_robot("h1", Pose(spot.x, 200, 90))
    match.put_robot("a1", Pose(spot.x - 60, spot.y, 0))
    match.bodies["h1"].act(Command(Walk(forward=40)))
    since_ns = next(e.time_ns for e in match.events if e.kind is EventKind.SET_PLAY)
    while match.now_ns < since_ns + 10 * SECOND - STEP_NS:
        match.advance(match.now_ns + STEP_NS)
        pose = next(r.pose for r in match.truth().robots if r.name == "h1")
        assert length(pose.x - spot.x, pose.y - spot.y) >= KEEP_OUT - 1
    assert match.bodies["a1"].sense().game.set_play is SetPlay.KICK_IN
    assert match._referee.touched_by is None
    match.advance(match.now_ns + 10 * STEP_NS)
    game = match.bodies["h1"].sense().game
    assert game.set_play is SetPlay.NONE
    match.advance(match.now_ns + 2 * SECOND)
    assert match.events[-2].robot == "h1", "it has pushed the ball out again"


def test_a_touch_ends_the_set_play() -> None:
    match = playing()
    roll_after_touch(match, "h1", Point(120, 200), 10, 150)
    spot = match.truth().ball
    match.put_robot("a1", Pose(spot.x + 17.5, spot.y, 180))
    match.bodies["a1"].act(Command(Walk(forward=5)))
    assert match.bodies["h1"].sense().game.set_play is SetPlay.KICK_IN
    match.advance(match.now_ns + SECOND)
    assert match.bodies["h1"].sense().game.set_play is SetPlay.NONE


def test_a_ball_is_not_laid_down_on_a_robot() -> None:
    match = playing()
    match.put_robot("a2", Pose(392, -112, 0))
    noted = roll_after_touch(match, "h1", Point(380, -200), 150, -20)
    assert (noted[-1].team, noted[-1].detail) == ("Away", "goal kick")
    assert match._referee.touched_by is None
    assert (match.truth().ball.x, match.truth().ball.y) == (390, -110)


def test_a_ball_between_both_teams_that_nobody_can_move_is_dropped_in_the_middle() -> None:
    match = playing()
    match.put_robot("h1", Pose(180, 100))
    match.put_robot("a1", Pose(220, 100, 180))
    match.put_ball(Point(200, 100))
    match.advance(match.now_ns + 30 * SECOND)
    assert EventKind.DROPPED_BALL in kinds(list(match.events))
    assert abs(match.truth().ball.x) < 1


def test_a_ball_that_nobody_goes_for_is_left_alone() -> None:
    match = playing()
    match.put_ball(Point(100, 50))
    match.advance(match.now_ns + 60 * SECOND)
    assert EventKind.DROPPED_BALL not in kinds(list(match.events))


# ---- penalties ------------------------------------------------------------------------------------------


def penalties(match: Match) -> list[tuple[str, str]]:
    return [(e.robot, e.detail) for e in match.events if e.kind is EventKind.PENALTY]


def test_who_pushes_an_opponent_away_from_the_ball_is_taken_out_and_comes_back() -> None:
    match = playing()
    match.put_robot("h1", Pose(-200, 150, 0))
    match.put_robot("a1", Pose(-170, 150, 180))
    match.bodies["h1"].act(Command(Walk(forward=20)))
    match.advance(match.now_ns + 4 * SECOND)
    assert penalties(match) == [("h1", "pushing")]
    percept = match.bodies["h1"].sense()
    assert (percept.game.state, percept.game.game_state) == (PlayerState.PENALISED, PlayerState.PLAYING)
    assert percept.ball is None
    truth = next(r for r in match.truth().robots if r.name == "h1")
    assert truth.penalised
    assert abs(truth.pose.y) > HALF_WIDTH
    match.advance(match.now_ns + 9 * SECOND)
    returned = [e for e in match.events if e.kind is EventKind.RETURN]
    assert [e.robot for e in returned] == ["h1"]
    assert match.bodies["h1"].sense().game.state is PlayerState.PLAYING
    truth = next(r for r in match.truth().robots if r.name == "h1")
    assert not truth.penalised


def test_a_fight_for_the_ball_is_no_foul() -> None:
    match = playing()
    match.put_robot("h1", Pose(-200, 150, 0))
    match.put_robot("a1", Pose(-170, 150, 180))
    match.put_ball(Point(-185, 175))
    match.bodies["h1"].act(Command(Walk(forward=20)))
    match.advance(match.now_ns + 3 * SECOND)
    assert penalties(match) == []


def test_who_leaves_the_field_is_taken_out() -> None:
    match = playing()
    match.put_robot("h2", Pose(-200, 280, 90))
    match.bodies["h2"].act(Command(Walk(forward=40)))
    match.advance(match.now_ns + 4 * SECOND)
    assert penalties(match) == [("h2", "leaving the field")]


def test_who_does_not_get_up_is_taken_out_and_comes_back_on_its_feet() -> None:
    match = playing()
    match.put_robot("h2", Pose(-200, 100), Posture.FALLEN)
    match.advance(match.now_ns + 16 * SECOND)
    assert penalties(match) == [("h2", "incapable")]
    match.advance(match.now_ns + 11 * SECOND)
    assert match.bodies["h2"].sense().posture is Posture.STANDING


def test_half_time_forgives() -> None:
    match = playing(rules=Rules(initial_ns=0, ready_ns=0, set_ns=0, half_ns=8 * SECOND))
    match.put_robot("h2", Pose(-200, 280, 90))
    match.bodies["h2"].act(Command(Walk(forward=40)))
    match.advance(7 * SECOND)
    assert match.bodies["h2"].sense().game.state is PlayerState.PENALISED
    match.advance(9 * SECOND)
    assert match.bodies["h2"].sense().game.state is PlayerState.PLAYING


# ---- laws -----------------------------------------------------------------------------------------------


def wild_motion(chance: random.Random) -> Motion:
    kind = chance.randrange(8)
    if kind < 4:
        return Walk(chance.uniform(-20, 60), chance.uniform(-40, 40), chance.uniform(-90, 90))
    if kind < 6:
        return Kick(chance.uniform(0.1, 1), chance.uniform(-90, 90))
    return chance.choice((Stand(), Stand(), Sit(), Dive(left=chance.random() < 0.5)))


@pytest.mark.parametrize("seed", range(6))
def test_the_ball_never_leaves_without_the_referee_noticing(seed: int) -> None:
    match = Match(
        seed, HOME, AWAY, Rules(initial_ns=0, ready_ns=SECOND, set_ns=0, half_ns=60 * SECOND, halves=1)
    )
    chance = random.Random(seed)
    noted = 0
    outs = 0
    while not match.over:
        if match.now_ns % (20 * STEP_NS) == 0:
            for body in match.bodies.values():
                body.act(Command(wild_motion(chance), chance.uniform(-119, 119)))
        if match.now_ns % (150 * STEP_NS) == 0 and match.truth().state is PlayerState.PLAYING:
            spot = Point(chance.uniform(-440, 440), chance.uniform(-290, 290))
            match.put_ball(spot, chance.uniform(-400, 400), chance.uniform(-400, 400))
        before = match.truth().ball
        match.advance(match.now_ns + STEP_NS)
        ball = match.truth().ball
        # Whatever happens, the ball is on the field; where it jumped, the referee has said why.
        assert abs(ball.x) <= HALF_LENGTH + RADIUS
        assert abs(ball.y) <= HALF_WIDTH + RADIUS
        new = match.events[noted:]
        noted = len(match.events)
        if length(ball.x - before.x, ball.y - before.y) > 40:
            carried = {EventKind.GOAL, EventKind.NO_GOAL, EventKind.OUT, EventKind.DROPPED_BALL}
            carried |= {EventKind.KICK_OFF, EventKind.FULL_TIME}
            assert carried & {event.kind for event in new}
            outs += 1
        for robot in match.truth().robots:
            assert abs(robot.pose.x) <= HALF_LENGTH + 71
            assert abs(robot.pose.y) <= HALF_WIDTH + 71
    assert outs > 3
    score = [0, 0]
    for event in match.events:
        if event.kind is EventKind.GOAL:
            score[("Home", "Away").index(event.team)] += 1
            assert event.score == (score[0], score[1])
    assert match.result().score == (score[0], score[1])
    assert [event.time_ns for event in match.events] == sorted(event.time_ns for event in match.events)


@pytest.mark.parametrize(
    "times",
    [{"half_ns": 0}, {"halves": 0}, {"ready_ns": -1}, {"penalty_ns": -5}],
)
def test_rules_that_mean_nothing_are_refused(times: dict[str, int]) -> None:
    with pytest.raises(ValueError):
        Rules(**times)
