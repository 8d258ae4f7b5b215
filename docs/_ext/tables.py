"""Tables for Sphinx, for pages that are made from what the package says of itself."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from docutils import nodes


def table(head: Sequence[str], rows: Iterable[Sequence[str]], widths: Sequence[int]) -> nodes.table:
    """A table; what stands in backquotes is code."""
    group = nodes.tgroup(cols=len(head))
    group += [nodes.colspec(colwidth=width) for width in widths]
    group += nodes.thead("", _row(head))
    group += nodes.tbody("", *(_row(cells) for cells in rows))
    return nodes.table("", group)


def _row(cells: Sequence[str]) -> nodes.row:
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *inline(cell))) for cell in cells))


def inline(text: str) -> list[nodes.Node]:
    """The nodes of a text with code in backquotes."""
    parts = re.split(r"`([^`]+)`", text)
    return [
        nodes.literal("", part) if odd % 2 else nodes.Text(part) for odd, part in enumerate(parts) if part
    ]
