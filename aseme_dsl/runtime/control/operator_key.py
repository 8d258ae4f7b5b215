"""Operators' keys: who has one may control robots over their network.

A file of keys is TOML: a name for each key, and its 32 bytes in hexadecimal. A robot accepts each key in its
file, and reads the file again for each request: a key is added or removed while the team runs.

    k3f9a2c81 = "5d0c…"
    k9c01b7e2 = { ann = "77ab…", bob = "01fe…" }

The second key has only what follows from it for two robots. With it, neither can pass for an operator to
another robot.
"""

from __future__ import annotations

import contextlib
import hmac
import json
import os
import re
import secrets
import stat
from collections.abc import Iterable, Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.versions import IS_POSIX, VersionError, check_place

SECRET_BYTES = 32
LARGEST = 1 << 14
"""A file of keys has at most so many bytes."""
_NAME = re.compile("[A-Za-z0-9_-]{1,64}")
_SECRET = re.compile(f"[0-9a-f]{{{2 * SECRET_BYTES}}}")


class KeyFileError(Exception):
    """A file of keys cannot be used; the text says why, and has nothing of what is in it."""


@dataclass(frozen=True, slots=True)
class Key:
    """A key, and the name under which robots know it."""

    name: str
    secret: bytes = field(repr=False)
    """Empty if only what follows from it for some robots is known."""
    robots: Mapping[str, bytes] = field(default_factory=dict, repr=False)
    """What follows from it for each of these robots."""

    def of(self, robot: str) -> bytes | None:
        """What proves to a robot, and of it, that this key is known; None: it is not known for this robot."""
        if self.secret:
            return hmac.digest(self.secret, b"asemec key of a robot 1\0" + robot.encode(), "sha256")
        return self.robots.get(robot)


def proof(what: str, key: bytes, about: Iterable[str], *contents: bytes) -> str:
    """The HMAC-SHA256 of all parts with their lengths: none can pass for a part of another."""
    parts = [f"asemec control {what} 1".encode(), *(part.encode() for part in about), *contents]
    whole = b"".join(len(part).to_bytes(8, "big") + part for part in parts)
    return hmac.digest(key, whole, "sha256").hex()


def read_keys(path: Path) -> Mapping[str, Key]:
    """The keys of a file by name, in their order in it.

    Raises:
        KeyFileError: it cannot be read, is not such a file, or another user may read or replace it.
    """
    import tomllib

    try:
        check_place(path.absolute())
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(descriptor, "rb") as file:
            found = os.fstat(descriptor)
            if not stat.S_ISREG(found.st_mode):
                raise KeyFileError(f"{path} is not a regular file")
            if IS_POSIX and found.st_uid != os.geteuid():
                raise KeyFileError(f"{path} belongs to another user ({found.st_uid})")
            if IS_POSIX and found.st_mode & 0o077:
                raise KeyFileError(f"{path} is open to other users: run `chmod 600` on it")
            content = file.read(LARGEST + 1)
    except VersionError as problem:
        raise KeyFileError(str(problem)) from problem
    except OSError as problem:
        raise KeyFileError(f"{path} cannot be read: {problem.strerror or problem}") from problem
    if len(content) > LARGEST:
        raise KeyFileError(f"{path} is larger than {LARGEST} bytes")
    try:
        document = tomllib.loads(content.decode("utf-8"))
    except (ValueError, RecursionError):  # what tomllib says may quote a key
        raise KeyFileError(f"{path} is not valid TOML") from None
    keys: dict[str, Key] = {}
    for name, secret in document.items():
        if not _NAME.fullmatch(name):
            raise KeyFileError(f"{path}: the name of a key has up to 64 letters, digits, `_` and `-`")
        each = secret if isinstance(secret, dict) else {"": secret}
        if not all(isinstance(item, str) and _SECRET.fullmatch(item) for item in each.values()):
            raise KeyFileError(f"{path}: the key {name} is not {2 * SECRET_BYTES} hexadecimal digits")
        known = {robot: bytes.fromhex(item) for robot, item in each.items()}
        keys[name] = Key(name, known.pop("", b""), known)
    return keys


def newest_key(path: Path) -> Key:
    """The last key of a file. Raises KeyFileError."""
    keys = list(read_keys(path).values())
    if not keys:
        raise KeyFileError(f"{path} has no key")
    return keys[-1]


def write_key(path: Path) -> Key:
    """Make a key, and a file with it that only the user may read.

    Raises:
        KeyFileError: there is such a file already, or it cannot be written.
    """
    key = Key(f"k{secrets.token_hex(4)}", secrets.token_bytes(SECRET_BYTES))
    _write(path, f'{key.name} = "{key.secret.hex()}"\n'.encode("ascii"))
    return key


def _write(path: Path, content: bytes) -> None:
    try:
        write_new(path, content, 0o600)
    except FileExistsError as problem:
        raise KeyFileError(f"{path} is there already") from problem
    except OSError as problem:
        raise KeyFileError(f"{path} cannot be written: {problem.strerror or problem}") from problem


def keys_for(path: Path, robots: Iterable[str]) -> bytes:
    """The content of a file with the keys of this one, as they are for some robots only.

    Raises:
        KeyFileError: it cannot be used, or has a key that is not known for one of the robots.
    """
    lines: list[str] = []
    wanted = tuple(robots)
    for key in read_keys(path).values():
        found = {robot: key.of(robot) for robot in wanted}
        items = [f'{_quoted(robot)} = "{item.hex()}"' for robot, item in found.items() if item is not None]
        if len(items) < len(found):
            raise KeyFileError(f"{path}: the key {key.name} is for other agents")
        lines.append(f"{key.name} = {{ {', '.join(items)} }}\n")
    return "".join(lines).encode()


def write_keys_for(path: Path, source: Path, robots: Iterable[str]) -> None:
    """Write such a file, which only the user may read. Raises KeyFileError as `write_key` does."""
    content = keys_for(source, robots)
    _write(path, content)


def _quoted(name: str) -> str:
    return json.dumps(name, ensure_ascii=False)


def write_new(path: Path, content: bytes, mode: int) -> None:
    """Write a file that is not there yet, whole or not at all, with these permissions.

    Raises:
        FileExistsError: there is such a file.
        OSError: it cannot be written.
    """
    part = path.with_name(f".{path.name}.{secrets.token_hex(4)}.part")
    descriptor = os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
        os.link(part, path)  # unlike a renaming, it replaces nothing
    finally:
        with contextlib.suppress(OSError):
            part.unlink()
