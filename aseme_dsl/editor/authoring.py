"""Authoring: the requests of an editor while somebody types; what there is to say is decided elsewhere."""

from __future__ import annotations

from typing import TYPE_CHECKING

from lsprotocol import types as lsp

from aseme_dsl.editor.completion import MOST, complete
from aseme_dsl.editor.items import Item, ItemKind
from aseme_dsl.editor.known import Known, known_in
from aseme_dsl.editor.signatures import Signature, signatures
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from aseme_dsl.editor.server import Server
    from aseme_dsl.editor.view import View

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
    """Answer completion and signature help."""
    kept: dict[str, tuple[View, Known]] = {}

    def asked(document: lsp.TextDocumentIdentifier, position: lsp.Position) -> _Asked | None:
        """The text as it is now, the offset in it, and what was known of it when it was last compiled."""
        path = server.path(document.uri)
        text, view = server.files.text(path), server.files.recent(path)
        if text is None or view is None:
            return None
        if path not in kept or kept[path][0] is not view:
            kept[path] = (view, known_in(view))
        source = Source(path, text)
        return source, server.offset_in(source, position), kept[path][1]

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, lsp.CompletionOptions(trigger_characters=list(TRIGGERS)))
    def completion(params: lsp.CompletionParams) -> lsp.CompletionList | None:
        found = asked(params.text_document, params.position)
        if found is None:
            return None
        source, offset, known = found
        typed = params.context.trigger_character if params.context is not None else None
        items = complete(source, offset, known)
        if typed == " " and not _is_wanted_after_a_blank(source.text, offset):
            items = ()
        ranges = _Ranges(server, source)
        with_snippets = _takes_snippets(server)
        return lsp.CompletionList(
            len(items) == MOST,
            [_item(ranges, number, item, with_snippets) for number, item in enumerate(items)],
        )

    @server.feature(
        lsp.TEXT_DOCUMENT_SIGNATURE_HELP,
        lsp.SignatureHelpOptions(trigger_characters=["(", ","], retrigger_characters=[")"]),
    )
    def signature_help(params: lsp.SignatureHelpParams) -> lsp.SignatureHelp | None:
        place = asked(params.text_document, params.position)
        found = signatures(*place) if place is not None else None
        if found is None:
            return None
        return lsp.SignatureHelp(
            [_signature(item) for item in found.signatures], found.active, found.parameter
        )


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
            self.made[start, end] = self.server.range(Span(self.source, start, end))
        return self.made[start, end]


def _item(ranges: _Ranges, number: int, item: Item, with_snippets: bool) -> lsp.CompletionItem:
    text = item.insert
    if item.is_snippet and not with_snippets:
        text = text.partition("$")[0].rstrip()  # as far as it is the same whatever is filled in
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


__all__ = ["answer_authors"]
