"""Layout: the page of a compact drawing: title, modules, the chart, and what explains its words below."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.blocks import Closed, Group, NotCompact, Parallel, blocks
from aseme_dsl.diagrams.compact.elements import SIZES, Look, Nested, Picture, Shape, Text
from aseme_dsl.diagrams.compact.endings import Endings
from aseme_dsl.diagrams.compact.parts import Placer, Rim
from aseme_dsl.diagrams.compact.pen import PITCH, Placed, Room, text
from aseme_dsl.diagrams.compact.plan import Plan
from aseme_dsl.diagrams.compact.words import Words, width
from aseme_dsl.diagrams.look.labels import fitted
from aseme_dsl.records import dataclass

_MARGIN = 14

_WIDTHS = (152, 190, 132, 116, 100)
"""How wide labels are; the next is tried for an outermost region that is wider than wanted."""

_SLACK = 100
"""How much of the width the borders around a line that turns back may take at first, in px."""

_TRIES = 4
"""How often a lower limit is tried for a region that comes over it."""

_AROUND = 120
"""The most that the frame of the outermost regions takes, in px."""

_GAIN = 0.9
"""Narrow labels are worth it where a region is at most so much of its usual width."""

_LEAST = 560
"""How wide a page with texts below is at least, unless they need less."""

_BESIDE = 300
"""So much room beside the chart is enough for the texts that have none below, in px."""


Entry = tuple[str, str]
"""A name or a number, and what it stands for; channels have no name."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is to be drawn: the OR `top`, with the composites `closed` closed, if it can be in the `size`.

    On a `page` of this size, the texts below are as wide as the chart. If that is too high, they take all of
    the width, or stand beside the chart, or `apart` on pages of their own. The `path` leads to the page, from
    the states that the pages before it show. What has no compact form is drawn by `nested`, if that is given.
    """

    top: str
    closed: frozenset[str] = frozenset()
    size: tuple[float, float] = (1920, 1080)
    page: bool = False
    apart: bool = False
    path: tuple[str, ...] = ()
    nested: Nested | None = None


def layout(chart: Statechart, activities: Iterable[Activity] = (), wanted: Wanted | None = None) -> Picture:
    """The compact drawing of a chart, or of a part of it. Raises NotCompact."""
    wanted = wanted or Wanted(chart.root.label)
    root = _blocks(chart, wanted)
    endings, first = Endings(chart), Words(chart, tuple(activities))
    room, nested = wanted.size[0] - 2 * _AROUND, wanted.nested

    def drawn(
        wide: float, chosen: Mapping[str, float], limits: Mapping[str, float]
    ) -> tuple[Picture, Mapping[str, float], float]:
        words = first.anew()
        placer = Placer(chart, words, Plan(chart, words, endings), wide, room, chosen, limits, nested)
        field = _root(chart, placer.plan, placer, root, words)
        return _page(chart, field, words, placer, wanted), placer.widths, field.right

    picture, widths, right = drawn(_WIDTHS[0], {}, {})
    around = right - max(widths.values(), default=right)
    limit = wanted.size[0] - 2 * _MARGIN - max(2 * _MARGIN, min(around, _AROUND))
    measured = [(_WIDTHS[0], widths)]
    for wide in _WIDTHS[1:]:
        if all(width <= limit for width in widths.values()):
            break
        picture, widths, _ = drawn(wide, {}, {})
        measured.append((wide, widths))
    if len(measured) == 1:
        return picture
    chosen = {label: _best(label, measured, limit) for label in widths}
    fit = {label for label in widths if any(found[label] <= limit for _, found in measured)}
    limits = dict.fromkeys(widths.keys() - fit, limit - _SLACK)
    picture, widths, _ = drawn(_WIDTHS[0], chosen, limits)
    best = {label: (widths[label], -at) for label, at in limits.items()}
    for _ in range(_TRIES):  # what stands behind a row may come over the limit
        more = {label: widths[label] - limit for label in limits if best[label][0] > limit}
        if not more:
            return picture
        limits = {label: max(at - more.get(label, 0.0), _LEAST) for label, at in limits.items()}
        picture, widths, _ = drawn(_WIDTHS[0], chosen, limits)
        best = {label: min(best[label], (widths[label], -at)) for label, at in limits.items()}
    return drawn(_WIDTHS[0], chosen, {label: -at for label, (_, at) in best.items()})[0]


def _blocks(chart: Statechart, wanted: Wanted) -> Group | Closed:
    """The blocks of a page; one that another page leads to may be all nested. Raises NotCompact."""
    try:
        return blocks(chart, wanted.top, wanted.closed)
    except NotCompact as reason:
        if wanted.nested is None or not wanted.path:
            raise
        return Closed(wanted.top, str(reason))


def _best(label: str, measured: Sequence[tuple[float, Mapping[str, float]]], limit: float) -> float:
    """How wide the labels of a region are: as they are first within the limit.

    If they never are, as the region is narrowest, or as usual if that gains little. Nothing outside the
    region counts, so that a change there leaves it as it is.
    """
    for wide, widths in measured:
        if widths[label] <= limit:
            return wide
    usual, narrowest = measured[0], min(measured, key=lambda item: item[1][label])
    return narrowest[0] if narrowest[1][label] < _GAIN * usual[1][label] else usual[0]


def texts_of(top: str) -> str:
    """What leads to the page with the texts of a state's page."""
    return f"{top} texts"


