"""A match: the world in which two teams of robots play, step by step.

Everything random is drawn from one ``random.Random(seed)``. The order does not depend on the machine, nor on
how the time is cut into calls: one seed and the same commands give the same match to the bit.
A robot is driven only through its body; :meth:`Match.truth` is for tests and pictures.
"""

from __future__ import annotations

import random
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from aseme_dsl.runtime.world.body import RadioMessage
from aseme_dsl.worlds.field import opponent, vision
from aseme_dsl.worlds.field.ball import Ball, roll
from aseme_dsl.worlds.field.collision import Contact, keep_on_carpet, separate, touch_ball
from aseme_dsl.worlds.field.command import Command, Walk
from aseme_dsl.worlds.field.event import Event, EventKind
from aseme_dsl.worlds.field.geometry import Point, Pose, clamp, turned, unit, wrap
from aseme_dsl.worlds.field.noise import bell
from aseme_dsl.worlds.field.percept import GameSeen, Percept, PlayerState, Posture, SetPlay
from aseme_dsl.worlds.field.radio import Radio, RadioCount, RadioSettings
from aseme_dsl.worlds.field.referee import Referee, Rules, keep_distance, open_match, touched, watch
from aseme_dsl.worlds.field.robot import (
    KICK_ANGLE,
    KICK_ANGLE_NOISE,
    KICK_SPEED,
    KICK_STRENGTH_NOISE,
    Robot,
    at_feet,
    fall,
    kick_now,
    move,
    obey,
)
from aseme_dsl.worlds.field.team import TeamSheet, kick_off_places, team_sheet
from aseme_dsl.worlds.field.trail import Trail, TrailPoint

STEP_NS = 10_000_000
"""One step of the world."""
PICTURE_STEPS = 3
"""The cameras take a picture, and the bodies a percept, every so many steps."""
TRAIL_STEPS = 10
"""The path of the ball is noted every so many steps."""
TRAIL_POINTS = 18_000
"""So many of its points are kept, those of the last half an hour: longer than any match, but not for ever."""

PLACE_NOISE = 6.0
"""The standard deviation of each coordinate of the pose that a robot believes in, cm."""
HEADING_NOISE = 2.0
"""The same for its heading, degrees."""
FALL_SPEED = 25.0
"""Robots that run into each other faster than this may fall, cm/s …"""
FALL_PROBABILITY = 0.002
"""… each with this probability per step."""

# The error of the pose wanders: in one picture this much of it is kept, and the rest of its spread is new.
_ERROR_KEPT = 0.98
_ERROR_NEW = 0.19899748742132398  # √(1 − 0.98²)

HOME = team_sheet(1, "Home", ("robot1", "robot2", "robot3"), goalie="keeper")
"""The team that a match has if no other is named: three players and a goalie, driven through their bodies."""
VISITORS = team_sheet(
    2, "Visitors", ("visitor1", "visitor2", "visitor3"), goalie="visitor_keeper", scripted=True
)
"""A team that the field plays itself."""
NOBODY = TeamSheet(2, "Nobody", (), scripted=True)
"""A team without players, for training."""


@dataclass(frozen=True, slots=True)
class BallTruth:
    """Where the ball is and how it moves: cm and cm/s, as the home team sees the field."""

    x: float
    y: float
    vx: float
    vy: float


@dataclass(frozen=True, slots=True)
class RobotTruth:
    """Where a robot is and how it holds itself, as the home team sees the field."""

    name: str
    team: int
    """0: the home team, 1: the other."""
    jersey: int
    goalie: bool
    pose: Pose
    head: float
    posture: Posture
    penalised: bool


@dataclass(frozen=True, slots=True)
class Truth:
    """The world as it is: for tests and pictures, never for a body."""

    time_ns: int
    state: PlayerState
    ball: BallTruth
    robots: tuple[RobotTruth, ...]


