"""Ask: asks the others for help."""

from aseme_dsl.runtime import Context


class Ask:
    def execute(self, context: Context) -> None:
        context.wait(0.5)
