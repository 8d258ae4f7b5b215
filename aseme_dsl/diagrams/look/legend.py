"""Legend: the numbers that stand for transition expressions in a drawing, and what they mean."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.expression import Named, value_text, values_of
from aseme_dsl.amola.statechart import State, StateType, transition_text
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Sheet
from aseme_dsl.diagrams.look.drawing import Expressions
from aseme_dsl.diagrams.look.labels import Cell, short, table, table_lines, wrapped
from aseme_dsl.diagrams.look.view import View, Way

_WIDTH = 92
"""Characters in a line of the legend."""

Rows = Sequence[Sequence[Cell]]


def numbers(view: View) -> Mapping[int, int]:
    """A number for each drawn transition with an expression, by its place; in the order they are tried."""
    order = {node.label: index for index, node in enumerate(view.chart.states)}
    ways = [way for way in view.ways if transition_text(way.transition)]
    ways.sort(key=lambda way: (order[way.transition.source], way.transition.priority, way.place))
    return {way.place: number for number, way in enumerate(ways, start=1)}


def meanings(view: View) -> Sequence[tuple[str, str]]:
    """Each `let` name used in the drawn transitions and what it stands for, in the order of first use.

    Roles and protocols have names of their own, so one name may be there twice with two meanings.
    """
    found: dict[tuple[str, str], None] = {}
    for way in view.ways:
        for value in values_of(way.transition.expression):
            if isinstance(value, Named):
                found.setdefault((value.name, value_text(value.expression)))
    return tuple(found)


def rows(view: View, expressions: Expressions) -> Rows:
    """The rows of the legend: number, transition, expression; then the `let` names."""
    found: list[list[Cell]] = []
    if expressions is Expressions.NONE:
        return found
    if expressions is Expressions.NUMBERED:
        ways = {way.place: way for way in view.ways}
        for place, number in numbers(view).items():
            text = transition_text(ways[place].transition)
            found.append(_row(str(number), _ends(view, ways[place]), text))
    for name, text in meanings(view):
        found.append(_row("", f"let {name}", f"= {text}"))
    return found


def below(sheet: Sheet, rows: Rows, width: float) -> Sheet:
    """The sheet with the legend under it, in as many blocks side by side as fit into `width` points."""
    if not rows:
        return sheet
    block = sum(max(_cell_width(row[column]) for row in rows) for column in range(3)) + 30
    blocks = max(1, min(len(rows) // 4, int(width // block)))
    height = -(-len(rows) // blocks)
    empty = [Cell(("",))] * 3
    joined: list[Sequence[Cell]] = [[Cell(("",), 3 * blocks, size=4)]]  # keeps a distance to the drawing
    joined += [
        [cell for start in range(0, len(rows), height) for cell in (*rows, *[empty] * height)[start + line]]
        for line in range(height)
    ]
    label = {"label": table(joined, cell_border=0, padding=2), "labelloc": "b", "labeljust": "l"}
    return replace(sheet, graph={**sheet.graph, **label}, lines=table_lines(joined))


def _cell_width(cell: Cell) -> float:
    return cell.width + 8


def _row(number: str, subject: str, text: str) -> list[Cell]:
    return [
        Cell((number,), bold=True, ink=style.NUMBER_COLOUR, align="RIGHT", size=style.SMALL_SIZE),
        Cell(wrapped(subject, 44), ink=style.PALE_INK, size=style.SMALL_SIZE),
        Cell(wrapped(text, _WIDTH), size=style.SMALL_SIZE),
    ]


def _ends(view: View, way: Way) -> str:
    """`decision: choice to ScanForBall`: the composite around it, and both ends."""
    chart = view.chart
    source, target = chart.node(way.transition.source), chart.node(way.transition.target)
    around = next((node for node in chart.ancestors(source.label) if node.name != node.label), None)
    scope = "" if around is None else f"{short(around.name, 24)}: "
    if not way.transition.changes_state:
        return f"{scope}{_end(source)}"
    if source is target and not way.transition.into:
        return f"{scope}{_end(source)} again"
    return f"{scope}{_end(source)} to {' and '.join(_end(chart.node(x)) for x in way.transition.targets)}"


def _end(node: State) -> str:
    kind = {StateType.START: "start", StateType.END: "end", StateType.CONDITION: "choice"}.get(node.type)
    return kind or short(node.name, 32)
