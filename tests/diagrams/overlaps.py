"""Finds in a finished SVG what a reader could not read: text on text, text on a line, lines on lines."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise
from xml.etree.ElementTree import Element, fromstring

from aseme_dsl.diagrams.look.labels import text_width
from tests.diagrams.pictures import SVG, Frame, Point

_PART = re.compile(r"([A-Za-z])|(-?\d*\.?\d+(?:e-?\d+)?)")
_MOVE = re.compile(r"translate\((-?[\d.]+)[ ,](-?[\d.]+)\)")
_STEP = 2.0
"""How far apart the points are at which a line is looked at, in px."""
_NEAR = 1.5
_ALONG = 16.0
"""Two lines that do not begin or end together may run so far on one another: where they cross."""
_HEAD = 6.0
_BESIDE = 24.0
"""Lines that begin or end so near to each other do so at one thing."""


@dataclass(frozen=True)
class Text:
    said: str
    frame: Frame
    order: int


@dataclass(frozen=True)
class Line:
    """A line or a border; `edge` is the number of the edge that it is of, 0 for a border."""

    points: tuple[Point, ...]
    order: int
    edge: int


@dataclass(frozen=True)
class Plate:
    """A filled rectangle: what was painted before it is not to be seen there."""

    frame: Frame
    order: int


@dataclass(frozen=True)
class Head:
    """The head of an arrow."""

    frame: Frame
    edge: int


class Painted:
    """The texts, lines and filled rectangles of an SVG, in the order in which they are painted."""

    def __init__(self, svg: bytes | str) -> None:
        root = fromstring(svg)
        self.width, self.height = (
            float(root.get(name, "").removesuffix("pt")) for name in ("width", "height")
        )
        self.texts: list[Text] = []
        self.lines: list[Line] = []
        self.plates: list[Plate] = []
        self.heads: list[Head] = []
        self._order = 0
        self._read(root, (0.0, 0.0), {"font-size": "12"}, 0)

    def _read(self, item: Element, at: Point, given: dict[str, str], edge: int) -> None:
        move = _MOVE.search(item.get("transform", ""))
        if move is not None:
            at = (at[0] + float(move[1]), at[1] + float(move[2]))
        given = given | item.attrib
        tag = item.tag.removeprefix(SVG)
        self._order += 1
        if "edge" in item.get("class", "").split():
            edge = self._order
        if tag == "text":
            self._text(item, at, given)
            return
        if tag in ("path", "polygon", "polyline", "ellipse", "circle", "rect", "line"):
            shapes = [[(x + at[0], y + at[1]) for x, y in shape] for shape in _shapes(tag, item)]
            if _is_seen(item.get("stroke", "none")):
                self.lines += (Line(tuple(shape), self._order, edge * (tag == "path")) for shape in shapes)
            if edge and tag == "polygon":
                self.heads += (Head(_frame(shape), edge) for shape in shapes)
            elif _is_seen(item.get("fill", "black" if tag != "polyline" else "none")):
                self.plates += (
                    Plate(_frame(shape), self._order)
                    for shape in shapes
                    if tag == "rect" or (tag == "polygon" and len(set(shape)) == 4)
                )
        for child in item:
            self._read(child, at, given, edge)

    def _text(self, item: Element, at: Point, given: dict[str, str]) -> None:
        size = float(given["font-size"].removesuffix("px"))
        said = "".join(item.itertext()).replace("\xa0", " ")
        wide = text_width(said, size) * (1.07 if given.get("font-weight") == "bold" else 1.0)
        x, y = float(item.get("x", "0")) + at[0], float(item.get("y", "0")) + at[1]
        x -= {"middle": wide / 2, "end": wide}.get(given.get("text-anchor", ""), 0.0)
        if said.strip():
            self.texts.append(Text(said, (x, y - 0.72 * size, x + wide, y + 0.2 * size), self._order))


def overlaps(svg: bytes | str) -> list[str]:
    """What cannot be read or told apart, in words; nothing if all can."""
    painted = Painted(svg)
    return [*hidden_texts(svg), *_along(painted), *_at_heads(painted)]


def hidden_texts(svg: bytes | str) -> list[str]:
    """The texts that cannot be read, and why."""
    painted = Painted(svg)
    return [*_on_text(painted), *_on_lines(painted), *_outside(painted)]


def _on_text(painted: Painted) -> Iterator[str]:
    for one, other in combinations(painted.texts, 2):
        if _meet(one.frame, other.frame, -0.5):
            yield f"{one.said!r} is on {other.said!r}"


def _on_lines(painted: Painted) -> Iterator[str]:
    for text in painted.texts:
        for line in painted.lines:
            if not _meet(text.frame, _frame(line.points), 0.0):
                continue
            seen = [point for point in _walk(line.points) if _holds(text.frame, point)]
            covers = [item.frame for item in painted.plates if line.order < item.order < text.order]
            seen = [point for point in seen if not any(_holds(frame, point) for frame in covers)]
            if seen:
                x, y = seen[0]
                yield f"a line crosses {text.said!r} at {x:.0f}, {y:.0f}"
                break


def _outside(painted: Painted) -> Iterator[str]:
    for text in painted.texts:
        left, top, right, bottom = text.frame
        if left < 0 or top < 0 or right > painted.width + 1 or bottom > painted.height + 1:
            yield f"{text.said!r} is outside"


def _along(painted: Painted) -> Iterator[str]:
    lines = [item.points for item in painted.lines if item.edge]
    for one, other in combinations(lines, 2):
        if _meet(_frame(one), _frame(other), _NEAR) and not _join(one, other):
            there = list(_walk(other))
            on = sum(any(math.dist(point, near) < _NEAR for near in there) for point in _walk(one))
            if on * _STEP > _ALONG:
                yield f"lines run on one another at {one[0]} and {other[0]}"


def _at_heads(painted: Painted) -> Iterator[str]:
    """Lines that run through the head of an arrow, but for those that end there as well."""
    for head in painted.heads:
        x, y = (head.frame[0] + head.frame[2]) / 2, (head.frame[1] + head.frame[3]) / 2
        for line in painted.lines:
            if line.edge in (0, head.edge) or not _meet(head.frame, _frame(line.points), _HEAD):
                continue
            if math.dist((x, y), line.points[-1]) > _BESIDE and any(
                math.dist((x, y), point) < _HEAD for point in _walk(line.points)
            ):
                yield f"a line runs through the head of an arrow at {x:.0f}, {y:.0f}"


def _join(one: tuple[Point, ...], other: tuple[Point, ...]) -> bool:
    """Whether two lines begin together or end together: on paper they fan out there."""
    return min(math.dist(one[0], other[0]), math.dist(one[-1], other[-1])) < _BESIDE


def _walk(points: tuple[Point, ...]) -> Iterator[Point]:
    """Points on a line, a step from each other."""
    for start, end in pairwise(points):
        steps = max(1, math.ceil(math.dist(start, end) / _STEP))
        for step in range(steps):
            yield (
                start[0] + (end[0] - start[0]) * step / steps,
                start[1] + (end[1] - start[1]) * step / steps,
            )
    yield points[-1]


def _meet(one: Frame, other: Frame, room: float) -> bool:
    return (
        one[0] < other[2] + room
        and other[0] < one[2] + room
        and one[1] < other[3] + room
        and other[1] < one[3] + room
    )


def _holds(frame: Frame, point: Point) -> bool:
    return frame[0] <= point[0] <= frame[2] and frame[1] <= point[1] <= frame[3]


def _frame(points: list[Point] | tuple[Point, ...]) -> Frame:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def _is_seen(colour: str) -> bool:
    return colour not in ("none", "transparent")


def _shapes(tag: str, item: Element) -> list[list[Point]]:
    """The outlines of a shape as points."""
    number = {
        name: float(item.get(name, "0")) for name in ("x", "y", "cx", "cy", "r", "rx", "ry") if item.get(name)
    }
    if tag == "rect":
        if item.get("width", "").endswith("%"):
            return []
        x, y, wide, high = (float(item.get(name, "0")) for name in ("x", "y", "width", "height"))
        return [[(x, y), (x + wide, y), (x + wide, y + high), (x, y + high), (x, y)]]
    if tag in ("ellipse", "circle"):
        rx, ry = number.get("rx", number.get("r", 0.0)), number.get("ry", number.get("r", 0.0))
        turns = [step * math.pi / 24 for step in range(49)]
        return [[(number["cx"] + rx * math.cos(a), number["cy"] + ry * math.sin(a)) for a in turns]]
    if tag in ("polygon", "polyline"):
        numbers = [float(found[1]) for found in _PART.findall(item.get("points", ""))]
        return [list(zip(numbers[::2], numbers[1::2], strict=True))]
    return list(_path(item.get("d", "")))


_COUNTS = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6, "q": 4, "a": 7, "z": 0}


def _path(text: str) -> Iterator[list[Point]]:
    """The lines of a path, with its curves as points; an arc is a straight line here."""
    parts = [letter or float(number) for letter, number in _PART.findall(text)]
    points: list[Point] = []
    letter = ""
    while parts:
        if isinstance(parts[0], str):
            letter = str(parts.pop(0))
        small = letter.lower()
        taken, parts = [float(part) for part in parts[: _COUNTS[small]]], parts[_COUNTS[small] :]
        x, y = points[-1] if points and letter.islower() else (0.0, 0.0)
        if small == "m":
            if len(points) > 1:
                yield points
            points = [(x + taken[0], y + taken[1])]
            letter = "l" if letter == "m" else "L"
        elif small == "h":
            points.append((x + taken[0], points[-1][1]))
        elif small == "v":
            points.append((points[-1][0], y + taken[0]))
        elif small == "z":
            points.append(points[0])
        elif small in "la":
            points.append((x + taken[-2], y + taken[-1]))
        else:
            bends = [(x + a, y + b) for a, b in zip(taken[::2], taken[1::2], strict=True)]
            curve = [points[-1], *bends]
            points += [_bend(curve, step / 12) for step in range(1, 13)]
    if len(points) > 1:
        yield points


def _bend(points: list[Point], part: float) -> Point:
    """A point of a Bézier curve."""
    while len(points) > 1:
        points = [(a + (c - a) * part, b + (d - b) * part) for (a, b), (c, d) in pairwise(points)]
    return points[0]
