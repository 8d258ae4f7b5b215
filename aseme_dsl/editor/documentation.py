"""Documentation: what the comments beside a declaration say of it."""

from __future__ import annotations

import re
from collections.abc import Mapping

from aseme_dsl.editor.program import Program
from aseme_dsl.grammar import tree
from aseme_dsl.source import Span

_SECTION = re.compile(r"\s*[-=*#]{3,}.*")
"""A line that divides a file, and is about nothing in it."""


def documentation(program: Program, span: Span) -> str:
    """The comment lines right above the line of `span` (a whole one), or else the comment behind it there."""
    file = next((item for item in program.inspection.loaded.files if item.source is span.source), None)
    if file is None:
        return ""
    lines = _by_last_line(file)
    text: list[str] = []
    number = span.line - 1
    while number > 0 and number in lines and _stands_alone(lines[number]):
        comment = lines[number]
        said = _said(comment)
        if any(_SECTION.fullmatch(line) for line in said):
            break
        text[:0] = said
        number = comment.span.line - 1
    if not text and span.line in lines:
        comment = lines[span.line]
        if comment.span.start > span.start:
            text = _said(comment)
    return "\n".join(text).strip()


def _by_last_line(file: tree.File) -> Mapping[int, tree.Comment]:
    """The comments by the lines on which they end."""
    return {file.source.position(item.span.end)[0]: item for item in file.comments}


def _stands_alone(comment: tree.Comment) -> bool:
    source = comment.span.source
    return not source.line(comment.span.line)[: comment.span.column - 1].strip()


def _said(comment: tree.Comment) -> list[str]:
    """The lines of a comment without its marks."""
    if comment.text.startswith("//"):
        return [comment.text[2:].strip()]
    inner = comment.text[2:-2]
    return [line.strip().removeprefix("*").strip() for line in inner.split("\n")]
