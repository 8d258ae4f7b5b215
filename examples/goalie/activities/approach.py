"""Approach: walks to the ball."""

from aseme_dsl.runtime import Context


class Approach:
    def execute(self, context: Context) -> None:
        while True:
            context.body.act(("walk", context.body.sense().ball))
            context.wait(0.1)
