"""Assumptions: what is assumed of the surroundings of a run, and when that was so no longer."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from typing import assert_never

from aseme_dsl.amola import expression as e
from aseme_dsl.play.evaluate import Known, value_of
from aseme_dsl.play.scenario import (
    Assumption,
    CrashesAssumed,
    DurationAssumed,
    FailuresAssumed,
    NetworkAssumed,
    PaceAssumed,
    ValueAssumed,
)
from aseme_dsl.runtime.trace.records import Record

_ENDS = frozenset(("end", "crash", "cancel"))
_BETWEEN_STEPS = e.Age | e.At | e.Mean | e.Expired | e.Outcome | e.StateValue
"""The parts of a value that may be otherwise though its agent has made no step."""


class Assumptions:
    """Watches a run by the lines of its trace. `broken` is the first that does not hold, and since when."""

    def __init__(self, assumptions: Iterable[Assumption]) -> None:
        self.broken: tuple[Assumption, int] | None = None
        self._crashed: list[str] = []
        self._all = tuple(assumptions)
        self._started: dict[tuple[int, str], int] = {}
        """When an activity of an assumption, by its number, has started in an agent."""
        self._written: dict[tuple[int, str], int] = {}
        """When it has written last since then."""
        self.minds_activities = any(isinstance(item, PaceAssumed | DurationAssumed) for item in self._all)
        """Whether the lines of activities have to be seen."""
        self._values = tuple(
            (item, any(isinstance(part, _BETWEEN_STEPS) for part in e.walk(item.value)))
            for item in self._all
            if isinstance(item, ValueAssumed)
        )
        """With whether the value may be otherwise between the steps of its agent."""
        for item in self._all:
            if isinstance(item, NetworkAssumed) and item.broken_at is not None:
                self._break(item, item.broken_at)

    def see(self, record: Record) -> None:
        """One more line of the trace."""
        if not self._all:
            return
        self.pass_to(record["time"])
        activity = record.get("activity")
        if activity is not None:
            for number, item in enumerate(self._all):
                if isinstance(item, PaceAssumed | DurationAssumed) and item.activity == activity:
                    self._see(number, item, record)

    def _see(self, number: int, item: PaceAssumed | DurationAssumed, record: Record) -> None:
        key, now = (number, record["agent"]), record["time"]
        if record["kind"] == "activity" and record["what"] == "start":
            self._started[key] = now
            self._written.pop(key, None)
        elif record["kind"] == "activity" and record["what"] in _ENDS:
            lasted = now - self._started.pop(key, now)
            is_done = record["what"] == "end"
            if is_done and isinstance(item, DurationAssumed) and lasted < item.takes.least:
                self._break(item, now)
        elif isinstance(item, PaceAssumed) and record.get("channel") == item.channel:
            last = self._written.get(key)
            if last is not None and now - last < item.every.least:
                self._break(item, now)
            self._written[key] = now

    def pass_to(self, moment: int) -> None:
        """Time passes: until then nothing else happens."""
        for (number, agent), started in self._started.items():
            item = self._all[number]
            match item:
                case PaceAssumed(every=every):
                    due = self._written.get((number, agent), started) + every.most
                case DurationAssumed(takes=takes):
                    due = started + takes.most
                case _:
                    continue
            if moment > due:
                self._break(item, due)

    def look(self, known: Callable[[str], Known], moment: int, stepped: Collection[str] | None) -> None:
        """Something has happened: what each agent knows may be otherwise.

        `stepped` are the only agents that have made a step since the last look; None if that is not known.
        """
        for item, is_passing in self._values:
            is_same = not is_passing and stepped is not None and item.agent not in stepped
            if not is_same and value_of(item.value, known(item.agent)) is False:
                self._break(item, moment)

    def crash(self, agent: str, moment: int) -> None:
        """An agent has crashed."""
        self._crashed.append(agent)
        for item in self._all:
            match item:
                case CrashesAssumed(most=most, agents=agents):
                    if sum(name in agents for name in self._crashed) > most:
                        self._break(item, moment)
                case (
                    PaceAssumed() | DurationAssumed() | NetworkAssumed() | FailuresAssumed() | ValueAssumed()
                ):
                    pass
                case _:
                    assert_never(item)

    def _break(self, item: Assumption, moment: int) -> None:
        if self.broken is None or moment < self.broken[1]:
            self.broken = item, moment


__all__ = ["Assumptions"]
