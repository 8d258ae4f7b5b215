"""Observe: logs that are complete, from the first line to the last."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence
from pathlib import Path

from aseme_dsl.project.observing.log_lines import MessageLog, is_trace
from aseme_dsl.project.observing.session import Observed, Session
from aseme_dsl.project.observing.statements import StoryWanted
from aseme_dsl.project.playing.merging import Beginning, shifts
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.trace.trace_reading import MISFITS, Line, TraceReader, fitting, misfit
from aseme_dsl.runtime.workers.process_wide import uncollected


def observe(paths: Sequence[Path], session: Session) -> tuple[Observed, tuple[tuple[Path, str], ...]]:
    """What has become of everything, and which logs are not whole, with the reasons.

    Several logs are those of one run.

    Raises:
        TraceError: one is not a log, or a trace is together with logs of other programs.
        NoModel: there is no model to observe them against.
        NotReplayable: this version of asemec does not compile the model in a trace.
    """
    kinds = {is_trace(path) for path in paths}
    if len(kinds) > 1:
        first = next(path for path in paths if is_trace(path) != is_trace(paths[0]))
        raise TraceError(f"{paths[0]} and {first} are logs of different kinds: observe one kind at a time")
    with uncollected():  # what is read makes no cycles, and stays: to look through it takes half of the time
        read = _traces if kinds == {True} else _logs
        try:
            return read(paths, session.hasty())
        except StoryWanted:
            return read(paths, session)


def _logs(paths: Sequence[Path], session: Session) -> tuple[Observed, tuple[tuple[Path, str], ...]]:
    session.begin()
    logs = [MessageLog(path) for path in paths]
    messages = iter(logs[0]) if len(logs) == 1 else heapq.merge(*logs, key=lambda item: item.moment)
    for message in messages:
        session.hear(message)
    problems = [(log.path, log.problem) for log in logs if log.problem is not None]
    for log in logs:
        if log.backwards is not None:
            session.note(
                f"{log.path}:{log.backwards}: the times go backwards here: the order of lines counts"
            )
    return session.end(), tuple(problems)


def _traces(paths: Sequence[Path], session: Session) -> tuple[Observed, tuple[tuple[Path, str], ...]]:
    readers = [TraceReader(path) for path in paths]
    headers = [reader.header() for reader in readers]
    for reader, header in zip(readers, headers, strict=True):
        with fitting(reader.path, header):
            Beginning().add(header.record)
    session.headers(header.record for header in headers)
    lines = _lines(readers[0], 0) if len(readers) == 1 else _merged(readers)
    for reader in readers:
        reader.kinds = session.kinds
    for reader, line, record in lines:
        if line.number > 1:
            try:  # a line a few microseconds long: `fitting` would take as long again
                session.see(record)
            except MISFITS as problem:
                raise misfit(reader.path, line, problem) from problem
    problems = [(reader.path, reader.problem) for reader in readers if reader.problem is not None]
    return session.end(), tuple(problems)


def _lines(reader: TraceReader, shift: int) -> Iterator[tuple[TraceReader, Line, Record]]:
    for line in reader:
        yield reader, line, line.record | {"time": line.record["time"] + shift} if shift else line.record


def _merged(readers: Sequence[TraceReader]) -> Iterator[tuple[TraceReader, Line, Record]]:
    """The lines of the processes of a run on one time line."""
    began = [Beginning() for _ in readers]
    for reader, beginning in zip(readers, began, strict=True):
        beginning.add(reader.header().record)
    if len({item.clock for item in began}) > 1:  # the differences of clocks stand anywhere
        for reader, beginning in zip(readers, began, strict=True):
            for line in reader:
                with fitting(reader.path, line):
                    beginning.add(line.record)
    parts = [_lines(reader, shift) for reader, shift in zip(readers, shifts(began), strict=True)]
    return heapq.merge(*parts, key=lambda item: item[2]["time"])


__all__ = ["observe"]
