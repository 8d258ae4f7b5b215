"""Operating real processes: status, select and swap over their sockets, also when one does not answer."""

from __future__ import annotations

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.project.operating import health
from aseme_dsl.runtime.control import control_socket
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.control.control_socket import ControlError, ask, endpoints, listening
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.trace import Record
from tests.cli import support as cli
from tests.faults.test_swap import ONE, WITHOUT_KICK
from tests.runtime.playing import SECOND, make
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

LONGER = ONE.replace("Search . (Kick | Wait)", "Search . (Kick | Wait) . Cheer")
OTHER = """\
srm goalie { liveness { goalie = Guard~ } activities { Guard takes 50ms } }
team S"""


class Here:
    """A folder with texts, and processes that run from it."""

    def __init__(self, folder: Path, capture: pytest.CaptureFixture[str]) -> None:
        self.folder = folder
        self.capture = capture
        self.running: list[subprocess.Popen[str]] = []
        self.runtime = Path(tempfile.mkdtemp(prefix="aseme", dir="/tmp"))  # a socket's path is short

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text, "utf-8")

    def start(self, *arguments: str) -> subprocess.Popen[str]:
        return self.begin("run", *arguments, "--real", "-q")

    def begin(self, *arguments: str, **environment: str) -> subprocess.Popen[str]:
        """`asemec` in a process of its own."""
        process = subprocess.Popen(
            [sys.executable, "-m", "aseme_dsl", *arguments],
            cwd=self.folder,
            env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2]), **environment},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        self.running.append(process)
        return process

    def asemec(self, *arguments: str) -> tuple[int, str]:
        """What an operator says, from this process."""
        done = cli.Here(self.capture)(*arguments)
        return done.code, done.out + done.err

    def status(self) -> list[dict[str, Any]]:
        code, said = self.asemec("team", "status", "-o", "out", "--json")
        return json.loads(said)["processes"] if code == 0 else []

    def agents(self, count: int = 2) -> dict[str, dict[str, Any]]:
        """What so many agents say of themselves, when they do."""

        def found() -> dict[str, dict[str, Any]]:
            agents = {agent["name"]: agent for process in self.status() for agent in process["agents"]}
            return agents if len(agents) == count else {}

        return wait_until(found, pause=0.02)


@pytest.fixture
def here(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Iterator[Here]:
    made = Here(tmp_path, capsys)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(made.runtime))
    yield made
    for process in made.running:
        if process.poll() is None:
            process.send_signal(signal.SIGCONT)
            process.kill()
        process.communicate()
    shutil.rmtree(made.runtime)


def test_a_team_is_asked_and_changed(here: Here) -> None:
    here.write("one.aseme", ONE.replace("team S", OTHER))
    here.write("two.aseme", LONGER.replace("team S", OTHER))
    here.write("three.aseme", WITHOUT_KICK.replace("player", "striker"))
    here.write("wrong.aseme", ONE.replace("Kick takes", "Kik takes"))
    here.start("one.aseme", "-o", "out")
    before = here.agents()
    assert {name: agent["role"] for name, agent in before.items()} == {"a": "player", "b": "player"}

    code, said = here.asemec("team", "swap", "wrong.aseme", "-o", "out")
    assert code == 1
    assert "error" in said
    code, said = here.asemec("team", "swap", "three.aseme", "-o", "out")
    assert code == 1
    assert "the new model has no player, which a plays; it has striker" in said
    assert {a["model"] for a in here.agents().values()} == {before["a"]["model"]}

    code, said = here.asemec("team", "swap", "two.aseme", "-o", "out")
    assert code == 0, said
    after = here.agents()
    assert {a["model"] for a in after.values()} != {before["a"]["model"]}
    wait_until(lambda: "Cheer" in here.agents()["a"]["activities"])

    code, said = here.asemec("team", "switch", "b", "goalie", "-o", "out")
    assert code == 0, said
    assert here.agents()["b"]["role"] == "goalie"
    code, said = here.asemec("team", "switch", "b", "sweeper", "-o", "out")
    assert code == 1
    assert "there is no plan sweeper; there are S.player, S.goalie" in said
    code, said = here.asemec("team", "switch", "nobody", "goalie", "-o", "out")
    assert "there is no agent nobody; there are a, b" in said
    process = here.running[0]
    process.send_signal(signal.SIGINT)
    process.wait(LONG)
    assert here.asemec("team", "status", "-o", "out")[0] == 1
    kinds = [line["kind"] for line in records_of(here.folder / "out/trace.jsonl.gz")]
    assert kinds.count("swap") == 3  # refused, and done by two
    assert kinds.count("select") == 2


