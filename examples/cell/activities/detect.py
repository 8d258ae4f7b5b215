"""Detect: until a part lies in the bin."""

from aseme_dsl.runtime import Context


class Detect:
    def execute(self, context: Context) -> None:
        while not context.body.sense().part:
            context.wait(0.05)
