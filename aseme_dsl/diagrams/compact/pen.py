"""Pen: a line that is being drawn, with the links that it has gone over so far."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from aseme_dsl.amola.statechart import Transition
from aseme_dsl.diagrams.compact import texts
from aseme_dsl.diagrams.compact.elements import Line, Link, Look, Point, Stroke, Text

PITCH = 14.5
"""From base line to base line."""

GAP = 16
"""The least room before an arrow's head."""


@dataclass(frozen=True, slots=True)
class Pen:
    """A line that has come to the x `at`, on the axis `points[-1][1]`."""

    points: tuple[Point, ...]
    at: float
    chain: tuple[Link, ...] = ()
    stroke: Stroke = Stroke.PLAIN

    @property
    def axis(self) -> float:
        return self.points[-1][1]

    @property
    def is_joint(self) -> bool:
        """Whether nothing is to be drawn yet."""
        return not self.chain and len(self.points) == 1 and self.at == self.points[0][0]


def pen(x: float, y: float = 0.0) -> Pen:
    """A pen that is set down."""
    return Pen(((x, y),), x)


def over(line: Pen, link: Link, transitions: Sequence[Transition]) -> tuple[Pen, tuple[Text, ...]]:
    """The pen after a link, and the texts at the line that the link's transitions have."""
    if not link:
        return line, ()
    cuts = line.stroke is Stroke.CUT and not line.chain
    above: list[tuple[str, Look, int]] = []
    below: list[tuple[str, Look, int]] = []
    for place in link:
        upper, lower = texts.rows(transitions[place], cuts)
        if len(link) > 1 and not upper:
            upper = (("done", Look.LABEL),)
        above += [(text, look, place) for text, look in upper]
        below += [(text, look, place) for text, look in lower]
        if len(link) > 1 and lower:  # actions belong to the row above them
            above += below
            below = []
    written = [
        Text(
            line.at + 8,
            line.axis - 5 - (len(above) - 1 - row) * PITCH,
            text,
            look,
            texts.width(text, look),
            of,
        )
        for row, (text, look, of) in enumerate(above)
    ]
    written += [
        Text(line.at + 8, line.axis + 14 + row * PITCH, text, look, texts.width(text, look), of)
        for row, (text, look, of) in enumerate(below)
    ]
    at = max((item.x + item.width + 4 for item in written), default=line.at)
    errors = cuts and all(transitions[place].expression.is_for_errors for place in link)
    stroke = Stroke.ERROR if errors else line.stroke
    return replace(line, at=at, chain=(*line.chain, link), stroke=stroke), tuple(written)


def down(line: Pen, dy: float) -> Pen:
    """The pen as it is seen from an axis `dy` below."""
    return replace(line, points=tuple((x, y - dy) for x, y in line.points))


def line_to(line: Pen, *points: Point, arrow: bool = True) -> Line:
    """The finished line."""
    return Line((*line.points, *points), line.chain, line.stroke, arrow)
