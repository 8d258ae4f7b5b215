"""Dive: falls to the ball's side, and gets up."""

from aseme_dsl.runtime import Context


class Dive:
    def execute(self, context: Context) -> str:
        before = context.body.sense()
        context.body.act(("dive",))
        while context.body.sense().speed > 5 and context.body.sense().ball[0] < before.ball[0] + 50:
            context.wait(0.05)
            if context.body.sense().ball[0] <= 5:
                return "missed"
        context.body.act(None)
        return "saved"
