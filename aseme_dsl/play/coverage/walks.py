"""Walks: the agents of a run, followed through the statecharts of their roles by the records of the run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.following import Change, Following, Shape
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.chart.plan import State as PlanState
from aseme_dsl.runtime.chart.plan import Transition as PlanTransition
from aseme_dsl.runtime.trace.records import Record


@dataclass(frozen=True, slots=True)
class Move:
    """What an agent of a role left and entered; by a transition, if it has `taken` one (or a compound one).

    `completed` are the composites that are complete since.
    """

    agent: str
    role: str
    change: Change
    taken: tuple[int, ...] = ()
    completed: tuple[str, ...] = ()


@dataclass(slots=True)
class _Walk:
    role: str
    at: Following
    begins: bool = True
    """Whether the next step enters the root: the first one, also after a crash or a switch of the role."""


class Walks:
    """Follows the agents of one run, also where they switch their roles, or change to these models."""

    def __init__(self, charts: Mapping[str, Statechart], models: Iterable[str] = ()) -> None:
        """`models` are the hashes of the models of the roles; without any, all agents run these."""
        self._charts = charts
        self._models = frozenset(models)
        self._shapes: dict[str, Shape] = {}
        self._walks: dict[str, _Walk] = {}

    def begin(self, agent: str, role: str) -> bool:
        """An agent takes part in a role; whether that is one of this system."""
        if role not in self._charts:
            return False
        self._walks[agent] = _Walk(role, Following(self._shape(role)))
        return True

    def role(self, agent: str) -> str | None:
        """The role of an agent now; None if it is not followed."""
        walk = self._walks.get(agent)
        return None if walk is None else walk.role

    def moves(self, record: Record) -> Iterator[Move]:
        """What an agent does by a record. Each move is to be taken before the next one is asked for."""
        name = str(record.get("agent", ""))
        walk = self._walks.get(name)
        if walk is None:
            self._come(name, record)
            return
        match record["kind"]:
            case "step":
                yield from self._step(name, walk, record)
            case "error":
                yield Move(name, walk.role, walk.at.end())
            case "select" if "reason" not in record:
                yield Move(name, walk.role, walk.at.end())
                if self._is_other(record) or not self.begin(name, record["plan"].rpartition(".")[2]):
                    del self._walks[name]
            case "swap" if record["what"] == "done" and self._is_other(record):
                yield Move(name, walk.role, walk.at.end())
                del self._walks[name]

    def _come(self, name: str, record: Record) -> None:
        """An agent that is not followed may change to one of these models."""
        if self._is_other(record):
            return
        match record["kind"]:
            case "select" if "reason" not in record:
                self.begin(name, record["plan"].rpartition(".")[2])
            case "swap" if record["what"] == "done" and self.begin(name, record["role"]):
                walk = self._walks[name]
                walk.begins = False
                walk.at.stand(record["configuration"])

    def _is_other(self, record: Record) -> bool:
        """Whether the agent has another model from here on, which is not followed."""
        return bool(self._models) and record.get("model") not in self._models

    def _step(self, name: str, walk: _Walk, record: Record) -> Iterator[Move]:
        if walk.begins or record["step"] == 1:
            yield Move(name, walk.role, walk.at.end())
            walk.at, walk.begins = Following(walk.at.shape), False
            yield Move(name, walk.role, walk.at.begin())
        at = walk.at
        for way in record["taken"]:
            numbers = tuple(way["transitions"])
            change = at.take(numbers)
            yield Move(name, walk.role, change, numbers, tuple(_completed(at, change.entered)))
        leaves = record.get("configuration")
        if leaves is not None and not at.active.issuperset(leaves):
            at.stand(leaves)  # a gap in the trace

    def _shape(self, role: str) -> Shape:
        found = self._shapes.get(role)
        if found is None:
            found = self._shapes[role] = _shape_of(self._charts[role])
        return found


def _completed(at: Following, entered: Iterable[str]) -> Iterator[str]:
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


def _shape_of(chart: Statechart) -> Shape:
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
                PlanTransition(
                    item.source, item.target, kind=item.kind.value, resume=item.resume, into=item.into
                )
                for item in chart.transitions
            ),
            branches=tuple(BranchInfo(item.label, item.origin.owner, item.origin.name) for item in branches),
        )
    )


__all__ = ["Move", "Walks"]
