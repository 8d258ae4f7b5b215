"""Look: stands and looks around."""

from aseme_dsl.runtime import Context


class Look:
    def execute(self, context: Context) -> None:
        context.wait(2)
