"""Layout: the page of a compact drawing: title, modules, the chart, and what explains its words below."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.blocks import Group, Parallel, blocks
from aseme_dsl.diagrams.compact.elements import Look, Picture, Shape, Text
from aseme_dsl.diagrams.compact.endings import Endings
from aseme_dsl.diagrams.compact.parts import Placer, Rim
from aseme_dsl.diagrams.compact.pen import PITCH, Placed, Room, text
from aseme_dsl.diagrams.compact.plan import Plan
from aseme_dsl.diagrams.compact.words import Words, width
from aseme_dsl.diagrams.look.labels import wrapped

_MARGIN = 14

_WIDTHS = (152, 190, 132, 116, 100)
"""How wide labels are; the next is tried for an outermost region that is wider than wanted."""

_SLACK = 100
"""How much of the width the borders around a line that turns back may take, in px."""

_GAIN = 0.9
"""Narrow labels are worth it where a region is at most so much of its usual width."""

_LEAST = 560
"""How wide a page is at least, so that the texts below have room."""


_BESIDE = 300
"""So much room beside the chart is enough for the texts that have none below, in px."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is to be drawn: the OR `top`, with the composites `closed` closed, if it can be in the `size`.

    On a `page` of this size, the texts below take all of its width, or stand beside the chart.
    """

    top: str
    closed: frozenset[str] = frozenset()
    size: tuple[float, float] = (1920, 1080)
    page: bool = False


def layout(chart: Statechart, activities: Iterable[Activity] = (), wanted: Wanted | None = None) -> Picture:
    """The compact drawing of a chart, or of a part of it. Raises NotCompact."""
    wanted = wanted or Wanted(chart.root.label)
    root = blocks(chart, wanted.top, wanted.closed)
    endings, first = Endings(chart), Words(chart, tuple(activities))
    limit = wanted.size[0] - 4 * _MARGIN

    def drawn(
        wide: float, chosen: Mapping[str, float], limits: Mapping[str, float]
    ) -> tuple[Picture, Mapping[str, float]]:
        words = first.anew()
        placer = Placer(chart, words, Plan(chart, words, endings), wide, chosen, limits)
        return _page(chart, root, words, placer, wanted), placer.widths

    measured: list[tuple[float, Mapping[str, float]]] = []
    for wide in _WIDTHS:
        picture, widths = drawn(wide, {}, {})
        measured.append((wide, widths))
        if all(width <= limit for width in widths.values()):
            break
    if len(measured) == 1:
        return picture
    chosen = {label: _best(label, measured, limit) for label in widths}
    fit = {label for label in widths if any(found[label] <= limit for _, found in measured)}
    return drawn(_WIDTHS[0], chosen, dict.fromkeys(widths.keys() - fit, limit - _SLACK))[0]


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


def scale(picture: Picture, size: tuple[float, float]) -> float:
    """How large the drawing is where there is room of a size; 1 if it fits."""
    return min(1.0, size[0] / picture.width, size[1] / picture.height)


def _page(chart: Statechart, root: Group, words: Words, placer: Placer, wanted: Wanted) -> Picture:
    plan = placer.plan
    field = _root(chart, plan, placer, root, words)
    room = Room()
    part = plan.heading(wanted.top)[0] if wanted.top != chart.root.label else ""
    title = " · ".join(filter(None, (chart.name, part)))
    states, transitions = len(chart.states), len(chart.transitions)
    about = f"{chart.kind} of {chart.system}: {states} states, {transitions} transitions"
    about = f"a part of the {about}" if part else about
    room.add(text(_MARGIN, _MARGIN + 14, title, Look.TITLE))
    room.add(text(_MARGIN + width(title, Look.TITLE) + 12, _MARGIN + 14, about, Look.SMALL))
    top = _MARGIN + 28.0
    if chart.modules and not part:
        room.add(*_modules(chart, top))
        top += 24
    room.put(field, top + field.up, _MARGIN)
    right = max(room.right, _LEAST)
    below = room.down + 20
    broad = wanted.size[0] - _MARGIN if wanted.page else right
    explained = _explained(chart, words, _MARGIN, broad - _MARGIN, below)
    lowest = max((item.y for texts in explained for item in texts), default=0.0)
    beside = wanted.size[0] - room.right - 2 * _MARGIN
    if wanted.page and lowest + 2 * _MARGIN > wanted.size[1] and beside > _BESIDE:
        explained = _explained(chart, words, room.right + _MARGIN, beside, top)
    for texts in explained:
        room.add(*texts)
    return Picture(
        round(max(right, room.right) + _MARGIN, 1),
        round(room.down + _MARGIN, 1),
        tuple(room.elements),
        wanted.top,
        tuple(placer.copies),
        tuple(words.notes),
    )


def _root(chart: Statechart, plan: Plan, placer: Placer, root: Group, words: Words) -> Placed:
    """The outermost region: an AND that never ends needs no line to it."""
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


def _explained(chart: Statechart, words: Words, left: float, wide: float, top: float) -> list[list[Text]]:
    """What each name of a `let`, each number and each short name of a channel stands for, in columns."""
    entries = [(name, f"= {said}") for name, said in words.lets().items()]
    entries += [(f"({number})", said) for number, said in enumerate(map(words.text, words.notes), 1)]
    columns = 1 if wide < 900 else 2 if wide < 1500 else 3
    each = wide / columns
    indent = max((width(name, Look.FIELD) for name, _ in entries), default=0) + 10
    cells = [(name, wrapped(said, max(20, int((each - indent - 20) / 5.9)))) for name, said in entries]
    total = sum(len(lines) for _, lines in cells)
    made: list[list[Text]] = []
    x, y, most = left, top, -(-total // columns)
    used, lowest = 0, top
    for name, lines in cells:
        if used and used + len(lines) > most and x - left + each < wide - 1:
            x, y, used = x + each, top, 0
        made.append([text(x, y, name, Look.FIELD)])
        made.append([text(x + indent, y + row * PITCH, line, Look.LABEL) for row, line in enumerate(lines)])
        y += len(lines) * PITCH
        used += len(lines)
        lowest = max(lowest, y)
    short = ", ".join(f"{name} = {full}" for name, full in words.short_channels().items())
    said = [f"channels: {short}"] if short else []
    for paragraph in said:
        for line in wrapped(paragraph, max(40, int(wide / 5.4))):
            made.append([text(left, lowest + 2, line, Look.SMALL)])
            lowest += PITCH
    return made


__all__ = ["Wanted", "layout", "scale"]
