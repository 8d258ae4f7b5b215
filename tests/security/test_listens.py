"""What listens: each row of "Open sockets" in `docs/project/security.md`, by looking at what is open."""

from __future__ import annotations

import contextlib
import json
import os
import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlsplit

import psutil
import pytest

from aseme_dsl.editor.viewer import LOOPBACK, Viewer, page_state
from aseme_dsl.project.settings import deployment
from aseme_dsl.runtime.control import connections
from aseme_dsl.runtime.control.connections import MOST
from aseme_dsl.runtime.control.control_socket import endpoints
from aseme_dsl.runtime.transport import meeting as meetings
from tests.cli.support import asemec
from tests.faults.team import NAME, PATIENT, ROOT, project, started
from tests.faults.test_network import certificates, port
from tests.security.lines import line
from tests.support.waiting import LONG, wait_until

__all__ = ["certificates", "port"]


@contextmanager
def running(*command: str, folder: Path) -> Iterator[psutil.Process]:
    """`asemec` with these arguments, in a folder."""
    process = psutil.Popen(
        [sys.executable, "-c", PATIENT, *command],
        cwd=folder,
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def internet(process: psutil.Process) -> set[tuple[str, int]]:
    """The addresses on which a process and its children take what others send, over TCP and UDP."""
    found = [
        item
        for one in (process, *process.children(recursive=True))
        for item in one.net_connections("inet")
        if item.status == psutil.CONN_LISTEN or (item.status == psutil.CONN_NONE and item.laddr)
    ]
    return {(item.laddr.ip, item.laddr.port) for item in found}


def unix(process: psutil.Process) -> set[Path]:
    """The names of the Unix sockets of a process and its children; an abstract one has none on the disk."""
    return {
        Path(item.laddr)
        for one in (process, *process.children(recursive=True))
        for item in one.net_connections("unix")
        if item.laddr
    }


def listed(folder: Path) -> dict[str, list[str]]:
    """What `asemec doctor` says."""
    found: dict[str, list[str]] = {}
    for opening in asemec("doctor", "--json", cwd=folder).json["opens"]:
        found.setdefault(opening["platform"], []).append(opening["opens"])
    return found


@line("team", "in one process")
def test_a_team_in_one_process_opens_a_control_socket_alone(tmp_path: Path) -> None:
    folder = project(tmp_path)
    with running("run", "--real", str(folder), folder=folder) as process:
        (path,) = wait_until(lambda: endpoints(folder / "out"))
        assert internet(process) == set()
        assert {one.parent for one in unix(process)} == {path.parent}
    assert listed(folder)["in_process"] == ["nothing on the network"]
    assert listed(folder)["all"] == ["a Unix socket for control, where a run listens for it"]


@line("team", "a process for each robot, or `asemec node`, without `hosts`")
def test_robots_on_one_machine_open_unix_sockets_alone(tmp_path: Path) -> None:
    pytest.importorskip("zenoh")
    folder = project(tmp_path)
    with started(folder) as run:
        run.wait_for_talk()
        robots = run.robots()
        assert len(robots) == 3
        whole = psutil.Process(run.process.pid)
        assert internet(whole) == set()
        places = {meetings.meeting_place(NAME), endpoints(folder / "out")[0].parent}
        assert {path.parent for path in unix(whole)} == places
        assert all(place.parent.name == f"asemec-{os.getuid()}" for place in places)
        assert run.end() == 130
    assert listed(folder)["zenoh"] == ["Unix sockets in a folder with mode 0700"]


OWN = """
import sys
from pathlib import Path
from tests.faults.test_network import WIRE, secured
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
given = {} if len(sys.argv) == 3 else {"interface": sys.argv[3]}
network = secured(Path(sys.argv[1]), "bob", listen=(sys.argv[2],), robot="bob", team=("ann", "bob"), **given)
session = ZenohLink(WIRE, network).connected("bob")
print("open", flush=True)
sys.stdin.read()
"""


def opened_with(certificates: Path, port: int, interface: str | None) -> set[tuple[str, int]]:
    """What a robot with a host of its own opens, in a process of its own."""
    pytest.importorskip("zenoh")
    process = psutil.Popen(
        [
            sys.executable,
            "-c",
            OWN,
            str(certificates),
            f"tls/127.0.0.1:{port}",
            *([interface] if interface else []),
        ],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        text=True,
    )
    assert process.stdout.readline() == "open\n"
    found = internet(process)
    process.communicate("")
    return found


@line("team", "with `hosts`")
def test_a_robot_with_a_host_listens_there_alone(certificates: Path, port: int) -> None:
    assert opened_with(certificates, port, None) == {("127.0.0.1", port)}


@line("team", "with a name as host that this machine does not know as its own")
def test_a_robot_whose_host_is_another_name_listens_on_all_addresses(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def unknown(*_: object, **__: object) -> object:
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    monkeypatch.setattr(socket, "getaddrinfo", unknown)
    assert deployment._listening("robot1.local:7448") == "0.0.0.0:7448"


@line("team", "with `hosts` and `interface`")
def test_a_robot_that_looks_for_others_listens_for_multicast_too(certificates: Path, port: int) -> None:
    found = opened_with(certificates, port, "lo")
    assert ("127.0.0.1", port) in found
    # Multicast comes by one socket, its answers by another.
    rest = {address for address in found if address != ("127.0.0.1", port)}
    assert {number for address, number in rest if address in ("224.0.0.224", "0.0.0.0")} >= {7446}


@line("team", "`asemec view`")
def test_the_viewer_is_on_the_loopback_interface(tmp_path: Path) -> None:
    folder = project(tmp_path)
    with running("view", "talk.aseme", folder=folder) as process:
        ((address, _),) = wait_until(lambda: internet(process))
        assert address == "127.0.0.1"
        assert unix(process) == set()
    assert listed(folder)["asemec view"] == ["tcp/127.0.0.1, any free port"]


@pytest.fixture
def shown() -> Iterator[Viewer]:
    made = Viewer(lambda said: None)
    made.show(page_state(title="one"))
    yield made
    made.close()


@contextmanager
def crowd(shown: Viewer) -> Iterator[list[socket.socket]]:
    """As many connections to the viewer as there may be."""
    with contextlib.ExitStack() as stack:
        yield [
            stack.enter_context(socket.create_connection((LOOPBACK, shown.port), LONG)) for _ in range(MOST)
        ]


def state_of(shown: Viewer, after: int = 0, wrong: str = "") -> bytes:
    """What a page asks."""
    where = urlsplit(shown.url)
    return f"GET {where.path}{wrong}state?after={after} HTTP/1.1\r\nHost: {where.netloc}\r\n\r\n".encode()


def status_of(connection: socket.socket) -> bytes:
    """The first line of an answer; empty where the connection is closed."""
    with connection.makefile("rb") as lines:
        return lines.readline().rstrip()


@line("another user of this machine", "hold up the page of `asemec view` by silent or slow connections")
@pytest.mark.parametrize("how", ["silent", "in the midst", "refused"])
def test_who_does_not_know_the_secret_of_the_viewer_makes_room(shown: Viewer, how: str) -> None:
    places = shown._server.places
    with crowd(shown) as silent:
        for connection in silent:
            if how == "in the midst":
                connection.sendall(b"GET / HT")
            elif how == "refused":
                connection.sendall(state_of(shown, wrong="x"))
                assert b"404" in connection.recv(1 << 20)
                wait_until(lambda: not places._answered)  # it waits again, and longer than those after it
        with socket.create_connection((LOOPBACK, shown.port), LONG) as page:
            page.sendall(state_of(shown))
            assert status_of(page) == b"HTTP/1.1 200 OK"
        assert status_of(silent[0]) == b""
        for connection in silent[1:]:
            connection.sendall(b"TP/1.1\r\n\r\n" if how == "in the midst" else state_of(shown, wrong="x"))
            assert status_of(connection) == b"HTTP/1.1 404 Not Found"


def test_pages_that_wait_for_news_lose_no_place(shown: Viewer) -> None:
    version = shown.wait(0)
    assert version is not None
    with crowd(shown) as pages:
        for page in pages:
            page.sendall(state_of(shown, version[0]))
        places = shown._server.places
        wait_until(lambda: len(places._answered) == MOST)
        with socket.create_connection((LOOPBACK, shown.port), LONG) as one_more:
            assert status_of(one_more) == b"HTTP/1.1 503 Service Unavailable"
        shown.show(page_state(title="two"))
        for page in pages:
            assert status_of(page) == b"HTTP/1.1 200 OK"


@pytest.mark.parametrize("said", [b"GET / HTTP/1.1\r\nx: ", b""])
def test_who_sends_the_viewer_a_byte_now_and_then_is_closed(
    shown: Viewer, monkeypatch: pytest.MonkeyPatch, said: bytes
) -> None:
    monkeypatch.setattr(connections, "REQUEST_SECONDS", 0.5)
    with socket.create_connection((LOOPBACK, shown.port), LONG) as connection:
        connection.sendall(said)

        def is_closed() -> bool:
            """Send one more byte."""
            try:
                connection.sendall(b"x")
            except OSError:
                return True
            return False

        wait_until(is_closed, 20.0, pause=0.05)


BROWSER = """#!/bin/sh
cat /proc/[0-9]*/cmdline > seen 2>/dev/null
stat -c %a "$1" > mode
cp "$1" page.new && mv page.new page
"""


@line("another user of this machine", "see the address of `asemec view --open` in a list of processes")
def test_the_secret_of_the_viewer_is_on_no_command_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not sys.platform.startswith("linux"):
        pytest.skip("NOT TESTED: command lines are read in /proc")
    folder = project(tmp_path)
    browser = folder / "bin" / "xdg-open"
    browser.parent.mkdir()
    browser.write_text(BROWSER)
    browser.chmod(0o755)
    monkeypatch.setenv("PATH", str(browser.parent), prepend=os.pathsep)
    with running("view", "talk.aseme", "--open", folder=folder):
        wait_until(lambda: (folder / "seen").exists())
        wait_until(
            lambda: (folder / "page").exists() or b"http://127.0.0.1" in (folder / "seen").read_bytes()
        )
    seen = (folder / "seen").read_bytes()
    assert b"http://127.0.0.1" not in seen
    (secret,) = set(re.findall(r"http://127\.0\.0\.1:[0-9]+/([^/]+)/", (folder / "page").read_text()))
    assert secret.encode() not in seen and str(browser).encode() in seen
    assert (folder / "mode").read_text() == "600\n"


@line("team", "`asemec lsp`, `asemec lsp --tcp PORT`")
def test_the_language_server_is_on_the_loopback_interface_if_it_is_asked_to(
    tmp_path: Path, port: int
) -> None:
    if find_spec("pygls") is None:
        pytest.skip("pygls is not installed")
    folder = project(tmp_path)
    with running("lsp", "--tcp", str(port), folder=folder) as process:
        assert wait_until(lambda: internet(process)) == {("127.0.0.1", port)}
    with running("lsp", folder=folder) as process:
        text = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "shutdown"})
        process.stdin.write(f"Content-Length: {len(text)}\r\n\r\n{text}".encode())
        process.stdin.flush()
        assert internet(process) == set()
    assert listed(folder)["asemec lsp"] == ["tcp/127.0.0.1, the port of `--tcp`; nothing without it"]
