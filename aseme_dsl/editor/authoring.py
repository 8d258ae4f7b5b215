"""Authoring: the requests of an editor while the author types; other modules make the answers."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lsprotocol import types as lsp

from aseme_dsl import outside
from aseme_dsl.diagnostics import Edit
from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.diagnostics.pages import file_of
from aseme_dsl.editor.changes.actions import CLASS, Action, ActionKind, actions, carry_out
from aseme_dsl.editor.changes.activities import activity_class
from aseme_dsl.editor.changes.rewriting import Refused
from aseme_dsl.editor.files.known import Known, known_in
from aseme_dsl.editor.files.positions import Lines
from aseme_dsl.editor.typing.completion import offered
from aseme_dsl.editor.typing.items import Item, ItemKind
from aseme_dsl.editor.typing.signatures import Signature, signatures
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from aseme_dsl.editor.files.view import View
    from aseme_dsl.editor.session import Server

_Asked = tuple[Source, int, Known]

_KINDS = {
    ItemKind.WORD: lsp.CompletionItemKind.Keyword,
    ItemKind.SNIPPET: lsp.CompletionItemKind.Snippet,
    ItemKind.TOPIC: lsp.CompletionItemKind.Module,
    ItemKind.CLASS: lsp.CompletionItemKind.Unit,
    ItemKind.MESSAGE: lsp.CompletionItemKind.Struct,
    ItemKind.MEMBER: lsp.CompletionItemKind.Field,
    ItemKind.ENUM: lsp.CompletionItemKind.Enum,
    ItemKind.CONSTANT: lsp.CompletionItemKind.EnumMember,
    ItemKind.TYPE: lsp.CompletionItemKind.TypeParameter,
    ItemKind.VARIABLE: lsp.CompletionItemKind.Variable,
    ItemKind.LET: lsp.CompletionItemKind.Constant,
    ItemKind.FUNCTION: lsp.CompletionItemKind.Function,
    ItemKind.TIMER: lsp.CompletionItemKind.Variable,
    ItemKind.EVENT: lsp.CompletionItemKind.Event,
    ItemKind.PERFORMATIVE: lsp.CompletionItemKind.Event,
    ItemKind.TERM: lsp.CompletionItemKind.Value,
    ItemKind.FORMULA: lsp.CompletionItemKind.Method,
    ItemKind.ACTIVITY: lsp.CompletionItemKind.Method,
    ItemKind.FUNCTIONALITY: lsp.CompletionItemKind.Property,
    ItemKind.ROLE: lsp.CompletionItemKind.Class,
    ItemKind.ACTOR: lsp.CompletionItemKind.Class,
    ItemKind.USE_CASE: lsp.CompletionItemKind.Interface,
    ItemKind.PROTOCOL: lsp.CompletionItemKind.Interface,
    ItemKind.PARTICIPANT: lsp.CompletionItemKind.Class,
    ItemKind.AGENT: lsp.CompletionItemKind.Value,
    ItemKind.STATE: lsp.CompletionItemKind.Value,
    ItemKind.FILE: lsp.CompletionItemKind.File,
    ItemKind.NAME: lsp.CompletionItemKind.Text,
}

TRIGGERS = (".", " ", "(", "[", ":", "/", '"', "@", "=", ",")
"""Characters after which an editor asks of its own accord."""


def answer_authors(server: Server) -> None:
    """Answer all requests of this file."""
    _offer(server)
    _act(server)


def _offer(server: Server) -> None:
    """Answer completion and signature help."""
    kept: dict[str, tuple[View, Known]] = {}

    async def asked(document: lsp.TextDocumentIdentifier, position: lsp.Position) -> _Asked | None:
        """The text as it is now, the offset in it, and what was known of it when it was last compiled."""
        path = server.texts.path(document.uri)
        if not server.files.is_known(path):
            await server.settled(path)
        view = server.files.recent(path)
        if view is None:
            return None
        before = kept.get(path)
        if before is None or before[0].program is not view.program:
            before = kept[path] = (view, known_in(view))
        return view.source, server.texts.offset(view, position), before[1]

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, lsp.CompletionOptions(trigger_characters=list(TRIGGERS)))
    async def completion(params: lsp.CompletionParams) -> lsp.CompletionList | None:
        found = await asked(params.text_document, params.position)
        if found is None:
            return None
        source, offset, known = found
        typed = params.context.trigger_character if params.context is not None else None
        items, are_all = offered(source, offset, known)
        if typed == " " and not _is_wanted_after_a_blank(source.text, offset):
            items = ()
        ranges = _Ranges(server, source)
        with_snippets = _takes_snippets(server)
        return lsp.CompletionList(
            not are_all,
            [_item(ranges, number, item, with_snippets) for number, item in enumerate(items)],
        )

    @server.feature(
        lsp.TEXT_DOCUMENT_SIGNATURE_HELP,
        lsp.SignatureHelpOptions(trigger_characters=["(", ","], retrigger_characters=[")"]),
    )
    async def signature_help(params: lsp.SignatureHelpParams) -> lsp.SignatureHelp | None:
        place = await asked(params.text_document, params.position)
        found = signatures(*place) if place is not None else None
        if found is None:
            return None
        return lsp.SignatureHelp(
            [_signature(item) for item in found.signatures], found.active, found.parameter
        )


# ---- actions ---------------------------------------------------------------------------------------

CARRY_OUT = "aseme.carryOut"
"""The command that carries out a refactoring, for editors that do not ask for an action's edits."""
EXPLAIN = "aseme.explain"
"""The command that shows the page of a code, and answers with its text."""
GO_ON = "aseme.goOn"
"""The command that puts the cursor where the author has to continue writing after an action."""

