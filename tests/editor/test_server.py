"""Every request of the language server, asked by a client of a real server process."""

from __future__ import annotations

import asyncio
import itertools
import subprocess
import sys
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.client import LanguageClient as BaseLanguageClient
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from aseme_dsl.editor.answers.tokens import TYPES
from aseme_dsl.editor.files.positions import Lines
from tests.editor.test_viewer import Browser

pytestmark = pytest.mark.asyncio(loop_scope="module")

TEAM = """\
system Team
import "shared.aseme"
import soccer

// How often somebody has tried. 🤖
let near = vision.state.Ball.distance < 3

aip swap {
  participant giver {
    engage "always"
    var tries : int = 0
    sends inform Note
    process = Give . [more]
    more = Give . Rest
  }
  participant taker { engage "always"  receives inform Note  process = Take }
  control giver {
    enter Give : / send inform Note to taker; tries = tries + 1
    enter more : [tries < 2]
    skip more : else
  }
  control taker { enter Take : inform Note from giver }
}

srm keeper {
  plays swap.giver as handing with Give = Hand
  plays swap.taker
  liveness {
    keeper = (look | handing | taker)~
    look = Scan . [Jump]
  }
  activities {
    Scan uses camera writes board.state.Note
    Jump takes 1s
  }
  functionality camera { technology "eye" }
  control keeper {
    enter look    : [near]
    enter handing : [board.state.Note.number == 1]
    enter taker   : else
  }
  control look {
    enter Jump : [is_high(board.state.Note)] / start_timer(pace, 1s)
    skip Jump : [expired(pace)]
  }
}
team Team { robot1 : keeper }
"""

SHARED = """\
// What is written on the board.
message Note {
  int number  // which one
}
topic board { state Note }
function is_high(Note note) : bool = "judge:is_high"
"""

SCAN = '''\
"""Scan."""


class Scan:
    def run(self, context): ...
'''


VERSIONS = itertools.count(1)
"""So that what is said of a text is never taken for what is said of that of another test."""


class Project:
    """A project on disk that a server has open."""

    def __init__(self, folder: Path, client: LanguageClient) -> None:
        self.folder = folder
        self.client = client
        self.versions: dict[str, int] = {}
        self._published = published_by(client)
        self._seen = len(self._published)

    def uri(self, name: str = "team.aseme") -> str:
        return (self.folder / name).as_uri()

    def document(self, name: str = "team.aseme") -> lsp.TextDocumentIdentifier:
        return lsp.TextDocumentIdentifier(self.uri(name))

    def open(self, name: str, text: str) -> None:
        self.versions[name] = next(VERSIONS)
        self.client.text_document_did_open(
            lsp.DidOpenTextDocumentParams(
                lsp.TextDocumentItem(self.uri(name), "aseme", self.versions[name], text)
            )
        )

    def change(self, name: str, text: str, place: lsp.Range | None = None) -> None:
        self.versions[name] = next(VERSIONS)
        change: lsp.TextDocumentContentChangeEvent = (
            lsp.TextDocumentContentChangeWholeDocument(text)
            if place is None
            else lsp.TextDocumentContentChangePartial(place, text)
        )
        self.client.text_document_did_change(
            lsp.DidChangeTextDocumentParams(
                lsp.VersionedTextDocumentIdentifier(self.versions[name], self.uri(name)), [change]
            )
        )

    def close(self, name: str) -> None:
        self.client.text_document_did_close(lsp.DidCloseTextDocumentParams(self.document(name)))

    async def settled(self, name: str = "team.aseme") -> None:
        """Wait until the server has compiled the text as it is now: some answers do not wait for that."""
        await self.client.text_document_document_symbol_async(lsp.DocumentSymbolParams(self.document(name)))

    async def diagnostics(self, name: str, errors: int = 1) -> list[lsp.Diagnostic]:
        """The diagnostics of the text as it is now, as soon as there are so many errors among them.

        Activities without a file, of which the project has some, do not count.
        What the server says of a file may come again when another one has changed.
        """
        async with asyncio.timeout(60):
            while True:
                for found in self._published[self._seen :]:
                    self._seen += 1
                    wrong = [item for item in found.diagnostics if item.severity == 1 and item.code != "E543"]
                    is_current = found.uri == self.uri(name) and found.version == self.versions[name]
                    if is_current and len(wrong) == errors:
                        return list(found.diagnostics)
                await asyncio.sleep(0.02)


