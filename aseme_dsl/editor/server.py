"""Server: the language server protocol around the functions of this room; nothing is decided here."""

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
from collections.abc import Awaitable, Callable, Iterable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, BinaryIO, Protocol, TypeVar, cast

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException, JsonRpcInvalidParams
from pygls.io_ import StdoutWriter, run_async
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from aseme_dsl import diagnostics
from aseme_dsl.compiler.pieces import InPieces
from aseme_dsl.diagnostics.pages import file_of
from aseme_dsl.diagrams import GraphvizMissing
from aseme_dsl.editor import calls, hints, hover, layout, navigation, outline, reading, rename, tokens
from aseme_dsl.editor.authoring import answer_authors
from aseme_dsl.editor.bounded_input import BoundedInput, BoundedReader, Limits
from aseme_dsl.editor.carrying import carry
from aseme_dsl.editor.diagram import Diagrams, LiveDrawing
from aseme_dsl.editor.following import Page
from aseme_dsl.editor.index import Kind, Symbol, Use
from aseme_dsl.editor.positions import Change, Lines, Position, changed
from aseme_dsl.editor.program import Program
from aseme_dsl.editor.python_answers import answer_in_python
from aseme_dsl.editor.view import View
from aseme_dsl.editor.workspace import Project, Workspace
from aseme_dsl.grammar.parts import TooSlow
from aseme_dsl.source import Source, Span

DIAGRAM, CURSOR = "aseme/diagram", "aseme/cursor"
"""A request of ours, for the drawing that belongs to a place in a file, and a notification of a place."""

VIEW = "asemec.view"
"""The command that opens a page in a browser, which follows the cursor."""

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

_SYMBOLS = {
    Kind.SYSTEM: lsp.SymbolKind.Module,
    Kind.LIBRARY: lsp.SymbolKind.Package,
    Kind.ENUM: lsp.SymbolKind.Enum,
    Kind.CONSTANT: lsp.SymbolKind.EnumMember,
    Kind.MESSAGE: lsp.SymbolKind.Struct,
    Kind.FIELD: lsp.SymbolKind.Field,
    Kind.TOPIC: lsp.SymbolKind.Namespace,
    Kind.FUNCTION: lsp.SymbolKind.Function,
    Kind.PARAMETER: lsp.SymbolKind.Variable,
    Kind.LET: lsp.SymbolKind.Constant,
    Kind.VARIABLE: lsp.SymbolKind.Variable,
    Kind.USE_CASE: lsp.SymbolKind.Interface,
    Kind.ROLE: lsp.SymbolKind.Class,
    Kind.PROTOCOL: lsp.SymbolKind.Interface,
    Kind.PARTICIPANT: lsp.SymbolKind.Class,
    Kind.ALIAS: lsp.SymbolKind.Class,
    Kind.FORMULA: lsp.SymbolKind.Method,
    Kind.ACTIVITY: lsp.SymbolKind.Function,
    Kind.OUTCOME: lsp.SymbolKind.EnumMember,
    Kind.FUNCTIONALITY: lsp.SymbolKind.Property,
    Kind.CAPABILITY: lsp.SymbolKind.Property,
    Kind.STATE: lsp.SymbolKind.Key,
    Kind.TEAM: lsp.SymbolKind.Namespace,
    Kind.AGENT: lsp.SymbolKind.Object,
}

_HIGHLIGHTS = {
    Use.DECLARATION: lsp.DocumentHighlightKind.Text,
    Use.READ: lsp.DocumentHighlightKind.Read,
    Use.WRITE: lsp.DocumentHighlightKind.Write,
}

