"""Sheets of models that are drawn as tables instead of graphs."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Sheet
from aseme_dsl.diagrams.look.labels import Cell, table, table_lines


def table_sheet(name: str, box_id: str, rows: Sequence[Sequence[Cell]]) -> Sheet:
    """A drawing that is one table; `box_id` is its id in the SVG."""
    look = {"shape": "plain", "style": "", "margin": "0", "width": "0", "height": "0"}
    box = Box(box_id, look | {"label": table(rows, border=1, padding=5)}, table_lines(rows))
    return Sheet(name, (box,), (), style.GRAPH, style.NODE, style.EDGE)
