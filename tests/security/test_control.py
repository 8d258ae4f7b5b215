"""Who can control a running team, and who cannot."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import socket
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import jsonschema
import pytest

from aseme_dsl.runtime.control import connections, control_socket
from aseme_dsl.runtime.control.connections import MOST
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.control.control_log import Origin
from aseme_dsl.runtime.control.control_socket import ask, listening
from aseme_dsl.runtime.team.swap import Version
from aseme_dsl.runtime.trace.trace_schema import schema
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport import meeting as meetings
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.version.loading import activities_of
from aseme_dsl.runtime.version.versions import VersionError, hash_of, read_version
from tests.faults.changing import version
from tests.faults.team import NAME, Started, project, started
from tests.faults.test_operate import Running
from tests.faults.test_select import play
from tests.security.lines import line
from tests.security.users import NOBODY, can_be_another
from tests.support.waiting import LONG, wait_until


@pytest.fixture
def foreign() -> Iterator[Path]:
    """A folder that everybody may read, with a package whose import leaves a mark."""
    folder = Path(tempfile.mkdtemp(prefix="aseme"))
    folder.chmod(0o755)
    package = folder / "monas" / NAME
    package.mkdir(parents=True)
    (package / "__init__.py").write_text(f"open({str(folder / 'ran')!r}, 'w').close()\n")
    yield package
    shutil.rmtree(folder)


def requests_of(run: Started, robot: str) -> list[dict[str, object]]:
    return [record for record in run.trace(robot) if record["kind"] == "control"]


@line("another user of this machine", "have a robot import code (`swap` with a folder)")
def test_no_request_brings_code(foreign: Path, tmp_path: Path) -> None:
    """Not even from the team's own user, over the bus with its secret."""
    pytest.importorskip("zenoh")
    request = json.dumps({"version": 1, "request": "swap", "phase": "ready", "folder": str(foreign)})
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        with ZenohLink(NAME, Network()).connected("operator") as session:

            def ask() -> list[dict[str, object]]:
                """Nobody answers until this session has found the robots."""
                replies = session.get(f"asemec/{NAME}/control/robot1", payload=request, timeout=LONG)
                return [json.loads(reply.ok.payload.to_string()) for reply in replies if reply.ok is not None]

            (reply,) = wait_until(ask)
        assert run.end() == 130
    assert reply["reasons"] == ["control over the bus is off"]
    assert not (foreign.parents[1] / "ran").exists()
    assert {(r["what"], r["origin"]) for r in requests_of(run, "robot1")} == {("refused", "bus")}


ASKS = """
system Ask
import runtime
srm captain {
  liveness { captain = Think~ }
  activities { Think takes 100ms }
  control captain { enter Think : / WHO.runtime.signal.SelectPlan.plan = "sweeper"; \
write_messages.runtime.signal.SelectPlan }
}
srm player { liveness { player = Chase~ } activities { Chase takes 100ms } }
team Two { boss : captain  mate : player }
"""


@line("a robot with a certificate", "have another robot load a package of another system (`SelectPlan`)")
def test_a_message_of_another_robot_loads_no_package() -> None:
    loaded: list[str] = []

    def carried() -> list[Version]:
        loaded.append("Other")
        text = "system Other\nsrm sweeper { liveness { sweeper = Sweep~ } activities { Sweep takes 40ms } }"
        return [version(text)]

    _, records = play(ASKS.replace("WHO", "mate"), carried=carried)
    refused = [record for record in records if record["kind"] == "select"]
    assert {(r["agent"], r["by"], r["reason"]) for r in refused} == {
        ("mate", "boss", "there is no plan sweeper; there are Ask.captain, Ask.player")
    }
    assert loaded == []
    _, records = play(ASKS.replace("WHO.", ""), carried=carried)  # a robot may for itself
    assert [r["plan"] for r in records if r["kind"] == "select"] == ["Other.sweeper"]
    assert loaded == ["Other"]


