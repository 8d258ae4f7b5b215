"""KickBall: shoots where the opponents' goal is free."""

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills

from .knowledge import ball_place, kick, own_pose


class KickBall:
    def execute(self, context: Context) -> None:
        ball = ball_place(context)
        if ball is not None:
            kick(context, skills.shoot(own_pose(context), ball, skills.aim(context.body.sense(), ball)))
