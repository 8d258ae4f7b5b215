"""Publishing: the diagnostics that an editor is sent without having asked."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

from lsprotocol import types as lsp

from aseme_dsl import diagnostics
from aseme_dsl.diagnostics.pages import file_of
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.reading import reading
from aseme_dsl.editor.session import Server
from aseme_dsl.source import Source, Span

DEBOUNCE = 0.04
"""Seconds without a change after which there is something to say of a file."""

UNUSED = frozenset({"N727", "E302", "W301"})
"""Codes of what is there and never used: editors show it pale."""

_SEVERITIES = {
    diagnostics.Severity.ERROR: lsp.DiagnosticSeverity.Error,
    diagnostics.Severity.WARNING: lsp.DiagnosticSeverity.Warning,
    diagnostics.Severity.NOTE: lsp.DiagnosticSeverity.Information,
}


class Publishing:
    """What a server says by itself of the files that are open."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._texts = server.texts
        self._files = server.files
        self._waiting: dict[str, asyncio.Task[None]] = {}
        self._elsewhere: dict[str, dict[str, list[lsp.Diagnostic]]] = {}
        self.renewed: Callable[[], None] = lambda: None
        """Called when the diagnostics are those of the text of this moment."""

    def soon(self, path: str) -> None:
        """Say what there is to say of a file, and of those that it concerns, when nothing changes now."""
        self.hush(path)
        self._server.tidying.busy()
        self._waiting[path] = asyncio.create_task(self.publish(path))

    def hush(self, path: str) -> None:
        """What was to be said of a file is out of date."""
        earlier = self._waiting.pop(path, None)
        if earlier is not None:
            earlier.cancel()

    async def publish(self, path: str) -> None:
        """Send the diagnostics of a file and of all open files that they may have changed in."""
        await asyncio.sleep(DEBOUNCE)
        while True:
            try:
                await self._server.reading(lambda: self._publish(path))
                break
            except reading.NotYet as wanted:
                await self._server.reader.wait(wanted.job)
        self._waiting.pop(path, None)
        if not self._waiting:
            self._server.tidying.tidy_up()

    async def _publish(self, path: str) -> None:
        for other in self._files.affected(path):
            view = await self._server.settled(other)
            if view is not None:
                self._publish_one(other, view)
                await self._server.in_pieces(view.program.indexing())
        for root in self._files.roots(path):
            self._publish_elsewhere(root, await self._server.in_pieces(self._files.programming(root)))
        self.hush_elsewhere()
        self.renewed()

    def _publish_one(self, path: str, view: View) -> None:
        if path not in self._files.buffers:
            return
        found = [self._diagnostic(view.program, view.source, item) for item in view.diagnostics]
        if self._server.showing is not None:
            found += self._server.showing.diagnostics(view)
        self._server.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(self._texts.uri(path), found, self._files.buffers[path].version)
        )

    def _publish_elsewhere(self, root: str, program: Program | None) -> None:
        """Send what there is to say of a root's files that are not open: Python, the configuration, imports.

        None: no file of the root is open any more.
        """
        found: dict[str, list[lsp.Diagnostic]] = {}
        if program is not None:
            for item in program.diagnostics:
                path = program.place_of(item)
                if path not in self._files.buffers and Path(path).exists():
                    source = item.span.source if item.span is not None else self._texts.source(path, "")
                    found.setdefault(path, []).append(self._diagnostic(program, source, item))
        before = self._elsewhere.pop(root, {})
        if found:
            self._elsewhere[root] = found
        for path in {*before, *found} - set(self._files.buffers):
            if before.get(path) == found.get(path):
                continue
            said: list[lsp.Diagnostic] = []
            for known in self._elsewhere.values():
                said += [item for item in known.get(path, ()) if item not in said]
            self._server.text_document_publish_diagnostics(
                lsp.PublishDiagnosticsParams(self._texts.uri(path), said)
            )

    def hush_elsewhere(self) -> None:
        """What was said of the files of roots that no open file belongs to any more is out of date."""
        if self._elsewhere:
            roots = {root for path in self._files.buffers for root in self._files.roots(path)}
            for root in set(self._elsewhere) - roots:
                self._publish_elsewhere(root, None)

    def _diagnostic(self, program: Program, source: Source, item: diagnostics.Diagnostic) -> lsp.Diagnostic:
        """As editors show it; what is about no place of a file stands at its first line."""
        span = item.span if item.span is not None else Span(source, 0, len(source.line(1)))
        message = item.message if item.hint is None else f"{item.message}\n{item.hint}"
        page = file_of(item.code)
        return lsp.Diagnostic(
            self._texts.range(span),
            message,
            severity=_SEVERITIES[item.severity],
            code=item.code,
            code_description=None if page is None else lsp.CodeDescription(page.as_uri()),
            source="asemec",
            tags=[lsp.DiagnosticTag.Unnecessary] if item.code in UNUSED else None,
            related_information=[
                lsp.DiagnosticRelatedInformation(
                    self._texts.location(program.path_of(other.span.source), other.span), other.message
                )
                for other in item.related
                if other.span.source.path != "<built in>"
            ],
            data=self._fix(program, item),
        )

    def _fix(self, program: Program, item: diagnostics.Diagnostic) -> dict[str, object] | None:
        """What fixes it, as a workspace edit's changes, for clients that apply it themselves."""
        if not item.changes:
            return None
        changes: dict[str, list[object]] = {}
        for edit in item.changes:
            uri = self._texts.uri(program.path_of(edit.span.source))
            changes.setdefault(uri, []).append(
                {"range": self._texts.plain_range(edit.span), "newText": edit.text}
            )
        return {"changes": changes}


__all__ = ["Publishing"]