def published_by(client: LanguageClient) -> list[lsp.PublishDiagnosticsParams]:
    """What the server says of files, in its order, from the first time on that this is asked: all of it.

    Who waits for one message after the other misses what comes together with the one before.
    """
    if not hasattr(client, "published"):
        published: list[lsp.PublishDiagnosticsParams] = []

        def keep(found: lsp.PublishDiagnosticsParams) -> None:
            published.append(found)
            client.protocol.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS, keep)

        client.protocol.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS, keep)
        client.published = published  # type: ignore[attr-defined]
    return client.published  # type: ignore[attr-defined,no-any-return]


def at(marked: str, text: str = TEAM) -> lsp.Position:
    """The place of the `^` in a piece of the text."""
    before, _, after = marked.partition("^")
    offset = text.index(before + after) + len(before)
    place = Lines(text).position(offset)
    return lsp.Position(place.line, place.character)


def shown(text: str, place: lsp.Range) -> str:
    """The text of a range."""
    lines = text.split("\n")
    assert place.start.line == place.end.line
    line = lines[place.start.line].encode("utf-16-le")
    return line[2 * place.start.character : 2 * place.end.character].decode("utf-16-le")


def asked_to_watch(client: LanguageClient) -> list[lsp.Registration]:
    """What the server asks an editor to tell of, as it asks."""
    registered: list[lsp.Registration] = []

    @client.feature(lsp.CLIENT_REGISTER_CAPABILITY)
    def register(params: lsp.RegistrationParams) -> None:
        registered.extend(params.registrations)

    return registered


@pytest_lsp.fixture(
    config=ClientServerConfig(server_command=[sys.executable, "-m", "aseme_dsl", "lsp"]), scope="module"
)
async def client(lsp_client: LanguageClient, folder: Path) -> AsyncIterator[None]:
    asked_to_watch(lsp_client)
    await lsp_client.initialize_session(
        lsp.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[lsp.WorkspaceFolder(folder.as_uri(), "team")],
        )
    )
    yield
    await lsp_client.shutdown_session()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("project")
    (made / "team.aseme").write_text(TEAM, "utf-8")
    (made / "shared.aseme").write_text(SHARED, "utf-8")
    (made / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["team.aseme"]\nactivities = "act"\n', "utf-8"
    )
    (made / "act").mkdir()
    (made / "act/scan.py").write_text(SCAN, "utf-8")
    (made / "judge.py").write_text("def is_high(note):\n    return True\n", "utf-8")
    return made


@pytest.fixture
def project(client: LanguageClient, folder: Path) -> Project:
    made = Project(folder, client)
    made.open("team.aseme", TEAM)
    return made


async def hovered(project: Project, marked: str) -> str:
    await project.settled()
    found = await project.client.text_document_hover_async(lsp.HoverParams(project.document(), at(marked)))
    assert found is not None and isinstance(found.contents, lsp.MarkupContent)
    return found.contents.value


async def test_diagnostics_come_while_typing_and_go(project: Project) -> None:
    project.change("team.aseme", TEAM.replace("[near]", "[neer]"))
    found = await project.diagnostics("team.aseme")
    mistake = next(item for item in found if item.code == "E200")
    assert shown(TEAM.replace("[near]", "[neer]"), mistake.range) == "neer"
    assert mistake.severity is lsp.DiagnosticSeverity.Error
    assert mistake.code_description is not None and mistake.code_description.href.endswith("/E200.md")
    assert mistake.data is not None  # the fix
    project.change("team.aseme", TEAM)
    await project.diagnostics("team.aseme", errors=0)


async def test_diagnostics_have_related_places(project: Project) -> None:
    twice = TEAM.replace("team Team {", "let near = true\nteam Team {")
    project.change("team.aseme", twice)
    found = await project.diagnostics("team.aseme")
    mistake = next(item for item in found if item.code == "E201")
    assert [shown(twice, item.location.range) for item in mistake.related_information or ()] == ["near"]


async def test_diagnostics_come_in_files_that_import_the_changed_one(project: Project) -> None:
    project.open("shared.aseme", SHARED)
    project.change("shared.aseme", SHARED.replace("int number", "int numero"))
    found = await project.diagnostics("team.aseme")
    assert [shown(TEAM, item.range) for item in found if item.severity == 1] == ["number"]
    project.close("shared.aseme")
    await project.diagnostics("team.aseme", errors=0)


