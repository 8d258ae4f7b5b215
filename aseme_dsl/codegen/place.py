"""Places in the source, as generated files and traces show them."""

from __future__ import annotations

from pathlib import PurePath

from aseme_dsl.source import Span


def in_docstring(text: str) -> str:
    """A text of the user's, such as a file's name, as it can stand between three double quotes."""
    return text.replace("\\", "\\\\").replace('"', '\\"')


def place(span: Span | None) -> str:
    """`team.aseme:12:5`: the file's name without its folder, so that the same input gives the same bytes."""
    if span is None:
        return ""
    line, column = span.source.position(span.start)
    return f"{PurePath(span.source.path).name}:{line}:{column}"
