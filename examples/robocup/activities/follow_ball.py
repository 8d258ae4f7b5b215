"""FollowBall: the keeper stays between the ball and its goal, and throws itself before a shot."""

from monas.Kouretes.messages import Gaze

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.command import Command

from .knowledge import ball_place, own_pose, walk


class FollowBall:
    def execute(self, context: Context) -> None:
        context.publish("head.state.Gaze", Gaze(at_ball=True))
        ball = ball_place(context)
        dive = skills.save(context.body.sense())
        if dive is not None:
            context.body.act(Command(dive))
            context.wait(0.5)
        elif ball is not None:
            place = skills.keeper_place(ball)
            walk(context, skills.walk_to(own_pose(context), place, place.heading))
            context.wait(0.05)
