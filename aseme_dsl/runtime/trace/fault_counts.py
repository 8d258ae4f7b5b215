"""Fault counts: the faults of a run by reason and place, however many there are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

MOST_FAULTS = 1000
"""After so many different faults, further ones are counted together."""


@dataclass(frozen=True, slots=True)
class FaultCount:
    """Faults with one reason and place: the first one's agent, activity and time (ns), and how many."""

    reason: str
    agent: str
    at: str
    activity: str
    time: int
    count: int


class FaultCounts:
    """Counts the faults of a run by reason and place. Not for several threads at once."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], list[Any]] = {}
        self._more: list[Any] | None = None

    def add(self, reason: str, agent: str, at: str, activity: str, moment: int) -> None:
        """Count a fault."""
        entry = self._found.get((reason, at))
        if entry is None and len(self._found) < MOST_FAULTS:
            entry = self._found[reason, at] = [agent, activity, moment, 0]
        if entry is None:
            entry = self._more = self._more or [agent, activity, moment, 0]
        entry[3] += 1

    def counts(self) -> tuple[FaultCount, ...]:
        """All faults, in the order in which the first of each kind came."""
        found = [
            FaultCount(reason, agent, at, activity, moment, count)
            for (reason, at), (agent, activity, moment, count) in self._found.items()
        ]
        if self._more is not None:
            agent, activity, moment, count = self._more
            found.append(FaultCount("faults of further kinds", agent, "", activity, moment, count))
        return tuple(found)
