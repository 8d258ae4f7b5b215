"""Found: the diagnostics that come with what phases make."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from typing import TypeVar

from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.records import dataclass

_T = TypeVar("_T")

With = tuple[_T, tuple[Diagnostic, ...]]
"""What a phase makes, and what is wrong with it."""

Stage = InPieces[With[_T]]
"""The same in pieces."""


@dataclass(slots=True)
class Found:
    """What is wrong so far; what was made is handed on."""

    diagnostics: list[Diagnostic] = field(default_factory=list)

    def keep(self, result: With[_T]) -> _T:
        """What was made, without its diagnostics, which are kept here."""
        self.diagnostics.extend(result[1])
        return result[0]

    def keep_all(self, results: Iterable[With[_T]]) -> list[_T]:
        return [self.keep(result) for result in results]

    def add(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics.extend(diagnostics)

    def of(self, made: _T) -> With[_T]:
        """What a stage made, with what is wrong with it."""
        return made, tuple(self.diagnostics)


__all__ = ["Found", "Stage", "With"]
