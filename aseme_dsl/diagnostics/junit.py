"""JUnit: diagnostics as a test report, which most CI services show (GitLab, Jenkins, Azure, …)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from aseme_dsl.diagnostics.model import Diagnostic, Severity
from aseme_dsl.diagnostics.render import render_text

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 cannot hold, not even escaped."""


def junit(
    diagnostics: Iterable[Diagnostic],
    files: Iterable[str],
    *,
    name: str = "asemec check",
    strict: bool = False,
) -> str:
    """The diagnostics as JUnit XML: one test suite for each file, one case for each diagnostic.

    A file without diagnostics has one case that passes. An error is a failed case; with `strict` a warning
    is, too. Any other diagnostic is a case that passes, with its text as output. `name` is the name of the
    run.
    """
    from xml.etree.ElementTree import Element, SubElement, indent, tostring

    suites: dict[str, list[Diagnostic]] = {path: [] for path in sorted(files)}
    for item in diagnostics:
        path = item.span.source.path if item.span is not None else item.path or "asemec"
        suites.setdefault(path, []).append(item)
    bad = {Severity.ERROR, Severity.WARNING} if strict else {Severity.ERROR}
    root = Element("testsuites", {"name": name, **_counts(suites, bad)})
    for path, found in suites.items():
        suite = SubElement(root, "testsuite", {"name": printable(path), **_counts({path: found}, bad)})
        if not found:
            SubElement(suite, "testcase", {"name": "nothing to report", "classname": printable(path)})
        for item in found:
            case = SubElement(
                suite, "testcase", {"name": printable(_name(item)), "classname": printable(path)}
            )
            text = printable(render_text([item]))
            if item.severity in bad:
                attributes = {"type": item.code, "message": printable(item.message)}
                SubElement(case, "failure", attributes).text = text
            else:
                SubElement(case, "system-out").text = text
    indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, encoding="unicode") + "\n"


def _counts(suites: Mapping[str, list[Diagnostic]], bad: set[Severity]) -> dict[str, str]:
    tests = sum(max(1, len(found)) for found in suites.values())
    failures = sum(item.severity in bad for found in suites.values() for item in found)
    return {"tests": str(tests), "failures": str(failures), "errors": "0"}


def _name(item: Diagnostic) -> str:
    place = f" line {item.span.line}:" if item.span is not None else ""
    return f"{item.severity}[{item.code}]{place} {item.message}"


def printable(text: str) -> str:
    """The text without what XML cannot hold."""
    return _NO_XML.sub("\ufffd", text)


__all__ = ["junit", "printable"]
