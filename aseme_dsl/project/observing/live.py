"""Live: a run is observed while its traces are written."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path

from aseme_dsl.project.observing.session import Observed, Session
from aseme_dsl.project.playing.following import TraceFollower
from aseme_dsl.project.playing.merging import Beginning, shifts
from aseme_dsl.project.settings.target import traces_of
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_check import wrong_in
from aseme_dsl.runtime.trace.trace_files import TraceError

_PAUSE = 0.1
"""Seconds between two looks at the traces."""


class Live:
    """Follows the traces of one run until it ends."""

    def __init__(self, paths: Sequence[Path], session: Session) -> None:
        self._session = session
        self._followers = [TraceFollower(path) for path in paths]
        self._waiting: list[list[Record]] = [[] for _ in paths]
        self._began = [Beginning() for _ in paths]
        self._counts = [0 for _ in paths]
        self._shifts: list[int] | None = None
        self.has_begun = False

    def follow(self, until: Callable[[], bool]) -> Observed | None:
        """What has become of everything when all traces have ended, `until` says so, or Ctrl-C does; None if
        no trace has begun.

        Raises:
            TraceError: a trace cannot be followed, or another run has begun in its place.
            NoModel, NotReplayable: there is no model to observe it against.
        """
        try:
            while not until():
                has_ended = self._look()
                if has_ended:
                    break
                time.sleep(_PAUSE)
        except KeyboardInterrupt:
            pass
        finally:
            for item in self._followers:
                item.close()
        return self._session.end() if self.has_begun else None

    def _look(self) -> bool:
        """Observe what was written since the last time; whether that was all."""
        for number, item in enumerate(self._followers):
            if item.path.is_dir():  # before the first run the name of its trace is not known
                item = self._followers[number] = TraceFollower(*traces_of(item.path, following=True)[0])
            for record in item.poll():
                self._take(number, record)
        if all(beginning.agents for beginning in self._began):
            self._show()
        return all(item.finished for item in self._followers)

    def _take(self, number: int, record: Record) -> None:
        path = self._followers[number].path
        self._counts[number] += 1
        place, wrong = self._counts[number], wrong_in(record)
        if wrong is not None:
            kind = repr(record["kind"][:40])
            raise TraceError(f"{path}:{place}: this line of the kind {kind} is damaged: {wrong}")
        if record["kind"] == "header" and self._began[number].agents:
            raise TraceError(f"{path}: another run has begun there")
        if record["kind"] != "header" and not self._began[number].agents:
            raise TraceError(f"{path}: the header of a trace is wanted first")
        self._began[number].add(record)
        self._waiting[number].append(record)

    def _show(self) -> None:
        if self._shifts is None:
            self._shifts = shifts(self._began)
            self._session.headers(items.pop(0) for items in self._waiting)
            self.has_begun = True
        come = [
            record | {"time": record["time"] + shift} if shift else record
            for items, shift in zip(self._waiting, self._shifts, strict=True)
            for record in items
        ]
        for items in self._waiting:
            items.clear()
        if len(self._followers) > 1:
            come.sort(key=lambda record: record["time"])
        for record in come:
            try:
                self._session.see(record)
            except (LookupError, TypeError, ValueError, AttributeError, OverflowError) as problem:
                text = f"{type(problem).__name__}: {problem}"
                raise TraceError(f"a line does not fit those before it ({text})") from problem


__all__ = ["Live"]
