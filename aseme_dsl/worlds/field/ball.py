"""The ball: it rolls, slows down, and bounces off what it meets."""

from __future__ import annotations

from dataclasses import dataclass

from aseme_dsl.worlds.field.field import GOAL_HALF_WIDTH, HALF_LENGTH, POST_RADIUS
from aseme_dsl.worlds.field.geometry import length

RADIUS = 5.0
"""cm."""
DECELERATION = 45.0
"""What rolling on the carpet takes from the speed: cm/s²."""
BOUNCE = 0.25
"""The share of its speed that the ball keeps when it bounces off a robot."""
POST_BOUNCE = 0.6
"""The same for a goal post."""

_POST_REACH = POST_RADIUS + RADIUS


@dataclass(slots=True)
class Ball:
    """Where the ball is (cm) and how it moves (cm/s)."""

    x: float = 0.0
    y: float = 0.0
    vx: float = 0.0
    vy: float = 0.0

    @property
    def speed(self) -> float:
        """cm/s."""
        return length(self.vx, self.vy)

    def put(self, x: float, y: float) -> None:
        """Lay the ball down at a place, at rest."""
        self.x, self.y, self.vx, self.vy = x, y, 0.0, 0.0


def roll(ball: Ball, seconds: float) -> None:
    """Let the ball roll for a moment, and bounce off a post that is in its way."""
    if ball.vx == 0.0 and ball.vy == 0.0:
        return
    speed = ball.speed
    slower = speed - DECELERATION * seconds
    if slower <= 0.0:
        ball.vx = ball.vy = 0.0
        return
    ball.vx *= slower / speed
    ball.vy *= slower / speed
    ball.x += ball.vx * seconds
    ball.y += ball.vy * seconds
    if abs(ball.x) > HALF_LENGTH - _POST_REACH:
        post_x = HALF_LENGTH if ball.x > 0.0 else -HALF_LENGTH
        for post_y in (GOAL_HALF_WIDTH, -GOAL_HALF_WIDTH):
            bounce(ball, post_x, post_y, _POST_REACH, POST_BOUNCE)


def bounce(
    ball: Ball, x: float, y: float, reach: float, keeps: float, vx: float = 0.0, vy: float = 0.0
) -> bool:
    """Let the ball bounce off something round that moves with (vx, vy) cm/s; whether it touches it at all.

    ``reach`` is the distance of the middles at which they touch. The ball is put there, and what it
    had of speed towards the thing is turned round and kept by the share ``keeps``.
    """
    dx, dy = ball.x - x, ball.y - y
    square = dx * dx + dy * dy
    if square >= reach * reach:
        return False
    away = length(dx, dy)
    if away == 0.0:
        dx, away = 1.0, 1.0
    nx, ny = dx / away, dy / away
    ball.x, ball.y = x + nx * reach, y + ny * reach
    closing = (ball.vx - vx) * nx + (ball.vy - vy) * ny
    if closing < 0.0:
        ball.vx -= (1.0 + keeps) * closing * nx
        ball.vy -= (1.0 + keeps) * closing * ny
    return True
