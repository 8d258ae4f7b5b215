"""Turns: lines that go back to a joint or continue in a row below, and borders that they leave from."""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.diagrams.compact.elements import Element, Form, Line, Link, Point, Shape, Stroke, Text
from aseme_dsl.diagrams.compact.nodes import endless
from aseme_dsl.diagrams.compact.pen import PITCH, Pen, Placed, Room, back_width, down, line_to, over, pen
from aseme_dsl.diagrams.compact.plan import Links
from aseme_dsl.diagrams.compact.words import Words, link_rows

ROW = 9
"""Between two rows, in px."""


def loop(
    words: Words, wide: float, room: Room, body: Placed, joint: float, links: Links, signs: Link, label: str
) -> Pen | None:
    """The line back above a group; the pen behind it if something follows."""
    if not links.again:
        return body.pen
    assert body.pen is not None
    behind, least = body.pen, joint + back_width(links.again, words, wide)
    axis = behind.axis
    reached = behind.is_joint and behind.at >= max(body.right, least)
    x = behind.at if reached else max(max(behind.at, body.right) + 10, least)
    if links.onward and not reached:
        room.add(line_to(behind, (x, axis), arrow=False))
        behind = pen(x, axis)
    elif not reached:
        behind = replace(behind, points=(*behind.points, (x, axis)), at=x)
    texts = back(words, wide, links.again, behind, joint, body.up)
    room.add(*texts)
    if signs or not (links.onward or links.events):
        written = [item.x + item.width for item in texts if isinstance(item, Text)]
        line = next(item for item in texts if isinstance(item, Line))
        room.add(endless(max(written, default=joint + 4) + 6, line.points[-2][1] - 7, label, signs))
    return replace(behind, at=behind.at + 8) if links.onward else None


def back(
    words: Words, wide: float, link: Link, start: Pen, joint: float, top: float, *, arc: bool = False
) -> list[Element]:
    """A line from a pen up, back, and down to a joint, with its texts above.

    An arc goes back to the border that it leaves.
    """
    _, below = link_rows(words, link, wide, start.stroke is Stroke.CUT)
    axis = -top - 8 - len(below) * PITCH
    at = Pen(((joint, axis),), joint + 2, (), start.stroke)
    after, written = over(at, link, words, wide)
    end = (joint, start.axis if arc else 0.0)
    points = (*start.points, (start.points[-1][0], axis), (joint, axis), end)
    return [*written, Line(points, (*start.chain, *after.chain), after.stroke)]


def rows_of(words: Words, wide: float, link: Link, silent: Link, cuts: bool) -> tuple[int, int]:
    """How many rows stand above and below the line of a link."""
    if link and link[0] in silent:
        return 0, 0
    above, below = link_rows(words, link, wide, cuts)
    return len(above), len(below)


def put_row(room: Room, row: Placed, turns: tuple[Point, ...]) -> Pen | None:
    """Put a row below all others, entered by a line with these turns; gives the pen behind it."""
    if not turns:
        room.put(replace(row, pen=None))
        return row.pen
    left, under = turns[-1]
    axis = under + ROW + row.up
    start = (*turns, (left, axis))
    room.put(replace(from_below(row, (left, 0.0), start, axis), pen=None), axis)
    room.reach(max(x for x, _ in turns))
    return None if row.pen is None else down(pen_from_below(row.pen, (left, 0.0), start, axis), -axis)


def from_below(placed: Placed, mark: Point, start: tuple[Point, ...], dy: float) -> Placed:
    """What was placed from a mark on its own axis; its first line begins elsewhere when it is `dy` lower."""

    def moved(item: Element) -> Element:
        if isinstance(item, Line) and item.points[:2] == (mark, mark):
            return replace(item, points=(*((x, y - dy) for x, y in start), *item.points[1:]))
        return item

    return replace(placed, elements=tuple(map(moved, placed.elements)))


def pen_from_below(line: Pen, mark: Point, start: tuple[Point, ...], dy: float) -> Pen:
    """The pen behind what was placed so, if it has not left the mark yet."""
    if line.points[:2] != (mark, mark):
        return line
    return replace(line, points=(*((x, y - dy) for x, y in start), *line.points[1:]))


def border_of(placed: Placed, label: str) -> Shape | None:
    """The border of a state among what has been placed."""
    forms = (Form.FIELD, Form.ENDLESS, Form.PILL, Form.STACK)
    shapes = (item for item in placed.elements if isinstance(item, Shape) and item.form not in forms)
    return next((item for item in shapes if item.state == label or label in item.also), None)


def beside(placed: Placed, shape: Shape) -> float:
    """How far the texts reach below the axis that stand right of a border already."""
    right = shape.x + shape.width
    return max(
        (item.y + 4 for item in placed.elements if isinstance(item, Text) and item.x >= right), default=0
    )


def taller(placed: Placed, shape: Shape, below: float) -> tuple[Placed, Shape]:
    """The border so high that it reaches so far below the axis."""
    missing = below - (shape.y + shape.height)
    if missing <= 0:
        return placed, shape
    made = replace(shape, height=shape.height + missing)
    elements = tuple(made if item is shape else item for item in placed.elements)
    return replace(placed, elements=elements, down=max(placed.down, below)), made
