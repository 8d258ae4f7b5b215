"""Scaffold: the skeletons of what is missing, written into a file that is otherwise left as it is."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.compiler import Analysis, Options, analyse
from aseme_dsl.compiler.formula.holes import apart_from_holes, as_notes
from aseme_dsl.compiler.read.missing import insertions
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

_ROUNDS = 10
"""How often what was written may be completed in turn: a new role may have choices to decide."""

_BRACKETS = ("(", ")")


@dataclass(frozen=True, slots=True)
class Scaffolded:
    """The text with its skeletons; `added` are the notes that they answer, `diagnostics` what is left.

    `advised` are the notes for which only a comment is written, which says what to do.

    Of a file with errors the text is the one that was given.
    """

    text: str
    added: tuple[Diagnostic, ...]
    diagnostics: tuple[Diagnostic, ...]
    advised: tuple[Diagnostic, ...] = ()


def scaffold(
    source: Source, sources: Mapping[str, str] | None = None, options: Options | None = None
) -> Scaffolded:
    """Complete a text with all that its notes say is missing; every character that it has stays.

    Roles, protocols and control are written with holes (`?`, `[?]`) where the author has to decide. Parts
    that another part would have to use first (formulas, participants) are written as comments. Parts that
    stand there already are not written again.
    """
    mark = "\ufeff" if source.text.startswith("\ufeff") else ""
    text = source.text[len(mark) :]
    added: list[Diagnostic] = []
    advised: list[Diagnostic] = []
    first: Analysis | None = None
    for _ in range(_ROUNDS):
        analysis = analyse(Source(source.path, text), sources, options)
        first = first or analysis
        if has_errors(apart_from_holes(analysis.diagnostics)):
            break
        changed, answered, commented = _completed(text, source.path, analysis)
        if not answered and not commented:
            break
        text = changed
        added += answered
        advised += commented
    assert first is not None
    if has_errors(apart_from_holes(analysis.diagnostics)):
        # Also if a skeleton should ever break a file: what was there is better.
        return Scaffolded(source.text, (), as_notes(first.diagnostics))
    return Scaffolded(mark + text, tuple(added), as_notes(analysis.diagnostics), tuple(advised))


def _completed(text: str, path: str, analysis: Analysis) -> tuple[str, list[Diagnostic], list[Diagnostic]]:
    """The text with one round of skeletons, the notes that they answer, and those that get a comment."""
    pieces: dict[int, list[str]] = {}
    answered: list[Diagnostic] = []
    commented: list[Diagnostic] = []
    for item in analysis.missing:
        place = item.place
        if place is None or place.source.path != path:
            continue  # another file's
        found = insertions(text, item)
        for at, piece in found:
            there = pieces.setdefault(at, [])
            if piece not in _BRACKETS or piece not in there:  # several terms may be joined to one formula
                there.append(piece)
        if found:
            (commented if item.is_comment else answered).append(item.note)
    for at in sorted(pieces, reverse=True):
        text = text[:at] + "".join(pieces[at]) + text[at:]
    return text, answered, commented


__all__ = ["Scaffolded", "scaffold"]
