"""What listens: nothing on TCP or UDP while a team of one machine runs, and only the user can reach it."""

from __future__ import annotations

import os
import shutil
import stat
import tempfile
from pathlib import Path

import psutil
import pytest

from aseme_dsl.runtime.transport import Network, Tls, TransportError
from aseme_dsl.runtime.transport import meeting as meetings
from aseme_dsl.runtime.transport.settings import Xmpp
from tests.faults.team import NAME, project, started
from tests.security.conftest import AsOther
from tests.security.lines import line
from tests.support.network import own_name

pytest.importorskip("zenoh")

CONNECT = """
import json, socket, zenoh
for path in sys.argv[1:]:
    try:
        socket.socket(socket.AF_UNIX).connect(path)
    except PermissionError:
        print("refused")
    else:
        print("let in")
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("connect/endpoints", json.dumps(["unixsock-stream/" + path]))
    try:
        zenoh.open(config)
    except zenoh.ZError:
        print("refused")
    else:
        print("let in")
"""


def sockets_of(process: psutil.Process) -> list[str]:
    """What a process and its children have open on TCP and UDP."""
    return [
        f"{found.laddr} {found.status}"
        for one in (process, *process.children(recursive=True))
        for found in one.net_connections("inet")
    ]


@line("another user of this machine", "reach the bus of a team on this machine")
@line("a machine without certificate", "reach a team on one machine")
def test_a_team_on_one_machine_opens_no_port_and_lets_nobody_in(tmp_path: Path, as_other: AsOther) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        assert sockets_of(psutil.Process(run.process.pid)) == []
        folder = meetings.meeting_place(NAME)
        found = sorted(str(path) for path in folder.glob("*.sock"))
        done = as_other(CONNECT, *found, modules=("json", "socket", "zenoh"))
        assert run.end() == 130
    assert len(found) == 3
    assert done.stdout.split("\n")[:-1] == ["refused"] * 6, done.stderr
    for one in (folder, folder.parent):
        assert stat.S_IMODE(one.stat().st_mode) == 0o700 and one.stat().st_uid == os.getuid()


def test_sockets_of_processes_that_were_killed_are_removed() -> None:
    system = own_name("Meet")
    folder = meetings.meeting_place(system)
    (folder / "old.sock").touch()
    (folder / "old.sock.lock").touch()
    with meetings.joining(system, "ann") as meeting:
        assert meeting.others == ()
    assert sorted(path.name for path in folder.iterdir()) == ["lock", "secret"]
    assert stat.S_IMODE((folder / "secret").stat().st_mode) == 0o600
    with meetings.joining(system, "ann") as again:
        assert again.secret != meeting.secret  # nobody was there
    assert again.own != meeting.own


@pytest.mark.parametrize("how", ["long", "hash", "writable", "around", "around of another"])
def test_a_folder_that_will_not_do_is_left_for_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: str
) -> None:
    if how.endswith("another") and os.geteuid() != 0:
        pytest.skip("NOT TESTED: folders of another user need tests that run as root")
    with tempfile.TemporaryDirectory(dir="/tmp", prefix="r") as name:
        around = Path(name)
        root = Path("/tmp/a#b") if how == "hash" else around / ("l" * 90 if how == "long" else "w")
        if how != "hash":
            root.mkdir(mode=0o700)
        if how == "writable":
            root.chmod(0o777)
        elif how == "around":
            around.chmod(0o777)
        elif how == "around of another":
            os.chown(around, 65534, 65534)
        monkeypatch.setenv("XDG_RUNTIME_DIR", str(root))
        assert root not in meetings.meeting_place("Any").parents


@line("another user of this machine", "have robots meet in a folder that holds what this user has put there")
def test_a_folder_that_others_could_write_in_is_made_anew_or_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with tempfile.TemporaryDirectory(dir="/tmp", prefix="r") as name:
        monkeypatch.setattr(meetings, "_roots", lambda: iter((Path(name),)))
        folder = meetings.meeting_place("Any")
        folder.chmod(0o777)
        assert stat.S_IMODE(meetings.meeting_place("Any").stat().st_mode) == 0o700
        (folder / "secret").write_bytes(bytes(32))
        folder.chmod(0o777)
        for _ in range(2):
            with pytest.raises(TransportError, match="not empty"):
                meetings.meeting_place("Any")


@line("another user of this machine", "read the private key of a robot's certificate")
@pytest.mark.parametrize("mode", [0o604, 0o602])
def test_a_private_key_that_all_may_read_is_refused(tmp_path: Path, mode: int) -> None:
    for file in ("a.pem", "b.pem", "b.key"):
        (tmp_path / file).touch(0o600)
    network = Network(
        listen=("tls/127.0.0.1:0",), tls=Tls(tmp_path / "a.pem", tmp_path / "b.pem", tmp_path / "b.key")
    )
    assert dict(network.settings())
    (tmp_path / "b.key").chmod(mode)
    with pytest.raises(TransportError, match="is open to all users"):
        dict(network.settings())


@line("another user of this machine", "read the password of an agent's XMPP account")
@pytest.mark.parametrize("mode", [0o604, 0o602])
def test_a_password_file_that_all_may_read_is_refused(tmp_path: Path, mode: int) -> None:
    file = tmp_path / "ann.txt"
    file.write_text("secret\n")
    settings = Xmpp(password=tmp_path / "ROBOT.txt")
    file.chmod(0o600)
    assert settings.password_of("ann") == "secret"
    file.chmod(mode)
    with pytest.raises(TransportError, match="is open to all users"):
        settings.password_of("ann")


def test_who_takes_the_name_of_the_folder_keeps_nobody_from_meeting(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if os.geteuid() != 0:
        pytest.skip("NOT TESTED: folders of another user need tests that run as root")
    monkeypatch.delenv("XDG_RUNTIME_DIR", raising=False)
    taken, free = Path(f"/tmp/t{os.getpid()}"), Path(f"/tmp/u{os.getpid()}")
    monkeypatch.setattr(meetings, "_roots", lambda: iter((taken, free)))
    try:
        for root in (taken, free):
            root.mkdir()
            root.chmod(0o1777)
        mine = taken / f"asemec-{os.getuid()}"
        mine.mkdir()
        os.chown(mine, 65534, 65534)
        assert meetings.meeting_place("Any").parent.parent == free
        monkeypatch.setattr(meetings, "_roots", lambda: iter((taken,)))
        with pytest.raises(TransportError, match="it belongs to another user"):
            meetings.meeting_place("Any")
        mine.rmdir()
        mine.symlink_to(free)  # to a folder of ours is no better
        with pytest.raises(TransportError, match="it belongs to another user"):
            meetings.meeting_place("Any")
    finally:
        shutil.rmtree(taken)
        shutil.rmtree(free)


@pytest.mark.parametrize(
    "end", ["tcp/192.0.2.1:7447", "udp/[2001:db8::1]:7447", "tcp/0.0.0.0:0", "tcp/robot2:7447"]
)
def test_without_a_certificate_nobody_beyond_this_machine_is_accepted(end: str) -> None:
    with pytest.raises(TransportError, match="only tls/ proves who is there"):
        dict(Network(listen=(end,)).settings())
    with pytest.raises(TransportError, match="only tls/ proves who is there"):
        dict(Network(connect=(end,)).settings())
    with pytest.raises(TransportError, match="without certificates"):
        dict(Network(interface="eth0").settings())
