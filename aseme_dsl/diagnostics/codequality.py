"""Code quality: diagnostics as GitLab's Code Quality report, which it shows in a merge request's changes."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.diagnostics.identity import below_here, fingerprints
from aseme_dsl.diagnostics.model import Diagnostic, Severity

_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.NOTE: "info"}


def codequality(diagnostics: Iterable[Diagnostic]) -> list[dict[str, object]]:
    """One issue a problem, as GitLab documents it for tools of one's own.

    A path is relative to the working directory where it is below that. A problem that is in no line is shown
    at the first one of its file.
    """
    found = tuple(diagnostics)
    return [_issue(item, own) for item, own in zip(found, fingerprints(found), strict=True)]


def _issue(item: Diagnostic, fingerprint: str) -> dict[str, object]:
    text = item.message if item.hint is None else f"{item.message}; {item.hint}"
    path, lines = item.path or "asemec", {"begin": 1}
    if item.span is not None:
        path = item.span.source.path
        lines = {"begin": item.span.line, "end": item.span.source.position(item.span.end)[0]}
    inside = below_here(path)
    return {
        "description": text,
        "check_name": item.code,
        "fingerprint": fingerprint,
        "severity": _SEVERITIES[item.severity],
        "location": {"path": path if inside is None else inside.as_posix(), "lines": lines},
    }


__all__ = ["codequality"]
