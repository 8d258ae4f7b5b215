"""The camera: what a robot sees in the cone before its head, and with what error."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass

from aseme_dsl.worlds.field.ball import Ball
from aseme_dsl.worlds.field.field import GOAL_HALF_WIDTH, HALF_LENGTH
from aseme_dsl.worlds.field.geometry import direction, length, unit, wrap
from aseme_dsl.worlds.field.noise import bell
from aseme_dsl.worlds.field.percept import BallSeen, PostSeen, Posture, RobotSeen
from aseme_dsl.worlds.field.robot import RADIUS, Robot

RANGE = 450.0
"""How far a robot sees, cm."""
HALF_ANGLE = 30.0
"""The cone reaches this far to each side of where the head points, degrees."""
MISS_NEAR = 0.03
"""The probability that a thing in the cone is missed in one picture, close by …"""
MISS_FAR = 0.25
"""… and at the end of the range."""
SPEED_NOISE = 4.0
"""The standard deviation of each component of the ball's velocity, cm/s."""


def distance_noise(distance: float) -> float:
    """The standard deviation of a distance that is seen, in cm."""
    return 0.5 + 0.03 * distance


def bearing_noise(distance: float) -> float:
    """The standard deviation of the bearing of a thing at a distance, in degrees."""
    return 0.5 + 0.004 * distance


def miss_probability(distance: float) -> float:
    """The probability that a thing in the cone is missed in one picture."""
    share = distance / RANGE
    return MISS_NEAR + (MISS_FAR - MISS_NEAR) * share * share


@dataclass(frozen=True, slots=True)
class Picture:
    """What one look gave."""

    ball: BallSeen | None
    robots: tuple[RobotSeen, ...]
    posts: tuple[PostSeen, ...]


NOTHING = Picture(None, (), ())
"""What a robot sees that lies on the carpet or stands behind the line, penalised."""

_COSINE, _SINE = unit(HALF_ANGLE)


def look(observer: Robot, ball: Ball, robots: Sequence[Robot], chance: random.Random) -> Picture:
    """What ``observer`` sees of the ball, the goal posts and the robots in play.

    A robot that stands between it and the ball hides the ball; nothing hides robots and posts.
    """
    if observer.posture is Posture.FALLEN or observer.penalised:
        return NOTHING
    sight = unit(observer.heading + observer.head)
    sign = 1.0 if observer.team == 0 else -1.0
    others: list[RobotSeen] = []
    for robot in robots:
        if robot is not observer and (spot := _spot(observer, sight, robot.x, robot.y, chance)) is not None:
            others.append(RobotSeen(robot.team == observer.team, robot.jersey, *spot))
    posts: list[PostSeen] = []
    for opponents in (True, False):
        x = HALF_LENGTH * sign if opponents else -HALF_LENGTH * sign
        for left in (True, False):
            y = GOAL_HALF_WIDTH * sign if left else -GOAL_HALF_WIDTH * sign
            if (spot := _spot(observer, sight, x, y, chance)) is not None:
                posts.append(PostSeen(opponents, left, *spot))
    return Picture(_ball(observer, sight, ball, robots, chance), tuple(others), tuple(posts))


def _spot(
    observer: Robot, sight: tuple[float, float], x: float, y: float, chance: random.Random
) -> tuple[float, float] | None:
    """The distance and bearing at which something is seen, or None: outside the cone, or missed."""
    dx, dy = x - observer.x, y - observer.y
    if dx > RANGE or dx < -RANGE or dy > RANGE or dy < -RANGE:
        return None
    c, s = sight
    ahead = dx * c + dy * s
    if ahead <= 0.0:
        return None
    aside = dy * c - dx * s
    if abs(aside) * _COSINE > ahead * _SINE:
        return None
    away = length(dx, dy)
    if away > RANGE or chance.random() < miss_probability(away):
        return None
    seen = away + distance_noise(away) * bell(chance)
    turn = observer.head + direction(ahead, aside) + bearing_noise(away) * bell(chance)
    return (seen if seen > 0.0 else 0.0), wrap(turn)


def _ball(
    observer: Robot, sight: tuple[float, float], ball: Ball, robots: Sequence[Robot], chance: random.Random
) -> BallSeen | None:
    spot = _spot(observer, sight, ball.x, ball.y, chance)
    if spot is None or _hidden(observer, ball, robots):
        return None
    c, s = unit(observer.heading)
    return BallSeen(
        *spot,
        ball.vx * c + ball.vy * s + SPEED_NOISE * bell(chance),
        ball.vy * c - ball.vx * s + SPEED_NOISE * bell(chance),
    )


def _hidden(observer: Robot, ball: Ball, robots: Sequence[Robot]) -> bool:
    """Whether a robot stands on the line between the observer and the ball."""
    dx, dy = ball.x - observer.x, ball.y - observer.y
    away = length(dx, dy)
    if away == 0.0:
        return False
    dx, dy = dx / away, dy / away
    for robot in robots:
        rx, ry = robot.x - observer.x, robot.y - observer.y
        if 0.0 < rx * dx + ry * dy < away and abs(ry * dx - rx * dy) < RADIUS and robot is not observer:
            return True
    return False