_FOLDS = {
    "region": lsp.FoldingRangeKind.Region,
    "comment": lsp.FoldingRangeKind.Comment,
    "imports": lsp.FoldingRangeKind.Imports,
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
        async def answered(*arguments: Any) -> Any:
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
        async def answered(*arguments: Any) -> Any:
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
                        raise _outdated()
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
        changes: dict[str, list[Any]] = {}
        for edit in item.changes:
            uri = self.uri(program.path_of(edit.span.source))
            changes.setdefault(uri, []).append({"range": _plain(self, edit.span), "newText": edit.text})
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


def make_server(
    version: str, project: Project, folders: FoldersOf, reader: reading.Reader | None = None
) -> Server:
    """A server that answers every request that this room can answer."""
    server = Server(version, project, folders, reader)
    _documents(server)
    _questions(server)
    _changes(server)
    _structure(server)
    _hierarchy(server)
    _drawings(server)
    answer_authors(server)
    answer_in_python(server)
    return server


# ---- what the editor tells -------------------------------------------------------------------------


def _documents(server: Server) -> None:
    @server.feature(lsp.INITIALIZED)
    def initialized(params: lsp.InitializedParams) -> None:
        folders = server.workspace.folders.values() if server.workspace.folders else ()
        paths = [to_fs_path(folder.uri) for folder in folders] or [server.workspace.root_path]
        server.files.folders = [path for path in paths if path]
        _ask_for_news_of_files(server)

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def did_open(params: lsp.DidOpenTextDocumentParams) -> None:
        document = params.text_document
        path = server.path(document.uri)
        server.uris[path] = document.uri
        if is_python(document.uri):
            server.code[path] = document.text
            return
        server.files.open(path, document.text, document.version)
        server.soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(params: lsp.DidChangeTextDocumentParams) -> None:
        path = server.path(params.text_document.uri)
        changes = tuple(map(_change, params.content_changes))
        if is_python(params.text_document.uri):
            server.code[path] = changed(server.code.get(path, ""), changes, server.encoding)
            return
        text = server.files.text(path) or ""
        for change in changes:
            text = changed(text, (change,), server.encoding)
            server.files.open(path, text, params.text_document.version)
        server.reader.changed(path, text)
        server.soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def did_save(params: lsp.DidSaveTextDocumentParams) -> None:
        server.files.forget()
        saved = server.path(params.text_document.uri)
        for path in server.files.buffers if is_python(params.text_document.uri) else (saved,):
            server.soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(params: lsp.DidCloseTextDocumentParams) -> None:
        path = server.path(params.text_document.uri)
        if is_python(params.text_document.uri):
            server.code.pop(path, None)
            server.uris.pop(path, None)
            return
        others = [other for other in server.files.affected(path) if other != path]
        server.hush(path)
        server.files.close(path)
        server.tokens.pop(path, None)
        server.uris.pop(path, None)
        empty: list[lsp.Diagnostic] = []
        server.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(params.text_document.uri, empty)
        )
        for other in others:
            server.soon(other)
        server.hush_elsewhere()
        server.idle = asyncio.get_running_loop().call_later(IDLE, server.tidy_all)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(params: lsp.DidChangeWatchedFilesParams) -> None:
        server.files.forget()
        for path in server.files.buffers:
            server.soon(path)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(params: lsp.DidChangeWorkspaceFoldersParams) -> None:
        paths = [to_fs_path(folder.uri) for folder in server.workspace.folders.values()]
        server.files.folders = [path for path in paths if path]
        server.files.forget()
        for path in server.files.buffers:
            server.soon(path)


def _ask_for_news_of_files(server: Server) -> None:
    """Have the editor tell of files that change on disk, if it does so when asked."""
    workspace = server.client_capabilities.workspace
    watching = workspace.did_change_watched_files if workspace is not None else None
    if watching is None or not watching.dynamic_registration:
        return
    glob = "**/*.{aseme,proto,py,toml}"
    options = lsp.DidChangeWatchedFilesRegistrationOptions([lsp.FileSystemWatcher(glob)])
    registration = lsp.Registration("files", lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)
    server.client_register_capability(lsp.RegistrationParams([registration]))


def _change(item: lsp.TextDocumentContentChangeEvent) -> Change:
    if isinstance(item, lsp.TextDocumentContentChangePartial):
        start, end = item.range.start, item.range.end
        return Change(item.text, Position(start.line, start.character), Position(end.line, end.character))
    return Change(item.text)


