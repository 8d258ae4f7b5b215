"""What a robot can be told to do: a motion of the body, and a direction for the head."""

from __future__ import annotations

import math
from dataclasses import dataclass


def _check(number: float, what: str) -> None:
    if not math.isfinite(number):
        raise ValueError(f"{what} must be a finite number, not {number}")


@dataclass(frozen=True, slots=True)
class Walk:
    """Walk with a speed in cm/s forwards and to the left, and turn left with degrees/s.

    Continues until the next motion. A robot that is too weak for the speed walks as fast as it can.
    """

    forward: float = 0.0
    left: float = 0.0
    turn: float = 0.0

    def __post_init__(self) -> None:
        _check(self.forward, "forward")
        _check(self.left, "left")
        _check(self.turn, "turn")


@dataclass(frozen=True, slots=True)
class Kick:
    """Kick once: with a strength above 0 and up to 1, into a direction in degrees from straight ahead.

    The foot hits only a ball that is at the feet when it swings through; directions beyond
    ±``robot.KICK_ANGLE`` are kicked as far round as the robot can. Raises ValueError for another strength.
    """

    strength: float = 1.0
    direction: float = 0.0

    def __post_init__(self) -> None:
        _check(self.direction, "direction")
        if not 0.0 < self.strength <= 1.0:
            raise ValueError(f"strength must be above 0 and at most 1, not {self.strength}")


@dataclass(frozen=True, slots=True)
class Stand:
    """Stand still; get up first from sitting or lying."""


@dataclass(frozen=True, slots=True)
class Sit:
    """Sit down."""


@dataclass(frozen=True, slots=True)
class Dive:
    """Throw yourself to the left, or to the right, before the ball; afterwards you lie there."""

    left: bool


Motion = Walk | Kick | Stand | Sit | Dive


@dataclass(frozen=True, slots=True)
class Command:
    """A motion, and a direction to turn the head to (degrees from straight ahead); None leaves that as it is.

    So one activity can drive the head while another walks. A walk continues. A kick, a dive, sitting down and
    getting up are done once per command, as soon as the robot can: a motion that has begun is ended first.
    """

    motion: Motion | None = None
    head: float | None = None

    def __post_init__(self) -> None:
        if self.head is not None:
            _check(self.head, "head")
