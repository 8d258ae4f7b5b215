"""Tables: sheets of models that are drawn as tables instead of graphs, and the title above a graph."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Sheet
from aseme_dsl.diagrams.look.labels import Cell, table, table_lines

_PADDING = 6


def table_sheet(name: str, box_id: str, title: Cell, rows: Sequence[Sequence[Cell]], about: str) -> Sheet:
    """A drawing that is one table under its title; `box_id` is its id in the SVG."""
    columns = sum(cell.columns for cell in rows[-1]) if rows else 1
    ruled = [[replace(title, columns=columns, bold=True, size=style.TITLE_SIZE, sides="B")]]
    ruled += [[replace(cell, sides="B" if cell is row[0] else "BL") for cell in row] for row in rows]
    look = {"shape": "plain", "style": "", "margin": "0", "width": "0", "height": "0"}
    box = Box(box_id, look | {"label": table(ruled, padding=_PADDING)}, table_lines(ruled))
    return Sheet(name, (box,), (), style.GRAPH, style.NODE, style.EDGE, about=about)


def titled(sheet: Sheet, title: str, key: str) -> Sheet:
    """The sheet under a title, with a key to its lines below that."""
    cells = [
        Cell((title,), bold=True, size=style.TITLE_SIZE),
        Cell((key,), ink=style.PALE_INK, size=style.SMALL_SIZE),
    ]
    rows = [[cell] for cell in cells if cell.lines != ("",)]
    label = {"label": table(rows, cell_border=0, padding=2), "labelloc": "t", "labeljust": "l"}
    lines = table_lines(rows)
    return replace(
        sheet, graph={**sheet.graph, **label}, lines=lines, about=f"{title}; {key}" if key else title
    )


__all__ = ["table_sheet", "titled"]
