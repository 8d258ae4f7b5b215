"""Seen: what the records of runs say of the states, transitions and outcomes of roles."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.play.coverage.probes import Evaluations
from aseme_dsl.runtime.chart.following import Following as At
from aseme_dsl.runtime.chart.following import Shape
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.chart.plan import State as PlanState
from aseme_dsl.runtime.chart.plan import Transition as PlanTransition
from aseme_dsl.runtime.trace.records import Record


@dataclass(slots=True)
class RoleSeen:
    """What agents of a role have done: how often, by label of the state or number of the transition."""

    entered: Counter[str] = field(default_factory=Counter)
    completed: Counter[str] = field(default_factory=Counter)
    taken: Counter[int] = field(default_factory=Counter)
    ended: Counter[tuple[str, str]] = field(default_factory=Counter)
    """How often the activity of a state has ended with an outcome, by label and outcome."""

    def add(self, other: RoleSeen) -> None:
        self.entered.update(other.entered)
        self.completed.update(other.completed)
        self.taken.update(other.taken)
        self.ended.update(other.ended)


@dataclass(slots=True)
class Seen:
    """What some runs have shown. `evaluated` says in how many the evaluations of conditions were noted."""

    roles: dict[str, RoleSeen] = field(default_factory=dict)
    evaluations: Evaluations = field(default_factory=dict)
    scenarios: int = 0
    traces: int = 0
    evaluated: int = 0
    left_out: Counter[str] = field(default_factory=Counter)
    """Agents of traces that were not counted, by the reason."""

    def of(self, role: str) -> RoleSeen:
        return self.roles.setdefault(role, RoleSeen())

    def add(self, other: Seen) -> None:
        """Take what other runs have shown, too."""
        for role, item in other.roles.items():
            self.of(role).add(item)
        for decision, found in other.evaluations.items():
            self.evaluations.setdefault(decision, set()).update(found)
        self.scenarios += other.scenarios
        self.traces += other.traces
        self.evaluated += other.evaluated
        self.left_out.update(other.left_out)


@dataclass(slots=True)
class _Agent:
    role: str
    at: At


class Following:
    """Counts the records of one run."""

    def __init__(self, charts: Mapping[str, Statechart], seen: Seen, agents: Mapping[str, str]) -> None:
        shapes = {role: shape_of(charts[role]) for role in set(agents.values()) if role in charts}
        self._seen = seen
        known = {name: role for name, role in agents.items() if role in shapes}
        self._agents = {name: _Agent(role, At(shapes[role])) for name, role in known.items()}
        for role in shapes:
            seen.of(role)

    def wants(self, kind: str, what: str | None) -> bool:
        return kind in ("step", "activity", "error")

    def __call__(self, record: Record) -> None:
        agent = self._agents.get(str(record.get("agent", "")))
        if agent is None:
            return
        seen = self._seen.of(agent.role)
        match record["kind"]:
            case "step":
                self._step(agent, seen, record)
            case "activity" if record["what"] == "end":
                seen.completed[record["label"]] += 1
                if (outcome := record.get("outcome")) is not None:
                    seen.ended[record["label"], outcome] += 1
            case "error":
                agent.at.end()

    def leave(self, agent: str) -> None:
        """The agent has another model from here on, which is not counted."""
        self._agents.pop(agent, None)

    def _step(self, agent: _Agent, seen: RoleSeen, record: Record) -> None:
        at = agent.at
        if record["step"] == 1:  # it begins, also after a crash
            at = agent.at = At(at.shape)
            seen.entered.update(at.begin().entered)
        for way in record["taken"]:
            seen.taken.update(way["transitions"])
            entered = at.take(tuple(way["transitions"])).entered
            seen.entered.update(entered)
            seen.completed.update(completed(at, entered))
        leaves = record.get("configuration")
        if leaves is not None and not at.active.issuperset(leaves):
            at.stand(leaves)  # a gap in the trace


def completed(at: At, entered: Iterable[str]) -> Iterator[str]:
    """The composites that are complete since these states were entered."""
    states = at.shape.plan.by_label
    for label in entered:
        parent = states[label].parent
        if states[label].type != "END" or parent is None:
            continue
        yield parent
        around = states[parent].parent
        if around is not None and states[around].type == "AND" and at.is_complete(around):
            yield around


def shape_of(chart: Statechart) -> Shape:
    """What following agents of a role needs of its statechart."""
    branches = [state for state in chart.states if chart.is_branch(state)]
    return Shape(
        Plan(
            chart.name,
            chart.system,
            "",
            "",
            tuple(PlanState(item.label, item.name, item.type.value, item.parent) for item in chart.states),
            tuple(
                PlanTransition(item.source, item.target, kind=item.kind.value, resume=item.resume)
                for item in chart.transitions
            ),
            branches=tuple(BranchInfo(item.label, item.origin.owner, item.origin.name) for item in branches),
        )
    )


__all__ = ["Following", "RoleSeen", "Seen", "completed", "shape_of"]