async def test_incremental_changes_count_in_utf16(project: Project) -> None:
    line = next(n for n, text in enumerate(TEAM.split("\n")) if "🤖" in text)
    end = len(TEAM.split("\n")[line]) + 1
    project.change(
        "team.aseme", "\nlet far = neer", lsp.Range(lsp.Position(line, end), lsp.Position(line, end))
    )
    found = await project.diagnostics("team.aseme")
    mistake = next(item for item in found if item.code == "E200")
    assert (mistake.range.start.line, mistake.range.start.character) == (line + 1, 10)


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("[^near]", ["let near : bool = vision.state.Ball.distance < 3", "How often somebody has tried. 🤖"]),
        ("board.state.Note.^number", ["int number", "which one"]),
        ("board.state.^Note.number", ["message Note", "What is written on the board.", "board.state.Note"]),
        ("[^board.state.Note.number", ["topic board", "Written by `Scan`", "`control keeper` of keeper"]),
        ("look = ^Scan", ["Scan uses camera", "State `0.2.3.2` of keeper"]),
        ("enter ^Jump", ["Jump takes 1s", "of keeper"]),
        ("(^look", ["look = Scan . [Jump]", "State `0.2.3` of keeper"]),
        ("plays swap.^giver", ["participant giver", "Engages: always", "Sends `inform Note`"]),
        ("[^is_high", ["function is_high(Note note) : bool", "judge:is_high"]),
        ("expired(^pace", ["Timer `pace`", "1s"]),
        ("[^tries", ["var tries : int = 0"]),
        ("uses ^camera", ["Technology: eye"]),
        ("^expired", ["expired(timer)"]),
    ],
)
async def test_hover(project: Project, marked: str, expected: list[str]) -> None:
    text = await hovered(project, marked)
    for part in expected:
        assert part in text


async def test_hover_explains_a_code_in_a_comment(project: Project) -> None:
    text = "// asemec: allow-file(W300) so it is\n" + TEAM
    project.change("team.aseme", text)
    found = await project.client.text_document_hover_async(
        lsp.HoverParams(project.document(), at("(^W300", text))
    )
    assert found is not None and "mixed operators without parentheses" in found.contents.value


async def places(project: Project, found: object) -> list[tuple[str, str]]:
    """Locations as the names of files with the text of the line."""
    made = []
    for item in found or ():  # type: ignore[attr-defined]
        path = Path(item.uri.removeprefix("file://"))
        made.append((path.name, path.read_text("utf-8").split("\n")[item.range.start.line].strip()))
    return made


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("(^look |", ("team.aseme", "look = Scan . [Jump]")),
        ("board.state.Note.^number", ("shared.aseme", "int number  // which one")),
        (
            "plays swap.^taker",
            ("team.aseme", 'participant taker { engage "always"  receives inform Note  process = Take }'),
        ),
        ("vision.state.^Ball", ("soccer.aseme", "message Ball {")),
        ('import "^shared', ("shared.aseme", "// What is written on the board.")),
        ("enter ^Jump", ("team.aseme", "Jump takes 1s")),
        ("robot1 : ^keeper", ("team.aseme", "srm keeper {")),
    ],
)
async def test_definition(project: Project, marked: str, expected: tuple[str, str]) -> None:
    parameters = lsp.DefinitionParams(project.document(), at(marked))
    found = await project.client.text_document_definition_async(parameters)
    assert await places(project, found) == [expected]
    also = await project.client.text_document_declaration_async(
        lsp.DeclarationParams(project.document(), at(marked))
    )
    assert also == found


async def test_implementation_is_in_python(project: Project) -> None:
    for marked, expected in (
        ("look = ^Scan", ("scan.py", "class Scan:")),
        ("[^is_high", ("judge.py", "def is_high(note):")),
    ):
        parameters = lsp.ImplementationParams(project.document(), at(marked))
        found = await project.client.text_document_implementation_async(parameters)
        assert await places(project, found) == [expected]


async def test_a_target_leads_to_python(project: Project) -> None:
    project.open("shared.aseme", SHARED)
    parameters = lsp.DefinitionParams(project.document("shared.aseme"), at('"judge:^is_high', SHARED))
    found = await project.client.text_document_definition_async(parameters)
    assert await places(project, found) == [("judge.py", "def is_high(note):")]
    project.close("shared.aseme")


