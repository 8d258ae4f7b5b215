"""Session: a language server with the files that are open in an editor, and what it says by itself."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import gc
import logging
import os
import stat
import sys
import threading
import time
from collections.abc import Awaitable, Callable, Iterable
from functools import lru_cache
from pathlib import Path
from typing import Any, BinaryIO, Protocol, TypeVar, cast

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.io_ import StdoutWriter, run_async
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from aseme_dsl import diagnostics
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics.pages import file_of
from aseme_dsl.editor.answers import navigation
from aseme_dsl.editor.answers.diagram import Diagrams
from aseme_dsl.editor.files.carrying import carry
from aseme_dsl.editor.files.positions import Lines, Position
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Project, Workspace
from aseme_dsl.editor.reading import reading
from aseme_dsl.editor.reading.bounded_input import BoundedInput, BoundedReader, Limits
from aseme_dsl.grammar.parsing.parts import TooSlow
from aseme_dsl.source import Source, Span

DEBOUNCE = 0.04
"""Seconds without a change after which there is something to say of a file."""

IDLE = 5.0
"""Seconds without a change after which there is time to tidy up."""

UNTIDY = 400_000
"""How many new objects, and as many as there were, make it necessary to look through all."""

PIECE = 0.008
"""Seconds for which the compiler may work before what has come in is looked at."""

BREAK = 0.001
"""Seconds in which what has come in is read, where a thread reads it: a message is read in several steps."""

STEPS = 4
"""How often the event loop goes round until a message that has come in is answered."""

_T = TypeVar("_T")

_log = logging.getLogger(__name__)

_SEVERITIES = {
    diagnostics.Severity.ERROR: lsp.DiagnosticSeverity.Error,
    diagnostics.Severity.WARNING: lsp.DiagnosticSeverity.Warning,
    diagnostics.Severity.NOTE: lsp.DiagnosticSeverity.Information,
}


class AtPlace(Protocol):
    """What a request about one place in a file is asked with."""

    text_document: lsp.TextDocumentIdentifier
    position: lsp.Position


class Server(LanguageServer):
    """A language server with the workspace that it answers for."""

    def __init__(
        self, version: str, project: Project, folders: FoldersOf, reader: reading.Reader | None = None
    ) -> None:
        super().__init__("asemec", version, text_document_sync_kind=lsp.TextDocumentSyncKind.Incremental)
        self.tell: Callable[[str], None] = _log.warning
        """Told what is refused of what the editor sends."""
        self.files = Workspace(project)
        self.reader = reader or reading.Reader()
        self.folders_of = folders
        self.waiting: dict[str, asyncio.Task[None]] = {}
        self.compiling = asyncio.Lock()
        self.tokens: dict[str, tuple[str, list[int]]] = {}
        self.uris: dict[str, str] = {}
        self.elsewhere: dict[str, dict[str, list[lsp.Diagnostic]]] = {}
        self.diagrams = Diagrams()
        self.drawing = asyncio.Lock()
        self.moved: Callable[[str, lsp.Position], None] = lambda uri, position: None
        self.renewed: Callable[[], None] = lambda: None
        self.tidies = False
        """Whether the process is the server's own, and so is Python's collector of cycles."""
        self.idle: asyncio.TimerHandle | None = None
        self.kept = self.grown = 0
        self.reads_itself = False
        self.code: dict[str, str] = {}
        self.of_python: dict[str, Callable[[Any], Awaitable[Any]]] = {}

    # ---- requests ----------------------------------------------------------------------------------

    def feature(self, feature_name: str, options: Any | None = None) -> Callable[[Any], Any]:
        """Register the answer to a request, which may have to wait for what is read elsewhere."""
        register = super().feature(feature_name, options)
        return lambda handler: register(self._patient(self._apart_from_python(feature_name, handler)))

    def command(self, command_name: str) -> Callable[[Any], Any]:
        """The same for a command."""
        register = super().command(command_name)
        return lambda handler: register(self._patient(handler))

    def _apart_from_python(self, name: str, handler: Callable[..., Any]) -> Callable[..., Any]:
        """Of the Python of activities, only some requests are answered, and those by other functions."""
        if not asyncio.iscoroutinefunction(handler):
            return handler

        @functools.wraps(handler)
        async def answered(*arguments: object) -> object:
            document = getattr(arguments[0], "text_document", None) if arguments else None
            if document is None or not is_python(document.uri):
                return await handler(*arguments)
            own = self.of_python.get(name)
            return None if own is None else await own(*arguments)

        return answered

    def _patient(self, handler: Callable[..., Any]) -> Callable[..., Any]:
        """Begins anew when what was missing has been read. Notifications are none of these coroutines."""
        if not asyncio.iscoroutinefunction(handler):
            return handler

        @functools.wraps(handler)
        async def answered(*arguments: object) -> object:
            document = getattr(arguments[0], "text_document", None) if arguments else None
            path = self.path(document.uri) if document is not None else None
            text = self.files.text(path) if path is not None else None
            try:
                while True:
                    try:
                        return await self.reading(lambda: handler(*arguments))
                    except reading.NotYet as wanted:
                        await self.reader.wait(wanted.job)
                    if path is not None and self.files.text(path) != text:
                        # Its places may not be those that are meant any more.
                        raise outdated()
            except TooSlow as slow:
                raise JsonRpcException(
                    f"the text was not read, because that takes {slow}", lsp.LSPErrorCodes.RequestFailed
                ) from slow

        return answered

    async def reading(self, work: Callable[[], Awaitable[_T]]) -> _T:
        """Some work whose parses have the budget of this server."""
        before = reading.reader.set(self.reader)
        try:
            return await work()
        finally:
            reading.reader.reset(before)

    @property
    def encoding(self) -> str:
        chosen = self.server_capabilities.position_encoding
        return str(getattr(chosen, "value", chosen) or "utf-16")

    # ---- places ----------------------------------------------------------------------------------

    def lines(self, source: Source) -> Lines:
        return _lines(source, self.encoding)

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

    async def in_pieces(self, work: InPieces[_T]) -> _T:
        """What comes out of some work of the compiler; what comes in meanwhile is answered in between."""
        async with self.compiling:
            return await self.aside(work)

    async def aside(self, work: InPieces[_T]) -> _T:
        """The same for what does not need the compiler: it does not wait for it."""
        begun = time.monotonic()
        while True:
            try:
                next(work)
            except StopIteration as end:
                return cast(_T, end.value)
            if time.monotonic() - begun > PIECE:
                await self.let_in()
                begun = time.monotonic()

    async def let_in(self) -> None:
        """Look at what has come in, and answer it."""
        if not self.reads_itself:
            await asyncio.sleep(BREAK)
            return
        # Without a pause: on a machine that has much to do it would be a long one.
        for _ in range(STEPS):
            await asyncio.sleep(0)

    def start_io(self, stdin: BinaryIO | None = None, stdout: BinaryIO | None = None) -> None:
        """Serve standard input and output, read by the event loop itself where it can read such a file.

        Other files are read by a thread, in several steps for each message, between which it has to wait.
        """
        source, target = stdin or sys.stdin.buffer, stdout or sys.stdout.buffer
        kind, other = os.fstat(source.fileno()), os.fstat(target.fileno())
        is_own = (kind.st_dev, kind.st_ino) != (other.st_dev, other.st_ino)  # it is read without blocking
        is_pipe = stat.S_ISFIFO(kind.st_mode) or stat.S_ISSOCK(kind.st_mode)
        if sys.platform == "win32" or not (is_pipe and is_own):
            given: Any = BoundedInput(source, Limits(self.tell))
            super().start_io(given, target)
            return
        self.reads_itself = True
        self.protocol.set_writer(StdoutWriter(target))
        try:
            asyncio.run(self._serve(source))
        except (BrokenPipeError, KeyboardInterrupt, SystemExit):
            _log.info("the editor is gone")
        finally:
            self.shutdown()  # type: ignore[no-untyped-call]

    async def _serve(self, source: BinaryIO) -> None:
        reader = asyncio.StreamReader()
        loop = asyncio.get_running_loop()
        await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), source)
        self._stop_event = stop = threading.Event()
        with contextlib.suppress(asyncio.IncompleteReadError):
            bounded = BoundedReader(reader, Limits(self.tell))
            await run_async(stop, bounded, self.protocol, _log, self.report_server_error)

    async def settled(self, path: str) -> View | None:
        """The file as it is, compiled."""
        return await self.in_pieces(self.files.viewing(path))

    async def view(self, uri: str) -> View | None:
        return await self.settled(self.path(uri))

    async def places(self, uri: str, *positions: lsp.Position) -> tuple[View, list[int]] | None:
        """The file as it is, compiled, and the offsets of places in the text of this moment.

        What is edited while the compiler works moves them.
        """
        path = self.path(uri)
        text = self.files.text(path)
        if text is None:
            return None
        source = self.source(path, text)
        offsets = [self.offset_in(source, position) for position in positions]
        view = await self.settled(path)
        if view is None:
            return None
        if view.source.text != source.text:
            moved = carry(source.text, view.source.text)
            offsets = [moved.forward(offset) for offset in offsets]
        return view, offsets

    async def place(self, params: AtPlace) -> tuple[View, int] | None:
        """The view and the offset that a request is about."""
        found = await self.places(params.text_document.uri, params.position)
        return None if found is None else (found[0], found[1][0])

    async def place_now(self, params: AtPlace) -> tuple[View, int] | None:
        """The same without waiting for the compiler, if it has seen the file before."""
        path = self.path(params.text_document.uri)
        if not self.files.is_known(path):
            return await self.place(params)
        view = self.files.recent(path)
        return None if view is None else (view, self.offset(view, params.position))

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

    def text_of(self, uri: str) -> Source | None:
        """The text of a file as it is at this moment."""
        path = self.path(uri)
        text = self.files.text(path)
        return None if text is None else self.source(path, text)

    def source(self, path: str, text: str) -> Source:
        """A text as the compiler reads it."""
        return _source(path, text.removeprefix("\ufeff"))

    # ---- diagnostics ------------------------------------------------------------------------------

    def soon(self, path: str) -> None:
        """Say what there is to say of a file, and of those that it concerns, when nothing changes now."""
        self.hush(path)
        if self.idle is not None:
            self.idle.cancel()
        self.waiting[path] = asyncio.create_task(self.publish(path))

    def hush(self, path: str) -> None:
        """What was to be said of a file is out of date."""
        earlier = self.waiting.pop(path, None)
        if earlier is not None:
            earlier.cancel()

    async def publish(self, path: str) -> None:
        """Send the diagnostics of a file and of all open files that they may have changed in."""
        await asyncio.sleep(DEBOUNCE)
        while True:
            try:
                await self.reading(lambda: self._publish(path))
                break
            except reading.NotYet as wanted:
                await self.reader.wait(wanted.job)
        self.waiting.pop(path, None)
        if not self.waiting:
            self.tidy_up()

    async def _publish(self, path: str) -> None:
        for other in self.files.affected(path):
            view = await self.settled(other)
            if view is not None:
                self.publish_one(other, view)
                await self.in_pieces(view.program.indexing())
        for root in self.files.roots(path):
            self.publish_elsewhere(root, await self.in_pieces(self.files.programming(root)))
        self.hush_elsewhere()
        self.renewed()

    def tidy_up(self) -> None:
        """Free what only cycles hold, of what has come since the last time (cli/lsp.py turns off all else).

        Models are many objects that live long: to look for cycles among all of them takes longer than to make
        them anew. So it is done when nobody waits, or when they have become many more.
        """
        if not self.tidies:
            return
        gc.collect()
        self.grown += len(gc.get_objects())
        gc.freeze()
        if self.grown > 4 * max(self.kept, UNTIDY):
            self.tidy_all()
        elif self.grown > max(self.kept, UNTIDY):
            self.idle = asyncio.get_running_loop().call_later(IDLE, self.tidy_all)

    def tidy_all(self) -> None:
        """Free whatever only cycles hold."""
        if not self.tidies:
            return
        gc.unfreeze()
        gc.collect()
        self.kept, self.grown = len(gc.get_objects()), 0
        gc.freeze()

    def publish_one(self, path: str, view: View) -> None:
        if path not in self.files.buffers:
            return
        found = [self.diagnostic(view.program, view.source, item) for item in view.diagnostics]
        self.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(self.uri(path), found, self.files.buffers[path].version)
        )

    def publish_elsewhere(self, root: str, program: Program | None) -> None:
        """Send what there is to say of a root's files that are not open: Python, the configuration, imports.

        None: no file of the root is open any more.
        """
        found: dict[str, list[lsp.Diagnostic]] = {}
        if program is not None:
            for item in program.diagnostics:
                path = program.place_of(item)
                if path not in self.files.buffers and Path(path).exists():
                    source = item.span.source if item.span is not None else self.source(path, "")
                    found.setdefault(path, []).append(self.diagnostic(program, source, item))
        before = self.elsewhere.pop(root, {})
        if found:
            self.elsewhere[root] = found
        for path in {*before, *found} - set(self.files.buffers):
            if before.get(path) == found.get(path):
                continue
            said: list[lsp.Diagnostic] = []
            for known in self.elsewhere.values():
                said += [item for item in known.get(path, ()) if item not in said]
            self.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(self.uri(path), said))

    def hush_elsewhere(self) -> None:
        """What was said of the files of roots that no open file belongs to any more is out of date."""
        if self.elsewhere:
            roots = {root for path in self.files.buffers for root in self.files.roots(path)}
            for root in set(self.elsewhere) - roots:
                self.publish_elsewhere(root, None)

    def diagnostic(self, program: Program, source: Source, item: diagnostics.Diagnostic) -> lsp.Diagnostic:
        """As editors show it; what is about no place of a file stands at its first line."""
        span = item.span if item.span is not None else Span(source, 0, len(source.line(1)))
        message = item.message if item.hint is None else f"{item.message}\n{item.hint}"
        page = file_of(item.code)
        return lsp.Diagnostic(
            self.range(span),
            message,
            severity=_SEVERITIES[item.severity],
            code=item.code,
            code_description=None if page is None else lsp.CodeDescription(page.as_uri()),
            source="asemec",
            tags=[lsp.DiagnosticTag.Unnecessary] if item.code in UNUSED else None,
            related_information=[
                lsp.DiagnosticRelatedInformation(
                    self.location(program.path_of(other.span.source), other.span), other.message
                )
                for other in item.related
                if other.span.source.path != "<built in>"
            ],
            data=self.fix(program, item),
        )

    def fix(self, program: Program, item: diagnostics.Diagnostic) -> dict[str, Any] | None:
        """What mends it, as a workspace edit's changes, for clients that apply it themselves."""
        if not item.changes:
            return None
        changes: dict[str, list[object]] = {}
        for edit in item.changes:
            uri = self.uri(program.path_of(edit.span.source))
            changes.setdefault(uri, []).append({"range": plain_range(self, edit.span), "newText": edit.text})
        return {"changes": changes}

    def text_edits(self, edits: Iterable[diagnostics.Edit]) -> list[lsp.TextEdit]:
        return [lsp.TextEdit(self.range(edit.span), edit.text) for edit in edits]

    def locations(self, places: Iterable[navigation.Place]) -> list[lsp.Location]:
        """Where things are now; not those whose names have been edited since the compiler has seen them."""
        found = ((place, self.now(place.path, place.span)) for place in places)
        return [
            lsp.Location(self.uri(place.path), self.range(span))
            for place, span in found
            if span.text == place.span.text
        ]


UNUSED = frozenset({"N727", "E302", "W301"})
"""Codes of what is there and never used: editors show it pale."""


def is_python(uri: str) -> bool:
    """Whether a document is Python and no `.aseme` file."""
    return uri.endswith(".py")


FoldersOf = Callable[[Path], navigation.PythonFolders]
"""Where the Python of a root's activities, functions and modules is."""


@lru_cache(maxsize=16)
def _source(path: str, text: str) -> Source:
    return Source(path, text)


@lru_cache(maxsize=64)
def _lines(source: Source, encoding: str) -> Lines:
    return Lines(source.text, encoding)


def outdated() -> JsonRpcException:
    """The answer to a question that an edit has overtaken."""
    return JsonRpcException("the text has changed meanwhile", lsp.LSPErrorCodes.ContentModified)


def plain_range(server: Server, span: Span) -> dict[str, dict[str, int]]:
    """A range as it goes over the wire."""
    place = server.range(span)
    return {
        "start": {"line": place.start.line, "character": place.start.character},
        "end": {"line": place.end.line, "character": place.end.character},
    }
