"""The plain face as an engine of tests: inputs become what a program does, and its calls become effects."""

from __future__ import annotations

import importlib
import inspect
import sys
from collections.abc import Iterable
from random import Random
from typing import Any

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.plain.generate import module_text
from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.codegen.plain_limits import limits
from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Fault,
    FunctionResult,
    Happened,
    Input,
    Outcome,
    Sample,
    Start,
    Written,
)
from aseme_dsl.runtime.plain.plain import ActivityFailed, OutOfBounds, Plain, Unsettled
from tests.support.forgetting import forget_folders
from tests.support.generated import Generated


class CannotDo(Exception):
    """The plain face refuses a text, or there is no such input."""


def plain_class(made: Generated, role: str, options: PlainOptions) -> Any:
    """The class of a role, in a module of the package of its system.

    Raises:
        CannotDo: it is refused.
    """
    chart = made.system.iac(role)
    assert chart is not None
    refused = limits(chart, made.system.activities)
    if refused:
        raise CannotDo("; ".join(dict.fromkeys(limit.what.value for limit in refused)))
    name = f"plain_{role}{'_watched' * options.watched}{'_mapping' * options.mapping}"
    full = f"{made.package.__name__}.{name}"
    if full not in sys.modules:
        text = module_text(made.system, chart, BackendOptions(), options)
        (made.folder / made.package.__name__ / f"{name}.py").write_text(text, "utf-8")
        forget_folders(made.folder)
        importlib.import_module(full)
    found = vars(sys.modules[full]).values()
    return next(v for v in found if isinstance(v, type) and issubclass(v, Plain) and v is not Plain)


class PlainEngine:
    """A watched plain chart with the interface of an agent's chart; what it was told is in the outcome."""

    def __init__(self, made: Generated, role: str) -> None:
        self.plan = made.plan(role)
        self.pending: Any = tuple
        self.outcome = Outcome()
        self.started = False
        self.failure: str | None = None
        self.is_outside = False
        """Whether a write outside of its variable's bounds has ended it."""
        self.tokens = 0
        self.token: dict[str, int] = {}
        kind = plain_class(made, role, PlainOptions(watched=True))
        self.chart = _telling(kind, self)()
        self.slots = {(channel, host): slot for slot, channel, host in getattr(kind, "MESSAGES", ()) if slot}
        chart = self.chart
        if hasattr(chart, "chance"):
            chart.chance = Random("1/me")
        for agent, name, value in self.plan.settings:
            if agent == "me":
                setattr(chart.bb, name, value)

    def step(self, now: int, inputs: Iterable[Input]) -> Outcome:
        """One step of an agent: what is on the blackboard at once, then at most one event or completion.

        Raises:
            CannotDo: there is more than one of these, or an input of another kind.
        """
        self.outcome = Outcome()
        if self.failure is not None or (self.started and self.chart.finished):
            self.outcome.finished, self.outcome.failure = self.failure is None, self.failure
            return self.outcome
        calls: list[Input] = []
        for item in inputs:
            match item:
                case Sample():
                    self.hear(item)
                case Written(variable, value):
                    setattr(self.chart.bb, variable, value)
                case Happened():
                    calls.append(item)
                case Completed(label, token) | Crashed(label, token):
                    if token == self.token.get(label):
                        del self.token[label]  # what has returned does not return again
                        calls.append(item)
                case AgentMessage():
                    raise CannotDo(f"{type(item).__name__} as an input")
        if len(calls) > 1 or (calls and not self.started):
            raise CannotDo("several inputs in one step")
        if hasattr(type(self.chart), "now"):
            self.chart.now = now
        try:
            self.call(calls)
            self.check_that_nothing_is_enabled()
        except (Unsettled, OutOfBounds) as error:
            self.failure = str(error)
            self.is_outside = isinstance(error, OutOfBounds)
        except ActivityFailed as error:
            raise CannotDo("stopping: the program is told of the failure") from error
        self.outcome.failure = self.failure
        self.outcome.finished = self.failure is None and self.chart.finished
        return self.outcome

    def call(self, calls: list[Input]) -> None:
        if not self.started:
            self.started = True
            self.chart.start()
            return
        match calls:
            case [Happened(name)]:
                self.chart.send(name)
            case [Completed(label, _, outcome)]:
                self.chart.done(label, outcome)
            case [Crashed(label, _, reason)]:
                self.chart.failed(label, reason)
            case _:
                self.chart.step()

    def check_that_nothing_is_enabled(self) -> None:
        """A further step takes nothing: else a program that waits for an input has overlooked something."""
        taken, effects = len(self.outcome.taken), len(self.outcome.effects)
        if not self.chart.finished:
            self.chart.step()
        assert len(self.outcome.taken) == taken, f"it rests although it may take {self.outcome.taken[taken:]}"
        del self.outcome.effects[effects:]

    def hear(self, item: Sample) -> None:
        """Put a state on the blackboard."""
        for (channel, host), slot in self.slots.items():
            if channel == item.channel and host in (None, item.sender):
                setattr(self.chart.bb, slot, item.message)

    def due(self, now: int) -> int | None:
        if self.failure is not None or self.chart.finished or not hasattr(self.chart, "due"):
            return None
        self.chart.now = now
        found: int | None = self.chart.due()
        return found

    def configuration(self) -> tuple[str, ...]:
        found: tuple[str, ...] = self.chart.configuration()
        return found

    def variable(self, name: str) -> Any:
        return getattr(self.chart.bb, name)


def _telling(kind: Any, engine: PlainEngine) -> Any:
    """A subclass of a watched chart that notes in the outcome of an engine what it is told."""

    def start(self: Any, label: str, *arguments: Any) -> None:
        engine.tokens += 1
        engine.token[label] = engine.tokens
        activity = engine.plan.by_label[label].activity or ""
        names = list(inspect.signature(getattr(kind, f"start_{activity}")).parameters)[2:]
        given = tuple(zip(names, arguments, strict=True))
        engine.outcome.effects.append(Start(label, activity, engine.tokens, given))

    def stop(self: Any, label: str) -> None:
        activity = engine.plan.by_label[label].activity or ""
        engine.outcome.effects.append(Cancel(label, activity, engine.token.pop(label)))

    def took(self: Any, *transitions: int) -> None:
        engine.outcome.taken.append(transitions)

    def fault(self: Any, transition: int, reason: object) -> bool:
        if isinstance(reason, OutOfBounds):
            raise reason
        if transition not in self.faulty:
            self.faulty = (*self.faulty, transition)
            engine.outcome.effects.append(Fault(transition, str(reason)))
        return False

    def noting(name: str, function: Any) -> Any:
        def call(*arguments: Any) -> Any:
            value = function(*arguments)
            engine.outcome.effects.append(FunctionResult(name, value))
            return value

        return call

    module = vars(sys.modules[kind.__module__])
    for name, function in list(module.items()):
        original = getattr(function, "original", function)
        if getattr(original, "called", None):
            module[name] = noting(original.called, original)
            module[name].original = original

    def random(self: Any) -> float:
        value: float = self.chance.random()
        engine.outcome.effects.append(FunctionResult("random", value))
        return value

    methods: dict[str, Any] = {"took": took, "fault": fault, "random": random}
    methods |= {name: start for name in vars(kind) if name.startswith("start_")}
    methods |= {name: stop for name in vars(kind) if name.startswith("stop_")}
    return type(f"Telling{kind.__name__}", (kind,), methods)
