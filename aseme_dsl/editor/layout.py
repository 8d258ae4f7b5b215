"""Layout: the changes that lay a file, or some lines of it, out in the canonical way."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher

from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.reading import format_source
from aseme_dsl.source import Source, Span


def layout(source: Source, first: int = 1, last: int | None = None) -> tuple[Edit, ...]:
    """What changes on the lines `first` to `last` (from 1) where the file is laid out.

    Nothing in a file with mistakes of syntax: it cannot be laid out.
    """
    text = format_source(source).text
    if text == source.text:
        return ()
    before, after = source.text.splitlines(keepends=True), text.splitlines(keepends=True)
    starts = [0]
    for line in before:
        starts.append(starts[-1] + len(line))
    last = len(before) if last is None else last
    return tuple(
        Edit(Span(source, starts[begin], starts[end]), "".join(lines))
        for begin, end, lines in _changes(before, after)
        if begin < last and max(end, begin + 1) >= first
    )


_LONGEST = 3000
"""Lines that are compared one by one; more of them are replaced as a whole."""


def _changes(before: Sequence[str], after: Sequence[str]) -> list[tuple[int, int, Sequence[str]]]:
    """Which lines are replaced by which."""
    start = 0
    while start < min(len(before), len(after)) and before[start] == after[start]:
        start += 1
    end = 0
    while end < min(len(before), len(after)) - start and before[-1 - end] == after[-1 - end]:
        end += 1
    old, new = before[start : len(before) - end], after[start : len(after) - end]
    if max(len(old), len(new)) > _LONGEST:
        return [(start, start + len(old), new)]
    return [
        (start + a, start + b, new[c:d])
        for tag, a, b, c, d in SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
        if tag != "equal"
    ]