_ACTION_KINDS = {
    ActionKind.QUICK_FIX: lsp.CodeActionKind.QuickFix,
    ActionKind.FIX_ALL: lsp.CodeActionKind.SourceFixAll,
    ActionKind.EXTRACT: lsp.CodeActionKind.RefactorExtract,
    ActionKind.INLINE: lsp.CodeActionKind.RefactorInline,
    ActionKind.REWRITE: lsp.CodeActionKind.RefactorRewrite,
}


def _act(server: Server) -> None:
    """Answer code actions, and carry them out."""

    @server.feature(
        lsp.TEXT_DOCUMENT_CODE_ACTION,
        lsp.CodeActionOptions(code_action_kinds=list(_ACTION_KINDS.values()), resolve_provider=True),
    )
    async def code_action(params: lsp.CodeActionParams) -> list[lsp.CodeAction] | None:
        found = await server.places(params.text_document.uri, params.range.start, params.range.end)
        if found is None:
            return None
        view, (start, end) = found
        wanted = params.context.only
        known = [
            _code_action(server, view, item, params.context.diagnostics)
            for item in actions(view, start, end, server.folders_of(Path(view.program.root)))
            if wanted is None or any(_is_of_kind(item.kind.value, kind) for kind in wanted)
        ]
        quick = ActionKind.QUICK_FIX.value
        if server.showing is None or not (wanted is None or any(_is_of_kind(quick, kind) for kind in wanted)):
            return known
        return known + server.showing.actions(view, start, end, params.context.diagnostics)

    @server.feature(lsp.CODE_ACTION_RESOLVE)
    async def resolve(params: lsp.CodeAction) -> lsp.CodeAction:
        if params.edit is None and params.data is not None:
            params.edit = _carried_out(server, params.data)
        return params

    @server.command(CARRY_OUT)
    async def carry(data: Any) -> None:
        edit = _carried_out(server, data)
        if edit is not None:
            server.workspace_apply_edit(lsp.ApplyWorkspaceEditParams(edit))

    @server.command(EXPLAIN)
    def explain(code: str) -> str | None:
        file = file_of(code)
        if file is not None and _shows_documents(server):
            server.window_show_document(lsp.ShowDocumentParams(file.as_uri(), take_focus=True))
        return outside.read_text(file) if file is not None else None

    @server.command(GO_ON)
    def go_on(uri: str, line: int, character: int) -> None:
        place = lsp.Position(line, character)
        server.window_show_document(
            lsp.ShowDocumentParams(uri, take_focus=True, selection=lsp.Range(place, place))
        )


def _is_of_kind(own: str, kind: lsp.CodeActionKind | str) -> bool:
    """Whether a kind is another or one below it (`refactor` has `refactor.extract` below it)."""
    wanted = str(getattr(kind, "value", kind))
    return own == wanted or own.startswith(f"{wanted}.")


def _code_action(server: Server, view: View, item: Action, shown: Sequence[lsp.Diagnostic]) -> lsp.CodeAction:
    made = lsp.CodeAction(item.title, kind=_ACTION_KINDS[item.kind], is_preferred=item.preferred or None)
    places = {
        (mended.code, server.texts.range(mended.span).start.line) for mended in item.mends if mended.span
    }
    made.diagnostics = [one for one in shown if (one.code, one.range.start.line) in places] or None
    if item.explains:
        made.command = lsp.Command(item.title, EXPLAIN, arguments=[item.explains])
    elif item.edits:
        made.edit = _workspace_edit(server, view, item.edits)
        if item.cursor is not None and _shows_documents(server):
            text = apply(view.source.text, item.edits)
            place = Lines(text, server.encoding).position(item.cursor)
            arguments = [server.texts.uri(view.path), place.line, place.character]
            made.command = lsp.Command(item.title, GO_ON, arguments=arguments)
    else:
        data = {"path": view.path, "name": item.name, "start": item.start, "end": item.end}
        data["text"] = _checksum(view.source.text)
        if _asks_for_edits(server):
            made.data = data
        else:
            made.command = lsp.Command(item.title, CARRY_OUT, arguments=[data])
    return made


