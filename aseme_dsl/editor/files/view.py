"""View: one file as it is open in an editor at one moment, with all that is known of it."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cached_property

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.editor.files.carrying import Carry
from aseme_dsl.editor.files.index import Occurrence
from aseme_dsl.editor.files.positions import Lines
from aseme_dsl.editor.files.program import Program
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_WORD = re.compile(r"\w*", re.ASCII)
_TWO = re.compile(r"\w\w", re.ASCII)
_LONGEST = 200
"""How long a word is at most."""


def _word_at(text: str, offset: int) -> tuple[int, int]:
    """Where the word around an offset begins and ends."""
    before = _WORD.match(text[max(0, offset - _LONGEST) : offset][::-1])
    behind = _WORD.match(text, offset)
    assert before is not None and behind is not None  # it may be empty
    return offset - before.end(), behind.end()


def _is_in_a_word(text: str, offset: int) -> bool:
    return _TWO.match(text, offset - 1) is not None if offset > 0 else False


def _name_of(declaration: tree.Declaration | None) -> str:
    return str(getattr(declaration, "name", ""))


@dataclass(frozen=True)
class View:
    """A file and the program that it is looked at in.

    Offsets and whole spans are those of `source`, the text of the moment. Spans of trees and models belong to
    parts of files: `whole` turns them into places, `at` says in which part an offset is.
    """

    path: str
    """Where the file really is."""
    source: Source
    version: int | None
    program: Program
    diagnostics: tuple[Diagnostic, ...]
    """What there is to say of this file, in all programs that it is in."""
    earlier: View | None = None
    """The last view in which the file had no mistake of syntax, if it has one now."""
    carry: tuple[Carry, ...] = ()
    """What has been edited since the program was compiled, in this order."""

    @cached_property
    def lines(self) -> Lines:
        return Lines(self.source.text)

    @cached_property
    def file(self) -> tree.File | None:
        """The tree of what could be read; None where the file could not be read at all."""
        return self.program.files.get(self.path)

    @cached_property
    def parts(self) -> tuple[tuple[int, int, Source], ...]:
        """The parts of the file as `Layout.parts_of` has them."""
        return self.program.layout.parts_of(self.file.source) if self.file is not None else ()

    def at(self, offset: int) -> tuple[Source, int]:
        """The part that `offset` is in, and the offset in the part."""
        for edit in reversed(self.carry):
            offset = edit.back(offset)
        found, base = self.file.source if self.file is not None else self.source, 0
        for start, own, part in self.parts:
            if own > offset:
                break
            found, base = part, start
        return found, offset - base

    def whole(self, span: Span) -> Span:
        """The place in its file of a span of a tree or model."""
        span = self.program.whole(span)
        if self.carry and self.file is not None and span.source is self.file.source:
            for edit in self.carry:
                span = edit.span(span, self.source)
        return span

    def declaration_at(self, offset: int) -> tree.Declaration | None:
        """The declaration around an offset."""
        part, inside = self.at(offset)
        for item in self.file.declarations if self.file is not None else ():
            if item.span.source is part and item.span.start <= inside <= item.span.end:
                return item
        return None

    def occurrence_at(self, offset: int) -> Occurrence | None:
        """The name at an offset, or just before it; in what cannot be read now, what it meant before."""
        part, inside = self.at(offset)
        found = self.program.index.at(part, inside)
        if found is not None and self.carry:
            span = self.whole(found.span)
            found = found if self.stands(found) and span.start <= offset <= span.end else None
        return found or self._meant_before(offset)

    def stands(self, item: Occurrence) -> bool:
        """Whether a name has not been edited since the program was compiled."""
        if not self.carry:
            return True
        span, text = self.whole(item.span), self.source.text
        if span.source is not self.source:
            return True
        if span.text != item.span.text:
            return False
        return not any(_is_in_a_word(text, place) for place in (span.start, span.end))

    def _meant_before(self, offset: int) -> Occurrence | None:
        """What the word at an offset meant in its block before the last edits, or mistakes of syntax."""
        start, end = _word_at(self.source.text, offset)
        if start == end:
            return None
        name = _name_of(self.declaration_at(offset))
        for view in (self if self.carry else None, self.earlier):
            for block in view.file.declarations if view is not None and view.file is not None else ():
                if view is not None and _name_of(block) == name:
                    for item in view.program.index.part(block.span.source):
                        if item.span.text == self.source.text[start:end]:
                            return replace(item, span=Span(self.source, start, end))
        return None

    @cached_property
    def occurrences(self) -> tuple[Occurrence, ...]:
        """All names of the file, in the order of the text."""
        if self.file is None:
            return ()
        parts = [part for *_, part in self.parts] or [self.file.source]
        return tuple(item for part in parts for item in self.program.index.part(part))


def carried(view: View, text: str, edits: tuple[Carry, ...]) -> View:
    """The same file with the text of this moment, to which it has been edited since `view` was made."""
    return replace(view, source=Source(view.source.path, text), carry=edits) if edits else view
