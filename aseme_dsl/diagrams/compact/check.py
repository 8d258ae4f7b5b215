"""Check: whether a compact drawing shows its statechart, no more and no less.

It knows nothing of the layout: it reads the elements, and the chart.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.blocks import inside
from aseme_dsl.diagrams.compact.check_nested import nested_faults, shown_in, states_in, staying_in
from aseme_dsl.diagrams.compact.elements import SIZES, Form, Line, Look, Picture, Point, Shape, Stroke, Text
from aseme_dsl.diagrams.compact.follows import Follows
from aseme_dsl.diagrams.compact.plan import equal, transitions_in
from aseme_dsl.diagrams.compact.words import Words

_NEAR = 3.0
"""Two points that are so near are one on paper, in px."""

_AGAIN = "↻"

_PITCH = 14.5
"""From one line of text to the next, in px."""

_DRAWN = (StateType.BASIC, StateType.AND, StateType.CONDITION)
_SHUT = (Form.CLOSED, Form.NESTED)
"""States that no lines of the drawing lead into."""

_SOLID = (Form.ACTIVITY, Form.PARALLEL, *_SHUT)
_FULL = (Form.ACTIVITY, *_SHUT, Form.PILL, Form.INITIAL, Form.FINAL, Form.ENDLESS)
"""What no line may cross, and no text that is not its own."""

_SIGNS = (Form.FIELD, Form.ENDLESS, Form.STACK)
"""What is drawn of a state that has a shape besides, or none."""

Box = tuple[float, float, float, float]


def faults(chart: Statechart, picture: Picture, activities: Iterable[Activity] = ()) -> list[str]:
    """What a compact drawing shows wrongly; empty if it is right. A page of texts shows no state."""
    if all(isinstance(item, Text) for item in picture.elements):
        return list(_overlaps(picture, (), (), [item for item in picture.elements if isinstance(item, Text)]))
    lines = [item for item in picture.elements if isinstance(item, Line)]
    shapes = [item for item in picture.elements if isinstance(item, Shape)]
    written = [item for item in picture.elements if isinstance(item, Text)]
    follows = Follows(chart, picture.top)
    words = Words(chart, activities, picture.notes)
    shut = [shape for shape in shapes if shape.form in _SHUT]
    hidden = frozenset(place for shape in shut for place in transitions_in(chart, shape.state))
    return [
        *_counted(chart, picture, lines, shapes),
        *_marks(chart, picture, follows, words, shapes),
        *_chains(follows, lines),
        *_ends(chart, follows, lines, shapes),
        *_joints(follows, lines, shapes, chart, hidden),
        *_heads(lines, shapes),
        *_again(shapes, written),
        *_labels(chart, words, lines, shapes, written),
        *_names(chart, words, shapes, written),
        *_overlaps(picture, lines, shapes, written),
        *_crossings(lines, shapes),
        *(fault for shape in shut if shape.form is Form.NESTED for fault in nested_faults(chart, shape)),
    ]


def _counted(
    chart: Statechart, picture: Picture, lines: Sequence[Line], shapes: Sequence[Shape]
) -> Iterator[str]:
    """Each transition has one home, and each state that has a shape has one."""
    seen = Counter(place for line in lines for link in line.chain for place in link)
    seen.update(place for shape in shapes for place in shape.marks)
    drawn = Counter(shape.state for shape in shapes if shape.form not in _SIGNS)
    for shape in shapes:
        if shape.form is Form.CLOSED:
            drawn.update(inside(chart, shape.state)[1:])
        elif shape.inset is not None:
            drawn.update(states_in(shape.inset) - Counter([shape.state]))
            seen.update(shown_in(shape.inset))
            seen.update(staying_in(chart, shape.state))
    for one, *others in reversed(picture.copies):  # inner ones come after those around them
        for other in others:
            if chart.node(one).parent != chart.node(other).parent or not equal(chart, one, other):
                yield f"region {other} does not equal {one}"
                continue
            mine, its = transitions_in(chart, one), transitions_in(chart, other)
            seen.update({there: seen[here] for here, there in zip(mine, its, strict=True)})
            pairs = zip(inside(chart, one), inside(chart, other), strict=True)
            drawn.update({there: drawn[here] for here, there in pairs})
    shown = set(transitions_in(chart, picture.top)) if picture.top else set(range(len(chart.transitions)))
    for place in range(len(chart.transitions)):
        if seen[place] != (place in shown):
            yield f"transition {place} is drawn {seen[place]} times"
    yield from (f"transition {place} is invented" for place in seen if place >= len(chart.transitions))
    for label in inside(chart, picture.top or chart.root.label):
        if chart.node(label).type in _DRAWN and drawn[label] != 1:
            yield f"state {label} is drawn {drawn[label]} times"


def _marks(
    chart: Statechart, picture: Picture, follows: Follows, words: Words, shapes: Sequence[Shape]
) -> Iterator[str]:
    """What a shape stands for itself belongs to it."""
    items = chart.transitions
    for shape in shapes:
        states = {shape.state, *shape.also}
        around = {item.label for item in chart.ancestors(shape.state)}
        hidden: frozenset[int] = frozenset()
        if shape.form is Form.CLOSED:
            hidden = frozenset(transitions_in(chart, shape.state))
        elif shape.form is Form.PILL:
            region = next(
                (item for item in chart.ancestors(shape.state) if chart.is_region(item.label)), None
            )
            hidden = frozenset(transitions_in(chart, region.label)) if region is not None else hidden
            if any(map(words.has_text, hidden)) or set(shape.marks) != hidden:
                yield f"the region of {shape.state} is more than a repetition"
        for place in shape.marks:
            item = items[place]
            belongs = (
                place in hidden
                or (not item.changes_state and item.source in states)
                or (place in follows.never and item.source in states | around)
                or (item.reactive and chart.node(item.target).parent == chart.node(shape.state).parent)
                or (
                    shape.form is Form.PARALLEL
                    and chart.node(item.source).type is StateType.START
                    and chart.node(item.source).parent in around
                    and item.target in states | around
                    and not words.has_text(place)
                )
            )
            if not belongs:
                yield f"state {shape.state} stands for transition {place}, which is another's"
            if shape.form is Form.ENDLESS and place not in follows.never:
                yield f"transition {place} can be taken"


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
    bordered = [shape for shape in shapes if shape.form not in (*_SIGNS, Form.PILL)]
    boxes = {label: _box(shape) for shape in bordered for label in (shape.state, *shape.also)}
    closed = {shape.state for shape in shapes if shape.form in _SHUT}
    going_on = {_rounded(line.points[0]): line.points[-1] for line in lines if not line.chain}
    for line in lines:
        if not line.chain:
            continue
        first, last = chart.transitions[line.chain[0][0]], chart.transitions[line.chain[-1][0]]
        source, target = chart.node(first.source), chart.node(last.target)
        composite = source.type in (StateType.OR, StateType.AND)
        group = composite and follows.is_event(line.chain[0][0])
        if (source.type in _DRAWN or group or source.label in closed) and not _on(
            line.points[0], boxes.get(source.label)
        ):
            yield f"transition {line.chain[0]} does not begin at state {source.label}"
        dot = boxes.get(source.label) if source.type is StateType.START else None
        if dot is not None and not _on(line.points[0], dot):
            yield f"transition {line.chain[0]} does not begin at state {source.label}"
        solid = target.type in _DRAWN or (target.label in boxes and target.type is not StateType.OR)
        if solid or target.label in closed:
            last_point = line.points[-1]
            for _ in range(len(going_on)):
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
    follows: Follows,
    lines: Sequence[Line],
    shapes: Sequence[Shape],
    chart: Statechart,
    hidden: frozenset[int],
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
    solid = [_box(shape) for shape in shapes if shape.form in _SOLID]
    solid_ends = _touching([line.points[-1] for line in lines], solid)
    by_box = {state: box for box, state in choices}
    for number, line in enumerate(lines):
        if not line.chain:
            continue
        wanted = frozenset[int]().union(*(follows.after[place] for place in line.chain[-1])) - hidden
        target = chart.transitions[line.chain[-1][0]].target
        reached: set[int] = set()
        if target in by_box:
            found = [item for item in at_choice.get(target, ()) if _on(lines[item].points[0], by_box[target])]
        elif number in solid_ends:
            found = []
        else:
            found = _beginning(line.points[-1], lines, grid)
        waiting = list(found)
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


def _heads(lines: Sequence[Line], shapes: Sequence[Shape]) -> Iterator[str]:
    """A line that only leads on begins where another ends, and alone; one to a state has a head."""
    into = [_box(shape) for shape in shapes if shape.form in (*_SOLID, Form.CHOICE, Form.FINAL)]
    entered = _touching([line.points[-1] for line in lines], into)
    ended = {_rounded(line.points[-1]) for line in lines}
    begun = Counter(_rounded(line.points[0]) for line in lines if not line.chain)
    for number, line in enumerate(lines):
        if number in entered and not line.arrow:
            yield f"a line ends at {_rounded(line.points[-1])} without a head"
        if line.chain:
            continue
        x, y = _rounded(line.points[0])
        if begun[x, y] > 1:
            yield f"{begun[x, y]} lines lead on from {(x, y)}"
        if not any((x + dx, y + dy) in ended for dx in range(-3, 4) for dy in range(-3, 4)):
            yield f"a line begins at {(x, y)}, where none ends"


def _again(shapes: Sequence[Shape], written: Sequence[Text]) -> Iterator[str]:
    """A choice that is tried again has the sign of that in it, and only such a one."""
    signs = [item for item in written if item.text == _AGAIN]
    for shape in shapes:
        if shape.form is not Form.CHOICE:
            continue
        inside = [item for item in signs if _within(item, _box(shape))]
        if len(inside) != bool(shape.marks):
            yield f"the choice {shape.state} has {len(inside)} signs that it is tried again"
        signs = [item for item in signs if item not in inside]
    yield from (f"the sign {item.text} is in no choice" for item in signs)


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


def _labels(
    chart: Statechart, words: Words, lines: Sequence[Line], shapes: Sequence[Shape], written: Sequence[Text]
) -> Iterator[str]:
    """Every text that a transition has stands at its line or in its state, and no other there."""
    found: dict[int, list[Text]] = {}
    for item in written:
        if item.of is not None:
            found.setdefault(item.of, []).append(item)
    boxes: dict[str, list[Box]] = {}
    for shape in shapes:
        for label in (shape.state, *shape.also):
            boxes.setdefault(label, []).append(_room(shape, shapes))
    for line in lines:
        cut = line.stroke in (Stroke.CUT, Stroke.ERROR)
        for number, link in enumerate(line.chain):
            reach = 20 + _PITCH * sum(len(found.get(place, ())) for place in link)
            for place in link:
                here = found.pop(place, [])
                told = _plain(item.text for item in here)
                own = boxes.get(chart.transitions[place].source, ())
                row = _plain(text for text, _ in words.exit(place, _ENDLESS, cut and number == 0))
                if told == row and any(_within(item, box) for box in own for item in here[:1]):
                    yield from (
                        f"the text {item.text!r} is not in its state"
                        for item in here
                        if not any(_within(item, box) for box in own)
                    )
                    continue
                upper, lower = words.rows(place, _ENDLESS, cut and number == 0)
                expected = [text for text, _ in (*upper, *lower)]
                if len(link) > 1:
                    rows = words.one_of_many(place, _ENDLESS, cut and number == 0)
                    expected = [text for text, _ in rows]
                if told != _plain(expected):
                    yield f"transition {place} has not its own text"
                yield from (
                    f"the text {item.text!r} is not at its line"
                    for item in here
                    if not _beside(item, line, reach)
                )
    for shape in shapes:
        if shape.form in (*_SHUT, Form.PILL, Form.ENDLESS):
            continue
        for place in shape.marks:
            here = found.pop(place, [])
            staying = not chart.transitions[place].changes_state
            expected = [text for text, _ in words.inside(place, _ENDLESS)] if staying else []
            if _plain(item.text for item in here) != _plain(expected):
                yield f"transition {place} has not its own text"
            box = _room(shape, shapes)
            yield from (
                f"the text {item.text!r} is not in its state" for item in here if not _within(item, box)
            )
    yield from (f"transition {place} has a text without a line" for place in found)


_ENDLESS = 100_000.0
"""So wide that no text is broken."""


def _plain(rows: Iterable[str]) -> str:
    """The text of rows, however they are broken."""
    return "".join("".join(rows).split())


def _room(shape: Shape, shapes: Sequence[Shape]) -> Box:
    """Where the texts of a shape may stand.

    A field has only its upper border: it reaches to the next one, or to the end of the frame.
    """
    a, b, c, d = _box(shape)
    if shape.form is not Form.FIELD:
        return a, b, c, d
    below = [item.y for item in shapes if item.form is Form.FIELD and item.x == shape.x and item.y > b]
    frames = (_box(item) for item in shapes if item.form is Form.PARALLEL)
    around = [low for left, top, right, low in frames if left <= a and c <= right and top <= b < low]
    return a, b, c, min((*below, *around), default=_ENDLESS)


def _within(item: Text, box: Box) -> bool:
    a, b, c, d = _text_box(item)
    return box[0] <= a and box[1] <= b and c <= box[2] and d <= box[3]


def _names(
    chart: Statechart, words: Words, shapes: Sequence[Shape], written: Sequence[Text]
) -> Iterator[str]:
    """Each activity has its name in its node, and only that."""
    named: dict[tuple[int, int], list[Text]] = {}
    for item in written:
        if item.look in (Look.NAME, Look.FIELD):
            for cell in _cells(_text_box(item)):
                named.setdefault(cell, []).append(item)
    for shape in shapes:
        if shape.form not in (Form.ACTIVITY, Form.PILL):
            continue
        box = _box(shape)
        near = {item for cell in _cells(box) for item in named.get(cell, ())}
        names = [item.text for item in near if _within(item, box)]
        name = chart.node(shape.state).name
        if names != [words.short(name)] and names != [name]:
            yield f"state {shape.state} is not called {name}"


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
        a, b, c, d = _box(shape)
        if shape.form is Form.CHOICE:
            e = (c - a) / 4
            things.append(("a choice", (a + e, b + e, c - e, d - e)))
            continue
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
        if item.text == _AGAIN:
            met = {thing for thing in met if thing[0] != "a choice"}  # it stands in one
        yield from (
            f"the text {item.text!r} is on {name}" for name, other in sorted(met) if _meet(box, other)
        )
    again = Counter(_text_box(item) for item in written)
    yield from ("two texts are in one place" for count in again.values() if count > 1)


def _crossings(lines: Sequence[Line], shapes: Sequence[Shape]) -> Iterator[str]:
    """No line runs through a node."""
    cells: dict[tuple[int, int], list[Shape]] = {}
    for shape in shapes:
        if shape.form in _FULL:
            for cell in _cells(_box(shape)):
                cells.setdefault(cell, []).append(shape)
    for line in lines:
        for (a, b), (c, d) in zip(line.points, line.points[1:], strict=False):
            box = (min(a, c), min(b, d), max(a, c), max(b, d))
            near = {shape for cell in _cells(box) for shape in cells.get(cell, ())}
            yield from (
                f"a line runs through state {shape.state}" for shape in near if _meet(box, _inner(shape))
            )


def _inner(shape: Shape) -> Box:
    a, b, c, d = _box(shape)
    return (a + 1, b + 1, c - 1, d - 1)


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
    if item.text == _AGAIN:
        return (item.x, item.y - 10, item.x + 10, item.y)
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
