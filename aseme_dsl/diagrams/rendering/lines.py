"""Lines: how far lines of an SVG by Graphviz run on one another, or over texts, and mislead."""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from xml.etree import ElementTree

from aseme_dsl.diagrams.look.labels import text_width

_NAMESPACE = "{http://www.w3.org/2000/svg}"
_PAIR = re.compile(r"(-?\d+(?:\.\d+)?),(-?\d+(?:\.\d+)?)")

_NEAR = 1.6
"""Lines that are nearer are one on the other, in px."""

_LONG = 15.0
"""So far they may be that: where they cross."""

_HEAD = 7.0
"""A line that is nearer to the middle of an arrow's head runs through it."""

_BESIDE = 24.0
"""Lines that begin or end so near to each other fan out there."""

_CELL = 32.0
_ABOVE, _BELOW = 0.72, 0.2
"""How far a text reaches above and below its base line, by its size."""

_STEP = 2.0
_BENDS = 12

Point = tuple[float, float]


def mixed_up(svg: bytes, ids: Sequence[str]) -> float:
    """How far lines with these ids run on one another, or through heads of others, in px; 0 if all is clear.

    Lines that begin or end together may.
    """
    wanted = set(ids)
    lines: list[list[Point]] = []
    heads: list[Point] = []
    for item in ElementTree.fromstring(svg).iter():
        path = item.find(f".//{_NAMESPACE}path") if item.get("id") in wanted else None
        if path is not None:
            lines.append(list(_points(path.get("d", ""))))
            heads += (_middle(head.get("points", "")) for head in item.iter(f"{_NAMESPACE}polygon"))
    near = _Grid(lines, _NEAR)
    along: Counter[tuple[int, int]] = Counter()
    for number, line in enumerate(lines):
        for point in line:
            along.update((number, other) for other in near.lines_at(point) if other > number)
    far = (steps * _STEP for (one, other), steps in along.items() if not _join(lines[one], lines[other]))
    around = _Grid(lines, _HEAD)
    through = sum(
        math.dist(head, lines[number][-1]) > _BESIDE for head in heads for number in around.lines_at(head)
    )
    return sum(length for length in far if length > _LONG) + _LONG * through


def crossed(svg: bytes, ids: Sequence[str]) -> int:
    """How many texts are under a line or border with one of these ids."""
    wanted = set(ids)
    root = ElementTree.fromstring(svg)
    cells: dict[tuple[int, int], set[Point]] = defaultdict(set)
    for item in root.iter():
        for x, y in _outline(item) if item.get("id") in wanted else ():
            cells[int(x // _CELL), int(y // _CELL)].add((x, y))
    return sum(_is_crossed(text, cells) for text in root.iter(f"{_NAMESPACE}text"))


def _outline(item: ElementTree.Element) -> Iterator[Point]:
    """Points on the line of an element, or on its border."""
    shapes = (shape for shape in item.iter() if shape.get("d") or shape.get("points"))
    shape = next(shapes, None)
    if shape is None:
        return
    if shape.get("d"):
        yield from _points(shape.get("d", ""))
        return
    corners = [(float(x), float(y)) for x, y in _PAIR.findall(shape.get("points", ""))]
    for start, end in pairwise(corners):
        yield from _between(start, end)


def _is_crossed(text: ElementTree.Element, cells: Mapping[tuple[int, int], set[Point]]) -> bool:
    said, size = "".join(text.itertext()).strip(), float(text.get("font-size", "12"))
    wide = text_width(said, size, bold=text.get("font-weight") == "bold")
    x, y = float(text.get("x", "0")), float(text.get("y", "0"))
    left = x - {"middle": wide / 2, "end": wide}.get(text.get("text-anchor", ""), 0.0)
    top, low = y - _ABOVE * size, y + _BELOW * size
    return bool(said) and any(
        left <= at <= left + wide and top <= level <= low
        for column in range(int(left // _CELL), int((left + wide) // _CELL) + 1)
        for row in range(int(top // _CELL), int(low // _CELL) + 1)
        for at, level in cells.get((column, row), ())
    )


def _middle(corners: str) -> Point:
    xs, ys = zip(*((float(x), float(y)) for x, y in _PAIR.findall(corners)), strict=True)
    return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2


def _join(one: Sequence[Point], other: Sequence[Point]) -> bool:
    """Whether two lines begin or end together."""
    return min(math.dist(one[0], other[0]), math.dist(one[-1], other[-1])) < _BESIDE


class _Grid:
    """Finds the lines that are nearer to a point than `near`."""

    def __init__(self, lines: Sequence[Sequence[Point]], near: float) -> None:
        self._near = near
        self._cells: dict[tuple[int, int], list[tuple[int, Point]]] = defaultdict(list)
        for number, line in enumerate(lines):
            for point in line:
                self._cells[self._cell(point)].append((number, point))

    def lines_at(self, point: Point) -> set[int]:
        column, row = self._cell(point)
        cells = product((column - 1, column, column + 1), (row - 1, row, row + 1))
        found = (item for cell in cells for item in self._cells.get(cell, ()))
        return {number for number, other in found if math.dist(point, other) < self._near}

    def _cell(self, point: Point) -> tuple[int, int]:
        return int(point[0] // self._near), int(point[1] // self._near)


def _points(path: str) -> Iterator[Point]:
    """Points a step from each other on a path, which is one of Bézier curves."""
    corners = [(float(x), float(y)) for x, y in _PAIR.findall(path)]
    bent = [corners[0]]
    for at in range(1, len(corners) - 2, 3):
        curve = [corners[at - 1], *corners[at : at + 3]]
        bent += (_on(curve, step / _BENDS) for step in range(1, _BENDS + 1))
    for start, end in pairwise(bent):
        yield from _between(start, end)
    yield bent[-1]


def _between(start: Point, end: Point) -> Iterator[Point]:
    steps = max(1, math.ceil(math.dist(start, end) / _STEP))
    for step in range(steps):
        part = step / steps
        yield start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part


def _on(curve: list[Point], part: float) -> Point:
    while len(curve) > 1:
        curve = [(a + (c - a) * part, b + (d - b) * part) for (a, b), (c, d) in pairwise(curve)]
    return curve[0]


__all__ = ["crossed", "mixed_up"]
