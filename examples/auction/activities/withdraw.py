"""Withdraw: nobody has wanted it."""

from aseme_dsl.runtime import Context


class Withdraw:
    def execute(self, context: Context) -> None:
        context.log("withdrawn")
