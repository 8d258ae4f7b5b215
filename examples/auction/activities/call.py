"""Call: says the price aloud."""

from aseme_dsl.runtime import Context


class Call:
    def execute(self, context: Context) -> None:
        context.log(f"{context.get_variable('price'):.0f}!")
