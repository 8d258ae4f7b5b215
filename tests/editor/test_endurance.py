"""A server that is typed at wildly goes on, says in the end what a cold check says, and stays small."""

from __future__ import annotations

import asyncio
import gc
import os
import random
import sys
from pathlib import Path

import psutil
import pytest
from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

from aseme_dsl.compiler import analyse
from aseme_dsl.editor import publishing, server
from aseme_dsl.editor.answers.navigation import PythonFolders
from aseme_dsl.editor.files.positions import Lines
from aseme_dsl.editor.files.workspace import Project
from aseme_dsl.source import Source
from tests.support.edits import KINDS, TOKENS, Edit, edited

ROOT = Path(__file__).parents[2]
EDITS = int(os.environ.get("EDITOR_EDITS", "24"))

TEXT = (ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8")


PATH = "/nowhere/team.aseme"
SERVER = server.make_server("1", Project(), lambda root: PythonFolders())
PUBLISHING = publishing.Publishing(SERVER)


def change(before: str, after: str) -> lsp.TextDocumentContentChangePartial:
    """What turns one text into the other, as an editor tells it."""
    start = 0
    while start < min(len(before), len(after)) and before[start] == after[start]:
        start += 1
    end = 0
    while end < min(len(before), len(after)) - start and before[-1 - end] == after[-1 - end]:
        end += 1
    lines = Lines(before)
    places = [lines.position(start), lines.position(len(before) - end)]
    first, last = (lsp.Position(place.line, place.character) for place in places)
    return lsp.TextDocumentContentChangePartial(lsp.Range(first, last), after[start : len(after) - end])


async def ask(
    client: LanguageClient, what: int, document: lsp.TextDocumentIdentifier, position: lsp.Position
) -> None:
    """One of several questions; any answer will do."""
    match what:
        case 0:
            await client.text_document_hover_async(lsp.HoverParams(document, position))
        case 1:
            await client.text_document_completion_async(lsp.CompletionParams(document, position))
        case 2:
            await client.text_document_definition_async(lsp.DefinitionParams(document, position))
        case 3:
            await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(document))
        case _:
            await client.text_document_semantic_tokens_full_async(lsp.SemanticTokensParams(document))


async def typed_at(path: Path, seed: int) -> tuple[list[str], list[str], int, int]:
    """The codes that the server says in the end and that a cold check says; its memory before and after."""
    client = LanguageClient("test", "1")
    said: dict[int, list[str]] = {}
    arrived = asyncio.Event()

    @client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def published(params: lsp.PublishDiagnosticsParams) -> None:
        said[params.version or 0] = [str(item.code) for item in params.diagnostics]
        arrived.set()

    await client.start_io(sys.executable, "-m", "aseme_dsl", "lsp")
    server = client._server
    assert server is not None
    await client.initialize_async(lsp.InitializeParams(lsp.ClientCapabilities()))
    client.initialized(lsp.InitializedParams())
    uri = path.as_uri()
    document = lsp.TextDocumentIdentifier(uri)
    client.text_document_did_open(lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "aseme", 1, TEXT)))
    chance = random.Random(seed)
    text, version, half = TEXT, 1, 0
    for number in range(EDITS):
        edit = Edit(
            chance.choice(KINDS), chance.randrange(1000), chance.randrange(1000), chance.choice(TOKENS)
        )
        # `\r` alone ends a line for an editor, and is a blank for us: no edit may part one from its `\n`.
        after = edited(text, edit, TEXT).replace("\r", "")
        if number % 10 == 9:
            after = TEXT
        version += 1
        client.text_document_did_change(
            lsp.DidChangeTextDocumentParams(
                lsp.VersionedTextDocumentIdentifier(version, uri), [change(text, after)]
            )
        )
        text = after
        place = Lines(text).position(chance.randrange(len(text) + 1))
        await ask(client, chance.randrange(5), document, lsp.Position(place.line, place.character))
        if number == EDITS // 2:
            half = psutil.Process(server.pid).memory_info().rss
    while version not in said:
        arrived.clear()
        await asyncio.wait_for(arrived.wait(), 60)
    end = psutil.Process(server.pid).memory_info().rss
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()
    cold = analyse(Source(str(path), text))
    return sorted(said[version]), sorted(item.code for item in cold.diagnostics), half, end


def test_a_server_that_is_typed_at_wildly_goes_on(tmp_path: Path) -> None:
    said, cold, half, end = asyncio.run(typed_at(tmp_path / "team.aseme", seed=7))
    assert said == [code for code in cold if code != "E008"] or said == cold
    if EDITS > 1000:  # nothing is settled before
        assert end < half * 1.3


async def objects_kept(edits: int, first: int) -> int:
    """How many objects a server has left after so many edits, each of which it has published."""
    text = TEXT[: TEXT.index("srm ")]
    for number in range(first, first + edits):
        SERVER.files.open(
            "/nowhere/team.aseme", f"{text}\nlet l{number} = {number} < 3 {'{' * (number % 3 == 0)}\n"
        )
        SERVER.files.recent("/nowhere/team.aseme")
        await PUBLISHING.publish("/nowhere/team.aseme")
    SERVER.tidying.tidy_all()
    return SERVER.tidying.kept


@pytest.mark.long
def test_what_a_server_keeps_does_not_grow(monkeypatch: pytest.MonkeyPatch) -> None:
    async def edited_long() -> tuple[int, int]:
        await objects_kept(70, 0)  # until as much is kept as ever
        return await objects_kept(30, 100), await objects_kept(60, 200)

    monkeypatch.setattr(publishing, "DEBOUNCE", 0)
    monkeypatch.setattr(SERVER.tidying, "tidies", True)
    monkeypatch.setattr(PUBLISHING, "_publish_one", lambda path, view: None)  # nobody is there
    try:
        before, after = asyncio.run(edited_long())
    finally:
        gc.unfreeze()
    assert after < before * 1.02