FILES = {
    "monas/S/__init__.py": b"",
    "monas/S/messages.py": b"x = 1",
    "activities/kick.py": b"class Kick: pass",
}


def stored(store: Path) -> tuple[str, Path]:
    """A version in a folder of versions; gives its hash and its folder."""
    name = hash_of(FILES)
    for path, content in FILES.items():
        (store / name / path).parent.mkdir(parents=True, exist_ok=True)
        (store / name / path).write_bytes(content)
    for place in (store, *store.rglob("*")):
        place.chmod(0o700 if place.is_dir() else 0o600)
    return name, store / name


@line("another user of this machine", "exchange the code of a version")
def test_a_version_is_what_was_hashed_and_nobody_elses(tmp_path: Path) -> None:
    store = tmp_path / "versions"
    name, folder = stored(store)
    kick = folder / "activities" / "kick.py"
    read = read_version(store, name)
    kick.write_bytes(b"raise SystemExit('exchanged')")
    assert activities_of(read)("Kick") is not None  # what was hashed runs
    with pytest.raises(VersionError, match="has been changed"):
        read_version(store, name)
    kick.write_bytes(FILES["activities/kick.py"])
    (folder / "activities" / "more.py").touch(0o600)
    with pytest.raises(VersionError, match="has been changed"):
        read_version(store, name)
    (folder / "activities" / "more.py").unlink()
    for place in (kick, folder / "activities", folder, store):
        mode = place.stat().st_mode & 0o777
        for wrong in (mode | 0o020, mode | 0o002):
            place.chmod(wrong)
            with pytest.raises(VersionError, match="can be written by other users"):
                read_version(store, name)
        place.chmod(mode)
    tmp_path.chmod(0o777)
    with pytest.raises(VersionError, match="can be written by other users"):
        read_version(store, name)
    tmp_path.chmod(0o700)
    assert read_version(store, name) == read
    kick.rename(tmp_path / "kick.py")
    kick.symlink_to(tmp_path / "kick.py")
    with pytest.raises(VersionError, match="cannot be read"):
        read_version(store, name)
    kick.unlink()
    os.mkfifo(kick, 0o600)
    with pytest.raises(VersionError, match="not a regular file"):
        read_version(store, name)
    kick.unlink()  # hypothesis reads the files of all modules, and would wait for the pipe
    for wrong_name in ("", "..", name.upper(), "0" * 64, f"../versions/{name}"):
        with pytest.raises(VersionError):
            read_version(store, wrong_name)


def test_a_version_of_another_user_is_not_loaded(tmp_path: Path) -> None:
    if not can_be_another():
        pytest.skip("NOT TESTED: versions that belong to another user need tests that run as root")
    store = tmp_path / "versions"
    name, folder = stored(store)
    for place in (folder / "monas" / "S" / "messages.py", folder, store):
        os.chown(place, NOBODY, NOBODY)
        with pytest.raises(VersionError, match="belongs to another user"):
            read_version(store, name)
        os.chown(place, 0, 0)
    assert read_version(store, name).hash == name


def test_a_request_with_a_folder_is_refused_at_the_socket_too(foreign: Path) -> None:
    with Running() as (team, _):
        control = Control(team)
        reply = control.handle({"version": 1, "request": "swap", "phase": "ready", "folder": str(foreign)})
    assert reply["reasons"] == ["a request has no member 'folder'"]
    assert not (foreign.parents[1] / "ran").exists()


HOSTILE: tuple[bytes, ...] = (
    b"",
    b"\xff\x00",
    b"[" * 60_000,
    b'{"a":' * 10_000,
    b'"' + b"a" * 70_000 + b'"',
    b"[1]",
    b'{"version": 1}',
    b'{"version": 1, "request": ["status"]}',
    b'{"version": 1, "request": "stop", "force": true}',
    b'{"version": 1, "request": "swap", "phase": "ready", "folder": "a\\u0000b"}',
    b'{"version": 1, "request": "swap", "phase": "ready", "folder": 7}',
    b'{"version": 1, "request": "swap", "phase": "prepare", "folder": "/nowhere", "within": NaN}',
    b'{"version": 1, "request": "swap", "phase": "refuse", "folder": "/nowhere", "reasons": 3}',
    b'{"version": 1, "request": "swap", "phase": "commit", "id": true}',
    b'{"version": 1, "request": "select", "agent": "\\ud800", "plan": "x"}',
    b'{"version": 9, "request": "status"}',
)


