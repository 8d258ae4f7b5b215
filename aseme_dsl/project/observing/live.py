"""Live: a run is observed while its traces are written."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path

from aseme_dsl.project.observing.session import Observed, Session
from aseme_dsl.project.playing.following import RunFollower
from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_files import TraceError

_PAUSE = 0.1
"""Seconds between two looks at the traces."""


class Live:
    """Follows the traces of one run until it ends."""

    def __init__(self, paths: Sequence[Path], session: Session) -> None:
        self._session = session
        self._traces = RunFollower(paths)
        self._waiting: list[tuple[int, Record]] = []
        """What was read before all traces had begun."""
        self._headers: dict[int, Record] = {}
        self._count = len(paths)
        self.has_begun = False

    @property
    def problems(self) -> tuple[tuple[Path, str], ...]:
        """Which traces have lines that were skipped, with what is to be said of them."""
        return self._traces.problems

    def follow(self, until: Callable[[], bool]) -> Observed | None:
        """What has become of everything when all traces have ended, `until` says so, or Ctrl-C does; None if
        no trace has begun.

        Raises:
            TraceError: a trace cannot be followed, or another run has begun in its place.
            NoModel, NotReplayable: there is no model to observe it against.
        """
        try:
            while not until():
                self._look()
                if self._traces.finished:
                    break
                time.sleep(_PAUSE)
        except KeyboardInterrupt:
            pass
        finally:
            self._traces.close()
        return self._session.end() if self.has_begun else None

    def _look(self) -> None:
        """Observe what was written since the last time."""
        for number, record in self._traces.poll():
            if (record["kind"] == "header") == (number in self._headers):
                is_late = number in self._headers
                what = "another run has begun there" if is_late else "the header of a trace is wanted first"
                raise TraceError(f"{self._traces.path(number)}: {what}")
            if record["kind"] == "header":
                self._headers[number] = record
            else:
                self._waiting.append((number, record))
        if len(self._headers) == self._count:
            self._show()

    def _show(self) -> None:
        if not self.has_begun:
            self._session.headers(header for _, header in sorted(self._headers.items()))
            self.has_begun = True
        come = [(self._traces.on_one_line(number, record), number) for number, record in self._waiting]
        self._waiting.clear()
        if self._count > 1:
            come.sort(key=lambda item: item[0]["time"])
        for record, number in come:
            try:
                self._session.see(record)
            except (LookupError, TypeError, ValueError, AttributeError, OverflowError) as problem:
                text = f"{type(problem).__name__}: {problem}"
                path = self._traces.path(number)
                raise TraceError(f"{path}: a line does not fit those before it ({text})") from problem


__all__ = ["Live"]
