"""SVG: what Graphviz drew, made the same everywhere, and compared with what the drawing must show."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from xml.etree import ElementTree
from xml.sax.saxutils import escape

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.colours import night
from aseme_dsl.diagrams.look.dot import Kind, Shown
from aseme_dsl.diagrams.look.labels import printable

_COMMENT = re.compile(rb"<!--.*?-->\n?", re.DOTALL)
_DOCTYPE = re.compile(rb"<!DOCTYPE[^>]*>\n?")
_FONT = f'font-family="{style.FONT}"'.encode()
_FONTS = f'font-family="{style.FONTS}"'.encode()
_ROOT = re.compile(rb'<svg width="([\d.]+)pt" height="([\d.]+)pt"')
_NAME = re.compile(rb"<title>[^<]*</title>\n(?=(<g id=[^>]*><a [^>]*xlink:title=\"([^\"]*)\")?)")
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?|nan|inf", re.IGNORECASE)
_NAMESPACE = "{http://www.w3.org/2000/svg}"

_TOLERANCE = 2.0
"""How far a border may be drawn over the one around it, in points: about the width of a line."""

Frame = tuple[float, float, float, float]
"""Left, top, right and bottom of something drawn."""


def cleaned(svg: bytes, about: str) -> bytes:
    """The SVG as all drawings are: light and dark colours, and `about` as its title.

    Graphviz signs with its version in comments, and names elements where a reader expects their tips. One
    unit is one pixel, so that texts are as large as in the compact drawings.
    """
    svg = _DOCTYPE.sub(b"", _COMMENT.sub(b"", svg)).replace(_FONT, _FONTS)
    svg = _NAME.sub(lambda match: b"<title>%s</title>\n" % match[2] if match[1] else b"", svg)
    said = escape(printable(about), {'"': "&quot;"}).encode()
    root = b'<svg width="\\1" height="\\2" class="aseme-drawing" role="img" aria-label="%s"'
    head, border, rest = _ROOT.sub(root % said.replace(b"\\", b"\\\\"), svg, count=1).partition(b">\n<g ")
    look = f"<title>{said.decode()}</title>\n<style>{night(svg.decode())}</style>"
    return head + b">\n" + look.encode() + b"\n<g " + rest if border else svg


def faults(svg: bytes, shown: Sequence[Shown]) -> list[str]:
    """What the picture lacks or shows in the wrong place; empty if it is whole."""
    try:
        root = ElementTree.fromstring(svg)
    except ElementTree.ParseError as error:
        return [f"the SVG cannot be read: {error}"]
    elements = {element.get("id", ""): element for element in root.iter() if element.get("id")}
    found: list[str] = []
    frames: dict[str, Frame] = {}
    for item in shown:
        element = root if item.kind is Kind.SHEET else elements.get(item.id)
        if element is None:
            found.append(f"{item.id} is not drawn")
            continue
        text = _without_blanks("".join(_texts(element)))
        found += [
            f"{item.id} lacks the text {line!r}" for line in item.lines if _without_blanks(line) not in text
        ]
        if item.kind is Kind.SHEET:
            continue
        shape = _shape(element, item.kind)
        frame = None if shape is None else shape_frame(shape.attrib)
        if shape is None or frame is None:
            if item.kind is Kind.LINE or not text:  # a turning point may be nothing but its number
                found.append(f"{item.id} has no shape")
            continue
        if item.kind is Kind.GROUP and shape.get("stroke", "none") in ("none", "transparent"):
            found.append(f"{item.id} has no border")
        frames[item.id] = frame
        around = frames.get(item.inside or "")
        if around is not None and not _is_inside(frame, around):
            found.append(f"{item.id} is drawn outside of {item.inside}")
    return found


def _texts(element: ElementTree.Element) -> Iterator[str]:
    for text in element.iter(f"{_NAMESPACE}text"):
        yield "".join(text.itertext())


def _without_blanks(text: str) -> str:
    return "".join(text.split())


def _shape(element: ElementTree.Element, kind: Kind) -> ElementTree.Element | None:
    """The element's first shape: its border, or for a line its path."""
    names = ("path",) if kind is Kind.LINE else ("polygon", "path", "ellipse", "polyline")
    return next((shape for shape in element.iter() if shape.tag.removeprefix(_NAMESPACE) in names), None)


def shape_frame(attributes: Mapping[str, str]) -> Frame | None:
    """The frame of a polygon, path or ellipse; None if its numbers are none."""
    if "cx" in attributes:
        x, y, rx, ry = (float(attributes[name]) for name in ("cx", "cy", "rx", "ry"))
        frame = (x - rx, y - ry, x + rx, y + ry)
    else:
        numbers = [
            float(text) for text in _NUMBER.findall(attributes.get("points") or attributes.get("d") or "")
        ]
        if len(numbers) < 4:
            return None
        frame = (min(numbers[::2]), min(numbers[1::2]), max(numbers[::2]), max(numbers[1::2]))
    return frame if all(map(math.isfinite, frame)) else None


def _is_inside(inner: Frame, outer: Frame) -> bool:
    return (
        inner[0] >= outer[0] - _TOLERANCE
        and inner[1] >= outer[1] - _TOLERANCE
        and inner[2] <= outer[2] + _TOLERANCE
        and inner[3] <= outer[3] + _TOLERANCE
    )
