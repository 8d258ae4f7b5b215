"""Insight: what conditions ask of an agent's statechart that the lines of a trace do not say.

In virtual time it is asked while it is so (`Present`). Who looks later, or from another process, has it kept
with the line of the step (`Kept`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from typing import Protocol

from aseme_dsl.amola import expression as e
from aseme_dsl.play.scenario import Condition, Holds
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.team.team import Team


class Insight(Protocol):
    """The inside of an agent's statechart."""

    @property
    def plan(self) -> Plan:
        """What it follows."""

    @property
    def index(self) -> int:
        """Which instance it is."""

    def variable(self, name: str) -> object:
        """The value of a variable, as a trace tells it; None before the first step, or if there is none."""

    def outcome(self, activity: str) -> str | None:
        """How an activity has ended last."""

    def timers(self, name: str) -> Iterable[int]:
        """When a timer runs out, in each region in which it is started (ns)."""

    def has_returned(self, label: str) -> bool:
        """Whether the activity of a BASIC state has returned."""


class Surroundings(Protocol):
    """The run that conditions are about."""

    def now(self) -> int:
        """The time of the run (ns)."""

    def at(self, moment: int, call: Callable[[], None]) -> None:
        """Make a call at a moment; it keeps no run from its end."""

    def insight(self, agent: str) -> Insight:
        """The inside of an agent."""


# ---- while it is so ---------------------------------------------------------------------------------


class Live:
    """The inside of an agent, whose statechart this is, as it is now."""

    def __init__(self, chart: Chart) -> None:
        self._chart = chart
        self.plan = chart.PLAN

    @property
    def index(self) -> int:
        return self._chart.index

    def variable(self, name: str) -> object:
        chart = self._chart
        return to_json(chart.variable(name)) if chart.started and name in chart.VARIABLES else None

    def outcome(self, activity: str) -> str | None:
        of = self.plan.by_label
        ended = reversed(self._chart.outcomes.items())
        return next((how for label, how in ended if of[label].activity == activity), None)

    def timers(self, name: str) -> Iterable[int]:
        boards = self._chart.boards() if self._chart.started else ()
        return (board.timers[name] for board in boards if board is not None and name in board.timers)

    def has_returned(self, label: str) -> bool:
        leaf, _, number = self._chart.RUNNING[label]
        return bool(getattr(self._chart, leaf) == number + 1)


class Present:
    """A team in this process, in virtual time."""

    def __init__(self, team: Team) -> None:
        self._team = team

    def now(self) -> int:
        return self._team.driver.clock.now()

    def at(self, moment: int, call: Callable[[], None]) -> None:
        self._team.driver.at(moment, call, background=True)

    def insight(self, agent: str) -> Insight:
        return Live(self._team.agent(agent).chart)


# ---- for later --------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Asked:
    """What conditions ask of the inside of agents, by name; as plain data, for another process."""

    variables: tuple[str, ...] = ()
    outcomes: tuple[str, ...] = ()
    timers: tuple[str, ...] = ()
    done: tuple[str, ...] = ()
    """States that are asked whether they are complete."""


def asked_by(conditions: Iterable[Condition]) -> Asked:
    """What these conditions ask."""
    parts = [part for item in conditions if isinstance(item, Holds) for part in e.walk(item.value)]
    return Asked(
        tuple(dict.fromkeys(part.name for part in parts if isinstance(part, e.VariableValue))),
        tuple(dict.fromkeys(part.activity for part in parts if isinstance(part, e.Outcome))),
        tuple(dict.fromkeys(part.timer for part in parts if isinstance(part, e.Expired))),
        tuple(
            dict.fromkeys(
                part.state for part in parts if isinstance(part, e.StateValue) and part.question == "done"
            )
        ),
    )


@dataclass(frozen=True, slots=True)
class Kept:
    """The inside of an agent after a step, as far as it is asked for."""

    plan: Plan
    index: int = 1
    variables: Mapping[str, object] = field(default_factory=dict)
    outcomes: Mapping[str, str] = field(default_factory=dict)
    started: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    """When the timers run out."""
    returned: frozenset[str] = frozenset()

    def variable(self, name: str) -> object:
        return self.variables.get(name)

    def outcome(self, activity: str) -> str | None:
        return self.outcomes.get(activity)

    def timers(self, name: str) -> Iterable[int]:
        return self.started.get(name, ())

    def has_returned(self, label: str) -> bool:
        return label in self.returned


def kept(chart: Chart, asked: Asked) -> Kept:
    """The inside of an agent as it is now. To be called where no other thread steps it."""
    live = Live(chart)
    ends = ((name, live.outcome(name)) for name in asked.outcomes)
    return Kept(
        live.plan,
        live.index,
        {name: live.variable(name) for name in asked.variables},
        {name: how for name, how in ends if how is not None},
        {name: moments for name in asked.timers if (moments := tuple(live.timers(name)))},
        frozenset(
            state.label
            for name in asked.done
            for state in live.plan.states
            if state.type == "BASIC" and name in (state.name, state.activity)
            if live.has_returned(state.label)
        ),
    )


__all__ = ["Asked", "Insight", "Kept", "Live", "Present", "Surroundings", "asked_by", "kept"]
