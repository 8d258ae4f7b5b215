"""Missing: what the analyst has not said yet, as a note with the text to start from and its place."""

from __future__ import annotations

from dataclasses import dataclass

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Missing:
    """A note (N7xx) with its skeleton: lines for the end of the block `inside`, or (None) of the note's file.

    A skeleton that could not stand there without being used is written as a comment.
    """

    note: Diagnostic
    skeleton: str
    inside: Span | None = None


__all__ = ["Missing"]
