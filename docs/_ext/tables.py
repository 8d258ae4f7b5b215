"""Tables for Sphinx, for pages that are made from what the package says of itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from docutils import nodes

Cell = str | nodes.Node
"""A text, in which what stands in backquotes is code, or what docutils shows."""


def table(head: Sequence[Cell], rows: Iterable[Sequence[Cell]], widths: Sequence[int]) -> nodes.table:
    """A table."""
    group = nodes.tgroup(cols=len(head))
    group += [nodes.colspec(colwidth=width) for width in widths]
    group += nodes.thead("", _row(head))
    group += nodes.tbody("", *(_row(cells) for cells in rows))
    return nodes.table("", group)


def _row(cells: Sequence[Cell]) -> nodes.row:
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *_shown(cell))) for cell in cells))


def _shown(cell: Cell) -> list[nodes.Node]:
    return inline(cell) if isinstance(cell, str) else [cell]


def inline(text: str) -> list[nodes.Node]:
    """The nodes of a text with code in backquotes."""
    parts = re.split(r"`([^`]+)`", text)
    return [
        nodes.literal("", part) if odd % 2 else nodes.Text(part) for odd, part in enumerate(parts) if part
    ]
