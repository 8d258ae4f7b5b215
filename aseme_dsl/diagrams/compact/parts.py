"""Parts: places the blocks of a statechart like a railroad diagram.

Each block has an axis, on which it is entered at the left and left at the right. The first branch is on the
axis, the others below; loops go back above, interrupts leave below, regions stand one below the other. The
time is linear in the states of each level.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import assert_never

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.blocks import Activity, Block, Branch, Closed, Cut, Group, Parallel, Part
from aseme_dsl.diagrams.compact.elements import (
    STACKED,
    Form,
    Link,
    Look,
    Nested,
    Point,
    Shape,
    Stroke,
    Text,
)
from aseme_dsl.diagrams.compact.nodes import PAD, Nodes, ended, endless
from aseme_dsl.diagrams.compact.pen import (
    GAP,
    PITCH,
    Pen,
    Placed,
    Room,
    back_width,
    down,
    line_to,
    over,
    pen,
    right_by,
    room_of,
    text,
)
from aseme_dsl.diagrams.compact.plan import Links, Plan
from aseme_dsl.diagrams.compact.turns import (
    ROW,
    back,
    beside,
    border_of,
    from_below,
    loop,
    pen_from_below,
    put_row,
    rows_of,
    taller,
)
from aseme_dsl.diagrams.compact.words import Words
from aseme_dsl.records import dataclass

_CHOICE = 10
"""Half a diamond."""

_ROW_AT_LEAST = 200
"""A row that is shorter does not end before what is too wide."""

_WIDE = 900
"""A sequence is broken before regions at its end that are wider."""


@dataclass(frozen=True, slots=True)
class Exit:
    """A line behind a part, and how far what is before it reaches."""

    line: Pen
    right: float


@dataclass(frozen=True, slots=True)
class Rim:
    """What the border of a block has to carry.

    - `labels`: the formulas that are nothing but this block.
    - `signs`: the transitions never taken, as the block is never complete.
    - `exits`: those whose texts stand as a table in it.
    - `least`: how wide it is at least.
    - `leaves`: whether lines leave from its border. `stops`: it is complete, and nothing follows.
    """

    labels: tuple[str, ...] = ()
    signs: Link = ()
    exits: Link = ()
    least: float = 0.0
    leaves: bool = False
    stops: bool = False


class Placer:
    """Places the blocks of one chart; labels are about `wide` px wide, in some regions as `chosen`.

    What has no compact form is drawn by `nested`. A row of pills comes to `room`. In the outermost regions
    that have `limits`, a line that comes to the limit continues in a row below. `copies` collects the regions
    that are drawn once for several, `widths` how wide the outermost ones are.
    """

    def __init__(
        self,
        chart: Statechart,
        words: Words,
        plan: Plan,
        wide: float,
        room: float,
        chosen: Mapping[str, float],
        limits: Mapping[str, float],
        nested: Nested | None = None,
    ) -> None:
        self.plan = plan
        self.copies: list[tuple[str, ...]] = []
        self.widths: dict[str, float] = {}
        self._chart = chart
        self._words = words
        self._wide = self._usual = wide
        self._chosen = chosen
        self._nodes = Nodes(chart, words, plan, room, nested)
        self._limits = limits
        self._limit: float | None = None
        self._bare: set[str] = set()
        self._is_inside = False

    # ---- regions -----------------------------------------------------------------------------------

    def field(self, region: Group | Closed, x: float) -> Placed:
        """A region: its initial dot, what is inside, and the ring if it ends."""
        if isinstance(region, Closed):
            return self._nodes.closed(region, None, x)
        if self._is_inside or self.plan.is_around_regions(region):
            return self._field(region, x)
        self._is_inside, self._wide = True, self._chosen.get(region.label, self._usual)
        self._limit = self._limits.get(region.label)
        placed = self._field(region, x)
        self._is_inside, self._limit = False, None
        self.widths[region.label] = placed.right - x
        return placed

    def _field(self, region: Group, x: float) -> Placed:
        title = self.plan.title(region)
        if title is not None:
            self._bare.add(title)
        room = Room()
        room.add(Shape(Form.INITIAL, x, -4, 8, 8, region.start))
        inside = self.group(region, pen(x + 8), (), lower=True)
        room.put(replace(inside, pen=None))
        if inside.pen is not None:
            end = inside.pen.at + GAP
            axis = inside.pen.axis
            room.add(line_to(inside.pen, (end, axis)))
            room.add(Shape(Form.FINAL, end, axis - 6, 12, 12, region.end or region.label))
        return room.placed(None)

    def whole(self, region: Group) -> Placed:
        """The outermost region, with what stays in it."""
        placed = self.field(region, 0.0)
        room = Room()
        if self.plan.staying(region.label):
            placed = self._titled(placed, (region,), -PAD)
            marks = self.plan.staying(region.label)
            room.add(Shape(Form.FIELD, 0, -placed.up - 4, max(placed.right, 40), 0, region.label, marks))
        room.put(placed)
        return room.placed(None)

    def regions(self, block: Parallel, x: float, rim: Rim) -> Placed:
        """The frame of an AND with its left border at x, without the line to it."""
        strips: list[tuple[Placed, tuple[Group | Closed, ...]]] = []
        middle = 0
        for run in self.plan.runs(block):
            if self.plan.pill(run[0]) is not None:
                strips.append(
                    (self._nodes.pills([item for item in run if isinstance(item, Group)], x + PAD), run)
                )
                continue
            if len(run) > 1:
                self.copies.append(tuple(item.label for item in run))
            if all(self.plan.pill(other[0]) is not None for _, other in strips):
                middle = len(strips)
            shift = PAD / 2 if len(run) > 1 else 0.0
            placed = self._titled(self.field(run[0], x + PAD + shift), run, x + shift)
            strips.append((self._stacked(placed, run[0].label, x + PAD / 2) if shift else placed, run))
        room = Room()
        tops: list[tuple[float, tuple[Group | Closed, ...]]] = []
        first = -sum(item.down + item.up + 12 for item, _ in strips[:middle]) if middle else 0.0
        axis = first + (strips[0][0].up - strips[middle][0].up if middle else 0.0)
        for number, (placed, run) in enumerate(strips):
            if number:
                axis += strips[number - 1][0].down + 12 + placed.up
            tops.append((axis - placed.up - 6, run))
            room.put(placed, axis)
        endless_ = self.plan.is_endless(block.label)
        if endless_:
            room.reach(x + strips[0][0].right - x + 34 if len(strips[0][0].elements) else 0)
        form = Form.PARALLEL
        shape, written = self._nodes.border(form, (*rim.labels, block.label), room, x, rim.exits, rim.least)
        if endless_:  # the sign stands beside the title
            needed = max((item.x + item.width for item in written), default=x) + 34 - shape.x
            shape = replace(shape, width=max(shape.width, needed))
        if not written:  # no title: the first dashed line is the border
            shape = replace(shape, y=shape.y + 3, height=shape.height - 3)
        made = Room()
        made.add(shape, *written)
        if endless_:
            made.add(endless(shape.x + shape.width - 26, shape.y + 12, block.label, rim.signs))
        for number, (top, run) in enumerate(tops):
            marks = () if isinstance(run[0], Closed) else self.plan.staying(run[0].label)
            if marks or (number and self.plan.pill(run[0]) is None):
                made.add(
                    Shape(Form.FIELD, x, top if number else shape.y, shape.width, 0, run[0].label, marks)
                )
            elif number:
                made.add(Shape(Form.FIELD, x, top, shape.width, 0, run[0].label))
        made.put(room.placed(None))
        return made.placed(None if endless_ else pen(shape.x + shape.width))

    def _stacked(self, placed: Placed, label: str, x: float) -> Placed:
        """A region that is drawn once for several, on the first of several sheets."""
        room = Room()
        top, width = -placed.up - 4, placed.right + PAD - x
        room.add(Shape(Form.STACK, x, top, width, placed.down + PAD - 4 - top, label))
        room.reach(x + width + STACKED + PAD / 2, 0.0, placed.down + PAD - 4 + STACKED)
        room.put(placed)
        return room.placed(placed.pen)

    def _titled(self, placed: Placed, run: tuple[Group | Closed, ...], x: float) -> Placed:
        """A field with its name and what stays in it, above what is inside."""
        label = run[0].label
        title = self.plan.title(run[0])
        names = self.plan.heading(title)[0] if title is not None else ""
        if len(run) > 1:
            names = f"{names} × {len(run)}".strip()
        rows = [] if isinstance(run[0], Closed) else self._nodes.rows(label)
        if not names and not rows:
            return placed
        room = Room()
        room.put(placed)
        top = -placed.up - (len(rows) + bool(names)) * PITCH
        if names:
            name = text(x + PAD, top + 11, names, Look.FIELD)
            room.add(replace(name, state=title or ""))
        room.add(
            *(
                text(x + PAD, top + 11 + (n + bool(names)) * PITCH, *row, of)
                for n, (row, of) in enumerate(rows)
            )
        )
        return room.placed(placed.pen)

    # ---- groups ------------------------------------------------------------------------------------

    def group(self, group: Group, line: Pen, signs: Link, lower: bool = False) -> Placed:
        """An OR without a border of its own, entered by the pen, which has the link to it.

        What is behind it may be `lower`: in the last row.
        """
        if group.choice is None:
            (branch,) = group.branches
            return self.branch(branch, line, signs, lower=lower)
        room = Room()
        line, written = over(replace(line, row=None), group.enter, self._words, self._wide)
        x = line.at + GAP
        middle = x + _CHOICE
        room.add(*written, line_to(line, (x, 0)))
        room.add(Shape(Form.CHOICE, x, -_CHOICE, 2 * _CHOICE, 2 * _CHOICE, group.choice, group.reactive))
        if group.reactive:
            room.add(text(middle - 5, 4, "↻", Look.SMALL))
        with_parts = [branch for branch in group.branches if branch.parts]
        column = max((room_of(item.enter, self._words, self._wide) for item in with_parts), default=0)
        ends: list[Exit] = []
        low = 0.0
        for number, branch in enumerate(group.branches):
            first = number == 0
            start = pen(x + 2 * _CHOICE) if first else Pen(((middle, 0.0), (middle, 0.0)), x + 2 * _CHOICE)
            mine = () if not signs or self._ends(branch) else signs
            signs = () if mine else signs
            placed = self.branch(branch, start, mine, column if branch.parts else 0)
            dy = 0.0 if first else low + ROW + placed.up
            under = (middle, 0.0), ((middle, float(_CHOICE)),)
            room.put(placed if first else from_below(placed, *under, dy), dy)
            low = max(low, dy + max(placed.down, _CHOICE + 2 if first else 6))
            if placed.pen is not None:
                behind = placed.pen if first else pen_from_below(placed.pen, *under, dy)
                ends.append(Exit(down(behind, -dy), placed.right))
        room.reach(0, 0, low)
        if signs:
            room.add(endless(room.right + 6, -8, group.label, signs))
        return self._join(room, ends)

    def _ends(self, branch: Branch) -> bool:
        """Whether something follows a branch."""
        return not branch.parts or self.plan.goes_on(branch.parts[-1])

    def _join(self, room: Room, ends: Sequence[Exit]) -> Placed:
        """Lines that meet at a joint on the axis, behind everything."""
        if not ends:
            return room.placed(None)
        if len(ends) == 1 and ends[0].line.axis == 0:
            return room.placed(ends[0].line)
        x = max(room.right, *(end.line.at for end in ends)) + 8
        for end in ends:
            line = end.line
            corner: tuple[Point, ...] = ((x, line.axis), (x, 0.0)) if line.axis != 0 else ((x, 0.0),)
            room.add(line_to(line, *corner, arrow=False))
        return room.placed(pen(x))

    def branch(
        self, branch: Branch, line: Pen, signs: Link, least: float = 0.0, lower: bool = False
    ) -> Placed:
        """The parts of a line one after the other, from the link that leads to the first."""
        if self._limit is None:
            return self._straight(branch, line, signs, least)
        limit = self._limit
        placed = self._if_it_fits(lambda: self._straight(branch, line, signs, least), limit)
        return placed or self._in_rows(branch, line, signs, least, limit, lower)

    def _if_it_fits(self, place: Callable[[], Placed], limit: float) -> Placed | None:
        """What is placed in one row, if it does not come to the limit."""
        known, self._limit = len(self.copies), None
        placed = place()
        self._limit = limit
        if placed.right <= limit:
            return placed
        del self.copies[known:]
        return None

    def _in_rows(
        self, branch: Branch, line: Pen, signs: Link, least: float, limit: float, lower: bool
    ) -> Placed:
        """The parts of a line in several rows: the line turns back below what it has come to."""
        room, row = Room(), Room()
        left = line.at + 12
        turns: tuple[Point, ...] = ()
        behind: Pen | None
        behind, written = over(line, branch.enter, self._words, self._wide, least)
        row.add(*written)
        for number, part in enumerate(branch.parts):
            assert behind is not None
            last = number == len(branch.parts) - 1
            dotted = not last and not self.plan.goes_on(part)
            place = partial(self.part, part, signs=signs if last else (), dotted=dotted)
            start = replace(behind, row=None)
            placed = self._if_it_fits(partial(place, start), limit)
            if placed is None and behind.at > left + _ROW_AT_LEAST:
                behind = put_row(room, row.placed(behind), turns)
                assert behind is not None
                right, under = max(behind.at, row.right) + 8, room.down + ROW
                turns = (*behind.points, (right, behind.axis), (right, under), (left, under))
                row = Room()
                start = replace(behind, points=((left, 0.0), (left, 0.0)), at=left, row=None)
                placed = self._if_it_fits(partial(place, start), limit)
            placed = placed or place(start)
            row.put(replace(placed, pen=None))
            behind = placed.pen
        behind = put_row(room, row.placed(behind), turns)
        if behind is None or lower:
            return room.placed(behind)
        return self._join(room, [Exit(behind, room.right)])

    def _straight(self, branch: Branch, line: Pen, signs: Link, least: float) -> Placed:
        """The parts of a line in one row."""
        room = Room()
        x = line.at - 8 if line.is_joint else line.at + 12
        behind: Pen | None
        behind, written = over(line, branch.enter, self._words, self._wide, least)
        room.add(*written)
        for number, part in enumerate(branch.parts):
            assert behind is not None
            last = number == len(branch.parts) - 1
            if number > 0:
                row = (x, room.down) if last and not self.plan.goes_on(part) else None
                behind = replace(behind, row=row)
            ends_here = not last and not self.plan.goes_on(part)
            placed = self.part(part, behind, signs if last else (), dotted=ends_here)
            room.put(replace(placed, pen=None))
            behind = placed.pen
        return room.placed(behind)

    # ---- parts -------------------------------------------------------------------------------------

    def part(
        self, part: Part, line: Pen, signs: Link, labels: tuple[str, ...] = (), dotted: bool = False
    ) -> Placed:
        """A block with the links back to it, onward and of what interrupts it.

        The formulas `labels` are nothing but this part, and have its frame. If something stands behind it
        that is never reached, it is `dotted` to there.
        """
        plan, block, links = self.plan, part.block, self.plan.links(part, dotted)
        signs = (*signs, *links.never)
        loops = isinstance(block, Group) and bool(links.again or links.back)
        room = Room()
        if part.cuts or links.again or links.back or links.events:
            line = replace(line, row=None)
        joint = line.at + 12
        if loops:
            room.add(line_to(line, (joint, 0), arrow=False))
            line = replace(pen(joint), at=joint + 4)
        table = not isinstance(block, Closed)
        silent = links.onward if table and not loops and plan.tabled(links.onward) else ()
        silent += links.events if table and plan.tabled(links.events) else ()
        inside = plan.is_endless(block.label) and not (loops and links.again)
        rim = Rim(
            labels,
            signs if inside else (),
            silent,
            max(
                back_width(links.back, self._words, self._wide) + 16 * bool(links.back),
                0.0 if loops else back_width(links.again, self._words, self._wide),
            ),
            bool(links.events or links.back or part.cuts or labels),
            not links.onward and not links.again,
        )
        body = self._body(block, line, rim)
        shape = border_of(body, block.label) if rim.leaves or not isinstance(block, Group) else None
        if links.events and shape is not None:
            rows = (
                rows_of(self._words, self._wide, links.events, silent, True)[0]
                + rows_of(self._words, self._wide, links.onward, silent, False)[1]
            )
            body, shape = taller(body, shape, rows * PITCH + beside(body, shape) + 14)
        room.put(replace(body, pen=None))
        behind = body.pen
        if loops:
            behind = loop(self._words, self._wide, room, body, joint, links, signs, block.label)
            if links.back and shape is not None:
                start = replace(pen(shape.x + shape.width - 12, shape.y), stroke=Stroke.CUT)
                room.add(
                    *back(
                        self._words, self._wide, links.back, start, joint, room.up if links.again else body.up
                    )
                )
        elif shape is not None:
            for link, stroke in ((links.again, Stroke.PLAIN), (links.back, Stroke.CUT)):
                start = replace(pen(shape.x + shape.width - 8, shape.y), stroke=stroke)
                room.add(
                    *(
                        back(self._words, self._wide, link, start, shape.x + 8, room.up, arc=True)
                        if link
                        else ()
                    )
                )
        # An activity that repeats and that nothing follows: its OR has no END.
        again_only = isinstance(block, Activity) and links.again and not (links.onward or links.events)
        if (signs or again_only) and not inside and not (loops and links.again):
            room.add(endless(room.right + 6, -8, block.label, signs))
        ends = self._onward(room, behind, shape, links, silent, isinstance(block, Activity) and not signs)
        for number, cut in enumerate(part.cuts):
            assert shape is not None
            # A lower one passes left of the texts above.
            x = shape.x + 12 + 9 * (len(part.cuts) - 1 - number)
            ends += self._cut(room, cut, (x, shape.y + shape.height))
        return self._join(room, ends)

    def _onward(
        self, room: Room, behind: Pen | None, shape: Shape | None, links: Links, silent: Link, near: bool
    ) -> list[Exit]:
        """The lines to what follows a part; the texts of one that is `near` may stand over what is low."""
        ends: list[Exit] = []
        if links.lost:
            x = shape.x + shape.width if shape is not None else room.right + 10
            never = replace(pen(x), stroke=Stroke.NEVER, at=max(x, room.right))
            never, written = self._over(never, links.lost, ())
            room.add(*written)
            ends.append(Exit(never, room.right))
        if links.onward and behind is not None:
            at = behind.at if near and not links.again else max(behind.at, room.right)
            behind, written = self._over(replace(behind, at=at), links.onward, silent)
            room.add(*written)
            ends.append(Exit(behind, room.right))
        if links.events and shape is not None:
            y = shape.y + shape.height - 10
            start = replace(pen(shape.x + shape.width, y), stroke=Stroke.CUT)
            start, written = self._over(start, links.events, silent)
            start = replace(start, at=start.at + (0 if written else 12))
            room.add(*written)
            room.reach(start.at, 0, y + 4)
            ends.append(Exit(start, start.at))
        return ends

    def _body(self, block: Block, line: Pen, rim: Rim) -> Placed:
        match block:
            case Activity():
                return self._nodes.activity(block, line, "", rim.least, rim.exits, rim.signs)
            case Closed():
                placed = self._nodes.closed(block, line, line.at + GAP, rim.signs, rim.least)
                return replace(placed, pen=None) if rim.stops else placed
            case Parallel():
                return self._parallel(block, line, rim)
            case Group():
                alone = self.plan.alone(block)
                framed = self.plan.is_framed(block.label) and block.label not in self._bare
                if alone is not None and framed and not rim.leaves:
                    return self._named(block, alone, line, rim.signs)
                if not rim.leaves and not framed:
                    placed = self.group(block, line, rim.signs)
                    return ended(placed, block.end or block.label) if rim.stops else placed
                return self._framed(block, line, rim)
            case _:
                assert_never(block)

    def _named(self, group: Group, part: Part, line: Pen, signs: Link) -> Placed:
        """A formula that is one activity: a node with both names."""
        activity = part.block
        assert isinstance(activity, Activity)
        line, _ = over(line, group.branches[0].enter, self._words, self._wide)
        name = self.plan.heading(group.label)[0]
        never = self.plan.never(part.onward)
        placed = self._nodes.activity(activity, line, name, 0, (), (*signs, *never))
        onward = self.plan.live(part.onward)
        if not onward or placed.pen is None:
            return replace(placed, pen=None)
        behind, _ = over(placed.pen, onward, self._words, self._wide)
        return replace(placed, pen=behind)

    def _framed(self, group: Group, line: Pen, rim: Rim) -> Placed:
        """An OR with a border; one that is nothing but another frame has that frame."""
        part = self.plan.merges(group, rim.leaves)
        if (
            part is not None
            and not rim.exits
            and not rim.least
            and (not rim.stops or self.plan.is_endless(group.label))
        ):
            line, _ = over(line, group.branches[0].enter, self._words, self._wide)
            return self.part(part, line, rim.signs, (*rim.labels, group.label))
        left = line.at + GAP - 4
        inside = self.group(group, replace(line, at=left - 2, row=None), rim.signs)
        if rim.stops:
            inside = ended(inside, group.end or group.label)
        room = Room()
        room.put(inside)
        branch = any(self._chart.is_branch(self._chart.node(label)) for label in (*rim.labels, group.label))
        form = Form.PROTOCOL if branch else Form.FRAME
        shape, written = self._nodes.border(
            form, (*rim.labels, group.label), room, left, rim.exits, rim.least
        )
        made = Room()
        made.add(shape, *written)
        made.put(inside)
        behind = inside.pen
        if behind is not None:
            behind = replace(behind, at=max(behind.at, shape.x + shape.width + 2))
        return made.placed(behind)

    def _parallel(self, block: Parallel, line: Pen, rim: Rim) -> Placed:
        """An AND with the line to it; below a long line if it is wide itself and nothing follows."""
        x = line.at + GAP
        start = x if line.row is None else line.row[0]
        frame = self.regions(block, start, rim)
        room = Room()
        if line.row is not None and frame.right - start > _WIDE and x > start + 60:
            dy = line.row[1] + 24 + frame.up
            room.put(frame, dy)
            at, top = line.at + 16, dy - frame.up
            corners: tuple[Point, ...] = ((at, 0.0),)
            if at > frame.right - 20:
                corners = ((at, 0.0), (at, top - 14), (frame.right - 20, top - 14))
            room.add(line_to(line, *corners, (corners[-1][0], top)))
            return room.placed(None)
        room.put(frame, 0, x - start)
        room.add(line_to(line, (x, 0)))
        return room.placed(None if frame.pen is None else right_by(frame.pen, x - start))

    # ---- lines -------------------------------------------------------------------------------------

    def _over(self, line: Pen, link: Link, silent: Link) -> tuple[Pen, tuple[Text, ...]]:
        """The pen after a link; the texts of `silent` ones stand in the state."""
        if link and link[0] in silent:
            return replace(line, chain=(*line.chain, link)), ()
        return over(line, link, self._words, self._wide)

    def _cut(self, room: Room, cut: Cut, start: Point) -> list[Exit]:
        """What interrupts a block: its line leaves the border below."""
        x, bottom = start
        line = replace(Pen(((x, 0.0), (x, 0.0)), x), stroke=Stroke.CUT)
        line, written = over(line, cut.enter, self._words, self._wide)
        placed = self.part(cut.part, line, ())
        made = Room()
        made.add(*written)
        made.put(placed)
        moved = made.placed(placed.pen)
        dy = max(room.down, bottom) + ROW + moved.up
        start_ = ((x, bottom),)
        room.put(from_below(moved, (x, 0.0), start_, dy), dy)
        if moved.pen is None:
            return []
        return [Exit(down(pen_from_below(moved.pen, (x, 0.0), start_, dy), -dy), moved.right)]
