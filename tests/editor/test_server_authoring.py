"""Completion and signature help, asked by a client of a real server process."""

from __future__ import annotations

import asyncio
from ast import literal_eval
from collections.abc import Sequence

import pytest
from lsprotocol import types as lsp

from aseme_dsl.editor.authoring import EXPLAIN, GO_ON
from aseme_dsl.editor.files.positions import Lines, Position
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


# ---- actions -------------------------------------------------------------------------------------


async def actions(
    project: Project, place: lsp.Range, *only: str, diagnostics: Sequence[lsp.Diagnostic] = ()
) -> list[lsp.CodeAction]:
    context = lsp.CodeActionContext(list(diagnostics), only=list(only) or None)
    found = await project.client.text_document_code_action_async(
        lsp.CodeActionParams(project.document(), place, context)
    )
    return list(found or ())


def between(first: str, last: str, text: str = TEAM) -> lsp.Range:
    return lsp.Range(at(first, text), at(last, text))


def written(project: Project, edit: lsp.WorkspaceEdit | None, text: str = TEAM) -> str:
    """The text of the file after an edit."""
    assert edit is not None and edit.changes is not None
    lines = Lines(text)
    for item in reversed(sorted(edit.changes[project.uri()], key=lambda one: one.range.start.line)):
        start, end = item.range.start, item.range.end
        before = lines.offset(Position(start.line, start.character))
        behind = lines.offset(Position(end.line, end.character))
        text = text[:before] + item.new_text + text[behind:]
    return text


async def test_a_mistake_is_mended(project: Project) -> None:
    text = TEAM.replace("[near]", "[naer]")
    project.change("team.aseme", text)
    shown = [item for item in await project.diagnostics("team.aseme") if item.code == "E200"]
    found = await actions(project, between("[^naer]", "[naer^]", text), diagnostics=shown)
    assert found[0].title == "Write `near` instead of `naer`"
    assert found[0].is_preferred and list(found[0].diagnostics or ()) == shown
    assert written(project, found[0].edit, text) == TEAM


async def test_a_code_is_explained(project: Project) -> None:
    project.change("team.aseme", TEAM.replace("[near]", "[naer]"))
    found = await actions(project, between("[^near]", "[^near]"), "quickfix")
    assert found[-1].title == "Explain E200: unknown name"
    said = await project.client.workspace_execute_command_async(
        lsp.ExecuteCommandParams(EXPLAIN, arguments=["E200"])
    )
    assert isinstance(said, str) and "```aseme wrong" in said


async def test_a_problem_is_allowed_and_the_cursor_stands_where_the_reason_is_missing(
    project: Project,
) -> None:
    text = TEAM + "srm extra {\n  liveness { extra = A . B | C }\n}\n"
    project.change("team.aseme", text)
    place = at("extra = A . B ^| C", text)
    (action,) = [
        item
        for item in await actions(project, lsp.Range(place, place), "quickfix")
        if item.title.startswith("Allow W300")
    ]
    # lsprotocol reads an action that has a command as one, whose name is then the text of the real one.
    command = literal_eval(str(action.command))
    assert command["command"] == GO_ON
    line = "  liveness { extra"
    allowed = text.replace(line, f"  // asemec: allow(W300) \n{line}")
    project.change("team.aseme", allowed)
    await project.client.workspace_execute_command_async(
        lsp.ExecuteCommandParams(GO_ON, arguments=command["arguments"])
    )
    document = project.client.shown_documents[-1]
    place = at("// asemec: allow(W300) ^\n", allowed)
    assert (document.uri, document.selection) == (project.uri(), lsp.Range(place, place))


async def test_a_part_of_a_formula_gets_a_name(project: Project) -> None:
    (action,) = await actions(project, between("(^look | handing | taker)~", "(look | handing | taker^)~"))
    assert action.title == "Make a formula of what is selected" and action.edit is None
    resolved = await project.client.code_action_resolve_async(action)
    changed = written(project, resolved.edit)
    assert "keeper = look_part~\n    look_part = look | handing | taker\n" in changed


async def test_a_formula_is_written_where_it_is_used(project: Project) -> None:
    place = at("    ^look = Scan")
    found = await actions(project, lsp.Range(place, place), "refactor.inline")
    (action,) = [item for item in found if item.title == "Write `look` where it is used"]
    resolved = await project.client.code_action_resolve_async(action)
    changed = written(project, resolved.edit)
    assert "look = Scan" not in changed and "control look {" not in changed and "Scan . [Jump]" in changed


async def test_every_transition_gets_a_control_line(project: Project) -> None:
    place = at("control ^look {")
    found = await actions(project, lsp.Range(place, place))
    (action,) = [item for item in found if "control line" in item.title]
    resolved = await project.client.code_action_resolve_async(action)
    changed = written(project, resolved.edit)
    assert changed.count("enter Scan") == 1 and "enter Scan" not in TEAM


async def test_what_cannot_be_done_is_said(project: Project) -> None:
    (action,) = await actions(project, between("(^look | handing | taker)~", "(look | handing^ | taker)~"))
    message = asyncio.ensure_future(
        project.client.protocol.wait_for_notification_async(lsp.WINDOW_SHOW_MESSAGE)
    )
    await asyncio.sleep(0)
    resolved = await project.client.code_action_resolve_async(action)
    assert resolved.edit is None
    said = await asyncio.wait_for(message, 60)
    assert said.message == "Not done: some of the branches of `|` would mean something else alone"


async def test_an_activity_gets_its_class(project: Project) -> None:
    place = at("[^Jump]")
    found = await actions(project, lsp.Range(place, place), "refactor")
    action = next(item for item in found if item.title == "Write the Python class of `Jump`")
    resolved = await project.client.code_action_resolve_async(action)
    assert resolved.edit is not None and resolved.edit.document_changes is not None
    created, filled = resolved.edit.document_changes
    assert isinstance(created, lsp.CreateFile) and created.uri.endswith("/act/jump.py")
    assert isinstance(filled, lsp.TextDocumentEdit)
    assert "class Jump" in str(filled.edits[0].new_text)
    place = at("look = ^Scan")
    found = await actions(project, lsp.Range(place, place), "refactor")
    assert not any(item.title.startswith("Write the Python class") for item in found)


async def test_an_expression_of_kse_is_translated(project: Project) -> None:
    text = TEAM.replace("[near]", "[TimeoutCheck(pace) && near]/process_messages")
    assert text != TEAM
    project.change("team.aseme", text)
    shown = [item for item in await project.diagnostics("team.aseme") if item.code == "E118"]
    found = await actions(project, between("[^TimeoutCheck", "process^_messages", text), diagnostics=shown)
    assert list(found[0].diagnostics or ()) == shown
    changed = written(project, found[0].edit, text)
    assert changed == TEAM.replace("[near]", "[expired(pace) && near] / read_messages")
