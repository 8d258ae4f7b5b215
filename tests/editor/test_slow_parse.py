"""A parse that takes too long: nobody waits for it, it ends, and what was known before still counts."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from tests.editor.test_server import Project, asked_to_watch, at, published_by, shown
from tests.support.slow_server import COMMAND

pytestmark = [
    pytest.mark.asyncio(loop_scope="function"),
    pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks into /proc"),
]

TEAM = """\
system Team

srm keeper {
  liveness { keeper = (Scan | Jump)~ }
  control keeper { enter Scan : seen  enter Jump : else }
}

srm player {
  liveness { player = Walk . Kick }
  activities { Walk takes 1s  Kick takes 1s }
}
team Team { robot1 : keeper  robot2 : player }
"""

SLOW = TEAM.replace("Walk . Kick", "Walk . Sloth . Kick")


@pytest_lsp.fixture(config=ClientServerConfig(server_command=list(COMMAND)))
async def client(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    asked_to_watch(lsp_client)
    await lsp_client.initialize_session(
        lsp.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[lsp.WorkspaceFolder(tmp_path.as_uri(), "team")],
        )
    )
    yield
    await lsp_client.shutdown_session()


@pytest.fixture
def project(client: LanguageClient, tmp_path: Path) -> Project:
    return Project(tmp_path, client)


async def opened(project: Project, name: str = "team.aseme", text: str = TEAM) -> None:
    project.open(name, text)
    assert await project.diagnostics(name, errors=0) is not None


async def hovered(project: Project, name: str, marked: str, text: str) -> str:
    place = at(marked, text)
    found = await project.client.text_document_hover_async(lsp.HoverParams(project.document(name), place))
    assert found is not None and isinstance(found.contents, lsp.MarkupContent)
    return found.contents.value


def readers(project: Project) -> list[int]:
    """The processes that read for the server."""
    server = project.client._server
    assert server is not None
    tasks = Path(f"/proc/{server.pid}/task")
    return [int(pid) for path in tasks.glob("*/children") for pid in path.read_text().split()]


async def until_one_reads(project: Project) -> int:
    while not (found := readers(project)):
        await asyncio.sleep(0.01)
    return found[0]


async def gone(pid: int) -> None:
    while Path(f"/proc/{pid}").exists():
        await asyncio.sleep(0.01)


def codes(found: list[lsp.Diagnostic]) -> list[str]:
    return [str(item.code) for item in found if item.severity == lsp.DiagnosticSeverity.Error]


async def test_others_are_answered_while_a_file_is_read(project: Project) -> None:
    other = TEAM.replace("Team", "Other")
    await opened(project)
    await opened(project, "other.aseme", other)
    said = len(published_by(project.client))
    project.change("team.aseme", SLOW)
    await until_one_reads(project)
    assert "Scan" in await hovered(project, "team.aseme", "^Scan |", SLOW)
    assert "Kick" in await hovered(project, "other.aseme", "Walk . ^Kick", other)
    project.change("other.aseme", other.replace("Scan |", "Scan | Scan | "))
    await project.client.text_document_document_symbol_async(
        lsp.DocumentSymbolParams(project.document("other.aseme"))
    )
    assert project.document().uri not in {item.uri for item in published_by(project.client)[said:]}
    assert codes(await project.diagnostics("team.aseme")) == ["E116"]


async def test_what_is_not_read_in_time_is_known_as_it_was(project: Project) -> None:
    await opened(project)
    # The declaration above it has changed, too, and is read.
    changed = SLOW.replace("(Scan | Jump)~", "(Scan | Leap)~").replace("enter Jump", "enter Leap")
    project.change("team.aseme", changed)
    reading = await until_one_reads(project)
    (found,) = await project.diagnostics("team.aseme")
    assert (found.code, shown(changed, found.range)) == ("E116", "srm player {")
    assert "1 s" in found.message
    await gone(reading)
    assert readers(project) == []
    assert "Leap" in await hovered(project, "team.aseme", "(Scan | ^Leap", changed)
    assert "Kick" in await hovered(project, "team.aseme", "Sloth . ^Kick", changed)
    symbols = await project.client.text_document_document_symbol_async(
        lsp.DocumentSymbolParams(project.document())
    )
    assert symbols is not None
    assert [item.name for item in symbols] == ["Team", "keeper", "player", "Team"]
    # It is not tried again when something else is edited, but when it is itself.
    project.change("team.aseme", changed.replace("Leap", "Fly"))
    assert codes(await project.diagnostics("team.aseme")) == ["E116"]
    assert readers(project) == []
    project.change("team.aseme", TEAM)
    assert codes(await project.diagnostics("team.aseme", errors=0)) == []


async def test_a_newer_edit_ends_what_is_read(project: Project) -> None:
    await opened(project)
    project.change("team.aseme", SLOW)
    reading = await until_one_reads(project)
    project.change("team.aseme", TEAM.replace("Walk . Kick", "Walk . Kick . Walk"))
    await project.diagnostics("team.aseme", errors=0)
    await gone(reading)
    said = [item.code for one in published_by(project.client) for item in one.diagnostics]
    assert "E116" not in said


async def test_a_file_that_was_never_read(project: Project) -> None:
    project.open("team.aseme", SLOW)
    assert codes(await project.diagnostics("team.aseme")) == ["E116"]
    assert "Scan" in await hovered(project, "team.aseme", "^Scan |", SLOW)


async def test_what_is_slow_and_ends_is_read(project: Project) -> None:
    text = TEAM.replace("player = Walk . Kick", "player  = Walk . Snail")
    await opened(project)
    project.change("team.aseme", text)
    await project.diagnostics("team.aseme", errors=1)  # nobody describes Snail, and Kick is never used
    assert "Snail" in await hovered(project, "team.aseme", ". ^Snail", text)
    found = await project.client.text_document_formatting_async(
        lsp.DocumentFormattingParams(project.document(), lsp.FormattingOptions(2, True))
    )
    assert found


async def test_who_asks_for_it_is_told(project: Project) -> None:
    await opened(project)
    project.change("team.aseme", SLOW)
    with pytest.raises(JsonRpcException, match="was not read, because that takes longer than 1 s"):
        await project.client.text_document_formatting_async(
            lsp.DocumentFormattingParams(project.document(), lsp.FormattingOptions(2, True))
        )
    place = at("Sloth . ^Kick", SLOW)
    found = await project.client.text_document_completion_async(
        lsp.CompletionParams(project.document(), place)
    )
    assert found is not None
    with pytest.raises(JsonRpcException, match="E116"):
        await project.client.text_document_rename_async(lsp.RenameParams(project.document(), place, "Shoot"))
