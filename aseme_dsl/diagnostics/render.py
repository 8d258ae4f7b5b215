"""Diagnostics for people (terminal) and for programs (JSON)."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable

from aseme_dsl.diagnostics.model import Diagnostic, Severity, Suppressed
from aseme_dsl.source import Span

_COLOURS = {Severity.ERROR: "31", Severity.WARNING: "33", Severity.NOTE: "36"}
_TAB = 4
_LONG = 200
"""Lines of more characters are shown only around the place."""
_BEFORE, _INSIDE, _ALL = 80, 80, 180
"""How many characters of a long line are shown before the place, of the place, and in all."""

_LEAST = 20
"""How many columns of a line are shown on the narrowest terminal."""

Link = Callable[[str], str | None]
"""The address of the page about a code, or None if there is none."""


def render_text(
    diagnostics: Iterable[Diagnostic],
    *,
    colour: bool = False,
    link: Link | None = None,
    columns: int | None = None,
) -> str:
    """One block a problem: the code, the place, the line underlined, related places and a hint.

    With `link`, each code is a hyperlink to its page (OSC 8), which only a terminal understands. Source lines
    are cut around the place to what a terminal of so many `columns` shows; without, only very long ones are.
    """
    return "\n".join(_block(item, colour, link, columns) for item in diagnostics)


def _paint(text: str, code: str, colour: bool) -> str:
    return f"\x1b[{code}m{text}\x1b[0m" if colour else text


def _width(text: str) -> int:
    """Columns on a terminal of a text that is shown: East Asian wide characters take two, marks none."""
    return sum(
        0
        if unicodedata.category(char) in ("Mn", "Me")
        else 2
        if unicodedata.east_asian_width(char) in "WF"
        else 1
        for char in text
    )


def _visible(text: str) -> str:
    """A line as it can be shown: tabs as blanks, and nothing that would move a terminal's cursor."""
    if text.isprintable():
        return text
    text = text.replace("\t", " " * _TAB)
    return "".join(char if char.isprintable() else "\ufffd" for char in text)


def excerpt(span: Span, mark: str, paint: str, colour: bool, columns: int | None) -> list[str]:
    """The lines of a place: all of one line, the first and the last of several."""
    first, column = span.source.position(span.start)
    last, end = span.source.position(max(span.start, span.end))
    if last > first and not span.source.line(last)[: end - 1].strip():
        while last > first and not span.source.line(last)[: end - 1].strip():
            last -= 1  # what is there besides blanks ends on an earlier line
            end = len(span.source.line(last)) + 1
    width = len(str(last))
    room = None if columns is None else max(_LEAST, columns - width - 4)
    line = span.source.line(first)
    stop = end - 1 if last == first else len(line)
    lines = _cut(line, column - 1, stop, str(first).rjust(width), mark, paint, colour, room)
    if last > first:
        if last > first + 1:
            lines.append(f" {' ' * width} {_paint('|', '34', colour)} …")
        line = span.source.line(last)
        start = len(line) - len(line.lstrip())
        lines += _cut(line, start, end - 1, str(last), mark, paint, colour, room)
    return lines


def _cut(
    line: str, start: int, stop: int, number: str, mark: str, paint: str, colour: bool, room: int | None
) -> list[str]:
    """The line with what is between `start` and `stop` marked; of a long one, the neighbourhood of that.

    `room` is how many columns it may take.
    """
    before, inside, after = (_visible(part) for part in (line[:start], line[start:stop], line[stop:]))
    if room is not None:
        before, inside, after = _fitting(before, inside, after, room)
    elif len(before + inside + after) > _LONG:  # a line of a machine-made file
        shown = before + inside + after
        cut = max(0, len(before) - _BEFORE)
        more = "…" if len(shown) > cut + _ALL else ""
        shown = ("…" if cut else "") + shown[cut : cut + _ALL] + more
        before = ("…" if cut else "") + before[cut:]
        inside = inside[:_INSIDE]
        after = shown[len(before + inside) :]
    bar = _paint("|", "34", colour)
    underline = " " * _width(before) + _paint(mark * max(1, _width(inside)), paint, colour)
    shown = before + inside + after
    return [f" {_paint(number, '34', colour)} {bar} {shown}", f" {' ' * len(number)} {bar} {underline}"]


def _fitting(before: str, inside: str, after: str, room: int) -> tuple[str, str, str]:
    """The three parts of a line, cut with ellipses to `room` columns; the middle one stays longest."""
    if _width(before + inside + after) <= room:
        return before, inside, after
    if _width(inside) > room - 2:
        inside = _first(inside, room - 3) + "…"
    left = room - _width(inside)
    most = left // 2 if _width(after) >= left - left // 2 else left - _width(after)
    if _width(before) > most:
        before = "…" + _first(before[::-1], most - 1)[::-1] if most > 0 else ""
    left -= _width(before)
    if _width(after) > left:
        after = _first(after, left - 1) + "…" if left > 0 else ""
    return before, inside, after


def _first(text: str, columns: int) -> str:
    """As many characters as fit into so many columns, each with the marks that follow it."""
    taken = 0
    for index, char in enumerate(text):
        taken += _width(char)
        if taken > columns:
            return text[:index]
    return text


def _block(item: Diagnostic, colour: bool, link: Link | None, columns: int | None) -> str:
    paint = _COLOURS[item.severity]
    head = _paint(f"{item.severity}[{_linked(item.code, link)}]", paint + ";1", colour)
    if item.span is None:
        lines = [f"{item.path or '<input>'}: {head}: {item.message}"]
    else:
        lines = [f"{item.span}: {head}: {item.message}"]
        lines += excerpt(item.span, "^", paint, colour, columns)
    for related in item.related:
        lines.append(f"   {related.span}: {related.message}")
        lines += excerpt(related.span, "-", "34", colour, columns)
    if item.hint:
        first, *more = item.hint.splitlines()
        lines.append(f"   {_paint('hint', '32', colour)}: {first}")
        lines += [f"         {line}".rstrip() for line in more]
    return "\n".join(lines) + "\n"


def _linked(code: str, link: Link | None) -> str:
    address = link(code) if link is not None else None
    return f"\x1b]8;;{address}\x1b\\{code}\x1b]8;;\x1b\\" if address else code


def place_json(span: Span) -> dict[str, object]:
    """A place as plain data: the file, and the range in lines and columns from 1, its end exclusive."""
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {
        "file": span.source.path,
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
    }


def render_json(diagnostics: Iterable[Diagnostic]) -> list[dict[str, object]]:
    """The same as plain data, for `--json`.

    `edits` is everything that fixes the problem; `fix` is the one replacement of the text at its place.
    """
    return [
        {
            "code": item.code,
            "severity": str(item.severity),
            "message": item.message,
            "place": place_json(item.span) if item.span else ({"file": item.path} if item.path else None),
            "related": [{"message": r.message, "place": place_json(r.span)} for r in item.related],
            "hint": item.hint,
            "fix": item.fix,
            "edits": [{"place": place_json(edit.span), "text": edit.text} for edit in item.changes],
        }
        for item in diagnostics
    ]


def suppressed_json(suppressed: Iterable[Suppressed]) -> list[dict[str, object]]:
    """What comments in the sources allow, each with the comment's place and reason."""
    found = tuple(suppressed)
    items = render_json(item.diagnostic for item in found)
    return [
        {**data, "allowed": {"place": place_json(item.allow), "reason": item.reason}}
        for data, item in zip(items, found, strict=True)
    ]