async def test_references_in_all_files(project: Project) -> None:
    parameters = lsp.ReferenceParams(lsp.ReferenceContext(True), project.document(), at("state.Note.^number"))
    found = await project.client.text_document_references_async(parameters)
    assert await places(project, found) == [
        ("shared.aseme", "int number  // which one"),
        ("team.aseme", "enter handing : [board.state.Note.number == 1]"),
    ]
    parameters.context.include_declaration = False
    found = await project.client.text_document_references_async(parameters)
    assert [name for name, _ in await places(project, found)] == ["team.aseme"]


async def test_highlights(project: Project) -> None:
    parameters = lsp.DocumentHighlightParams(project.document(), at("[^tries"))
    found = await project.client.text_document_document_highlight_async(parameters) or ()
    kinds = lsp.DocumentHighlightKind
    assert [item.kind for item in found] == [kinds.Text, kinds.Write, kinds.Read, kinds.Read]


def applied(text: str, edits: list[lsp.TextEdit]) -> str:
    lines = Lines(text)

    def offset(place: lsp.Position) -> int:
        from aseme_dsl.editor.files.positions import Position

        return lines.offset(Position(place.line, place.character))

    for edit in sorted(edits, key=lambda item: offset(item.range.start), reverse=True):
        text = text[: offset(edit.range.start)] + edit.new_text + text[offset(edit.range.end) :]
    return text


async def test_rename_changes_all_files(project: Project) -> None:
    where = at("state.Note.^number")
    prepared = await project.client.text_document_prepare_rename_async(
        lsp.PrepareRenameParams(project.document(), where)
    )
    assert isinstance(prepared, lsp.Range) and shown(TEAM, prepared) == "number"
    found = await project.client.text_document_rename_async(
        lsp.RenameParams(project.document(), where, "count")
    )
    assert found is not None and found.changes is not None
    assert applied(TEAM, found.changes[project.uri()]) == TEAM.replace("Note.number", "Note.count")
    shared = applied(SHARED, found.changes[project.uri("shared.aseme")])
    assert shared == SHARED.replace("int number", "int count")


async def test_an_activity_is_renamed_with_its_file_and_class(project: Project) -> None:
    where = at("look = ^Scan")
    found = await project.client.text_document_rename_async(
        lsp.RenameParams(project.document(), where, "LookAround")
    )
    assert found is not None and found.document_changes is not None
    edits = {
        item.text_document.uri: [edit for edit in item.edits if isinstance(edit, lsp.TextEdit)]
        for item in found.document_changes
        if isinstance(item, lsp.TextDocumentEdit)
    }
    assert applied(TEAM, edits[project.uri()]) == TEAM.replace("Scan", "LookAround")
    assert applied(SCAN, edits[project.uri("act/scan.py")]) == SCAN.replace("class Scan", "class LookAround")
    moved = found.document_changes[-1]
    assert isinstance(moved, lsp.RenameFile)
    assert (moved.old_uri, moved.new_uri) == (project.uri("act/scan.py"), project.uri("act/look_around.py"))


@pytest.mark.parametrize(
    ("marked", "name", "reason"),
    [
        ("[^tries", "for ever", "is not a name"),
        ("(^look |", "handing", "handing"),
        ("look = ^Scan", "Jump", "there is an activity `Jump` already"),
        ("[^tries", "true", "true"),
        ("vision.state.^Ball", "Sphere", "the standard library declares it"),
        ("^process = Give", "x", "a word of the language"),
        ("[^board", "vision", "there is a topic `vision` already"),
    ],
)
async def test_rename_is_refused_with_the_reason(
    project: Project, marked: str, name: str, reason: str
) -> None:
    with pytest.raises(JsonRpcException, match=reason):
        await project.client.text_document_rename_async(
            lsp.RenameParams(project.document(), at(marked), name)
        )


async def test_document_symbols(project: Project) -> None:
    found = await project.client.text_document_document_symbol_async(
        lsp.DocumentSymbolParams(project.document())
    )
    tree = {item.name: item for item in found or ()}
    assert list(tree) == ["Team", "near", "swap", "keeper"]
    swap = tree["swap"]
    assert [item.name for item in swap.children or ()] == ["giver", "taker"]
    giver = (swap.children or ())[0]
    assert {item.name for item in giver.children or ()} == {"tries", "process", "more"}