@line("another user of this machine", "send 1 000 control requests over the bus")
def test_a_flood_over_the_bus_changes_nothing_and_is_summarised() -> None:
    with Running() as (team, records):
        control = Control(team)
        asked = [*HOSTILE, b'{"version": 1, "request": "stop"}', b'{"version": 1, "request": "status"}']
        for number in range(1000):
            reply = control.not_over_the_bus("a", asked[number % len(asked)])
            assert reply == {"version": 1, "ok": False, "reasons": ["control over the bus is off"]}
        control.log.flush()
        traced = [record for record in records if record["kind"] == "control"]
        assert sum(record.get("count", 1) for record in traced) == 1000
        assert len(traced) < 200
        assert {(record["what"], record["origin"], record["agent"]) for record in traced} == {
            ("refused", "bus", "a")
        }
        assert not any(agent.over for agent in team.agents)
        for record in traced:
            jsonschema.validate(record, schema())


@line("a process without the secret", "send malformed requests to a control socket")
def test_hostile_requests_to_the_socket_are_refused_with_a_reason_and_traced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    with Running() as (team, records), listening(Control(team), tmp_path / "out", "team") as path:
        for data in HOSTILE:
            with socket.socket(socket.AF_UNIX) as connection:
                connection.settimeout(LONG)
                connection.connect(str(path))
                connection.sendall(data + b"\n")
                connection.shutdown(socket.SHUT_WR)
                reply = json.loads(connection.makefile("rb").readline())
            assert reply["ok"] is False, data[:80]
            assert reply["reasons"][0], data[:80]
            assert "Traceback" not in str(reply)
        assert not any(agent.over for agent in team.agents)
        wait_until(lambda: sum(r["kind"] == "control" for r in records) == len(HOSTILE))
    assert {r["uid"] for r in records if r["kind"] == "control"} == {os.geteuid()}


def opened(path: Path) -> socket.socket:
    """A connection to a control socket."""
    connection = socket.socket(socket.AF_UNIX)
    connection.settimeout(LONG)
    connection.connect(str(path))
    return connection


@contextmanager
def crowd(path: Path) -> Iterator[list[socket.socket]]:
    """As many connections as there may be."""
    with contextlib.ExitStack() as stack:
        yield [stack.enter_context(opened(path)) for _ in range(MOST)]


def replies(connection: socket.socket) -> list[dict[str, object]]:
    """What comes until the connection is closed at the other end."""
    with connection.makefile("rb") as lines:
        return [json.loads(line) for line in lines]


STATUS = b'{"version": 1, "request": "status"}\n'


@line("a process without the secret", "keep others from a control socket by silent or slow connections")
@pytest.mark.parametrize("said", [b"", STATUS[:9], STATUS])
def test_who_waits_longest_on_a_control_socket_makes_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: bytes
) -> None:
    """Before a request, in the midst of one, and after one."""
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    with (
        Running() as (team, records),
        listening(Control(team), tmp_path / "out", "team") as path,
        crowd(path) as silent,
    ):
        for connection in silent:
            connection.sendall(said)
            if said.endswith(b"\n"):
                assert b'"ok": true' in connection.recv(1 << 20)
        assert ask(path, {"request": "status"})["ok"]
        (refusal,) = replies(silent[0])
        assert refusal["reasons"] == [f"{MOST} others are connected, and this one had waited longest"]
        for connection in silent[1:]:  # they have kept their places
            connection.sendall(STATUS if said == STATUS else STATUS[len(said) :])
            assert b'"ok": true' in connection.recv(1 << 20)
    refused = [r for r in records if r["kind"] == "control" and r["what"] == "refused"]
    assert [r["reasons"] for r in refused[:1]] == [refusal["reasons"]]


