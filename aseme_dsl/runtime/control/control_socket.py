"""Control sockets: how operators on the same machine and of the same user reach running teams.

Each process that runs agents listens on a Unix domain socket of its own in a folder for its output folder;
all processes of a team share it. A request is a line of JSON, the reply another; a connection may be used for
several. The folder is one that only the user may enter, found as a team's meeting place is.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import socket
import struct
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.runtime.control.connections import MOST, Places, Timely
from aseme_dsl.runtime.control.control import FORMAT, Control
from aseme_dsl.runtime.control.control import LARGEST as REQUEST
from aseme_dsl.runtime.control.control_log import Origin
from aseme_dsl.runtime.control.replies import Reply, as_reply
from aseme_dsl.runtime.transport.meeting import private_folder
from aseme_dsl.runtime.transport.port import TransportError

LARGEST = 1 << 20
"""A reply has at most so many bytes."""


class ControlError(Exception):
    """A running team cannot be reached, or one cannot listen; the text says why."""


def folder_for(output: Path) -> Path:
    """The folder with the sockets of the runs from an output folder: of the places, the first that is free.

    Raises:
        ControlError: there is none.
    """
    try:
        return private_folder(hashlib.sha256(os.fsencode(output.resolve())).hexdigest()[:16])
    except TransportError as problem:
        raise ControlError(str(problem)) from problem


@contextmanager
def listening(control: Control, output: Path, name: str) -> Iterator[Path]:
    """Inside, requests that come to a socket for this output folder are answered by `control`.

    Raises:
        ControlError: there cannot be such a socket.
    """
    folder = folder_for(output)
    path = folder / f"{_safe(name)}-{os.getpid()}.sock"
    try:
        # Under its name others find it, and remove it if no process listens. It gets the name once one does.
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
    """The sockets of the runs from an output folder; sockets without a listening process are removed."""
    found: list[Path] = []
    try:
        folder = folder_for(output)
    except ControlError:  # nor can anything have listened
        return found
    for path in sorted(folder.glob("*.sock")):
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
                pass  # a process is there that accepts no more connections
        found.append(path)
    return found


def ask(path: Path, request: dict[str, object], timeout: float = 5.0) -> Reply:
    """The reply to a request (without its `version`, which is put in).

    Raises:
        ControlError: there is no answer, or not in time.
    """
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
            connection.settimeout(timeout)
            connection.connect(str(path))
            with contextlib.suppress(BrokenPipeError):  # who takes no request may have said why
                connection.sendall(json.dumps({"version": FORMAT, **request}).encode() + b"\n")
            with connection.makefile("rb") as lines:
                line = lines.readline(LARGEST + 1)
    except TimeoutError as problem:
        raise ControlError(f"{_who(path)} does not answer within {timeout:g} s") from problem
    except OSError as problem:
        raise ControlError(f"{_who(path)} cannot be reached: {problem.strerror or problem}") from problem
    try:
        reply = outside.loads(line, LARGEST)
    except ValueError as problem:
        if line.endswith(b"\n") or len(line) > LARGEST:
            raise ControlError(f"the answer of {_who(path)} cannot be read: {problem}") from problem
        raise ControlError(f"{_who(path)} has ended before it answered") from problem
    if not isinstance(reply, dict):
        raise ControlError(f"{_who(path)} answers with {reply!r}")
    return as_reply(reply)


def _who(path: Path) -> str:
    """Whose socket it is, for people: `process 4711 (robot2)`."""
    name, _, number = path.stem.rpartition("-")
    return f"process {number} ({name})"


def _safe(name: str) -> str:
    return "".join(letter if letter.isalnum() else "_" for letter in name)[:32] or "team"


def _serve(server: socket.socket, control: Control) -> None:
    places = Places()
    while True:
        try:
            connection, _ = server.accept()
        except OSError:  # it was closed: the run is over
            return
        if places.take(connection):
            threading.Thread(
                target=_answer, args=(connection, control, places), name="aseme operator", daemon=True
            ).start()
            continue
        with connection, contextlib.suppress(OSError):
            _refuse(connection, control, f"{MOST} others are being answered")


def _refuse(connection: socket.socket, control: Control, reason: str) -> None:
    """Say why nothing is answered here, to who takes it at once. Raises OSError if it is not taken."""
    reply = control.refuse(Origin("socket", uid=_user_of(connection)), None, reason)
    connection.settimeout(0.0)
    connection.sendall(json.dumps(reply).encode() + b"\n")


def _user_of(connection: socket.socket) -> int | None:
    """The user at the other end; None where the system does not say, and only the folder keeps others out."""
    option = getattr(socket, "SO_PEERCRED", None)
    if option is None:
        return None
    credentials = connection.getsockopt(socket.SOL_SOCKET, option, struct.calcsize("3i"))
    return int(struct.unpack("3i", credentials)[1])


def _answer(connection: socket.socket, control: Control, places: Places) -> None:
    """Answer the requests of a connection until it is closed or silent, or others need its place."""
    with connection, contextlib.suppress(OSError):
        try:
            with contextlib.suppress(OSError):
                _converse(connection, control, places)
        finally:
            kept = places.leave(connection)
        if not kept:
            _refuse(connection, control, f"{MOST} others are connected, and this one had waited longest")


def _converse(connection: socket.socket, control: Control, places: Places) -> None:
    """Raises OSError if nothing is asked, or what is asked or answered takes too long."""
    origin = Origin("socket", uid=_user_of(connection))
    foreign = origin.uid not in (None, os.geteuid())
    coming = Timely(connection)
    lines = BufferedReader(coming)
    while (line := lines.readline(REQUEST + 1)) and places.answer(connection):
        if foreign:
            reply = control.refuse(origin, None, "this socket is for another user")
        else:
            reply = control.read(line, origin)
        places.wait(connection, socket.SHUT_RDWR)  # until the reply is taken
        connection.sendall(json.dumps(reply).encode() + b"\n")
        if foreign or not line.endswith(b"\n"):  # the rest of it would be taken for another request
            return
        places.wait(connection)
        coming.next()
