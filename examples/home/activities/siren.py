"""Siren: tells everybody that it burns, until the button is pressed."""

from aseme_dsl.runtime import Context


class Siren:
    def execute(self, context: Context) -> None:
        context.log("fire!")
