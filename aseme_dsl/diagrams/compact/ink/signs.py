"""Signs: small pictures that not every font has, as lines from the left end of the base line."""

from __future__ import annotations

import math

from aseme_dsl.diagrams.compact.elements import Point
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Sign:
    """A picture of lines and perhaps a circle (middle and radius).

    It is drawn in the `colour`, and filled with it if it is `solid`. The `flap` is a line on what is filled.
    """

    colour: str
    lines: tuple[tuple[Point, ...], ...]
    circle: tuple[float, float, float] | None = None
    solid: bool = False
    flap: tuple[Point, ...] = ()


_FLASH = ((7.0, -11.0), (0.5, -4.0), (4.0, -4.0), (2.0, 1.0), (9.5, -6.0), (6.0, -6.0), (7.0, -11.0))
_LETTER = ((0.5, -8.5), (12.0, -8.5), (12.0, -0.5), (0.5, -0.5), (0.5, -8.5))
_FLAP = ((0.5, -8.5), (6.2, -4.0), (12.0, -8.5))

SIGNS = {
    "⚡": Sign("cut", (_FLASH,), solid=True),
    "↯": Sign("cut", (_FLASH,)),
    "✕": Sign("error", (((1.5, -8.5), (8.5, -1.5)), ((8.5, -8.5), (1.5, -1.5)))),
    "↻": Sign(
        "soft",
        (((5.0, -10.0), (5.0, -6.0), (8.0, -8.0), (5.0, -10.0)),),
        circle=(5.0, -4.0, 4.0),
    ),
    "◷": Sign("soft", (((5.8, -7.4), (5.8, -4.2), (8.4, -2.6)),), circle=(5.8, -4.2, 5.2)),
    "✉": Sign("message", (_LETTER, _FLAP)),
    "➤": Sign("message", (_LETTER,), solid=True, flap=_FLAP),
    "Ⓗ": Sign(
        "soft",
        (((4.2, -7.2), (4.2, -1.2)), ((8.4, -7.2), (8.4, -1.2)), ((4.2, -4.2), (8.4, -4.2))),
        circle=(6.3, -4.2, 5.7),
    ),
}

ENDLESS = tuple(
    (8 + 7 * math.sin(step * math.pi / 12), 3.6 * math.sin(step * math.pi / 6)) for step in range(25)
)
"""The sign of what never ends, from its left end, with the middle at 0."""

__all__ = ["ENDLESS", "SIGNS", "Sign"]
