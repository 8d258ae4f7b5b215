"""Sightings: a run in real time, watched a little later than it happens.

There the lines of a trace come from many threads, and with a process for each agent over pipes. So they are
collected, put in the order of their times, and shown to the observer when no earlier one can come any more.
"""

from __future__ import annotations

import heapq
import itertools
import json
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from functools import partial
from typing import cast

from aseme_dsl.play.observer import KINDS, Observer
from aseme_dsl.play.sight.insight import Asked, Insight, Kept, kept
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.records import Record, as_record

LAG = 250_000_000
"""So much later (ns) a line of a trace is looked at: by then each earlier one has come."""


@dataclass(frozen=True, slots=True)
class Sighting:
    """A line of a trace; that of a step with the inside of the agent after it."""

    record: Record
    inside: Kept | None = None


class Reporter:
    """A listener of a trace in real time: makes a sighting of each line that conditions may be about."""

    def __init__(self, asked: Asked, tell: Callable[[Sighting], None]) -> None:
        """`tell` is called by the threads of the run, one at a time; it must not wait."""
        self._asked = asked
        self._tell = tell
        self._team: Team | None = None

    def begin(self, team: Team) -> None:
        """The run of the team begins."""
        self._team = team

    def wants(self, kind: str, what: str | None) -> bool:
        return kind in KINDS

    def __call__(self, record: Record) -> None:
        inside = None
        if record["kind"] == "step" and self._team is not None:
            # The thread that writes this line is the one that steps the agent.
            inside = kept(self._team.agent(record["agent"]).chart, self._asked)
        self._tell(Sighting(record, inside))


class Later:
    """What an observer is shown some time later; it is the surroundings of that observer.

    `take`, `hear` and `crash` may be called from any thread, the others from one.
    """

    def __init__(self, observer: Observer, plans: Iterable[Plan]) -> None:
        """`plans` are those that the conditions are made for, by the roles of the agents."""
        self._observer = observer
        self._plans = {(plan.name, plan.model): plan for plan in plans}
        by_role = {plan.name: plan for plan in self._plans.values()}
        self._kept = {name: Kept(by_role[role]) for name, role in observer.script.team}
        self._come: deque[tuple[int, Callable[[], None]]] = deque()
        self._due: list[tuple[int, int, Callable[[], None]]] = []
        self._number = itertools.count()
        self._now = 0
        self.stranger: tuple[str, int] | None = None
        """An agent that runs another version of its model now, and since when: nothing is watched then."""
        observer.begin(self)

    # ---- the surroundings ------------------------------------------------------------------------

    def now(self) -> int:
        return self._now

    def at(self, moment: int, call: Callable[[], None]) -> None:
        heapq.heappush(self._due, (moment, next(self._number), call))

    def insight(self, agent: str) -> Insight:
        return self._kept[agent]

    # ---- what comes ------------------------------------------------------------------------------

    def take(self, sighting: Sighting) -> None:
        """A sighting of this process."""
        self._come.append((sighting.record["time"], partial(self._see, sighting)))

    def hear(self, text: str) -> None:
        """A sighting of another process, as `told` writes it. Raises ValueError for another text."""
        record, role, model, inside = _heard(text)
        self._come.append((record["time"], partial(self._see_there, record, role, model, inside)))

    def crash(self, agent: str, moment: int) -> None:
        """An agent has stopped dead."""
        self._come.append((moment, partial(self._crash, agent)))

    def pass_to(self, moment: int) -> None:
        """Show the observer all that has come up to a moment."""
        while self._come:
            self.at(*self._come.popleft())
        while self._due and self._due[0][0] <= moment and self.stranger is None:
            time, _, call = heapq.heappop(self._due)
            self._now = max(self._now, time)
            call()
        if self.stranger is None and moment > self._now:
            self._now = moment
            self._observer.settled()

    def _crash(self, agent: str) -> None:
        self._kept[agent] = Kept(self._kept[agent].plan)
        self._observer.crashed(agent)

    def _see(self, sighting: Sighting) -> None:
        inside, record = sighting.inside, sighting.record
        if inside is not None:
            plan = inside.plan
            if (plan.name, plan.model) not in self._plans:
                self.stranger = record["agent"], record["time"]
                return
            self._kept[record["agent"]] = inside
        self._observer(record)

    def _see_there(self, record: Record, role: str, model: str, inside: Mapping[str, object]) -> None:
        if not role:
            self._see(Sighting(record))
        elif (plan := self._plans.get((role, model))) is None:
            self.stranger = record["agent"], record["time"]
        else:
            self._see(Sighting(record, _inside(plan, inside)))


# ---- between processes ------------------------------------------------------------------------------


def told(sighting: Sighting) -> str:
    """A sighting as JSON, in one line."""
    inside = sighting.inside
    found: dict[str, object] = {"record": sighting.record}
    if inside is not None:
        found["role"], found["model"] = inside.plan.name, inside.plan.model
        found["inside"] = {
            "index": inside.index,
            "variables": inside.variables,
            "outcomes": inside.outcomes,
            "started": inside.started,
            "returned": sorted(inside.returned),
        }
    return json.dumps(found, ensure_ascii=False, separators=(",", ":"))


def _heard(text: str) -> tuple[Record, str, str, Mapping[str, object]]:
    try:
        found = json.loads(text)
        record = as_record(found["record"])
        if record["kind"] not in KINDS or not isinstance(record["time"], int):
            raise ValueError("it is not a sighting")
        return record, found.get("role", ""), found.get("model", ""), found.get("inside", {})
    except (KeyError, TypeError, RecursionError) as problem:
        raise ValueError("it is not a sighting") from problem


def _inside(plan: Plan, said: Mapping[str, object]) -> Kept:
    variables = cast("Mapping[str, object]", said["variables"])
    outcomes = cast("Mapping[str, str]", said["outcomes"])
    started = cast("Mapping[str, list[int]]", said["started"])
    returned = frozenset(cast("list[str]", said["returned"]))
    moments = {name: tuple(items) for name, items in started.items()}
    return Kept(plan, cast(int, said["index"]), variables, outcomes, moments, returned)


def asked_text(asked: Asked) -> str:
    """What conditions ask, as JSON."""
    return json.dumps(asdict(asked))


def asked_of(text: str) -> Asked:
    """What conditions ask, from JSON."""
    return Asked(**{name: tuple(items) for name, items in json.loads(text).items()})


__all__ = ["LAG", "Later", "Reporter", "Sighting", "asked_of", "asked_text", "told"]
