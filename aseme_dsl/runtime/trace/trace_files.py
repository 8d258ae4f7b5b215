"""Trace files: the lines of a run on disk: JSON lines, by their suffix compressed (`.gz`) or MCAP (`.mcap`).

A trace has its own name only when it is complete; until then it is `NAME.part`. So a full disk or a broken
run does not destroy an earlier trace of that name.
"""

from __future__ import annotations

import contextlib
import errno
import os
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import IO, Protocol

from aseme_dsl import outside

FORMAT = 2
"""The version of the format. The kinds of records had other names in 1."""
MCAP_SUFFIX = ".mcap"
GZIP_SUFFIX = ".gz"
PART = ".part"
USUAL = "trace.jsonl.gz"
"""The name of a trace in the output directory, if no other is given."""
MOST_LINES = 50_000
"""So many lines wait for the disk at most."""
GATHER_SECONDS = 0.05
"""In real time, lines are handed to the disk together, this often."""
FLUSH_SECONDS = 1.0
"""In virtual time, a trace of JSON lines is handed to the system after this time at the latest."""
SYNC_SECONDS = 5.0
"""In real time, what was written is on the disk after this time: little is left for the end of a run."""
CLOSE_SECONDS = 1.0
"""How long the end of a run waits for a slow disk."""


class TraceError(Exception):
    """A trace cannot be written or read as it was asked for; the text says why."""


class Format(Protocol):
    """A kind of trace file. Its methods raise OSError when the disk refuses."""

    flush_seconds: float
    """How long at most a line of a run in real time may stay in this process."""
    may_flush: bool
    """Whether flushing leaves the bytes of the file as they would be without."""

    def put(self, lines: Iterable[str]) -> None:
        """Write lines, without their ends."""
        ...

    def flush(self) -> None:
        """Hand everything to the system: it stays even if this process is killed."""
        ...

    def sync(self) -> None:
        """Wait until what was flushed is on the disk."""
        ...

    def finish(self) -> None:
        """Write what belongs to the end of the file, put it on the disk, and close it."""
        ...

    def abandon(self) -> None:
        """Close the file as it is. Raises nothing."""
        ...


class JsonLines:
    """A file of JSON lines."""

    flush_seconds = GATHER_SECONDS
    may_flush = True

    def __init__(self, path: Path) -> None:
        """Raises OSError if there cannot be a file at `path`."""
        self._file = outside.new_file(path)

    def put(self, lines: Iterable[str]) -> None:
        self._file.write(encoded(lines))

    def flush(self) -> None:
        self._file.flush()

    def sync(self) -> None:
        to_disk(self._file)

    def finish(self) -> None:
        self.flush()
        to_disk(self._file)
        self._file.close()

    def abandon(self) -> None:
        with contextlib.suppress(OSError, ValueError):  # the disk is still full
            self._file.close()


def encoded(lines: Iterable[str]) -> bytes:
    """Lines as they stand in a file, with their ends."""
    # A text may hold half a surrogate pair; written with a backslash it is JSON's own escape.
    return "".join([f"{line}\n" for line in lines]).encode("utf-8", "backslashreplace")


def to_disk(file: IO[str] | IO[bytes]) -> None:
    """Wait until a file is on its disk, if it is a file on a disk."""
    try:
        os.fsync(file.fileno())
    except OSError as error:
        if error.errno not in (errno.EINVAL, errno.ENOTSUP):  # a pipe, a device
            raise


def name_for(agent: str, name: str = USUAL) -> str:
    """What the trace of one agent is called beside one of this name."""
    suffixes = Path(name).suffixes
    suffix = "".join(suffixes[-2:] if suffixes[-1:] == [GZIP_SUFFIX] else suffixes[-1:])
    return f"{name.removesuffix(suffix)}.{agent}{suffix}"


def part_of(path: Path) -> Path:
    """Where a trace is while it is written."""
    return path.with_name(path.name + PART)


class Output(Protocol):
    """Where a trace's lines go."""

    def put(self, line: str) -> None:
        """Write a line. Raises OSError."""
        ...

    def has_room(self, again: bool) -> bool:
        """Whether another line can be taken; `again`: after one could not."""
        ...

    def close(self) -> None:
        """Put everything on disk. Raises OSError."""
        ...

    def abandon(self) -> None:
        """Give the file up."""
        ...


class Direct:
    """The thread that records a line writes it: in virtual time this delays no agent."""

    def __init__(self, file: Format) -> None:
        self._file = file
        self._flushed = time.monotonic()

    def put(self, line: str) -> None:
        self._file.put((line,))
        if self._file.may_flush and time.monotonic() - self._flushed > FLUSH_SECONDS:
            self._file.flush()
            self._flushed = time.monotonic()

    def has_room(self, again: bool) -> bool:
        return True

    def close(self) -> None:
        self._file.finish()

    def abandon(self) -> None:
        self._file.abandon()


class Background:
    """Lines wait for a thread that writes them: in real time no step waits for a disk."""

    def __init__(self, file: Format, failed: Callable[[Exception], None]) -> None:
        """`failed` gets the reason, in that thread, when nothing can be written any more."""
        self._file = file
        self._failed = failed
        self._waiting: deque[str] = deque()
        self._closing = threading.Event()
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="aseme trace", daemon=True)
        self._thread.start()

    def put(self, line: str) -> None:
        self._waiting.append(line)

    def has_room(self, again: bool) -> bool:
        # Once full, it is taken up again only when there is room for more than the next few lines.
        return len(self._waiting) < (MOST_LINES // 2 if again else MOST_LINES)

    def close(self) -> None:
        self._closing.set()
        self._thread.join(CLOSE_SECONDS)
        if self._thread.is_alive():
            raise OSError(
                f"the disk is too slow: {len(self._waiting)} lines and more were still to be written"
            )
        if self._error is not None:
            raise OSError(reason_of(self._error)) from self._error

    def abandon(self) -> None:
        """The thread closes the file, since it may be in the midst of writing."""
        self._waiting.clear()
        self._closing.set()

    def _run(self) -> None:
        flushed = synced = time.monotonic()
        try:
            closing = False
            while not closing:
                closing = self._closing.wait(GATHER_SECONDS)
                number = len(self._waiting)
                if number:
                    self._file.put([self._waiting.popleft() for _ in range(number)])
                if time.monotonic() - flushed >= self._file.flush_seconds:
                    self._file.flush()
                    flushed = time.monotonic()
                if time.monotonic() - synced >= SYNC_SECONDS:
                    self._file.sync()
                    synced = time.monotonic()
            self._file.finish()
        except Exception as error:  # the run must hear of each error
            self._error = error
            self._file.abandon()
            if not self._closing.is_set():
                self._failed(error)


def reason_of(error: Exception) -> str:
    """What an error says, without its number."""
    return getattr(error, "strerror", None) or str(error)
