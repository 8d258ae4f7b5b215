"""Verdicts about all runs in an editor, asked by a client of a real server process."""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest
import pytest_lsp
from lsprotocol import types as lsp
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from aseme_dsl.editor.showing import CODE, PROVE, STOP
from tests.editor.test_server import Project, asked_to_watch, at, published_by

pytestmark = pytest.mark.asyncio(loop_scope="function")

LOAN = """\
system Loans

message Tool { int number }

aip loan {
  participant borrower {
    process = Ask . [Work]
  }
  participant lender {
    var is_free : bool
    process = Look . (Refuse | Lend)
  }
  control borrower {
    enter Ask  : / send request Tool { .. } to lender
    enter Work : agree Tool from lender
    skip  Work : refuse Tool from lender or after(1min)
    leave Work : / send inform Tool { .. } to lender
  }
  control lender {
    enter Look   : request Tool from borrower
    enter Lend   : [is_free] / send agree Tool { .. } to borrower
    enter Refuse : else / send refuse Tool { .. } to borrower
    leave Lend   : inform Tool from borrower
  }
  outcome "The tool was used." when Work@borrower
  outcome "The tool was not free." when Refuse@lender
  clause Lend@lender before Work@borrower
}
"""
MENDED = LOAN.replace(
    "    leave Lend   : inform Tool from borrower\n",
    "    leave Lend   : inform Tool from borrower or lost borrower\n",
)

SMALL = """\
system Small

srm walker {
  liveness { walker = (Walk . Rest)~ }
}
team All { robot : walker }

property "never rests" { never robot in Rest }
"""

