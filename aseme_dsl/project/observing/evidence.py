"""Evidence: what a log has of a run, and what a statement about that run asks for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field

from aseme_dsl.amola import expression as e
from aseme_dsl.play.scenario import (
    AllOf,
    AnyOf,
    Breached,
    Condition,
    Expectation,
    Failed,
    Faulty,
    Holds,
    InPlaces,
    NotSo,
    Says,
    Script,
    Untaken,
    parts_of,
)
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import conditions_of
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.records import Record

_LATE = 1_000_000_000
"""In real time, a line may come so much later (ns) than one behind it."""
_AWAITED = 1000
"""So many missing lines are remembered."""


@dataclass(frozen=True, slots=True)
class Needs:
    """What a statement asks of a log."""

    steps: frozenset[str] = frozenset()
    """The agents whose steps it is about."""
    senders: frozenset[str] = frozenset()
    """The agents whose agent messages it is about."""
    channels: bool = False
    faults: bool = False
    inside: str | None = None
    """What only the statechart knows: `the variable tries`."""


def never_in_a_log(needs: Needs, is_trace: bool) -> str | None:
    """Why no log of its kind decides a statement: it asks for what such a log does not have."""
    if needs.inside is not None:
        again = "; `asemec replay` decides it" if is_trace else ""
        return f"it asks for {needs.inside}, which a log does not have{again}"
    if is_trace:
        return None
    if needs.steps:
        return f"the log has no steps of {min(needs.steps)}"
    if needs.channels or needs.faults:
        return f"the log has no {'messages of topics' if needs.channels else 'faults'}"
    return None


def needs_of(script: Script, item: Expectation, channels: Iterable[str]) -> Needs:
    """What a statement asks of a log; `channels` are the types of messages on topics."""
    topics = frozenset(channels)
    everyone = frozenset(name for name, _ in script.team)
    steps: set[str] = set()
    senders: set[str] = set()
    has_channels = has_faults = False
    inside: str | None = None
    todo = [*conditions_of(item.rule), *item.witnesses]
    while todo:
        condition: Condition = script.conditions[todo.pop()]
        match condition:
            case InPlaces(places=places):
                steps.update(places)
            case Holds(agent=agent, value=value):
                steps.add(agent)
                inside = inside or _inside(value)
            case Says(agents=agents, is_received=is_received, condition=value):
                (steps if is_received else senders).update(everyone if agents is None else agents)
                kind = condition.what if condition.is_kind else ""
                is_mail = condition.performative is not None or (condition.is_kind and kind not in topics)
                has_channels = has_channels or not is_mail
                if value is not None:
                    inside = inside or _inside(value)
            case Breached(agents=agents):
                senders.update(agents)
                has_channels = True
            case Faulty() | Failed() | Untaken():
                has_faults = True
            case AllOf() | AnyOf() | NotSo():
                todo += parts_of(condition)
    return Needs(frozenset(steps), frozenset(senders), has_channels, has_faults, inside)


def _inside(value: e.Value) -> str | None:
    """What a condition asks that no line of a trace says."""
    for part in e.walk(value):
        match part:
            case e.VariableValue(name=name):
                return f"the variable {name.partition('@')[0]}"
            case e.Outcome(activity=activity):
                return f"how {activity} has ended"
            case e.Expired(timer=timer):
                return f"the timer {timer}"
            case e.StateValue(question="done", state=state):
                return f"whether {state} is complete"
            case e.StateValue() | e.Member() | e.Literal():
                pass
            case _:
                pass
    return None


@dataclass(slots=True)
class Evidence:
    """What has been seen of a run by now. `strangers` are agents of whose steps nothing is known, and why."""

    agents: frozenset[str] = frozenset()
    """The agents that have a log."""
    is_one: bool = True
    """Whether all agents run in one process, without a simulated network: their lines are numbered."""
    is_virtual: bool = True
    strangers: dict[str, str] = field(default_factory=dict)
    steps: dict[str, int] = field(default_factory=dict)
    protocols: set[str] = field(default_factory=set)
    """The protocols of which the log shows where their conversations begin and end."""
    missing: tuple[int, str] | None = None
    """Since when and how lines are missing."""
    _numbers: dict[str, int] = field(default_factory=dict)
    _awaited: dict[tuple[str, int], int] = field(default_factory=dict)

    def see(self, record: Record) -> None:
        """The next line of a trace."""
        kind, moment = record["kind"], record["time"]
        if "sequence" in record:
            self._number(record["agent"], record["sequence"], moment)
        if kind == "step":
            self._step(record, moment)
        elif kind == "gap":
            self._lack(moment, f"{record['lines']} lines are missing ({record['reason']})")
        elif kind == "checkpoint" and record.get("anew"):
            self.steps[record["agent"]] = record["step"]
        elif kind in ("received", "arrived"):
            self._know(*record["input"])
        elif kind == "conversation":
            self.protocols.add(record.get("protocol") or record["conversation"].partition("-")[0])
        if self._awaited and self.steps:  # of messages alone, the numbers have gaps
            place, since = next(iter(self._awaited.items()))
            if (self.is_virtual and self.is_one) or moment > since + _LATE:
                self._lack(since, f"lines about {place[0]} are missing")

    def _step(self, record: Record, moment: int) -> None:
        agent, number = record["agent"], record["step"]
        before = self.steps.get(agent, 0)
        if number > before + 1:
            self._lack(moment, f"step {before + 1} of {agent} is missing")
        self.steps[agent] = number
        for name, which in record["inputs"]:
            if int(which) > self._numbers.get(str(name), 0):
                self._awaited.setdefault((str(name), int(which)), moment)

    def _number(self, agent: str, number: int, moment: int) -> None:
        """An agent has done something: where it runs alone, its numbers have no gaps."""
        last = self._numbers.get(agent, 0 if self.is_virtual else number - 1)
        if self.is_one and number > last + 1 and len(self._awaited) < _AWAITED:
            self._awaited[agent, last + 1] = moment
        self._know(agent, number)

    def _know(self, agent: str | int, number: str | int) -> None:
        name, which = str(agent), int(number)
        self._numbers[name] = max(which, self._numbers.get(name, 0))
        if self._awaited:
            self._awaited.pop((name, which), None)

    def _lack(self, moment: int, how: str) -> None:
        if self.missing is None:
            self.missing = moment, f"from {shown(moment)} on, {how}"

    def lacks(self, needs: Needs) -> str | None:
        """What this log does not have of what a statement asks for; None if it has all."""
        for agent in sorted(needs.steps | needs.senders):
            if agent not in self.agents:
                return f"there is no log of {agent}"
        for agent in sorted(needs.steps):
            if agent in self.strangers:
                return self.strangers[agent]
            if agent not in self.steps:
                return f"the log has no steps of {agent}"
        if not self.steps and (needs.channels or needs.faults):
            return f"the log has no {'messages of topics' if needs.channels else 'faults'}"
        return None

    def lacks_conversations(self, item: Expectation) -> str | None:
        """Why a clause cannot be decided though something has happened: no conversation is shown."""
        if item.protocol is None or item.protocol in self.protocols:
            return None
        return f"the log does not show which agents take part in conversations of {item.protocol}"


__all__ = ["Evidence", "Needs", "needs_of", "never_in_a_log"]