def test_a_team_in_several_processes_changes_as_one_or_not_at_all(here: Here) -> None:
    here.write("one.aseme", ONE)
    here.write("two.aseme", LONGER)
    assert here.asemec("build", "one.aseme", "-o", "out")[0] == 0
    for name in ("a", "b"):
        here.start("out", "--role", "player", "--agent", name, "--trace", f"{name}.jsonl")
    before = here.agents()

    here.running[1].send_signal(signal.SIGSTOP)
    code, said = here.asemec("team", "swap", "two.aseme", "-o", "out")
    assert code == 1, said
    assert "does not answer" in said
    code, said = here.asemec("team", "status", "-o", "out")
    assert code == 1
    pid = here.running[1].pid
    assert f"error[E034]: process {pid} (b) does not answer within" in said
    assert [line.split()[:2] for line in said.splitlines() if line.startswith("  ")] == [["a", "player"]]
    here.running[1].send_signal(signal.SIGCONT)
    assert {a["model"] for a in here.agents().values()} == {before["a"]["model"]}

    code, said = here.asemec("team", "swap", "two.aseme", "-o", "out")
    assert code == 0, said
    models = {agent["model"] for agent in here.agents().values()}
    assert len(models) == 1
    assert models != {before["a"]["model"]}


# ---- one process, by its control ------------------------------------------------------------------


class Running:
    """A team that runs in real time in a thread."""

    def __init__(self, text: str = ONE) -> None:
        self.team, self.records = make(text, clock="real", until=round(LONG) * SECOND)
        self.thread = threading.Thread(target=self.team.run, daemon=True)
        self.thread.start()
        wait_until(lambda: all(agent.steps for agent in self.team.agents))

    def __enter__(self) -> tuple[Team, list[Record]]:
        return self.team, self.records

    def __exit__(self, *problem: object) -> None:
        self.team.driver.stop("over")
        self.thread.join(LONG)


def package(folder: Path, text: str) -> tuple[str, str]:
    """The hash of a version on disk, and that of its models."""
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.playing.operate import write_version
    from tests.support.generated import system_of

    return write_version(system_of(text), folder, Choice(), None)


def said(control: Control, **request: Any) -> dict[str, Any]:
    return control.handle({"version": 1, **request})


def test_who_hears_no_more_goes_on_as_it_was(tmp_path: Path) -> None:
    name, _ = package(tmp_path, LONGER)
    with Running() as (team, records):
        control = Control(team, store=tmp_path / "versions")
        old = {agent.plan.model for agent in team.agents}
        reply = said(control, request="swap", phase="prepare", hash=name, within=60, hold=2)
        assert reply["state"] == "prepared"
        steps = [agent.steps for agent in team.agents]
        other = said(control, request="swap", phase="prepare", hash=name)
        assert other["reasons"] == ["another swap is under way"]
        assert [agent.steps for agent in team.agents] == steps  # they are held
        wait_until(lambda: said(control, request="status")["swap"] is None)
        late = said(control, request="swap", phase="commit", id=reply["id"])
        assert late["reasons"] == [f"the swap {reply['id']} is not held here any more"]
        assert {agent.plan.model for agent in team.agents} == old
        wait_until(lambda: [agent.steps for agent in team.agents] > steps)
    (line,) = [r for r in records if r["kind"] == "swap"]
    assert (line["what"], line["reasons"]) == ("rolled back", ["no supervisor has confirmed it within 2 s"])


