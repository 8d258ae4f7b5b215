"""PDF: the checked SVG of a drawing as vectors on one page, for a Graphviz that writes none."""

from __future__ import annotations

import math
import re
import zlib
from collections.abc import Iterator, Mapping, Sequence
from xml.etree import ElementTree

from aseme_dsl.diagrams.look.labels import text_width

_NAMESPACE = "{http://www.w3.org/2000/svg}"
_TOKEN = re.compile(r"[A-Za-z]|-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_TRANSLATE = re.compile(r"translate\(([-\d.]+)[ ,]+([-\d.]+)\)")
_COLOURS = {"black": (0.0, 0.0, 0.0), "white": (1.0, 1.0, 1.0)}

_LONGEST = 14400.0
"""A PDF page has at most so many units on a side; beyond, the unit grows."""

_KAPPA = 0.5522847498
"""How far the control points of a quarter of an ellipse are from its ends, in radii."""


def from_svg(svg: bytes) -> bytes:
    """The drawing as a PDF with Helvetica, which every viewer has. Same SVG, same bytes.

    Raises UnicodeEncodeError for text outside of Windows' Latin characters, which that font lacks.
    """
    root = ElementTree.fromstring(svg)
    left, top, width, height = (float(number) for number in root.attrib["viewBox"].split())
    unit = max(1.0, math.ceil(max(width, height) / _LONGEST))
    graph = root.find(f"{_NAMESPACE}g")
    assert graph is not None
    moved = _TRANSLATE.search(graph.get("transform", ""))
    x, y = (float(moved[1]), float(moved[2])) if moved else (0.0, 0.0)
    # From here on coordinates are those of the SVG, whose y grows downwards.
    operators = [f"{1 / unit:g} 0 0 {-1 / unit:g} {_n((x - left) / unit)} {_n((height - y + top) / unit)} cm"]
    for element in graph.iter():
        operators.extend(_drawn(element))
    return _document("\n".join(operators).encode("cp1252"), width / unit, height / unit, unit)


def _drawn(element: ElementTree.Element) -> Iterator[str]:
    attributes = element.attrib
    match element.tag.removeprefix(_NAMESPACE):
        case "polygon":
            yield from _painted([*_polyline(attributes["points"]), "h"], attributes)
        case "polyline":
            yield from _painted(_polyline(attributes["points"]), attributes)
        case "path":
            yield from _painted(_path(attributes["d"]), attributes)
        case "ellipse":
            yield from _painted(_ellipse(attributes), attributes)
        case "text":
            yield from _text("".join(element.itertext()), attributes)


def _n(number: float) -> str:
    return f"{number:.2f}".rstrip("0").rstrip(".")


def _colour(name: str) -> tuple[float, float, float] | None:
    if name in ("none", "transparent"):
        return None
    if name.startswith("#"):
        red, green, blue = (int(name[place : place + 2], 16) / 255 for place in (1, 3, 5))
        return red, green, blue
    return _COLOURS.get(name, (0.0, 0.0, 0.0))


def _painted(path: Sequence[str], attributes: Mapping[str, str]) -> Iterator[str]:
    fill, stroke = _colour(attributes.get("fill", "black")), _colour(attributes.get("stroke", "none"))
    if fill is None and stroke is None:
        return
    if fill is not None:
        yield f"{' '.join(map(_n, fill))} rg"
    if stroke is not None:
        dashes = attributes.get("stroke-dasharray", "").replace(",", " ")
        yield f"{' '.join(map(_n, stroke))} RG {attributes.get('stroke-width', '1')} w [{dashes}] 0 d"
    yield from path
    yield {(True, True): "B", (True, False): "f", (False, True): "S"}[fill is not None, stroke is not None]


def _polyline(points: str) -> list[str]:
    pairs = [pair.split(",") for pair in points.split()]
    return [f"{x} {y} {'l' if index else 'm'}" for index, (x, y) in enumerate(pairs)]


def _path(data: str) -> list[str]:
    """A path of moves, lines and curves in absolute coordinates, which is all that Graphviz writes."""
    operators: list[str] = []
    command = ""
    numbers: list[str] = []
    for token in _TOKEN.findall(data):
        if token.isalpha():
            command = token
            if token in "Zz":
                operators.append("h")
            continue
        numbers.append(token)
        if len(numbers) == (6 if command == "C" else 2):
            operators.append(f"{' '.join(numbers)} {dict(M='m', C='c').get(command, 'l')}")
            numbers = []
            command = "L" if command == "M" else command
    return operators


def _ellipse(attributes: Mapping[str, str]) -> list[str]:
    x, y, rx, ry = (float(attributes[name]) for name in ("cx", "cy", "rx", "ry"))
    kx, ky = rx * _KAPPA, ry * _KAPPA
    corners = [
        (x + rx, y + ky, x + kx, y + ry, x, y + ry),
        (x - kx, y + ry, x - rx, y + ky, x - rx, y),
        (x - rx, y - ky, x - kx, y - ry, x, y - ry),
        (x + kx, y - ry, x + rx, y - ky, x + rx, y),
    ]
    return [f"{_n(x + rx)} {_n(y)} m", *(f"{' '.join(map(_n, corner))} c" for corner in corners), "h"]


def _text(text: str, attributes: Mapping[str, str]) -> Iterator[str]:
    text = text.replace("\xa0", " ")
    size = float(attributes.get("font-size", "14"))
    x, y = float(attributes["x"]), float(attributes["y"])
    share = {"middle": 0.5, "end": 1.0}.get(attributes.get("text-anchor", "start"), 0.0)
    x -= share * text_width(text, size)
    font = "/Bold" if attributes.get("font-weight") == "bold" else "/Plain"
    escaped = text.replace("\\", "\\\\").replace("(", "\\(").replace(")", "\\)")
    colour = _colour(attributes.get("fill", "black")) or (0.0, 0.0, 0.0)
    look = f"{' '.join(map(_n, colour))} rg {font} {_n(size)} Tf"
    yield f"BT {look} 1 0 0 -1 {_n(x)} {_n(y)} Tm ({escaped}) Tj ET"


def _document(content: bytes, width: float, height: float, unit: float) -> bytes:
    def font(name: str) -> bytes:
        return f"<< /Type /Font /Subtype /Type1 /BaseFont /{name} /Encoding /WinAnsiEncoding >>".encode()

    packed = zlib.compress(content, 9)
    page = (
        f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {_n(width)} {_n(height)}] /UserUnit {_n(unit)} "
        "/Contents 4 0 R /Resources << /Font << /Plain 5 0 R /Bold 6 0 R >> >> >>"
    )
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        page.encode(),
        f"<< /Length {len(packed)} /Filter /FlateDecode >>\nstream\n".encode() + packed + b"\nendstream",
        font("Helvetica"),
        font("Helvetica-Bold"),
    ]
    written = bytearray(b"%PDF-1.6\n%\xe2\xe3\xcf\xd3\n")
    places = []
    for number, item in enumerate(objects, start=1):
        places.append(len(written))
        written += f"{number} 0 obj\n".encode() + item + b"\nendobj\n"
    start = len(written)
    table = "".join(f"{place:010d} 00000 n \n" for place in places)
    written += f"xref\n0 {len(objects) + 1}\n0000000000 65535 f \n{table}".encode()
    written += f"trailer\n<< /Size {len(objects) + 1} /Root 1 0 R >>\nstartxref\n{start}\n%%EOF\n".encode()
    return bytes(written)
