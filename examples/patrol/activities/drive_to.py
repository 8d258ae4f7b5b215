"""DriveTo: to a point of a zone."""

from world import point_of

from aseme_dsl.runtime import Context

from .driving import drive_to


class DriveTo:
    def execute(self, context: Context, zone: int, point: int) -> None:
        drive_to(context, point_of(zone, point))
