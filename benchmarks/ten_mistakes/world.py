"""What the peers' behaviours see: a ball, the phase of the game, and a function of the user's."""

from enum import Enum


class Phase(Enum):
    idle = 0
    playing = 1


class Side(Enum):
    left = 0
    right = 1


class Ball:
    __slots__ = ("distance", "speed")

    def __init__(self, distance: float, speed: float) -> None:
        self.distance = distance
        self.speed = speed


def is_still(speed: float) -> bool:
    """Whether a ball that is as fast as that lies still."""
    return speed < 0.1


DRIVE = [
    ("done", Ball(0.2, 0.0), Phase.playing, "kick"),
    ("done", Ball(0.2, 0.0), Phase.playing, "search"),
    ("done", Ball(5.0, 0.0), Phase.playing, "approach"),
    ("done", Ball(5.0, 0.0), Phase.playing, "search"),
    ("done", Ball(0.3, 0.0), Phase.playing, "approach"),
    ("whistle", Ball(5.0, 0.0), Phase.playing, "search"),
]
"""The match of every peer: an event, what is seen then, and the state that is right afterwards."""
