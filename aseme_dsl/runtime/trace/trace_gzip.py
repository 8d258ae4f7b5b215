"""Gzip: a trace of JSON lines in a compressed file, a tenth as large, that `zcat` and `zgrep` read.

Each block of lines is a member of the file, complete in itself, whose header says what is in it. So a reader
finds the place from which it needs the lines, and a killed run leaves all that was flushed.
"""

from __future__ import annotations

import errno
import zlib
from collections.abc import Iterable, Iterator
from io import BufferedReader
from pathlib import Path

from aseme_dsl.runtime.trace.trace_blocks import BLOCK, OPEN, Unpacker, as_far_as_it_goes, packed
from aseme_dsl.runtime.trace.trace_files import JsonLines, encoded
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, Torn

MAGIC = b"\x1f\x8b"
_PIECE = 1 << 16
_AT_ONCE = 1 << 20
"""So many bytes are unpacked at once at most."""
_MUCH, _TIMES = 1 << 30, 200
"""A file that unpacks to more bytes than this, and to so many times its size, is there to fill a memory."""


class GzipFile(JsonLines):
    """Writes lines into a compressed file; a `trace_files.Format`.

    A flush does not end a block: what was flushed is replaced by the whole block later. So the file has the
    same bytes whenever it was flushed.
    """

    flush_seconds = 0.2  # a flush packs the block again

    def __init__(self, path: Path) -> None:
        """Raises OSError if there cannot be a file at `path`."""
        super().__init__(path)
        self._lines: list[str] = []
        self._size = 0
        self._before = 0
        """How many lines there are in the blocks that are complete."""
        self._end = 0
        """Where these end in the file."""
        self._flushed: tuple[int, int] = (0, 0)
        """How many lines of the present block are in the file, and where they end there."""

    def put(self, lines: Iterable[str]) -> None:
        for line in lines:
            self._lines.append(line)
            self._size += len(line) + 1
            if self._size >= BLOCK:
                self._end_block()

    def flush(self) -> None:
        if len(self._lines) != self._flushed[0]:
            if self._file.seekable():
                self._flushed = len(self._lines), self._write(OPEN)
            else:  # a pipe
                self._end_block()
        super().flush()

    def finish(self) -> None:
        if self._lines:
            self._end_block()
        super().finish()

    def _end_block(self) -> None:
        self._end = self._write()
        self._before += len(self._lines)
        self._lines.clear()
        self._size = 0
        self._flushed = 0, self._end

    def _write(self, flags: int = 0) -> int:
        """Write the present block in the place of what was flushed of it; where it ends."""
        block = packed(encoded(self._lines), self._before + 1, flags)
        end = self._end + len(block)
        if self._flushed[0]:
            self._file.seek(self._end)
        self._file.write(block)
        if self._flushed[0] and self._flushed[1] > end:
            self._file.truncate(end)
        return end


def unpacked_lines(file: BufferedReader) -> Iterator[bytes]:
    """The lines of a compressed trace from a block on, with their ends.

    Raises:
        OSError: the file cannot be read, a line is too long, or there is far more in it than in any trace.
        Torn: it is damaged or ends early, which can be after many lines. What stands before that comes first.
    """
    number = 0
    rest = b""
    try:
        for piece in _unpacked(file):
            *lines, rest = (rest + piece).split(b"\n")
            if len(rest) > LONGEST or any(len(line) >= LONGEST for line in lines):
                raise OSError(errno.EFBIG, f"a line is longer than {LONGEST} bytes", file.name)
            for line in lines:
                yield line + b"\n"
                number += 1
    except zlib.error as problem:
        if rest:
            yield rest
        raise Torn(number, f"the compressed file is not whole: {problem}") from problem
    if rest:
        yield rest


def _unpacked(file: BufferedReader) -> Iterator[bytes]:
    """What is in a compressed file, in pieces. Raises OSError and zlib.error, after all that is whole."""
    data = b""
    reader: Unpacker | None = None
    taken = given = 0
    is_full = False
    while is_full or data or (data := file.read(_PIECE)):
        if reader is None:
            data = data.lstrip(b"\0")  # what may fill up a file
            if not data:
                continue
            reader = zlib.decompressobj(zlib.MAX_WBITS + 16)
        before = len(data)
        piece, is_whole = as_far_as_it_goes(reader, data, _AT_ONCE)
        yield piece
        is_full = len(piece) == _AT_ONCE  # there may be more
        if not is_whole:
            raise zlib.error("it is damaged")
        data = reader.unused_data if reader.eof else reader.unconsumed_tail
        taken, given = taken + before - len(data), given + len(piece)
        if given > _MUCH and given > _TIMES * taken:
            reason = f"it unpacks to more than {_TIMES} times its size: it is not a trace"
            raise OSError(errno.EFBIG, reason, file.name)
        if reader.eof:
            reader, is_full = None, False
    if reader is not None:
        raise zlib.error("it breaks off")


__all__ = ["MAGIC", "GzipFile", "unpacked_lines"]
