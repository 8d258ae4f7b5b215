"""Worded: a problem of any code that says what a test wants it to say, for tests of what shows problems."""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.diagnostics import Diagnostic, Edit, Problem, Related, Severity
from aseme_dsl.source import Span


class Worded(Problem):
    """Its `code` is a field: so it is not a class of a code."""

    code: str  # type: ignore[misc]
    text: str
    advice: str | None = None

    @property
    def message(self) -> str:
        return self.text

    @property
    def hint(self) -> str | None:
        return self.advice


def worded(
    code: str,
    message: str,
    span: Span | None,
    related: tuple[Related, ...] = (),
    hint: str | None = None,
    fix: str | None = None,
    path: str | None = None,
    edits: tuple[Edit, ...] = (),
    level: Severity | None = None,
) -> Diagnostic:
    """A diagnostic that says `message`."""
    return Diagnostic(Worded(code, message, hint), span, related, fix, path, edits, level)


def reworded(item: Diagnostic, message: str) -> Diagnostic:
    """The diagnostic with another message."""
    return replace(item, problem=Worded(item.code, message, item.hint))
