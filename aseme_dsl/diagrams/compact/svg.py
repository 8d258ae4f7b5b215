"""SVG: a compact drawing as text, with what each element stands for in its id and its tip."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never
from xml.sax.saxutils import escape

from aseme_dsl.amola.statechart import OriginKind, Statechart, StateType, transition_text
from aseme_dsl.diagrams.compact.colours import style
from aseme_dsl.diagrams.compact.elements import Form, Line, Picture, Point, Shape, Text
from aseme_dsl.diagrams.compact.words import ICON
from aseme_dsl.diagrams.look.labels import printable

_RADIUS = 6.0
_HEAD = 7.0

_ICONS = {
    "⚡": ("cut whole", "M7 -11L0.5 -4H4L2 1L9.5 -6H6Z"),
    "↯": ("cut", "M7 -11L0.5 -4H4L2 1L9.5 -6H6Z"),
    "✕": ("failed", "M1.5 -8.5L8.5 -1.5M8.5 -8.5L1.5 -1.5"),
    "↻": ("", "M9 -4A4 4 0 1 1 5 -8M5 -10.5V-5.5L8 -8Z"),
    "◷": ("", "M11 -4.2A5.2 5.2 0 1 0 0.6 -4.2A5.2 5.2 0 1 0 11 -4.2M5.8 -7.4V-4.2L8.4 -2.6"),
    "✉": ("message", "M0.5 -8.5H12V-0.5H0.5ZL6.2 -4L12 -8.5"),
    "➤": ("sent", "M0.5 -8.5H12V-0.5H0.5Z"),
    "Ⓗ": (
        "",
        "M12 -4.2A5.7 5.7 0 1 0 0.6 -4.2A5.7 5.7 0 1 0 12 -4.2M4.2 -7.2V-1.2M8.4 -7.2V-1.2M4.2 -4.2H8.4",
    ),
}
"""Signs that not every font has, drawn from the left end of the base line, with what they are."""


def svg(chart: Statechart, picture: Picture, theme: str | None = None) -> str:
    """The drawing in light and dark colours, or in those of one `theme` (`light`, `dark`) alone."""
    width, height = picture.width, picture.height
    about = f"{chart.kind} {chart.name} of {chart.system}"
    order = sorted(picture.elements, key=_layer)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" '
        f'viewBox="0 0 {width:g} {height:g}" role="img" aria-label="{_text(about)}">',
        f"<title>{_text(about)}</title>",
        f"<style>{style(theme)}</style>",
        f'<rect class="paper" width="{width:g}" height="{height:g}"/>',
    ]
    for item in order:
        parts += _element(chart, item)
    return "\n".join([*parts, "</svg>", ""])


def _layer(item: Line | Shape | Text) -> int:
    """Frames are at the back, outer ones first, as they are wider; texts in front."""
    match item:
        case Shape():
            return -round(item.width) if item.form in (Form.FRAME, Form.PARALLEL, Form.PROTOCOL) else 2
        case Line():
            return 1
        case Text():
            return 3
        case _:
            assert_never(item)


def _element(chart: Statechart, item: Line | Shape | Text) -> Iterator[str]:
    match item:
        case Text():
            of = "" if item.of is None else f' data-of="{item.of}"'
            text, x = item.text, item.x
            if text[:1] in _ICONS and text:
                place = f"translate({x:.1f} {item.y:.1f})"
                kind, path = _ICONS[text[0]]
                yield f'<path class="icon {kind}" d="{path}" transform="{place}"/>'
                if kind == "sent":
                    yield f'<path class="flap" d="M0.5 -8.5L6.2 -4L12 -8.5" transform="{place}"/>'
                text, x = text[1:].lstrip(), x + ICON
            yield f'<text class="{item.look}" x="{x:.1f}" y="{item.y:.1f}"{of}>{_text(text)}</text>'
        case Line():
            yield from _line(chart, item)
        case Shape():
            yield from _shape(chart, item)
        case _:
            assert_never(item)


def _line(chart: Statechart, item: Line) -> Iterator[str]:
    places = [place for link in item.chain for place in link]
    tip = "\n".join(_told(chart, place) for place in places)
    chain = "|".join(",".join(map(str, link)) for link in item.chain)
    name = f' id="t{places[0]}"' if places else ""
    yield f'<g{name} class="line" data-c="{chain}" data-t="{" ".join(map(str, places))}">'
    if tip:
        yield f"<title>{_text(tip)}</title>"
    yield f'<path class="{item.stroke}" d="{_path(item.points)}"/>'
    if item.arrow and item.chain:
        yield f'<path class="head {item.stroke}" d="{_head(item.points)}"/>'
    yield "</g>"


def _told(chart: Statechart, place: int) -> str:
    item = chart.transitions[place]
    ends = f"{_name(chart, item.source)} → {_name(chart, item.target)}"
    return f"{ends}: {transition_text(item) or 'when complete'}"


def _name(chart: Statechart, label: str) -> str:
    state = chart.node(label)
    return state.name if state.name != label else f"{state.type.value} {label}"


def _shape(chart: Statechart, item: Shape) -> Iterator[str]:
    state = chart.node(item.state)
    marks = f' data-t="{" ".join(map(str, item.marks))}"' if item.marks else ""
    tips = [f"{state.label} {state.type.value} {state.name}", *(_told(chart, place) for place in item.marks)]
    yield f'<g id="n{state.label}" class="state" data-n="{state.label}"{marks}>'
    if state.type not in (StateType.START, StateType.END):
        yield f"<title>{_text(chr(10).join(tips))}</title>"
    x, y, width, height = item.x, item.y, item.width, item.height
    middle, centre = x + width / 2, y + height / 2
    box = f'x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"'
    match item.form:
        case Form.ACTIVITY | Form.FRAME | Form.PARALLEL | Form.CLOSED:
            yield f'<rect class="{item.form}" {box} rx="8"/>'
        case Form.CHOICE:
            corners = f"M{middle:.1f} {y:.1f}L{x + width:.1f} {centre:.1f}L{middle:.1f} {y + height:.1f}"
            yield f'<path class="choice" d="{corners}L{x:.1f} {centre:.1f}Z"/>'
        case Form.INITIAL:
            yield f'<circle class="initial" cx="{middle:.1f}" cy="{centre:.1f}" r="{width / 2:.1f}"/>'
        case Form.FINAL:
            yield f'<circle class="final" cx="{middle:.1f}" cy="{centre:.1f}" r="{width / 2:.1f}"/>'
            yield f'<circle class="dot" cx="{middle:.1f}" cy="{centre:.1f}" r="3"/>'
        case Form.PROTOCOL:
            number = _protocol(chart, item.state)
            yield f'<rect class="p{number}" {box} rx="4"/>'
            yield f'<path class="p{number}" d="M{x + 2:.1f} {y:.1f}V{y + height:.1f}"/>'
        case Form.PILL:
            yield f'<rect class="pill" {box} rx="10"/>'
        case Form.ENDLESS:
            curve = "M8 0C5.5 -3.5 1 -3.5 1 0S5.5 3.5 8 0S15 -3.5 15 0S10.5 3.5 8 0Z"
            yield f'<path class="endless" d="{curve}" transform="translate({x:.1f} {centre:.1f})"/>'
        case Form.FIELD:
            yield f'<path class="field" d="M{x:.1f} {y:.1f}H{x + width:.1f}"/>'
        case _:
            assert_never(item.form)
    yield "</g>"


def _protocol(chart: Statechart, label: str) -> int:
    """The number of the colour of a branch: each protocol has one."""
    kind = OriginKind.PROTOCOL
    owners = dict.fromkeys(item.origin.owner for item in chart.states if item.origin.kind is kind)
    return list(owners).index(chart.node(label).origin.owner) % 4


def _path(points: tuple[Point, ...]) -> str:
    """A line with round corners."""
    kept = [p for n, p in enumerate(points) if n == 0 or p != points[n - 1]]
    parts = [f"M{kept[0][0]:.1f} {kept[0][1]:.1f}"]
    for before, here, after in zip(kept, kept[1:], kept[2:], strict=False):
        near, far = _towards(here, before), _towards(here, after)
        parts.append(f"L{near[0]:.1f} {near[1]:.1f}Q{here[0]:.1f} {here[1]:.1f} {far[0]:.1f} {far[1]:.1f}")
    parts.append(f"L{kept[-1][0]:.1f} {kept[-1][1]:.1f}")
    return "".join(parts)


def _towards(start: Point, end: Point) -> Point:
    """A point on the way from one to another, at most a radius away."""
    length = abs(end[0] - start[0]) + abs(end[1] - start[1])
    part = min(_RADIUS, length / 2) / length
    return start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part


def _head(points: tuple[Point, ...]) -> str:
    """The head of an arrow at the last point."""
    x, y = points[-1]
    before = next((p for p in reversed(points) if p != points[-1]), (x - 1, y))
    dx = (x > before[0]) - (x < before[0])
    dy = (y > before[1]) - (y < before[1])
    back_x, back_y = x - dx * _HEAD, y - dy * _HEAD
    side_x, side_y = dy * 3.5, dx * 3.5
    left, right = (back_x + side_x, back_y + side_y), (back_x - side_x, back_y - side_y)
    return f"M{x:.1f} {y:.1f}L{left[0]:.1f} {left[1]:.1f}L{right[0]:.1f} {right[1]:.1f}Z"


def _text(text: str) -> str:
    return escape(printable(text), {'"': "&quot;"})


__all__ = ["svg"]
