"""Go: walks back to the middle of the goal."""

from aseme_dsl.runtime import Context


class Go:
    def execute(self, context: Context) -> None:
        context.body.act(("walk", (10.0, 0.0)))
        while abs(context.body.sense().place[1]) > 5:
            context.wait(0.1)
