"""Bright: the lamp is on."""

from aseme_dsl.runtime import Context


class Bright:
    def execute(self, context: Context) -> None:
        context.wait(0.1)
