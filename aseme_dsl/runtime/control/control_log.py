"""Control log: every control request is in the trace, with who made it; of a flood, how many they were."""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.runtime.team.team import Team

MOST = 20
"""So many requests of one origin and outcome get lines of their own within `SPAN`."""
SPAN = 1.0
"""After so many seconds a flood is summarised."""


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a request came from: "program", "socket" (a user of this machine), or "bus" (to which agent)."""

    where: str
    uid: int | None = None
    agent: str | None = None
    key: str | None = None
    """The name of the operator's key that proves it."""


PROGRAM = Origin("program")


class ControlLog:
    """Writes a line for each request. May be used from any thread."""

    def __init__(self, team: Team) -> None:
        self._team = team
        self._lock = threading.Lock()
        self._counts: Counter[tuple[Origin, str]] = Counter()
        """How many have no lines of their own yet."""
        self._lines: Counter[tuple[Origin, str]] = Counter()
        self._since = time.monotonic()
        self._timer: threading.Timer | None = None

    def note(self, origin: Origin, request: str | None, reasons: Sequence[str]) -> None:
        """A request was accepted, or refused if there are reasons; `request` is its name, if known."""
        what = "refused" if reasons else "accepted"
        with self._lock:
            begun = self._team.trace.begun
            if begun and time.monotonic() - self._since >= SPAN:
                self._summarise()
            if begun and self._lines[origin, what] < MOST:
                self._lines[origin, what] += 1
                self._write(origin, what, request=request, reasons=list(reasons) or None)
                return
            self._counts[origin, what] += 1
            if self._timer is None:
                self._timer = threading.Timer(SPAN, self.flush)
                self._timer.daemon = True
                self._timer.start()

    def flush(self) -> None:
        """Write how many requests have had no lines of their own."""
        with self._lock:
            self._summarise()

    def _summarise(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if not self._team.trace.begun:  # with the next request, or at the end
            return
        for (origin, what), number in self._counts.items():
            self._write(origin, what, count=number)
        self._counts.clear()
        self._lines.clear()
        self._since = time.monotonic()

    def _write(self, origin: Origin, what: str, **members: object) -> None:
        now = self._team.driver.clock.now()
        self._team.trace.write(
            "control",
            now,
            what=what,
            agent=origin.agent,
            origin=origin.where,
            uid=origin.uid,
            key=origin.key,
            **members,
        )