def _carried_out(server: Server, data: object) -> lsp.WorkspaceEdit | None:
    """The edit of a refactoring; None, and a message that says why, if it cannot be done."""
    path, name = str(_part(data, "path")), str(_part(data, "name"))
    start, end = int(str(_part(data, "start"))), int(str(_part(data, "end")))
    view = server.files.view(path)
    try:
        if view is None or _checksum(view.source.text) != _part(data, "text"):
            raise Refused("the file has changed since: ask again")
        if name == CLASS:
            file, text = activity_class(view, start, server.folders_of(Path(view.program.root)))
            return _new_file(file, text)
        return _workspace_edit(server, view, carry_out(view, name, start, end))
    except Refused as reason:
        server.window_show_message(lsp.ShowMessageParams(lsp.MessageType.Warning, f"Not done: {reason}"))
        return None


def _workspace_edit(server: Server, view: View, edits: Sequence[Edit]) -> lsp.WorkspaceEdit:
    changes: dict[str, list[lsp.TextEdit]] = {}
    for edit in edits:
        uri = server.texts.uri(view.program.path_of(edit.span.source))
        changes.setdefault(uri, []).append(lsp.TextEdit(server.texts.range(edit.span), edit.text))
    return lsp.WorkspaceEdit(changes=changes)


def _new_file(path: Path, text: str) -> lsp.WorkspaceEdit:
    uri = path.as_uri()
    nowhere = lsp.Range(lsp.Position(0, 0), lsp.Position(0, 0))
    created = lsp.CreateFile(uri, options=lsp.CreateFileOptions(ignore_if_exists=True))
    document = lsp.OptionalVersionedTextDocumentIdentifier(uri)
    return lsp.WorkspaceEdit(
        document_changes=[created, lsp.TextDocumentEdit(document, [lsp.TextEdit(nowhere, text)])]
    )


def _shows_documents(server: Server) -> bool:
    """Whether the editor can be told to show a place."""
    window = server.client_capabilities.window
    return window is not None and window.show_document is not None and window.show_document.support


def _asks_for_edits(server: Server) -> bool:
    """Whether the editor asks for the edits of the action that is chosen."""
    document = server.client_capabilities.text_document
    action = document.code_action if document is not None else None
    resolved = action.resolve_support if action is not None else None
    return resolved is not None and "edit" in resolved.properties


def _checksum(text: str) -> int:
    return zlib.crc32(text.encode("utf-8", "surrogatepass"))


def _part(data: object, name: str) -> object:
    """A member of what an editor has sent back."""
    found: object = data[name] if isinstance(data, dict) else getattr(data, name)
    return found


# ---- items ------------------------------------------------------------------------------------------


def _takes_snippets(server: Server) -> bool:
    """Whether the editor can fill in snippets."""
    document = server.client_capabilities.text_document
    completion = document.completion if document is not None else None
    item = completion.completion_item if completion is not None else None
    return bool(item is not None and item.snippet_support)


def _is_wanted_after_a_blank(text: str, offset: int) -> bool:
    """Whether a blank that was just typed is likely to be followed by a name: not at the begin of a line."""
    line = text[text.rfind("\n", 0, offset) + 1 : offset]
    return bool(line.strip())


class _Ranges:
    """The ranges of items, most of which are the same."""

    def __init__(self, server: Server, source: Source) -> None:
        self.server = server
        self.source = source
        self.made: dict[tuple[int, int], lsp.Range] = {}

    def __call__(self, start: int, end: int) -> lsp.Range:
        if (start, end) not in self.made:
            self.made[start, end] = self.server.texts.range(Span(self.source, start, end))
        return self.made[start, end]


def _item(ranges: _Ranges, number: int, item: Item, with_snippets: bool) -> lsp.CompletionItem:
    text = item.insert
    if item.is_snippet and not with_snippets:
        text = text.partition("$")[0].rstrip()  # up to the first place to fill in
    return lsp.CompletionItem(
        item.label,
        kind=_KINDS[item.kind],
        detail=item.detail or None,
        documentation=(
            lsp.MarkupContent(lsp.MarkupKind.PlainText, item.documentation) if item.documentation else None
        ),
        sort_text=f"{number:04}",
        insert_text_format=(
            lsp.InsertTextFormat.Snippet
            if item.is_snippet and with_snippets
            else lsp.InsertTextFormat.PlainText
        ),
        text_edit=lsp.TextEdit(ranges(item.start, item.end), text),
        commit_characters=list(item.commit) or None,
    )


def _signature(item: Signature) -> lsp.SignatureInformation:
    return lsp.SignatureInformation(
        item.label,
        documentation=item.documentation or None,
        parameters=[lsp.ParameterInformation(place) for place in item.parameters],
    )


__all__ = ["CARRY_OUT", "EXPLAIN", "GO_ON", "answer_authors"]
