"""Following: the lines of traces while they are being written."""

from __future__ import annotations

import os
import zlib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from io import BufferedReader
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.project.playing.merging import Beginning, shifts
from aseme_dsl.project.settings.target import traces_of
from aseme_dsl.runtime.trace.records import Record, as_record
from aseme_dsl.runtime.trace.trace_blocks import Damaged, is_ours, packed_blocks, unpacked
from aseme_dsl.runtime.trace.trace_check import wrong_in
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
        self._file: BufferedReader | None = None
        self._rest = b""
        self._seen = 0
        """How many lines of the present block of a compressed trace were read."""
        self._number = 0
        self._skipped: list[int] = []
        """The numbers of the lines that are not records."""

    @property
    def problem(self) -> str | None:
        """What is to be said of lines that were skipped, if some were."""
        if not self._skipped:
            return None
        count = len(self._skipped)
        lines = "a line is not a record" if count == 1 else f"{count} lines are not records"
        return f"{self.path}: {lines} of a trace; the first is line {self._skipped[0]}"

    def poll(self) -> Iterator[Record]:
        """The records that were written since it was looked at last; it waits for nothing.

        Raises:
            TraceError: it cannot be read, or is damaged; it is an MCAP file, or another program has
                compressed it.
        """
        try:
            if self._file is None or self._is_another(self._file):
                self._open()
            if self._file is None:
                return
            if self._is_packed(self._file):
                yield from self._packed(self._file)
            else:
                while piece := self._file.read(_AT_ONCE):
                    yield from self._records(piece)
        except OSError as problem:
            raise TraceError(f"{self.path} cannot be read: {reason_of(problem)}") from problem
        except Damaged as problem:
            raise TraceError(f"{self.path} cannot be read: {problem}") from problem

    def _is_packed(self, file: BufferedReader) -> bool:
        place = file.tell()
        file.seek(0)
        start = file.read(len(GZIP_MAGIC))
        file.seek(place)
        return start == GZIP_MAGIC

    def _packed(self, file: BufferedReader) -> Iterator[Record]:
        """The records of the blocks from the present one on; the last one may still grow."""
        offset = file.tell()
        blocks = list(packed_blocks(file, offset))
        if not blocks and not offset and not is_ours(file):
            raise TraceError(f"{self.path} was compressed by another program: it cannot be followed")
        for block in blocks:
            file.seek(offset)
            try:
                *lines, _ = unpacked(file.read(block.size)).split(b"\n")
            except zlib.error:  # it is just being written
                file.seek(offset)
                break
            before, self._seen = self._seen, len(lines) if block.is_open else 0
            if not block.is_open:
                offset += block.size
            file.seek(offset)
            for line in lines[before:]:
                yield from self._record(line)

    def _records(self, piece: bytes) -> Iterator[Record]:
        """The records that end in a piece of the file."""
        *lines, self._rest = (self._rest + piece).split(b"\n")
        if (lines or [self._rest])[0].startswith(MAGIC):
            raise TraceError(f"{self.path} is MCAP: it can be read when the run has ended, and not followed")
        if len(self._rest) > LONGEST:
            raise TraceError(f"{self.path} cannot be read: a line is longer than {LONGEST} bytes")
        for line in lines:
            yield from self._record(line)

    def _record(self, line: bytes) -> Iterator[Record]:
        self._number += 1
        record = record_of(line.decode("utf-8", "replace"))
        if record is None:
            self._skipped.append(self._number)
        else:
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
        self._seen = self._number = 0
        self._skipped.clear()
        self.finished = False
        for path in (part_of(self.path), self.path):
            with suppress(FileNotFoundError, IsADirectoryError):
                self._file = outside.open_file(path)
                return

    def _is_another(self, file: BufferedReader) -> bool:
        """Whether another run writes there now than the one that is being read."""
        mine = os.fstat(file.fileno())
        if mine.st_size < file.tell():
            return True
        with suppress(FileNotFoundError):
            there = part_of(self.path).stat()
            return (there.st_dev, there.st_ino) != (mine.st_dev, mine.st_ino)
        return False


class RunFollower:
    """The traces of the processes of one run, which write them or will write them."""

    def __init__(self, paths: Sequence[Path]) -> None:
        """A folder stands for the trace of the run that will begin there."""
        self._traces = [TraceFollower(path) for path in paths]
        self._lines = [0 for _ in paths]
        self._began: dict[int, Beginning] = {}
        self._shifts: dict[int, int] = {}

    @property
    def finished(self) -> bool:
        """Whether all have ended."""
        return all(item.finished for item in self._traces)

    @property
    def problems(self) -> tuple[tuple[Path, str], ...]:
        """What is to be said of lines that were skipped, and of which traces."""
        found = ((item.path, item.problem) for item in self._traces)
        return tuple((path, problem) for path, problem in found if problem is not None)

    def path(self, number: int) -> Path:
        """The path of the trace with this number (from 0)."""
        return self._traces[number].path

    def poll(self) -> Iterator[tuple[int, Record]]:
        """The records that were written since it was looked at last, with the numbers of their traces.

        Raises:
            TraceError: as `TraceFollower.poll`, or a record is damaged.
        """
        for number, trace in enumerate(self._traces):
            if trace.path.is_dir():  # before the first run the name of its trace is not known
                trace = self._traces[number] = TraceFollower(*traces_of(trace.path, following=True)[0])
            for record in trace.poll():
                self._check(number, record)
                if record["kind"] in ("header", "peer"):
                    self._began.setdefault(number, Beginning()).add(record)
                    found = shifts(list(self._began.values()))
                    self._shifts = dict(zip(self._began, found, strict=True))
                yield number, record

    def _check(self, number: int, record: Record) -> None:
        self._lines[number] = 1 if record["kind"] == "header" else self._lines[number] + 1
        wrong = wrong_in(record)
        if wrong is not None:
            place, kind = f"{self.path(number)}:{self._lines[number]}", repr(record["kind"][:40])
            raise TraceError(f"{place}: this line of the kind {kind} is damaged: {wrong}")

    def on_one_line(self, number: int, record: Record) -> Record:
        """A record of a trace with the time since the first of the processes began, as far as it is known."""
        shift = self._shifts.get(number, 0)
        return as_record(record | {"time": record["time"] + shift}) if shift else record

    def close(self) -> None:
        """Let the files go."""
        for item in self._traces:
            item.close()


__all__ = ["RunFollower", "TraceFollower"]
