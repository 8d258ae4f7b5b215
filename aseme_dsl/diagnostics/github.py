"""GitHub: diagnostics as workflow commands, which a GitHub action shows beside the lines of a change."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.diagnostics.model import Diagnostic, Severity
from aseme_dsl.source import Span

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}


def github(diagnostics: Iterable[Diagnostic]) -> str:
    """One line a problem: `::error file=…,line=…,col=…,endLine=…,endColumn=…,title=…::…`.

    Of a place of several lines there are no columns: GitHub takes them only within a line.
    """
    return "".join(f"{_command(item)}\n" for item in diagnostics)


def _command(item: Diagnostic) -> str:
    text = item.message if item.hint is None else f"{item.message}\n{item.hint}"
    return command(_COMMANDS[item.severity], item.span, item.path, item.code, text)


def command(word: str, span: Span | None, path: str | None, title: str, text: str) -> str:
    """A workflow command at a place, or at a file alone."""
    properties: dict[str, str | int] = {}
    if span is not None:
        line, column = span.source.position(span.start)
        end_line, end_column = span.source.position(span.end)
        properties = {"file": span.source.path, "line": line, "endLine": end_line}
        if line == end_line:
            properties |= {"col": column, "endColumn": end_column}
    elif path is not None:
        properties["file"] = path
    properties["title"] = title
    said = ",".join(f"{name}={_property(str(value))}" for name, value in properties.items())
    return f"::{word} {said}::{_data(text)}"


def _data(text: str) -> str:
    """Escaped as the runner wants it in the text of a command."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    """Escaped as the runner wants it in a property, where `:` and `,` end it."""
    return _data(text).replace(":", "%3A").replace(",", "%2C")


__all__ = ["command", "github"]