def test_agents_that_a_swap_holds_are_not_stuck(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(health, "PATIENCE", 0.2)
    name, _ = package(tmp_path, LONGER)
    looks: list[health.Health] = []
    with Running() as (team, records):
        looker = health.Looker(team, looks.append, 0.1)
        looker.begin()
        control = Control(team, store=tmp_path / "versions")
        reply = said(control, request="swap", phase="prepare", hash=name, within=60, hold=3)
        wait_until(lambda: any(look.notes == ("a swap holds a", "a swap holds b") for look in looks))
        held = len(looks)
        wait_until(lambda: len(looks) >= held + 25)
        said(control, request="swap", phase="rollback", id=reply["id"])
        wait_until(lambda: looks[-1].notes == ())
        looker.close()
    assert [look.reasons() for look in looks if look.begun and not look.is_ready] == []
    assert [record for record in records if record["kind"] == "fault"] == []


def test_who_has_committed_goes_on_to_the_end(tmp_path: Path) -> None:
    name, model = package(tmp_path, LONGER)
    with Running() as (team, records):
        control = Control(team, store=tmp_path / "versions")
        held = said(control, request="swap", phase="prepare", hash=name, within=60, hold=2)
        assert said(control, request="swap", phase="finish", id=held["id"])["ok"] is False
        assert said(control, request="swap", phase="commit", id=held["id"])["state"] == "committed"
        wait_until(lambda: said(control, request="status")["swap"] is None)
        assert said(control, request="status")["model"] == model
    assert [r["what"] for r in records if r["kind"] == "swap"] == ["done", "done"]


@pytest.mark.parametrize(
    "request_, reason",
    [
        ({"request": "dance"}, "there is no request 'dance'"),
        ({"request": "swap", "phase": "hop"}, "there is no phase 'hop'"),
        ({"request": "swap", "phase": "prepare", "folder": "/nowhere"}, "no member 'folder'"),
        ({"request": "select", "agent": "zoe", "plan": "x"}, "there is no agent zoe here; there are a, b"),
        ({"request": "status", "version": 9}, "requests of version 9 are not known"),
    ],
)
def test_requests_that_mean_nothing(request_: dict[str, Any], reason: str) -> None:
    with Running() as (team, _):
        reply = said(Control(team), **request_)
    assert reply["ok"] is False
    assert reason in reply["reasons"][0]


class TestSocket:
    @pytest.fixture(autouse=True)
    def place(self, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
        short = tempfile.mkdtemp(prefix="aseme", dir="/tmp")
        monkeypatch.setenv("XDG_RUNTIME_DIR", short)
        yield
        shutil.rmtree(short)

    def test_a_folder_with_a_long_path_is_not_used(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("XDG_RUNTIME_DIR", "/tmp/" + "x" * 60)
        assert len(str(control_socket.folder_for(Path("out")) / f"{'n' * 32}-4194304.sock")) < 104

    def test_it_is_the_users_alone_and_goes_with_the_run(self, tmp_path: Path) -> None:
        with Running() as (team, _):
            with listening(Control(team), tmp_path / "out", "team") as path:
                assert stat.S_IMODE(path.stat().st_mode) == 0o600
                assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
                assert endpoints(tmp_path / "out") == [path]
                assert ask(path, {"request": "status"})["system"] == "S"
            assert not path.exists()
            assert endpoints(tmp_path / "out") == []
            with pytest.raises(ControlError, match="cannot be reached"):
                ask(path, {"request": "status"})

    def test_who_looks_while_a_run_begins_does_not_take_its_socket_for_one_that_was_left(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        import socket

        listen = socket.socket.listen

        def looked_at(server: socket.socket) -> None:
            endpoints(tmp_path / "out")
            listen(server)

        monkeypatch.setattr(socket.socket, "listen", looked_at)
        with Running() as (team, _), listening(Control(team), tmp_path / "out", "team") as path:
            assert endpoints(tmp_path / "out") == [path]
            assert ask(path, {"request": "status"})["system"] == "S"
            assert [item.name for item in path.parent.iterdir()] == [path.name]

    def test_what_a_killed_run_has_left_is_removed(self, tmp_path: Path) -> None:
        import socket

        folder = control_socket.folder_for(tmp_path / "out")
        left = folder / "team-1.sock"
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(left))
        assert left.exists()
        assert endpoints(tmp_path / "out") == []
        assert not left.exists()

    def test_nonsense_is_answered(self, tmp_path: Path) -> None:
        import socket

        with Running() as (team, _), listening(Control(team), tmp_path / "out", "team") as path:
            with socket.socket(socket.AF_UNIX) as connection:
                connection.connect(str(path))
                connection.sendall(b"\x00\xff\n[1]\n")
                answer = b""
                connection.settimeout(LONG)
                while answer.count(b"\n") < 2 and (part := connection.recv(4096)):
                    answer += part
            replies = [json.loads(line) for line in answer.splitlines()]
            assert [reply["ok"] for reply in replies] == [False, False]
