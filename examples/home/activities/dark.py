"""Dark: the lamp is off."""

from aseme_dsl.runtime import Context


class Dark:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
