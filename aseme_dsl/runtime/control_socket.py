"""Control sockets: how operators on the same machine and of the same user reach running teams.

Each process that runs agents listens on a Unix domain socket of its own in a folder for its output folder;
all processes of a team share it. A request is a line of JSON, the reply another; a connection may be used for
several. The folder is in the user's runtime directory ($XDG_RUNTIME_DIR, else the temporary one), since a
socket's path may have no more than about a hundred bytes; only the user may enter it.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import socket
import stat
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from aseme_dsl.runtime.control import FORMAT, Control

ROOM = 32
"""A folder whose path has more bytes leaves too few for the rest of a socket's path."""
LARGEST = 1 << 20
"""A request or reply has at most so many bytes."""
_IDLE_SECONDS = 60.0
"""A connection on which nothing is asked for so long is closed."""


class ControlError(Exception):
    """A running team cannot be reached, or one cannot listen; the text says why."""


def folder_for(output: Path) -> Path:
    """Where the sockets are of what runs from an output folder."""
    places = (os.environ.get("XDG_RUNTIME_DIR", ""), tempfile.gettempdir(), "/tmp")
    root = next((place for place in places if place and len(os.fsencode(place)) <= ROOM), "/tmp")
    return (
        Path(root) / f"asemec-{os.getuid()}" / hashlib.sha256(os.fsencode(output.resolve())).hexdigest()[:16]
    )


@contextmanager
def listening(control: Control, output: Path, name: str) -> Iterator[Path]:
    """Inside, requests that come to a socket for this output folder are answered by `control`.

    Raises:
        ControlError: there cannot be such a socket.
    """
    folder = folder_for(output)
    path = folder / f"{_safe(name)}-{os.getpid()}.sock"
    try:
        _make_private(folder.parent)
        _make_private(folder)
        # Under its name it is found, and removed if nobody listens: it gets that when somebody does.
        early = path.with_suffix(".new")
        early.unlink(missing_ok=True)  # of an earlier process of this number
        server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            server.bind(str(early))
            early.chmod(0o600)
            server.listen()
            early.replace(path)
        except OSError:
            server.close()
            raise
    except OSError as problem:
        raise ControlError(f"{path}: {problem.strerror or problem}") from problem
    thread = threading.Thread(target=_serve, args=(server, control), name="aseme control", daemon=True)
    thread.start()
    try:
        yield path
    finally:
        with contextlib.suppress(OSError):
            path.unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            server.shutdown(socket.SHUT_RDWR)  # wakes the thread
        server.close()
        thread.join(1.0)


def endpoints(output: Path) -> list[Path]:
    """The sockets of what runs from an output folder; those that nobody listens on any more are removed."""
    found: list[Path] = []
    for path in sorted(folder_for(output).glob("*.sock")):
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
            try:
                probe.settimeout(1.0)
                probe.connect(str(path))
            except ConnectionRefusedError:
                with contextlib.suppress(OSError):
                    path.unlink()
                continue
            except FileNotFoundError:
                continue
            except OSError:
                pass  # somebody is there who takes no more connections
        found.append(path)
    return found


def ask(path: Path, request: dict[str, Any], timeout: float = 5.0) -> dict[str, Any]:
    """The reply to a request (without its `version`, which is put in).

    Raises:
        ControlError: nobody answers, or not in time.
    """
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
            connection.settimeout(timeout)
            connection.connect(str(path))
            connection.sendall(json.dumps({"version": FORMAT, **request}).encode() + b"\n")
            with connection.makefile("rb") as lines:
                line = lines.readline(LARGEST)
    except TimeoutError as problem:
        raise ControlError(f"{_who(path)} does not answer within {timeout:g} s") from problem
    except OSError as problem:
        raise ControlError(f"{_who(path)} cannot be reached: {problem.strerror or problem}") from problem
    try:
        reply = json.loads(line)
    except ValueError as problem:
        raise ControlError(f"{_who(path)} has ended before it answered") from problem
    if not isinstance(reply, dict):
        raise ControlError(f"{_who(path)} answers with {reply!r}")
    return reply


def _who(path: Path) -> str:
    """Whose socket it is, for people: `process 4711 (robot2)`."""
    name, _, number = path.stem.rpartition("-")
    return f"process {number} ({name})"


def _make_private(folder: Path) -> None:
    """Make a folder that is the user's alone. Raises OSError if it is somebody else's."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode) or found.st_uid != os.getuid():
        raise PermissionError(1, f"{folder} belongs to somebody else")
    if stat.S_IMODE(found.st_mode) != 0o700:
        folder.chmod(0o700)


def _safe(name: str) -> str:
    return "".join(letter if letter.isalnum() else "_" for letter in name)[:32] or "team"


def _serve(server: socket.socket, control: Control) -> None:
    while True:
        try:
            connection, _ = server.accept()
        except OSError:  # it was closed: the run is over
            return
        threading.Thread(
            target=_answer, args=(connection, control), name="aseme operator", daemon=True
        ).start()


def _answer(connection: socket.socket, control: Control) -> None:
    """Answer the requests of a connection until it is closed or silent."""
    with connection, contextlib.suppress(OSError), connection.makefile("rb") as lines:
        connection.settimeout(_IDLE_SECONDS)
        while line := lines.readline(LARGEST):
            try:
                request = json.loads(line)
            except (ValueError, RecursionError):
                request = None
            if not isinstance(request, dict):
                reason = "a request is a JSON object on a line"
                reply: dict[str, Any] = {"version": FORMAT, "ok": False, "reasons": [reason]}
            else:
                reply = control.handle(request)
            connection.sendall(json.dumps(reply).encode() + b"\n")
