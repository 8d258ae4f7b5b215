"""Layout: places blocks like a railroad diagram, in time linear in the states of each level.

Each block has an axis, on which it is entered at the left and left at the right. The first branch is on the
axis, the others below; loops go back above, interrupts leave below, regions stand one below the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from aseme_dsl.amola.statechart import OriginKind, Statechart, Transition
from aseme_dsl.diagrams.compact import texts
from aseme_dsl.diagrams.compact.blocks import Activity, Block, Branch, Group, Parallel, Part, blocks
from aseme_dsl.diagrams.compact.elements import (
    Element,
    Form,
    Line,
    Link,
    Look,
    Picture,
    Shape,
    Stroke,
    Text,
    moved,
)
from aseme_dsl.diagrams.compact.pen import GAP, PITCH, Pen, down, line_to, over, pen

_ROW = 11
"""Between two rows."""

_PAD = 10
"""Between a border and what is inside."""

_CHOICE = 11
"""Half a diamond."""

_MARGIN = 14


@dataclass(frozen=True, slots=True)
class _Placed:
    """A block in its place: its elements, the pen behind it (None: it never ends), and how far it reaches."""

    elements: tuple[Element, ...]
    pen: Pen | None
    right: float
    up: float
    down: float


def layout(chart: Statechart) -> Picture:
    """The compact drawing of a chart. Raises NotCompact."""
    placer = _Placer(chart)
    root = blocks(chart)
    field = placer.field(root, 0.0)
    title = texts.width(chart.name, Look.TITLE)
    head = Text(_MARGIN, _MARGIN + 14, chart.name, Look.TITLE, title)
    about = (
        f"{chart.kind} of {chart.system}: {len(chart.states)} states, {len(chart.transitions)} transitions"
    )
    more = Text(_MARGIN + title + 12, _MARGIN + 14, about, Look.SMALL, texts.width(about, Look.SMALL))
    axis = _MARGIN + 34 + field.up
    elements = [head, more, *(moved(item, _MARGIN, axis) for item in field.elements)]
    right = max(field.right + _MARGIN, more.x + more.width)
    below = axis + field.down + _MARGIN
    for number, module in enumerate(chart.modules):
        text = f"module {module.name}"
        below += PITCH
        elements.append(Text(_MARGIN, below - 4, text, Look.SMALL, texts.width(text, Look.SMALL)))
        right = max(right, _MARGIN + texts.width(text, Look.SMALL)) if number >= 0 else right
    return Picture(round(right + _MARGIN, 1), round(below + _MARGIN, 1), tuple(elements))


def _extent(elements: Iterable[Element]) -> tuple[float, float, float]:
    """How far elements reach to the right, above and below the axis."""
    right, up, low = 0.0, 0.0, 0.0
    for item in elements:
        match item:
            case Line():
                right = max(right, *(x for x, _ in item.points))
                up = max(up, *(-y for _, y in item.points))
                low = max(low, *(y for _, y in item.points))
            case Shape():
                right = max(right, item.x + item.width)
                up, low = max(up, -item.y), max(low, item.y + item.height)
            case Text():
                right = max(right, item.x + item.width)
                up, low = max(up, 11 - item.y), max(low, item.y + 4)
            case _:
                assert_never(item)
    return right, up, low


def _placed(elements: Sequence[Element], behind: Pen | None) -> _Placed:
    right, up, low = _extent(elements)
    right = max(right, behind.at) if behind is not None else right
    return _Placed(tuple(elements), behind, right, up, low)


class _Placer:
    """Places the blocks of one chart; it holds nothing but the chart."""

    def __init__(self, chart: Statechart) -> None:
        self._chart = chart
        self._transitions = chart.transitions
        places = {id(item): place for place, item in enumerate(chart.transitions)}
        staying: dict[str, list[int]] = {}
        for item in chart.transitions:
            if not item.changes_state:
                staying.setdefault(item.source, []).append(places[id(item)])
        self._staying = {label: tuple(found) for label, found in staying.items()}

    def field(self, group: Group, x: float) -> _Placed:
        """A region: its initial dot, what is inside, and the ring if it ends."""
        dot = Shape(Form.INITIAL, x, -4, 8, 8, group.start)
        inside = self.group(group, pen(x + 8))
        elements: list[Element] = [dot, *inside.elements]
        if inside.pen is not None:
            end = inside.pen.at + GAP + 6
            elements.append(line_to(inside.pen, (end, 0)))
            elements.append(Shape(Form.FINAL, end, -6, 12, 12, group.end or group.label))
        return _placed(elements, None)

    def group(self, group: Group, line: Pen) -> _Placed:
        """An OR, entered by the pen, which has the link to it."""
        if group.choice is None:
            (branch,) = group.branches
            return self.branch(branch, line, group.end)
        line, written = over(line, group.enter, self._transitions)
        x = line.at + GAP + 4
        middle = x + _CHOICE
        elements: list[Element] = [*written, line_to(line, (x, 0))]
        diamond = Shape(Form.CHOICE, x, -_CHOICE, 2 * _CHOICE, 2 * _CHOICE, group.choice, group.reactive)
        elements.append(diamond)
        if group.reactive:
            elements.append(Text(middle - 5, 4, "↻", Look.SMALL, 10))
        ends: list[tuple[Pen, float]] = []
        low = 0.0
        right = x + 2 * _CHOICE
        for number, branch in enumerate(group.branches):
            first = number == 0
            start = pen(x + 2 * _CHOICE) if first else Pen(((middle, 0.0), (middle, 0.0)), middle + 6)
            placed = self.branch(branch, start, group.end)
            dy = 0.0 if first else low + _ROW + placed.up
            shift = [moved(item, 0, dy) for item in placed.elements]
            if not first:
                shift = [self._from_diamond(item, middle, dy) for item in shift]
            elements += shift
            low = max(low, dy + max(placed.down, _CHOICE + 2 if first else 6))
            right = max(right, placed.right)
            if placed.pen is not None:
                behind = down(placed.pen, -dy)
                if len(behind.points) > 1 and behind.points[0] == (middle, dy):
                    behind = replace(behind, points=((middle, float(_CHOICE)), *behind.points[1:]))
                ends.append((behind, placed.right))
        if not ends:
            return _placed(elements, None)
        return self._join(elements, ends, right)

    def _from_diamond(self, item: Element, x: float, dy: float) -> Element:
        """A line that begins below the diamond; it was placed from its own axis."""
        if isinstance(item, Line) and len(item.points) > 1 and item.points[:2] == ((x, dy), (x, dy)):
            return replace(item, points=((x, float(_CHOICE)), *item.points[1:]))
        return item

    def _join(self, elements: list[Element], ends: Sequence[tuple[Pen, float]], right: float) -> _Placed:
        """Lines that meet at a joint on the axis, behind everything."""
        if len(ends) == 1 and ends[0][0].axis == 0:
            return _placed(elements, ends[0][0])
        x = max(right, *(line.at for line, _ in ends)) + 8
        for line, _ in ends:
            corner = ((x, line.axis), (x, 0.0)) if line.axis != 0 else ((x, 0.0),)
            elements.append(line_to(line, *corner, arrow=False))
        return _placed(elements, pen(x))

    def branch(self, branch: Branch, line: Pen, end: str | None) -> _Placed:
        """The parts of a line one after the other, from the link that leads to the first."""
        line, written = over(line, branch.enter, self._transitions)
        elements: list[Element] = list(written)
        behind: Pen | None = line
        for part in branch.parts:
            assert behind is not None
            placed = self.part(part, behind)
            elements += placed.elements
            behind = placed.pen
            if behind is None and part is not branch.parts[-1]:
                raise AssertionError("every part with a link onward has a line behind it")
        return _placed(elements, behind)

    def part(self, part: Part, line: Pen) -> _Placed:
        """A block with the links back to it, onward and of what interrupts it."""
        block = part.block
        label = block.label
        events = self._events(part.onward) if isinstance(block, Group) else ()
        onward = tuple(item for item in part.onward if item not in events)
        again_events = self._events(part.again) if isinstance(block, Group) else ()
        again = tuple(item for item in part.again if item not in again_events)
        elements: list[Element] = []
        joint: tuple[float, float] | None = None
        if (again or again_events or part.cuts) and isinstance(block, Group) and (again or again_events):
            x = line.at + 10
            elements.append(line_to(line, (x, 0), arrow=False))
            joint = (x, 0.0)
            line = pen(x)
            line = replace(line, at=x + 4)
        framed = bool(events or again_events or part.cuts) or self._is_framed(label)
        if isinstance(block, Group) and framed:
            left = line.at + 8
            inside = self.group(block, replace(line, at=left + _PAD))
            if not onward and not again:
                inside = self._ended(block, inside)
            inside = self._frame(label, left, inside, self._wide(again_events) + 16)
        elif isinstance(block, Group):
            inside = self.group(block, line)
            if not onward and not again:
                inside = self._ended(block, inside)
        else:
            inside = self.block(block, line, self._wide(again))
        elements += inside.elements
        behind, right = inside.pen, inside.right
        top, low = inside.up, inside.down
        shape = next((s for s in inside.elements if isinstance(s, Shape) and s.state == label), None)
        # The line back above the block.
        if isinstance(block, Group) and (again or again_events):
            assert joint is not None
            if again:
                if behind is None:  # it never ends, so this is never taken
                    start: Pen = replace(pen(right + 10), stroke=Stroke.NEVER)
                    exits = start
                    behind = start
                else:
                    x = max(max(behind.at, right) + 10, joint[0] + self._wide(again))
                    if behind.is_joint and behind.at >= max(right, joint[0] + self._wide(again)):
                        exits = behind
                    else:
                        elements.append(line_to(behind, (x, 0), arrow=False))
                        exits = pen(x)
                        behind = exits
                back, shift = self._back(again, exits, joint, top)
                elements += back
                behind = shift if onward else None
                top = _extent(elements)[1]
                right = max(right, exits.at)
            if again_events:
                back_top = replace(pen(right - 12, -top if shape is None else shape.y), stroke=Stroke.CUT)
                elements += self._back_from(again_events, back_top, joint, top)
        elif again and shape is not None:
            start = pen(shape.x + shape.width - 8, shape.y)
            elements += self._back_from(again, start, (shape.x + 8, shape.y), top)
        # Onward.
        if onward and behind is None:
            behind = replace(pen(right + 10), stroke=Stroke.NEVER)
            right += 10
        if behind is not None and not onward and not isinstance(block, Group):
            behind = None
        ends: list[tuple[Pen, float]] = []
        if behind is not None:
            behind, written = over(replace(behind, at=max(behind.at, right)), onward, self._transitions)
            elements += written
            ends.append((behind, right))
        if shape is not None:
            low = max(low, *(item.y + 4 for item in elements if isinstance(item, Text)), 0.0)
        bottom = 0.0 if shape is None else shape.y + shape.height
        side = right
        if events:
            assert shape is not None
            written_right = max(
                (item.x + item.width for item in elements if isinstance(item, Text)), default=0
            )
            start = replace(pen(shape.x + shape.width - 12, bottom), stroke=Stroke.CUT)
            rows = max(1, sum(sum(map(len, texts.rows(self._transitions[item], True))) for item in events))
            axis = max(low, bottom) + 10 + rows * PITCH
            start = replace(start, points=(*start.points, (start.at, axis)))
            start, written = over(start, events, self._transitions)
            elements += written
            ends.append((start, start.at))
            low = max(_extent(written)[2], axis + 4)
            side = max(side, start.at, written_right)
        for number, cut in enumerate(part.cuts):
            assert shape is not None
            x = shape.x + 12 + 9 * (len(part.cuts) - 1 - number)  # a lower one passes left of the texts above
            start = replace(Pen(((x, 0.0), (x, 0.0)), x), stroke=Stroke.CUT)
            start, written = over(start, cut.enter, self._transitions)
            placed = self.part(cut.part, start)
            made = _placed([*written, *placed.elements], placed.pen)
            dy = low + _ROW + made.up
            for item in made.elements:
                shifted = moved(item, 0, dy)
                if isinstance(shifted, Line) and shifted.points[:2] == ((x, dy), (x, dy)):
                    shifted = replace(shifted, points=((x, bottom), *shifted.points[1:]))
                elements.append(shifted)
            low = dy + made.down
            side = max(side, made.right)
            if made.pen is not None:
                after = down(made.pen, -dy)
                if after.points[0] == (x, dy):
                    after = replace(after, points=((x, bottom), *after.points[1:]))
                ends.append((after, made.right))
        if not ends:
            return _placed(elements, None)
        return self._join(elements, ends, side)

    def _ended(self, group: Group, inside: _Placed) -> _Placed:
        """A group that is complete and waits for an event: its line ends at a ring."""
        if inside.pen is None:
            return inside
        x = max(inside.pen.at, inside.right) + GAP
        ring = Shape(Form.FINAL, x, -6, 12, 12, group.end or group.label)
        return _placed([*inside.elements, line_to(inside.pen, (x, 0)), ring], None)

    def _wide(self, link: Link) -> float:
        """How long a line back must be for its texts."""
        rows = [row for place in link for part in texts.rows(self._transitions[place], True) for row in part]
        return max((texts.width(*row) + 36 for row in rows), default=0.0)

    def _events(self, link: Link) -> Link:
        """Those that need not wait until their source is complete."""
        items: Sequence[Transition] = self._transitions
        return tuple(
            place for place in link if items[place].expression.events or items[place].expression.when
        )

    def _is_framed(self, label: str) -> bool:
        state = self._chart.node(label)
        named = state.name != label and state.name.partition("(")[0].replace(".", "_").isidentifier()
        return named or label in self._staying or self._chart.is_branch(state)

    def _frame(self, label: str, left: float, inside: _Placed, least: float) -> _Placed:
        """A border around what is placed, with its title and the rows of what stays in it."""
        title = self._title(label)
        rows = self._rows(label)
        head = [(title, Look.NAME)] if title else []
        head += rows
        top = -inside.up - _PAD - len(head) * PITCH
        wide = max((texts.width(text, look) for text, look in head), default=0)
        right = max(inside.right + _PAD, left + wide + 2 * _PAD, left + least)
        height = inside.down + _PAD - top
        shape = Shape(Form.FRAME, left, top, right - left, height, label, self._staying.get(label, ()))
        written = [
            Text(left + _PAD, top + 14 + row * PITCH, text, look, texts.width(text, look))
            for row, (text, look) in enumerate(head)
        ]
        behind = inside.pen
        if behind is not None:
            behind = replace(behind, at=max(behind.at, right + 2))
        return _placed([shape, *written, *inside.elements], behind)

    def _title(self, label: str) -> str:
        state = self._chart.node(label)
        if state.origin.kind is OriginKind.PROTOCOL and self._chart.is_branch(state):
            return f"{state.origin.owner} · {state.origin.name}" if state.origin.name else state.origin.owner
        return state.name if state.name != label else ""

    def _rows(self, label: str) -> list[tuple[str, Look]]:
        return [
            (text, Look.SMALL)
            for place in self._staying.get(label, ())
            for part in texts.rows(self._transitions[place])
            for text, _ in part
        ]

    def _back(
        self, link: Link, start: Pen, joint: tuple[float, float], top: float
    ) -> tuple[list[Element], Pen]:
        """The line back above a group, and the pen behind it."""
        elements = self._back_from(link, start, joint, top)
        return elements, replace(start, at=start.at + 8)

    def _back_from(self, link: Link, start: Pen, joint: tuple[float, float], top: float) -> list[Element]:
        """A line from a pen up, back, and down to a joint, with its texts above."""
        low = sum(len(texts.rows(self._transitions[item])[1]) for item in link)
        axis = -top - 8 - (low * PITCH if low else 0)
        at = Pen(((joint[0], axis),), joint[0] + 2, (), start.stroke)
        after, written = over(at, link, self._transitions)
        points = (*start.points, (start.points[-1][0], axis), (joint[0], axis), joint)
        return [*written, Line(points, after.chain, after.stroke)]

    def block(self, block: Block, line: Pen, least: float = 0.0) -> _Placed:
        """A block, at least so wide, entered by the pen, which has the link to it."""
        match block:
            case Activity():
                return self._activity(block, line, least)
            case Parallel():
                return self._parallel(block, line, least)
            case Group():
                return self.group(block, line)
            case _:
                assert_never(block)

    def _activity(self, block: Activity, line: Pen, least: float) -> _Placed:
        x = line.at + GAP
        name = self._chart.node(block.label).name
        lines: list[tuple[str, Look]] = [(name, Look.NAME), *self._rows(block.label)]
        width = max(texts.width(text, look) for text, look in lines) + 2 * 9
        width = max(width, least)
        height = len(lines) * PITCH + 9
        shape = Shape(Form.ACTIVITY, x, -12, width, height, block.label, self._staying.get(block.label, ()))
        written = [
            Text(
                x + (width - texts.width(text, look)) / 2,
                4.5 + row * PITCH,
                text,
                look,
                texts.width(text, look),
            )
            for row, (text, look) in enumerate(lines)
        ]
        return _placed([line_to(line, (x, 0)), shape, *written], pen(x + width))

    def _parallel(self, block: Parallel, line: Pen, least: float) -> _Placed:
        x = line.at + GAP
        elements: list[Element] = []
        axis, right, up = 0.0, x + max(40, least), 0.0
        borders: list[float] = []
        head = self._rows(block.label)
        for number, region in enumerate(block.regions):
            placed = self.field(region, x + _PAD)
            title = [(self._chart.node(region.label).name, Look.SMALL)]
            if title[0][0] == region.label:
                title = []
            rows = [*title, *self._rows(region.label)]
            top = placed.up + len(rows) * PITCH + 6
            if number == 0:
                up = top
            else:
                borders.append(axis)
                axis += top
            marks = self._staying.get(region.label, ())
            elements.append(Shape(Form.FIELD, x, axis - top, 0, top + placed.down + 6, region.label, marks))
            elements += [
                Text(x + _PAD, axis - top + 14 + row * PITCH, text, look, texts.width(text, look))
                for row, (text, look) in enumerate(rows)
            ]
            elements += [moved(item, 0, axis) for item in placed.elements]
            right = max(right, placed.right + _PAD, *(x + 2 * _PAD + texts.width(*row) for row in rows))
            axis += placed.down + 6
        elements = [
            replace(item, width=right - x)
            if isinstance(item, Shape) and item.form is Form.FIELD and item.x == x
            else item
            for item in elements
        ]
        written = [
            Text(x + _PAD, -up - len(head) * PITCH + 12 + row * PITCH, text, look, texts.width(text, look))
            for row, (text, look) in enumerate(head)
        ]
        right = max(right, *(item.x + item.width + _PAD for item in written)) if written else right
        top = -up - (len(head) * PITCH + 4 if head else 0)
        shape = Shape(
            Form.PARALLEL, x, top, right - x, axis - top, block.label, self._staying.get(block.label, ())
        )
        return _placed([line_to(line, (x, 0)), shape, *written, *elements], pen(right))


__all__ = ["layout"]
