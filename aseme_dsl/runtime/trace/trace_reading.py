"""Reading traces: the lines of a trace file of any kind, complete or torn, from any place on."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.records import Record, agents_of, as_record
from aseme_dsl.runtime.trace.trace_blocks import (
    CHANGES,
    Block,
    Damaged,
    packed_blocks,
    plain_blocks,
    start_for,
    unpacked_as_far_as_it_goes,
)
from aseme_dsl.runtime.trace.trace_check import wrong_in
from aseme_dsl.runtime.trace.trace_files import FORMAT, TraceError, part_of
from aseme_dsl.runtime.trace.trace_gzip import MAGIC as GZIP_MAGIC
from aseme_dsl.runtime.trace.trace_gzip import unpacked_lines
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, MAGIC, Torn, lines_in
from aseme_dsl.runtime.trace.trace_types import beginning, decoded

_BEGINNING = '{"kind":"'
MOST_PARTS = 1_000_000
"""No line has so many lists and objects: each takes many times the room in memory that it takes in a file."""

MISFITS = (LookupError, TypeError, ValueError, AttributeError, OverflowError)
"""What is raised by a line that does not fit those before it."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line of a trace: its number from 1, its text without the end, and what it says."""

    number: int
    text: str
    record: Record


@contextmanager
def fitting(path: Path, line: Line) -> Iterator[None]:
    """Around what is done with a line. Raises TraceError where it does not fit the lines before it.

    It is about an agent that there is not, or about a state that its role does not have.
    """
    try:
        yield
    except MISFITS as problem:
        raise misfit(path, line, problem) from problem


def misfit(path: Path, line: Line, problem: Exception) -> TraceError:
    """What is said of a line at which one of `MISFITS` was raised."""
    text = f"{type(problem).__name__}: {problem}"
    return TraceError(f"{path}:{line.number}: this line does not fit those before it ({text})")


