"""Session: a language server with the files that are open in an editor, and what it says by itself."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import logging
import os
import stat
import sys
import threading
import time
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path
from typing import Any, BinaryIO, Protocol, TypeVar, cast

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.io_ import StdoutWriter, run_async
from pygls.lsp.server import LanguageServer

from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.editor.answers import navigation
from aseme_dsl.editor.answers.diagram import Diagrams
from aseme_dsl.editor.files.carrying import carry
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Project, Workspace
from aseme_dsl.editor.reading import reading
from aseme_dsl.editor.reading.bounded_input import BoundedInput, BoundedReader, Limits
from aseme_dsl.editor.texts import Texts
from aseme_dsl.editor.tidying import Tidying
from aseme_dsl.grammar.parsing.parts import TooSlow

PIECE = 0.008
"""Seconds for which the compiler may work before what has come in is looked at."""

BREAK = 0.001
"""Seconds in which what has come in is read, where a thread reads it: a message is read in several steps."""

STEPS = 4
"""How often the event loop goes round until a message that has come in is answered."""

_T = TypeVar("_T")

_log = logging.getLogger(__name__)


class AtPlace(Protocol):
    """What a request about one place in a file is asked with."""

    text_document: lsp.TextDocumentIdentifier
    position: lsp.Position


class Verdicts(Protocol):
    """What is shown of all runs of systems (see `showing`)."""

    def lenses(self, view: View) -> list[lsp.CodeLens]: ...

    def diagnostics(self, view: View) -> list[lsp.Diagnostic]: ...

    def actions(
        self, view: View, start: int, end: int, shown: Sequence[lsp.Diagnostic]
    ) -> list[lsp.CodeAction]: ...

    def saved(self, path: str) -> None: ...

    def closed(self) -> None: ...


class Server(LanguageServer):
    """A language server with the workspace that it answers for."""

    def __init__(
        self, version: str, project: Project, folders: FoldersOf, reader: reading.Reader | None = None
    ) -> None:
        super().__init__("asemec", version, text_document_sync_kind=lsp.TextDocumentSyncKind.Incremental)
        self.tell: Callable[[str], None] = _log.warning
        """Told what is refused of what the editor sends."""
        self.files = Workspace(project)
        self.texts = Texts(self.files, lambda: self.encoding)
        self.reader = reader or reading.Reader()
        self.folders_of = folders
        self.compiling = asyncio.Lock()
        self.tokens: dict[str, tuple[str, list[int]]] = {}
        self.diagrams = Diagrams()
        self.drawing = asyncio.Lock()
        self.moved: Callable[[str, lsp.Position], None] = lambda uri, position: None
        self.tidying = Tidying()
        self.showing: Verdicts | None = None
        """What is known of all runs; None: nothing is proved."""
        self.reads_itself = False
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
            path = self.texts.path(document.uri) if document is not None else None
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
            _log.info("the editor has closed the connection")
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
        return await self.settled(self.texts.path(uri))

    async def places(self, uri: str, *positions: lsp.Position) -> tuple[View, list[int]] | None:
        """The file as it is, compiled, and the offsets of places in the text of this moment.

        What is edited while the compiler works moves them.
        """
        path = self.texts.path(uri)
        text = self.files.text(path)
        if text is None:
            return None
        source = self.texts.source(path, text)
        offsets = [self.texts.offset_in(source, position) for position in positions]
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
        path = self.texts.path(params.text_document.uri)
        if not self.files.is_known(path):
            return await self.place(params)
        view = self.files.recent(path)
        return None if view is None else (view, self.texts.offset(view, params.position))


def is_python(uri: str) -> bool:
    """Whether a document is Python and no `.aseme` file."""
    return uri.endswith(".py")


FoldersOf = Callable[[Path], navigation.PythonFolders]
"""Where the Python of a root's activities, functions and modules is."""


def outdated() -> JsonRpcException:
    """The answer to a question that an edit has overtaken."""
    return JsonRpcException("the text has changed meanwhile", lsp.LSPErrorCodes.ContentModified)
