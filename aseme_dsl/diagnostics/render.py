"""Diagnostics for people (terminal) and for programs (JSON)."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from typing import Any

from aseme_dsl.diagnostics.model import Diagnostic, Severity
from aseme_dsl.source import Span

_COLOURS = {Severity.ERROR: "31", Severity.WARNING: "33", Severity.NOTE: "36"}
_TAB = 4


def render_text(diagnostics: Iterable[Diagnostic], *, colour: bool = False) -> str:
    """One block a problem: the code, the place, the line underlined, related places and a hint."""
    return "\n".join(_block(item, colour) for item in diagnostics)


def _paint(text: str, code: str, colour: bool) -> str:
    return f"\x1b[{code}m{text}\x1b[0m" if colour else text


def _width(text: str) -> int:
    """Columns on a terminal: tabs are expanded before, East Asian wide characters take two."""
    return sum(
        0 if unicodedata.combining(char) else 2 if unicodedata.east_asian_width(char) in "WF" else 1
        for char in text
    )


def _excerpt(span: Span, mark: str, label: str, paint: str, colour: bool) -> list[str]:
    line = span.source.line(span.line)
    before = line[: span.column - 1].replace("\t", " " * _TAB)
    inside = line[span.column - 1 : span.column - 1 + (span.end - span.start)].replace("\t", " " * _TAB)
    shown = line.replace("\t", " " * _TAB)
    if len(shown) > 200:  # a line of a machine-made file: show the neighbourhood of the place only
        cut = max(0, len(before) - 80)
        shown = ("…" if cut else "") + shown[cut : cut + 180] + "…"
        before = ("…" if cut else "") + before[cut:]
        inside = inside[:80]
    number = str(span.line)
    underline = " " * _width(before) + _paint(mark * max(1, _width(inside)), paint, colour)
    gutter = " " * len(number)
    return [
        f" {_paint(number, '34', colour)} {_paint('|', '34', colour)} {shown}",
        f" {gutter} {_paint('|', '34', colour)} {underline}{' ' + label if label else ''}",
    ]


def _block(item: Diagnostic, colour: bool) -> str:
    paint = _COLOURS[item.severity]
    head = _paint(f"{item.severity}[{item.code}]", paint + ";1", colour)
    if item.span is None:
        lines = [f"{item.path or '<input>'}: {head}: {item.message}"]
    else:
        lines = [f"{item.span}: {head}: {item.message}"]
        lines += _excerpt(item.span, "^", "", paint, colour)
    for related in item.related:
        lines.append(f"   {related.span}: {related.message}")
        lines += _excerpt(related.span, "-", "", "34", colour)
    if item.hint:
        first, *more = item.hint.splitlines()
        lines.append(f"   {_paint('hint', '32', colour)}: {first}")
        lines += [f"         {line}".rstrip() for line in more]
    return "\n".join(lines) + "\n"


def _place(span: Span) -> dict[str, Any]:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {
        "file": span.source.path,
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
    }


def render_json(diagnostics: Iterable[Diagnostic]) -> list[dict[str, Any]]:
    """The same as plain data, for `--json`."""
    return [
        {
            "code": item.code,
            "severity": str(item.severity),
            "message": item.message,
            "place": _place(item.span) if item.span else ({"file": item.path} if item.path else None),
            "related": [{"message": r.message, "place": _place(r.span)} for r in item.related],
            "hint": item.hint,
            "fix": item.fix,
        }
        for item in diagnostics
    ]
