"""Award: says who has it."""

from aseme_dsl.runtime import Context


class Award:
    def execute(self, context: Context) -> None:
        context.log(f"sold to {context.variable('best')} for {context.variable('price'):.0f}")
