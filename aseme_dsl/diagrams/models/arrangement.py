"""Arrangement: where the states of a nested drawing should stand, as far as Graphviz has to be told."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.labels import text_width
from aseme_dsl.diagrams.look.marks import name_lines
from aseme_dsl.diagrams.look.view import View
from aseme_dsl.records import dataclass

_GAP = 22.0
"""About the distance between two rows of states, in points."""

_HEADER = 40.0
"""About the height that a composite adds to what is in it."""

_ASPECT = 1.6
"""How much wider than high the regions of an AND are arranged where they are free to be."""


@dataclass(frozen=True, slots=True)
class Arrangement:
    """The places of states, as far as the lines of a drawing depend on them. Keys are labels of states.

    - `columns`: the regions of each drawn AND, by column.
    - `first`, `last`: the innermost states at the top and at the bottom of each state.
    - `rows`: the number of rows between these two.
    - `step`: the number of rows that a transition into a composite takes.
    - `width`: the approximate width of the drawing, in points.
    """

    columns: Mapping[str, tuple[tuple[str, ...], ...]]
    first: Mapping[str, str]
    last: Mapping[str, str]
    rows: Mapping[str, int]
    step: int
    width: float


def arranged(view: View, step: int) -> Arrangement:
    """The arrangement of a view, from the inside outwards."""
    size: dict[str, tuple[float, float]] = {}
    columns: dict[str, tuple[tuple[str, ...], ...]] = {}
    first: dict[str, str] = {}
    last: dict[str, str] = {}
    rows: dict[str, int] = {}
    after = _successors(view)
    for node in reversed(view.states):
        label = node.label
        inside = [child.label for child in view.inside(label)]
        if not inside:
            size[label] = _leaf_size(node)
            first[label] = last[label] = label
            rows[label] = 0
        elif node.type is StateType.AND:
            columns[label] = _columns(inside, size)
            wide = [max(size[region][0] for region in column) + 16 for column in columns[label]]
            high = [sum(size[region][1] + _GAP for region in column) for column in columns[label]]
            size[label] = (sum(wide), max(high) + _HEADER)
            middle = columns[label][(len(wide) - 1) // 2]
            highest = columns[label][high.index(max(high))]
            first[label], last[label] = first[middle[0]], last[highest[-1]]
            rows[label] = sum(rows[region] + 1 for region in highest) - 1
        else:
            size[label] = _sequence_size(inside, after, size)
            start, end = view.chart.start_of(label), view.chart.end_of(label)
            bottom = end.label if end else inside[-1]
            first[label] = first[start.label if start else inside[0]]
            last[label] = last[bottom]
            rows[label] = _row(inside, bottom, after, rows, step) + rows[bottom]
    return Arrangement(columns, first, last, rows, step, size[view.top][0])


def _row(
    inside: Sequence[str], bottom: str, after: Mapping[str, Sequence[str]], rows: Mapping[str, int], step: int
) -> int:
    """In which row of a composite its state `bottom` begins: below all that lead to it."""
    row = dict.fromkeys(inside, 0)
    for label in inside:
        for target in after.get(label, ()):
            if target in row and target != label:
                below = row[label] + rows[label] + (step if rows[target] else 1)
                row[target] = max(row[target], below)
    return row[bottom]


def _successors(view: View) -> Mapping[str, Sequence[str]]:
    after: dict[str, list[str]] = {}
    for way in view.ways:
        if not (way.source_outside or way.target_outside or way.is_back):
            after.setdefault(way.source, []).append(way.target)
    return after


def _leaf_size(node: State) -> tuple[float, float]:
    if node.type in (StateType.START, StateType.END, StateType.CONDITION):
        return 16.0, 16.0
    lines = name_lines(node)
    return max(text_width(line, style.TEXT_SIZE) for line in lines) + 20, 14.0 + 15.0 * len(lines)


def _sequence_size(
    inside: Sequence[str], after: Mapping[str, Sequence[str]], size: Mapping[str, tuple[float, float]]
) -> tuple[float, float]:
    """The size of an OR: its states in rows, each below all that lead to it."""
    row = dict.fromkeys(inside, 0)
    for label in inside:
        for target in after.get(label, ()):
            if target in row and target != label:
                row[target] = max(row[target], row[label] + 1)
    wide: dict[int, float] = {}
    high: dict[int, float] = {}
    for label in inside:
        wide[row[label]] = wide.get(row[label], 0.0) + size[label][0] + 18
        high[row[label]] = max(high.get(row[label], 0.0), size[label][1])
    return max(wide.values()) + 16, sum(high.values()) + _GAP * len(high) + _HEADER


def _columns(regions: Sequence[str], size: Mapping[str, tuple[float, float]]) -> tuple[tuple[str, ...], ...]:
    """The regions in columns, in their order: small ones under each other beside a large one.

    No column is higher than the highest region, unless the regions together would be too wide.
    """
    area = sum(size[label][0] * size[label][1] for label in regions)
    limit = max(*(size[label][1] for label in regions), math.sqrt(area / _ASPECT))
    columns: list[list[str]] = []
    height = math.inf
    for label in regions:
        if height + _GAP + size[label][1] > limit:
            columns.append([])
            height = -_GAP
        columns[-1].append(label)
        height += _GAP + size[label][1]
    return tuple(map(tuple, columns))
