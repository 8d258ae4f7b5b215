"""Reading traces: the lines of a trace file of either kind, complete or torn, one at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.runtime.trace.records import Record, as_record
from aseme_dsl.runtime.trace.trace_files import FORMAT, TraceError, part_of
from aseme_dsl.runtime.trace.trace_gzip import MAGIC as GZIP_MAGIC
from aseme_dsl.runtime.trace.trace_gzip import unpacked_lines
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, MAGIC, Torn, lines_in


@dataclass(frozen=True, slots=True)
class Line:
    """A line of a trace: its number from 1, its text without the end, and what it says."""

    number: int
    text: str
    record: Record


class TraceReader:
    """The lines of a trace, for one walk through it.

    A run that was killed leaves `NAME.part`, whose last line may be torn: what is whole is read, and
    `problem` says afterwards what is not. `NAME` stands for `NAME.part` where there is no `NAME`.
    """

    def __init__(self, path: Path) -> None:
        """Raises TraceError if there is no such file."""
        self.path = path
        if not path.exists() and part_of(path).exists():
            self.path = part_of(path)
        self.problem: str | None = None
        self.finished = False
        """Whether the run came to its end: the last line says so."""
        try:
            self._file = outside.open_file(self.path)
            start = self._file.peek(len(MAGIC))
            self._is_mcap = start.startswith(MAGIC)
            self._is_packed = start.startswith(GZIP_MAGIC)
        except OSError as problem:
            raise TraceError(f"{self.path} cannot be read: {problem.strerror or problem}") from problem

    def __iter__(self) -> Iterator[Line]:
        """The lines in their order.

        Raises:
            TraceError: a line that is not the last is none of a trace, or the first is not a known header.
        """
        number = 0
        with self._file:
            texts = lines_in(self._file, self.path) if self._is_mcap else self._texts()
            try:
                for number, text in enumerate(texts, 1):
                    record = record_of(text)
                    if record is None or (number == 1 and record["kind"] != "header"):
                        what = "the header of a trace" if number == 1 else "a line of a trace"
                        raise TraceError(f"{self.path}:{number}: {what} is wanted, not {_short(text)}")
                    if number == 1 and record.get("format", FORMAT) != FORMAT:
                        other = f"the format {record['format']}; this version reads the format {FORMAT}"
                        raise TraceError(f"{self.path} has {other}")
                    self.finished = record["kind"] == "finish"
                    yield Line(number, text, record)
            except Torn as torn:
                self.problem = f"{self.path}:{torn.lines + 1}: the trace breaks off here: {torn.reason}"
            except OSError as problem:
                raise TraceError(f"{self.path} cannot be read: {problem.strerror or problem}") from problem
        if number == 0 and self.problem is None:
            raise TraceError(f"{self.path} is empty")
        if self.problem is None and not self.finished:
            self.problem = f"{self.path}: the run did not come to its end: there is no line `finish`"

    def _texts(self) -> Iterator[str]:
        number = 0
        before: bytes | None = None
        lines = unpacked_lines(self._file) if self._is_packed else outside.lines(self._file, LONGEST)
        torn: Torn | None = None
        try:
            for data in lines:
                if before is not None:
                    number += 1
                    yield _decoded(before)
                before = data
        except Torn as found:
            torn = found
        if before is not None:
            text = _decoded(before)
            if not before.endswith(b"\n") and record_of(text) is None:
                raise Torn(number, f"{_short(text)} is not a whole line")
            yield text
        if torn is not None:
            raise torn


def _decoded(data: bytes) -> str:
    return data.decode("utf-8", "replace").rstrip("\n")


def record_of(text: str) -> Record | None:
    """What a line says, or None if it is none."""
    try:
        found = outside.loads(text)
    except ValueError:
        return None
    if not isinstance(found, dict) or not isinstance(found.get("kind"), str):
        return None
    moment = found.get("time")
    return as_record(found) if isinstance(moment, int) and not isinstance(moment, bool) else None


def _short(text: str) -> str:
    text = text if len(text) <= 40 else f"{text[:40]}…"
    return repr(text) if text else "an empty line"
