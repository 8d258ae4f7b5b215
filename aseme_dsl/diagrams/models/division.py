"""Division: a statechart that is too much for one picture, in pieces with an index."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.drawing import Drawing, of_sheet, piece_name
from aseme_dsl.diagrams.look.labels import Cell
from aseme_dsl.diagrams.look.marks import FILLS, cells_label, name_lines, small, state_id
from aseme_dsl.diagrams.look.view import View, view

PIECE = 80
"""A piece has at most so many states, if its own OR state alone has not more."""

Drawer = Callable[[View, str, Mapping[str, str]], Sheet]
"""Draws a view under a name, with the files that its closed states lead to."""


def pieces(whole: View, name: str, draw: Drawer, most: int = PIECE) -> tuple[Drawing, ...]:
    """The view, divided into several drawings. The first one is the index, and has the name of the view.

    The others are named after their outermost state (`iac.player.0.2.5`) and have at most `most` states. If
    Graphviz cannot draw one of these, it is divided again: one drawing for each OR state.
    """
    parts = _parts(whole, name, draw, most)
    return (of_sheet(_index(whole, name, parts)), *(drawing for _, drawing in parts))


def _parts(whole: View, name: str, draw: Drawer, most: int) -> list[tuple[View, Drawing]]:
    """The piece that each view is drawn in."""
    cuts = frozenset(_cuts(whole, most)) | {whole.top}
    files = {label: f"{piece_name(name, label)}.svg" for label in cuts}
    parts = []
    for label in (node.label for node in whole.states if node.label in cuts):
        part = view(whole.chart, at=label, closed=(frozenset(whole.closed) | cuts) - {label})
        smaller = partial(_flat, part, name, draw) if most > 1 else None
        sheet = draw(part, piece_name(name, label), files)
        parts.append((part, of_sheet(sheet, states=len(part.states), pieces=smaller)))
    return parts


def _flat(part: View, name: str, draw: Drawer) -> tuple[Drawing, ...]:
    return tuple(drawing for _, drawing in _parts(part, name, draw, most=1))


def _cuts(whole: View, most: int) -> list[str]:
    """The composites to draw by themselves: the largest ones of each state that is too large with them."""
    size: dict[str, int] = {}
    cuts: list[str] = []
    for node in reversed(whole.states):
        inside = whole.inside(node.label)
        total = 1 + sum(size[child.label] for child in inside)
        for child in sorted(inside, key=lambda child: -size[child.label]):
            if total <= most or size[child.label] == 1:
                break
            cuts.append(child.label)
            total -= size[child.label] - 1
        size[node.label] = total
    return cuts


def _index(whole: View, name: str, parts: list[tuple[View, Drawing]]) -> Sheet:
    """A tree of the pieces, each with the state it begins with and the file it is in."""
    tops = {part.top for part, _ in parts}
    boxes, lines = [], []
    for part, drawing in parts:
        node = whole.chart.node(part.top)
        cells = [Cell(name_lines(node), align="CENTER")]
        if node.name != node.label:
            cells.append(small(f"{node.type.value} {node.label}"))
        cells += [small(f"{len(part.states)} states"), small(f"{drawing.name}.svg", style.NUMBER_COLOUR)]
        label, text = cells_label(cells)
        look = {"fillcolor": FILLS.get(node.type, style.PAPER), "URL": f"{drawing.name}.svg"}
        boxes.append(Box(state_id(part.top), look | label, text))
        around = next((outer.label for outer in whole.chart.ancestors(part.top) if outer.label in tops), None)
        if around is not None and part.top != whole.top:
            lines.append(Line(state_id(around), state_id(part.top), f"p{part.top}"))
    title = f"{name} in {len(parts)} drawings"
    graph = style.GRAPH | {
        "rankdir": "LR",
        "ordering": "out",
        "nodesep": "0.15",
        "labelloc": "t",
        "label": title,
    }
    return Sheet(name, tuple(boxes), tuple(lines), graph, style.NODE, style.EDGE, (title,), title)
