"""Comments: what is said of a declaration above it, or behind it on its line."""

from __future__ import annotations

from bisect import bisect_left

from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

_RULER = frozenset("-=*#/ ")


def documentation(file: tree.File, span: Span) -> str:
    """The comment lines right above what stands at `span`, and the comment behind it; "" without any."""
    text = file.source.text
    starts = _starts(file)
    line = text.rfind("\n", 0, span.start) + 1
    before = bisect_left(starts, line)
    above: list[str] = []
    reached = line
    while before > 0:
        comment = file.comments[before - 1].span
        begin = text.rfind("\n", 0, comment.start) + 1
        if text[comment.end : reached].strip(" \t\r") != "\n" or text[begin : comment.start].strip():
            break
        above.insert(0, _said(comment.text))
        reached = begin
        before -= 1
    stop = text.find("\n", span.end)
    stop = stop if stop >= 0 else len(text)
    behind = bisect_left(starts, span.end)
    if behind < len(starts) and starts[behind] < stop:
        above.append(_said(file.comments[behind].span.text))
    return "\n".join(said for said in above if said).strip()


def _starts(file: tree.File) -> list[int]:
    return [item.span.start for item in file.comments]


def _said(comment: str) -> str:
    """A comment without its marks; a ruler, or a heading in one, says nothing of what follows."""
    if comment.startswith("/*"):
        comment = comment[2:].removesuffix("*/")
        lines = [line.strip().removeprefix("*").strip() for line in comment.split("\n")]
        return "\n".join(lines).strip()
    said = comment[2:].strip()
    return "" if said.startswith(("----", "====", "asemec:")) or not set(said) - _RULER else said


__all__ = ["documentation"]
