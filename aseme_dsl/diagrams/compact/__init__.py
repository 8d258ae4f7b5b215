"""The compact drawing of a statechart: one line from state to state, laid out like a railroad diagram."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.blocks import NotCompact
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import Line, Picture, Shape
from aseme_dsl.diagrams.compact.ink.svg import svg
from aseme_dsl.diagrams.compact.ink.xdot import dot
from aseme_dsl.diagrams.compact.layout import scale
from aseme_dsl.diagrams.compact.pages import Page, divided, whole
from aseme_dsl.diagrams.look.dot import Kind, Shown
from aseme_dsl.diagrams.look.drawing import Drawing, NoSuchState, Options, piece_name

__all__ = ["drawings"]


def drawings(chart: Statechart, options: Options, activities: Iterable[Activity] = ()) -> list[Drawing] | str:
    """The compact drawing of a chart, in pages if `options` ask for them, or why there is none that is right.

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
            pages: Sequence[Page] = tuple(divided(chart, known, top, options.page.room))
        else:
            pages = (whole(chart, known, top, options.depth),)
    except NotCompact as reason:
        return str(reason)
    for page in pages:
        if found := faults(chart, page.picture, known):
            return f"the compact drawing is not right: {found[0]}"
    size = options.page.room if options.page is not None else None
    files = {page.top: f"{_name(chart, page.top)}.svg" for page in pages}
    return [_drawing(chart, page, files, size) for page in pages]


def _name(chart: Statechart, top: str) -> str:
    name = f"{chart.kind.lower()}.{chart.name}"
    return name if top == chart.root.label else piece_name(name, top)


def _drawing(
    chart: Statechart, page: Page, files: dict[str, str], size: tuple[float, float] | None
) -> Drawing:
    picture, name = page.picture, _name(chart, page.top)
    drawn = svg(chart, picture, files={top: name for top, name in files.items() if top != page.top})
    made = Drawing(name, dot(chart, picture), _shown(picture), picture=drawn)
    if size is None or scale(picture, size) >= 1:
        return made
    percent = f"{scale(picture, size):.0%}"
    return replace(made, note=f"{name} has no smaller formula to close: it fits on the page at {percent}")


def _shown(picture: Picture) -> tuple[Shown, ...]:
    """The elements that have an id: states, and lines by their first transition."""
    found: list[Shown] = []
    for item in picture.elements:
        if isinstance(item, Shape):
            found.append(Shown(f"n{item.state}", Kind.BOX))
        elif isinstance(item, Line) and item.chain:
            found.append(Shown(f"t{item.chain[0][0]}", Kind.LINE))
    return tuple(found)
