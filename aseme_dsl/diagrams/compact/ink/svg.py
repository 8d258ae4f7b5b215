"""SVG: a compact drawing as text, with what each element stands for in its id and its tip."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import assert_never
from xml.sax.saxutils import escape

from aseme_dsl.amola.statechart import Statechart, StateType, transition_text
from aseme_dsl.diagrams.compact.elements import (
    SIZES,
    STACKED,
    Form,
    Line,
    Picture,
    Point,
    Shape,
    Text,
)
from aseme_dsl.diagrams.compact.ink.colours import branch_colour, style
from aseme_dsl.diagrams.compact.ink.nested import colours, inset
from aseme_dsl.diagrams.compact.ink.reading import (
    headings,
    heard_before,
    in_order,
    is_frame,
    line_name,
    names,
    silent,
)
from aseme_dsl.diagrams.compact.ink.signs import ENDLESS, SIGNS, Sign
from aseme_dsl.diagrams.compact.words import BOLD, ICON
from aseme_dsl.diagrams.look.labels import printable, text_width

_RADIUS = 6.0
_HEAD = 7.0


def svg(
    chart: Statechart, picture: Picture, theme: str | None = None, files: Mapping[str, str] | None = None
) -> str:
    """The drawing in light and dark colours, or in those of one `theme` (`light`, `dark`) alone.

    A closed state that has one of the `files` leads there, and so does a name in the title.
    """
    files = files or {}
    width, height = picture.width, picture.height
    about = f"{chart.kind} {chart.name} of {chart.system}"
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" '
        f'viewBox="0 0 {width:g} {height:g}" class="aseme-compact" role="graphics-document document" '
        f'aria-label="{_text(about)}">',
        f"<title>{_text(about)}</title>",
        f"<style>{style(theme, *colours(picture))}</style>",
        f'<rect class="paper" width="{width:g}" height="{height:g}"/>',
    ]
    known: Counter[str] = Counter()
    heard = heard_before(chart, picture)
    spoken, unread, first = names(chart, picture), silent(picture), headings(picture)
    texts: dict[bool, list[str]] = {True: [], False: []}
    for item in in_order(chart, picture):
        for frame in heard.get(item, ()):
            parts.append(f'<g role="img" aria-label="{_text(spoken[frame])}">{_unseen(frame)}</g>')
        made = _element(chart, item, known, files, spoken)
        leads = files.get(item.state) if isinstance(item, Shape) and item.form is Form.CLOSED else None
        if isinstance(item, Text) and item not in first:
            texts[item in unread] += made
        else:
            parts += (f'<a href="{_text(leads)}">', *made, "</a>") if leads else made
    parts += ('<g aria-hidden="true">', *texts[True], "</g>", *texts[False])
    return "\n".join([*parts, "</svg>", ""])


def _element(
    chart: Statechart,
    item: Line | Shape | Text,
    known: Counter[str],
    files: Mapping[str, str],
    spoken: Mapping[Shape, str],
) -> Iterator[str]:
    match item:
        case Text():
            of = ""
            if item.of is not None:
                of = f' id="{text_id(item.of, known[f"t{item.of}"])}" data-of="{item.of}"'
                known[f"t{item.of}"] += 1
            elif item.state and not known[f"n{item.state}"]:
                of = f' id="n{item.state}" data-n="{item.state}"'
                known[f"n{item.state}"] += 1
            text, x = item.text, item.x
            if text[:1] in SIGNS:
                yield from _sign(SIGNS[text[0]], x, item.y)
                text, x = text[1:].lstrip(), x + ICON
            long = text_width(text, SIZES[item.look], bold=item.look in BOLD)  # in any font
            fixed = f' textLength="{long:.1f}" lengthAdjust="spacingAndGlyphs"' if long else ""
            back = files.get(item.leads)
            if back:
                yield f'<a href="{_text(back)}">'
            yield f'<text class="{item.look}" x="{x:.1f}" y="{item.y:.1f}"{fixed}{of}>{_text(text)}</text>'
            if back:
                yield "</a>"
        case Line():
            yield from _line(chart, item)
        case Shape():
            name = f"n{item.state}"  # a frame and the sign that it never ends have the same
            yield from _shape(chart, item, f' id="{name}"' if not known[name] else "", spoken.get(item, ""))
            yield from inset(chart, item)
            known[name] += 1
        case _:
            assert_never(item)


def _sign(sign: Sign, x: float, y: float) -> Iterator[str]:
    path = "".join(map(_straight, sign.lines))
    if sign.circle is not None:
        middle, centre, radius = sign.circle
        path += f"M{middle - radius:g} {centre:g}a{radius:g} {radius:g} 0 1 0 {2 * radius:g} 0"
        path += f"a{radius:g} {radius:g} 0 1 0 {-2 * radius:g} 0"
    place = f"translate({x:.1f} {y:.1f})"
    kind = f"icon {sign.colour}{' solid' if sign.solid else ''}"
    yield f'<path class="{kind}" d="{path}" transform="{place}"/>'
    if sign.flap:
        yield f'<path class="icon flap" d="{_straight(sign.flap)}" transform="{place}"/>'


def _straight(points: Sequence[Point]) -> str:
    return "M" + "L".join(f"{x:.4g} {y:.4g}" for x, y in points)


def _line(chart: Statechart, item: Line) -> Iterator[str]:
    places = [place for link in item.chain for place in link]
    tip = "\n".join(_told(chart, place) for place in places)
    chain = "|".join(",".join(map(str, link)) for link in item.chain)
    name = f' id="t{places[0]}"' if places else ""
    others = places[1:]
    role = f' role="img" aria-label="{_text(line_name(chart, item))}"' if tip else ""
    yield f'<g{name} class="line"{role} data-c="{chain}" data-t="{" ".join(map(str, places))}">'
    if tip:
        yield f"<title>{_text(tip)}</title>"
    yield "".join(f'<g id="t{place}">' for place in others)
    yield f'<path class="{item.stroke}" d="{_path(item.points)}"/>'
    if item.arrow:
        yield f'<path class="head {item.stroke}" d="{_straight(head(item.points))}Z"/>'
    yield "</g>" * (len(others) + 1)


def text_id(place: int, number: int) -> str:
    """The id of a text of a transition; the transition may have several."""
    return f"t{place}.{number}"


def _told(chart: Statechart, place: int) -> str:
    item = chart.transitions[place]
    ends = f"{_name(chart, item.source)} → {_name(chart, item.target)}"
    return f"{ends}: {transition_text(item) or 'when complete'}"


def _name(chart: Statechart, label: str) -> str:
    state = chart.node(label)
    return state.name if state.name != label else f"{state.type.value} {label}"


def _shape(chart: Statechart, item: Shape, name: str, spoken: str) -> Iterator[str]:
    state = chart.node(item.state)
    marks = f' data-t="{" ".join(map(str, item.marks))}"' if item.marks else ""
    tips = [f"{state.label} {state.type.value} {state.name}", *(_told(chart, place) for place in item.marks)]
    others = item.also
    role = f' role="img" aria-label="{_text(spoken)}"' if spoken else ' role="img"'
    if is_frame(item):
        role = ' aria-hidden="true"'  # read before what is inside, not where it is painted
    yield f'<g{name} class="state"{role} data-n="{" ".join((item.state, *item.also))}"{marks}>'
    if state.type not in (StateType.START, StateType.END):
        yield f"<title>{_text(chr(10).join(tips))}</title>"
    yield "".join(f'<g id="n{label}">' for label in others)
    x, y, width, height = item.x, item.y, item.width, item.height
    middle, centre = x + width / 2, y + height / 2
    box = f'x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"'
    match item.form:
        case Form.ACTIVITY | Form.FRAME | Form.PARALLEL | Form.CLOSED | Form.NESTED:
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
            number = branch_colour(chart, item.state)
            yield f'<rect class="p{number}" {box} rx="4"/>'
            yield f'<path class="p{number}" d="M{x + 2:.1f} {y:.1f}V{y + height:.1f}"/>'
        case Form.PILL:
            yield f'<rect class="pill" {box} rx="10"/>'
        case Form.ENDLESS:
            place = f"translate({x:.1f} {centre:.1f})"
            yield f'<path class="endless" d="{_straight(ENDLESS)}" transform="{place}"/>'
        case Form.STACK:
            yield f'<rect class="stack" {box} rx="8"/>'
            yield f'<path class="stack" d="{_path(behind(item))}"/>'
        case Form.FIELD:
            yield f'<path class="field" d="M{x:.1f} {y:.1f}H{x + width:.1f}"/>'
        case _:
            assert_never(item.form)
    yield "</g>" * (len(others) + 1)


def _unseen(item: Shape) -> str:
    """The place of a frame for a screen reader; nothing is painted there."""
    box = f'x="{item.x:.1f}" y="{item.y:.1f}" width="{item.width:.1f}" height="{item.height:.1f}"'
    return f'<rect {box} fill="none" stroke="none" pointer-events="none"/>'


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


def head(points: tuple[Point, ...]) -> tuple[Point, ...]:
    """The head of an arrow at the last point."""
    x, y = points[-1]
    before = next((p for p in reversed(points) if p != points[-1]), (x - 1, y))
    dx = (x > before[0]) - (x < before[0])
    dy = (y > before[1]) - (y < before[1])
    back_x, back_y = x - dx * _HEAD, y - dy * _HEAD
    side_x, side_y = dy * 3.5, dx * 3.5
    return (x, y), (back_x + side_x, back_y + side_y), (back_x - side_x, back_y - side_y)


def behind(item: Shape) -> tuple[Point, ...]:
    """What is seen of the sheet behind a stack."""
    left, top = item.x, item.y
    right, bottom = left + item.width, top + item.height
    far = STACKED
    return (
        (right, top + far),
        (right + far, top + far),
        (right + far, bottom + far),
        (left + far, bottom + far),
    )


def _text(text: str) -> str:
    return escape(printable(text), {'"': "&quot;"})


__all__ = ["behind", "head", "svg", "text_id"]