def test_who_takes_no_replies_makes_room_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    with (
        Running() as (team, records),
        listening(Control(team), tmp_path / "out", "team") as path,
        crowd(path) as deaf,
    ):
        for connection in deaf:
            connection.setblocking(False)
            with contextlib.suppress(BlockingIOError):
                while True:
                    connection.sendall(STATUS * 99)
        assert ask(path, {"request": "status"}, LONG)["ok"]
        wait_until(lambda: any("waited longest" in str(record.get("reasons")) for record in list(records)))


def test_who_is_being_answered_loses_no_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    held, go = threading.Semaphore(0), threading.Event()
    with Running() as (team, _):
        control = Control(team)
        read = control.read

        def slow(data: bytes, origin: Origin) -> dict[str, object]:
            held.release()
            go.wait(LONG)
            return read(data, origin)

        monkeypatch.setattr(control, "read", slow)
        with listening(control, tmp_path / "out", "team") as path, crowd(path) as busy:
            for connection in busy:
                connection.sendall(STATUS)
            for _ in busy:
                assert held.acquire(timeout=LONG)
            assert ask(path, {"request": "status"})["reasons"] == [f"{MOST} others are being answered"]
            go.set()
            for connection in busy:
                assert b'"ok": true' in connection.recv(1 << 20)
            assert wait_until(lambda: ask(path, {"request": "status"})["ok"])


def test_who_sends_a_byte_now_and_then_holds_no_place_for_ever(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    monkeypatch.setattr(connections, "REQUEST_SECONDS", 0.5)
    with Running() as (team, _), listening(Control(team), tmp_path / "out", "team") as path:
        with socket.socket(socket.AF_UNIX) as connection:
            connection.connect(str(path))

            def is_closed() -> bool:
                """Send one more byte."""
                try:
                    connection.sendall(b" ")
                except OSError:
                    return True
                return False

            wait_until(is_closed, 20.0, pause=0.05)
        with socket.socket(socket.AF_UNIX) as connection:  # in two pieces is no harm
            connection.connect(str(path))
            asked = b'{"version": 1, "request": "status"}\n' * 2
            connection.sendall(asked[:9])
            connection.sendall(asked[9:])
            with connection.makefile("rb") as lines:
                assert [json.loads(lines.readline())["ok"] for _ in range(2)] == [True, True]


@line("another user of this machine", "connect to a control socket")
def test_the_socket_is_for_one_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    monkeypatch.setattr(control_socket, "_user_of", lambda connection: 12345)
    with Running() as (team, records), listening(Control(team), tmp_path / "out", "team") as path:
        assert ask(path, {"request": "stop"})["reasons"] == ["this socket is for another user"]
        assert not any(agent.over for agent in team.agents)
    assert [(r["what"], r["uid"]) for r in records if r["kind"] == "control"] == [("refused", 12345)]


def test_who_takes_the_name_of_the_folder_keeps_nobody_from_controlling(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not can_be_another():
        pytest.skip("NOT TESTED: folders of another user need tests that run as root")
    taken, free = (Path(tempfile.mkdtemp(prefix="t", dir="/tmp")) for _ in range(2))
    monkeypatch.setattr(meetings, "_roots", lambda: iter((taken, free)))
    try:
        mine = taken / f"asemec-{os.getuid()}"
        mine.mkdir()
        os.chown(mine, NOBODY, NOBODY)
        with Running() as (team, _), listening(Control(team), tmp_path / "out", "team") as path:
            assert path.is_relative_to(free)
            assert control_socket.endpoints(tmp_path / "out") == [path]
    finally:
        shutil.rmtree(taken)
        shutil.rmtree(free)
