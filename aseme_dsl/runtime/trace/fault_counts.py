"""Fault counts: the faults of a run by reason and place, however many there are."""

from __future__ import annotations

from aseme_dsl.records import dataclass

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


@dataclass(slots=True)
class _Counter:
    """The first fault of a kind, and how many there were."""

    agent: str
    activity: str
    time: int
    count: int = 0

    def of(self, reason: str, at: str) -> FaultCount:
        return FaultCount(reason, self.agent, at, self.activity, self.time, self.count)


class FaultCounts:
    """Counts the faults of a run by reason and place. Not for several threads at once."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], _Counter] = {}
        self._more: _Counter | None = None

    def add(self, reason: str, agent: str, at: str, activity: str, moment: int) -> None:
        """Count a fault."""
        entry = self._found.get((reason, at))
        if entry is None and len(self._found) < MOST_FAULTS:
            entry = self._found[reason, at] = _Counter(agent, activity, moment)
        if entry is None:
            entry = self._more = self._more or _Counter(agent, activity, moment)
        entry.count += 1

    def counts(self) -> tuple[FaultCount, ...]:
        """All faults, in the order in which the first of each kind came."""
        found = [entry.of(reason, at) for (reason, at), entry in self._found.items()]
        if self._more is not None:
            found.append(self._more.of("faults of further kinds", ""))
        return tuple(found)
