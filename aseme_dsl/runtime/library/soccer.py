"""Soccer: the functions of `import soccer`. Lengths in cm, angles in degrees, left positive.

Messages are taken by their attributes, so that any class with these members fits.
"""

from __future__ import annotations

import math
from typing import Protocol

from aseme_dsl.runtime.library.math import turned

FEET_REACH = 5.0
"""A ball at most this far from the feet can be kicked, cm."""
FEET_ANGLE = 30.0
"""… if it lies at most this far to one side, degrees."""

HALF_LENGTH = 450.0
"""From the middle of the field to a goal line (RoboCup SPL rule book, section 1, Figure 1), cm."""
GOAL_HALF_WIDTH = 75.0
PENALTY_AREA_DEPTH = 165.0
PENALTY_AREA_HALF_WIDTH = 200.0
BALL_RADIUS = 5.0


class BallLike(Protocol):
    """What is read of a `Ball`."""

    @property
    def visible(self) -> bool: ...
    @property
    def distance(self) -> float: ...
    @property
    def bearing(self) -> float: ...


class PoseLike(Protocol):
    """What is read of a `Pose`."""

    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...
    @property
    def heading(self) -> float: ...


def can_kick(ball: BallLike) -> bool:
    """Whether the ball is seen where a kick hits it."""
    return ball.visible and ball.distance <= FEET_REACH and abs(turned(ball.bearing)) <= FEET_ANGLE


def facing_goal(pose: PoseLike) -> bool:
    """Whether a ball that is kicked straight ahead goes between the posts of the opponents' goal."""
    if pose.x >= HALF_LENGTH:
        return False
    half = GOAL_HALF_WIDTH - BALL_RADIUS
    right = bearing_to(pose, HALF_LENGTH, -half)
    left = bearing_to(pose, HALF_LENGTH, half)
    return right < 0.0 < left and left - right < 180.0


def distance_to_goal(pose: PoseLike) -> float:
    """How far it is to the middle of the opponents' goal."""
    return distance_to(pose, HALF_LENGTH, 0.0)


def distance_to(pose: PoseLike, x: float, y: float) -> float:
    """How far it is to a place."""
    return math.hypot(x - pose.x, y - pose.y)


def bearing_to(pose: PoseLike, x: float, y: float) -> float:
    """In which direction a place is, from straight ahead."""
    return turned(math.degrees(math.atan2(y - pose.y, x - pose.x)) - pose.heading)


def in_own_half(pose: PoseLike) -> bool:
    """Whether the robot stands in its own half."""
    return pose.x < 0.0


def in_own_penalty_area(pose: PoseLike) -> bool:
    """Whether the robot stands in the area before its own goal where a keeper is at home."""
    return (
        -HALF_LENGTH <= pose.x <= PENALTY_AREA_DEPTH - HALF_LENGTH and abs(pose.y) <= PENALTY_AREA_HALF_WIDTH
    )
