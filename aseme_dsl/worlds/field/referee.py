"""The referee: the states of the game, goals, balls out of bounds, set plays, penalties and the score.

After the rules of the Standard Platform League, in the parts that a game in the plane has. The teams do not
change sides at half-time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from aseme_dsl.worlds.field import ball as balls
from aseme_dsl.worlds.field.ball import Ball
from aseme_dsl.worlds.field.collision import Contact
from aseme_dsl.worlds.field.event import Event, EventKind
from aseme_dsl.worlds.field.field import (
    CENTRE_CIRCLE_RADIUS,
    GOAL_AREA_DEPTH,
    GOAL_AREA_HALF_WIDTH,
    GOAL_HALF_WIDTH,
    HALF_LENGTH,
    HALF_WIDTH,
)
from aseme_dsl.worlds.field.geometry import Pose, length, turned
from aseme_dsl.worlds.field.percept import GameSeen, PlayerState, Posture, SetPlay
from aseme_dsl.worlds.field.robot import DIVE_REACH, RADIUS, TOUCH, Robot
from aseme_dsl.worlds.field.team import TeamSheet, kick_off_places

SECOND = 1_000_000_000
MILLISECOND = 1_000_000

KEEP_OUT = 75.0
"""How far the other team stays from the ball in a set play, cm."""
CORNER_INSET = 5.0
"""A corner kick is taken this far from the lines, cm."""
LEAVING = 55.0
"""Who is further than this outside the lines has left the field, cm."""
STUCK_MOVE = 30.0
"""A ball that moves less than this with both teams around it is stuck, cm."""
SCRUM = 50.0
"""A robot this near to the ball is in the fight for it, cm."""
PUT_CLEARANCE = 3.0
"""No robot stands nearer than this to a ball that is laid down, cm."""
PUSH_SPEED = 8.0
"""Who walks into an opponent faster than this pushes, cm/s."""


@dataclass(frozen=True, slots=True)
class Rules:
    """How long everything takes, in ns. Raises ValueError for times that mean nothing."""

    initial_ns: int = 1 * SECOND
    """Before each half."""
    ready_ns: int = 8 * SECOND
    """For walking to the places of a kick-off."""
    set_ns: int = 1 * SECOND
    half_ns: int = 60 * SECOND
    """The playing time of a half; once it has begun, it runs on while the ball is out of play."""
    halves: int = 2
    set_play_ns: int = 10 * SECOND
    """After this time the other team may come near, although the ball has not been touched."""
    penalty_ns: int = 10 * SECOND
    push_ns: int = 1500 * MILLISECOND
    """Pushing an opponent away from the ball for so long is a foul."""
    incapable_ns: int = 15 * SECOND
    """Who lies for so long is taken out."""
    stuck_ns: int = 12 * SECOND

    def __post_init__(self) -> None:
        if self.half_ns <= 0 or self.halves < 1:
            raise ValueError("a match has at least one half, and a half some time")
        if min(self.initial_ns, self.ready_ns, self.set_ns, self.set_play_ns, self.penalty_ns) < 0:
            raise ValueError("a time of the rules is negative")

    @property
    def match_ns(self) -> int:
        """How long a whole match lasts. It is the same for all: the clock does not stop."""
        return self.halves * (self.initial_ns + self.ready_ns + self.set_ns + self.half_ns)


@dataclass(slots=True)
class _Watch:
    """What the referee remembers of one robot."""

    pushing_ns: int = 0
    fallen_ns: int = 0


@dataclass(slots=True)
class Referee:
    """The state of the game. Teams are 0 (home) and 1; places are those of the home team."""

    rules: Rules
    sheets: tuple[TeamSheet, TeamSheet]
    state: PlayerState = PlayerState.INITIAL
    since_ns: int = 0
    half: int = 1
    half_ends_ns: int | None = None
    kicking: int = 0
    """Whose the last kick-off was, or the coming one is."""
    score: list[int] = field(default_factory=lambda: [0, 0])
    set_play: SetPlay = SetPlay.NONE
    set_play_team: int = 0
    set_play_since_ns: int = 0
    straight_from_kick_off: bool = False
    """Only the robot of the kick-off, within the centre circle, has touched the ball."""
    touched_by: Robot | None = None
    """Who touched the ball last since it was put down …"""
    touched_before_by: Robot | None = None
    """… and the last of the other team before."""
    stuck_x: float = 0.0
    stuck_y: float = 0.0
    stuck_since_ns: int = 0
    events: list[Event] = field(default_factory=list)
    watches: dict[str, _Watch] = field(default_factory=dict)

    @property
    def playing(self) -> bool:
        """Whether the ball may be played."""
        return self.state is PlayerState.PLAYING

    @property
    def walking(self) -> bool:
        """Whether the players may leave their places."""
        return self.state is PlayerState.PLAYING or self.state is PlayerState.READY

    def note(self, time_ns: int, kind: EventKind, ball: Ball | Robot, **what: str) -> None:
        """Write down what happened."""
        self.events.append(
            Event(time_ns, kind, x=ball.x, y=ball.y, score=(self.score[0], self.score[1]), **what)
        )

    def seen_by(self, team: int, penalised: bool, now_ns: int) -> GameSeen:
        """What the referee signals to a player of a team."""
        remaining_ns = self.rules.half_ns if self.half_ends_ns is None else max(0, self.half_ends_ns - now_ns)
        return GameSeen(
            state=PlayerState.PENALISED
            if penalised and self.state is not PlayerState.FINISHED
            else self.state,
            game_state=self.state,
            half=self.half,
            seconds_remaining=-(-remaining_ns // SECOND),
            own_score=self.score[team],
            other_score=self.score[1 - team],
            own_kick_off=self.kicking == team,
            set_play=self.set_play,
            own_set_play=self.set_play is not SetPlay.NONE and self.set_play_team == team,
        )


def open_match(referee: Referee, robots: Sequence[Robot], ball: Ball) -> None:
    """Put the players beside their half of the field and the ball into the middle, before the match."""
    _line_up_outside(robots)
    ball.put(0.0, 0.0)
    for robot in robots:
        referee.watches[robot.name] = _Watch()
    referee.note(0, EventKind.STATE, ball, detail=referee.state.name)


def keep_distance(referee: Referee, ball: Ball, robots: Sequence[Robot]) -> None:
    """Keep the team that does not take the set play away from the ball."""
    for robot in robots:
        if robot.team == referee.set_play_team or robot.penalised:
            continue
        if referee.set_play is SetPlay.KICK_OFF:
            if robot.team == 0 and robot.x > -RADIUS:
                robot.x = -RADIUS
            elif robot.team == 1 and robot.x < RADIUS:
                robot.x = RADIUS
        dx, dy = robot.x - ball.x, robot.y - ball.y
        away = length(dx, dy)
        if away < KEEP_OUT:
            if away == 0.0:
                dx, away = (-1.0 if robot.team == 0 else 1.0), 1.0
            robot.x = ball.x + dx / away * KEEP_OUT
            robot.y = ball.y + dy / away * KEEP_OUT


def touched(referee: Referee, robot: Robot, ball: Ball) -> None:
    """A robot touched the ball."""
    last = referee.touched_by
    if referee.straight_from_kick_off and last is not None:
        outside = length(ball.x, ball.y) > CENTRE_CIRCLE_RADIUS
        if robot is not last or outside:
            referee.straight_from_kick_off = False
    if last is not None and last.team != robot.team:
        referee.touched_before_by = last
    referee.touched_by = robot
    referee.set_play = SetPlay.NONE


def watch(
    referee: Referee,
    now_ns: int,
    step_ns: int,
    ball: Ball,
    before: tuple[float, float],
    robots: Sequence[Robot],
    contacts: Sequence[Contact],
) -> None:
    """Look at the field after the step that ends at ``now_ns``; the ball came from ``before``."""
    if referee.state is PlayerState.FINISHED:
        return
    if referee.half_ends_ns is not None and now_ns >= referee.half_ends_ns:
        _end_half(referee, now_ns, ball, robots)
        return
    for robot in robots:
        if robot.penalised_until_ns is not None and now_ns >= robot.penalised_until_ns:
            _bring_back(referee, now_ns, robot, robots)
    passed = now_ns - referee.since_ns
    rules = referee.rules
    if referee.state is PlayerState.INITIAL:
        if passed >= rules.initial_ns:
            _enter(referee, now_ns, PlayerState.READY, ball)
    elif referee.state is PlayerState.READY:
        if passed >= rules.ready_ns:
            _place_all(referee, now_ns, robots)
            _enter(referee, now_ns, PlayerState.SET, ball)
    elif referee.state is PlayerState.SET:
        if passed >= rules.set_ns:
            _kick_off(referee, now_ns, ball, robots)
    else:
        _watch_play(referee, now_ns, step_ns, ball, before, robots, contacts)


def _enter(referee: Referee, now_ns: int, state: PlayerState, ball: Ball) -> None:
    referee.state, referee.since_ns = state, now_ns
    referee.set_play = SetPlay.NONE
    referee.note(now_ns, EventKind.STATE, ball, detail=state.name)


def _kick_off(referee: Referee, now_ns: int, ball: Ball, robots: Sequence[Robot]) -> None:
    _enter(referee, now_ns, PlayerState.PLAYING, ball)
    if referee.half_ends_ns is None:
        referee.half_ends_ns = now_ns + referee.rules.half_ns
    _put_ball(referee, now_ns, ball, 0.0, 0.0, robots)
    referee.straight_from_kick_off = True
    referee.set_play, referee.set_play_team = SetPlay.KICK_OFF, referee.kicking
    referee.note(now_ns, EventKind.KICK_OFF, ball, team=referee.sheets[referee.kicking].name)


def _end_half(referee: Referee, now_ns: int, ball: Ball, robots: Sequence[Robot]) -> None:
    ball.put(0.0, 0.0)
    referee.half_ends_ns = None
    for robot in robots:
        robot.penalised_until_ns = None
    if referee.half == referee.rules.halves:
        referee.note(now_ns, EventKind.FULL_TIME, ball)
        _enter(referee, now_ns, PlayerState.FINISHED, ball)
        return
    referee.half += 1
    referee.kicking = (referee.half - 1) % 2
    referee.note(now_ns, EventKind.HALF_TIME, ball)
    _line_up_outside(robots)
    _enter(referee, now_ns, PlayerState.INITIAL, ball)


def _watch_play(
    referee: Referee,
    now_ns: int,
    step_ns: int,
    ball: Ball,
    before: tuple[float, float],
    robots: Sequence[Robot],
    contacts: Sequence[Contact],
) -> None:
    if (
        referee.set_play is not SetPlay.NONE
        and now_ns - referee.set_play_since_ns >= referee.rules.set_play_ns
    ):
        referee.set_play = SetPlay.NONE
    if abs(ball.x) > HALF_LENGTH + balls.RADIUS or abs(ball.y) > HALF_WIDTH + balls.RADIUS:
        _ball_out(referee, now_ns, ball, before, robots)
    elif abs(ball.x - referee.stuck_x) > STUCK_MOVE or abs(ball.y - referee.stuck_y) > STUCK_MOVE:
        referee.stuck_x, referee.stuck_y, referee.stuck_since_ns = ball.x, ball.y, now_ns
    elif now_ns - referee.stuck_since_ns >= referee.rules.stuck_ns:
        if len({robot.team for robot in robots if _in_scrum(robot, ball)}) == 2:
            _put_ball(referee, now_ns, ball, 0.0, 0.0, robots)
            referee.note(now_ns, EventKind.DROPPED_BALL, ball)
        referee.stuck_since_ns = now_ns
    _watch_robots(referee, now_ns, step_ns, ball, robots, contacts)


def _in_scrum(robot: Robot, ball: Ball) -> bool:
    return not robot.penalised and length(robot.x - ball.x, robot.y - ball.y) <= SCRUM


def _ball_out(
    referee: Referee, now_ns: int, ball: Ball, before: tuple[float, float], robots: Sequence[Robot]
) -> None:
    """The whole ball is over a line: a goal, or it is put back for the other team."""
    x, y, over = _crossing(ball, before)
    side = 1 if x > 0.0 else -1
    attacking = 0 if side > 0 else 1
    last = referee.touched_by
    if over == "goal line" and abs(y) < GOAL_HALF_WIDTH:
        if referee.straight_from_kick_off and last is not None and last.team == attacking:
            referee.note(
                now_ns, EventKind.NO_GOAL, ball, team=referee.sheets[attacking].name, robot=last.name
            )
        else:
            _goal(referee, now_ns, ball, attacking, robots)
            return
    else:
        who = {} if last is None else {"team": referee.sheets[last.team].name, "robot": last.name}
        referee.note(now_ns, EventKind.OUT, ball, detail=over, **who)
    # No robot touched it since it was put down: it was lying there for the team of the set play.
    taker = referee.set_play_team if last is None else 1 - last.team
    y_side = 1.0 if y > 0.0 else -1.0
    if over == "side line":
        what = SetPlay.KICK_IN
        x = min(max(x, CORNER_INSET - HALF_LENGTH), HALF_LENGTH - CORNER_INSET)
        y = HALF_WIDTH * y_side
    elif taker == attacking:
        what = SetPlay.CORNER_KICK
        x, y = (HALF_LENGTH - CORNER_INSET) * side, (HALF_WIDTH - CORNER_INSET) * y_side
    else:
        what = SetPlay.GOAL_KICK
        x, y = (HALF_LENGTH - GOAL_AREA_DEPTH) * side, GOAL_AREA_HALF_WIDTH * y_side
    _put_ball(referee, now_ns, ball, x, y, robots)
    referee.set_play, referee.set_play_team = what, taker
    detail = what.name.lower().replace("_", " ")
    referee.note(now_ns, EventKind.SET_PLAY, ball, team=referee.sheets[taker].name, detail=detail)


def _crossing(ball: Ball, before: tuple[float, float]) -> tuple[float, float, str]:
    """Where the whole ball went over which line, if it went straight: the line it crossed first."""
    shares: list[tuple[float, str]] = []
    for was, is_, limit, line in (
        (before[0], ball.x, HALF_LENGTH + balls.RADIUS, "goal line"),
        (before[1], ball.y, HALF_WIDTH + balls.RADIUS, "side line"),
    ):
        if abs(is_) > limit:
            target = limit if is_ > 0.0 else -limit
            # It may have been pushed, so that it was out before it rolled: then it crossed at once.
            share = 0.0 if abs(was) > limit or was == is_ else (target - was) / (is_ - was)
            shares.append((share, line))
    share, line = min(shares)
    return before[0] + share * (ball.x - before[0]), before[1] + share * (ball.y - before[1]), line


def _goal(referee: Referee, now_ns: int, ball: Ball, scoring: int, robots: Sequence[Robot]) -> None:
    referee.score[scoring] += 1
    last, before = referee.touched_by, referee.touched_before_by
    team = referee.sheets[scoring].name
    if last is None or last.team == scoring:
        referee.note(now_ns, EventKind.GOAL, ball, team=team, robot="" if last is None else last.name)
    elif before is not None:
        detail = f"off {last.name}"
        referee.note(now_ns, EventKind.GOAL, ball, team=team, robot=before.name, detail=detail)
    else:
        referee.note(now_ns, EventKind.GOAL, ball, team=team, robot=last.name, detail="own goal")
    referee.kicking = 1 - scoring
    _put_ball(referee, now_ns, ball, 0.0, 0.0, robots)
    _enter(referee, now_ns, PlayerState.READY, ball)


def _put_ball(referee: Referee, now_ns: int, ball: Ball, x: float, y: float, robots: Sequence[Robot]) -> None:
    """Lay the ball down, and have robots that stand in its place step aside: they have not touched it."""
    ball.put(x, y)
    referee.touched_by = referee.touched_before_by = None
    referee.straight_from_kick_off = False
    referee.set_play_since_ns = referee.stuck_since_ns = now_ns
    referee.stuck_x, referee.stuck_y = x, y
    for robot in robots:
        clear = TOUCH + PUT_CLEARANCE + (DIVE_REACH if robot.dived else 0.0)
        dx, dy = robot.x - x, robot.y - y
        away = length(dx, dy)
        if away < clear and not robot.penalised:
            if away == 0.0:
                dx, away = (-1.0 if robot.team == 0 else 1.0), 1.0
            robot.x, robot.y = x + dx / away * clear, y + dy / away * clear


def _watch_robots(
    referee: Referee,
    now_ns: int,
    step_ns: int,
    ball: Ball,
    robots: Sequence[Robot],
    contacts: Sequence[Contact],
) -> None:
    pushing: set[str] = set()
    for contact in contacts:
        one, other = contact.one, contact.other
        if one.team == other.team or _in_scrum(one, ball) or _in_scrum(other, ball):
            continue
        if contact.one_pushes > PUSH_SPEED and contact.one_pushes > contact.other_pushes:
            pushing.add(one.name)
        elif contact.other_pushes > PUSH_SPEED and contact.other_pushes > contact.one_pushes:
            pushing.add(other.name)
    rules = referee.rules
    for robot in robots:
        if robot.penalised:
            continue
        memory = referee.watches[robot.name]
        memory.pushing_ns = memory.pushing_ns + step_ns if robot.name in pushing else 0
        memory.fallen_ns = memory.fallen_ns + step_ns if robot.posture is Posture.FALLEN else 0
        if memory.pushing_ns >= rules.push_ns:
            _penalise(referee, now_ns, robot, robots, "pushing")
        elif memory.fallen_ns >= rules.incapable_ns:
            _penalise(referee, now_ns, robot, robots, "incapable")
        elif abs(robot.x) > HALF_LENGTH + LEAVING or abs(robot.y) > HALF_WIDTH + LEAVING:
            _penalise(referee, now_ns, robot, robots, "leaving the field")


def _penalise(referee: Referee, now_ns: int, robot: Robot, robots: Sequence[Robot], why: str) -> None:
    referee.watches[robot.name] = _Watch()
    team = referee.sheets[robot.team].name
    referee.note(now_ns, EventKind.PENALTY, robot, team=team, robot=robot.name, detail=why)
    robot.penalised_until_ns = now_ns + referee.rules.penalty_ns
    robot.raise_up()
    robot.put(_outside(robot, robots, 60.0))


def _bring_back(referee: Referee, now_ns: int, robot: Robot, robots: Sequence[Robot]) -> None:
    """Set a robot onto the side line of its own half, where there is room."""
    robot.penalised_until_ns = None
    in_play = [other for other in robots if other is not robot and not other.penalised]
    places = [Pose(-130.0 - 30.0 * index, HALF_WIDTH, -90.0) for index in range(10)]
    robot.put(
        next(
            (pose for pose in _for_team(robot, places) if _room(pose, in_play)), _turned_for(robot, places[0])
        )
    )
    team = referee.sheets[robot.team].name
    referee.note(now_ns, EventKind.RETURN, robot, team=team, robot=robot.name)


def _line_up_outside(robots: Sequence[Robot]) -> None:
    """Put each robot beside its own half, looking at the field, the teams on opposite sides."""
    for robot in robots:
        robot.raise_up()
        robot.put(_outside(robot, robots, 20.0))


def _outside(robot: Robot, robots: Sequence[Robot], beyond: float) -> Pose:
    """A place of its own beside the team's half, ``beyond`` cm outside the line, looking at the field."""
    index = [other.name for other in robots if other.team == robot.team].index(robot.name)
    return _turned_for(robot, Pose(-60.0 - 50.0 * index, HALF_WIDTH + beyond, -90.0))


