"""Changes: what fixes several problems at once, and texts with it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from aseme_dsl.diagnostics.model import Diagnostic, Edit

UNSURE = frozenset(("W200",))
"""Codes whose fix is for people to decide: two names may be meant to be close."""


def choose(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Those whose changes do not overlap: of two that do, the first. All changes of one go together."""
    taken: dict[str, list[Edit]] = {}
    chosen = []
    for item in diagnostics:
        mine = by_file([item])
        if not any(
            _overlap(edit, other)
            for path, edits in mine.items()
            for edit in edits
            for other in taken.get(path, ())
        ):
            chosen.append(item)
            for path, edits in mine.items():
                taken.setdefault(path, []).extend(edits)
    return chosen


def by_file(diagnostics: Iterable[Diagnostic]) -> dict[str, list[Edit]]:
    """The changes of all, by the path of the file; several systems may have read it, each for itself."""
    names: dict[str, str] = {}
    found: dict[str, list[Edit]] = {}
    for item in diagnostics:
        for edit in item.changes:
            shown = edit.span.source.path
            found.setdefault(names.setdefault(os.path.realpath(shown), shown), []).append(edit)
    return found


def apply(text: str, edits: Sequence[Edit]) -> str:
    """The text with changes that do not overlap."""
    for edit in sorted(edits, key=lambda item: (item.span.start, item.span.end), reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


def _overlap(first: Edit, second: Edit) -> bool:
    a, b = first.span, second.span
    if a.start == a.end or b.start == b.end:
        return a.start <= b.end and b.start <= a.end
    return a.start < b.end and b.start < a.end


__all__ = ["UNSURE", "apply", "by_file", "choose"]
