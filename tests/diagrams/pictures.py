"""What an SVG shows: elements by id, their text, and where they are."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams import Drawing, Expressions, Layout, Options, draw_statechart

SVG = "{http://www.w3.org/2000/svg}"
TITLE = "{http://www.w3.org/1999/xlink}title"

Frame = tuple[float, float, float, float]
Point = tuple[float, float]


class Picture:
    """An SVG, to be asked what is in it."""

    def __init__(self, svg: bytes) -> None:
        self.root = ElementTree.fromstring(svg)
        self.elements = {element.get("id", ""): element for element in self.root.iter() if element.get("id")}

    @property
    def ids(self) -> set[str]:
        return set(self.elements)

    @property
    def text(self) -> str:
        return text_of(self.root)

    def says(self, id: str) -> str:
        """All text in an element."""
        return text_of(self.elements[id])

    def tip(self, id: str) -> str:
        """The tooltip of an element."""
        return next(anchor.get(TITLE, "") for anchor in self.elements[id].iter(f"{SVG}a"))

    def frame(self, id: str) -> Frame:
        """Left, top, right and bottom of the border of a state."""
        shape = next(
            e for e in self.elements[id].iter() if e.tag in (f"{SVG}polygon", f"{SVG}path", f"{SVG}ellipse")
        )
        if "cx" in shape.attrib:
            x, y, rx, ry = (float(shape.attrib[name]) for name in ("cx", "cy", "rx", "ry"))
            return x - rx, y - ry, x + rx, y + ry
        points = points_of(shape)
        xs, ys = [x for x, _ in points], [y for _, y in points]
        return min(xs), min(ys), max(xs), max(ys)

    def line(self, id: str) -> list[Point]:
        """The points that the line of an edge passes, and those of its arrowhead."""
        edge = self.elements[id]
        points: list[Point] = []
        for path in edge.iter(f"{SVG}path"):
            points += points_of(path)[::3]  # the others are control points
        for head in edge.iter(f"{SVG}polygon"):
            points += points_of(head)
        return points


def points_of(shape: ElementTree.Element) -> list[Point]:
    numbers = [float(n) for n in re.findall(r"-?[\d.]+", shape.get("points") or shape.get("d") or "")]
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def text_of(element: ElementTree.Element) -> str:
    return "\n".join("".join(text.itertext()).replace("\xa0", " ") for text in element.iter(f"{SVG}text"))


def distance_to_border(frame: Frame, point: Point) -> float:
    """How far a point is from the border of a frame, whichever side of it."""
    left, top, right, bottom = frame
    x, y = point
    beside = max(left - x, 0.0, x - right)
    above = max(top - y, 0.0, y - bottom)
    if beside or above:
        return (beside**2 + above**2) ** 0.5
    return min(x - left, right - x, y - top, bottom - y)


def is_deep_inside(frame: Frame, point: Point, depth: float) -> bool:
    left, top, right, bottom = frame
    return left + depth < point[0] < right - depth and top + depth < point[1] < bottom - depth


def by_graphviz(chart: Statechart, expressions: Expressions = Expressions.NUMBERED) -> list[Drawing]:
    """The drawings of a statechart that Graphviz lays out."""
    return [
        drawing
        for layout in (Layout.NESTED, Layout.TREE)
        for drawing in draw_statechart(chart, Options(expressions, layout=layout))
    ]