async def test_workspace_symbols(project: Project) -> None:
    found = await project.client.workspace_symbol_async(lsp.WorkspaceSymbolParams("ishi"))
    assert [(item.name, Path(item.location.uri).name) for item in found or ()] == [
        ("is_high", "shared.aseme")
    ]


async def test_semantic_tokens_full_and_their_difference(project: Project) -> None:
    whole = await project.client.text_document_semantic_tokens_full_async(
        lsp.SemanticTokensParams(project.document())
    )
    assert whole is not None and len(whole.data) % 5 == 0
    lines = TEAM.split("\n")
    found = []
    line = character = 0
    for index in range(0, len(whole.data), 5):
        down, right, length, kind, _ = whole.data[index : index + 5]
        line, character = line + down, right if down else character + right
        found.append((lines[line][character : character + length], TYPES[kind]))
    assert ("Note", "struct") in found and ("number", "property") in found and ("Scan", "function") in found

    changed = TEAM.replace("enter look    : [near]", "enter look    : [!near]")
    project.change("team.aseme", changed)
    difference = await project.client.text_document_semantic_tokens_full_delta_async(
        lsp.SemanticTokensDeltaParams(project.document(), whole.result_id or "")
    )
    assert isinstance(difference, lsp.SemanticTokensDelta)
    data = list(whole.data)
    for edit in difference.edits:
        data[edit.start : edit.start + edit.delete_count] = edit.data or []
    again = await project.client.text_document_semantic_tokens_full_async(
        lsp.SemanticTokensParams(project.document())
    )
    assert again is not None and data == list(again.data)


async def test_semantic_tokens_of_some_lines(project: Project) -> None:
    place = at("^let near")
    end = lsp.Position(place.line + 1, 0)
    found = await project.client.text_document_semantic_tokens_range_async(
        lsp.SemanticTokensRangeParams(project.document(), lsp.Range(place, end))
    )
    assert found is not None
    assert [TYPES[kind] for kind in found.data[3::5]] == "variable namespace keyword struct property".split()
    assert found.data[0] == place.line and not any(found.data[5::5])


async def test_what_is_asked_right_after_an_edit_is_answered_at_the_places_of_now(project: Project) -> None:
    await project.settled()
    above, text = at("^let near"), TEAM.replace("let near", "// two\n// lines\n\nlet near")
    project.change("team.aseme", "// two\n// lines\n\n", lsp.Range(above, above))
    end = at("taker   : else^", text)
    project.change("team.aseme", "", lsp.Range(lsp.Position(end.line, end.character - 1), end))
    text = text.replace("taker   : else", "taker   : els")
    asked = lsp.HoverParams(project.document(), at("control ^look {", text))
    early = await project.client.text_document_hover_async(asked)
    assert early is not None and early.range is not None and shown(text, early.range) == "look"
    places = await project.client.text_document_definition_async(
        lsp.DefinitionParams(project.document(), at("control ^look {", text))
    )
    assert isinstance(places, list) and isinstance(places[0], lsp.Location)
    assert places[0].range.start == at("    ^look = Scan", text)
    await project.settled()
    assert await project.client.text_document_hover_async(asked) == early


async def test_folding(project: Project) -> None:
    found = await project.client.text_document_folding_range_async(lsp.FoldingRangeParams(project.document()))
    lines = TEAM.split("\n")
    folded = {lines[item.start_line].strip(): lines[item.end_line + 1].strip() for item in found or ()}
    assert folded["srm keeper {"] == "}"
    assert folded["liveness {"] == "}"


async def test_selection_grows(project: Project) -> None:
    found = await project.client.text_document_selection_range_async(
        lsp.SelectionRangeParams(project.document(), [at("[^tries")])
    )
    texts = []
    around = (found or [])[0]
    while around is not None:
        if around.range.start.line == around.range.end.line:
            texts.append(shown(TEAM, around.range))
        around = around.parent
    assert texts[:3] == ["tries", "tries < 2", "[tries < 2]"]


