"""Bodies that meet: robots push each other apart, and the ball bounces off robots."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from aseme_dsl.worlds.field.ball import BOUNCE, Ball, bounce
from aseme_dsl.worlds.field.field import BORDER, HALF_LENGTH, HALF_WIDTH
from aseme_dsl.worlds.field.geometry import clamp, length
from aseme_dsl.worlds.field.robot import DIVE_REACH, RADIUS, TOUCH, Robot, covers

_APART = 2 * RADIUS
_NEAR = TOUCH + DIVE_REACH


@dataclass(frozen=True, slots=True)
class Contact:
    """Two robots that touch, and the speed in cm/s with which each walks into the other (never below 0)."""

    one: Robot
    other: Robot
    one_pushes: float
    other_pushes: float


def separate(robots: Sequence[Robot]) -> list[Contact]:
    """Push robots apart that stand in the same place, half the way each; who touched whom."""
    contacts: list[Contact] = []
    for index, one in enumerate(robots):
        x, y = one.x, one.y
        for other in robots[index + 1 :]:
            dx = other.x - x
            if dx >= _APART or dx <= -_APART:
                continue
            dy = other.y - y
            if dx * dx + dy * dy < _APART * _APART:
                contacts.append(_part(one, other))
                x, y = one.x, one.y
    return contacts


def keep_on_carpet(robot: Robot) -> None:
    """Stop a robot at the edge of the carpet."""
    robot.x = clamp(robot.x, HALF_LENGTH + BORDER)
    robot.y = clamp(robot.y, HALF_WIDTH + BORDER)


def touch_ball(ball: Ball, robots: Sequence[Robot]) -> list[Robot]:
    """Let the ball bounce off every robot that it touches; who they are."""
    touching: list[Robot] = []
    for robot in robots:
        dx = robot.x - ball.x
        if -_NEAR < dx < _NEAR and -_NEAR < robot.y - ball.y < _NEAR:
            x, y = covers(robot, ball.x, ball.y)
            if bounce(ball, x, y, TOUCH, BOUNCE, robot.vx, robot.vy):
                touching.append(robot)
    return touching


def _part(one: Robot, other: Robot) -> Contact:
    dx, dy = other.x - one.x, other.y - one.y
    apart = length(dx, dy)
    if apart == 0.0:
        dx, apart = 1.0, 1.0
        push = RADIUS
    else:
        push = (_APART - apart) / 2
    nx, ny = dx / apart, dy / apart
    one.x -= push * nx
    one.y -= push * ny
    other.x += push * nx
    other.y += push * ny
    return Contact(
        one, other, max(0.0, one.vx * nx + one.vy * ny), max(0.0, -(other.vx * nx + other.vy * ny))
    )
