"""Scan: looks for the ball."""

from aseme_dsl.runtime import Context


class Scan:
    def execute(self, context: Context) -> None:
        context.wait(10)
