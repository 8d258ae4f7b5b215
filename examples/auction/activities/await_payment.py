"""AwaitPayment: until the statechart has heard of it."""

from aseme_dsl.runtime import Context


class AwaitPayment:
    def execute(self, context: Context) -> None:
        context.wait(3600)
