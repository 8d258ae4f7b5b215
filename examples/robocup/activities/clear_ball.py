"""ClearBall: kicks the ball out, as far from the own goal as the robot stands."""

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills

from .knowledge import ball_place, kick, own_pose


class ClearBall:
    def execute(self, context: Context) -> None:
        ball = ball_place(context)
        if ball is not None:
            kick(context, skills.clear(own_pose(context), ball))
