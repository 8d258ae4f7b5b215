"""A chart is played by our runtime, and what happens is written down for other engines to repeat.

What only the surroundings know is recorded and given to them: which activities have returned, what has
arrived, which times have come, and what functions, ages and histories say.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from itertools import cycle
from typing import Any

from aseme_dsl.amola.expression import After
from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.codegen.plan import value_term
from aseme_dsl.interop.export.lowering import lowered
from aseme_dsl.interop.export.machine import INPUT, Datum, Machine
from aseme_dsl.interop.export.names import Names
from aseme_dsl.runtime.chart.inputs import Cancel, Completed, Happened, Input, Sample, Start, Written
from tests.oracle.choices import Choices
from tests.oracle.interpreter import ABSENT, Reference
from tests.oracle.playing import filled, like
from tests.support.generated import Generated

MS = 1_000_000
MOST = 100
"""So many steps may follow one another at once: some charts raise an event in each, and have no end."""
HOSTS = ("ann", "bob", "me")


@dataclass(frozen=True)
class Step:
    """An event for the engine, and the ids of the states that are then active; None: the agent has ended."""

    event: str
    data: dict[str, Any]
    active: tuple[str, ...] | None


@dataclass(frozen=True)
class Recording:
    """A machine with its first values, what is active at first, and what follows."""

    machine: Machine
    chart: Statechart
    first: tuple[str, ...] | None
    steps: tuple[Step, ...]


@dataclass
class Recorder:
    """Plays a role, and records it."""

    made: Generated
    role: str = "R"
    waits: tuple[int, ...] = (0, MS, 5 * MS, 10 * MS, 20 * MS)
    now: int = 0
    running: dict[str, int] = field(default_factory=dict)
    numbers: int = 0

    def __post_init__(self) -> None:
        chart = self.made.system.iac(self.role)
        assert chart is not None
        self.chart: Statechart = chart
        self.machine, self.refused = lowered(self.made.system, chart)
        self.plan = self.made.plan(self.role)
        self.actual = self.made.chart(self.role, "me")
        self.reference = Reference(self.plan, "me", vars(self.made.messages))
        self.ids = {vertex.label: vertex.id for vertex in self.machine.root.inside()}
        self.known: dict[str, Any] = {}
        self.said: dict[str, Any] = {}
        self.names = Names(chart)
        for state in chart.states:
            self.names.id_of(state)
        self.durations = dict(self._durations())

    def _durations(self) -> Iterator[tuple[str, set[int]]]:
        for source in self.chart.states:
            found: set[int] = set()
            stack = [source.label]
            while stack:
                for way in self.chart.outgoing(stack.pop()):
                    found |= {e.duration for e in way.expression.events if isinstance(e, After)}
                    found |= {way.expression.every} - {None}  # type: ignore[arg-type]
                    if self.chart.node(way.target).type is StateType.CONDITION:
                        stack.append(way.target)
            yield source.label, found

    def record(self, choices: Choices, most: int = 25) -> Recording | None:
        """Play up to so many steps; None if not even the first one ends."""
        first = self.step([])
        if isinstance(first, bool):
            return None
        initial = self.known
        begun = tuple(self._begun(item, initial) for item in self.machine.data)
        machine = replace(self.machine, data=begun)
        steps: list[Step] = []
        while len(steps) < most and not self.reference.finished:
            self.now += choices.one_of(self.waits)
            inputs = [self.input(choices) for _ in range(choices.weighted(none=1, one=5, two=2) != "none")]
            before = self.known
            active = self.step([item for item in inputs if item is not None])
            if isinstance(active, bool):
                break
            data = {key: value for key, value in self.known.items() if before.get(key) != value}
            steps.append(Step(INPUT, self.said | data, active))
        return Recording(machine, self.chart, first, tuple(steps))

    def _begun(self, item: Datum, known: dict[str, Any]) -> Datum:
        value = known.get(item.name)
        return item if item.given is None or isinstance(value, dict) else replace(item, initial=value)

    def step(self, inputs: list[Input]) -> tuple[str, ...] | bool | None:
        """Make a step, and those that follow it at once; False if the agent fails, or too many follow."""
        self.said = self.flags() | dict(pair for item in inputs for pair in self.set_by(item))
        for _ in range(MOST):
            expected = self.reference.step(self.now, inputs)
            outcome = self.actual.step(self.now, inputs)
            assert self.reference.configuration() == self.actual.configuration()
            for effect in outcome.effects:
                if isinstance(effect, Start):
                    self.running[effect.label] = effect.token
                elif isinstance(effect, Cancel):
                    self.running.pop(effect.label, None)
            if expected.failure is not None:
                return False
            if not (expected.again or outcome.again):
                break
            inputs = []
        else:
            return False
        self.known = self.seen()
        if self.reference.finished:
            return None
        return tuple(self.ids[label] for label in sorted(self.reference.active) if label in self.ids)

    # ---- what the engine is given -------------------------------------------------------

    def flags(self) -> dict[str, Any]:
        """The times that have come for what was active before the step."""
        found: dict[str, Any] = {}
        for state in self.chart.states:
            if state.label not in self.reference.active:
                continue
            for duration in self.durations.get(state.label, ()):
                if self.now - self.reference.entered[state.label] >= duration:
                    found[self.names.after(state, duration)] = True
        for label, region in self.reference.regions.items():
            for timer, due in region.timers.items():
                if due <= self.now:
                    found[self.names.timer(label, timer)] = True
        known = {item.name for item in self.machine.data}
        return {name: value for name, value in found.items() if name in known}

    def set_by(self, item: Input) -> Iterator[tuple[str, Any]]:
        """The inputs that something sets."""
        known = {datum.name for datum in self.machine.data}
        match item:
            case Completed(label=label, outcome=outcome):
                state = self.chart.node(label)
                yield self.names.flag("done", state), True
                if self.names.flag("outcome", state) in known:
                    yield self.names.flag("outcome", state), outcome
            case Written(variable=name, value=value) if self.names.variable(name) in known:
                yield self.names.variable(name), plain(value)
            case Happened(name=name):
                for region in self.plan.regions:
                    if (flag := self.names.event(region.label, name)) in known:
                        yield flag, True

    def seen(self) -> dict[str, Any]:
        """What arrived last, and what functions, ages and histories say."""
        board = self.reference.regions[self.chart.root.label]
        found: dict[str, Any] = {}
        for item in self.machine.data:
            if item.given is None:
                continue
            self.reference.asking = self.chart.root.label
            term = value_term(item.given)
            try:
                value = self.reference.value(term, board)
            except Exception:  # of a function of the project: its value is absent
                value = ABSENT
            found[item.name] = None if value is ABSENT else plain(value)
        return found

    def input(self, choices: Choices) -> Input | None:
        match choices.weighted(done=8, arrival=5, event=4, write=2, nothing=1):
            case "done" if self.running:
                label = choices.one_of(list(self.running))
                return Completed(label, self.running.pop(label))
            case "event":
                ways = self.plan.transitions
                names = sorted({e[1] for way in ways for e in way.events if e[0] == "raised"})
                return Happened(str(choices.one_of(names))) if names else None
            case "write" if self.plan.variables:
                variable = choices.one_of(self.plan.variables)
                before = self.reference.variable(variable.name)
                if before is None or isinstance(before, tuple) or is_dataclass(before):
                    return None
                kind = next(item.type for item in self.chart.variables if item.name == variable.name)
                if kind.kind is Kind.ENUM and not isinstance(before, Enum):
                    before = getattr(self.made.messages, kind.name)(before)
                return Written(variable.name, like(before, choices.number(0, 3)))
            case "arrival" if self.plan.channels:
                info = choices.one_of(self.plan.channels)
                members = tuple(choices.number(0, 3) for _ in range(6))
                message = filled(getattr(self.made.messages, info.message), cycle(members))
                sender = choices.one_of(HOSTS)
                self.numbers += 1
                age = choices.one_of((0, 0, MS, 10 * MS))
                return Sample(info.name, message, sender, self.now - age, (sender, self.numbers))
        return None


def plain(value: Any) -> Any:
    """A value as JSON has it: messages are objects, enum constants their names."""
    if isinstance(value, Enum):
        return value.name
    if is_dataclass(value) and not isinstance(value, type):
        return {item.name: plain(getattr(value, item.name)) for item in fields(value)}
    return [plain(item) for item in value] if isinstance(value, tuple) else value
