"""Check of nested parts: whether an inset shows its part of the statechart, no more and no less.

It knows nothing of what has drawn it: it reads the pieces, and the chart.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.statechart import Statechart, StateType, transition_text
from aseme_dsl.diagrams.compact.blocks import inside
from aseme_dsl.diagrams.compact.elements import INSET_PAD, Shape
from aseme_dsl.diagrams.compact.plan import transitions_in
from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.diagrams.look.inset import Inset, Outline, Oval, Piece, Point, Words
from aseme_dsl.diagrams.look.labels import printable, text_width

_NEAR = 3.0
"""A line that ends so near to a border ends there, in px."""

_BESIDE = 40.0
"""So far from its line a text may stand, in px."""

_STRAIGHT = 0.94
"""The cosine of the largest angle between a line and its head."""

_OTHER_FONT = 0.18
"""By so much of its width a text may be wider in the font that Graphviz knows."""

_SAID = 30
"""So many characters of a name are shown at least; the tip has all of it."""

Frame = tuple[float, float, float, float]


def shown_in(inset: Inset) -> Counter[int]:
    """How often each transition is drawn as a line."""
    pieces = (item for item in inset.pieces if item.kind is Kind.LINE)
    return Counter(int(item.id[1:]) for item in pieces if item.id[:1] == "t" and item.id[1:].isdecimal())


def states_in(inset: Inset) -> Counter[str]:
    """How often each state is drawn."""
    return Counter(item.id[1:] for item in inset.pieces if item.id[:1] == "n")


def staying_in(chart: Statechart, label: str) -> Iterator[int]:
    """The transitions in a state that lead nowhere: they have no line, but are written in their states."""
    return (place for place in transitions_in(chart, label) if not chart.transitions[place].changes_state)


def nested_faults(chart: Statechart, shape: Shape) -> Iterator[str]:
    """What the inset of a state shows wrongly; nothing if it is right."""
    inset = shape.inset
    if inset is None:
        yield f"state {shape.state} is nested, and has no picture"
        return
    wanted = frozenset(transitions_in(chart, shape.state))
    states = inside(chart, shape.state)
    by_id = {item.id: item for item in inset.pieces}
    yield from _counted(chart, inset, wanted, states)
    yield from _within(inset, shape)
    for label in states:
        if (piece := by_id.get(f"n{label}")) is not None:
            yield from _state(chart, label, piece, by_id)
    for place in sorted(wanted):
        if chart.transitions[place].changes_state and f"t{place}" in by_id:
            yield from _line(chart, place, inset, by_id)


def _counted(chart: Statechart, inset: Inset, wanted: frozenset[int], states: Sequence[str]) -> Iterator[str]:
    drawn = states_in(inset)
    for label in states:
        if drawn[label] != 1:
            yield f"state {label} is drawn {drawn[label]} times in its inset"
    yield from (f"state {label} is invented" for label in drawn if label not in states)
    lines = shown_in(inset)
    for place in wanted:
        if lines[place] != chart.transitions[place].changes_state:
            yield f"transition {place} is drawn {lines[place]} times"
    again = Counter(item.id for item in inset.pieces if item.id)
    yield from (f"{name} is drawn {count} times" for name, count in again.items() if count > 1)
    for piece in inset.pieces:
        of = piece.id.removeprefix("t").partition(".")[0]
        if piece.id and piece.id[0] not in "nt":
            yield f"{piece.id} stands for nothing"
        elif piece.id[:1] == "t" and (not of.isdecimal() or int(of) not in wanted):
            yield f"{piece.id} is invented"


def _within(inset: Inset, shape: Shape) -> Iterator[str]:
    """The picture is inside its border."""
    if inset.width + 2 * INSET_PAD > shape.width + 1 or inset.height + INSET_PAD > shape.height + 1:
        yield f"the picture of state {shape.state} is larger than its border"
    whole = (0.0, 0.0, inset.width, inset.height)
    points: Sequence[Point]
    for piece in inset.pieces:
        for part in piece.parts:
            match part:
                case Outline():
                    points = tuple(_points(part.points)) if part.curved else part.points
                case Oval():
                    points = ((part.x - part.rx, part.y - part.ry), (part.x + part.rx, part.y + part.ry))
                case Words():
                    points = ((part.x, part.y),)
            if not all(_holds(whole, point, _NEAR) for point in points):
                yield f"{piece.id or 'a text'} is outside of its picture"


def _state(chart: Statechart, label: str, piece: Piece, by_id: Mapping[str, Piece]) -> Iterator[str]:
    """A state has its shape, its name, what is done in it, and stands in the one around it."""
    state, frame = chart.node(label), piece.frame
    if frame is None:
        yield f"state {label} has no shape"
        return
    if state.type in (StateType.BASIC, StateType.OR, StateType.AND):
        said = _squeezed(state.name)[:_SAID]
        if not piece.text.startswith(said):
            yield f"state {label} is not called {state.name}"
        for item in chart.outgoing(label):
            if not item.changes_state and _squeezed(transition_text(item)) not in piece.text:
                yield f"state {label} lacks the text {transition_text(item)!r}"
    around = by_id.get(f"n{state.parent}")
    outer = around.frame if around is not None else None
    if outer is not None and not (_holds(outer, frame[:2], _NEAR) and _holds(outer, frame[2:], _NEAR)):
        yield f"state {label} is drawn outside of {state.parent}"


def _line(chart: Statechart, place: int, inset: Inset, by_id: Mapping[str, Piece]) -> Iterator[str]:
    """A transition leads from its state to its state, has one head, and its own text beside it."""
    item = chart.transitions[place]
    own = [piece for piece in inset.pieces if piece.id.partition(".")[0] == f"t{place}"]
    outlines = [part for piece in own if piece.kind is Kind.LINE for part in piece.parts]
    curves = [part.points for part in outlines if isinstance(part, Outline) and not part.is_head]
    heads = [part.points for part in outlines if isinstance(part, Outline) and part.is_head]
    if len(heads) != 1 or not curves:
        yield f"transition {place} has {len(curves)} lines and {len(heads)} heads"
        return
    ends = [point for curve in curves for point in (curve[0], curve[-1])]
    left, tip, right = heads[0][:3]
    base = (left[0] + right[0]) / 2, (left[1] + right[1]) / 2
    headed = min(ends, key=lambda point: math.dist(point, base))
    if math.dist(headed, base) > _NEAR or not _is_straight(curves, headed, base, tip):
        yield f"the head of transition {place} is not at its line"
    ends.remove(headed)
    target = by_id.get(f"n{item.target}")
    if not _at(tip, target) or (target is not None and target.kind is Kind.BOX and _is_in(base, target)):
        yield f"transition {place} does not end at state {item.target}"
    begins = [point for point in ends if _at(point, by_id.get(f"n{item.source}"))]
    if not begins:
        yield f"transition {place} does not begin at state {item.source}"
        return
    ends.remove(begins[0])
    turns = [piece for piece in own if piece.kind is not Kind.LINE]
    for number, point in enumerate(ends):
        others = (*ends[:number], *ends[number + 1 :])
        if not any(_at(point, turn) for turn in turns) and not any(
            math.dist(point, other) < _NEAR for other in others
        ):
            yield f"the line of transition {place} is broken"
    for turn in turns:
        if sum(_at(point, turn) for point in (*ends, headed)) < 2:
            yield f"the line of transition {place} is broken at {turn.id}"
    if "".join(piece.text for piece in own) != _squeezed(transition_text(item)):
        yield f"transition {place} has not its own text"
    texts = [part for piece in own for part in piece.parts if isinstance(part, Words)]
    if texts and not _is_beside(texts, curves):
        yield f"the text of transition {place} is not at its line"


def _is_straight(curves: Sequence[Sequence[Point]], end: Point, base: Point, tip: Point) -> bool:
    """Whether the head of an arrow leads where its line leads."""
    for curve in curves:
        points = [point for point in (curve if curve[-1] == end else curve[::-1]) if point != end]
        if end in (curve[0], curve[-1]) and points:
            far, long = math.dist(points[-1], end), math.dist(base, tip)
            along = (end[0] - points[-1][0]) * (tip[0] - base[0]) + (end[1] - points[-1][1]) * (
                tip[1] - base[1]
            )
            return far < 1 or long == 0 or along / (far * long) > _STRAIGHT
    return True


def _is_beside(texts: Sequence[Words], curves: Sequence[Sequence[Point]]) -> bool:
    lefts, rights = zip(*(_ends(item) for item in texts), strict=True)
    box = (
        min(lefts),
        min(item.y - item.size for item in texts),
        max(rights),
        max(item.y for item in texts),
    )
    return any(_holds(box, point, _BESIDE) for curve in curves for point in _points(curve))


def _ends(item: Words) -> tuple[float, float]:
    wide = text_width(item.text, item.size, bold=item.bold)
    left = item.x - wide / 2 if item.middle else item.x
    return left, left + wide


def _points(curve: Sequence[Point]) -> Iterator[Point]:
    """Points on a line of curves."""
    for start in range(0, len(curve) - 3, 3):
        a, b, c, d = curve[start : start + 4]
        steps = max(8, int(math.dist(a, d) / 16))
        for step in range(steps + 1):
            t = step / steps
            yield (
                (1 - t) ** 3 * a[0] + 3 * (1 - t) ** 2 * t * b[0] + 3 * (1 - t) * t * t * c[0] + t**3 * d[0],
                (1 - t) ** 3 * a[1] + 3 * (1 - t) ** 2 * t * b[1] + 3 * (1 - t) * t * t * c[1] + t**3 * d[1],
            )


def _at(point: Point, piece: Piece | None) -> bool:
    """Whether a point lies at the border of a state, or at a turn."""
    frame = piece.frame if piece is not None else None
    if piece is None or frame is None:
        return piece is not None and _near_text(point, piece)
    left, top, right, bottom = frame
    if _is_round(piece):
        middle, radius = ((left + right) / 2, (top + bottom) / 2), (right - left) / 2
        return abs(math.dist(point, middle) - radius) <= _NEAR
    far = min(abs(point[0] - left), abs(point[0] - right), abs(point[1] - top), abs(point[1] - bottom))
    return _holds(frame, point, _NEAR) and far <= _NEAR


def _near_text(point: Point, piece: Piece) -> bool:
    """Whether a point lies at the border of a label that is a turn by itself, with the room around it."""
    texts = [part for part in piece.parts if isinstance(part, Words)]
    if not texts:
        return False
    left, right = min(_ends(item)[0] for item in texts) - 5, max(_ends(item)[1] for item in texts) + 7
    top, bottom = min(item.y - item.size for item in texts) - 3, max(item.y for item in texts) + 8
    room = _NEAR + 1 + _OTHER_FONT * (right - left)
    sides = min(abs(point[0] - left), abs(point[0] - right)) <= room
    ends = min(abs(point[1] - top), abs(point[1] - bottom)) <= _NEAR + 1
    return _holds((left, top, right, bottom), point, room) and (sides or ends)


def _is_in(point: Point, piece: Piece) -> bool:
    """Whether a point lies inside a state, not at its border."""
    frame = piece.frame
    if frame is None:
        return False
    if _is_round(piece):
        middle = (frame[0] + frame[2]) / 2, (frame[1] + frame[3]) / 2
        return math.dist(point, middle) < (frame[2] - frame[0]) / 2 - 0.5
    return _holds(frame, point, -1.0)


def _is_round(piece: Piece) -> bool:
    return any(isinstance(part, Oval) for part in piece.parts)


def _holds(frame: Frame, point: Point, room: float) -> bool:
    return frame[0] - room <= point[0] <= frame[2] + room and frame[1] - room <= point[1] <= frame[3] + room


def _squeezed(text: str) -> str:
    return "".join(printable(text).split())


__all__ = ["nested_faults", "shown_in", "states_in", "staying_in"]
