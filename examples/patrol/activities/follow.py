"""Follow: drives to where the intruder is seen, as long as the statechart wants it."""

from aseme_dsl.runtime import Context


class Follow:
    def execute(self, context: Context) -> None:
        while True:
            intruder = context.body.sense().intruder
            if intruder is not None:
                context.body.act(intruder)
            context.wait(0.2)