def scale(picture: Picture, size: tuple[float, float]) -> float:
    """How large the drawing is where there is room of a size; 1 if it fits."""
    return min(1.0, size[0] / picture.width, size[1] / picture.height)


def _page(chart: Statechart, field: Placed, words: Words, placer: Placer, wanted: Wanted) -> Picture:
    part = wanted.top != chart.root.label
    states, transitions = len(chart.states), len(chart.transitions)
    about = f"{chart.kind} of {chart.system}: {states} states, {transitions} transitions"
    room = _titled(chart, placer.plan, wanted, f"a part of the {about}" if part else about)
    top = _MARGIN + 28.0
    if chart.modules and not part:
        room.add(*_modules(chart, top))
        top += 24
    room.put(field, top + field.up, _MARGIN)
    entries = _entries(words)
    right = max(room.right, _MARGIN + min(_needed(entries), _LEAST - _MARGIN))
    below = room.down + 20
    further: tuple[Picture, ...] = ()
    if wanted.apart and entries:
        told = text(_MARGIN, below, "Its names and numbers are explained on a page of their own.", Look.SMALL)
        room.add(replace(told, leads=texts_of(wanted.top)))
        further = _apart(chart, placer.plan, wanted, entries)
    else:
        explained = _explained(entries, _MARGIN, right - _MARGIN, below)
        lowest = max((item.y for item in explained), default=0.0)
        if wanted.page and lowest + 2 * _MARGIN > wanted.size[1]:
            explained = _explained(entries, _MARGIN, wanted.size[0] - 2 * _MARGIN, below)
            lowest = max((item.y for item in explained), default=0.0)
        beside = wanted.size[0] - room.right - 2 * _MARGIN
        if wanted.page and lowest + 2 * _MARGIN > wanted.size[1] and beside > _BESIDE:
            explained = _explained(entries, room.right + _MARGIN, beside, top)
        room.add(*explained)
    return Picture(
        round(max(right, room.right) + _MARGIN, 1),
        round(room.down + _MARGIN, 1),
        tuple(room.elements),
        wanted.top,
        tuple(placer.copies),
        tuple(words.notes),
        further,
    )


def _titled(chart: Statechart, plan: Plan, wanted: Wanted, about: str) -> Room:
    """A page with its title: the chart, and the formulas that lead to what it shows."""
    room = Room()
    at = float(_MARGIN)
    shown = [*wanted.path, wanted.top]
    for number, label in enumerate(shown if chart.root.label in shown else [chart.root.label, *shown]):
        name = f"{'· ' if number else ''}{plan.called(label)}"
        room.add(replace(text(at, _MARGIN + 14, name, Look.TITLE), leads=label))
        at += width(name, Look.TITLE) + 5
    room.add(text(at + 7, _MARGIN + 14, about, Look.SMALL))
    return room


def _apart(chart: Statechart, plan: Plan, wanted: Wanted, entries: Sequence[Entry]) -> tuple[Picture, ...]:
    """What the names and numbers of a page stand for, on pages of the same size."""
    made: list[Picture] = []
    top = _MARGIN + 46.0
    waiting = list(entries)
    while waiting:
        room = _titled(chart, plan, wanted, "what its names and numbers stand for")
        count = next(
            count
            for count in range(len(waiting), 0, -1)
            if count == 1 or _lowest(waiting[:count], wanted, top) + 2 * _MARGIN <= wanted.size[1]
        )
        room.add(*_explained(waiting[:count], _MARGIN, wanted.size[0] - 2 * _MARGIN, top))
        del waiting[:count]
        size = round(room.right + _MARGIN, 1), round(room.down + _MARGIN, 1)
        made.append(Picture(*size, tuple(room.elements), wanted.top))
    return tuple(made)


def _lowest(entries: Sequence[Entry], wanted: Wanted, top: float) -> float:
    return max(item.y for item in _explained(entries, _MARGIN, wanted.size[0] - 2 * _MARGIN, top))


