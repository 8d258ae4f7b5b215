"""Hear: looks at the own battery."""

from aseme_dsl.runtime import Context


class Hear:
    def execute(self, context: Context) -> None:
        context.wait(0.2)
