"""Stare: goes sideways with the ball, on the goal line."""

from aseme_dsl.runtime import Context


class Stare:
    def execute(self, context: Context) -> None:
        while True:
            percept = context.body.sense()
            side = max(-60.0, min(60.0, percept.ball[1] * 10 / max(10.0, percept.ball[0])))
            context.body.act(("walk", (10.0, side)))
            context.wait(0.1)
