"""Gzip: a trace of JSON lines in a compressed file, a tenth as large, that `zcat` and `zgrep` read.

Each MB of lines is a part that is complete in itself: a killed run leaves what it wrote.
"""

from __future__ import annotations

import contextlib
import gzip
import zlib
from collections.abc import Iterable, Iterator
from io import BufferedReader
from pathlib import Path
from typing import cast

from aseme_dsl import outside
from aseme_dsl.runtime.trace.trace_files import to_disk
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, Torn

MAGIC = b"\x1f\x8b"
PART_BYTES = 1 << 20
LEVEL = 6
"""How hard it is compressed: a match of 130 s becomes 8 MB, at a twentieth of the time that the run takes."""


class GzipFile:
    """Writes lines into a compressed file; a `trace_files.Format`."""

    flush_seconds = 1.0  # a flush ends a part, and small parts are packed badly
    may_flush = False

    def __init__(self, path: Path) -> None:
        """Raises OSError if there cannot be a file at `path`."""
        self._file = outside.new_file(path)
        self._lines: list[bytes] = []
        self._size = 0

    def put(self, lines: Iterable[str]) -> None:
        for line in lines:
            data = f"{line}\n".encode("utf-8", "backslashreplace")
            self._lines.append(data)
            self._size += len(data)
            if self._size >= PART_BYTES:
                self._end_part()

    def _end_part(self) -> None:
        if self._lines:
            self._file.write(gzip.compress(b"".join(self._lines), LEVEL, mtime=0))
            self._lines.clear()
            self._size = 0

    def flush(self) -> None:
        self._end_part()
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


def unpacked_lines(file: BufferedReader) -> Iterator[bytes]:
    """The lines of a compressed trace, with their ends.

    Raises:
        OSError: the file cannot be read, or a line is too long.
        Torn: it is damaged or ends early, which can be after many lines.
    """
    number = 0
    reader = cast(BufferedReader, gzip.GzipFile(fileobj=file))
    try:
        for line in outside.lines(reader, LONGEST):
            yield line
            number += 1
    except (EOFError, gzip.BadGzipFile, zlib.error) as problem:
        raise Torn(number, f"the compressed file is not whole: {problem}") from problem


__all__ = ["MAGIC", "GzipFile", "unpacked_lines"]
