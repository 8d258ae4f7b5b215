"""On: the heater is on."""

from aseme_dsl.runtime import Context


class On:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
