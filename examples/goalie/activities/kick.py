"""Kick: kicks the ball away."""

from aseme_dsl.runtime import Context


class Kick:
    def execute(self, context: Context) -> None:
        context.body.act(("kick",))
        context.wait(0.5)
