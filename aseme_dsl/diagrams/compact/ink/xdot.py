"""Xdot: a compact drawing as the background of a Graphviz graph, from which Graphviz makes PNG and PDF."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.elements import (
    SIZES,
    Form,
    Line,
    Look,
    Picture,
    Point,
    Shape,
    Stroke,
    Text,
    moved,
)
from aseme_dsl.diagrams.compact.ink.colours import branch_colour
from aseme_dsl.diagrams.compact.ink.reading import in_order
from aseme_dsl.diagrams.compact.ink.signs import ENDLESS, SIGNS
from aseme_dsl.diagrams.compact.ink.svg import behind, head
from aseme_dsl.diagrams.compact.words import BOLD, ICON
from aseme_dsl.diagrams.look.colours import LIGHT
from aseme_dsl.diagrams.look.inset import Outline, Oval, Words
from aseme_dsl.diagrams.look.labels import printable, text_width
from aseme_dsl.diagrams.look.style import FONTS

_STROKES = {Stroke.PLAIN: "line", Stroke.CUT: "cut", Stroke.ERROR: "error", Stroke.NEVER: "soft"}
_INKS = {Look.ACTION: "soft", Look.SMALL: "soft", Look.CUT: "cut", Look.ERROR: "error"}
_CORNER = 8.0

_INCH = 99.0
"""How many px are an inch of paper: 11 px are 8 points."""

_LOWER = 0.1
"""So much of its size lower a text is asked for, as Graphviz writes it higher than that."""

_EDGE = 39.0
"""The margin of a sheet: 10 mm, in px."""

_BREAK = "\\\n"
"""Graphviz reads no longer piece of a text than 16384 characters."""


def dot(chart: Statechart, picture: Picture, paper: tuple[float, float] | None = None) -> str:
    """The drawing in light colours as a graph without nodes, whose background it is.

    On a sheet of `paper` of this size, in px, text of 11 px has 8 points; a drawing that is larger is scaled.
    """
    scaled = ""
    if paper is not None:
        scaled = f'pad=0 margin=0 size="{paper[0] / _INCH:.3f},{paper[1] / _INCH:.3f}" '
        picture = _on_paper(picture, paper)
    pen = _Pen(picture.height)
    for item in in_order(chart, picture):
        pen.element(chart, item)
    width, height = picture.width, picture.height
    size = f'pos="{width / 2:g},{height / 2:g}!" width={width / 72:.3f} height={height / 72:.3f}'
    return (
        f'digraph "compact" {{\n  graph [layout=nop2 {scaled}bb="0,0,{width:g},{height:g}" '
        f'_background="{_BREAK.join(pen.said)}"]\n  page [{size} shape=box style=invis label=""]\n}}\n'
    )


def _on_paper(picture: Picture, paper: tuple[float, float]) -> Picture:
    """The drawing in the middle of a sheet, at its top."""
    room = paper[0] - 2 * _EDGE, paper[1] - 2 * _EDGE
    larger = max(1.0, picture.width / room[0], picture.height / room[1])
    width, height = (round(side * larger, 1) for side in paper)
    left = (width - picture.width) / 2
    elements = tuple(moved(item, left, _EDGE) for item in picture.elements)
    return replace(picture, width=width, height=height, elements=elements)


class _Pen:
    """Collects drawing operations; y runs upwards there."""

    def __init__(self, height: float) -> None:
        self._height = height
        self.said: list[str] = []

    def element(self, chart: Statechart, item: Line | Shape | Text) -> None:
        match item:
            case Line():
                self._style("dashed" if item.stroke in (Stroke.ERROR, Stroke.NEVER) else "solid", 1.3)
                self._colour(_STROKES[item.stroke])
                self._line(item.points)
                if item.arrow:
                    self._style("solid", 1)
                    self._area(head(item.points), _STROKES[item.stroke], _STROKES[item.stroke])
            case Shape():
                self._shape(chart, item)
            case Text():
                self._text(item)
            case _:
                assert_never(item)

    def _shape(self, chart: Statechart, item: Shape) -> None:
        x, y, width, height = item.x, item.y, item.width, item.height
        middle, centre = x + width / 2, y + height / 2
        self._style("solid", 1.3)
        match item.form:
            case Form.ACTIVITY:
                self._area(_rounded(item, _CORNER), "node-border", "node")
            case Form.FRAME:
                self._area(_rounded(item, _CORNER), "frame-border", "frame")
            case Form.PARALLEL:
                self._area(_rounded(item, _CORNER), "frame-border", "paper")
            case Form.CLOSED:
                self._style("dotted", 1.3)
                self._area(_rounded(item, _CORNER), "ink", "frame")
            case Form.NESTED:
                self._style("dotted", 1)
                self._area(_rounded(item, _CORNER), "frame-border", "paper")
                self._inset(item)
            case Form.PILL:
                self._area(_rounded(item, height / 2), "frame-border", "pill")
            case Form.PROTOCOL:
                number = branch_colour(chart, item.state)
                self._area(_rounded(item, 4), f"p{number}", f"q{number}")
                self._style("solid", 4)
                self._line(((x + 2, y), (x + 2, y + height)))
            case Form.CHOICE:
                corners = ((middle, y), (x + width, centre), (middle, y + height), (x, centre))
                self._area(corners, "choice-border", "choice")
            case Form.INITIAL:
                self._circle(middle, centre, width / 2, "ink", "ink")
            case Form.FINAL:
                self._circle(middle, centre, width / 2, "ink", "paper")
                self._circle(middle, centre, 3, "ink", "ink")
            case Form.ENDLESS:
                self._colour("soft")
                self._line([(x + a, centre + b) for a, b in ENDLESS])
            case Form.STACK:
                self._area(_rounded(item, _CORNER), "frame-border", "paper")
                self._line(behind(item))
            case Form.FIELD:
                self._style("dashed", 1)
                self._colour("frame-border")
                self._line(((x, y), (x + width, y)))
            case _:
                assert_never(item.form)

    def _inset(self, item: Shape) -> None:
        """The picture in a nested state."""
        dx, dy = item.origin
        pieces = item.inset.pieces if item.inset is not None else ()
        for part in (part for piece in pieces for part in piece.parts):
            match part:
                case Outline():
                    points = [(x + dx, y + dy) for x, y in part.points]
                    self._style("dashed" if part.dashed else "solid", part.wide)
                    self._filled(part.fill, part.ink or part.fill)
                    kind = ("b" if part.fill else "B") if part.curved else ("P" if part.fill else "p")
                    self.said.append(f"{kind} {len(points)} {self._points(points)} ")
                case Oval():
                    self._style("solid", 1)
                    self._filled(part.fill, part.ink or part.fill)
                    kind = "E" if part.fill else "e"
                    self.said.append(
                        f"{kind} {self._place(part.x + dx, part.y + dy)} {part.rx:g} {part.ry:g} "
                    )
                case Words():
                    wide = text_width(part.text, part.size, bold=part.bold)
                    at = part.x + dx, part.y + dy
                    self._words(
                        part.text, at, part.size, part.ink, int(part.bold), wide, 0 if part.middle else -1
                    )
                case _:
                    assert_never(part)

    def _filled(self, fill: str, ink: str) -> None:
        self._colour(ink)
        if fill:
            self.said.append(f"C 7 -{LIGHT[fill]} ")

    def _text(self, item: Text) -> None:
        said, x = item.text, item.x
        sign = SIGNS.get(said[:1])
        if sign is not None:
            self._style("solid", 1.3)
            for points in sign.lines:
                moved = [(x + a, item.y + b) for a, b in points]
                if sign.solid:
                    self._area(moved, sign.colour, sign.colour)
                else:
                    self._colour(sign.colour)
                    self._line(moved)
            if sign.circle is not None:
                a, b, radius = sign.circle
                self._colour(sign.colour)
                self.said.append(f"e {self._place(x + a, item.y + b)} {radius:g} {radius:g} ")
            if sign.flap:
                self._colour("paper")
                self._line([(x + a, item.y + b) for a, b in sign.flap])
            said, x = said[1:].lstrip(), x + ICON
        if not said:
            return  # Graphviz reads nothing behind an empty text
        flags = (1 if item.look in BOLD else 0) + (2 if item.look is Look.ACTION else 0)
        self._words(said, (x, item.y), SIZES[item.look], _INKS.get(item.look, "ink"), flags, item.width)

    def _words(
        self, said: str, at: Point, size: float, ink: str, flags: int, wide: float, side: int = -1
    ) -> None:
        """A line of text, from its left end on (`side` -1) or around its middle (0)."""
        self._colour(ink)
        said = printable(said).replace("\\", "∖").replace('"', '\\"')
        length = len(said.replace('\\"', '"').encode())
        self.said.append(f"F {size:g} {len(FONTS)} -{FONTS} t {flags} ")
        low = at[1] + _LOWER * size
        self.said.append(f"T {self._place(at[0], low)} {side} {wide:.0f} {length} -{said} ")

    def _place(self, x: float, y: float) -> str:
        return f"{x:.1f} {self._height - y:.1f}"

    def _points(self, points: Iterable[Point]) -> str:
        return " ".join(self._place(x, y) for x, y in points)

    def _line(self, points: Sequence[Point]) -> None:
        self.said.append(f"L {len(points)} {self._points(points)} ")

    def _area(self, points: Sequence[Point], border: str, inside: str) -> None:
        self._colour(border)
        self.said.append(f"C 7 -{LIGHT[inside]} P {len(points)} {self._points(points)} ")

    def _circle(self, x: float, y: float, radius: float, border: str, inside: str) -> None:
        self._colour(border)
        self.said.append(f"C 7 -{LIGHT[inside]} E {self._place(x, y)} {radius:g} {radius:g} ")

    def _colour(self, name: str) -> None:
        self.said.append(f"c 7 -{LIGHT[name]} ")

    def _style(self, name: str, width: float) -> None:
        thick = f"setlinewidth({width:g})"
        self.said.append(f"S {len(name)} -{name} S {len(thick)} -{thick} ")


def _rounded(item: Shape, radius: float) -> list[Point]:
    """The border of a box with round corners."""
    return list(_corners(item, min(radius, item.width / 2, item.height / 2)))


def _corners(item: Shape, radius: float) -> Iterator[Point]:
    left, right = item.x + radius, item.x + item.width - radius
    top, bottom = item.y + radius, item.y + item.height - radius
    for quarter, (x, y) in enumerate(((right, bottom), (left, bottom), (left, top), (right, top))):
        for step in range(5):
            angle = (quarter + step / 4) * math.pi / 2
            yield x + radius * math.cos(angle), y + radius * math.sin(angle)


__all__ = ["dot"]
