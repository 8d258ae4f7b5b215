"""Inset: a part of a statechart drawn nested by Graphviz, for a compact drawing that has no form for it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from xml.etree import ElementTree

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.look.colours import LIGHT
from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.diagrams.look.drawing import STATE_GAPS, Drawing, Expressions, of_sheet
from aseme_dsl.diagrams.look.inset import Inset, Outline, Oval, Part, Piece, Point, Words
from aseme_dsl.diagrams.look.view import view
from aseme_dsl.diagrams.models.statechart import sheet
from aseme_dsl.diagrams.rendering.drawn import WHOLE
from aseme_dsl.diagrams.rendering.layout import DrawingFailed, GraphvizMissing, program, render

_NAMESPACE = "{http://www.w3.org/2000/svg}"
_TIP = "{http://www.w3.org/1999/xlink}title"
_NAMES = {colour: name for name, colour in reversed(LIGHT.items())}
_MOVE = re.compile(r"translate\((-?[\d.]+)[ ,](-?[\d.]+)\)")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
_KINDS = {"node": Kind.BOX, "cluster": Kind.GROUP, "edge": Kind.LINE}


def region(chart: Statechart, label: str) -> Inset | str:
    """A composite with all that is inside it, drawn nested, or why it cannot be drawn.

    What leads to the composite and leaves it is not in the picture. The texts stand at the transitions.
    """
    shown = view(chart, at=label)
    if len(shown.states) > WHOLE:
        return f"its {len(shown.states)} states are too much for one picture"
    inner = (
        way
        for way in shown.ways
        if not (way.source_outside or way.target_outside)
        and (way.transition.source != label or not way.transition.changes_state)
    )
    drawn = sheet(replace(shown, ways=tuple(inner)), f"part.{label}", expressions=Expressions.INLINE)
    try:
        return _drawn(program(), of_sheet(drawn, states=len(shown.states), gaps=STATE_GAPS))
    except GraphvizMissing:
        return "Graphviz, which would draw it nested, is not installed"
    except DrawingFailed as failure:
        return str(failure)


@lru_cache(64)
def _drawn(by: str, drawing: Drawing) -> Inset:
    """The picture that the program `by` makes, once: a part is laid out anew at each change around it."""
    return inset(render(drawing, "svg"))


def inset(svg: bytes) -> Inset:
    """The data of an SVG that Graphviz has drawn."""
    root = ElementTree.fromstring(svg)
    graph = next(item for item in root if item.tag == f"{_NAMESPACE}g")
    move = _MOVE.search(graph.get("transform", ""))
    at = (float(move[1]), float(move[2])) if move is not None else (0.0, 0.0)
    pieces = [
        Piece(
            item.get("id", ""),
            _KINDS[item.get("class", "node").split()[0]],
            tuple(_parts(item, at)),
            next((link.get(_TIP, "") for link in item.iter(f"{_NAMESPACE}a")), ""),
        )
        for item in graph
        if item.tag == f"{_NAMESPACE}g"
    ]
    _paper, *others = (part for item in graph if item.tag != f"{_NAMESPACE}g" for part in _part(item, at))
    if others:
        pieces.append(Piece("", Kind.SHEET, tuple(others)))
    width, height = float(root.get("width", "0")), float(root.get("height", "0"))
    return Inset(width, height, tuple(pieces))


def _parts(item: ElementTree.Element, at: Point) -> Iterator[Part]:
    for inner in item.iter():
        yield from _part(inner, at)


def _part(item: ElementTree.Element, at: Point) -> Iterator[Part]:
    fill, ink = _colour(item.get("fill", "")), _colour(item.get("stroke", ""))
    wide, dashed = float(item.get("stroke-width", "1")), item.get("stroke-dasharray") is not None
    match item.tag.removeprefix(_NAMESPACE):
        case "text":
            said = "".join(item.itertext()).replace("\xa0", " ").strip()
            if said:
                x, y = float(item.get("x", "0")) + at[0], float(item.get("y", "0")) + at[1]
                bold, middle = item.get("font-weight") == "bold", item.get("text-anchor") == "middle"
                yield Words(
                    round(x, 2), round(y, 2), said, float(item.get("font-size", "12")), fill, bold, middle
                )
        case "ellipse":
            x, y, rx, ry = (float(item.get(name, "0")) for name in ("cx", "cy", "rx", "ry"))
            yield Oval(round(x + at[0], 2), round(y + at[1], 2), rx, ry, fill, ink)
        case "polygon" | "polyline" | "path" as tag:
            numbers = [float(found) for found in _NUMBER.findall(item.get("points") or item.get("d") or "")]
            points = zip(numbers[::2], numbers[1::2], strict=True)
            moved = tuple((round(x + at[0], 2), round(y + at[1], 2)) for x, y in points)
            yield Outline(moved, fill, ink, tag == "path", dashed, wide)
        case _:
            return


def _colour(said: str) -> str:
    return "" if said in ("", "none", "transparent") else _NAMES.get(said, "ink")


__all__ = ["inset", "region"]
