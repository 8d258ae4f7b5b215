"""Pictures: the statecharts of both versions, with what was added, changed and removed.

Above is the new version, with `+` at what was added and `~` at what was changed. Below is the old one, with
`-` at what was removed, if anything was removed or changed. Each sort has a colour, a sign and a kind of
line: paper without colours shows it, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree as Xml

from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams import Options, draw_one
from aseme_dsl.project.comparing.behaviour import Result
from aseme_dsl.project.comparing.elements import Element
from aseme_dsl.project.comparing.report import Report
from aseme_dsl.project.comparing.structure import Sort, Structure

_SVG = "http://www.w3.org/2000/svg"
_HEAD = 34.0
"""How much room a heading takes, in px."""
_RADIUS = 7.0

_LIGHT = {"added": "#1a7f37", "changed": "#9a6700", "removed": "#cf222e"}
_DARK = {"added": "#56d364", "changed": "#e3b341", "removed": "#ff7b72"}
_DASHES = {"added": "none", "changed": "9 3", "removed": "2 3"}
_SIGNS = {"added": "+", "changed": "~", "removed": "-"}

Marks = Mapping[str, str]
"""What was done to states (`n0.2`) and transitions (`t12`)."""


def pictures(report: Report) -> Iterator[tuple[str, bytes]]:
    """The file names and contents of drawings: of each statechart in which something is different."""
    old, new = report.old.system, report.new.system
    assert old is not None and new is not None
    for name in dict.fromkeys(item.chart for item in report.results if _is_drawn(item)):
        before = _before(name, report.structure)
        first, second = old.chart(before), new.chart(name)
        if first is not None and second is not None:
            ours = _marks(report.structure, first, is_old=True)
            theirs = _marks(report.structure, second, is_old=False)
            yield f"{name}.diff.svg", _drawn((new, name, theirs), (old, before, ours))


def _is_drawn(result: Result) -> bool:
    return bool(result.chart) and not result.is_unchanged


def _before(name: str, structure: Structure) -> str:
    kind, _, owner = name.partition(".")
    renamed = structure.names.get("role" if kind == "iac" else "protocol", {})
    return f"{kind}.{next((old for old, new in renamed.items() if new == owner), owner)}"


# ---- what is marked -----------------------------------------------------------------------------------


def _marks(structure: Structure, chart: Statechart, *, is_old: bool) -> Marks:
    found: dict[str, str] = {}
    for change in structure.changes:
        if change.sort is Sort.RENAMED:
            continue
        element = change.old if is_old else change.new
        if element is not None:
            found |= {key: change.sort.value for key in _places(element, chart)}
    return found


def _places(element: Element, chart: Statechart) -> Iterator[str]:
    span = element.span
    match element.kind:
        case "transition":
            for place, transition in enumerate(chart.transitions):
                if (transition.span.start, transition.span.source.path) == (span.start, span.source.path):
                    yield f"t{place}"
        case "state" | "activity":
            name, _, number = element.name.partition("#")
            states = [s for s in chart.states if s.type is StateType.BASIC and name in (s.name, s.activity)]
            chosen = states[int(number) - 1 : int(number)] if number else states
            yield from (f"n{state.label}" for state in chosen)
        case "formula":
            for state in chart.states:
                if state.name == element.name and state.type in (StateType.OR, StateType.AND):
                    yield f"n{state.label}"


# ---- how it is drawn ----------------------------------------------------------------------------------


def _drawn(new: tuple[System, str, Marks], old: tuple[System, str, Marks]) -> bytes:
    Xml.register_namespace("", _SVG)
    parts = []
    for system, name, marks in (new, old) if old[2] else (new,):
        drawing = draw_one(system, name, Options())
        parts.append((drawing.picture if drawing is not None else "", marks))
    trees = [_marked(picture, marks) for picture, marks in parts if picture]
    width = max((_size(tree)[0] for tree in trees), default=200.0)
    height = sum(_size(tree)[1] + _HEAD for tree in trees)
    root = Xml.Element(
        f"{{{_SVG}}}svg",
        {"width": f"{width:g}", "height": f"{height:g}", "viewBox": f"0 0 {width:g} {height:g}"},
    )
    root.set("class", "aseme-diff")
    style = Xml.SubElement(root, f"{{{_SVG}}}style")
    style.text = _style()
    Xml.SubElement(root, f"{{{_SVG}}}rect", {"class": "paper", "width": "100%", "height": "100%"})
    y = 0.0
    titles = ("NEW:  + added  ~ changed", "OLD:  - removed  ~ changed")
    for number, tree in enumerate(trees):
        heading = Xml.SubElement(root, f"{{{_SVG}}}text", {"x": "14", "y": f"{y + 22:g}", "class": "heading"})
        heading.text = titles[number]
        tree.set("x", "0")
        tree.set("y", f"{y + _HEAD:g}")
        if number:
            _rename(tree)
        root.append(tree)
        y += _HEAD + _size(tree)[1]
    return bytes(Xml.tostring(root, encoding="utf-8", xml_declaration=False))


def _size(tree: Xml.Element) -> tuple[float, float]:
    return float(tree.get("width", "0")), float(tree.get("height", "0"))


def _rename(tree: Xml.Element) -> None:
    """The second drawing in a file has ids of its own."""
    for item in tree.iter():
        if (name := item.get("id")) is not None:
            item.set("id", f"old-{name}")


def _marked(picture: str, marks: Marks) -> Xml.Element:
    tree = Xml.fromstring(picture)  # our own drawing
    badges: list[tuple[float, float, str]] = []
    for item in tree.iter(f"{{{_SVG}}}g"):
        sort = _sort_of(item, marks)
        if sort is None:
            continue
        item.set("class", f"{item.get('class', '')} diff-{sort}".strip())
        place = _corner(item)
        if place is not None:
            badges.append((*place, sort))
    for x, y, sort in badges:
        badge = Xml.SubElement(tree, f"{{{_SVG}}}g", {"class": f"badge diff-{sort}"})
        Xml.SubElement(badge, f"{{{_SVG}}}circle", {"cx": f"{x:g}", "cy": f"{y:g}", "r": f"{_RADIUS:g}"})
        at = {"x": f"{x:g}", "y": f"{y + 4:g}", "text-anchor": "middle"}
        Xml.SubElement(badge, f"{{{_SVG}}}text", at).text = _SIGNS[sort]
    return tree


def _sort_of(item: Xml.Element, marks: Marks) -> str | None:
    """What was done to what a group stands for: a state by its id, a line or text by its transitions."""
    name = item.get("id", "")
    if name.startswith("n"):
        return marks.get(name)
    if name.startswith("t"):
        numbers = (item.get("data-t") or name.removeprefix("t").partition(".")[0]).split()
        return next((marks[f"t{number}"] for number in numbers if f"t{number}" in marks), None)
    return None


def _corner(item: Xml.Element) -> tuple[float, float] | None:
    """Where the sign of a group stands: at the corner of a box, or near the beginning of a line."""
    box = item.find(f"{{{_SVG}}}rect")
    if box is not None:
        return float(box.get("x", "0")), float(box.get("y", "0"))
    path = item.find(f".//{{{_SVG}}}path")
    found = _POINTS.findall(path.get("d", "")) if path is not None else []
    if len(found) < 2:
        return None
    (x, y), (other, below) = ((float(one), float(two)) for one, two in found[:2])
    return x + (other - x) * 0.3, y + (below - y) * 0.3


_POINTS = re.compile(r"(-?\d+(?:\.\d+)?) (-?\d+(?:\.\d+)?)")


def _style() -> str:
    light, dark = _colours(_LIGHT, "#ffffff", "#1b1f24"), _colours(_DARK, "#11151a", "#e6edf3")
    return f"{light}\n@media (prefers-color-scheme:dark){{{dark}}}"


def _colours(colours: Mapping[str, str], paper: str, ink: str) -> str:
    font = "font-family:Arial,Liberation Sans,Helvetica,DejaVu Sans Condensed,sans-serif"
    rules = [
        f".aseme-diff .paper{{fill:{paper}}}",
        f".aseme-diff .heading{{{font};font-size:14px;font-weight:bold;fill:{ink}}}",
    ]
    for sort, colour in colours.items():
        scope = f".aseme-diff .aseme-compact .diff-{sort}"
        line = "line-through" if sort == "removed" else "none"
        rules += [
            f"{scope} rect,{scope} path{{stroke:{colour};stroke-width:2.6;stroke-dasharray:{_DASHES[sort]}}}",
            f"{scope} path.head{{fill:{colour};stroke:none}}",
            f"{scope} text{{fill:{colour};text-decoration:{line}}}",
            f"{scope}.badge circle{{fill:{paper};stroke:{colour};stroke-width:1.6}}",
            f"{scope}.badge text{{fill:{colour};font-weight:bold;text-decoration:none}}",
        ]
    return "\n".join(rules)


__all__ = ["pictures"]
