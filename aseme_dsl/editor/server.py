"""Server: answers to the requests of an editor, by the functions of this room; nothing is decided here."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException, JsonRpcInvalidParams
from pygls.uris import to_fs_path

from aseme_dsl.diagrams import GraphvizMissing
from aseme_dsl.editor.answers import calls, hints, hover, navigation, outline, tokens
from aseme_dsl.editor.answers.diagram import LiveDrawing
from aseme_dsl.editor.authoring import answer_authors
from aseme_dsl.editor.changes import layout, rename
from aseme_dsl.editor.files.index import Kind, Symbol, Use
from aseme_dsl.editor.files.positions import Change, Position, changed
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Project
from aseme_dsl.editor.following import Page
from aseme_dsl.editor.publishing import Publishing
from aseme_dsl.editor.python_answers import answer_in_python
from aseme_dsl.editor.reading import reading
from aseme_dsl.editor.session import FoldersOf, Server, is_python, outdated
from aseme_dsl.editor.showing import answer_proofs
from aseme_dsl.source import Span

DIAGRAM, CURSOR = "aseme/diagram", "aseme/cursor"
"""A request of ours, for the drawing that belongs to a place in a file, and a notification of a place."""

VIEW = "asemec.view"
"""The command that opens a page in a browser, which follows the cursor."""

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


def make_server(
    version: str,
    project: Project,
    folders: FoldersOf,
    reader: reading.Reader | None = None,
    prover: Sequence[str] = (),
) -> Server:
    """A server that answers every request that this room can; `prover` starts a process that proves."""
    server = Server(version, project, folders, reader)
    publishing = Publishing(server)
    _documents(server, publishing)
    _questions(server)
    _changes(server)
    _structure(server)
    _semantic_tokens(server)
    _notes(server)
    _hierarchy(server)
    _drawings(server, publishing)
    answer_authors(server)
    answer_in_python(server)
    if prover:
        answer_proofs(server, publishing, prover)
    return server


# ---- what the editor tells -------------------------------------------------------------------------


def _documents(server: Server, publishing: Publishing) -> None:
    @server.feature(lsp.INITIALIZED)
    def initialized(params: lsp.InitializedParams) -> None:
        folders = server.workspace.folders.values() if server.workspace.folders else ()
        paths = [to_fs_path(folder.uri) for folder in folders] or [server.workspace.root_path]
        server.files.folders = [path for path in paths if path]
        _ask_for_news_of_files(server)

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def did_open(params: lsp.DidOpenTextDocumentParams) -> None:
        document = params.text_document
        path = server.texts.path(document.uri)
        server.texts.uris[path] = document.uri
        if is_python(document.uri):
            server.texts.code[path] = document.text
            return
        server.files.open(path, document.text, document.version)
        publishing.soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(params: lsp.DidChangeTextDocumentParams) -> None:
        path = server.texts.path(params.text_document.uri)
        changes = tuple(map(_change, params.content_changes))
        if is_python(params.text_document.uri):
            server.texts.code[path] = changed(server.texts.code.get(path, ""), changes, server.encoding)
            return
        text = server.files.text(path) or ""
        for change in changes:
            text = changed(text, (change,), server.encoding)
            server.files.open(path, text, params.text_document.version)
        server.reader.changed(path, text)
        publishing.soon(path)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def did_save(params: lsp.DidSaveTextDocumentParams) -> None:
        server.files.forget()
        saved = server.texts.path(params.text_document.uri)
        for path in server.files.buffers if is_python(params.text_document.uri) else (saved,):
            publishing.soon(path)
        if server.showing is not None and saved in server.files.buffers:
            server.showing.saved(saved)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(params: lsp.DidCloseTextDocumentParams) -> None:
        path = server.texts.path(params.text_document.uri)
        if is_python(params.text_document.uri):
            server.texts.code.pop(path, None)
            server.texts.uris.pop(path, None)
            return
        others = [other for other in server.files.affected(path) if other != path]
        publishing.hush(path)
        server.files.close(path)
        server.tokens.pop(path, None)
        server.texts.uris.pop(path, None)
        empty: list[lsp.Diagnostic] = []
        server.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(params.text_document.uri, empty)
        )
        for other in others:
            publishing.soon(other)
        publishing.hush_elsewhere()
        if server.showing is not None:
            server.showing.closed()
        server.tidying.later()

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(params: lsp.DidChangeWatchedFilesParams) -> None:
        server.files.forget()
        for path in server.files.buffers:
            publishing.soon(path)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(params: lsp.DidChangeWorkspaceFoldersParams) -> None:
        paths = [to_fs_path(folder.uri) for folder in server.workspace.folders.values()]
        server.files.folders = [path for path in paths if path]
        server.files.forget()
        for path in server.files.buffers:
            publishing.soon(path)


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
        return lsp.Hover(
            lsp.MarkupContent(lsp.MarkupKind.Markdown, found.text), server.texts.range(found.span)
        )

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: lsp.DefinitionParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        view, offset = place
        return server.texts.locations(navigation.definition_or_python(view, offset, _folders(server, view)))

    @server.feature(lsp.TEXT_DOCUMENT_DECLARATION)
    async def declaration(params: lsp.DeclarationParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        return server.texts.locations(navigation.definition(*place))

    @server.feature(lsp.TEXT_DOCUMENT_IMPLEMENTATION)
    async def implementation(params: lsp.ImplementationParams) -> list[lsp.Location] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        view, offset = place
        return server.texts.locations(navigation.implementation(view, offset, _folders(server, view)))

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    async def references(params: lsp.ReferenceParams) -> list[lsp.Location] | None:
        place = await server.place(params)
        if place is None:
            return None
        view, offset = place
        declared = params.context.include_declaration
        places = navigation.references(view, offset, _folders(server, view), declaration=declared)
        return server.texts.locations(places)

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    async def highlights(params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight] | None:
        place = await server.place_now(params)
        if place is None:
            return None
        server.moved(params.text_document.uri, params.position)
        found = navigation.highlights(*place)
        return [lsp.DocumentHighlight(server.texts.range(span), _HIGHLIGHTS[use]) for span, use in found]

    @server.feature(lsp.WORKSPACE_SYMBOL)
    async def symbols(params: lsp.WorkspaceSymbolParams) -> list[lsp.SymbolInformation]:
        roots = {root for path in server.files.files() for root in server.files.roots(path)}
        programs = [await server.in_pieces(server.files.programming(root)) for root in sorted(roots)]
        return [
            lsp.SymbolInformation(
                server.texts.location(path, span),
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
        return server.texts.range(found)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    async def on_rename(params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
        place = await server.place(params)
        if place is None:
            return None
        folder = _folders(server, place[0]).activities
        buffers = dict(server.files.buffers)
        found = await server.in_pieces(rename.renaming(server.files, *place, params.new_name, folder))
        if buffers != server.files.buffers:
            raise outdated()
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
        source = server.texts.text_of(uri)
        if source is None:
            return None
        found = await server.aside(layout.laying_out(source, first, last))
        now = server.texts.text_of(uri)
        if now is None or now.text != source.text:
            raise outdated()
        return server.texts.text_edits(found)


def _renaming(server: Server, found: rename.Renaming) -> lsp.WorkspaceEdit:
    """All edits; files get other names where the editor can do that, and else it says what is left to do."""
    edits = {
        server.texts.uri(path): server.texts.text_edits(changes)
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
        versions = {server.texts.uri(path): buffer.version for path, buffer in server.files.buffers.items()}
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
                around = lsp.SelectionRange(server.texts.range(span), around)
            assert around is not None
            found.append(around)
        return found

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def document_links(params: lsp.DocumentLinkParams) -> list[lsp.DocumentLink] | None:
        view = await server.view(params.text_document.uri)
        if view is None:
            return None
        return [
            lsp.DocumentLink(server.texts.range(span), server.texts.uri(path))
            for span, path in navigation.links(view)
        ]


def _entry(server: Server, item: outline.Entry) -> lsp.DocumentSymbol:
    return lsp.DocumentSymbol(
        item.name,
        _SYMBOLS.get(item.kind, lsp.SymbolKind.Variable),
        server.texts.range(item.span),
        server.texts.range(item.name_span),
        detail=item.detail,
        children=[_entry(server, inner) for inner in item.inside],
    )


def _semantic_tokens(server: Server) -> None:
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
        return lsp.SemanticTokens(
            await server.in_pieces(tokens.encoded(server.texts.lines(view.source), within))
        )


async def _encoded(server: Server, view: View) -> list[int]:
    names = await server.in_pieces(tokens.tokens(view))
    return await server.in_pieces(tokens.encoded(server.texts.lines(view.source), names))


def _remember(server: Server, view: View, data: Sequence[int]) -> str:
    """Keep the tokens that an editor has got, under a name that says which they are."""
    known, _ = server.tokens.get(view.path, ("0", []))
    name = str(int(known) + 1)
    server.tokens[view.path] = (name, list(data))
    return name


def _notes(server: Server) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_INLAY_HINT)
    async def inlay_hints(params: lsp.InlayHintParams) -> list[lsp.InlayHint] | None:
        found = await server.places(params.text_document.uri, params.range.start, params.range.end)
        if found is None:
            return None
        view, (start, end) = found
        return [
            lsp.InlayHint(
                server.texts.range(Span(view.source, item.offset, item.offset)).start,
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
        found = [
            lsp.CodeLens(
                server.texts.range(Span(item.span.source, item.span.start, item.span.start)),
                lsp.Command(item.title, item.command, arguments=[dict(item.arguments)]),
            )
            for item in hints.lenses(view)
        ]
        return found if server.showing is None else found + server.showing.lenses(view)


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
                _item(server, path, call.other), [server.texts.range(span) for span in call.places]
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
                _item(server, path, call.other), [server.texts.range(span) for span in call.places]
            )
            for call in calls.outgoing(view.program, symbol)
        ]


def _item(server: Server, path: str, found: calls.Caller) -> lsp.CallHierarchyItem:
    symbol = found.symbol
    return lsp.CallHierarchyItem(
        symbol.name,
        _SYMBOLS.get(symbol.kind, lsp.SymbolKind.Function),
        server.texts.uri(found.path),
        server.texts.range(found.span),
        server.texts.range(found.name_span),
        detail=symbol.owner or None,
        data={"view": path, "kind": symbol.kind.value, "name": symbol.name, "owner": symbol.owner},
    )


def _asked(item: lsp.CallHierarchyItem) -> tuple[str, Symbol]:
    """What an item is about: the file from which it was asked for, and the symbol."""
    data: object = item.data
    kind, name, owner = (str(_read(data, part)) for part in ("kind", "name", "owner"))
    return str(_read(data, "view")), Symbol(Kind(kind), name, owner)


def _read(data: object, name: str) -> object:
    """A member of what an editor has sent back."""
    found: object = data[name] if isinstance(data, dict) else getattr(data, name)
    return found


# ---- drawings ---------------------------------------------------------------------------------------


def _drawings(server: Server, publishing: Publishing) -> None:
    page: list[Page[lsp.Position]] = []

    async def drawn(uri: str, position: lsp.Position) -> tuple[View, LiveDrawing] | None:
        """The picture for a place, with the view that it belongs to."""
        async with server.drawing:
            view = await server.view(uri)
            if view is None:
                return None
            offset = server.texts.offset(view, position)
            view.occurrence_at(offset)  # it is looked up here: only one thread may ask the compiler's memory
            # Graphviz is another program: what is typed meanwhile is not kept waiting.
            found = await asyncio.to_thread(server.diagrams.at, view, offset)
        return None if found is None else (view, found)

    @server.feature(DIAGRAM)
    async def diagram(params: Any) -> dict[str, object] | None:
        """The picture for a place, or null: docs/howto/editors/language-server.md has the messages."""
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
                name: {
                    "uri": server.texts.uri(view.program.path_of(span.source)),
                    "range": server.texts.plain_range(span),
                }
                for name, span in picture.elements.items()
            },
        }

    @server.feature(CURSOR)
    def cursor(params: Any) -> None:
        """The cursor is somewhere else."""
        server.moved(*_asked_place(params))

    async def go(view: View, span: Span) -> None:
        """Show a place in the editor."""
        uri = server.texts.uri(view.program.path_of(span.source))
        await shown(lsp.ShowDocumentParams(uri, take_focus=True, selection=server.texts.range(span)))

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
            publishing.renewed = page[0].renew
        url = page[0].viewer.url
        await shown(lsp.ShowDocumentParams(url, external=True))
        return url


def _asked_place(params: object) -> tuple[str, lsp.Position]:
    """The document and the position of a request of ours."""
    place = _read(params, "position")
    position = lsp.Position(int(str(_read(place, "line"))), int(str(_read(place, "character"))))
    return str(_read(_read(params, "textDocument"), "uri")), position


__all__ = ["CURSOR", "DIAGRAM", "VIEW", "Server", "make_server"]
