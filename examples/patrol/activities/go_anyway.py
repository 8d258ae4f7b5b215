"""GoAnyway: nobody comes."""

from aseme_dsl.runtime import Context


class GoAnyway:
    def execute(self, context: Context) -> None:
        context.log("nobody takes my zone")
