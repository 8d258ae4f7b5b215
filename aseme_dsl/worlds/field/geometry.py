"""Places and directions on the field: centimetres, and degrees that grow to the left.

Sines and arcs differ in the last bit from one mathematical library to the next. They are rounded to some nine
decimals here, everything else the field uses is exact by IEEE 754: so a match is the same on every machine.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

# (x + R) - R rounds x to a multiple of the last bit of R: about 1e-9 for a ratio, 1e-6 for an angle.
_RATIO = 1.5 * 2.0**22
_ANGLE = 1.5 * 2.0**32


@dataclass(frozen=True, slots=True)
class Point:
    """A place: ``x`` cm towards the opponents' goal and ``y`` cm to the left of the middle of the field."""

    x: float
    y: float


@dataclass(frozen=True, slots=True)
class Pose:
    """A place, and the direction in degrees in which a robot looks there (0: at the opponents' goal)."""

    x: float
    y: float
    heading: float = 0.0

    @property
    def point(self) -> Point:
        """The place without the direction."""
        return Point(self.x, self.y)


def unit(heading: float) -> tuple[float, float]:
    """The vector of length 1 that points into a direction (degrees)."""
    angle = math.radians(heading)
    return (math.cos(angle) + _RATIO) - _RATIO, (math.sin(angle) + _RATIO) - _RATIO


def direction(x: float, y: float) -> float:
    """The direction of a vector in degrees, −180 to 180; of the zero vector 0."""
    return (math.degrees(math.atan2(y, x)) + _ANGLE) - _ANGLE


def length(x: float, y: float) -> float:
    """The length of a vector. (A square root is exact; ``math.hypot`` need not be.)"""
    return math.sqrt(x * x + y * y)


def wrap(angle: float) -> float:
    """The same direction as an angle above −180 and up to 180 degrees."""
    angle %= 360.0
    return angle - 360.0 if angle > 180.0 else angle


def clamp(value: float, limit: float) -> float:
    """The value, brought between −limit and limit."""
    return limit if value > limit else -limit if value < -limit else value


def distance(one: Point | Pose, other: Point | Pose) -> float:
    """The distance of two places in cm."""
    return length(other.x - one.x, other.y - one.y)


def towards(one: Point | Pose, other: Point | Pose) -> float:
    """The direction (degrees on the field) in which ``other`` lies, seen from ``one``."""
    return direction(other.x - one.x, other.y - one.y)


def bearing(pose: Pose, point: Point | Pose) -> float:
    """The direction of a point relative to where ``pose`` looks: degrees, left positive."""
    return wrap(towards(pose, point) - pose.heading)


def place_of(pose: Pose, distance: float, bearing: float) -> Point:
    """Where on the field something is that is seen at a distance (cm) and a bearing (degrees)."""
    x, y = unit(pose.heading + bearing)
    return Point(pose.x + distance * x, pose.y + distance * y)


def turned(pose: Pose) -> Pose:
    """The same pose as the other team names it: each team's x grows towards the other's goal."""
    return Pose(-pose.x, -pose.y, wrap(pose.heading + 180.0))
