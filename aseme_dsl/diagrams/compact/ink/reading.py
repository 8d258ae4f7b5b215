"""Reading: in what order the elements of a compact drawing stand in its file, and what is said of each.

A screen reader reads a frame before the states in it, and a state before the lines that leave it. What is
written at lines and in states is said with them, so their texts are not read a second time.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import assert_never

from aseme_dsl.amola.statechart import Statechart, StateType, transition_text
from aseme_dsl.diagrams.compact.elements import Element, Form, Line, Picture, Shape, Text
from aseme_dsl.diagrams.compact.words import outside_quotes

_FRAMES = (Form.FRAME, Form.PARALLEL, Form.PROTOCOL, Form.STACK)
_NOT = re.compile(r"!(?!=)")
_POINTS = {StateType.START: "start", StateType.END: "end", StateType.CONDITION: "choice"}


def headings(picture: Picture) -> set[Text]:
    """The texts that are read first: the title and what else stands above all states."""
    top = min((item.y for item in picture.elements if isinstance(item, Shape)), default=0.0)
    texts = (item for item in picture.elements if isinstance(item, Text) and item.of is None)
    return {item for item in texts if item.y < top}


def in_order(chart: Statechart, picture: Picture) -> list[Element]:
    """The elements from back to front: the title, frames, states with the lines that leave them, texts."""
    places = {state.label: place for place, state in enumerate(chart.states)}
    first = headings(picture)

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
                return (-1, 0, 0) if item in first else (2, 0, 0)
            case _:
                assert_never(item)

    return sorted(picture.elements, key=key)


def heard_before(chart: Statechart, picture: Picture) -> dict[Element, list[Shape]]:
    """The frames that are read before a state: each before the first one inside, not where it is painted."""
    places = {state.label: place for place, state in enumerate(chart.states)}
    items = [item for item in in_order(chart, picture) if not isinstance(item, Text)]
    frames = sorted(
        (item for item in items if isinstance(item, Shape) and is_frame(item)),
        key=lambda item: (places[item.state], -item.width),
    )
    found: dict[Element, list[Shape]] = {}
    for item in items:
        if isinstance(item, Shape) and not is_frame(item):
            before = [frame for frame in frames if places[frame.state] <= places[item.state]]
            found[item] = before
            frames = frames[len(before) :]
    return found


def is_frame(item: Shape) -> bool:
    """Whether a shape is painted behind what is inside it."""
    return item.form in _FRAMES


def names(chart: Statechart, picture: Picture) -> dict[Shape, str]:
    """What a screen reader says of each state and sign."""
    said: dict[Shape, str] = {}
    for shape, texts in _written(picture):
        inside = ", ".join(item.text for item in texts)
        state = chart.node(shape.state)
        match shape.form:
            case Form.ACTIVITY:
                around = _around(chart, shape.state)
                said[shape] = f"activity {inside}{f', in {around}' if around else ''}"
            case Form.PILL:
                said[shape] = f"always {inside}"
            case Form.NESTED:
                said[shape] = f"{_called(chart, shape.state)}, {inside}"
            case Form.CLOSED:
                said[shape] = f"closed {inside}"
            case Form.ENDLESS:
                said[shape] = f"{_called(chart, shape.state)} never ends"
            case Form.FIELD:
                said[shape] = _called(chart, shape.state)
            case Form.FRAME | Form.PARALLEL | Form.PROTOCOL:
                kind = "parallel regions" if state.type is StateType.AND else "group"
                said[shape] = f"{kind} {inside or _called(chart, shape.state)}"
            case Form.CHOICE | Form.INITIAL | Form.FINAL:
                said[shape] = _called(chart, shape.state)
            case Form.STACK:
                said[shape] = "several equal regions"
            case _:
                assert_never(shape.form)
        if shape.form in (Form.ACTIVITY, *_FRAMES):
            staying = (place for place in shape.marks if not chart.transitions[place].changes_state)
            said[shape] = "; ".join((said[shape], *_texts(chart, staying)))
    return said


def line_name(chart: Statechart, line: Line) -> str:
    """What a screen reader says of a line: from which state it leads to which, and when."""
    first, last = line.chain[0][0], line.chain[-1][0]
    ends = chart.transitions[first].source, chart.transitions[last].target
    texts = ("; or ".join(_texts(chart, link)) for link in line.chain)
    when = ", then ".join(filter(None, texts)) or "when complete"
    return f"{_called(chart, ends[0])} to {_called(chart, ends[1])}: {when}"


def state_name(chart: Statechart, label: str) -> str:
    """What a screen reader says of a state that is drawn nested, with what is done in it."""
    state = chart.node(label)
    kinds = {StateType.BASIC: "activity ", StateType.AND: "parallel regions ", StateType.OR: "group "}
    staying = (
        place
        for place, item in enumerate(chart.transitions)
        if item.source == label and not item.changes_state
    )
    return "; ".join((kinds.get(state.type, "") + _called(chart, label), *_texts(chart, staying)))


def _texts(chart: Statechart, places: Iterable[int]) -> list[str]:
    """What is said of transitions; of one without a word, that it is taken if it is one of several."""
    found = [transition_text(chart.transitions[place]) for place in places]
    if not any(found):
        return []
    return [outside_quotes(text, _spoken) or "when complete" for text in found]


def _spoken(text: str) -> str:
    """A text with words for signs that a screen reader leaves out."""
    text = text.replace("&&", "and").replace("||", "or").replace("[>", "at once,")
    return _NOT.sub("not ", text)


def silent(picture: Picture) -> set[Text]:
    """The texts that are said with a state or a line."""
    own = {item for _, texts in _written(picture) for item in texts}
    return own | {item for item in picture.elements if isinstance(item, Text) and item.of is not None}


def _called(chart: Statechart, label: str) -> str:
    """What a listener knows a state by: its name, or what it is of a state around it that has one."""
    state = chart.node(label)
    if state.parent is None:
        return chart.name
    if state.type in _POINTS:
        return f"{_POINTS[state.type]} of {_called(chart, state.parent)}"
    if chart.is_region(label):
        regions = [item.label for item in chart.children(state.parent)]
        number = f"region {regions.index(label) + 1} of {_called(chart, state.parent)}"
        return number if state.name == label else f"region {state.name}"
    return state.name if state.name != label else f"a part of {_called(chart, state.parent)}"


def _around(chart: Statechart, label: str) -> str:
    """The name of the innermost formula around a state, if it has one."""
    names = (state.name for state in chart.ancestors(label) if state.parent is not None)
    return next((name for name in names if name.isidentifier()), "")


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


__all__ = ["headings", "heard_before", "in_order", "is_frame", "line_name", "names", "silent", "state_name"]
