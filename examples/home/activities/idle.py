"""Idle: nobody has come."""

from aseme_dsl.runtime import Context


class Idle:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