async def test_formatting_lays_the_file_out(project: Project) -> None:
    options = lsp.FormattingOptions(2, True)
    edits = await project.client.text_document_formatting_async(
        lsp.DocumentFormattingParams(project.document(), options)
    )
    text = applied(TEAM, list(edits or ()))
    assert text != TEAM
    project.change("team.aseme", text)
    again = await project.client.text_document_formatting_async(
        lsp.DocumentFormattingParams(project.document(), options)
    )
    assert not again


async def test_formatting_of_some_lines(project: Project) -> None:
    text = TEAM.replace("enter look    : [near]", "enter look    :   [near]")
    project.change("team.aseme", text)
    place = at("enter look^    :   [near]", text)
    edits = await project.client.text_document_range_formatting_async(
        lsp.DocumentRangeFormattingParams(
            project.document(), lsp.Range(place, place), lsp.FormattingOptions(2, True)
        )
    )
    assert applied(text, list(edits or ())) == TEAM


async def test_inlay_hints(project: Project) -> None:
    found = await project.client.text_document_inlay_hint_async(
        lsp.InlayHintParams(project.document(), lsp.Range(lsp.Position(0, 0), lsp.Position(99, 0)))
    )
    lines = TEAM.split("\n")
    shown_at = {(lines[item.position.line].strip(), str(item.label)) for item in found or ()}
    assert ("let near = vision.state.Ball.distance < 3", ": bool") in shown_at
    assert ("look = Scan . [Jump]", "0.2.3.2") in shown_at


async def test_code_lens(project: Project) -> None:
    found = await project.client.text_document_code_lens_async(lsp.CodeLensParams(project.document()))
    titles = [(item.command.title, item.command.command) for item in found or () if item.command is not None]
    assert titles[:3] == [("Diagram", "asemec.diagram"), ("Diagram", "asemec.diagram"), ("Run", "asemec.run")]
    prove = ("prove", "asemec.prove")  # a protocol, and the team
    assert titles[3:] == [("prove all", "asemec.prove"), prove, prove]


async def test_document_links(project: Project) -> None:
    found = await project.client.text_document_document_link_async(lsp.DocumentLinkParams(project.document()))
    assert [Path(item.target or "").name for item in found or ()] == ["shared.aseme", "soccer.aseme"]


async def test_call_hierarchy_of_formulas(project: Project) -> None:
    items = await project.client.text_document_prepare_call_hierarchy_async(
        lsp.CallHierarchyPrepareParams(project.document(), at("(^look |"))
    )
    assert items is not None and [item.name for item in items] == ["look"]
    callers = await project.client.call_hierarchy_incoming_calls_async(
        lsp.CallHierarchyIncomingCallsParams(items[0])
    )
    assert [item.from_.name for item in callers or ()] == ["keeper"]
    called = await project.client.call_hierarchy_outgoing_calls_async(
        lsp.CallHierarchyOutgoingCallsParams(items[0])
    )
    assert [item.to.name for item in called or ()] == ["Scan", "Jump"]


async def test_a_buffer_that_is_no_file_is_answered_for(client: LanguageClient) -> None:
    uri = "untitled:Untitled-1"
    client.text_document_did_open(
        lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(uri, "aseme", 1, "system X\nlet a = 1 < 2\n"))
    )
    found = await client.text_document_hover_async(
        lsp.HoverParams(lsp.TextDocumentIdentifier(uri), lsp.Position(1, 4))
    )
    assert found is not None and "let a : bool" in found.contents.value
    client.text_document_did_close(lsp.DidCloseTextDocumentParams(lsp.TextDocumentIdentifier(uri)))


async def test_nonsense_is_answered(project: Project) -> None:
    project.change("team.aseme", "srm { /* 🤖 \x00 liveness { = . | ")
    position = lsp.Position(0, 9)
    assert (
        await project.client.text_document_hover_async(lsp.HoverParams(project.document(), position)) is None
    )
    assert (
        await project.client.text_document_document_symbol_async(lsp.DocumentSymbolParams(project.document()))
        is not None
    )


