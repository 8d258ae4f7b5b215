"""Off: the heater is off."""

from aseme_dsl.runtime import Context


class Off:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
