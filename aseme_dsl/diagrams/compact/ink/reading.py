"""Reading: in what order the elements of a compact drawing stand in its file, and what is said of each.

A screen reader reads a state, then the lines that leave it. What is written at lines and in states is said
with them, so their texts are not read a second time.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.elements import Element, Form, Line, Picture, Shape, Text

_FRAMES = (Form.FRAME, Form.PARALLEL, Form.PROTOCOL, Form.STACK)
_SIGNS = {
    Form.CHOICE: "choice",
    Form.INITIAL: "start",
    Form.FINAL: "end",
    Form.STACK: "several equal regions",
}


def in_order(chart: Statechart, picture: Picture) -> list[Element]:
    """The elements from back to front: frames, states with the lines that leave them, texts."""
    places = {state.label: place for place, state in enumerate(chart.states)}

    def key(item: Element) -> tuple[int, int, int]:
        match item:
            case Shape():
                if item.form in _FRAMES:
                    return 0, -round(item.width), 0
                return 1, places[item.state], 0
            case Line():
                source = chart.transitions[item.chain[0][0]].source if item.chain else None
                return 1, -1 if source is None else places[source], 1
            case Text():
                return 2, 0, 0
            case _:
                assert_never(item)

    return sorted(picture.elements, key=key)


def names(chart: Statechart, picture: Picture) -> dict[Shape, str]:
    """What a screen reader says of each state and sign."""
    said: dict[Shape, str] = {}
    for shape, texts in _written(picture):
        inside = ", ".join(item.text for item in texts)
        state = chart.node(shape.state)
        match shape.form:
            case Form.ACTIVITY:
                said[shape] = f"activity {inside}"
            case Form.PILL:
                said[shape] = f"always {inside}"
            case Form.CLOSED:
                said[shape] = f"closed {inside}"
            case Form.ENDLESS:
                said[shape] = f"{_called(chart, shape.state)} never ends"
            case Form.FIELD:
                said[shape] = f"region {_called(chart, shape.state)}"
            case Form.FRAME | Form.PARALLEL | Form.PROTOCOL:
                kind = "parallel regions" if state.type is StateType.AND else "group"
                said[shape] = f"{kind} {inside or _called(chart, shape.state)}"
            case Form.CHOICE | Form.INITIAL | Form.FINAL | Form.STACK:
                said[shape] = _SIGNS[shape.form]
            case _:
                assert_never(shape.form)
    return said


def silent(picture: Picture) -> set[Text]:
    """The texts that are said with a state or a line."""
    own = {item for _, texts in _written(picture) for item in texts}
    return own | {item for item in picture.elements if isinstance(item, Text) and item.of is not None}


def _called(chart: Statechart, label: str) -> str:
    return chart.node(label).name


def _written(picture: Picture) -> Iterator[tuple[Shape, list[Text]]]:
    """Each shape with the names that stand in it, and behind it among the elements."""
    shape: Shape | None = None
    texts: list[Text] = []
    for item in picture.elements:
        if isinstance(item, Shape):
            if shape is not None:
                yield shape, texts
            shape, texts = item, []
        elif isinstance(item, Text) and item.of is None and shape is not None and _holds(shape, item):
            texts.append(item)
    if shape is not None:
        yield shape, texts


def _holds(shape: Shape, item: Text) -> bool:
    return shape.x <= item.x <= shape.x + shape.width and shape.y <= item.y <= shape.y + shape.height


__all__ = ["in_order", "names", "silent"]
