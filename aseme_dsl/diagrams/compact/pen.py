"""Pen: a line that is being drawn, with the links that it has gone over; and the room that it leaves."""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from aseme_dsl.diagrams.compact.elements import Element, Line, Link, Look, Point, Shape, Stroke, Text, moved
from aseme_dsl.diagrams.compact.words import INDENT, Words, indented, link_rows, width
from aseme_dsl.records import dataclass

PITCH = 14.5
"""From base line to base line."""

GAP = 20
"""The least room before an arrow's head."""


@dataclass(frozen=True, slots=True)
class Pen:
    """A line that has come to the x `at`, on the axis `points[-1][1]`.

    What is wide may stand in the next `row`: from this x on, below this y.
    """

    points: tuple[Point, ...]
    at: float
    chain: tuple[Link, ...] = ()
    stroke: Stroke = Stroke.PLAIN
    row: tuple[float, float] | None = None

    @property
    def axis(self) -> float:
        return self.points[-1][1]

    @property
    def is_joint(self) -> bool:
        """Whether nothing is to be drawn yet."""
        return not self.chain and len(self.points) == 1 and self.at == self.points[0][0]


@dataclass(frozen=True, slots=True)
class Placed:
    """A block in its place: its elements, the pen behind it (None: it never ends), and how far it reaches."""

    elements: tuple[Element, ...]
    pen: Pen | None
    right: float
    up: float
    down: float


class Room:
    """Collects elements and how far they reach, seen from an axis at 0."""

    def __init__(self) -> None:
        self.elements: list[Element] = []
        self.right = self.up = self.down = 0.0

    def add(self, *elements: Element) -> None:
        for item in elements:
            right, up, down = _reach(item)
            self.reach(right, up, down)
        self.elements += elements

    def reach(self, right: float, up: float = 0.0, down: float = 0.0) -> None:
        """Say that something is there."""
        self.right, self.up, self.down = max(self.right, right), max(self.up, up), max(self.down, down)

    def put(self, placed: Placed, dy: float = 0.0, dx: float = 0.0) -> None:
        """Add what has been placed, `dy` lower."""
        moving = dx or dy
        self.elements += (moved(item, dx, dy) for item in placed.elements) if moving else placed.elements
        self.reach(placed.right + dx, placed.up - dy, placed.down + dy)

    def placed(self, behind: Pen | None) -> Placed:
        right = self.right if behind is None else max(self.right, behind.at)
        return Placed(tuple(self.elements), behind, right, self.up, self.down)


def _reach(item: Element) -> tuple[float, float, float]:
    """How far an element reaches to the right, above and below the axis."""
    match item:
        case Line():
            ys = [y for _, y in item.points]
            return max(x for x, _ in item.points), -min(ys), max(ys)
        case Shape():
            return item.x + item.width, -item.y, item.y + item.height
        case Text():
            return item.x + item.width, 11 - item.y, item.y + 4
        case _:
            assert_never(item)


def pen(x: float, y: float = 0.0) -> Pen:
    """A pen that is set down."""
    return Pen(((x, y),), x)


def over(
    line: Pen, link: Link, words: Words, wide: float, least: float = 0.0
) -> tuple[Pen, tuple[Text, ...]]:
    """The pen after a link, and the texts at the line that the link's transitions have.

    The texts take at least the room `least`.
    """
    if not link:
        return line, ()
    cuts = line.stroke is Stroke.CUT and not line.chain
    above, below = link_rows(words, link, wide, cuts)
    left = line.at + 8
    high = line.axis - 5 - (len(above) - 1) * PITCH
    placed = indented(above) if len(link) > 1 else ((row, of, 0.0) for row, of in above)
    written = [text(left + dx, high + n * PITCH, *row, of) for n, (row, of, dx) in enumerate(placed)]
    written += [text(left, line.axis + 14 + n * PITCH, *row, of) for n, (row, of) in enumerate(below)]
    at = max((item.x + item.width + 4 for item in written), default=line.at)
    errors = cuts and all(words.is_for_errors(place) for place in link)
    stroke = Stroke.ERROR if errors else line.stroke
    at = max(at, line.at + least)
    return replace(line, at=at, chain=(*line.chain, link), stroke=stroke), tuple(written)


def room_of(link: Link, words: Words, wide: float) -> float:
    """How much room the texts of a link take along the line."""
    return max((item + 12 for item in _widths(link, words, wide, False)), default=0.0)


def back_width(link: Link, words: Words, wide: float) -> float:
    """How long a line back must be for its texts."""
    return max((item + 36 for item in _widths(link, words, wide, True)), default=0.0)


def _widths(link: Link, words: Words, wide: float, cuts: bool) -> list[float]:
    above, below = link_rows(words, link, wide, cuts)
    dent = INDENT if len(link) > 1 else 0.0
    return [width(*row) + dent for row, _ in (*above, *below)]


def text(x: float, y: float, said: str, look: Look, of: int | None = None) -> Text:
    """A text with its left end at x."""
    return Text(x, y, said, look, width(said, look), of)


def down(line: Pen, dy: float) -> Pen:
    """The pen as it is seen from an axis `dy` below."""
    return replace(line, points=tuple((x, y - dy) for x, y in line.points))


def right_by(line: Pen, dx: float) -> Pen:
    """The pen, `dx` further to the right."""
    return replace(line, points=tuple((x + dx, y) for x, y in line.points), at=line.at + dx)


def line_to(line: Pen, *points: Point, arrow: bool = True) -> Line:
    """The finished line."""
    return Line((*line.points, *points), line.chain, line.stroke, arrow)
