"""Control sockets: how operators on the same machine and of the same user reach running teams.

Each process that runs agents listens on a Unix domain socket of its own in a folder for its output folder;
all processes of a team share it. The folder is one that only the user may enter, found as a team's meeting
place is. A system without such sockets (Windows) has TCP sockets of this machine. Then a file in the folder
has the port and a secret. An operator proves to have read the secret, and does not send it.

A request is a line of JSON, the reply another; a connection may be used for several.
"""

from __future__ import annotations

import contextlib
import hashlib
import hmac
import json
import os
import secrets
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


LOOPBACK = "127.0.0.1"
SECRET_BYTES = CHALLENGE_BYTES = 32
PROOF_SECONDS = 5.0
"""So long a new connection over TCP has to prove that it knows the secret."""


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
        server = new_socket()
        secret: bytes | None = None
        try:
            if _is_local(server):
                server.bind(str(early))
                early.chmod(0o600)
                server.listen()
            else:
                secret = secrets.token_bytes(SECRET_BYTES)
                server.bind((LOOPBACK, 0))
                server.listen()
                early.write_text(f"{server.getsockname()[1]} {secret.hex()}\n", "ascii")
            early.replace(path)
        except OSError:
            server.close()
            raise
    except OSError as problem:
        raise ControlError(f"{path}: {problem.strerror or problem}") from problem
    thread = threading.Thread(
        target=_serve, args=(server, control, secret), name="aseme control", daemon=True
    )
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
        with new_socket() as probe:
            try:
                probe.settimeout(1.0)
                connect(probe, path)
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
        with new_socket() as connection:
            connection.settimeout(timeout)
            connect(connection, path)
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


def new_socket() -> socket.socket:
    """A socket for requests: a Unix domain socket or, on a system without those, a TCP socket."""
    family = getattr(socket, "AF_UNIX", socket.AF_INET)
    return socket.socket(family, socket.SOCK_STREAM)


def _is_local(connection: socket.socket) -> bool:
    """Whether it is a Unix domain socket: the folder alone keeps other users out."""
    return connection.family != socket.AF_INET


def connect(connection: socket.socket, path: Path) -> None:
    """Connect to the process that `path` stands for; over TCP, prove to have read its file.

    Raises:
        OSError: it cannot be reached.
    """
    if _is_local(connection):
        connection.connect(str(path))
        return
    port, _, secret = outside.read_text(path, 1024).strip().partition(" ")
    try:
        at, key = int(port), bytes.fromhex(secret)
    except ValueError as problem:
        raise OSError(f"{path.name} is not the file of a control socket") from problem
    connection.connect((LOOPBACK, at))
    challenge = _exactly(connection, CHALLENGE_BYTES)
    connection.sendall(hmac.digest(key, challenge, "sha256"))


def _proves(connection: socket.socket, secret: bytes) -> bool:
    """Whether the other end has the secret. Raises OSError if it says nothing."""
    challenge = secrets.token_bytes(CHALLENGE_BYTES)
    connection.settimeout(PROOF_SECONDS)
    connection.sendall(challenge)
    proof = _exactly(connection, hashlib.sha256().digest_size)
    return hmac.compare_digest(proof, hmac.digest(secret, challenge, "sha256"))


def _exactly(connection: socket.socket, size: int) -> bytes:
    found = b""
    while len(found) < size:
        piece = connection.recv(size - len(found))
        if not piece:
            raise ConnectionResetError("the other end has hung up")
        found += piece
    return found


def label_of(path: Path) -> str:
    """The agent whose socket it is; that of a process with several is called `team`."""
    return path.stem.rpartition("-")[0]


def _who(path: Path) -> str:
    """Whose socket it is, for people: `process 4711 (robot2)`."""
    name, _, number = path.stem.rpartition("-")
    return f"process {number} ({name})"


def _safe(name: str) -> str:
    return "".join(letter if letter.isalnum() else "_" for letter in name)[:32] or "team"


def _serve(server: socket.socket, control: Control, secret: bytes | None) -> None:
    places = Places()
    while True:
        try:
            connection, _ = server.accept()
        except OSError:  # it was closed: the run is over
            return
        if places.take(connection):
            threading.Thread(
                target=_answer,
                args=(connection, control, places, secret),
                name="aseme operator",
                daemon=True,
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


def _answer(connection: socket.socket, control: Control, places: Places, secret: bytes | None) -> None:
    """Answer the requests of a connection until it is closed or silent, or others need its place."""
    with connection, contextlib.suppress(OSError):
        try:
            with contextlib.suppress(OSError):
                if secret is None or _proves(connection, secret):
                    _converse(connection, control, places)
        finally:
            kept = places.leave(connection)
        if not kept:
            _refuse(connection, control, f"{MOST} others are connected, and this one had waited longest")


def _converse(connection: socket.socket, control: Control, places: Places) -> None:
    """Raises OSError if nothing is asked, or what is asked or answered takes too long."""
    origin = Origin("socket", uid=_user_of(connection))
    foreign = origin.uid is not None and origin.uid != os.geteuid()
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
