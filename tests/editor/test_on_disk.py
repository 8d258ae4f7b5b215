"""What changes on disk, in files that are not open: what the server says of them and of those that are."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_asyncio
import pytest_lsp
from lsprotocol import types as lsp
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from tests.editor.test_server import Project, asked_to_watch

pytestmark = pytest.mark.asyncio

TEAM = """\
system Team
import "shared.aseme"
import "extra.proto"
srm keeper {
  liveness { keeper = Scan~ }
  activities { Scan reads board.state.Note, board.state.Mark }
  control keeper { repeat Scan : [board.state.Note.number == 1 and board.state.Mark.size == 2] }
}
team Team { robot1 : keeper }
"""
SHARED = """\
message Note { int number }
topic board { state Note, Mark }
"""
PROTO = """\
syntax = "proto3";
message Mark { int32 size = 1; }
"""
SCAN = """\
class Scan:
    def execute(self, context):
        context.wait(1)
        return context.read("board.state.Note")
"""
NO_SUCH_CHANNEL = SCAN.replace("return context", "context.read('board.state.Nott')\n        return context")
PROJECT = '[tool.asemec]\nfiles = ["team.aseme"]\nactivities = "act"\n'


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[sys.executable, "-m", "aseme_dsl", "lsp"]))
async def client(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    for name, text in {
        "team.aseme": TEAM,
        "shared.aseme": SHARED,
        "extra.proto": PROTO,
        "pyproject.toml": PROJECT,
        "act/scan.py": SCAN,
    }.items():
        (tmp_path / "main" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "main" / name).write_text(text, "utf-8")
    lsp_client.registered = asked_to_watch(lsp_client)  # type: ignore[attr-defined]
    await lsp_client.initialize_session(
        lsp.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[lsp.WorkspaceFolder((tmp_path / "main").as_uri(), "team")],
        )
    )
    yield
    await lsp_client.shutdown_session()


@pytest_asyncio.fixture
async def project(client: LanguageClient, tmp_path: Path) -> Project:
    made = Project(tmp_path / "main", client)
    made.open("team.aseme", TEAM)
    await says(made, "team.aseme")
    return made


async def says(project: Project, name: str, *codes: str) -> None:
    """Wait until this is what the server has said last of a file."""
    uri = (project.folder / name).resolve().as_uri()
    found: list[object] = []
    try:
        async with asyncio.timeout(120):
            while True:
                if uri in project.client.diagnostics or not codes:
                    found = [item.code for item in project.client.diagnostics.get(uri, ())]
                    if found == list(codes):
                        return
                await asyncio.sleep(0.02)
    except TimeoutError:
        pytest.fail(f"{name}: {found} rather than {codes}")


def changed(project: Project, name: str, text: str | None) -> None:
    """A file has another text on disk, or is gone, and the editor says so."""
    path = project.folder / name
    kind = lsp.FileChangeType.Changed if path.exists() else lsp.FileChangeType.Created
    if text is None:
        path.unlink()
        kind = lsp.FileChangeType.Deleted
    else:
        path.write_text(text, "utf-8")
    event = lsp.FileEvent(path.as_uri(), kind)
    project.client.workspace_did_change_watched_files(lsp.DidChangeWatchedFilesParams([event]))


async def test_the_server_asks_to_be_told_of_files(client: LanguageClient) -> None:
    """An editor that watches files only when it is asked to (Neovim, Emacs) is asked."""
    seen: list[lsp.Registration] = []
    async with asyncio.timeout(120):
        while not seen:
            seen = list(client.registered)  # type: ignore[attr-defined]
            await asyncio.sleep(0.02)
    (registration,) = seen
    assert registration.method == "workspace/didChangeWatchedFiles"


@pytest.mark.parametrize(
    ("name", "text", "wrong"),
    [
        ("shared.aseme", SHARED, SHARED.replace("number", "numero")),
        ("extra.proto", PROTO, PROTO.replace("size", "length")),
    ],
    ids=["an import", "a .proto file"],
)
async def test_what_is_imported_changes(project: Project, name: str, text: str, wrong: str) -> None:
    changed(project, name, wrong)
    await says(project, "team.aseme", "E501")
    changed(project, name, None)
    await says(project, "team.aseme", "E004")
    changed(project, name, text)
    await says(project, "team.aseme")


async def test_what_is_imported_is_wrong_itself(project: Project) -> None:
    changed(project, "shared.aseme", SHARED + "let far = neer\n")
    await says(project, "shared.aseme", "E200")
    project.open("shared.aseme", SHARED)  # from now on its text is the editor's
    await says(project, "shared.aseme")
    project.close("shared.aseme")
    await says(project, "shared.aseme", "E200")
    project.close("team.aseme")
    await says(project, "shared.aseme")  # nobody is interested any more


async def test_the_python_of_an_activity_changes(project: Project) -> None:
    changed(project, "act/scan.py", NO_SUCH_CHANNEL)
    await says(project, "act/scan.py", "W530")
    (problem,) = project.client.diagnostics[project.uri("act/scan.py")]
    assert problem.range.start == lsp.Position(3, 21)
    changed(project, "act/scan.py", None)
    await says(project, "act/scan.py")
    changed(project, "act/scan.py", NO_SUCH_CHANNEL)
    await says(project, "act/scan.py", "W530")
    changed(project, "act/scan.py", SCAN)
    await says(project, "act/scan.py")


async def test_the_configuration_changes(project: Project) -> None:
    changed(project, "pyproject.toml", PROJECT.replace("activities", "activitys"))
    await says(project, "pyproject.toml", "E010")
    changed(project, "pyproject.toml", PROJECT)
    await says(project, "pyproject.toml")
    changed(project, "act/scan.py", NO_SUCH_CHANNEL)
    await says(project, "act/scan.py", "W530")
    changed(project, "pyproject.toml", None)  # then the activities are somewhere else
    await says(project, "act/scan.py")
    changed(project, "pyproject.toml", PROJECT)
    await says(project, "act/scan.py", "W530")


async def test_a_folder_comes_and_goes(project: Project, tmp_path: Path) -> None:
    """What is in a folder belongs to the system that imports it, once the folder of that is open."""
    other = tmp_path / "other"
    other.mkdir()
    (other / "cup.aseme").write_text(
        'system Cup\nimport "../main/shared.aseme"\nlet far = board.state.Note.number == 1 and neer\n',
        "utf-8",
    )
    folder = lsp.WorkspaceFolder(other.as_uri(), "other")
    project.open("shared.aseme", SHARED)
    await says(project, "shared.aseme")

    async def systems() -> set[str]:
        found = await project.client.workspace_symbol_async(lsp.WorkspaceSymbolParams("Cup"))
        return {item.name for item in found or ()}

    assert await systems() == set()
    event = lsp.WorkspaceFoldersChangeEvent([folder], [])
    project.client.workspace_did_change_workspace_folders(lsp.DidChangeWorkspaceFoldersParams(event))
    await says(project, "../other/cup.aseme", "E200")
    assert await systems() == {"Cup"}
    event = lsp.WorkspaceFoldersChangeEvent([], [folder])
    project.client.workspace_did_change_workspace_folders(lsp.DidChangeWorkspaceFoldersParams(event))
    await says(project, "../other/cup.aseme")
    assert await systems() == set()
