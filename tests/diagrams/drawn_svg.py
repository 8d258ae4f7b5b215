"""Reads what a compact SVG shows: the elements that it was made of."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from xml.etree.ElementTree import Element

from aseme_dsl.diagrams.compact.elements import (
    INSET_PAD,
    Form,
    Line,
    Link,
    Look,
    Point,
    Shape,
    Stroke,
    Text,
)
from aseme_dsl.diagrams.compact.ink.signs import SIGNS
from aseme_dsl.diagrams.compact.words import ICON, width
from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.diagrams.look.inset import Inset, Outline, Oval, Part, Piece, Words
from tests.diagrams.pictures import SVG

_NUMBER = re.compile(r"-?[\d.]+")


def elements_of(root: Element) -> Iterator[Line | Shape | Text]:
    """The lines, shapes and texts of an SVG, in its order."""
    sign = ""
    insets = {item.get("data-in"): item for item in root if item.get("data-in")}
    for item in root:
        kinds = item.get("class", "").split()
        if item.tag == f"{SVG}g" and item.get("aria-hidden") and not item.get("data-n"):
            yield from elements_of(item)
        elif item.tag == f"{SVG}g" and "line" in kinds:
            yield _line(item)
        elif item.tag == f"{SVG}g" and "state" in kinds:
            shape = _shape(item)
            if shape.form is Form.NESTED:
                shape = replace(shape, inset=_inset(insets[shape.state], shape))
            yield shape
        elif item.tag == f"{SVG}path" and "icon" in kinds and "flap" not in kinds:
            sign = next(
                key
                for key, known in SIGNS.items()
                if known.colour == kinds[1]
                and known.solid == ("solid" in kinds)
                and len(_points(item.get("d", ""))) == sum(map(len, known.lines)) + 8 * bool(known.circle)
            )
        elif item.tag == f"{SVG}text" and "data-of" in item.attrib | {"data-of": ""}:
            yield _text(item, sign)
            sign = ""


def _line(item: Element) -> Line:
    path, *heads = item.iter(f"{SVG}path")
    chain = tuple(_link(part, ",") for part in item.get("data-c", "").split("|") if part)
    found = _corners(path.get("d", ""))
    return Line(found, chain, Stroke(path.get("class", "")), bool(heads))


def _shape(item: Element) -> Shape:
    state, *also = item.get("data-n", "").split()
    body = next(part for part in item.iter() if part.tag not in (f"{SVG}title", f"{SVG}g"))
    kind = body.get("class", "")
    form = Form.PROTOCOL if re.fullmatch(r"p\d", kind) else Form(kind)
    marks = _link(item.get("data-t", ""), " ")
    if body.tag == f"{SVG}rect":
        x, y, wide, high = (float(body.get(name, "")) for name in ("x", "y", "width", "height"))
    elif body.tag == f"{SVG}circle":
        x, y, radius = (float(body.get(name, "")) for name in ("cx", "cy", "r"))
        x, y, wide, high = x - radius, y - radius, 2 * radius, 2 * radius
    elif form is Form.ENDLESS:
        x, y = map(float, _NUMBER.findall(body.get("transform", "")))
        y, wide, high = y - 5, 16.0, 10.0
    elif form is Form.FIELD:
        x, y, right = map(float, _NUMBER.findall(body.get("d", "")))
        wide, high = right - x, 0.0
    else:
        corners = _points(body.get("d", ""))
        x, y = min(a for a, _ in corners), min(b for _, b in corners)
        wide, high = max(a for a, _ in corners) - x, max(b for _, b in corners) - y
    return Shape(form, x, y, wide, high, state, marks, tuple(also))


def _inset(item: Element, around: Shape) -> Inset:
    """The picture of a nested state, which has the rest of its border."""
    dx, dy = map(float, _NUMBER.findall(item.get("data-at", "")))
    pieces = tuple(part for piece in item for part in _pieces(piece, (-dx, -dy)))
    right, low = around.x + around.width - INSET_PAD, around.y + around.height - INSET_PAD
    return Inset(right - dx, low - dy, pieces)


def _pieces(item: Element, move: Point) -> Iterator[Piece]:
    name = item.get("id") or (f"n{item.get('data-n')}" if item.get("data-n") else "")
    tip = next((inner.text or "" for inner in item if inner.tag == f"{SVG}title"), "")
    inside = [inner for inner in item if inner.tag != f"{SVG}title"]
    parts = tuple(_part(inner, move) for inner in inside if not inner.get("data-part"))
    yield Piece(name, Kind(item.get("data-kind", "")), parts, tip)
    for other in (inner for inner in inside if inner.get("data-part")):
        parts = tuple(_part(inner, move) for inner in other)
        yield Piece(f"{name}.{other.get('data-part')}", Kind(other.get("data-kind", "")), parts)


def _part(item: Element, move: Point) -> Part:
    looks = item.get("class", "").split()
    fill = next((look[2:] for look in looks if look.startswith("f-")), "").replace("none", "")
    ink = next((look[2:] for look in looks if look.startswith("i-")), "").replace("none", "")
    x, y = (
        float(item.get(name) or item.get(f"c{name}") or 0) + by for name, by in zip("xy", move, strict=True)
    )
    match item.tag.removeprefix(SVG):
        case "text":
            size = next(float(look[1:]) for look in looks if re.fullmatch(r"s\d+", look))
            bold, middle = item.get("font-weight") == "bold", item.get("text-anchor") == "middle"
            return Words(x, y, item.text or "", size, fill, bold, middle)
        case "ellipse":
            return Oval(x, y, float(item.get("rx", "")), float(item.get("ry", "")), fill, ink)
        case "rect":
            right, low = x + float(item.get("width", "")), y + float(item.get("height", ""))
            return Outline(((x, y), (right, y), (right, low), (x, low)), fill, ink, item.get("rx") != "0")
        case _:
            points = _points(item.get("d") or item.get("points") or "")
            moved = tuple((a + move[0], b + move[1]) for a, b in points)
            return Outline(moved, fill, ink, "C" in item.get("d", ""), "dashed" in looks)


def _text(item: Element, sign: str) -> Text:
    look = Look(item.get("class", ""))
    x, y = float(item.get("x", "")), float(item.get("y", ""))
    said = f"{sign} {item.text or ''}".strip() if sign else item.text or ""
    of = item.get("data-of")
    left, place = x - (ICON if sign else 0), None if of is None else int(of)
    return Text(left, y, said, look, width(said, look), place, item.get("data-n", ""))


def _link(text: str, separator: str) -> Link:
    return tuple(map(int, filter(None, text.split(separator))))


def _points(path: str) -> list[Point]:
    numbers = [float(found) for found in _NUMBER.findall(path)]
    return list(zip(numbers[::2], numbers[1::2], strict=False))


def _corners(path: str) -> tuple[Point, ...]:
    """The points of a line with round corners: its ends, and the middle of each corner."""
    found = [_points(part)[0] for part in re.findall(r"[MQ][^MLQ]*", path)]
    return (*found, _points(path)[-1])