BIG = """\
system Big

message N { int number }
topic all { state N }

srm walker {
  var a : int = 0
  var b : int = 0
  var c : int = 0
  var d : int = 0
  liveness { walker = (Walk . Rest)~ || (Look . Wait)~ || (Hear . Say)~ }
  activities { Walk writes all.state.N, a  Look writes b, c  Hear writes d }
  control walker {
    enter Walk : [a < 3 || b < 5]
    enter Look : [c < 4]
    enter Hear : [d < 4 && all.state.N.number > 2]
  }
}
team All { robot[1..4] : walker }
"""


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[sys.executable, "-m", "aseme_dsl", "lsp"]))
async def client(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    await begin(lsp_client, tmp_path)
    yield
    await lsp_client.shutdown_session()


async def begin(client: LanguageClient, folder: Path, options: object = None) -> None:
    asked_to_watch(client)

    @client.feature(lsp.WORKSPACE_CODE_LENS_REFRESH)
    def refreshed(*given: object) -> None: ...

    await client.initialize_session(
        lsp.InitializeParams(
            capabilities=client_capabilities("visual-studio-code"),
            workspace_folders=[lsp.WorkspaceFolder(folder.as_uri(), "team")],
            initialization_options=options,
        )
    )


@pytest.fixture
def project(client: LanguageClient, tmp_path: Path) -> Project:
    return Project(tmp_path, client)


def put(project: Project, name: str, text: str) -> None:
    """A file that is saved, and open."""
    (project.folder / name).write_text(text, "utf-8")
    if name in project.versions:
        project.change(name, text)
        project.client.text_document_did_save(lsp.DidSaveTextDocumentParams(project.document(name)))
    else:
        project.open(name, text)


async def lenses(project: Project, name: str) -> dict[str, str]:
    """The title above each question."""
    found = await project.client.text_document_code_lens_async(lsp.CodeLensParams(project.document(name)))
    commands = [item.command for item in found or () if item.command is not None]
    return {
        argument(item.arguments, "question"): item.title for item in commands if item.command in (PROVE, STOP)
    }


def argument(arguments: Any, name: str) -> str:
    (one,) = arguments
    return str(one[name] if isinstance(one, dict) else getattr(one, name))


async def click(project: Project, name: str, question: str, command: str = PROVE) -> None:
    given = {"uri": project.uri(name), "question": question}
    await project.client.workspace_execute_command_async(lsp.ExecuteCommandParams(command, arguments=[given]))


async def shown(project: Project, name: str, question: str, wanted: Callable[[str], bool]) -> str:
    """The title above a question, as soon as it is a wanted one."""
    async with asyncio.timeout(60):
        while not wanted(title := (await lenses(project, name))[question]):
            await asyncio.sleep(0.05)
    return title


def is_verdict(title: str) -> bool:
    return title.startswith(("PROVED", "REFUTED", "UNDECIDED", "1 ", "2 ", "3 ", "4 ", "5 ", "6 "))


def provers(project: Project) -> list[int]:
    """The processes that prove for the server."""
    server = project.client._server
    assert server is not None
    return provers_of(server.pid)


def provers_of(pid: int) -> list[int]:
    tasks = Path(f"/proc/{pid}/task")
    found = [int(one) for path in tasks.glob("*/children") for one in read(path).split()]
    return [one for one in found if "proving.process" in read(Path(f"/proc/{one}/cmdline"))]


def read(path: Path) -> str:
    """What a file of /proc holds; nothing if its process or thread has ended meanwhile."""
    try:
        return path.read_text()
    except OSError:
        return ""


async def until(condition: Callable[[], object]) -> None:
    async with asyncio.timeout(60):
        while not condition():
            await asyncio.sleep(0.05)


QUESTIONS = ["all", "protocol loan", "protocol loan clause Lend@lender before Work@borrower"]


async def test_a_click_proves_and_the_counterexample_becomes_a_scenario(project: Project) -> None:
    published = published_by(project.client)
    put(project, "loan.aseme", LOAN)
    assert await lenses(project, "loan.aseme") == {
        QUESTIONS[0]: "prove all",
        QUESTIONS[1]: "prove",
        QUESTIONS[2]: "prove",
    }
    await click(project, "loan.aseme", QUESTIONS[2])
    assert (await lenses(project, "loan.aseme"))[QUESTIONS[2]].startswith("proving … (")
    title = await shown(project, "loan.aseme", QUESTIONS[2], is_verdict)
    assert title == "PROVED · 1 borrower, 1 lender; any delay; 44 states"
    assert (await lenses(project, "loan.aseme"))[QUESTIONS[1]] == "prove"
    (progress,) = project.client.progress_reports.values()
    assert [type(item) for item in progress][:1] == [lsp.WorkDoneProgressBegin]

    await click(project, "loan.aseme", QUESTIONS[1])
    title = await shown(project, "loan.aseme", QUESTIONS[1], is_verdict)
    assert "REFUTED" in title and "deadlock" in title and "lender waits after Lend" in title

    def refuted() -> list[lsp.Diagnostic]:
        return [item for item in published[-1].diagnostics if item.code == CODE]

    await until(refuted)
    said = next(item for item in refuted() if "`deadlock`" in item.message)
    assert said.range.start == at("aip ^loan", LOAN)
    assert said.severity is lsp.DiagnosticSeverity.Warning
    steps = [item.message for item in said.related_information or ()]
    assert (steps[0], len(steps)) == ("1. borrower: Ask ends", 5)

    params = lsp.CodeActionParams(
        project.document("loan.aseme"), said.range, lsp.CodeActionContext([said], only=["quickfix"])
    )
    actions = await project.client.text_document_code_action_async(params)
    action = next(item for item in actions or () if "`deadlock`" in item.title)
    assert isinstance(action, lsp.CodeAction) and action.edit is not None and action.edit.changes is not None
    assert list(action.diagnostics or ()) == [said]
    (edit,) = action.edit.changes[project.uri("loan.aseme")]
    saved = project.folder / "found.aseme"
    run(project.folder, "prove", "loan.aseme", "deadlock", "--save", "found.aseme")
    assert edit.new_text == saved.read_text().removeprefix('import "loan.aseme"\n')

    # The scenario fails, and does not make what is known out of date, nor is it offered again.
    put(project, "loan.aseme", LOAN + edit.new_text)
    done = run(project.folder, "test", "loan.aseme")
    assert done.returncode == 1 and "failed   deadlock of protocol loan" in done.stdout
    assert await shown(project, "loan.aseme", QUESTIONS[1], is_verdict) == title
    actions = await project.client.text_document_code_action_async(params)
    assert not [item for item in actions or () if "`deadlock`" in item.title]

    # A comment changes nothing; a condition does; and the text of before has its verdict again.
    project.change("loan.aseme", "// Tools.\n" + LOAN)
    assert (await lenses(project, "loan.aseme"))[QUESTIONS[1]] == title
    project.change("loan.aseme", MENDED)
    assert (await lenses(project, "loan.aseme"))[QUESTIONS[1]].startswith("changed since · ")
    await until(lambda: not refuted())
    project.change("loan.aseme", LOAN)
    assert (await lenses(project, "loan.aseme"))[QUESTIONS[1]] == title


async def test_what_cannot_be_proved_is_said(project: Project) -> None:
    (project.folder / "shared.aseme").write_text("message Tool { int number }\n")
    text = LOAN.replace("message Tool { int number }", 'import "shared.aseme"')
    put(project, "loan.aseme", text)
    put(project, "shared.aseme", "message Tool { int number }\n")
    project.change("shared.aseme", "message Tool { int numbers }\n")
    assert await said_after(project, PROVE) == "Not proved: save shared.aseme first, which is imported"
    project.change("loan.aseme", text.replace("Look .", "Look . ."))
    assert await said_after(project, PROVE) == "Not proved: the file has errors"
    wrong = lsp.DidChangeConfigurationParams({"prove": {"budget": "soon"}})
    message = project.client.protocol.wait_for_notification_async(lsp.WINDOW_SHOW_MESSAGE)
    waiting = asyncio.ensure_future(message)
    await asyncio.sleep(0)
    project.client.workspace_did_change_configuration(wrong)
    assert (await waiting).message == 'asemec: prove.budget is a duration like "10s", not soon'


async def said_after(project: Project, command: str) -> str:
    """What the editor shows after a click above the system."""
    message = project.client.protocol.wait_for_notification_async(lsp.WINDOW_SHOW_MESSAGE)
    waiting = asyncio.ensure_future(message)
    await asyncio.sleep(0)
    await click(project, "loan.aseme", "all", command)
    return str((await asyncio.wait_for(waiting, 60)).message)


def run(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "aseme_dsl", *arguments], cwd=folder, capture_output=True, text=True
    )


linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks into /proc")


@linux
async def test_what_is_refuted_in_an_open_imported_file_is_shown_there_only(project: Project) -> None:
    published = published_by(project.client)
    whole, _, rests = SMALL.partition("property")
    put(project, "part.aseme", f"property{rests}")
    put(project, "small.aseme", whole.replace("\n\n", '\n\nimport "part.aseme"\n\n', 1))
    await click(project, "small.aseme", "all")
    await shown(project, "part.aseme", "property never rests", is_verdict)

    def refuted(name: str) -> list[lsp.Diagnostic]:
        (*_, last) = [item for item in published if item.uri == project.uri(name)]
        return [item for item in last.diagnostics if item.code == CODE]

    await until(lambda: refuted("part.aseme"))
    assert refuted("small.aseme") == []


async def test_what_is_saved_is_proved_when_it_is_wanted(project: Project) -> None:
    put(project, "small.aseme", SMALL)
    put(project, "small.aseme", SMALL)
    assert (await lenses(project, "small.aseme"))["all"] == "prove all"
    settings = {"aseme": {"prove": {"onSave": True, "budget": "5s"}}}
    project.client.workspace_did_change_configuration(lsp.DidChangeConfigurationParams(settings))
    put(project, "small.aseme", SMALL)
    title = await shown(project, "small.aseme", "property never rests", is_verdict)
    assert title.startswith("REFUTED · ")
    whole = (await lenses(project, "small.aseme"))["all"]
    assert "REFUTED" in whole and not whole.rstrip().endswith(":")
    # A file with errors is not proved; the last verdict is that of another text.
    put(project, "small.aseme", SMALL.replace("Walk . Rest", "Walk . ."))
    await asyncio.sleep(0.3)
    assert provers(project) == []
    put(project, "small.aseme", SMALL.replace("Walk . Rest", "Walk . Stand").replace("in Rest", "in Stand"))
    await until(lambda: provers(project))


@linux
async def test_what_runs_is_replaced_given_up_and_may_die(project: Project) -> None:
    settings = {"prove": {"budget": "60s"}}
    project.client.workspace_did_change_configuration(lsp.DidChangeConfigurationParams(settings))
    put(project, "big.aseme", BIG)
    put(project, "small.aseme", SMALL)
    await click(project, "big.aseme", "team")
    await until(lambda: provers(project))
    (first,) = provers(project)
    # Two files: one does not wait for the other.
    await click(project, "small.aseme", "property never rests")
    assert (await shown(project, "small.aseme", "property never rests", is_verdict)).startswith("REFUTED")
    assert provers(project) == [first]
    # A second request replaces the first, and who clicks again gives it up.
    await click(project, "big.aseme", "all")
    await until(lambda: provers(project) and first not in provers(project))
    assert (await lenses(project, "big.aseme"))["team"].startswith("proving … (")
    await click(project, "big.aseme", "all", STOP)
    await until(lambda: not provers(project))
    assert (await lenses(project, "big.aseme"))["all"] == "prove all"
    # The process ends by itself; the text changes meanwhile.
    await click(project, "big.aseme", "team")
    await until(lambda: provers(project))
    os.kill(provers(project)[0], signal.SIGKILL)
    title = await shown(project, "big.aseme", "team", lambda title: "proving" not in title)
    assert title == "prove · not proved: the process ended with -9"
    await click(project, "small.aseme", "property never rests")
    project.change("small.aseme", SMALL.replace("Walk . Rest", "Walk . [Rest]"))
    title = await shown(project, "small.aseme", "property never rests", lambda title: "proving" not in title)
    assert title.startswith("changed since · REFUTED")
    # A file that is closed is not proved any more.
    await click(project, "big.aseme", "team")
    await until(lambda: provers(project))
    project.close("big.aseme")
    await until(lambda: not provers(project))


@linux
@pytest.mark.parametrize("is_killed", [False, True])
async def test_no_process_stays_behind(tmp_path: Path, is_killed: bool) -> None:
    client = LanguageClient()
    await client.start_io(sys.executable, "-m", "aseme_dsl", "lsp")
    await begin(client, tmp_path, {"prove": {"onSave": True, "budget": "60s"}})
    project = Project(tmp_path, client)
    put(project, "big.aseme", BIG)
    put(project, "big.aseme", BIG)
    await until(lambda: provers(project))
    (pid,) = provers(project)
    await until(lambda: computed(pid) > 1.5)  # it explores, and writes nothing meanwhile
    server = client._server
    assert server is not None
    if is_killed:
        server.kill()
    else:
        await client.shutdown_session()
    await until(lambda: not _is_there(pid))
    await client.stop()


def computed(pid: int) -> float:
    """The processor time of a process, in seconds."""
    parts = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return int(parts[11]) / os.sysconf("SC_CLK_TCK")


def _is_there(pid: int) -> bool:
    return ") Z" not in (read(Path(f"/proc/{pid}/stat")) or ") Z")
