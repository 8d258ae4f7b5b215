"""Check: whether a compact drawing shows its statechart, no more and no less.

It knows nothing of the layout: it reads the elements, and the chart.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact import texts
from aseme_dsl.diagrams.compact.elements import SIZES, Form, Line, Picture, Point, Shape, Stroke, Text
from aseme_dsl.diagrams.compact.follows import Follows

_NEAR = 3.0
"""Two points that are so near are one on paper, in px."""

_PITCH = 14.5
"""From one line of text to the next, in px."""

_DRAWN = (StateType.BASIC, StateType.AND, StateType.CONDITION)
_BOXES = (Form.ACTIVITY, Form.PARALLEL, Form.CHOICE, Form.INITIAL, Form.FINAL, Form.FRAME)

Box = tuple[float, float, float, float]


def faults(chart: Statechart, picture: Picture) -> list[str]:
    """What a compact drawing shows wrongly; empty if it is right."""
    lines = [item for item in picture.elements if isinstance(item, Line)]
    shapes = [item for item in picture.elements if isinstance(item, Shape)]
    written = [item for item in picture.elements if isinstance(item, Text)]
    follows = Follows(chart)
    return [
        *_counted(chart, lines, shapes),
        *_chains(follows, lines),
        *_ends(chart, follows, lines, shapes),
        *_joints(follows, lines, shapes, chart),
        *_labels(chart, lines, written),
        *_overlaps(picture, lines, shapes, written),
    ]


def _counted(chart: Statechart, lines: Sequence[Line], shapes: Sequence[Shape]) -> Iterator[str]:
    """Each transition has one home, and each state that has a shape has one."""
    seen = Counter(place for line in lines for link in line.chain for place in link)
    seen.update(place for shape in shapes for place in shape.marks)
    for place in range(len(chart.transitions)):
        if seen[place] != 1:
            yield f"transition {place} is drawn {seen[place]} times"
    yield from (f"transition {place} is invented" for place in seen if place >= len(chart.transitions))
    drawn = Counter(shape.state for shape in shapes)
    for state in chart.states:
        if state.type in _DRAWN and drawn[state.label] != 1:
            yield f"state {state.label} is drawn {drawn[state.label]} times"


def _chains(follows: Follows, lines: Sequence[Line]) -> Iterator[str]:
    """What one line stands for follows in the chart."""
    for line in lines:
        for before, after in zip(line.chain, line.chain[1:], strict=False):
            if any(not set(after) <= follows.after[place] for place in before):
                yield f"transitions {after} do not follow {before}"


def _ends(
    chart: Statechart, follows: Follows, lines: Sequence[Line], shapes: Sequence[Shape]
) -> Iterator[str]:
    """A line from or to a state with a shape begins or ends at its border."""
    boxes = {shape.state: _box(shape) for shape in shapes if shape.form is not Form.FIELD}
    going_on = {_rounded(line.points[0]): line.points[-1] for line in lines if not line.chain}
    for line in lines:
        if not line.chain:
            continue
        first, last = chart.transitions[line.chain[0][0]], chart.transitions[line.chain[-1][0]]
        source, target = chart.node(first.source), chart.node(last.target)
        group = source.type is StateType.OR and follows.is_event(line.chain[0][0])
        if (source.type in _DRAWN or group) and not _on(line.points[0], boxes.get(source.label)):
            yield f"transition {line.chain[0]} does not begin at state {source.label}"
        dot = boxes.get(source.label) if source.type is StateType.START else None
        if dot is not None and not _on(line.points[0], dot):
            yield f"transition {line.chain[0]} does not begin at state {source.label}"
        if (target.type in _DRAWN or target.label in boxes) and target.type is not StateType.OR:
            last_point = line.points[-1]
            last_point = going_on.get(_rounded(last_point), last_point)
            if not _on(last_point, boxes.get(target.label)):
                yield f"transition {line.chain[-1]} does not end at state {target.label}"
        wanted = any(follows.is_event(place) for place in line.chain[0]) and group
        if (
            wanted != (line.stroke in (Stroke.CUT, Stroke.ERROR))
            and not chart.transitions[line.chain[0][0]].first
        ):
            yield f"transition {line.chain[0]} is not drawn as what it is"


def _joints(
    follows: Follows, lines: Sequence[Line], shapes: Sequence[Shape], chart: Statechart
) -> Iterator[str]:
    """Lines meet where transitions follow, and nowhere else."""
    choices = [(_box(shape), shape.state) for shape in shapes if shape.form is Form.CHOICE]
    grid: dict[tuple[int, int], list[int]] = {}
    at_choice: dict[str, list[int]] = {}
    for number, line in enumerate(lines):
        x, y = line.points[0]
        grid.setdefault((int(x // 8), int(y // 8)), []).append(number)
        if line.chain and chart.node(source := chart.transitions[line.chain[0][0]].source).type is (
            StateType.CONDITION
        ):
            at_choice.setdefault(source, []).append(number)
    solid = [_box(shape) for shape in shapes if shape.form in (Form.ACTIVITY, Form.PARALLEL)]
    solid_ends = _touching([line.points[-1] for line in lines], solid)
    by_box = {state: box for box, state in choices}
    for number, line in enumerate(lines):
        if not line.chain:
            continue
        wanted = frozenset[int]().union(*(follows.after[place] for place in line.chain[-1]))
        target = chart.transitions[line.chain[-1][0]].target
        reached: set[int] = set()
        if target in by_box:
            found = [
                item for item in at_choice.get(target, ()) if _on(lines[item].points[0], by_box[target], 14)
            ]
        elif number in solid_ends:
            found = []
        else:
            found = _beginning(line.points[-1], lines, grid)
        waiting = [item for item in found]
        while waiting:
            item = waiting.pop()
            if lines[item].chain:
                reached |= set(lines[item].chain[0])
            else:
                waiting += _beginning(lines[item].points[-1], lines, grid)
        if lost := wanted - reached:
            yield f"transition {line.chain[-1]} does not lead to {sorted(lost)}"
        if extra := reached - wanted:
            yield f"transition {line.chain[-1]} leads to {sorted(extra)}, which do not follow"


def _rounded(point: Point) -> tuple[int, int]:
    return round(point[0]), round(point[1])


def _touching(points: Sequence[Point], boxes: Sequence[Box]) -> set[int]:
    """Which points lie at a border."""
    rows: dict[int, list[Box]] = {}
    for box in boxes:
        for x in (box[0], box[2]):
            rows.setdefault(int(x // 16), []).append(box)
    found = set()
    for number, (x, y) in enumerate(points):
        near = (box for column in (-1, 0, 1) for box in rows.get(int(x // 16) + column, ()))
        if any(_on((x, y), box, 1) and abs(x - box[0]) <= 1 for box in near):
            found.add(number)
    return found


def _beginning(point: Point, lines: Sequence[Line], grid: dict[tuple[int, int], list[int]]) -> list[int]:
    """The lines that begin at a point."""
    column, row = int(point[0] // 8), int(point[1] // 8)
    return [
        item
        for dx in (-1, 0, 1)
        for dy in (-1, 0, 1)
        for item in grid.get((column + dx, row + dy), ())
        if abs(lines[item].points[0][0] - point[0]) <= _NEAR
        and abs(lines[item].points[0][1] - point[1]) <= _NEAR
    ]


def _labels(chart: Statechart, lines: Sequence[Line], written: Sequence[Text]) -> Iterator[str]:
    """Every line of text that a transition has stands at its line, and no other there."""
    found: dict[int, list[Text]] = {}
    for item in written:
        if item.of is not None:
            found.setdefault(item.of, []).append(item)
    for line in lines:
        cut = line.stroke in (Stroke.CUT, Stroke.ERROR)
        for number, link in enumerate(line.chain):
            for place in link:
                upper, lower = texts.rows(chart.transitions[place], cut and number == 0)
                expected = [text for text, _ in (*upper, *lower)]
                if len(link) > 1 and not upper:
                    expected = ["done", *expected]
                here = found.pop(place, [])
                if [item.text for item in here] != expected:
                    yield f"transition {place} has not its own text"
                reach = 20 + _PITCH * sum(map(_rows_of(chart, cut), link))
                yield from (
                    f"the text {item.text!r} is not at its line"
                    for item in here
                    if not _beside(item, line, reach)
                )
    yield from (f"transition {place} has a text without a line" for place in found)


def _rows_of(chart: Statechart, cut: bool) -> Callable[[int], int]:
    """How many lines of text a transition has at most."""
    return lambda place: 1 + sum(map(len, texts.rows(chart.transitions[place], cut)))


def _beside(item: Text, line: Line, reach: float) -> bool:
    """Whether a text stands along a level stretch of a line, not far above or below."""
    middle = item.x + item.width / 2
    return any(
        a[1] == b[1] and min(a[0], b[0]) <= middle <= max(a[0], b[0]) and abs(item.y - a[1]) < reach
        for a, b in zip(line.points, line.points[1:], strict=False)
    )


def _overlaps(
    picture: Picture, lines: Sequence[Line], shapes: Sequence[Shape], written: Sequence[Text]
) -> Iterator[str]:
    """No text stands on a text, a line or a border, or outside."""
    cells: dict[tuple[int, int], list[tuple[str, Box]]] = {}
    things: list[tuple[str, Box]] = []
    for line in lines:
        for (a, b), (c, d) in zip(line.points, line.points[1:], strict=False):
            things.append(("a line", (min(a, c), min(b, d), max(a, c), max(b, d))))
    for shape in shapes:
        if shape.form in _BOXES and shape.form is not Form.CHOICE:
            a, b, c, d = _box(shape)
            things += [("a border", box) for box in ((a, b, c, b), (a, d, c, d), (a, b, a, d), (c, b, c, d))]
    things += [(repr(item.text), _text_box(item)) for item in written]
    for thing in things:
        for cell in _cells(thing[1]):
            cells.setdefault(cell, []).append(thing)
    for item in written:
        box = _text_box(item)
        if box[0] < 0 or box[1] < 0 or box[2] > picture.width or box[3] > picture.height:
            yield f"the text {item.text!r} is outside"
        own = (repr(item.text), box)
        met = {thing for cell in _cells(box) for thing in cells.get(cell, ()) if thing != own}
        yield from (
            f"the text {item.text!r} is on {name}" for name, other in sorted(met) if _meet(box, other)
        )
    again = Counter(_text_box(item) for item in written)
    yield from ("two texts are in one place" for count in again.values() if count > 1)


def _cells(box: Box) -> Iterator[tuple[int, int]]:
    for column in range(int(box[0] // 128), int(box[2] // 128) + 1):
        for row in range(int(box[1] // 64), int(box[3] // 64) + 1):
            yield column, row


def _meet(one: Box, other: Box) -> bool:
    return (one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]) or (
        (other[0] == other[2] or other[1] == other[3])
        and one[0] < other[2] + 0.01
        and other[0] - 0.01 < one[2]
        and one[1] < other[3] + 0.01
        and other[1] - 0.01 < one[3]
    )


def _text_box(item: Text) -> Box:
    size = SIZES[item.look]
    return (item.x + 1, item.y - size * 0.72, item.x + item.width - 1, item.y + size * 0.1)


def _box(shape: Shape) -> Box:
    return (shape.x, shape.y, shape.x + shape.width, shape.y + shape.height)


def _on(point: Point, box: Box | None, near: float = _NEAR) -> bool:
    """Whether a point lies at a border."""
    if box is None:
        return False
    x, y = point
    inside = box[0] - near <= x <= box[2] + near and box[1] - near <= y <= box[3] + near
    return inside and min(abs(x - box[0]), abs(x - box[2]), abs(y - box[1]), abs(y - box[3])) <= near


__all__ = ["faults"]
