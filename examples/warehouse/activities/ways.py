"""Ways: what the activities of the wheels share."""

import math

from world import DRAIN, GATE, SPEED, Drive, Percept, Point, shelf

from aseme_dsl.runtime import Context

RESERVE = 15.0
"""Per cent that are kept for the way back to the dock."""


def seconds_for(here: Percept, where: str) -> float:
    """How long it takes to fetch a pallet and to bring it to the gate."""
    place = shelf(where)
    return (math.dist(here.place, place) + math.dist(place, GATE)) / SPEED


def power_for(here: Percept, where: str) -> float:
    """What that costs, in per cent of the battery."""
    return seconds_for(here, where) * DRAIN + RESERVE


def drive_to(context: Context, target: Point) -> None:
    """Until the carrier is there. Raises RuntimeError if its motor does not turn."""
    context.body.act(Drive(target))
    try:
        while (here := context.body.sense()).place != target:
            if not here.turns:
                raise RuntimeError("the motor is burnt")
            context.wait(0.1)
    finally:
        context.body.act(Drive(None))
