"""Scaffold: the skeletons of what is missing, written into a file that is otherwise left as it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from aseme_dsl.compiler import Analysis, Options, analyse
from aseme_dsl.compiler.missing import insertion
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.source import Source

_ROUNDS = 10
"""How often what was written may be completed in turn: a new role may have choices to decide."""


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
    insertions: dict[int, list[str]] = {}
    notes: list[Diagnostic] = []
    for item in analysis.missing:
        place = item.inside if item.inside is not None else item.note.span
        if place is None or place.source.path != path:
            continue  # another file's
        found = insertion(text, item)
        if found is None:
            continue
        at, piece = found
        insertions.setdefault(at, []).append(piece)
        notes.append(item.note)
    for at in sorted(insertions, reverse=True):
        text = text[:at] + "".join(insertions[at]) + text[at:]
    return text, notes


__all__ = ["Scaffolded", "scaffold"]
