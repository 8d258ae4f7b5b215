"""Defend: stands between the ball and the own goal, and goes with the ball."""

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.field import OWN_GOAL
from aseme_dsl.worlds.field.geometry import Point, Pose, towards

from .knowledge import ball_place, own_pose, walk

SHARE = 0.5
"""How far from the goal to the ball."""


class Defend:
    def execute(self, context: Context) -> None:
        ball = ball_place(context)
        if ball is None:
            return
        spot = Point(OWN_GOAL.x + SHARE * (ball.x - OWN_GOAL.x), SHARE * ball.y)
        place = Pose(spot.x, spot.y, towards(spot, ball))
        walk(context, skills.walk_to(own_pose(context), place, place.heading))
        context.wait(0.2)
