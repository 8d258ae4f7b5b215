"""Checker: where an expression is typed and what was found wrong with it so far."""

from __future__ import annotations

from dataclasses import field

from aseme_dsl.amola.messages import DOUBLE, INT, Type
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.diagnostics import Diagnostic, Problem, Related
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(slots=True)
class Checker:
    """State of typing one expression. A wrong part is None, and causes no further diagnostic."""

    scope: Scope
    diagnostics: list[Diagnostic] = field(default_factory=list)

    def report(
        self, problem: Problem, span: Span, related: tuple[Related, ...] = (), fix: str | None = None
    ) -> None:
        self.diagnostics.append(Diagnostic(problem, span, related, fix))


def is_number(kind: Type) -> bool:
    """An int or a double."""
    return kind in (INT, DOUBLE)