@dataclass(frozen=True, slots=True)
class Result:
    """How a match stands."""

    teams: tuple[str, str]
    score: tuple[int, int]
    goals: tuple[Event, ...]
    over: bool

    def __str__(self) -> str:
        return f"{self.teams[0]} {self.score[0]}:{self.score[1]} {self.teams[1]}"


class FieldBody:
    """The body of one robot of the field: an ``aseme_dsl.runtime.world.body.Body[Percept, Command]``."""

    __slots__ = ("_commands", "_match", "_name", "_percept", "_radio")

    def __init__(self, match: Match, name: str, radio: Radio, percept: Percept) -> None:
        self._match = match
        self._name = name
        self._radio = radio
        self._percept = percept
        self._commands: deque[Command] = deque()

    @property
    def name(self) -> str:
        """The robot's name."""
        return self._name

    @property
    def payload_limit(self) -> int:
        """The longest payload in bytes that the radio takes."""
        return self._radio.settings.payload_limit

    def sense(self) -> Percept:
        """The newest percept."""
        return self._percept

    def act(self, command: Command) -> None:
        """Put a command in force from the next step on. Raises TypeError if it is not a command."""
        if not isinstance(command, Command):
            raise TypeError(f"a robot of the field obeys a Command, not {command!r}")
        self._commands.append(command)

    def say(self, payload: bytes) -> bool:
        """Send a message to the mates; False if too much was said lately, ValueError if it is too long."""
        return self._radio.say(self._name, payload, self._match.now_ns)

    def hear(self) -> list[RadioMessage]:
        """What arrived since the last call."""
        return self._radio.hear(self._name)


