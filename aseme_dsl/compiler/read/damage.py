"""Damage: where syntax errors left something out of the tree, so that what is missing there means nothing."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterable

from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.source import Source, Span

Damaged = Callable[[Span], bool]
"""Whether a declaration or block may lack parts of its source text, which could not be read."""


def damage(diagnostics: Iterable[Diagnostic]) -> Damaged:
    """The answer for what reading the files reported (E0xx and E1xx)."""
    places: dict[Source, list[int]] = {}
    for item in diagnostics:
        if item.span is not None and item.severity is Severity.ERROR:
            places.setdefault(item.span.source, []).append(item.span.start)
    if not places:
        return _undamaged
    for starts in places.values():
        starts.sort()

    def is_damaged(span: Span) -> bool:
        starts = places.get(span.source)
        if starts is None:
            return False
        index = bisect_left(starts, span.start)
        return index < len(starts) and starts[index] <= span.end

    return is_damaged


def _undamaged(span: Span) -> bool:
    """The answer of all files without errors: always this one, so that it can be seen to be the same."""
    return False


__all__ = ["Damaged", "damage"]
