"""Layout: the changes that lay a file, or some lines of it, out in the canonical way.

Each part between two blank lines at the margin is laid out alone, and remembered. While a file is edited,
only the changed parts are laid out again.
"""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher
from functools import lru_cache
from itertools import pairwise

from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.reading.reading import format_source
from aseme_dsl.grammar.parsing.parts import begins
from aseme_dsl.source import Source, Span


def layout(source: Source, first: int = 1, last: int | None = None) -> tuple[Edit, ...]:
    """`laying_out` in one go."""
    return finished(laying_out(source, first, last))


def laying_out(source: Source, first: int = 1, last: int | None = None) -> InPieces[tuple[Edit, ...]]:
    """What changes on the lines `first` to `last` (from 1) where the file is laid out.

    Nothing in a file with mistakes of syntax: it cannot be laid out.
    """
    text = source.text
    found: list[Edit] = []
    cuts = _cuts(text)
    for start, end in pairwise(cuts):
        laid = _laid_out(text[start:end])
        yield
        if laid is None:  # there is a mistake, or this was no place to cut
            whole = format_source(source)
            return tuple(_edits(source, 0, text, whole.text, first, last))
        wanted = laid if end == len(text) else laid + "\n"
        found += _edits(source, start, text[start:end], wanted, first, last)
    return tuple(found)


@lru_cache(maxsize=4096)
def _laid_out(text: str) -> str | None:
    """The canonical layout of some declarations; None if they have mistakes."""
    found = format_source(Source("<declarations>", text))
    return None if found.diagnostics else found.text


def _cuts(text: str) -> list[int]:
    """Where what is laid out alone begins and ends: behind a blank line before a declaration.

    Between that line and the declaration are at most comments, each on a line.
    """
    found = [0]
    begun = None if "\r" in text or "\ufeff" in text else begins(text)
    for start in (begun or ())[1:]:
        if text.startswith("language", start):
            continue  # it is allowed at the beginning only
        at, line = None, start
        while line > 0:
            above = text.rfind("\n", 0, line - 1) + 1
            said = text[above:line].strip()
            if said and not said.startswith("//"):
                if said.endswith("*/"):
                    at = None  # it may have begun anywhere
                break
            at, line = (line if not said else at), above
        if at is not None and at > found[-1] and line > 0:
            found.append(at)
    return [*found, len(text)]


def _edits(source: Source, base: int, old: str, new: str, first: int, last: int | None) -> list[Edit]:
    """What changes on some lines, of a piece of the file that begins at `base`."""
    if old == new:
        return []
    above = source.position(base)[0] - 1
    before, after = old.splitlines(keepends=True), new.splitlines(keepends=True)
    starts = [base]
    for line in before:
        starts.append(starts[-1] + len(line))
    last = above + len(before) if last is None else last
    return [
        Edit(Span(source, starts[begin], starts[end]), "".join(lines))
        for begin, end, lines in _changes(before, after)
        if above + begin < last and above + max(end, begin + 1) >= first
    ]


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
