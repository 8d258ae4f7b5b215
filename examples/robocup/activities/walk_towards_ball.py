"""WalkTowardsBall: until the ball lies at the feet and the opponents' goal behind it."""

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.field import OPPONENTS_GOAL

from .knowledge import ball_place, lined_up, own_pose, walk


class WalkTowardsBall:
    def execute(self, context: Context) -> None:
        while not lined_up(context, OPPONENTS_GOAL):
            ball = ball_place(context)
            if ball is None:
                return
            walk(context, skills.line_up(own_pose(context), ball, OPPONENTS_GOAL))
            context.wait(0.05)