def _place_all(referee: Referee, now_ns: int, robots: Sequence[Robot]) -> None:
    """Put each robot that does not stand in a legal place for the kick-off into one."""
    in_play = [robot for robot in robots if not robot.penalised]
    astray = [robot for robot in in_play if not _legal(robot, referee.kicking)]
    standing = [robot for robot in in_play if robot not in astray]
    places = [kick_off_places(sheet, team == referee.kicking) for team, sheet in enumerate(referee.sheets)]
    for robot in astray:
        spots = [places[robot.team][robot.name], *places[robot.team].values()]
        spots += [Pose(-150.0, y) for y in (-200.0, 200.0, -250.0, 250.0, -280.0, 280.0)]
        robot.put(
            next(
                (pose for pose in _for_team(robot, spots) if _room(pose, standing)),
                _turned_for(robot, spots[0]),
            )
        )
        standing.append(robot)
        team = referee.sheets[robot.team].name
        referee.note(now_ns, EventKind.PLACED, robot, team=team, robot=robot.name)


def _legal(robot: Robot, kicking: int) -> bool:
    """Whether a robot stands in its own half, on the field, and away from the ball or out of the circle."""
    x = robot.x if robot.team == 0 else -robot.x
    clear = TOUCH if robot.team == kicking else CENTRE_CIRCLE_RADIUS
    own_half = -HALF_LENGTH <= x <= (0.0 if robot.team == kicking else -RADIUS)
    return own_half and abs(robot.y) <= HALF_WIDTH and length(robot.x, robot.y) >= clear


def _room(pose: Pose, robots: Sequence[Robot]) -> bool:
    return all(length(robot.x - pose.x, robot.y - pose.y) >= 2 * RADIUS for robot in robots)


def _turned_for(robot: Robot, pose: Pose) -> Pose:
    return pose if robot.team == 0 else turned(pose)


def _for_team(robot: Robot, poses: Sequence[Pose]) -> list[Pose]:
    return [_turned_for(robot, pose) for pose in poses]
