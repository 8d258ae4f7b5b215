"""Driving: what the activities of the wheels share."""

from world import Point

from aseme_dsl.runtime import Context


def drive_to(context: Context, target: Point) -> None:
    """Until the robot is there."""
    context.body.act(target)
    while context.body.sense().place != target:
        context.wait(0.1)
    context.body.act(None)
