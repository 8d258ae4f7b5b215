"""Checker: where an expression is typed and what was found wrong with it so far."""

from __future__ import annotations

from dataclasses import dataclass, field

from aseme_dsl.amola.messages import DOUBLE, INT, Type
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.source import Span


@dataclass(slots=True)
class Checker:
    """State of typing one expression. A part that is wrong is None, and whoever uses it stays silent."""

    scope: Scope
    diagnostics: list[Diagnostic] = field(default_factory=list)

    def report(
        self,
        code: str,
        message: str,
        span: Span,
        hint: str | None = None,
        related: tuple[Related, ...] = (),
        fix: str | None = None,
    ) -> None:
        self.diagnostics.append(Diagnostic(code, message, span, related, hint, fix))


def is_number(kind: Type) -> bool:
    """An int or a double."""
    return kind in (INT, DOUBLE)


def a(kind: Type) -> str:
    """`a bool`, `an int`, `a PlayerState`."""
    return f"{'an' if str(kind)[:1] in 'aeiouAEIO' else 'a'} {kind}"
