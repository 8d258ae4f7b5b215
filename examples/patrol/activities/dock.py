"""Dock: drives to the robot's dock."""

from world import dock_of

from aseme_dsl.runtime import Context

from .driving import drive_to


class Dock:
    def execute(self, context: Context) -> None:
        drive_to(context, dock_of(context.agent))
