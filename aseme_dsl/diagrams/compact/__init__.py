"""The compact drawing of a statechart: one line from state to state, laid out like a railroad diagram."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import assert_never

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.blocks import NotCompact
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import Form, Line, Nested, Picture, Shape, Text
from aseme_dsl.diagrams.compact.ink.svg import svg, text_id
from aseme_dsl.diagrams.compact.ink.xdot import dot
from aseme_dsl.diagrams.compact.layout import scale, texts_of
from aseme_dsl.diagrams.compact.pages import Page, divided, whole
from aseme_dsl.diagrams.look.dot import Kind, Shown
from aseme_dsl.diagrams.look.drawing import Drawing, NoSuchState, Options, PageSize, piece_name
from aseme_dsl.diagrams.look.inset import Piece

__all__ = ["drawings"]


def drawings(
    chart: Statechart,
    options: Options,
    activities: Iterable[Activity] = (),
    alone: bool = False,
    nested: Nested | None = None,
) -> list[Drawing] | str:
    """The compact drawing of a chart, in pages if `options` ask for them, or why there is none that is right.

    If it is to stand `alone`, it is the first page, which leads to no other. What has no compact form is
    drawn by `nested` in its place; without that, it is a closed box.
    Raises NoSuchState if the chart has no state `options.at`.
    """
    known = tuple(activities)
    top = options.at or chart.root.label
    if top not in chart.by_label:
        raise NoSuchState(f"the statechart {chart.name} has no state {top}")
    if chart.node(top).type is not StateType.OR:
        return f"state {top} is not an OR state"
    try:
        if options.page is not None:
            most = 1 if alone else None
            pages: Sequence[Page] = tuple(islice(divided(chart, known, top, options.page.room, nested), most))
        else:
            pages = (whole(chart, known, top, options.depth, nested),)
    except NotCompact as reason:
        return str(reason)
    for page in pages:
        found = [
            fault for part in (page.picture, *page.picture.texts) for fault in faults(chart, part, known)
        ]
        if found:
            return f"the compact drawing is not right: {found[0]}"
    files = {page.top: f"{_name(chart, page.top)}.svg" for page in pages}
    files |= {texts_of(page.top): f"{_name(chart, page.top)}.texts.svg" for page in pages}
    return [drawing for page in pages for drawing in _drawings(chart, page, files, options.page)]


def _name(chart: Statechart, top: str) -> str:
    name = f"{chart.kind.lower()}.{chart.name}"
    return name if top == chart.root.label else piece_name(name, top)


def _drawings(
    chart: Statechart, page: Page, files: dict[str, str], size: PageSize | None
) -> Iterator[Drawing]:
    """The drawing of a page, and those of its texts."""
    picture, name = page.picture, _name(chart, page.top)
    paper = size.paper if size is not None else None
    drawn = svg(chart, picture, files={top: file for top, file in files.items() if top != page.top})
    shapes = (item for item in picture.elements if isinstance(item, Shape))
    closed = tuple(item.state for item in shapes if item.form is Form.CLOSED)
    measures = picture.width, picture.height
    notes = list(_left_out(picture, name))
    if size is not None and scale(picture, size.room) < 1:
        percent = f"{scale(picture, size.room):.0%}"
        notes.append(f"{name} has no smaller formula to close: it fits on the page at {percent}")
    made = Drawing(
        name,
        dot(chart, picture, paper),
        _shown(picture),
        picture=drawn,
        note="; ".join(notes),
        closed=closed,
        size=measures,
    )
    yield made
    for number, texts in enumerate(picture.texts, 1):
        called = f"{name}.texts{number if number > 1 else ''}"
        yield Drawing(called, dot(chart, texts, paper), picture=svg(chart, texts, files=files))


def _left_out(picture: Picture, name: str) -> Iterator[str]:
    """What must be said of the parts that have no compact drawing."""
    for item in picture.elements:
        if not isinstance(item, Shape) or not item.reason:
            continue
        if item.inset is not None:
            yield f"state {item.state} of {name} is drawn nested: {item.reason}"
        else:
            yield f"{name} is without the inside of state {item.state}: {item.reason}"


def _turns(piece: Piece) -> bool:
    """Whether a piece is a turn of a line, which has the rest of the line in the drawing."""
    return piece.id[:1] == "t" and "." in piece.id


def _shown(picture: Picture) -> tuple[Shown, ...]:
    """The elements that have an id: states, and transitions with their lines and texts."""
    found: list[Shown] = []
    texts: Counter[int] = Counter()
    for item in picture.elements:
        match item:
            case Shape():
                found += (Shown(f"n{label}", Kind.BOX) for label in (item.state, *item.also))
                pieces = item.inset.pieces if item.inset is not None else ()
                inner = (piece for piece in pieces if piece.id not in ("", f"n{item.state}"))
                found += (Shown(piece.id, piece.kind) for piece in inner if not _turns(piece))
            case Line():
                found += (Shown(f"t{place}", Kind.LINE) for link in item.chain for place in link)
            case Text(of=int(place)):
                found.append(Shown(text_id(place, texts[place]), Kind.LINE))
                texts[place] += 1
            case Text():
                found += [Shown(f"n{item.state}", Kind.LINE)] if item.state else []
            case _:
                assert_never(item)
    return tuple(found)
