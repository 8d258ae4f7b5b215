"""SARIF 2.1.0: diagnostics for code scanning services and editors (OASIS, Static Analysis Results …)."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path, PurePath
from typing import Any
from urllib.parse import quote

from aseme_dsl.diagnostics.model import Diagnostic, Suppressed
from aseme_dsl.diagnostics.pages import markdown, page
from aseme_dsl.source import Source, Span

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
ROOT = "%SRCROOT%"
"""What relative addresses are relative to: the working directory, which CI services take for the checkout."""
FINGERPRINT = "asemec/v1"


def sarif(
    diagnostics: Iterable[Diagnostic],
    suppressed: Iterable[Suppressed] = (),
    *,
    version: str,
) -> dict[str, Any]:
    """One run of asemec `version` as a SARIF log. Columns are counted in code points."""
    found = tuple(diagnostics)
    allowed = tuple(suppressed)
    run = _Run(sorted({item.code for item in (*found, *(other.diagnostic for other in allowed))}))
    results = [run.result(item) for item in found]
    for item in allowed:
        reason = {"justification": item.reason} if item.reason else {}
        suppression = {"kind": "inSource", "location": _location(item.allow), **reason}
        results.append({**run.result(item.diagnostic), "suppressions": [suppression]})
    driver = {"name": "asemec", "version": version, "rules": [_rule(code) for code in run.codes]}
    return {
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [
            {
                "tool": {"driver": driver},
                "invocations": [{"executionSuccessful": True}],
                "columnKind": "unicodeCodePoints",
                "results": results,
            }
        ],
    }


@dataclass(slots=True)
class _Run:
    """The rules of one log, and how often each fingerprint was given."""

    codes: list[str]
    seen: Counter[str] = field(default_factory=Counter)

    def result(self, item: Diagnostic) -> dict[str, Any]:
        text = item.message if item.hint is None else f"{item.message}\n{item.hint}"
        result: dict[str, Any] = {
            "ruleId": item.code,
            "ruleIndex": self.codes.index(item.code),
            "level": str(item.severity),
            "message": {"text": text},
            "partialFingerprints": {FINGERPRINT: self.fingerprint(item)},
        }
        if item.span is not None:
            result["locations"] = [_location(item.span)]
        elif item.path is not None:
            result["locations"] = [{"physicalLocation": {"artifactLocation": _artifact(item.path)}}]
        if item.related:
            result["relatedLocations"] = [
                {"id": number, **_location(other.span), "message": {"text": other.message}}
                for number, other in enumerate(item.related, 1)
            ]
        if item.changes:
            result["fixes"] = [_fix(item)]
        return result

    def fingerprint(self, item: Diagnostic) -> str:
        """What stays the same when lines are added elsewhere: the code, the file and the text of the place.

        The same problem on several lines that read the same is told apart by its number.
        """
        parts = [item.code]
        if item.span is not None:
            line = item.span.source.line(item.span.line)
            parts += [_uri(item.span.source.path), " ".join(line.split()), " ".join(item.span.text.split())]
        else:
            parts.append(_uri(item.path or ""))
        base = "\0".join(parts)
        self.seen[base] += 1
        return hashlib.sha256(f"{base}\0{self.seen[base]}".encode("utf-8", "replace")).hexdigest()[:32]


def _rule(code: str) -> dict[str, Any]:
    about = page(code)
    return {
        "id": code,
        "shortDescription": {"text": about.title},
        "help": {"text": about.text, "markdown": markdown(about)},
        "defaultConfiguration": {"level": about.severity},
    }


def _location(span: Span) -> dict[str, Any]:
    artifact = _artifact(span.source.path)
    return {"physicalLocation": {"artifactLocation": artifact, "region": _region(span)}}


def _region(span: Span) -> dict[str, int]:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {"startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column}


def _fix(item: Diagnostic) -> dict[str, Any]:
    changes: dict[Source, list[dict[str, Any]]] = {}
    for edit in item.changes:
        replacement = {"deletedRegion": _region(edit.span), "insertedContent": {"text": edit.text}}
        changes.setdefault(edit.span.source, []).append(replacement)
    return {
        "description": {"text": item.hint or item.message},
        "artifactChanges": [
            {"artifactLocation": _artifact(source.path), "replacements": replacements}
            for source, replacements in changes.items()
        ],
    }


def _artifact(path: str) -> dict[str, str]:
    uri = _uri(path)
    return {"uri": uri} if uri.startswith("file:") else {"uri": uri, "uriBaseId": ROOT}


def _uri(path: str) -> str:
    """Relative to the working directory where it is below that, else absolute."""
    pure = PurePath(path)
    if pure.is_absolute() or ".." in pure.parts:
        absolute = Path(path).absolute()
        inside = _below(absolute)
        if inside is None:
            return absolute.as_uri()
        pure = inside
    return quote(pure.as_posix(), errors="replace")


def _below(path: Path) -> PurePath | None:
    try:
        return path.resolve().relative_to(Path.cwd().resolve())
    except (ValueError, OSError):
        return None


__all__ = ["sarif"]
