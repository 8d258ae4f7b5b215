"""Alarm: somebody is in the hall, and nobody should be."""

from aseme_dsl.runtime import Context


class Alarm:
    def execute(self, context: Context) -> None:
        context.log("who is there?")
        context.wait(30)
