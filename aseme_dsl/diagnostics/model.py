"""Diagnostic: one problem in a document, as data."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from aseme_dsl.diagnostics.codes import CODES, GROUPS, Code
from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class Severity(StrEnum):
    """How bad it is: an error stops generation, a warning does not, a note is something still to be said."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Related:
    """Another place that explains a problem."""

    span: Span
    message: str


@dataclass(frozen=True, slots=True)
class Edit:
    """A change of a text: `text` instead of what the span has; an empty span is a place to insert at."""

    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """A problem, its place, and the edits that fix it.

    `span` is None only for problems that are in no text (a file that cannot be read); then `path` says
    which file is meant. `fix` is the replacement of the span's text where there is one right answer; an
    answer that is elsewhere, or in several places, is in `edits` instead. `level` is the severity that a
    project's policy has given it, None where it has said nothing.
    """

    problem: Problem
    span: Span | None
    related: tuple[Related, ...] = ()
    fix: str | None = None
    path: str | None = None
    edits: tuple[Edit, ...] = ()
    level: Severity | None = None

    def __post_init__(self) -> None:
        if self.code not in CODES:
            raise ValueError(f"unknown diagnostic code {self.code!r}")

    @property
    def code(self) -> str:
        return self.problem.code

    @property
    def message(self) -> str:
        return self.problem.message

    @property
    def hint(self) -> str | None:
        return self.problem.hint

    @property
    def severity(self) -> Severity:
        return self.level if self.level is not None else Severity(CODES[self.code].severity)

    @property
    def changes(self) -> tuple[Edit, ...]:
        """What fixes it, all of it together; empty where there is no one right answer."""
        if self.edits or self.fix is None or self.span is None:
            return self.edits
        return (Edit(self.span, self.fix),)


@dataclass(frozen=True, slots=True)
class Suppressed:
    """A problem that a comment in the source allows; `allow` is where the comment names its code."""

    diagnostic: Diagnostic
    allow: Span
    reason: str


def has_errors(diagnostics: Iterable[Diagnostic]) -> bool:
    """Whether anything in `diagnostics` stops generation."""
    return any(item.severity is Severity.ERROR for item in diagnostics)


def in_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """By file and place, each problem once."""

    def key(item: Diagnostic) -> tuple[str, int, int, str, str]:
        if item.span is None:
            return (item.path or "", -1, -1, item.code, item.message)
        return (item.span.source.path, item.span.start, item.span.end, item.code, item.message)

    seen: dict[tuple[str, int, int, str, str], Diagnostic] = {}
    for item in diagnostics:
        seen.setdefault(key(item), item)
    return tuple(seen[k] for k in sorted(seen))


__all__ = [
    "CODES",
    "GROUPS",
    "Code",
    "Diagnostic",
    "Edit",
    "Problem",
    "Related",
    "Severity",
    "Suppressed",
    "has_errors",
    "in_order",
]
