"""Metrics: how often and how long agents were in states, goals were served and protocols ran, run by run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import field

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.play.coverage.measure import is_counted
from aseme_dsl.play.coverage.serving import Place, Serving, serving
from aseme_dsl.play.coverage.walks import Move, Walks
from aseme_dsl.records import dataclass
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
    """How many agents each role has, or has had."""
    outcomes: Counter[tuple[str, str]] = field(default_factory=Counter)
    """How activities ended, by activity and outcome: `failed` among them."""


class Measuring:
    """Measures one run by its records."""

    def __init__(self, system: System, models: Iterable[str] = ()) -> None:
        """`models` are the hashes of the models of the roles; without any, all agents run these."""
        self.found = RunMetrics()
        self._charts = {chart.name: chart for chart in system.iacs}
        self._walks = Walks(self._charts, models)
        cases = serving(system)
        self._goals = {goal.name: frozenset(_served(cases[goal.name])) for goal in system.sag.goals}
        self._since: dict[tuple[str, str, str], int] = {}
        """Since when an agent in a role is in a state, by its label."""
        self._roles: set[tuple[str, str]] = set()
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
                    self._walks.begin(agent["name"], agent.get("role", ""))
                    self._count(agent["name"])
            case "step" | "error" | "select" | "swap":
                for move in self._walks.moves(record):
                    self._move(move, now)
                if record["kind"] == "select":
                    self._count(record["agent"])
            case "activity" if record["what"] in ("end", "crash"):
                how = "failed" if record["what"] == "crash" else record.get("outcome")
                if how is not None:
                    self.found.outcomes[record["activity"], how] += 1
            case "conversation":
                self._conversation(record, now)
            case "agent_message" if record.get("protocol"):
                self.found.messages[record["protocol"]] += 1
            case "finish":
                self._finish(now)

    def _count(self, agent: str) -> None:
        """An agent has a role, perhaps a second one."""
        role = self._walks.role(agent)
        if role is not None and (agent, role) not in self._roles:
            self._roles.add((agent, role))
            self.found.agents[role] += 1

    def _move(self, move: Move, now: int) -> None:
        role = move.role
        for label in move.change.left:
            since = self._since.pop((move.agent, role, label), None)
            if since is not None:
                self._times((role, label)).lasted.append(now - since)
                self._serve(role, label, -1, now)
        for label in move.change.entered:
            if is_counted(self._charts[role].by_label[label]):
                self._since[move.agent, role, label] = now
                self._times((role, label)).began += 1
                self._serve(role, label, 1, now)
        self._complete.update((move.agent, label) for label in move.completed)

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
        for (_, role, label), since in self._since.items():
            times = self._times((role, label))
            times.lasted.append(now - since)
            times.open += 1
        self._since.clear()
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
