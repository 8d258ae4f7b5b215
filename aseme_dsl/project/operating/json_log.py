"""Structured logs: what a run prints, as one JSON object a line."""

from __future__ import annotations

import json
import sys
import threading
from datetime import UTC, datetime
from typing import IO, TYPE_CHECKING

from aseme_dsl.project.operating.telling import record_text
from aseme_dsl.runtime.control.recent import Recent

if TYPE_CHECKING:
    from aseme_dsl.runtime.trace.records import Record

LONGEST = 4000
"""A message has at most so many characters."""
_ERRORS = frozenset({"error", "breach"})
_WARNINGS = frozenset(
    {"fault", "lost", "refused", "dropped", "unexpected", "unsent", "overload", "gap", "activity", "module"}
)
_MEMBERS = ("what", "peer", "activity", "channel", "reason", "at", "label")


class JsonLog:
    """A listener of a trace that prints its recent records, logs and activities; and other lines.

    Members of each line are `time` (UTC, ISO 8601), `level` (info, warning, error) and `message`. A record
    has `kind`, `run_time` (s) and `agent`, too, and some of `what`, `peer`, `activity`, `channel`,
    `reason`.
    """

    def __init__(self, *, activities: bool, stream: IO[str] | None = None) -> None:
        """With `activities`, their starts are printed, too."""
        self._activities = activities
        self._stream = stream or sys.stdout
        self._lock = threading.Lock()
        self._recent = Recent()

    def wants(self, kind: str, what: str | None) -> bool:
        """Whether such records are printed."""
        if kind == "log":
            return True
        return self._recent.wants(kind, what) or (self._activities and (kind, what) == ("activity", "start"))

    def __call__(self, record: Record) -> None:
        """Print a record."""
        found = dict(record)
        kind = str(found["kind"])
        text = f"{found.get('activity')}: {found.get('text')}" if kind == "log" else record_text(found)
        further = {name: found[name] for name in _MEMBERS if isinstance(found.get(name), str)}
        agent = found.get("agent")
        self._print(
            _level(kind, found.get("what")),
            text,
            kind=kind,
            run_time=record["time"] / 1e9,
            **({"agent": agent} if isinstance(agent, str) and agent else {}),
            **further,
        )

    def line(self, text: str) -> None:
        """A line that is not of a record."""
        self._print("info", text)

    def warn(self, text: str) -> None:
        """A line about something wrong."""
        self._print("error", text)

    def end(self) -> None:
        """Nothing is left to say."""

    def _print(self, level: str, message: str, **members: object) -> None:
        now = datetime.now(UTC).isoformat(timespec="milliseconds")
        line = json.dumps({"time": now, "level": level, "message": message[:LONGEST], **members})
        with self._lock:
            self._stream.write(line + "\n")
            self._stream.flush()


def _level(kind: str, what: object) -> str:
    if kind in _ERRORS:
        return "error"
    if (kind, what) == ("activity", "start"):
        return "info"
    return "warning" if kind in _WARNINGS or what in ("gone", "refused") else "info"


__all__ = ["JsonLog"]
