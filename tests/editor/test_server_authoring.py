"""Completion and signature help, asked by a client of a real server process."""

from __future__ import annotations

import pytest
from lsprotocol import types as lsp

from tests.editor.test_server import TEAM, Project, at, client, folder, project

__all__ = ["client", "folder", "project"]

pytestmark = pytest.mark.asyncio(loop_scope="module")


async def items(project: Project, place: lsp.Position, typed: str | None = None) -> list[lsp.CompletionItem]:
    kind = lsp.CompletionTriggerKind
    context = lsp.CompletionContext(kind.TriggerCharacter if typed else kind.Invoked, trigger_character=typed)
    found = await project.client.text_document_completion_async(
        lsp.CompletionParams(project.document(), place, context=context)
    )
    assert isinstance(found, lsp.CompletionList)
    return list(found.items)


async def test_completion_while_typing(project: Project) -> None:
    line = "    enter look    : [near]"
    typed = TEAM.replace(line, "    enter look    : [board.state.Note.")
    project.change("team.aseme", typed)
    (item,) = await items(project, at("enter look    : [board.state.Note.^", typed), ".")
    assert (item.label, item.kind, item.detail) == ("number", lsp.CompletionItemKind.Field, "int")
    assert isinstance(item.documentation, lsp.MarkupContent)
    assert item.documentation.value == "which one"


async def test_an_item_replaces_the_word(project: Project) -> None:
    found = await items(project, at("process = Give . [mo^re]"))
    item = next(item for item in found if item.label == "more")
    assert isinstance(item.text_edit, lsp.TextEdit)
    place = at("process = Give . [^more]")
    assert item.text_edit.range == lsp.Range(place, lsp.Position(place.line, place.character + len("more")))


async def test_a_snippet_has_room_for_what_must_follow(project: Project) -> None:
    project.change("team.aseme", TEAM + "\n\n")
    found = await items(project, lsp.Position(TEAM.count("\n") + 1, 0))
    item = next(item for item in found if item.label == "srm")
    assert item.insert_text_format == lsp.InsertTextFormat.Snippet
    assert item.text_edit is not None and "liveness {" in item.text_edit.new_text


async def test_a_blank_at_the_begin_of_a_line_asks_for_nothing(project: Project) -> None:
    text = TEAM.replace("  activities {\n", "  activities {\n    \n")
    project.change("team.aseme", text)
    place = at("  activities {\n    ^\n", text)
    assert await items(project, place, " ") == []
    assert await items(project, place) != []


async def test_signature_help(project: Project) -> None:
    found = await project.client.text_document_signature_help_async(
        lsp.SignatureHelpParams(project.document(), at("is_high(^board.state.Note)] / start"))
    )
    assert found is not None
    (signature,) = found.signatures
    assert signature.label == "is_high(Note note) : bool"
    assert signature.parameters is not None
    (parameter,) = signature.parameters
    assert tuple(parameter.label) == (8, 17)
    assert found.active_parameter == 0
