"""The compact drawing of a statechart: one line from state to state, laid out like a railroad diagram."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.blocks import NotCompact
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import Line, Picture, Shape
from aseme_dsl.diagrams.compact.layout import layout
from aseme_dsl.diagrams.compact.svg import svg
from aseme_dsl.diagrams.look.dot import Kind, Shown
from aseme_dsl.diagrams.look.drawing import Drawing

__all__ = ["drawing"]


def drawing(chart: Statechart, activities: Iterable[Activity] = ()) -> Drawing | str:
    """The compact drawing of a chart, or why there is none that is right."""
    known = tuple(activities)
    try:
        picture = layout(chart, known)
    except NotCompact as reason:
        return str(reason)
    if found := faults(chart, picture, known):
        return f"the compact drawing is not right: {found[0]}"
    name = f"{chart.kind.lower()}.{chart.name}"
    return Drawing(name, "", _shown(picture), picture=svg(chart, picture))


def _shown(picture: Picture) -> tuple[Shown, ...]:
    """The elements that have an id: states, and lines by their first transition."""
    found: list[Shown] = []
    for item in picture.elements:
        if isinstance(item, Shape):
            found.append(Shown(f"n{item.state}", Kind.BOX))
        elif isinstance(item, Line) and item.chain:
            found.append(Shown(f"t{item.chain[0][0]}", Kind.LINE))
    return tuple(found)
