"""Charge: stays in the dock until the battery is full."""

from aseme_dsl.runtime import Context


class Charge:
    def execute(self, context: Context) -> None:
        while context.body.sense().battery < 95:
            context.wait(0.5)
