"""AwaitOutcome: until the statechart has heard of it. Who cannot wait any longer sets `withdrawn`."""

from aseme_dsl.runtime import Context


class AwaitOutcome:
    def execute(self, context: Context) -> None:
        context.wait(90)
        context.set_variable("withdrawn", True)
