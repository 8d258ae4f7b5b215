"""The carpet: the dimensions of the Standard Platform League's field, in cm, as one team sees it.

The origin is the middle, x grows towards the opponents' goal and y to the left. Lines belong to the areas
they enclose. (RoboCup Standard Platform League rule book, section 1, Figure 1.)
"""

from __future__ import annotations

from aseme_dsl.worlds.field.geometry import Point

HALF_LENGTH = 450.0
"""From the middle to a goal line."""
HALF_WIDTH = 300.0
"""From the middle to a side line."""
BORDER = 70.0
"""Carpet beyond the lines. Nothing gets past it."""
GOAL_HALF_WIDTH = 75.0
"""From the middle of a goal to the middle of a post."""
GOAL_DEPTH = 50.0
POST_RADIUS = 5.0
PENALTY_AREA_DEPTH = 165.0
PENALTY_AREA_HALF_WIDTH = 200.0
GOAL_AREA_DEPTH = 60.0
GOAL_AREA_HALF_WIDTH = 110.0
CENTRE_CIRCLE_RADIUS = 75.0
PENALTY_MARK = 130.0
"""From a goal line to the penalty mark before it."""

CENTRE = Point(0.0, 0.0)
OPPONENTS_GOAL = Point(HALF_LENGTH, 0.0)
"""The middle of the goal to score in."""
OWN_GOAL = Point(-HALF_LENGTH, 0.0)
"""The middle of the goal to defend."""


def on_field(point: Point, beyond: float = 0.0) -> bool:
    """Whether a point is within the lines, or at most ``beyond`` cm outside."""
    return abs(point.x) <= HALF_LENGTH + beyond and abs(point.y) <= HALF_WIDTH + beyond


def in_own_penalty_area(point: Point) -> bool:
    """Whether a point is in the area before the own goal where a keeper is at home."""
    return (
        -HALF_LENGTH <= point.x <= PENALTY_AREA_DEPTH - HALF_LENGTH
        and abs(point.y) <= PENALTY_AREA_HALF_WIDTH
    )
