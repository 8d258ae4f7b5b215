"""TakeOver: keeps an eye on the zone of another guard, too."""

from aseme_dsl.runtime import Context


class TakeOver:
    def execute(self, context: Context, zone: int) -> None:
        context.log(f"looks after zone {zone}, too")
        context.wait(20)
