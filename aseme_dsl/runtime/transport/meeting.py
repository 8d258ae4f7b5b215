"""Meeting places: how the processes of a team find each other on one machine.

A team has a folder that only its user may enter. The folder has a Unix socket for each process, and the
secret by which the processes authenticate each other. A process joins under a lock: it removes the sockets of
processes that have ended, connects to all others, and listens on a new socket of its own. So of each two
processes the later one connects. A process that finds no other one makes a new secret.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import secrets
import socket
import stat
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.transport.port import TransportError

ROOM = 32
"""A folder whose path has more bytes leaves too few for the rest of a socket's path."""
SECRET_BYTES = 32
_PATIENCE = 10.0
"""How long, in seconds, others may take to join before we do."""


@dataclass(frozen=True, slots=True)
class Meeting:
    """Where to listen, to whom to connect, and the secret of those who are there."""

    own: Path
    others: tuple[Path, ...]
    secret: bytes


def check_meeting() -> None:
    """Raises TransportError where this system has nothing over which processes meet."""
    if not hasattr(socket, "AF_UNIX"):
        raise TransportError(
            "agents in several processes of one machine meet over Unix sockets, which this system does not"
            " have: run the team in one process"
        )


@contextmanager
def joining(system: str, name: str) -> Iterator[Meeting]:
    """Hold the lock under which one process at a time joins the team; listen on `own` before the block ends.

    Raises:
        TransportError: there is no private folder of this user, or another process takes too long to join.
    """
    folder = meeting_place(system)
    check_meeting()
    try:
        with _locked(folder / "lock"):
            others = tuple(path for path in sorted(folder.glob("*.sock")) if _is_live(path))
            short = re.sub("[^A-Za-z0-9_]", "_", name)[:12]
            own = folder / f"{short}-{secrets.token_hex(4)}.sock"
            yield Meeting(own, others, _secret(folder / "secret", new=not others))
    except OSError as problem:
        raise TransportError(
            f"robots on this machine cannot meet in {folder}: {problem.strerror or problem}"
        ) from problem


def meeting_place(system: str) -> Path:
    """The private folder of a team, which is made if it does not exist.

    It is below the first usable one of `$XDG_RUNTIME_DIR`, `/run/user/UID`, the temporary folder and the
    user's cache folder. So another user cannot block a team by taking its folder's name.

    Raises:
        TransportError: none can be used.
    """
    return private_folder(f"bus-{hashlib.sha256(system.encode()).hexdigest()[:16]}")


def private_folder(name: str) -> Path:
    """A folder of the user's own for sockets; see `meeting_place`.

    Raises:
        TransportError: none can be used.
    """
    if not hasattr(os, "getuid"):
        return _folder_of_profile(name)
    reasons: list[str] = []
    for root in _roots():
        folder = root / f"asemec-{os.getuid()}"
        try:
            _check_root(root)
            _make_private(folder)
            _make_private(folder / name)
        except OSError as problem:
            reasons.append(f"{problem.filename or root}: {problem.strerror}")
        else:
            return folder / name
    raise TransportError(
        "there is no folder in which robots on this machine can meet"
        f" ({'; '.join(reasons)}): set XDG_RUNTIME_DIR to a folder of your own with a short path"
    )


def _folder_of_profile(name: str) -> Path:
    """A folder in the user's profile, which on Windows only that user and administrators may enter."""
    try:
        given = os.environ.get("LOCALAPPDATA")
        folder = (Path(given) if given else Path.home()) / "asemec" / name
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, RuntimeError) as problem:
        raise TransportError(f"the user's profile cannot be used: {problem}") from problem
    return folder


def _roots() -> Iterator[Path]:
    given = os.environ.get("XDG_RUNTIME_DIR")
    if given:
        yield Path(given)
    for place in (Path(f"/run/user/{os.getuid()}"), Path(tempfile.gettempdir()), Path("/tmp")):
        if place.is_dir():
            yield place
    with contextlib.suppress(RuntimeError):  # the user has no home
        yield Path.home() / ".cache"


def _check_root(root: Path) -> None:
    """Raises OSError if a user other than this one and root can replace the contents of a folder."""
    if not root.is_absolute() or len(os.fsencode(root)) > ROOM or re.search("[#?]", str(root)):
        raise OSError(22, "a socket cannot have such a path", str(root))
    if root.name == ".cache":
        root.mkdir(mode=0o700, exist_ok=True)
    whole = root.resolve()
    for folder in (whole, *whole.parents):
        found = folder.stat()
        if found.st_uid not in (0, os.getuid()):
            raise OSError(1, "it belongs to another user", str(folder))
        if found.st_mode & 0o022 and not found.st_mode & stat.S_ISVTX:
            raise OSError(1, "others may replace what is in it", str(folder))


def _make_private(folder: Path) -> None:
    """Make a folder that only this user can enter. Raises OSError if it belongs to another user."""
    folder.mkdir(mode=0o700, exist_ok=True)
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode) or found.st_uid != os.getuid():
        raise OSError(1, "it belongs to another user", str(folder))
    if found.st_mode & 0o022:  # others may have put something in it
        folder.rmdir()
        folder.mkdir(mode=0o700)
    elif stat.S_IMODE(found.st_mode) != 0o700:
        folder.chmod(0o700)


@contextmanager
def _locked(path: Path) -> Iterator[None]:
    import fcntl

    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    try:
        deadline = time.monotonic() + _PATIENCE
        while True:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > deadline:
                    raise OSError(11, f"a process has been joining for {_PATIENCE:g} s") from None
                time.sleep(0.005)
        yield
    finally:
        os.close(descriptor)


def _is_live(path: Path) -> bool:
    """Whether a process listens on a socket: it holds the lock beside it. Removes both if it has ended."""
    import fcntl

    lock = path.with_name(f"{path.name}.lock")
    with contextlib.suppress(FileNotFoundError):
        descriptor = os.open(lock, os.O_RDWR | os.O_CLOEXEC | os.O_NOFOLLOW)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        finally:
            os.close(descriptor)
    path.unlink(missing_ok=True)
    lock.unlink(missing_ok=True)
    return False


def _secret(path: Path, *, new: bool) -> bytes:
    if not new:
        with contextlib.suppress(FileNotFoundError):
            found = outside.read_bytes(path)
            if len(found) == SECRET_BYTES:
                return found
        raise OSError(2, f"{path.name} is missing, and robots of the team are running: start them again")
    made = secrets.token_bytes(SECRET_BYTES)
    early = path.with_suffix(".new")
    early.unlink(missing_ok=True)
    descriptor = os.open(early, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    with os.fdopen(descriptor, "wb") as file:
        file.write(made)
    early.replace(path)
    return made
