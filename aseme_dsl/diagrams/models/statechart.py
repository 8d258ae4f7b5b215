"""The nested drawing of a statechart: states inside states (P1, Figure 7; P2, Figure 2)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import assert_never

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.diagrams.look import legend, style
from aseme_dsl.diagrams.look.dot import Box, Group, Line, Sheet, cluster
from aseme_dsl.diagrams.look.drawing import Expressions
from aseme_dsl.diagrams.look.labels import Cell, table, table_lines
from aseme_dsl.diagrams.look.marks import (
    FILLS,
    NAME_WIDTH,
    Label,
    Staying,
    branch_mark,
    cells_label,
    class_of,
    closed_marks,
    name_lines,
    outside_mark,
    protocol_border,
    small,
    state_id,
    staying,
    staying_marks,
    way_label,
    way_look,
)
from aseme_dsl.diagrams.look.tips import chart_about, state_tip, way_tip
from aseme_dsl.diagrams.look.view import View, Way
from aseme_dsl.diagrams.models.arrangement import Arrangement, arranged

_INLINE_WIDTH = 30

_POINT = {"shape": "point", "width": "0.02", "height": "0.02", "color": style.LINE}
"""Where a line bends."""

_BAR = {
    "shape": "box",
    "label": "",
    "style": "filled",
    "width": "0.35",
    "height": "0.05",
    "fillcolor": style.LINE,
    "color": style.LINE,
}
"""Where a line forks to several targets (UML's fork)."""


def sheet(
    view: View, name: str, links: Mapping[str, str] | None = None, *, expressions: Expressions
) -> Sheet:
    """The drawing of a view. `links` are the files that closed states lead to."""
    numbers = legend.numbers(view) if expressions is Expressions.NUMBERED else {}
    inline_width = _INLINE_WIDTH if expressions is Expressions.INLINE else None
    ways = [way for way in view.ways if way.transition.changes_state]
    stays = staying(view, numbers, inline_width)
    labels = {way.place: way_label(numbers, way, inline_width) for way in ways}
    # An arrow needs room above a composite, whose header would take it. As soon as one line has a label,
    # Graphviz makes such room everywhere by itself.
    labelled = any(labels[way.place][1] for way in ways if _outer(view, way) is None)
    arrangement = arranged(view, step=1 if labelled else 2)
    lines = _stacking(arrangement)
    for way in ways:
        lines += _lines(view, arrangement, way, labels[way.place])
    graph = style.GRAPH | {"compound": "true", "nodesep": "0.25", "ranksep": "0.34"}
    items = _items(view, ways, labels, stays, links or {})
    about = chart_about(view.chart)
    drawn = Sheet(name, items, tuple(lines), graph, style.NODE, style.EDGE, about=about)
    return legend.below(drawn, legend.rows(view, expressions), arrangement.width)


def _stacking(arrangement: Arrangement) -> list[Line]:
    """Invisible lines that hold the regions of a column under each other."""
    first, last = arrangement.first, arrangement.last
    return [
        Line(state_id(last[upper]), state_id(first[lower]), attributes={"style": "invis"})
        for columns in arrangement.columns.values()
        for column in columns
        for upper, lower in pairwise(column)
    ]


# ---- states ---------------------------------------------------------------------------------------


def _items(
    view: View, ways: Sequence[Way], labels: Mapping[int, Label], stays: Staying, links: Mapping[str, str]
) -> tuple[Box | Group, ...]:
    """The drawn states, each with the turning points of transitions that belong into it."""
    beside: dict[str | None, list[Box]] = {}
    drawn = {node.label for node in view.states}
    for way in ways:
        if way.source_outside or way.target_outside:
            beside.setdefault(None, []).append(Box(*outside_mark(view, way, _turn(way))))
        elif way.forks:
            scope = view.chart.scope_of(way.transition)
            tip = {"tooltip": way_tip(view, way), "class": "transition"}
            beside.setdefault(scope if scope in drawn else None, []).append(Box(_fork(way), tip | _BAR))
        elif outer := _outer(view, way):
            around = view.chart.node(outer).parent if outer != view.top else None
            points = beside.setdefault(around, [])
            points.append(_turning_point(view, way, labels[way.place]))
            if way.target == outer:
                points.append(Box(_corner(way), _POINT))
    made: dict[str, Box | Group] = {}
    for node in reversed(view.states):
        if inside := view.inside(node.label):
            children = (*(made[child.label] for child in inside), *beside.get(node.label, ()))
            made[node.label] = _group(view, node, children, stays)
        else:
            made[node.label] = _leaf(view, node, stays, links)
    return (made[view.top], *beside.get(None, ()))


def _leaf(view: View, node: State, stays: Staying, links: Mapping[str, str]) -> Box:
    common = class_of(node) | {"tooltip": state_tip(view, node)}
    match node.type:
        case StateType.START:
            return Box(state_id(node.label), common | style.START_DOT)
        case StateType.END:
            return Box(state_id(node.label), common | style.END_DOT)
        case StateType.CONDITION:
            look = style.CONDITION_CIRCLE | protocol_border(view, node)
            return Box(state_id(node.label), common | look, ("c",))
        case StateType.OR | StateType.AND | StateType.BASIC:
            return _titled(view, node, stays, links, common)
        case _:
            assert_never(node.type)


def _titled(view: View, node: State, stays: Staying, links: Mapping[str, str], common: dict[str, str]) -> Box:
    """The box of a state that has a name."""
    cells = [Cell(name_lines(node), align="CENTER")]
    closed, look = closed_marks(view, node, links)
    if closed and node.name != node.label:
        cells.append(small(node.label))
    label, lines = cells_label([*cells, *branch_mark(view, node), *staying_marks(node, stays), *closed])
    fill = {"fillcolor": FILLS[node.type]}
    return Box(state_id(node.label), common | fill | label | protocol_border(view, node) | look, lines)


def _group(view: View, node: State, children: tuple[Box | Group, ...], stays: Staying) -> Group:
    is_region = node.label != view.top and view.chart.is_region(node.label)
    name, place = Cell(name_lines(node), align="CENTER"), small(node.label)
    marks = [*branch_mark(view, node), *staying_marks(node, stays)]
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


def _fork(way: Way) -> str:
    return f"{way.id}.fork"


def _corner(way: Way) -> str:
    return f"{way.id}.corner"


def _turning_point(view: View, way: Way, label: Label) -> Box:
    """Where a transition turns outside a composite. It bears the label, so that this stays inside too."""
    attributes, lines = label
    tip = {"tooltip": way_tip(view, way), "class": "transition"}
    if not lines:
        return Box(_turn(way), tip | _POINT)
    return Box(
        _turn(way), tip | attributes | {"shape": "plain", "style": "", "width": "0", "height": "0"}, lines
    )


def _lines(view: View, arrangement: Arrangement, way: Way, label: Label) -> list[Line]:
    """The lines of a transition. They always run in document order; those that lead back are turned round.

    Graphviz breaks down over cycles between clusters, not over arrowheads at the other end.
    """
    tip = {"tooltip": way_tip(view, way), "class": "transition"} | way_look(way)
    attributes, text = label
    own = tip | attributes

    def border(end: str, label: str) -> dict[str, str]:
        """The attribute that ends a line at the border of a composite."""
        return {end: cluster(state_id(label))} if view.is_group(label) else {}

    def first(label: str) -> str:
        return state_id(arrangement.first[label])

    def last(label: str) -> str:
        return state_id(arrangement.last[label])

    if way.target_outside:
        return [Line(last(way.source), _turn(way), way.id, own | border("ltail", way.source), text)]
    if way.source_outside:
        return [Line(_turn(way), first(way.target), way.id, own | border("lhead", way.target), text)]
    if way.forks:
        return _forking_lines(view, way, tip, own, text, first, last, border)
    if outer := _outer(view, way):
        height = arrangement.rows[outer] if way.source == outer else 1
        return _turning_lines(way, outer, tip, first, last, border, height)
    if way.source == way.target:
        return [Line(first(way.source), first(way.source), way.id, own, text)]
    upper, lower = (way.target, way.source) if way.is_back else (way.source, way.target)
    own |= border("ltail", upper) | border("lhead", lower)
    if view.is_group(lower):
        own["minlen"] = str(arrangement.step)
    if way.is_back:
        own["dir"] = "back"
    return [Line(last(upper), first(lower), way.id, own, text)]


def _forking_lines(
    view: View,
    way: Way,
    look: dict[str, str],
    own: dict[str, str],
    text: tuple[str, ...],
    first: Callable[[str], str],
    last: Callable[[str], str],
    border: Callable[[str, str], dict[str, str]],
) -> list[Line]:
    """The lines of a transition into several regions: one to the bar where it forks, one to each target.

    Where the source is inside the target, or is it, the bar is below all of them; else it is between them.
    """
    bar, bare = _fork(way), own | {"dir": "none"}
    legs = [(way.leg(part), label) for part, label in enumerate(way.forks, start=1)]
    turned = look | {"dir": "back"}
    above = [Line(last(label), bar, leg, turned | border("ltail", label)) for leg, label in legs]
    if view.holds(way.target, way.source):
        return [Line(last(way.source), bar, way.id, bare | border("ltail", way.source), text), *above]
    if way.is_back:
        return [Line(bar, first(way.source), way.id, bare | border("lhead", way.source), text), *above]
    return [
        Line(last(way.source), bar, way.id, bare | border("ltail", way.source), text),
        *(Line(bar, first(label), leg, look | border("lhead", label)) for leg, label in legs),
    ]


def _turning_lines(
    way: Way,
    outer: str,
    look: dict[str, str],
    first: Callable[[str], str],
    last: Callable[[str], str],
    border: Callable[[str, str], dict[str, str]],
    height: int,
) -> list[Line]:
    """The lines of a transition between a composite and itself or a state inside it.

    One that comes back to the composite leaves it at the bottom, runs up beside it, and enters from the side.
    """
    arrow, rest = look | {"weight": "0"}, look | {"weight": "0", "dir": "none"}
    from_outer = border("ltail", outer)
    turn, rest_id = _turn(way), f"{way.id}.rest"
    if way.target == outer:
        corner, side = _corner(way), rest | {"weight": "1", "minlen": str(height)}
        return [
            Line(first(outer), corner, way.id, arrow | from_outer | {"dir": "back", "minlen": "0"}),
            Line(corner, turn, f"{way.id}.side", side),
            Line(turn, last(way.source), rest_id, rest | border("lhead", way.source) | {"minlen": "0"}),
        ]
    return [
        Line(first(outer), turn, rest_id, rest | from_outer),
        Line(turn, first(way.target), way.id, arrow | border("lhead", way.target)),
    ]
