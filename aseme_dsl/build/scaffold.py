"""Scaffold: the skeletons of what is missing, written into a file that is otherwise left as it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from aseme_dsl.compiler import Analysis, Options, analyse
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.source import Source, Span

_ROUNDS = 10
"""How often what was written may be completed in turn: a new role may have choices to decide."""

_STEP = "  "


@dataclass(frozen=True, slots=True)
class Scaffolded:
    """The text with its skeletons; `added` are the notes that they answer, `diagnostics` what is left.

    Of a file with errors the text is the one that was given.
    """

    text: str
    added: tuple[Diagnostic, ...]
    diagnostics: tuple[Diagnostic, ...]


def scaffold(
    source: Source, sources: Mapping[str, str] | None = None, options: Options | None = None
) -> Scaffolded:
    """Complete a text with all that its notes say is missing; every character that it has stays.

    Roles, protocols and control are written so that they compile; what another part would have to use first
    (formulas, participants) is written as a comment. What stands there already is not written again.
    """
    mark = "\ufeff" if source.text.startswith("\ufeff") else ""
    text = source.text[len(mark) :]
    added: list[Diagnostic] = []
    first: Analysis | None = None
    for _ in range(_ROUNDS):
        analysis = analyse(Source(source.path, text), sources, options)
        first = first or analysis
        if has_errors(analysis.diagnostics):
            break
        changed, notes = _completed(text, source.path, analysis)
        if not notes:
            break
        text = changed
        added += notes
    assert first is not None
    if has_errors(analysis.diagnostics):
        # Also if a skeleton should ever break a file: what was there is better.
        return Scaffolded(source.text, (), first.diagnostics)
    # The conditions of the skeletons are still to be written: until then their loops only go round.
    left = (item for item in analysis.diagnostics if not (added and item.code == "W420"))
    return Scaffolded(mark + text, tuple(added), tuple(left))


def _completed(text: str, path: str, analysis: Analysis) -> tuple[str, list[Diagnostic]]:
    """The text with one round of skeletons, and the notes that they answer."""
    newline = "\r\n" if "\r\n" in text else "\n"
    insertions: dict[int, list[str]] = {}
    notes: list[Diagnostic] = []
    for item in analysis.missing:
        place = item.inside if item.inside is not None else item.note.span
        if place is None or place.source.path != path:
            continue  # another file's
        lines = item.skeleton.split("\n")
        if lines[0].startswith("//") and lines[0] in text:
            continue
        at, piece = _at_end(text, lines) if item.inside is None else _in_block(text, item.inside, lines)
        insertions.setdefault(at, []).append(piece.replace("\n", newline))
        notes.append(item.note)
    for at in sorted(insertions, reverse=True):
        text = text[:at] + "".join(insertions[at]) + text[at:]
    return text, notes


def _at_end(text: str, lines: list[str]) -> tuple[int, str]:
    """After an empty line at the end of the file."""
    gap = "\n" if text.endswith("\n") or not text else "\n\n"
    return len(text), gap + "\n".join(lines) + ("\n" if text.endswith("\n") else "")


def _in_block(text: str, block: Span, lines: list[str]) -> tuple[int, str]:
    """Before the last brace of a block, as far in as what is already there."""
    brace = block.end - 1
    start = text.rfind("\n", 0, brace) + 1
    before = text[start:brace]
    indent = before[: len(before) - len(before.lstrip())]
    inner = _indent_inside(text[block.start : brace]) or indent + _STEP
    body = "".join(f"{inner}{line}\n" if line else "\n" for line in lines)
    if not before.strip():
        return start, body if lines[0].startswith("//") else "\n" + body
    # The brace shares its line: the skeleton and the brace get lines of their own.
    return brace, "\n" + body + indent


def _indent_inside(block: str) -> str:
    """The indentation of the first line inside a block; none where it begins on the line of its brace."""
    for line in block.split("\n")[1:]:
        if line.strip():
            return line[: len(line) - len(line.lstrip())]
    return ""


__all__ = ["Scaffolded", "scaffold"]
