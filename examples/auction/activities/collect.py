"""Collect: gives the bidders time."""

from aseme_dsl.runtime import Context


class Collect:
    def execute(self, context: Context) -> None:
        context.wait(2)
