"""The lineup: who plays on one side of a match."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.records import dataclass

HOME, AWAY = "home", "away"
"""The two sides of a match."""


@dataclass(frozen=True, slots=True)
class Lineup:
    """One side of a match: the name of its system, and the role of each of its agents."""

    name: str
    roles: Mapping[str, str]


def seat_of(side: str, agent: str) -> str:
    """The name that the body of an agent has in the world of a match: `home.robot1`."""
    return f"{side}.{agent}"
