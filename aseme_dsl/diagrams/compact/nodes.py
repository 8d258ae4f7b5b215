"""Nodes: what is drawn of single states: activities, closed composites, pills, borders and signs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.blocks import Activity, Closed, Group, inside
from aseme_dsl.diagrams.compact.elements import (
    INSET_PAD,
    SIZES,
    Form,
    Line,
    Link,
    Look,
    Nested,
    Point,
    Shape,
    Text,
)
from aseme_dsl.diagrams.compact.pen import GAP, PITCH, Pen, Placed, Room, line_to, pen, text
from aseme_dsl.diagrams.compact.plan import Plan, transitions_in
from aseme_dsl.diagrams.compact.words import Row, Words, indented, width
from aseme_dsl.diagrams.look.inset import Inset
from aseme_dsl.diagrams.look.labels import fitted

PAD = 10
"""Between a border and what is inside."""

_HALF = 14
"""Half the height of a node that has nothing but its name."""

_IN_NODE = 260
"""How wide the rows in a node may be, in px."""

_NOTE = 240
"""How wide the lines of a note in a box may be at least, in px."""

_ROW_OF_PILLS = 1100
"""How wide a row of pills may be, in px."""


class Nodes:
    """Draws the states of one chart that have nothing inside, where a line has so much `room`.

    What has no compact form is drawn by `nested`, if that is given.
    """

    def __init__(
        self, chart: Statechart, words: Words, plan: Plan, room: float, nested: Nested | None
    ) -> None:
        self._nested = nested
        self._chart = chart
        self._words = words
        self._plan = plan
        self._room = min(room, _ROW_OF_PILLS)

    def rows(self, label: str) -> list[tuple[Row, int]]:
        """What stays in a state, and what is done when it is left."""
        return [
            (row, place) for place in self._plan.staying(label) for row in self._words.inside(place, _IN_NODE)
        ]

    def table(self, link: Link, cuts: bool) -> list[tuple[Row, int]]:
        """The exits of a state as rows in it."""
        return [(row, place) for place in link for row in self._words.exit(place, _IN_NODE, cuts)]

    def activity(
        self, block: Activity, line: Pen, alias: str, least: float, exits: Link, signs: Link
    ) -> Placed:
        """An activity, at least so wide, with the table of its exits and the transitions never taken."""
        state = self._chart.node(block.label)
        head = [(alias, Look.SMALL)] if alias else []
        name = self._words.short(state.name)
        about = self._words.about(block.label)
        centred = [*head, (name, Look.NAME), *([(about, Look.SMALL)] if about else [])]
        rows = [*self.rows(block.label), *self.table(exits, False)]
        x = line.at + GAP
        wide = max(
            max((width(*row) for row in centred), default=0),
            max((dx + width(*row) for row, _, dx in indented(rows)), default=0),
        )
        wide = max(wide + 2 * PAD, least, 44)
        top = -_HALF - len(head) * (PITCH - 2)
        below = len(about[:1]) * 12 + len(rows) * PITCH + (8 if rows else 0)
        marks = (*self._plan.staying(block.label), *signs)
        room = Room()
        room.add(
            line_to(line, (x, 0)),
            Shape(Form.ACTIVITY, x, top, wide, _HALF - top + below, block.label, marks),
            *(
                text(
                    x + (wide - width(*row)) / 2,
                    4.5 + (number - len(head)) * PITCH - (number > len(head)),
                    *row,
                )
                for number, row in enumerate(centred)
            ),
            *_written(rows, x + PAD, _HALF + len(about[:1]) * 12 + PITCH - 2),
        )
        return room.placed(pen(x + wide))

    def closed(
        self, block: Closed, line: Pen | None, x: float, signs: Link = (), least: float = 0.0
    ) -> Placed:
        """A composite without what is inside: how much that is, and why it is closed if it must be."""
        chart, reason = self._chart, block.reason
        if reason and self._nested is not None:
            picture = self._nested(block.label)
            if isinstance(picture, Inset):
                return self._with_inset(block, picture, line, x, signs, least)
            reason = f"{reason}; {picture}"
        states = inside(chart, block.label)
        name, more = self._plan.called(block.label), self._plan.heading(block.label)[1]
        count = sum(chart.node(item).activity is not None for item in states)
        rows: list[Row] = [(name, Look.NAME)]
        rows += [(more, Look.SMALL)] if more else []
        rows.append(
            (f"{count} {'activity' if count == 1 else 'activities'}, {len(states)} states", Look.SMALL)
        )
        rows += _note(f"not drawn: {reason}" if reason else "", _NOTE)
        wide = max(max(width(*row) for row in rows) + 2 * PAD + 8, least)
        marks = (*transitions_in(chart, block.label), *signs)
        room = Room()
        if line is not None:
            room.add(line_to(line, (x, 0)))
        high = 2 * _HALF + (len(rows) - 1) * PITCH
        room.add(Shape(Form.CLOSED, x, -_HALF, wide, high, block.label, marks, reason=reason))
        room.add(*(text(x + PAD, 4.5 + number * PITCH, *row) for number, row in enumerate(rows)))
        return room.placed(None if self._plan.is_endless(block.label) else pen(x + wide))

    def _with_inset(
        self, block: Closed, picture: Inset, line: Pen | None, x: float, signs: Link, least: float
    ) -> Placed:
        """A composite whose inside is drawn as the papers draw, and the reason above it."""
        wide = max(picture.width + 2 * INSET_PAD, _NOTE + 2 * PAD, least)
        rows = _note(f"drawn as the papers draw: {block.reason}", wide - 2 * PAD)
        high = len(rows) * PITCH + 8 + picture.height + INSET_PAD
        room = Room()
        if line is not None:
            room.add(line_to(line, (x, 0)))
        border = Shape(Form.NESTED, x, -_HALF, wide, high, block.label, signs, reason=block.reason)
        room.add(replace(border, inset=picture))
        room.add(*(text(x + PAD, 2 + number * PITCH, *row) for number, row in enumerate(rows)))
        return room.placed(None if self._plan.is_endless(block.label) else pen(x + wide))

    def pills(self, regions: Sequence[Group], x: float) -> Placed:
        """Regions that repeat one activity each, side by side."""
        room = Room()
        room.add(text(x, 4, "always", Look.SMALL))
        left = x + width("always", Look.SMALL) + 10
        at, y = left, 0.0
        for region in regions:
            label = self._plan.pill(region)
            assert label is not None
            name = self._chart.node(label).name
            about = self._words.about(label).removeprefix("every ")
            wide = width(name, Look.FIELD) + 20 + (width(about, Look.SMALL) + 6 if about else 0)
            if at + wide > self._room and at > left:
                at, y = left, y + 26
            room.add(Shape(Form.PILL, at, y - 10, wide, 20, label, transitions_in(self._chart, region.label)))
            room.add(text(at + 10, y + 4, name, Look.FIELD))
            if about:
                room.add(text(at + 16 + width(name, Look.FIELD), y + 4, about, Look.SMALL))
            at += wide + 7
        return room.placed(None)

    def border(
        self, form: Form, labels: tuple[str, ...], room: Room, left: float, exits: Link, least: float
    ) -> tuple[Shape, list[Text]]:
        """The border around what is in a room, with its title, what stays in it, and its exits.

        They stand where less is in the room, above the axis or below, so that it becomes less high.
        """
        titles = [self._plan.heading(label) for label in labels]
        name = next((name for name, _ in titles if name), "")
        more = next((more for _, more in titles if more), "")
        rows = [row for label in labels for row in self.rows(label)]
        foot = self.table(exits, True)
        if room.down > room.up + 2 * PAD:
            rows, foot = rows + foot, []
        head = PITCH if name or more else 0.0
        top = -room.up - PAD - head - len(rows) * PITCH - (2 if head or rows else 0)
        wide = max((dx + width(*row) for row, _, dx in indented([*rows, *foot])), default=0)
        wide = max(wide, width(name, Look.NAME) + 8 + width(more, Look.SMALL))
        right = max(room.right + PAD, left + wide + 2 * PAD, left + least)
        written = [text(left + PAD, top + 14, name, Look.NAME)] if name else []
        if more:
            written.append(
                text(left + PAD + width(name, Look.NAME) + 8 * bool(name), top + 14, more, Look.SMALL)
            )
        written += _written(rows, left + PAD, top + 14 + head)
        written += _written(foot, left + PAD, room.down + PAD + 12)
        marks = tuple(place for label in labels for place in self._plan.staying(label))
        height = room.down + PAD - top + len(foot) * PITCH + (6 if foot else 0)
        shape = Shape(form, left, top, right - left, height, labels[-1], marks, labels[:-1])
        return shape, written


def _note(said: str, wide: float) -> list[Row]:
    """A note in small letters, in lines of this width."""
    return [(row, Look.SMALL) for row in fitted(said, wide, SIZES[Look.SMALL]) if row]


def endless(x: float, y: float, label: str, marks: Link) -> Shape:
    """The sign that a state is never complete, with the middle at y."""
    return Shape(Form.ENDLESS, x, y - 5, 16, 10, label, marks)


def ended(placed: Placed, label: str) -> Placed:
    """A composite that is complete and waits for an event: its line ends at a ring."""
    if placed.pen is None:
        return placed
    room = Room()
    room.put(replace(placed, pen=None))
    x = max(placed.pen.at, placed.right) + GAP
    axis = placed.pen.axis
    end: Point = (x, axis)
    corner: tuple[Point, ...] = (end,)
    line: Line = line_to(placed.pen, *corner)
    room.add(line, Shape(Form.FINAL, x, axis - 6, 12, 12, label))
    return room.placed(None)


def _written(rows: Sequence[tuple[Row, int]], x: float, y: float) -> list[Text]:
    return [text(x + dx, y + number * PITCH, *row, of) for number, (row, of, dx) in enumerate(indented(rows))]