class TraceReader:
    """The lines of a trace: all of them, those from near a moment on, or those before a line, backwards.

    A run that was killed leaves `NAME.part`, whose last line may be torn: what is whole is read, and
    `problem` says afterwards what is not. `NAME` stands for `NAME.part` where there is no `NAME`.
    """

    def __init__(self, path: Path, kinds: Collection[str] | None = None) -> None:
        """If `kinds` are given, lines of others may have no more than their kind, time, agent and number.

        Raises TraceError if there is no such file.
        """
        self.path = path
        self.kinds = kinds
        if not path.exists() and part_of(path).exists():
            self.path = part_of(path)
        self.problem: str | None = None
        self.finished = False
        """Whether the run came to its end: the last line says so."""
        self._blocks: tuple[Block, ...] | None = None
        with self._open() as file:
            start = file.peek(len(MAGIC))
            self._is_mcap = start.startswith(MAGIC)
            self._is_packed = start.startswith(GZIP_MAGIC)

    def __iter__(self) -> Iterator[Line]:
        """The lines in their order.

        Raises:
            TraceError: a line that is not the last is none of a trace, or the first is not a known header.
        """
        return self._lines(None)

    def since(self, moment: int, agents: Collection[str] = ()) -> Iterator[Line]:
        """The header, then all lines from the newest place on at which the state of each agent is known.

        That is where the agents (all of the header, or these) have a checkpoint not later than `moment` (ns);
        some lines stand before the oldest of these checkpoints. Between the header and that place come the
        lines `swap` and `select` that precede it: they tell which model an agent runs. Nothing else of what
        precedes is decoded. The numbers of the lines are those in the file.

        All lines come where there is no such place: the run has just begun, or the file is one that has no
        blocks (MCAP, or compressed by another program).

        Raises:
            TraceError: as from the begin.
        """
        blocks = self.blocks()
        names = agents
        if not names and blocks:
            names = {str(item["name"]) for item in agents_of(self.header().record)}
        start = start_for(blocks, moment, names) if names else None
        if start is None or start.line == 1:
            yield from self
            return
        yield self.header()
        for block in blocks:
            if block.offset < start.offset and block.changes:
                for number, text in self._texts_of(block):
                    record = record_of(text)
                    if number > 1 and record is not None and record["kind"].encode() in CHANGES:
                        self._check(number, record)
                        yield Line(number, text, record)
        yield from self._lines(start)

    def before(
        self, number: int, texts: Collection[str] = ("",), wanted: Callable[[str], bool] = lambda text: True
    ) -> Iterator[Line]:
        """The lines before a line that hold one of some texts, the newest first.

        Only these are decoded, and of them only those whose text is `wanted`. There are none where the file
        has no blocks.
        """
        for block in reversed(self.blocks()):
            if block.line < number:
                for line in self._records_of(block, texts, wanted):
                    if line.number < number:
                        yield line

    def header(self) -> Line:
        """The first line. Raises TraceError."""
        found = next(self._lines(None), None)
        if found is None:
            raise TraceError(self.problem)
        return found

    def blocks(self) -> tuple[Block, ...]:
        """The parts of the file that can be read by themselves; none in an MCAP file, or in one that another
        program has compressed. Raises TraceError."""
        if self._blocks is None:
            with self._open() as file:
                try:
                    if self._is_mcap:
                        self._blocks = ()
                    else:
                        self._blocks = tuple(packed_blocks(file) if self._is_packed else plain_blocks(file))
                except OSError as problem:
                    raise self._unread(problem) from problem
                except Damaged as problem:
                    raise TraceError(f"{self.path} cannot be read: {problem}") from problem
        return self._blocks

    # ---- the file ----------------------------------------------------------------------------

    def _open(self) -> BufferedReader:
        try:
            return outside.open_file(self.path)
        except OSError as problem:
            raise self._unread(problem) from problem

    def _unread(self, problem: OSError) -> TraceError:
        return TraceError(f"{self.path} cannot be read: {problem.strerror or problem}")

    def _lines(self, start: Block | None) -> Iterator[Line]:
        """The lines from a block on."""
        number = before = 0 if start is None else start.line - 1
        with self._open() as file:
            if start is not None:
                file.seek(start.offset)
            texts = lines_in(file, self.path) if self._is_mcap else self._texts(file)
            try:
                for number, text in enumerate(texts, before + 1):
                    if number > 1 and (record := self._passed_over(text)) is not None:
                        self.finished = record["kind"] == "finish"
                        yield Line(number, text, record)
                        continue
                    record = record_of(text)
                    if record is None or (number == 1 and record["kind"] != "header"):
                        for _ in texts if self._is_packed else ():  # the rest of a torn block may be nonsense
                            pass
                        what = "the header of a trace" if number == 1 else "a line of a trace"
                        raise TraceError(f"{self.path}:{number}: {what} is wanted, not {_short(text)}")
                    if number == 1 and record.get("format", FORMAT) != FORMAT:
                        found = record["format"]
                        other = found if isinstance(found, int) else _short(str(found))
                        text = f"{self.path} has the format {other}; this version reads the format {FORMAT}"
                        raise TraceError(text)
                    self._check(number, record)
                    self.finished = record["kind"] == "finish"
                    yield Line(number, text, record)
            except Torn as torn:
                place = before + torn.lines + 1
                self.problem = f"{self.path}:{place}: the trace breaks off here: {torn.reason}"
            except OSError as problem:
                raise self._unread(problem) from problem
        if number == 0 and self.problem is None:
            raise TraceError(f"{self.path} is empty")
        if self.problem is None and not self.finished:
            self.problem = f"{self.path}: the run did not come to its end: there is no line `finish`"

    def _passed_over(self, text: str) -> Record | None:
        """The beginning of a line that is not wanted; None if it is to be read in full."""
        if self.kinds is None or not text.startswith(_BEGINNING):
            return None
        kind = text[len(_BEGINNING) : text.find('"', len(_BEGINNING))]
        if kind in self.kinds or text.count("{") + text.count("[") > outside.DEEPEST:
            return None
        found = beginning(text, kind)
        return None if found is None else as_record(found)

    def _texts(self, file: BufferedReader) -> Iterator[str]:
        number = 0
        before: bytes | None = None
        lines = unpacked_lines(file) if self._is_packed else outside.lines(file, LONGEST)
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

    def _data_of(self, block: Block) -> bytes:
        """The lines of a block, as far as they are whole."""
        with self._open() as file:
            try:
                file.seek(block.offset)
                data = file.read(block.size)
            except OSError as problem:
                raise self._unread(problem) from problem
        return unpacked_as_far_as_it_goes(data) if self._is_packed else data

    def _texts_of(self, block: Block) -> Iterable[tuple[int, str]]:
        return enumerate(self._data_of(block).decode("utf-8", "replace").split("\n")[:-1], block.line)

    def _records_of(
        self,
        block: Block,
        texts: Collection[str],
        wanted: Callable[[str], bool],
    ) -> Iterator[Line]:
        """The lines of a block that hold one of some texts, and are wanted, the last one first."""
        data = self._data_of(block).decode("utf-8", "replace")
        if not any(text in data for text in texts):
            return
        lines = data.split("\n")
        for place in range(len(lines) - 2, -1, -1):
            found = lines[place]
            is_wanted = any(text in found for text in texts) and wanted(found)
            record = record_of(found) if is_wanted else None
            if record is not None:
                self._check(block.line + place, record)
                yield Line(block.line + place, found, record)

    def _check(self, number: int, record: Record) -> None:
        """Raises TraceError for a line that is not as its kind is."""
        wrong = wrong_in(record)
        if wrong is not None:
            kind = _short(record["kind"])
            raise TraceError(f"{self.path}:{number}: this line of the kind {kind} is damaged: {wrong}")


def _decoded(data: bytes) -> str:
    return data.decode("utf-8", "replace").rstrip("\n")


def record_of(text: str) -> Record | None:
    """What a line says, or None if it is none."""
    parts = text.count("{") + text.count("[")
    if parts > MOST_PARTS:
        return None
    found = decoded(text) if parts <= outside.DEEPEST else None
    if found is None:
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