class Match:
    """A match between two teams: an ``aseme_dsl.runtime.world.body.World[Percept, Command]``.

    A scripted team plays by itself; the robots of the others have bodies. Raises ValueError if two robots, or
    both teams, have one name.
    """

    def __init__(
        self,
        seed: int = 1,
        home: TeamSheet = HOME,
        away: TeamSheet = VISITORS,
        rules: Rules | None = None,
        radio: RadioSettings | None = None,
    ) -> None:
        self.seed = seed
        self.sheets = (home, away)
        self.rules = rules or Rules()
        self._chance = random.Random(seed)
        self._now_ns = 0
        self._steps = 0
        self._ball = Ball()
        self._robots = [
            Robot(player.name, team, player.jersey, player.goalie)
            for team, sheet in enumerate(self.sheets)
            for player in sheet.players
        ]
        if len({robot.name for robot in self._robots}) < len(self._robots) or home.name == away.name:
            raise ValueError(f"{home.name} and {away.name}: two robots or both teams have the same name")
        self._referee = Referee(self.rules, self.sheets)
        open_match(self._referee, self._robots, self._ball)
        self._errors = {
            robot.name: [bell(self._chance), bell(self._chance), bell(self._chance)] for robot in self._robots
        }
        settings = radio or RadioSettings()
        self._radios = tuple(
            Radio([player.name for player in sheet.players], settings) for sheet in self.sheets
        )
        self._trail = Trail(TRAIL_POINTS)
        self._trail.add(0, 0.0, 0.0, False)
        self._bodies = {
            robot.name: FieldBody(self, robot.name, self._radios[robot.team], percept)
            for robot, percept in self._percepts()
        }

    @property
    def bodies(self) -> Mapping[str, FieldBody]:
        """The bodies of the robots that the field does not play itself, by name."""
        return MappingProxyType(self._bodies)

    @property
    def step_ns(self) -> int:
        """One step: 10 ms."""
        return STEP_NS

    @property
    def now_ns(self) -> int:
        """How far the match has been played."""
        return self._now_ns

    @property
    def over(self) -> bool:
        """Whether the final whistle has gone. Time may pass on, but no robot walks any more."""
        return self._referee.state is PlayerState.FINISHED

    @property
    def events(self) -> tuple[Event, ...]:
        """The referee's notes so far, oldest first."""
        return tuple(self._referee.events)

    @property
    def trail(self) -> tuple[TrailPoint, ...]:
        """The path of the ball so far, or in the last half an hour, ten points a second."""
        return self._trail.points

    @property
    def radio(self) -> tuple[RadioCount, RadioCount]:
        """What the radios of both teams have done so far."""
        return self._radios[0].count, self._radios[1].count

    def result(self) -> Result:
        """How the match stands."""
        goals = tuple(event for event in self._referee.events if event.kind is EventKind.GOAL)
        score = (self._referee.score[0], self._referee.score[1])
        return Result((self.sheets[0].name, self.sheets[1].name), score, goals, self.over)

    def truth(self) -> Truth:
        """The world as it is. For tests and pictures: a robot knows only its percepts."""
        ball = self._ball
        robots = tuple(
            RobotTruth(
                robot.name,
                robot.team,
                robot.jersey,
                robot.goalie,
                robot.pose,
                robot.head,
                robot.posture,
                robot.penalised,
            )
            for robot in self._robots
        )
        return Truth(self._now_ns, self._referee.state, BallTruth(ball.x, ball.y, ball.vx, ball.vy), robots)

    def put_ball(self, place: Point, vx: float = 0.0, vy: float = 0.0) -> None:
        """Lay the ball somewhere, or let it roll from there with (vx, vy) cm/s: for training and tests.

        It counts as touched by no robot, and a set play ends.
        """
        self._referee.touched_by = self._referee.touched_before_by = None
        self._referee.straight_from_kick_off = False
        self._referee.set_play = SetPlay.NONE
        self._ball.put(place.x, place.y)
        self._ball.vx, self._ball.vy = vx, vy
        last = self._trail.last
        self._trail.add(self._now_ns, last.x, last.y, False)

    def put_robot(self, name: str, pose: Pose, posture: Posture = Posture.STANDING) -> None:
        """Set a robot down somewhere, as the home team sees the field: for training and tests.

        Raises KeyError if no robot has that name.
        """
        robot = next((robot for robot in self._robots if robot.name == name), None)
        if robot is None:
            raise KeyError(name)
        robot.raise_up()
        robot.put(pose)
        robot.posture = posture

    def advance(self, until_ns: int) -> None:
        """Play every step that ends at or before ``until_ns``. Raises ValueError for a time gone by."""
        if until_ns < self._now_ns:
            raise ValueError(f"{until_ns} ns has passed: the match is at {self._now_ns} ns")
        while self._now_ns + STEP_NS <= until_ns:
            self._step()

    def _step(self) -> None:
        now_ns = self._now_ns = self._now_ns + STEP_NS
        self._steps += 1
        seconds = STEP_NS / 1e9
        referee, ball, robots = self._referee, self._ball, self._robots
        self._take_commands(now_ns)
        walking = referee.walking
        for robot in robots:
            move(robot, now_ns, seconds, walking and not robot.penalised)
        in_play = [robot for robot in robots if robot.penalised_until_ns is None]
        contacts = separate(in_play)
        if contacts:
            self._stumble(contacts)
        before = (ball.x, ball.y)
        if referee.playing:
            for robot in in_play:
                if robot.action is not None:
                    self._kick(robot, now_ns)
            roll(ball, seconds)
            for robot in touch_ball(ball, in_play):
                touched(referee, robot, ball)
            if referee.set_play:
                keep_distance(referee, ball, robots)
        for robot in in_play:
            keep_on_carpet(robot)
        notes = len(referee.events)
        watch(referee, now_ns, STEP_NS, ball, before, robots, contacts)
        for radio in self._radios:
            radio.carry(now_ns, STEP_NS, self._chance)
        carried = len(referee.events) > notes and (ball.x, ball.y) != before and ball.speed == 0.0
        if carried:
            self._trail.add(now_ns, *before, False)
            self._trail.add(now_ns, ball.x, ball.y, referee.playing)
        elif self._steps % TRAIL_STEPS == 0:
            self._trail.add(now_ns, ball.x, ball.y, referee.playing)
        if self._steps % PICTURE_STEPS == 0:
            for robot, percept in self._percepts():
                self._bodies[robot.name]._percept = percept

    def _take_commands(self, now_ns: int) -> None:
        bodies = self._bodies
        for robot in self._robots:
            body = bodies.get(robot.name)
            if body is not None:
                while body._commands:
                    obey(robot, body._commands.popleft())
        if now_ns % opponent.DECIDE_NS == 0:
            for team, sheet in enumerate(self.sheets):
                if sheet.scripted:
                    robots = [robot for robot in self._robots if robot.team == team]
                    places = kick_off_places(sheet, self._referee.kicking == team)
                    for robot, command in opponent.decide(robots, self._ball, self._referee.state, places):
                        obey(robot, command)

    def _kick(self, robot: Robot, now_ns: int) -> None:
        """Let the foot of a robot that kicks swing through, where the ball may be or not."""
        kick = kick_now(robot, now_ns)
        if kick is None:
            return
        referee, ball, chance = self._referee, self._ball, self._chance
        team = self.sheets[robot.team].name
        if not at_feet(robot, ball.x, ball.y):
            referee.note(now_ns, EventKind.MISSED_KICK, ball, team=team, robot=robot.name)
            return
        turn = clamp(kick.direction, KICK_ANGLE) + KICK_ANGLE_NOISE * bell(chance)
        speed = KICK_SPEED * kick.strength * (1.0 + KICK_STRENGTH_NOISE * bell(chance))
        c, s = unit(robot.heading + turn)
        ball.vx, ball.vy = speed * c, speed * s
        touched(referee, robot, ball)
        referee.note(now_ns, EventKind.KICK, ball, team=team, robot=robot.name)

    def _stumble(self, contacts: list[Contact]) -> None:
        """Let robots that ran into each other fall, now and then."""
        for contact in contacts:
            if contact.one_pushes + contact.other_pushes <= FALL_SPEED:
                continue
            for robot in (contact.one, contact.other):
                if self._chance.random() < FALL_PROBABILITY and robot.posture is Posture.STANDING:
                    fall(robot)
                    team = self.sheets[robot.team].name
                    self._referee.note(self._now_ns, EventKind.FALL, robot, team=team, robot=robot.name)

    def _percepts(self) -> list[tuple[Robot, Percept]]:
        """What each robot with a body senses now."""
        in_play = [robot for robot in self._robots if not robot.penalised]
        percepts: list[tuple[Robot, Percept]] = []
        for team, sheet in enumerate(self.sheets):
            if sheet.scripted:
                continue
            places = kick_off_places(sheet, self._referee.kicking == team)
            games: dict[bool, GameSeen] = {}
            for robot in self._robots:
                if robot.team == team:
                    penalised = robot.penalised
                    if penalised not in games:
                        games[penalised] = self._referee.seen_by(team, penalised, self._now_ns)
                    percepts.append(
                        (robot, self._percept(robot, in_play, games[penalised], places[robot.name]))
                    )
        return percepts

    def _percept(self, robot: Robot, in_play: list[Robot], game: GameSeen, place: Pose) -> Percept:
        chance = self._chance
        error = self._errors[robot.name]
        for index in range(3):
            error[index] = _ERROR_KEPT * error[index] + _ERROR_NEW * bell(chance)
        pose = Pose(
            robot.x + PLACE_NOISE * error[0],
            robot.y + PLACE_NOISE * error[1],
            wrap(robot.heading + HEADING_NOISE * error[2]),
        )
        picture = vision.look(robot, self._ball, in_play, chance)
        return Percept(
            time_ns=self._now_ns,
            name=robot.name,
            team=self.sheets[robot.team].number,
            jersey=robot.jersey,
            goalie=robot.goalie,
            pose=pose if robot.team == 0 else turned(pose),
            walk=Walk(robot.forward, robot.left, robot.turn),
            head=robot.head,
            posture=robot.posture,
            busy=robot.action is not None,
            ball=picture.ball,
            ball_at_feet=not robot.penalised and at_feet(robot, self._ball.x, self._ball.y),
            robots=picture.robots,
            posts=picture.posts,
            game=game,
            kick_off_place=place,
        )
