"""Following: the lines of a trace while it is being written."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from aseme_dsl import outside
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_files import TraceError, part_of, reason_of
from aseme_dsl.runtime.trace.trace_gzip import MAGIC as GZIP_MAGIC
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, MAGIC
from aseme_dsl.runtime.trace.trace_reading import record_of

_AT_ONCE = 1 << 20
"""So many bytes are read at once."""


class TraceFollower:
    """A trace that a run writes, or will write: `NAME.part` until it is complete, `NAME` then.

    A follower that begins before the run waits for it. A run that begins anew in the same place is followed
    from its begin. The first poll gives the records that are there already, too. A folder is not a trace.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.finished = False
        """Whether the run has ended: its last line was read."""
        self._file: BinaryIO | None = None
        self._rest = b""

    def poll(self) -> Iterator[Record]:
        """The records that were written since it was looked at last; it waits for nothing.

        Raises:
            TraceError: it cannot be read, or is not text: an MCAP file, or a compressed one.
        """
        try:
            if self._file is None or self._is_another(self._file):
                self._open()
            if self._file is None:
                return
            while piece := self._file.read(_AT_ONCE):
                yield from self._records(piece)
        except OSError as problem:
            raise TraceError(f"{self.path} cannot be read: {reason_of(problem)}") from problem

    def _records(self, piece: bytes) -> Iterator[Record]:
        """The records that end in a piece of the file."""
        *lines, self._rest = (self._rest + piece).split(b"\n")
        if (lines or [self._rest])[0].startswith(MAGIC):
            raise TraceError(f"{self.path} is MCAP: it can be read when the run has ended, and not followed")
        if (lines or [self._rest])[0].startswith(GZIP_MAGIC):
            raise TraceError(f"{self.path} is compressed: it can be read when the run has ended")
        if len(self._rest) > LONGEST:
            raise TraceError(f"{self.path} cannot be read: a line is longer than {LONGEST} bytes")
        for line in lines:
            record = record_of(line.decode("utf-8", "replace"))
            if record is not None:
                self.finished = record["kind"] == "finish"
                yield record

    def close(self) -> None:
        """Let the file go."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def _open(self) -> None:
        self.close()
        self._rest = b""
        self.finished = False
        for path in (part_of(self.path), self.path):
            with suppress(FileNotFoundError, IsADirectoryError):
                self._file = outside.open_file(path)
                return

    def _is_another(self, file: BinaryIO) -> bool:
        """Whether another run writes there now than the one that is being read."""
        mine = os.fstat(file.fileno())
        if mine.st_size < file.tell():
            return True
        with suppress(FileNotFoundError):
            there = part_of(self.path).stat()
            return (there.st_dev, there.st_ino) != (mine.st_dev, mine.st_ino)
        return False


__all__ = ["TraceFollower"]
