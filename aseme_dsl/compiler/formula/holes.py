"""Holes: operators (`A ? B`) and conditions (`[?]`) that are still to be chosen (E109).

A hole leaves nothing out of the tree, so it hides nothing that other declarations need. No chart is made of
a formula or a control line with one, and no system of a file: what would be executed is not decided.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.diagnostics.problems.syntax.entries import Hole


def apart_from_holes(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics without those of holes."""
    return tuple(item for item in diagnostics if not isinstance(item.problem, Hole))


def as_notes(diagnostics: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """The diagnostics for commands that generate no code: a hole is then a note, not an error."""
    return tuple(
        replace(item, level=Severity.NOTE) if isinstance(item.problem, Hole) else item for item in diagnostics
    )


__all__ = ["apart_from_holes", "as_notes"]