async def test_without_pygls_the_command_says_what_to_install(tmp_path: Path) -> None:
    script = (
        "import sys; sys.modules['pygls'] = None; from aseme_dsl.cli import main; sys.exit(main(['lsp']))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 1
    assert 'pip install ".[editor]" (in a clone), or "aseme-dsl[editor]"' in done.stderr
    assert "Traceback" not in done.stderr


async def test_the_diagram_follows_the_cursor(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    # The ids of the picture are no names that an object could have: leave the result as it was sent.
    monkeypatch.setattr("pygls.protocol._dict_to_object", lambda result: result)

    async def asked(marked: str, text: str = TEAM) -> Any:
        place = at(marked, text)
        position = {"line": place.line, "character": place.character}
        params = {"textDocument": {"uri": project.uri()}, "position": position}
        return await project.client.protocol.send_request_async("aseme/diagram", params)

    drawing = await asked("look = Sc^an . [Jump]")
    assert drawing["name"] == "iac.keeper" and drawing["note"] == ""
    assert drawing["title"].startswith("Statechart of the role keeper: ")
    assert drawing["svg"].rstrip().endswith("</svg>")
    assert f'id="{drawing["here"]}"' in drawing["svg"]
    place = drawing["elements"][drawing["here"]]
    assert place["uri"] == project.uri()
    assert shown(TEAM, as_range(place["range"])) == "Scan"
    control = drawing["elements"][(await asked("enter look    : [ne^ar]"))["here"]]
    assert shown(TEAM, as_range(control["range"])) == "enter look    : [near]"
    assert (await asked("process = Give . [mo^re]"))["name"] == "eac.swap"
    assert await asked("system Te^am") is None
    broken = TEAM.replace("look = Scan . [Jump]", "look = Scan . . [Jump]")
    project.change("team.aseme", broken)
    earlier = await asked("look = Sc^an", broken)
    assert earlier["svg"] == drawing["svg"]
    assert "before the mistakes" in earlier["note"] and earlier["here"] is None


def as_range(value: dict[str, Any]) -> lsp.Range:
    return lsp.Range(lsp.Position(**value["start"]), lsp.Position(**value["end"]))


async def test_a_page_in_a_browser_follows_the_cursor(project: Project) -> None:
    client = project.client
    asked = lsp.ExecuteCommandParams("asemec.view", [])
    url = await client.workspace_execute_command_async(asked)
    assert isinstance(url, str)
    assert client.shown_documents[-1].uri == url and client.shown_documents[-1].external
    assert await client.workspace_execute_command_async(asked) == url
    browser = Browser(url)
    assert (await asyncio.to_thread(browser.next))["title"] == "Move the cursor into a model."

    place = lsp.DocumentHighlightParams(project.document(), at("look = Sc^an . [Jump]"))
    await client.text_document_document_highlight_async(place)
    state = await asyncio.to_thread(browser.next)
    assert state["name"] == "iac.keeper" and state["here"] in state["elements"]

    position = at("process = Give . [mo^re]")
    params = {"position": {"line": position.line, "character": position.character}}
    client.protocol.notify("aseme/cursor", {"textDocument": {"uri": project.uri()}, **params})
    state = await asyncio.to_thread(browser.next)
    assert state["name"] == "eac.swap"

    await asyncio.to_thread(browser.act, act="click", id=state["here"])
    state = await asyncio.to_thread(browser.next) if not state["here"] else state
    for _ in range(1200):
        if client.shown_documents[-1].uri == project.uri():
            break
        await asyncio.sleep(0.05)
    shown_place = client.shown_documents[-1]
    assert shown_place.uri == project.uri() and shown_place.selection is not None
    assert shown(TEAM, shown_place.selection) in ("more", "Give . Rest")
    await asyncio.to_thread(browser.act, act="click", id="nowhere")

    project.change("team.aseme", TEAM.replace("Give . Rest", "Give . Rest . Again"))
    state = await asyncio.to_thread(browser.next)
    assert "Again" in state["title"]


async def test_an_editor_that_can_show_nothing_is_not_asked_to() -> None:
    client = BaseLanguageClient("plain", "1")
    asked: list[object] = []

    @client.feature(lsp.WINDOW_SHOW_DOCUMENT)
    def show(params: lsp.ShowDocumentParams) -> lsp.ShowDocumentResult:
        asked.append(params)
        return lsp.ShowDocumentResult(False)

    await client.start_io(sys.executable, "-m", "aseme_dsl", "lsp")
    await client.initialize_async(lsp.InitializeParams(lsp.ClientCapabilities()))
    client.initialized(lsp.InitializedParams())
    url = await client.workspace_execute_command_async(lsp.ExecuteCommandParams("asemec.view"))
    assert isinstance(url, str) and url.startswith("http://127.0.0.1:")
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()
    assert asked == []
