"""HeadHandler: points the head at the ball, or to and fro in search of it."""

from monas.Kouretes.messages import Ball, Gaze

from aseme_dsl.runtime import Context
from aseme_dsl.worlds.field import skills
from aseme_dsl.worlds.field.command import Command
from aseme_dsl.worlds.field.geometry import clamp
from aseme_dsl.worlds.field.robot import HEAD_LIMIT

from .knowledge import SECOND


class HeadHandler:
    def execute(self, context: Context) -> None:
        gaze = context.read("head.state.Gaze", Gaze)
        ball = context.read("vision.state.Ball", Ball)
        at_ball = gaze is not None and gaze.at_ball and ball is not None and ball.visible
        if at_ball and context.body.sense().ball is None:
            # It is not where it should be: look there and elsewhere by turns.
            at_ball = context.now_ns % (2 * SECOND) < SECOND
        angle = clamp(ball.bearing, HEAD_LIMIT) if at_ball else skills.scan(context.now_ns)
        context.body.act(Command(head=angle))
