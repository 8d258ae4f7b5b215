"""Award: says who has it."""

from aseme_dsl.runtime import Context


class Award:
    def execute(self, context: Context) -> None:
        context.log(f"sold to {context.get_variable('best')} for {context.get_variable('price'):.0f}")
