"""PassBall: plays the ball to where the center_for goes to take it."""

from monas.Kouretes.messages import Assignment, Pass

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills

from .knowledge import ball_place, kick, lined_up, own_pose, pass_place, walk


class PassBall:
    def execute(self, context: Context) -> None:
        ball = ball_place(context)
        while ball is not None and not lined_up(context, pass_place(ball), turned=40):
            walk(context, skills.line_up(own_pose(context), ball, pass_place(ball)))
            context.wait(0.05)
            ball = ball_place(context)
        if ball is None:
            return
        to = (context.read("team.state.Assignment", Assignment) or Assignment()).center_for
        context.publish("team.signal.Pass", Pass(to))
        kick(context, skills.pass_to(own_pose(context), ball, pass_place(ball)))
        context.publish("team.signal.Pass", Pass(to))  # again: the radio loses one of ten
