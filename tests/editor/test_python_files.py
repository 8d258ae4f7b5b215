"""From the Python class of an activity to the model and back, and what mends its code."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from tests.editor.test_server import Project, asked_to_watch, at, published_by, shown

pytestmark = pytest.mark.asyncio(loop_scope="function")

TEAM = """\
system Team

message Ball { bool visible }
topic vision { state Ball }

srm player {
  liveness { player = Look~ || (Search . Walk) }
  control player { enter Walk : seen }
  activities {
    Look   writes vision.state.Ball
    Search takes 2s
    Walk   takes 1s
  }
}
"""

SEARCH = '''\
"""Where is the ball? 🤖"""

from aseme_dsl.runtime import Context


class Helper:
    pass


class Search:
    def execute(self, context: Context) -> None:
        context.log(f"the ball: {context.read('vision.state.Ball')}")
        context.emit("seen")
'''


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[sys.executable, "-m", "aseme_dsl", "lsp"]))
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


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "team.aseme").write_text(TEAM, "utf-8")
    (tmp_path / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["team.aseme"]\nactivities = "activities"\n', "utf-8"
    )
    (tmp_path / "activities").mkdir()
    for name in ("look", "search", "walk"):
        text = SEARCH if name == "search" else f"class {name.title()}:\n    def execute(self, context): ...\n"
        (tmp_path / "activities" / f"{name}.py").write_text(text, "utf-8")
    return tmp_path


@pytest.fixture
def project(client: LanguageClient, folder: Path) -> Project:
    return Project(folder, client)


FILE = "activities/search.py"


def found(places: object, project: Project) -> list[str]:
    """The places in `team.aseme`, as their lines."""
    assert isinstance(places, (list, tuple))
    assert {item.uri for item in places} <= {project.uri()}
    assert all(shown(TEAM, item.range) == "Search" for item in places)
    return [TEAM.splitlines()[item.range.start.line].strip() for item in places]


DESCRIBED = "Search takes 2s"
USED = "liveness { player = Look~ || (Search . Walk) }"


@pytest.mark.parametrize("is_open", [False, True])
async def test_from_the_class_to_the_model_and_back(project: Project, is_open: bool) -> None:
    text = SEARCH
    if is_open:  # with a change that is not saved, and no `.aseme` file open
        text = SEARCH.replace("class Helper", "\n\nclass Other: ...\n\n\nclass Helper")
        project.open(FILE, SEARCH)
        project.change(FILE, text)
    ask, file = project.client, project.document(FILE)
    place = at("class Sea^rch", text)
    assert found(await ask.text_document_definition_async(lsp.DefinitionParams(file, place)), project) == [
        DESCRIBED
    ]
    inside = at("context.^log", text)
    said = await ask.text_document_declaration_async(lsp.DeclarationParams(file, inside))
    assert found(said, project) == [DESCRIBED]
    assert await ask.text_document_definition_async(lsp.DefinitionParams(file, inside)) is None
    context = lsp.ReferenceContext(include_declaration=True)
    said = await ask.text_document_references_async(lsp.ReferenceParams(context, file, place))
    assert found(said, project) == [DESCRIBED, USED]
    (lens,) = await ask.text_document_code_lens_async(lsp.CodeLensParams(file)) or ()
    assert shown(text, lens.range) == "Search"
    assert lens.command is not None and lens.command.title == "team.aseme:11"
    back = lsp.ImplementationParams(project.document(), at("^Search takes", TEAM))
    (python,) = await ask.text_document_implementation_async(back)
    assert python.uri == project.uri(FILE)
    assert shown(text, python.range) == "Search"


async def test_other_python_is_left_alone(project: Project, folder: Path) -> None:
    (folder / "search.py").write_text(SEARCH, "utf-8")
    for name, text in (("search.py", SEARCH), (FILE, "class Search(:\n")):
        project.open(name, text)
        params = lsp.CodeLensParams(project.document(name))
        assert not await project.client.text_document_code_lens_async(params)
    file, place = project.document("search.py"), at("class Sea^rch", SEARCH)
    assert await project.client.text_document_hover_async(lsp.HoverParams(file, place)) is None
    assert await project.client.text_document_rename_async(lsp.RenameParams(file, place, "Find")) is None
    options = lsp.FormattingOptions(4, True)
    assert (
        await project.client.text_document_formatting_async(lsp.DocumentFormattingParams(file, options))
        is None
    )
    assert not [item for item in published_by(project.client) if item.uri == file.uri and item.diagnostics]


async def test_an_undeclared_access_is_declared(project: Project, folder: Path) -> None:
    """The quick fix of E540: the problem is in the Python, and what mends it in the model."""
    project.open("team.aseme", TEAM)
    await project.settled()
    project.open(FILE, SEARCH)
    place = at("context.read('vis^ion", SEARCH)
    params = lsp.CodeActionParams(project.document(FILE), lsp.Range(place, place), lsp.CodeActionContext([]))
    (action,) = await project.client.text_document_code_action_async(params) or ()
    assert isinstance(action, lsp.CodeAction) and action.edit is not None and action.edit.changes is not None
    assert action.title == "Insert `reads vision.state.Ball`"
    ((uri, (edit,)),) = action.edit.changes.items()
    assert uri == project.uri()
    lines = TEAM.splitlines(keepends=True)
    start = edit.range.start
    lines[start.line] = (
        lines[start.line][: start.character] + edit.new_text + lines[start.line][start.character :]
    )
    mended = "".join(lines)
    assert "Search takes 2s reads vision.state.Ball\n" in mended
    project.change("team.aseme", mended)
    assert await project.diagnostics("team.aseme", errors=0) is not None
    assert not await project.client.text_document_code_action_async(params)


LACKING = TEAM.replace(
    "  activities {", "  modules { Eyes every 1s writes vision.state.Ball }\n  activities {"
).replace("Search takes 2s", "Search takes 2s simulated")


@pytest.mark.parametrize("name", ["Walk", "Eyes"])
async def test_the_file_that_is_missing_is_started_where_it_is_missed(project: Project, name: str) -> None:
    for path in (project.folder / "activities").iterdir():
        path.unlink()
    (project.folder / "team.aseme").write_text(LACKING, "utf-8")
    project.open("team.aseme", LACKING)

    async def offered(place: lsp.Position, *only: str) -> list[lsp.CodeAction]:
        context = lsp.CodeActionContext([], only=list(only) or None)
        done = await project.client.text_document_code_action_async(
            lsp.CodeActionParams(project.document(), lsp.Range(place, place), context)
        )
        return [item for item in done or () if isinstance(item, lsp.CodeAction)]

    place = at(f"^{name} every" if name == "Eyes" else f"^{name}   takes", LACKING)
    (action,) = [item for item in await offered(place, "quickfix") if "Python" in item.title]
    assert action.title == f"Start the Python file of `{name}`"
    resolved = await project.client.code_action_resolve_async(action)
    assert resolved.edit is not None and resolved.edit.document_changes is not None
    created, filled = resolved.edit.document_changes
    assert isinstance(created, lsp.CreateFile) and created.uri == project.uri(f"activities/{name.lower()}.py")
    assert isinstance(filled, lsp.TextDocumentEdit) and f"class {name}" in str(filled.edits[0].new_text)
    assert all("Python" not in item.title for item in await offered(at("^Search takes", LACKING)))