def _root(chart: Statechart, plan: Plan, placer: Placer, root: Group | Closed, words: Words) -> Placed:
    """The outermost region: an AND that never ends needs no line to it."""
    if isinstance(root, Closed):
        return placer.field(root, 0.0)
    part = plan.only(root)
    group: Group | None = root
    enter = root.branches[0].enter if part is not None else ()
    signs: tuple[int, ...] = ()
    entered: tuple[int, ...] = ()
    labels: tuple[str, ...] = ()
    while part is not None and group is not None:
        quiet = (
            not part.again
            and not plan.staying(root.label)
            and not any(map(words.has_text, enter))
            and not plan.live(part.onward)
        )
        if not quiet:
            break
        signs, entered = (*signs, *part.onward), (*entered, *enter)
        block = part.block
        if isinstance(block, Parallel):
            placed = placer.regions(block, 0.0, Rim(labels, signs))
            frame, *others = placed.elements
            assert isinstance(frame, Shape)
            return replace(placed, elements=(replace(frame, marks=(*frame.marks, *entered)), *others))
        if not isinstance(block, Group) or plan.staying(block.label) or block.reactive:
            break
        if plan.heading(block.label)[0] != chart.name:
            labels = (*labels, block.label)
        group, part = block, plan.only(block)
        enter = block.branches[0].enter
    return placer.whole(root)


def _modules(chart: Statechart, y: float) -> list[Text]:
    said = [text(_MARGIN, y + 8, "modules", Look.SMALL)]
    x = _MARGIN + width("modules", Look.SMALL) + 12
    for module in chart.modules:
        said.append(text(x, y + 8, module.name, Look.FIELD))
        x += width(module.name, Look.FIELD) + 5
        every = duration_text(module.statement.every) if module.statement.every else ""
        said.append(text(x, y + 8, every, Look.SMALL))
        x += width(every, Look.SMALL) + 16
    return said


def _entries(words: Words) -> list[Entry]:
    """What each name of a `let`, each number and each short name of a channel stands for."""
    entries = [(name, f"= {said}") for name, said in words.lets().items()]
    entries += [(f"({number})", said) for number, said in enumerate(map(words.text, words.notes), 1)]
    short = ", ".join(f"{name} = {full}" for name, full in words.short_channels().items())
    return [*entries, ("", f"channels: {short}")] if short else entries


def _needed(entries: Sequence[Entry]) -> float:
    """How wide the entries are if each is one line."""
    indent = max((width(name, Look.FIELD) for name, _ in entries if name), default=0) + 10
    return max(
        (indent + width(said, Look.LABEL) if name else width(said, Look.SMALL) for name, said in entries),
        default=0.0,
    )


def _explained(entries: Sequence[Entry], left: float, wide: float, top: float) -> list[Text]:
    """The entries in columns, and the channels below them."""
    named = [item for item in entries if item[0]]
    columns = 1 if wide < 900 else 2 if wide < 1500 else 3
    each = wide / columns
    indent = max((width(name, Look.FIELD) for name, _ in named), default=0) + 10
    cells = [(name, fitted(said, max(120.0, each - indent - 20), SIZES[Look.LABEL])) for name, said in named]
    made: list[Text] = []
    lowest = top
    for number, column in enumerate(_columns([len(lines) for _, lines in cells], columns)):
        x, y = left + number * each, top
        for name, lines in (cells[place] for place in column):
            made.append(text(x, y, name, Look.FIELD))
            made += [text(x + indent, y + n * PITCH, line, Look.LABEL) for n, line in enumerate(lines)]
            y += len(lines) * PITCH
        lowest = max(lowest, y)
    for said in (said for name, said in entries if not name):
        lines = fitted(said, wide, SIZES[Look.SMALL])
        made += [text(left, lowest + 2 + n * PITCH, line, Look.SMALL) for n, line in enumerate(lines)]
    return made


def _columns(heights: Sequence[int], columns: int) -> list[range]:
    """Which entries stand in each column, so that the highest is as low as it can be."""
    low, high = max(heights, default=0), sum(heights)
    while low < high:
        middle = (low + high) // 2
        if len(_filled(heights, middle)) <= columns:
            high = middle
        else:
            low = middle + 1
    return _filled(heights, low)


def _filled(heights: Sequence[int], most: int) -> list[range]:
    """Columns that are at most so high."""
    found: list[range] = []
    start = used = 0
    for place, height in enumerate(heights):
        if used + height > most and place > start:
            found.append(range(start, place))
            start, used = place, 0
        used += height
    return [*found, range(start, len(heights))]


__all__ = ["Wanted", "layout", "scale", "texts_of"]
