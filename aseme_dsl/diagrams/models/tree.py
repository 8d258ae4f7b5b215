"""The labelled tree of a statechart: every state joined to the one around it (P1, Figure 5)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from aseme_dsl.amola.statechart import State, transition_text
from aseme_dsl.diagrams.look import legend, style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.drawing import Expressions
from aseme_dsl.diagrams.look.labels import Cell, short, wrapped
from aseme_dsl.diagrams.look.marks import (
    FILLS,
    Staying,
    branch_mark,
    cells_label,
    class_of,
    closed_marks,
    name_lines,
    number_label,
    outside_mark,
    protocol_border,
    small,
    state_id,
    staying,
    staying_marks,
    way_look,
)
from aseme_dsl.diagrams.look.tips import chart_about, state_tip, way_tip
from aseme_dsl.diagrams.look.view import View, Way

_FEW_LEAVES = 14
"""Up to so many leaves the tree grows downwards as in the paper, else to the right, which is less wide."""

_NAME_WIDTH = 26
_INLINE_WIDTH = 40


def sheet(
    view: View, name: str, links: Mapping[str, str] | None = None, *, expressions: Expressions
) -> Sheet:
    """The drawing of a view. `links` are the files that closed states lead to."""
    numbers = legend.numbers(view) if expressions is Expressions.NUMBERED else {}
    inline = expressions is Expressions.INLINE
    stays = {} if inline else staying(view, numbers, None)
    boxes = [_box(view, node, stays, links or {}, inline=inline) for node in view.states]
    boxes += [
        Box(*outside_mark(view, way, _outside_id(way)))
        for way in view.ways
        if way.source_outside or way.target_outside
    ]
    parents = [_parent_line(node) for node in view.states if node.label != view.top]
    ways = [
        line
        for way in view.ways
        if way.transition.changes_state
        for line in _way_lines(view, way, numbers.get(way.place))
    ]
    leaves = sum(not view.is_group(node.label) for node in view.states)
    downwards = leaves <= _FEW_LEAVES
    graph = style.GRAPH | {
        "rankdir": "TB" if downwards else "LR",
        "ordering": "out",
        "nodesep": "0.3" if downwards else "0.24",
        "ranksep": "0.4" if downwards else "0.5",
    }
    rows = legend.rows(view, expressions)
    about = chart_about(view.chart)
    drawn = Sheet(name, tuple(boxes), (*parents, *ways), graph, style.NODE, style.EDGE, about=about)
    return legend.below(drawn, rows, width=90.0 * (leaves if downwards else view.chart.levels))


def _box(view: View, node: State, stays: Staying, links: Mapping[str, str], *, inline: bool) -> Box:
    closed, look = closed_marks(view, node, links)
    if node.name == node.label:
        cells = [Cell((node.label,), size=style.SMALL_SIZE, align="CENTER"), small(node.type.value)]
    else:
        cells = [
            Cell(name_lines(node, _NAME_WIDTH), align="CENTER"),
            small(f"{node.type.value} {node.label}"),
        ]
    expressions = _expressions(view, node) if inline else []
    label, lines = cells_label(
        [*cells, *branch_mark(view, node), *staying_marks(node, stays), *closed, *expressions]
    )
    fill = {"fillcolor": FILLS.get(node.type, style.PAPER), "margin": "0.05,0.02"}
    tip = {"tooltip": state_tip(view, node)}
    return Box(
        state_id(node.label), class_of(node) | fill | label | protocol_border(view, node) | look | tip, lines
    )


def _expressions(view: View, node: State) -> list[Cell]:
    """The expressions of a state's transitions: between the boxes there is no room for them."""
    cells = []
    for transition in (
        *view.chart.outgoing(node.label),
        *view.chart.exits_of(node.label),
        *view.chart.abandons.get(node.label, ()),
    ):
        if text := transition_text(transition):
            names = [short(view.chart.node(label).name, _NAME_WIDTH) for label in transition.targets]
            where = f"to {' and '.join(names)}: " if transition.changes_state else ""
            lines = wrapped(f"{where}{text}", _INLINE_WIDTH)
            cells.append(Cell(lines, size=style.SMALL_SIZE))
    return cells


def _parent_line(node: State) -> Line:
    assert node.parent is not None
    look = {"color": style.PARENT_COLOUR, "dir": "none", "weight": "2", "class": "parent"}
    return Line(state_id(node.parent), state_id(node.label), f"p{node.label}", look)


def _way_lines(view: View, way: Way, number: int | None) -> Iterator[Line]:
    """The lines of a transition: one to each of its targets."""
    if not way.forks:
        yield _way_line(view, way, number)
    for part, label in enumerate(way.forks):
        yield _way_line(view, replace(way, target=label, part=part), number)


def _way_line(view: View, way: Way, number: int | None) -> Line:
    """A line of a transition. Its number is at the arrowhead: Graphviz fails over labels between siblings."""
    source = _outside_id(way) if way.source_outside else state_id(way.source)
    target = _outside_id(way) if way.target_outside else state_id(way.target)
    look = {
        "color": style.TRANSITION_COLOUR,
        "class": "transition",
        "tooltip": way_tip(view, way),
        "constraint": "false",  # the tree alone decides where the states stand
    }
    look |= way_look(way)
    if way.is_back:
        look["dir"] = "back"
    if number is not None:
        end = "taillabel" if way.is_back else "headlabel"
        look |= {end: number_label(number), "labelangle": "-60", "labeldistance": "1.4"}
    upper, lower = (target, source) if way.is_back else (source, target)
    return Line(upper, lower, way.id, look, () if number is None else (str(number),))


def _outside_id(way: Way) -> str:
    return f"{way.id}.outside"
