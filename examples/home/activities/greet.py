"""Greet: says hello."""

from aseme_dsl.runtime import Context


class Greet:
    def execute(self, context: Context) -> None:
        context.log("welcome home")
        context.wait(30)
