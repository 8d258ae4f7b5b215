"""Metrics: how often and how long agents were in states, goals were served and protocols ran, run by run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.play.coverage.measure import is_counted
from aseme_dsl.play.coverage.seen import completed, shape_of
from aseme_dsl.play.coverage.serving import Place, Serving, serving
from aseme_dsl.runtime.chart.following import Following as At
from aseme_dsl.runtime.trace.records import Record, agents_of


@dataclass(slots=True)
class Times:
    """How often something began in a run, and how long it lasted each time (ns).

    `open` are those that had not ended with the run: they count up to its end.
    """

    began: int = 0
    lasted: list[int] = field(default_factory=list)
    open: int = 0

    @property
    def total(self) -> int:
        return sum(self.lasted)


@dataclass(slots=True)
class RunMetrics:
    """What happened in one run, which lasted `end` ns."""

    seed: int | None = None
    end: int = 0
    states: dict[Place, Times] = field(default_factory=dict)
    """By role and label."""
    goals: dict[str, Times] = field(default_factory=dict)
    protocols: dict[str, Times] = field(default_factory=dict)
    """The conversations of each protocol."""
    messages: Counter[str] = field(default_factory=Counter)
    """The agent messages of each protocol."""
    parts: Counter[tuple[str, str, str]] = field(default_factory=Counter)
    """How the parts of agents ended, by protocol, participant and `completed`, `left` or `open`."""
    agents: Counter[str] = field(default_factory=Counter)
    """How many agents each role has."""
    outcomes: Counter[tuple[str, str]] = field(default_factory=Counter)
    """How activities ended, by activity and outcome: `failed` among them."""


@dataclass(slots=True)
class _Agent:
    role: str
    at: At
    since: dict[str, int] = field(default_factory=dict)


class Measuring:
    """Measures one run by its records."""

    def __init__(self, system: System) -> None:
        self.found = RunMetrics()
        self._charts = {chart.name: chart for chart in system.iacs}
        self._shapes = {name: shape_of(chart) for name, chart in self._charts.items()}
        cases = serving(system)
        self._goals = {goal.name: frozenset(_served(cases[goal.name])) for goal in system.sag.goals}
        self._agents: dict[str, _Agent] = {}
        self._busy: dict[str, int] = {}
        """How many active states serve a goal now."""
        self._goal_since: dict[str, int] = {}
        self._conversations: dict[str, tuple[str, int]] = {}
        self._joined: dict[tuple[str, str], tuple[str, str, str]] = {}
        self._ended: dict[tuple[str, str], tuple[str, str, str]] = {}
        self._members: Counter[str] = Counter()
        self._complete: set[tuple[str, str]] = set()

    def __call__(self, record: Record) -> None:
        """Take a record: those of a run come in their order, the header first."""
        now = record["time"]
        self.found.end = max(self.found.end, now)
        match record["kind"]:
            case "header":
                self.found.seed = record.get("seed")
                for agent in agents_of(record):
                    shape = self._shapes.get(agent.get("role", ""))
                    if shape is not None:
                        self.found.agents[agent["role"]] += 1
                        self._agents[agent["name"]] = _Agent(agent["role"], At(shape))
            case "step":
                self._step(record, now)
            case "activity" if record["what"] in ("end", "crash"):
                how = "failed" if record["what"] == "crash" else record.get("outcome")
                if how is not None:
                    self.found.outcomes[record["activity"], how] += 1
            case "conversation":
                self._conversation(record, now)
            case "agent_message" if record.get("protocol"):
                self.found.messages[record["protocol"]] += 1
            case "error":
                self._change(record["agent"], self._agents[record["agent"]].at.end().left, (), now)
            case "finish":
                self._finish(now)

    def _step(self, record: Record, now: int) -> None:
        agent = self._agents.get(record["agent"])
        if agent is None:
            return
        name = record["agent"]
        if record["step"] == 1:
            self._change(name, tuple(agent.since), (), now)
            agent.at = At(agent.at.shape)
            self._change(name, (), agent.at.begin().entered, now)
        for way in record["taken"]:
            change = agent.at.take(tuple(way["transitions"]))
            self._change(name, change.left, change.entered, now)
            self._complete.update((name, label) for label in completed(agent.at, change.entered))

    def _change(self, name: str, left: Iterable[str], entered: Iterable[str], now: int) -> None:
        agent = self._agents[name]
        for label in left:
            since = agent.since.pop(label, None)
            if since is not None:
                self._times((agent.role, label)).lasted.append(now - since)
                self._serve(agent.role, label, -1, now)
        for label in entered:
            if is_counted(self._charts[agent.role].by_label[label]):
                agent.since[label] = now
                self._times((agent.role, label)).began += 1
                self._serve(agent.role, label, 1, now)

    def _times(self, place: Place) -> Times:
        return self.found.states.setdefault(place, Times())

    def _serve(self, role: str, label: str, change: int, now: int) -> None:
        """A goal is served from the first state that serves it until the last one is left."""
        for goal, places in self._goals.items():
            if (role, label) not in places:
                continue
            before = self._busy.get(goal, 0)
            self._busy[goal] = before + change
            times = self.found.goals.setdefault(goal, Times())
            if change > 0:
                times.began += 1
                self._goal_since.setdefault(goal, now)
            elif before == 1:
                times.lasted.append(now - self._goal_since.pop(goal))

    def _conversation(self, record: Record, now: int) -> None:
        name = record["conversation"]
        protocol = str(record.get("protocol") or name.partition("-")[0])
        times = self.found.protocols.setdefault(protocol, Times())
        key = (record["agent"], name)
        if record["what"] in ("open", "join") and key not in self._joined:
            if name not in self._conversations:
                self._conversations[name] = protocol, now
                times.began += 1
            self._complete.discard((record["agent"], record["branch"]))
            self._joined[key] = (protocol, record["participant"], record["branch"])
            self._members[name] += 1
        elif record["what"] == "leave" and key in self._joined:
            _, participant, branch = self._joined.pop(key)
            how = "completed" if (record["agent"], branch) in self._complete else "left"
            self.found.parts[protocol, participant, how] += 1
            self._ended[key] = (protocol, participant, how)
            self._members[name] -= 1
            if not self._members[name]:
                times.lasted.append(now - self._conversations.pop(name)[1])
        elif record["what"] == "gone" and record.get("reason") == "completed":
            protocol, participant, how = self._ended.get((record["peer"], name), ("", "", ""))
            if how == "left":  # it has begun and completed in one step
                self.found.parts[protocol, participant, how] -= 1
                self.found.parts[protocol, participant, "completed"] += 1
                self._ended[record["peer"], name] = (protocol, participant, "completed")

    def _finish(self, now: int) -> None:
        for agent in self._agents.values():
            for label, since in agent.since.items():
                times = self._times((agent.role, label))
                times.lasted.append(now - since)
                times.open += 1
            agent.since.clear()
        for goal, since in self._goal_since.items():
            self.found.goals[goal].lasted.append(now - since)
            self.found.goals[goal].open += 1
        self._goal_since.clear()
        for protocol, since in self._conversations.values():
            times = self.found.protocols[protocol]
            times.lasted.append(now - since)
            times.open += 1
        self._conversations.clear()
        for protocol, participant, _ in self._joined.values():
            self.found.parts[protocol, participant, "open"] += 1
        self._joined.clear()

    def end(self) -> RunMetrics:
        """What was measured; a run without an end is over with its last record."""
        self._finish(self.found.end)
        return self.found


def _served(found: Serving) -> Iterable[Place]:
    """The states that serve a use case, or without any those of what it includes."""
    if found.states:
        yield from found.states
    else:
        for item in found.included:
            yield from _served(item)


def state_title(charts: Mapping[str, Statechart], place: Place) -> str:
    """The name of a state of a role."""
    chart = charts[place[0]]
    return chart.title(chart.by_label[place[1]])


__all__ = ["Measuring", "RunMetrics", "Times", "state_title"]
