"""Merging: the traces of the processes of a run, on one time line, though each counts from its own begin.

Processes of one machine share its clock. The difference between two machines' clocks is in the trace of the
machine that has measured it. Without a measurement, the dates on which the runs began have to do.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from datetime import datetime

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.records import Record, agents_of


@dataclass(slots=True)
class Beginning:
    """What a trace says of its time."""

    agents: frozenset[str] = frozenset()
    start: datetime | None = None
    clock: int | None = None
    origin: int = 0
    differences: dict[str, tuple[int, int]] = field(default_factory=dict)
    """By agent elsewhere: by how many ns the difference may be wrong, and what is added to its clock."""

    def add(self, record: Record) -> None:
        """A line of the trace, if it says something of time."""
        if record["kind"] == "header":
            self.agents = frozenset(str(agent["name"]) for agent in agents_of(record))
            if isinstance(record.get("start"), str):
                self.start = datetime.fromisoformat(record["start"])
            machine = record.get("machine")
            if machine is not None:
                self.clock, self.origin = int(machine["clock"]), int(machine["origin"])
        elif record["kind"] == "peer" and isinstance(record.get("difference"), int):
            found = int(record.get("uncertainty", 0)), int(record["difference"])
            self.differences[str(record["peer"])] = found


def shifts(beginnings: list[Beginning]) -> list[int]:
    """What is added to the times of each trace, in ns, so that all count from the first beginning."""
    found: dict[int, int] = {}
    while len(found) < len(beginnings):
        steps = [
            (step[0], there, step[1] + found[here])
            for here in found
            for there in range(len(beginnings))
            if there not in found and (step := _measured(beginnings[here], beginnings[there])) is not None
        ]
        if steps:  # by the most exact measurement first
            _, there, shift = min(steps)
            found[there] = shift
            continue
        there = next(number for number in range(len(beginnings)) if number not in found)
        found[there] = _by_date(beginnings, there, found)
    first = min(found.values(), default=0)
    return [found[number] - first for number in range(len(beginnings))]


def _measured(here: Beginning, there: Beginning) -> tuple[int, int] | None:
    """By how much the times of one trace differ from another's, and how exact that is; None: not measured."""
    if here.clock is None or there.clock is None:
        return None
    between = there.origin - here.origin
    if here.clock == there.clock:
        return 0, between
    known = [here.differences[name] for name in there.agents if name in here.differences]
    known += [
        (uncertainty, -difference)
        for name, (uncertainty, difference) in there.differences.items()
        if name in here.agents
    ]
    if not known:
        return None
    uncertainty, difference = min(known)
    return uncertainty, between + difference


def _by_date(beginnings: list[Beginning], there: int, found: Mapping[int, int]) -> int:
    """By the dates on which two runs began."""
    start = beginnings[there].start
    for here, shift in found.items():
        other = beginnings[here].start
        if start is not None and other is not None:
            return shift + int((start - other).total_seconds() * 1e9)
    return 0


__all__ = ["Beginning", "shifts"]
