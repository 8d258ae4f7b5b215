"""Aliases: the names that a file gives its imports, at a place of the text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text.lexer import clean
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_IMPORT = re.compile(r'import\s+"[^"\n]*"\s+as\s+(\w+)', re.ASCII)
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)


@dataclass(frozen=True, slots=True)
class Alias:
    """A name of an import at one place, where it is `declared`, and the import as it is written."""

    span: Span
    declared: Span
    said: str


def alias_at(view: View, offset: int) -> Alias | None:
    """The name of an import at an offset: `alice` of `alice.attacker`, or where it is given."""
    text = view.source.text
    start = offset
    while start > 0 and (text[start - 1].isalnum() or text[start - 1] == "_"):
        start -= 1
    word = _WORD.match(text, start)
    if word is None or any(span.start <= offset < span.end for span in comments_near(view, offset)):
        return None
    said = next((found for found in _IMPORT.finditer(text) if found[1] == word[0]), None)
    if said is None or not (text[word.end() :].lstrip()[:1] == "." or said.start(1) == start):
        return None
    declared = Span(view.source, said.start(1), said.end(1))
    return Alias(Span(view.source, start, word.end()), declared, said[0])


def comments_near(view: View, offset: int) -> Iterator[Span]:
    """The comments among which an offset may be; in a text that was not yet read again, those of its line."""
    if not view.carry:
        yield from (item.span for item in (view.file.comments if view.file is not None else ()))
        return
    begin = view.source.text.rfind("\n", 0, offset) + 1
    line = view.source.text[begin:].partition("\n")[0]
    for item in clean(Source(view.path, line)).comments:
        yield Span(view.source, begin + item.span.start, begin + item.span.end)


__all__ = ["Alias", "alias_at", "comments_near"]
