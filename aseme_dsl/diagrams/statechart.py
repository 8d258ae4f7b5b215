"""The nested drawing of a statechart: states inside states (P1, Figure 7; P2, Figure 2)."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from aseme_dsl.amola.statechart import Node, NodeType
from aseme_dsl.diagrams import legend, style
from aseme_dsl.diagrams.dot import Box, Group, Line, Sheet, cluster
from aseme_dsl.diagrams.drawing import Expressions
from aseme_dsl.diagrams.labels import Cell, table, table_lines, text_width
from aseme_dsl.diagrams.marks import (
    FILLS,
    NAME_WIDTH,
    Label,
    branch_mark,
    cells_label,
    class_of,
    closed_marks,
    name_lines,
    outside_mark,
    protocol_border,
    small,
    state_id,
    way_label,
)
from aseme_dsl.diagrams.tips import state_tip, way_tip
from aseme_dsl.diagrams.view import View, Way

_GAP = 22.0
"""About the distance between two rows of states, in points."""

_HEADER = 40.0
"""About the height that a composite adds to what is in it."""

_ASPECT = 1.6
"""How much wider than high the regions of an AND are arranged where they are free to be."""

_INLINE_WIDTH = 30


def sheet(
    view: View, name: str, links: Mapping[str, str] | None = None, *, expressions: Expressions
) -> Sheet:
    """The drawing of a view. `links` are the files that closed states lead to."""
    plan = _plan(view)
    numbers = legend.numbers(view) if expressions is Expressions.NUMBERED else {}
    inline_width = _INLINE_WIDTH if expressions is Expressions.INLINE else None
    labels = {way.place: way_label(numbers, way, inline_width) for way in view.ways}
    lines = _stacking(plan)
    for way in view.ways:
        lines += _lines(view, plan, way, labels[way.place])
    graph = style.GRAPH | {"compound": "true", "nodesep": "0.25", "ranksep": "0.34"}
    items = _items(view, labels, links or {})
    drawn = Sheet(name, items, _with_room(lines), graph, style.NODE, style.EDGE)
    return legend.below(drawn, legend.rows(view, expressions), plan.width)


# ---- where the states stand -----------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Plan:
    """The regions of each drawn AND in columns; the innermost states at top and bottom of each state.

    `width` is about how wide all of it will be, in points.
    """

    columns: Mapping[str, tuple[tuple[str, ...], ...]]
    first: Mapping[str, str]
    last: Mapping[str, str]
    width: float


def _plan(view: View) -> _Plan:
    size: dict[str, tuple[float, float]] = {}
    columns: dict[str, tuple[tuple[str, ...], ...]] = {}
    first: dict[str, str] = {}
    last: dict[str, str] = {}
    after = _successors(view)
    for node in reversed(view.states):
        label = node.label
        inside = [child.label for child in view.inside(label)]
        if not inside:
            size[label] = _leaf_size(node)
            first[label] = last[label] = label
        elif node.type is NodeType.AND:
            columns[label] = _columns(inside, size)
            wide = [max(size[region][0] for region in column) + 16 for column in columns[label]]
            high = [sum(size[region][1] + _GAP for region in column) for column in columns[label]]
            size[label] = (sum(wide), max(high) + _HEADER)
            middle = columns[label][(len(wide) - 1) // 2]
            highest = columns[label][high.index(max(high))]
            first[label], last[label] = first[middle[0]], last[highest[-1]]
        else:
            size[label] = _sequence_size(inside, after, size)
            start, end = view.chart.start_of(label), view.chart.end_of(label)
            first[label] = first[start.label if start else inside[0]]
            last[label] = last[end.label if end else inside[-1]]
    return _Plan(columns, first, last, size[view.top][0])


def _successors(view: View) -> Mapping[str, Sequence[str]]:
    after: dict[str, list[str]] = {}
    for way in view.ways:
        if not (way.source_outside or way.target_outside or way.is_back):
            after.setdefault(way.source, []).append(way.target)
    return after


def _leaf_size(node: Node) -> tuple[float, float]:
    if node.type in (NodeType.START, NodeType.END, NodeType.CONDITION):
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


def _stacking(plan: _Plan) -> list[Line]:
    """Invisible lines that hold the regions of a column under each other."""
    return [
        Line(state_id(plan.last[upper]), state_id(plan.first[lower]), attributes={"style": "invis"})
        for columns in plan.columns.values()
        for column in columns
        for upper, lower in pairwise(column)
    ]


# ---- states ---------------------------------------------------------------------------------------


def _items(view: View, labels: Mapping[int, Label], links: Mapping[str, str]) -> tuple[Box | Group, ...]:
    """The drawn states, each with the turning points of transitions that belong into it."""
    beside: dict[str | None, list[Box]] = {}
    for way in view.ways:
        if way.source_outside or way.target_outside:
            beside.setdefault(None, []).append(Box(*outside_mark(view, way, _turn(way))))
        elif outer := _outer(view, way):
            around = view.chart.node(outer).parent if outer != view.top else None
            beside.setdefault(around, []).append(_turning_point(view, way, labels[way.place]))
    made: dict[str, Box | Group] = {}
    for node in reversed(view.states):
        if inside := view.inside(node.label):
            children = (*(made[child.label] for child in inside), *beside.get(node.label, ()))
            made[node.label] = _group(view, node, children)
        else:
            made[node.label] = _leaf(view, node, links)
    return (made[view.top], *beside.get(None, ()))


def _leaf(view: View, node: Node, links: Mapping[str, str]) -> Box:
    common = class_of(node) | {"tooltip": state_tip(view, node)}
    match node.type:
        case NodeType.START:
            return Box(state_id(node.label), common | style.START_DOT)
        case NodeType.END:
            return Box(state_id(node.label), common | style.END_DOT)
        case NodeType.CONDITION:
            look = style.CONDITION_CIRCLE | protocol_border(view, node)
            return Box(state_id(node.label), common | look, ("c",))
    cells = [Cell(name_lines(node), align="CENTER")]
    closed, look = closed_marks(view, node, links)
    if closed and node.name != node.label:
        cells.append(small(node.label))
    label, lines = cells_label([*cells, *branch_mark(view, node), *closed])
    fill = {"fillcolor": FILLS[node.type]}
    return Box(state_id(node.label), common | fill | label | protocol_border(view, node) | look, lines)


def _group(view: View, node: Node, children: tuple[Box | Group, ...]) -> Group:
    is_region = node.label != view.top and view.chart.is_region(node.label)
    name, place = Cell(name_lines(node), align="CENTER"), small(node.label)
    marks = branch_mark(view, node)
    fill = FILLS[node.type]
    if node.name == node.label:
        rows, fill = [[place]], ""
    elif len(node.name) + len(node.label) <= NAME_WIDTH:
        rows = [[name, place]]
        marks = [replace(mark, columns=2) for mark in marks]
    else:
        rows = [[name], [place]]
    rows += [[mark] for mark in marks]
    attributes = class_of(node) | {
        "label": table(rows, cell_border=0, padding=1, fill=fill),
        "labelloc": "t",
        "labeljust": "l",
        "margin": "9",
        "peripheries": "1",
        "color": style.LINE,
        "fillcolor": style.PAPER,
        "style": "filled,dashed" if is_region else "filled,rounded",
        "tooltip": state_tip(view, node),
    }
    return Group(state_id(node.label), children, attributes | protocol_border(view, node), table_lines(rows))


# ---- transitions ----------------------------------------------------------------------------------


def _outer(view: View, way: Way) -> str | None:
    """The group that holds the other end of the transition, so that this has to turn outside of it."""
    if view.is_group(way.source) and view.holds(way.source, way.target):
        return way.source
    if view.is_group(way.target) and view.holds(way.target, way.source):
        return way.target
    return None


def _turn(way: Way) -> str:
    return f"{way.id}.turn"


def _turning_point(view: View, way: Way, label: Label) -> Box:
    """Where a transition turns outside a composite. It bears the label, so that this stays inside too."""
    attributes, lines = label
    tip = {"tooltip": way_tip(view, way), "class": "transition"}
    if not lines:
        # A bar rather than a point keeps the line off the border that it runs along.
        bar = {"shape": "box", "style": "filled", "label": "", "width": "0.2", "height": "0.01"}
        return Box(_turn(way), tip | bar | {"fixedsize": "true", "fillcolor": style.LINE})
    return Box(
        _turn(way), tip | attributes | {"shape": "plain", "style": "", "width": "0", "height": "0"}, lines
    )


def _lines(view: View, plan: _Plan, way: Way, label: Label) -> list[Line]:
    """The lines of a transition. They always run in document order; those that lead back are turned round.

    Graphviz breaks down over cycles between clusters, not over arrowheads at the other end.
    """
    tip = {"tooltip": way_tip(view, way), "class": "transition"}
    attributes, text = label
    own = tip | attributes

    def border(end: str, label: str) -> dict[str, str]:
        """The attribute that ends a line at the border of a composite."""
        return {end: cluster(state_id(label))} if view.is_group(label) else {}

    def first(label: str) -> str:
        return state_id(plan.first[label])

    def last(label: str) -> str:
        return state_id(plan.last[label])

    if way.target_outside:
        return [Line(last(way.source), _turn(way), way.id, own | border("ltail", way.source), text)]
    if way.source_outside:
        return [Line(_turn(way), first(way.target), way.id, own | border("lhead", way.target), text)]
    if outer := _outer(view, way):
        return _turning_lines(way, outer, tip, first, last, border)
    if way.source == way.target:
        return [Line(first(way.source), first(way.source), way.id, own, text)]
    upper, lower = (way.target, way.source) if way.is_back else (way.source, way.target)
    own |= border("ltail", upper) | border("lhead", lower)
    if way.is_back:
        own["dir"] = "back"
    return [Line(last(upper), first(lower), way.id, own, text)]


def _with_room(lines: Sequence[Line]) -> tuple[Line, ...]:
    """The lines, with room for the arrow above a composite, whose header would take it.

    As soon as one line has a label, Graphviz makes such room everywhere by itself.
    """
    if any("label" in line.attributes for line in lines):
        return tuple(lines)
    return tuple(
        replace(line, attributes={**line.attributes, "minlen": "2"})
        if "lhead" in line.attributes and "minlen" not in line.attributes
        else line
        for line in lines
    )


def _turning_lines(
    way: Way,
    outer: str,
    look: dict[str, str],
    first: Callable[[str], str],
    last: Callable[[str], str],
    border: Callable[[str, str], dict[str, str]],
) -> list[Line]:
    """The two lines of a transition between a composite and itself or a state inside it."""
    arrow, rest = look | {"weight": "0"}, look | {"weight": "0", "dir": "none"}
    from_outer = border("ltail", outer)
    turn, rest_id = _turn(way), f"{way.id}.rest"
    if way.target == outer:
        return [
            Line(first(outer), turn, way.id, arrow | from_outer | {"dir": "back"}),
            Line(turn, last(way.source), rest_id, rest | border("lhead", way.source) | {"minlen": "0"}),
        ]
    return [
        Line(first(outer), turn, rest_id, rest | from_outer),
        Line(turn, first(way.target), way.id, arrow | border("lhead", way.target)),
    ]
