"""HandOver: one of them comes."""

from aseme_dsl.runtime import Context


class HandOver:
    def execute(self, context: Context) -> None:
        context.log("somebody takes my zone")