# ---- names ---------------------------------------------------------------------------------------


def _questions(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    async def on_hover(params: lsp.HoverParams) -> lsp.Hover | None:
        place = await server.place_now(params)
        if place is None:
            return None
        found = hover.hover(*place)
        if found is None:
            return None
        return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, found.text), server.range(found.span))

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: lsp.DefinitionParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        view, offset = place
        return server.locations(navigation.definition_or_python(view, offset, _folders(server, view)))

    @server.feature(lsp.TEXT_DOCUMENT_DECLARATION)
    async def declaration(params: lsp.DeclarationParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        return server.locations(navigation.definition(*place))

    @server.feature(lsp.TEXT_DOCUMENT_IMPLEMENTATION)
    async def implementation(params: lsp.ImplementationParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        view, offset = place
        return server.locations(navigation.implementation(view, offset, _folders(server, view)))

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    async def references(params: lsp.ReferenceParams) -> list[lsp.Location] | None:
        place = await server.place(params)
        if place is None:
            return None
        view, offset = place
        declared = params.context.include_declaration
        places = navigation.references(view, offset, _folders(server, view), declaration=declared)
        return server.locations(places)

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    async def highlights(params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        server.moved(params.text_document.uri, params.position)
        found = navigation.highlights(*place)
        return [lsp.DocumentHighlight(server.range(span), _HIGHLIGHTS[use]) for span, use in found]

    @server.feature(lsp.WORKSPACE_SYMBOL)
    async def symbols(params: lsp.WorkspaceSymbolParams) -> list[lsp.SymbolInformation]:
        roots = {root for path in server.files.files() for root in server.files.roots(path)}
        programs = [await server.in_pieces(server.files.programming(root)) for root in sorted(roots)]
        return [
            lsp.SymbolInformation(
                server.location(path, span),
                symbol.name,
                _SYMBOLS.get(symbol.kind, lsp.SymbolKind.Variable),
                container_name=symbol.owner or None,
            )
            for symbol, path, span in outline.workspace_symbols(tuple(programs), params.query)
        ]


def _folders(server: Server, view: View) -> navigation.PythonFolders:
    return server.folders_of(Path(view.program.root))


# ---- changes --------------------------------------------------------------------------------------


def _changes(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare(params: lsp.PrepareRenameParams) -> lsp.Range | None:
        place = await server.place(params)
        if place is None:
            return None
        found = rename.renameable(server.files, *place)
        if isinstance(found, rename.Refused):
            raise JsonRpcInvalidParams(found.reason)
        return server.range(found)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    async def on_rename(params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
        place = await server.place(params)
        if place is None:
            return None
        folder = _folders(server, place[0]).activities
        buffers = dict(server.files.buffers)
        found = await server.in_pieces(rename.renaming(server.files, *place, params.new_name, folder))
        if buffers != server.files.buffers:
            raise _outdated()
        if isinstance(found, rename.Refused):
            raise JsonRpcInvalidParams(found.reason)
        return _renaming(server, found)

    @server.feature(lsp.TEXT_DOCUMENT_FORMATTING)
    async def formatting(params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit] | None:
        return await laid_out(params.text_document.uri)

    @server.feature(lsp.TEXT_DOCUMENT_RANGE_FORMATTING)
    async def range_formatting(params: lsp.DocumentRangeFormattingParams) -> list[lsp.TextEdit] | None:
        first, last = params.range.start.line + 1, params.range.end.line + 1
        if params.range.end.character == 0 and last > first:
            last -= 1
        return await laid_out(params.text_document.uri, first, last)

    async def laid_out(uri: str, first: int = 1, last: int | None = None) -> list[lsp.TextEdit] | None:
        source = server.text_of(uri)
        if source is None:
            return None
        found = await server.aside(layout.laying_out(source, first, last))
        now = server.text_of(uri)
        if now is None or now.text != source.text:
            raise _outdated()
        return server.text_edits(found)


def _outdated() -> JsonRpcException:
    """The answer to a question that an edit has overtaken."""
    return JsonRpcException("the text has changed meanwhile", lsp.LSPErrorCodes.ContentModified)


def _renaming(server: Server, found: rename.Renaming) -> lsp.WorkspaceEdit:
    """All edits; files get other names where the editor can do that, and else it says what is left to do."""
    edits = {
        server.uri(path): server.text_edits(changes)
        for path, changes in (*found.edits.items(), *found.code.edits.items())
    }
    moves = [(old.as_uri(), new.as_uri()) for old, new in found.code.moves]
    if not moves:
        return lsp.WorkspaceEdit(edits)
    workspace = server.client_capabilities.workspace
    able = workspace.workspace_edit if workspace is not None else None
    kinds = able.resource_operations or () if able is not None else ()
    if lsp.ResourceOperationKind.Rename not in kinds:
        for old, new in found.code.moves:
            text = f"rename the file {old} to {new.name}: your editor cannot do it for you"
            server.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Warning, text))
        return lsp.WorkspaceEdit(edits)
    versions: dict[str, int | None] = {}
    if able is not None and able.document_changes:  # it says whether versions are understood, no more
        versions = {server.uri(path): buffer.version for path, buffer in server.files.buffers.items()}
    documents = [
        lsp.TextDocumentEdit(
            lsp.OptionalVersionedTextDocumentIdentifier(uri, versions.get(uri)), list(changes)
        )
        for uri, changes in edits.items()
    ]
    return lsp.WorkspaceEdit(
        document_changes=[*documents, *(lsp.RenameFile(old_uri=old, new_uri=new) for old, new in moves)]
    )


# ---- structure -------------------------------------------------------------------------------------


def _structure(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    async def document_symbols(params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol] | None:
        view = await server.view(params.text_document.uri)
        return [_entry(server, item) for item in outline.outline(view)] if view is not None else None

    @server.feature(lsp.TEXT_DOCUMENT_FOLDING_RANGE)
    async def folding(params: lsp.FoldingRangeParams) -> list[lsp.FoldingRange] | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        return [
            lsp.FoldingRange(item.first - 1, item.last - 1, kind=_FOLDS[item.kind])
            for item in await server.in_pieces(outline.folds(view))
        ]

    @server.feature(lsp.TEXT_DOCUMENT_SELECTION_RANGE)
    async def selection(params: lsp.SelectionRangeParams) -> list[lsp.SelectionRange] | None:
        places = await server.places(params.text_document.uri, *params.positions)
        if places is None:
            return None
        view, offsets = places
        found = []
        for offset in offsets:
            around: lsp.SelectionRange | None = None
            for span in reversed(outline.selections(view, offset)):
                around = lsp.SelectionRange(server.range(span), around)
            assert around is not None
            found.append(around)
        return found

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def document_links(params: lsp.DocumentLinkParams) -> list[lsp.DocumentLink] | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        return [
            lsp.DocumentLink(server.range(span), server.uri(path)) for span, path in navigation.links(view)
        ]

    legend = lsp.SemanticTokensLegend(list(tokens.TYPES), list(tokens.MODIFIERS))

    @server.feature(
        lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL,
        lsp.SemanticTokensRegistrationOptions(
            legend=legend, full=lsp.SemanticTokensFullDelta(delta=True), range=True
        ),
    )
    async def semantic_tokens(params: lsp.SemanticTokensParams) -> lsp.SemanticTokens | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        data = await _encoded(server, view)
        return lsp.SemanticTokens(data, _remember(server, view, data))

    @server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA)
    async def semantic_tokens_delta(
        params: lsp.SemanticTokensDeltaParams,
    ) -> lsp.SemanticTokens | lsp.SemanticTokensDelta | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        data = await _encoded(server, view)
        known, before = server.tokens.get(view.path, ("", []))
        name = _remember(server, view, data)
        if known != params.previous_result_id:
            return lsp.SemanticTokens(data, name)
        if before == data:
            return lsp.SemanticTokensDelta([], name)
        start, count, inserted = tokens.difference(before, data)
        return lsp.SemanticTokensDelta([lsp.SemanticTokensEdit(start, count, inserted)], name)

    @server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE)
    async def semantic_tokens_range(params: lsp.SemanticTokensRangeParams) -> lsp.SemanticTokens | None:
        found = await server.places(params.text_document.uri, params.range.start, params.range.end)
        if found is None:
            return None
        view, (start, end) = found
        names = await server.in_pieces(tokens.tokens(view))
        within = [item for item in names if item.end > start and item.start < end]
        return lsp.SemanticTokens(await server.in_pieces(tokens.encoded(server.lines(view.source), within)))

    @server.feature(lsp.TEXT_DOCUMENT_INLAY_HINT)
    async def inlay_hints(params: lsp.InlayHintParams) -> list[lsp.InlayHint] | None:
        found = await server.places(params.text_document.uri, params.range.start, params.range.end)
        if found is None:
            return None
        view, (start, end) = found
        return [
            lsp.InlayHint(
                server.range(Span(view.source, item.offset, item.offset)).start,
                item.text,
                lsp.InlayHintKind.Type if item.is_type else None,
                padding_left=not item.is_type,
            )
            for item in hints.hints(view, start, end)
        ]

    @server.feature(lsp.TEXT_DOCUMENT_CODE_LENS)
    async def code_lens(params: lsp.CodeLensParams) -> list[lsp.CodeLens] | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        return [
            lsp.CodeLens(
                server.range(Span(item.span.source, item.span.start, item.span.start)),
                lsp.Command(item.title, item.command, arguments=[dict(item.arguments)]),
            )
            for item in hints.lenses(view)
        ]


def _entry(server: Server, item: outline.Entry) -> lsp.DocumentSymbol:
    return lsp.DocumentSymbol(
        item.name,
        _SYMBOLS.get(item.kind, lsp.SymbolKind.Variable),
        server.range(item.span),
        server.range(item.name_span),
        detail=item.detail,
        children=[_entry(server, inner) for inner in item.inside],
    )


async def _encoded(server: Server, view: View) -> list[int]:
    names = await server.in_pieces(tokens.tokens(view))
    return await server.in_pieces(tokens.encoded(server.lines(view.source), names))


def _remember(server: Server, view: View, data: Sequence[int]) -> str:
    """Keep the tokens that an editor has got, under a name that says which they are."""
    known, _ = server.tokens.get(view.path, ("0", []))
    name = str(int(known) + 1)
    server.tokens[view.path] = (name, list(data))
    return name


# ---- calls ------------------------------------------------------------------------------------------


def _hierarchy(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
    async def prepare(params: lsp.CallHierarchyPrepareParams) -> list[lsp.CallHierarchyItem] | None:
        place = await server.place(params)
        if place is None:
            return None
        found = calls.prepared(*place)
        return [_item(server, place[0].path, found)] if found is not None else None

    @server.feature(lsp.CALL_HIERARCHY_INCOMING_CALLS)
    async def incoming(
        params: lsp.CallHierarchyIncomingCallsParams,
    ) -> list[lsp.CallHierarchyIncomingCall] | None:
        path, symbol = _asked(params.item)
        view = await server.settled(path)
        if view is None:
            return None
        return [
            lsp.CallHierarchyIncomingCall(
                _item(server, path, call.other), [server.range(span) for span in call.places]
            )
            for call in calls.incoming(view.program, symbol)
        ]

    @server.feature(lsp.CALL_HIERARCHY_OUTGOING_CALLS)
    async def outgoing(
        params: lsp.CallHierarchyOutgoingCallsParams,
    ) -> list[lsp.CallHierarchyOutgoingCall] | None:
        path, symbol = _asked(params.item)
        view = await server.settled(path)
        if view is None:
            return None
        return [
            lsp.CallHierarchyOutgoingCall(
                _item(server, path, call.other), [server.range(span) for span in call.places]
            )
            for call in calls.outgoing(view.program, symbol)
        ]


def _item(server: Server, path: str, found: calls.Caller) -> lsp.CallHierarchyItem:
    symbol = found.symbol
    return lsp.CallHierarchyItem(
        symbol.name,
        _SYMBOLS.get(symbol.kind, lsp.SymbolKind.Function),
        server.uri(found.path),
        server.range(found.span),
        server.range(found.name_span),
        detail=symbol.owner or None,
        data={"view": path, "kind": symbol.kind.value, "name": symbol.name, "owner": symbol.owner},
    )


def _asked(item: lsp.CallHierarchyItem) -> tuple[str, Symbol]:
    """What an item is about: the file from which it was asked for, and the symbol."""
    data: Any = item.data
    kind, name, owner = (str(_read(data, part)) for part in ("kind", "name", "owner"))
    return str(_read(data, "view")), Symbol(Kind(kind), name, owner)


def _read(data: Any, name: str) -> Any:
    """A member of what an editor has sent back."""
    return data[name] if isinstance(data, dict) else getattr(data, name)


# ---- drawings ---------------------------------------------------------------------------------------


def _drawings(server: Server) -> None:
    page: list[Page[lsp.Position]] = []

    async def drawn(uri: str, position: lsp.Position) -> tuple[View, LiveDrawing] | None:
        """The picture for a place, with the view that it belongs to."""
        async with server.drawing:
            view = await server.view(uri)
            if view is None:
                return None
            offset = server.offset(view, position)
            view.occurrence_at(offset)  # it is looked up here: only one thread may ask the compiler's memory
            # Graphviz is another program: what is typed meanwhile is not kept waiting.
            found = await asyncio.to_thread(server.diagrams.at, view, offset)
        return None if found is None else (view, found)

    @server.feature(DIAGRAM)
    async def diagram(params: Any) -> dict[str, Any] | None:
        """The picture for a place, or null: what goes over the wire is said in docs/editor.md."""
        try:
            found = await drawn(*_asked_place(params))
        except GraphvizMissing as missing:
            raise JsonRpcException(str(missing), lsp.LSPErrorCodes.RequestFailed) from missing
        if found is None:
            return None
        view, picture = found
        return {
            "name": picture.name,
            "title": picture.title,
            "svg": picture.svg,
            "here": picture.here,
            "note": picture.note,
            "elements": {
                name: {"uri": server.uri(view.program.path_of(span.source)), "range": _plain(server, span)}
                for name, span in picture.elements.items()
            },
        }

    @server.feature(CURSOR)
    def cursor(params: Any) -> None:
        """The cursor is somewhere else."""
        server.moved(*_asked_place(params))

    async def go(view: View, span: Span) -> None:
        """Show a place in the editor."""
        uri = server.uri(view.program.path_of(span.source))
        await shown(lsp.ShowDocumentParams(uri, take_focus=True, selection=server.range(span)))

    async def shown(document: lsp.ShowDocumentParams) -> None:
        """Have the editor show something, if it can be told to."""
        window = server.client_capabilities.window
        if window is not None and window.show_document is not None and window.show_document.support:
            with contextlib.suppress(JsonRpcException):
                await server.window_show_document_async(document)

    @server.command(VIEW)
    async def view() -> str:
        """Open the page that follows the cursor; its address."""
        if not page:
            page.append(Page(drawn, go))
            server.moved = page[0].moved
            server.renewed = page[0].renew
        url = page[0].viewer.url
        await shown(lsp.ShowDocumentParams(url, external=True))
        return url


def _asked_place(params: Any) -> tuple[str, lsp.Position]:
    """The document and the position of a request of ours."""
    place = _read(params, "position")
    position = lsp.Position(int(_read(place, "line")), int(_read(place, "character")))
    return str(_read(_read(params, "textDocument"), "uri")), position


def _plain(server: Server, span: Span) -> dict[str, dict[str, int]]:
    """A range as it goes over the wire."""
    place = server.range(span)
    return {
        "start": {"line": place.start.line, "character": place.start.character},
        "end": {"line": place.end.line, "character": place.end.character},
    }


__all__ = ["CURSOR", "DIAGRAM", "VIEW", "Server", "make_server"]
