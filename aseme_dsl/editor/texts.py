"""Texts: what an editor calls files, and where places in their text are for it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from functools import lru_cache

from lsprotocol import types as lsp
from pygls.uris import from_fs_path, to_fs_path

from aseme_dsl import diagnostics
from aseme_dsl.editor.answers import navigation
from aseme_dsl.editor.files.carrying import carry
from aseme_dsl.editor.files.positions import Lines, Position
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.source import Source, Span


class Texts:
    """The files of a workspace as an editor names them, and places in them as it counts them."""

    def __init__(self, files: Workspace, encoding: Callable[[], str]) -> None:
        """`encoding` is in what the editor counts the places of a line."""
        self.files = files
        self.encoding = encoding
        self.uris: dict[str, str] = {}
        """As the editor calls the files that it has opened, by path."""
        self.code: dict[str, str] = {}
        """The Python files that are open, by path."""

    def lines(self, source: Source) -> Lines:
        return _lines(source, self.encoding())

    def uri(self, path: str) -> str:
        """As the editor calls the file, if it has opened it."""
        return self.uris.get(path) or from_fs_path(path) or path

    def path(self, uri: str) -> str:
        """What an editor calls by another scheme (`untitled:`) has a path that no file has."""
        path = to_fs_path(uri) if uri.startswith("file:") else f"/{uri.replace(':', '/')}"
        found = os.path.realpath(path or uri)
        if uri not in self.uris.values():
            self.uris.setdefault(found, uri)
        return found

    def source(self, path: str, text: str) -> Source:
        """A text as the compiler reads it."""
        return _source(path, text.removeprefix("\ufeff"))

    def text_of(self, uri: str) -> Source | None:
        """The text of a file as it is at this moment."""
        path = self.path(uri)
        text = self.files.text(path)
        return None if text is None else self.source(path, text)

    def now(self, path: str, span: Span) -> Span:
        """The same place in the text of this moment, if the file is open."""
        is_model = path in self.files.buffers
        text = self.files.buffers[path].text if is_model else self.code.get(path)
        if text is None or text.removeprefix("\ufeff") == span.source.text:
            return span
        view = self.files.recent(path) if is_model else None
        if view is not None and view.file is not None and view.file.source.text == span.source.text:
            return view.whole(Span(view.file.source, span.start, span.end))
        source = self.source(path, text)
        return carry(span.source.text, source.text).span(span, source)

    def offset(self, view: View, position: lsp.Position) -> int:
        return self.offset_in(view.source, position)

    def offset_in(self, source: Source, position: lsp.Position) -> int:
        return self.lines(source).offset(Position(position.line, position.character))

    def range(self, span: Span) -> lsp.Range:
        lines = self.lines(span.source)
        start, end = lines.position(span.start), lines.position(span.end)
        return lsp.Range(lsp.Position(start.line, start.character), lsp.Position(end.line, end.character))

    def location(self, path: str, span: Span) -> lsp.Location:
        """A place in a file; of one that is open, in the text of this moment."""
        return lsp.Location(self.uri(path), self.range(self.now(path, span)))

    def locations(self, places: Iterable[navigation.Place]) -> list[lsp.Location]:
        """Where things are now; not those whose names have been edited since the compiler has seen them."""
        found = ((place, self.now(place.path, place.span)) for place in places)
        return [
            lsp.Location(self.uri(place.path), self.range(span))
            for place, span in found
            if span.text == place.span.text
        ]

    def text_edits(self, edits: Iterable[diagnostics.Edit]) -> list[lsp.TextEdit]:
        return [lsp.TextEdit(self.range(edit.span), edit.text) for edit in edits]

    def plain_range(self, span: Span) -> dict[str, dict[str, int]]:
        """A range as it goes over the wire."""
        place = self.range(span)
        return {
            "start": {"line": place.start.line, "character": place.start.character},
            "end": {"line": place.end.line, "character": place.end.character},
        }


@lru_cache(maxsize=16)
def _source(path: str, text: str) -> Source:
    return Source(path, text)


@lru_cache(maxsize=64)
def _lines(source: Source, encoding: str) -> Lines:
    return Lines(source.text, encoding)


__all__ = ["Texts"]
