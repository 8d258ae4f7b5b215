"""Init: stands up."""

from aseme_dsl.runtime import Context


class Init:
    def execute(self, context: Context) -> None:
        context.wait(1)
