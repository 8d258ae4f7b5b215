"""Seen: what the records of runs say of the states, transitions and outcomes of roles."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import field

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.play.coverage.probes import Evaluations
from aseme_dsl.play.coverage.walks import Walks
from aseme_dsl.records import dataclass
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


class Following:
    """Counts the records of one run."""

    def __init__(
        self,
        charts: Mapping[str, Statechart],
        seen: Seen,
        agents: Mapping[str, str],
        models: Iterable[str] = (),
    ) -> None:
        """`models` are the hashes of the models of the roles; without any, all agents run these."""
        self._seen = seen
        self._walks = Walks(charts, models)
        for name, role in agents.items():
            if self._walks.begin(name, role):
                seen.of(role)

    def wants(self, kind: str, what: str | None) -> bool:
        return kind in ("step", "activity", "error", "select", "swap")

    def __call__(self, record: Record) -> None:
        for move in self._walks.moves(record):
            seen = self._seen.of(move.role)
            seen.taken.update(move.taken)
            seen.entered.update(move.change.entered)
            seen.completed.update(move.completed)
        if record["kind"] == "activity" and record["what"] == "end":
            role = self._walks.role(record["agent"])
            if role is None:
                return
            seen = self._seen.of(role)
            seen.completed[record["label"]] += 1
            if (outcome := record.get("outcome")) is not None:
                seen.ended[record["label"], outcome] += 1


__all__ = ["Following", "RoleSeen", "Seen"]
