"""Reports: the verdicts on scenarios for people and for CI services."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from shlex import quote

from aseme_dsl.diagnostics.github import command
from aseme_dsl.diagnostics.junit import printable
from aseme_dsl.diagnostics.render import excerpt
from aseme_dsl.play.sight.story import told
from aseme_dsl.project.testing.verdicts import ScenarioResult, Verdict
from aseme_dsl.source import Span

COLOURS = {"passed": "32", "failed": "31", "error": "31", "vacuous": "33"}
"""The colours of verdicts on a terminal, as ANSI codes."""


def explained(item: ScenarioResult, is_coloured: bool) -> Iterator[str]:
    """Why a scenario has not passed: the reason with its place, the inputs, and what happened last."""
    if item.span is None:
        return
    yield f"  {item.span}: {item.reason}"
    for line in excerpt(item.span, "^", COLOURS[item.verdict], is_coloured, None):
        yield f"  {line}"
    if given := {name: value for name, value in (item.given or {}).items() if name not in item.row}:
        yield "  with " + ", ".join(f"{name} = {value}" for name, value in given.items())
    if item.row:
        yield "  with the row " + ", ".join(f"{name} = {cell}" for name, cell in item.row.items())
    if item.dropped:
        yield f"  shown is a shorter run with the same reason, without {_inputs(item.dropped)}:"
    for line in told(item.story):
        yield f"    {line}"
    if not item.is_steady:
        yield "  a second run with this seed was different: code of an activity or world is not repeatable"
    if item.question and item.trace is not None:
        yield f"  ask next: {item.question} {quote(str(item.trace))}"
    elif item.question:
        yield f"  ask next: {item.question} TRACE (`asemec test --traces DIR` writes it)"


def _inputs(spans: Sequence[Span]) -> str:
    lines = ", ".join(str(span.line) for span in spans)
    return f"the input of line {lines}" if len(spans) == 1 else f"the inputs of lines {lines}"


def github(results: Sequence[ScenarioResult]) -> str:
    """One workflow command for each scenario that has not passed."""
    return "".join(
        f"{command('error', item.span, None, item.name, item.reason)}\n"
        for item in results
        if item.verdict is not Verdict.PASSED
    )


def junit(results: Sequence[ScenarioResult], file: str) -> str:
    """JUnit XML: one suite, the file, with a case for each scenario. A vacuous one is a failure, too."""
    from xml.etree.ElementTree import Element, SubElement, indent, tostring

    errors = sum(item.verdict is Verdict.ERROR for item in results)
    failures = sum(item.verdict in (Verdict.FAILED, Verdict.VACUOUS) for item in results)
    counts = {"tests": str(len(results)), "failures": str(failures), "errors": str(errors)}
    root = Element("testsuites", {"name": "asemec test", **counts})
    suite = SubElement(root, "testsuite", {"name": printable(file), **counts})
    for item in results:
        names = {"name": printable(item.name), "classname": printable(file)}
        case = SubElement(suite, "testcase", {**names, "time": f"{item.time_ns / 1e9:.3f}"})
        if item.verdict is not Verdict.PASSED:
            word = "error" if item.verdict is Verdict.ERROR else "failure"
            attributes = {"type": str(item.verdict), "message": printable(item.reason)}
            text = "\n".join((f"{item.span}: {item.reason}, seed {item.seed}", *told(item.story)))
            SubElement(case, word, attributes).text = printable(text)
    indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'


__all__ = ["COLOURS", "explained", "github", "junit"]
