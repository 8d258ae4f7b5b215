"""What comes from outside is bounded: files must be regular files, and JSON has a largest size and depth.

The writer of a file and the sender of a request decide what is in it. A pipe would stop its reader for ever,
and a hundred thousand nested brackets would end it.
"""

from __future__ import annotations

import errno
import os
import re
import stat
from collections.abc import Iterator
from io import BufferedReader, BufferedWriter
from pathlib import Path

LARGEST = 256 << 20
"""The largest file, in bytes, that is read as a whole, unless its reader says otherwise."""
DEEPEST = 100
"""So many lists and objects may stand in each other in JSON: far below what Python's own stack bears."""

_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)

# A text is matched as a whole, closed or not. The rest behind an open text has no structure, and each
# character is looked at once.
_STRUCTURE = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"?|[\[\]{}]', re.DOTALL)


def open_file(path: str | os.PathLike[str]) -> BufferedReader:
    """A regular file, opened for reading; links are followed.

    Raises:
        OSError: it cannot be opened, or it is a folder, a pipe, a socket or a device. None of these is
            waited for.
    """
    try:
        _check_regular(Path(path).stat(), path)  # opening a device may already do something
        descriptor = os.open(path, os.O_RDONLY | _AT_ONCE)
    except ValueError as problem:  # a NUL in the name
        raise OSError(errno.EINVAL, "not the name of a file", os.fspath(path)) from problem
    file = os.fdopen(descriptor, "rb")
    try:
        _check_regular(os.fstat(descriptor), path)  # it may be another by now
    except OSError:
        file.close()
        raise
    return file


def _check_regular(found: os.stat_result, path: str | os.PathLike[str]) -> None:
    if stat.S_ISDIR(found.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, "not a regular file", os.fspath(path))


def is_file(path: Path) -> bool:
    """Whether there is a file of that name, which a document gives: one that is too long is that of none."""
    try:
        return path.is_file()
    except OSError:
        return False


def read_bytes(path: str | os.PathLike[str], largest: int = LARGEST) -> bytes:
    """All of a regular file.

    Raises:
        OSError: as `open_file`, or it has more than `largest` bytes.
    """
    with open_file(path) as file:
        content = file.read(largest + 1)
    if len(content) > largest:
        reason = f"larger than {largest >> 20} MB" if largest >= 1 << 20 else f"larger than {largest} bytes"
        raise OSError(errno.EFBIG, reason, os.fspath(path))
    return content


def holds(path: str | os.PathLike[str], content: bytes) -> bool:
    """Whether there is a regular file with exactly these bytes."""
    try:
        return read_bytes(path, len(content)) == content
    except OSError:
        return False


def lines(file: BufferedReader, longest: int = LARGEST) -> Iterator[bytes]:
    """The lines that are left of a file, with their ends.

    Raises:
        OSError: the file cannot be read, or a line has more than `longest` bytes.
    """
    while line := file.readline(longest + 1):
        if len(line) > longest:
            raise OSError(errno.EFBIG, f"a line is longer than {longest} bytes", file.name)
        yield line


def new_file(path: str | os.PathLike[str]) -> BufferedWriter:
    """A file, opened for writing; it is made, or emptied, and links are followed.

    A device takes all, too, and so does a pipe that has a reader.

    Raises:
        OSError: it cannot be written, or it is a pipe without a reader, which is not waited for.
    """
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | _AT_ONCE, 0o666)
    except ValueError as problem:  # a NUL in the name
        raise OSError(errno.EINVAL, "not the name of a file", os.fspath(path)) from problem
    if hasattr(os, "O_NONBLOCK"):
        os.set_blocking(descriptor, True)
    return os.fdopen(descriptor, "wb")


def read_text(path: str | os.PathLike[str], largest: int = LARGEST, encoding: str = "utf-8") -> str:
    """The same as a text; line ends become `\\n`.

    Raises:
        OSError: as `read_bytes`.
        UnicodeDecodeError: it is not a text of this encoding.
    """
    text = read_bytes(path, largest).decode(encoding)
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def loads(data: str | bytes, largest: int = LARGEST, deepest: int = DEEPEST) -> object:
    """What a piece of JSON says (UTF-8, if bytes).

    Raises:
        ValueError: it is not JSON, too large, or too deep.
    """
    if len(data) > largest:
        raise ValueError(f"larger than {largest} bytes")
    text = data if isinstance(data, str) else data.decode("utf-8")
    if text.count("[") + text.count("{") > deepest and depth(text) > deepest:
        raise ValueError(f"more than {deepest} lists and objects in each other")
    import json  # most commands read none

    found: object = json.loads(text)
    return found


def depth(text: str) -> int:
    """How many brackets of a piece of JSON are open at once at the most, those in its texts left out."""
    usual = _depth_of_pairs(text)
    if usual is not None:
        return usual
    now = most = 0
    for found in _STRUCTURE.finditer(text):
        match text[found.start()]:
            case "[" | "{":
                now += 1
                most = max(most, now)
            case "]" | "}":
                now -= 1
            case _:
                pass
    return most


def _depth_of_pairs(text: str) -> int | None:
    """The depth of a text whose brackets are closed one and all, and no deeper than most; else None.

    It takes a tenth of the time: innermost pairs are removed until nothing is left. A backslash that is in no
    text of it may make a difference; no parser of JSON comes further than that.
    """
    data = text.encode("utf-8", "replace")
    if b"\\" in data:
        data = data.replace(b"\\\\", b"").replace(b'\\"', b"")
    rest = b"".join(data.split(b'"')[::2]).translate(_AS_SQUARE, _NO_BRACKETS)
    for number in range(_USUAL_DEPTH):
        if not rest:
            return number
        rest = rest.replace(b"[]", b"")
    return None


_USUAL_DEPTH = 20
_AS_SQUARE = bytes.maketrans(b"{}", b"[]")
_NO_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))
