"""AwardContract: the cheapest is taken, as the protocol has found out."""

from aseme_dsl.runtime import Context


class AwardContract:
    def execute(self, context: Context) -> None:
        context.log(f"{context.get_variable('job')} goes to {context.get_variable('best')}")
