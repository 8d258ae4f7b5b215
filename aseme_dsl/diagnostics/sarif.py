"""SARIF 2.1.0: diagnostics for code scanning services and editors (OASIS, Static Analysis Results …)."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.diagnostics.identity import fingerprints, uri
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
) -> dict[str, object]:
    """One run of asemec `version` as a SARIF log. Columns are counted in code points."""
    found = tuple(diagnostics)
    allowed = tuple(suppressed)
    everything = [*found, *(item.diagnostic for item in allowed)]
    codes = sorted({item.code for item in everything})
    results = [
        _result(item, codes, own) for item, own in zip(everything, fingerprints(everything), strict=True)
    ]
    for item, result in zip(allowed, results[len(found) :], strict=True):
        reason = {"justification": item.reason} if item.reason else {}
        result["suppressions"] = [{"kind": "inSource", "location": _location(item.allow), **reason}]
    driver = {"name": "asemec", "version": version, "rules": [_rule(code) for code in codes]}
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


def _result(item: Diagnostic, codes: list[str], fingerprint: str) -> dict[str, object]:
    text = item.message if item.hint is None else f"{item.message}\n{item.hint}"
    result: dict[str, object] = {
        "ruleId": item.code,
        "ruleIndex": codes.index(item.code),
        "level": str(item.severity),
        "message": {"text": text},
        "partialFingerprints": {FINGERPRINT: fingerprint},
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


def _rule(code: str) -> dict[str, object]:
    about = page(code)
    return {
        "id": code,
        "shortDescription": {"text": about.title},
        "help": {"text": about.text, "markdown": markdown(about)},
        "defaultConfiguration": {"level": about.severity},
    }


def _location(span: Span) -> dict[str, object]:
    artifact = _artifact(span.source.path)
    return {"physicalLocation": {"artifactLocation": artifact, "region": _region(span)}}


def _region(span: Span) -> dict[str, int]:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {"startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column}


def _fix(item: Diagnostic) -> dict[str, object]:
    changes: dict[Source, list[dict[str, object]]] = {}
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
    own = uri(path)
    return {"uri": own} if own.startswith("file:") else {"uri": own, "uriBaseId": ROOT}


__all__ = ["sarif"]
