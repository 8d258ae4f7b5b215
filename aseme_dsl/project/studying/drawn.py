"""Drawn: inputs that a chart can take, by a seed.

The inputs are events that transitions wait for, values for the messages that are read, ends of activities,
writes to variables, and agent messages that branches wait for. The values are near the constants that
conditions compare them with. All are drawn while a chart runs.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from enum import Enum
from typing import assert_never

from aseme_dsl.amola.expression import Literal, Raised, Received
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.statechart import Statechart, Variable
from aseme_dsl.amola.system import System
from aseme_dsl.project.studying.course import Course, Given, Recorder, begun
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import AgentMessage, Completed, Happened, Input, Sample, Written
from aseme_dsl.runtime.message.by_name import made

MS = 1_000_000
_LONGEST = 50
"""Milliseconds between two inputs, at most; now and then it is a thousand times as long."""
Constant = bool | int | float | str

STARTS = 100
"""How often a chart begins at the most."""


def drawn(
    system: System,
    chart: Statechart,
    kind: type[Chart],
    messages: Mapping[str, type[object]],
    steps: int,
    seed: int,
    number: int = 0,
) -> Course:
    """A course with so many inputs after its first step, or with as many as the chart takes before its end.

    `messages` are the classes of the messages and enums that `kind` reads. With each `number`, other inputs
    are drawn by the same seed.
    """
    chance = random.Random(f"{seed} {chart.name} {number}" if number else f"{seed} {chart.name}")
    drawing = _Drawing(system, chart, kind, messages, chance)
    running = begun(kind, "one")
    recorder = Recorder(running, "one")
    recorder.play(Given(0))
    now = 0
    while len(recorder.steps) <= steps and not running.finished and running.failure is None:
        now += chance.randrange(_LONGEST) * (1000 if chance.random() < 0.02 else 1) * MS
        item = drawing.next(running, now, len(recorder.steps))
        if item is None:
            break
        recorder.play(Given(now, (item,)))
    return recorder.course()


def drawn_anew(
    system: System,
    chart: Statechart,
    kind: type[Chart],
    messages: Mapping[str, type[object]],
    steps: int,
    seed: int,
) -> list[Course]:
    """Courses with so many inputs in all: where one comes to an end of the chart, another begins.

    Of a chart that comes to its end soon there are no more than `STARTS`; of one that takes no input, none.
    """
    found: list[Course] = []
    while steps > 0 and len(found) < STARTS:
        one = drawn(system, chart, kind, messages, steps, seed, len(found))
        if len(one.steps) <= 1:
            break
        found.append(one)
        steps -= len(one.steps) - 1
    return found


class _Drawing:
    """Draws inputs that a chart can take."""

    def __init__(
        self,
        system: System,
        chart: Statechart,
        kind: type[Chart],
        classes: Mapping[str, type[object]],
        chance: random.Random,
    ) -> None:
        self.chance = chance
        self.kind = kind
        self.classes = classes
        self.messages = {message.name: message for message in system.messages}
        self.enums = {enum.name: enum for enum in system.enums}
        events = [event for item in chart.transitions for event in item.expression.events]
        self.events = sorted({event.name for event in events if isinstance(event, Raised)})
        self.channels = [
            (info.name, info.message) for info in kind.PLAN.channels if kind.READERS.get(info.name)
        ]
        awaited = dict.fromkeys(
            (event.performative, event.message, event.participant)
            for event in events
            if isinstance(event, Received)
        )
        self.mails = [
            (branch.label, *mail)
            for branch in kind.PLAN.branches
            for mail in awaited
            if mail[:2] in branch.receives
        ]
        written = {name for item in kind.PLAN.activities for name in item.variables}
        self.variables = [item for item in chart.variables if item.name in written]
        self.waits = {node.label for node in chart.states if node.waits}
        self.ends = {item.name: item.ends for item in kind.PLAN.activities}
        self.activity = {node.label: node.activity for node in chart.states}
        self.constants: dict[Kind, list[Constant]] = {}
        for _, value in chart.values():
            if isinstance(value, Literal):
                self.constants.setdefault(value.type.kind, []).append(value.value)

    def next(self, chart: Chart, now: int, number: int) -> Input | None:
        """Input `number` for a chart as it is; None if there is nothing that it could take."""
        running = [
            label
            for label, (leaf, _, state) in chart.RUNNING.items()
            if getattr(chart, leaf) == state and label not in self.waits
        ]
        active = chart.configuration()
        mails = [mail for mail in self.mails if any(label.startswith(f"{mail[0]}.") for label in active)]
        kinds = [
            *(["event"] * bool(self.events)),
            *(["message"] * 2 * bool(self.channels)),
            *(["done"] * 2 * bool(running)),
            *(["write"] * bool(self.variables)),
            *(["mail"] * 3 * bool(mails)),
        ]
        if not kinds:
            return None
        identity = ("other", number)
        match self.chance.choice(kinds):
            case "event":
                return Happened(self.chance.choice(self.events))
            case "message":
                channel, message = self.chance.choice(self.channels)
                return Sample(channel, self.content(message), "other", now, identity)
            case "done":
                label = self.chance.choice(running)
                ends = self.ends.get(self.activity[label] or "", ())
                outcome = self.chance.choice(ends) if ends else None
                return Completed(label, getattr(chart, chart.RUNNING[label][1]), outcome)
            case "write":
                variable = self.chance.choice(self.variables)
                return Written(variable.name, _inside(variable, self.value(variable.type)))
            case _:
                branch, performative, message, participant = self.chance.choice(mails)
                content = self.content(message) if message else None
                return AgentMessage(branch, performative, message, content, participant, "other", identity)

    def content(self, name: str) -> object:
        """A message with values for its members, some of an optional one missing."""
        found: dict[str, object] = {}
        for item in self.messages[name].fields:
            if item.label == "repeated":
                found[item.name] = tuple(self.value(item.type) for _ in range(self.chance.randrange(4)))
            elif item.label != "optional" or self.chance.random() < 0.7:
                found[item.name] = self.value(item.type)
        return made(self.classes[name], **found)

    def value(self, kind: Type) -> object:
        """A value of a type: more often than not near a constant of the chart's own conditions."""
        chance = self.chance
        known = self.constants.get(kind.kind, [])
        near = chance.choice(known) if known and chance.random() < 0.7 else None
        match kind.kind:
            case Kind.BOOL:
                return chance.random() < 0.5
            case Kind.INT | Kind.DURATION:
                return (0 if near is None else int(near)) + chance.randrange(-2, 3)
            case Kind.DOUBLE:
                return (chance.uniform(-1, 1) if near is None else float(near)) + chance.choice(
                    (-0.1, 0, 0.1)
                )
            case Kind.STRING:
                return "text" if near is None else str(near)
            case Kind.BYTES:
                return b"\x00"
            case Kind.ENUM:
                found = self.classes[kind.name]
                assert issubclass(found, Enum)
                return found[chance.choice(self.enums[kind.name].constants)[0]]
            case Kind.MESSAGE:
                return self.content(kind.name)
            case Kind.OUTCOME | Kind.AGENT:
                return None
            case Kind.LIST:
                assert kind.element is not None
                return tuple(self.value(kind.element) for _ in range(chance.randrange(3)))
            case _:
                assert_never(kind.kind)


def _inside(variable: Variable, value: object) -> object:
    """The nearest value that a variable can hold."""
    bounds = variable.bounds
    if isinstance(value, tuple):
        return value[: variable.length]
    if bounds is None or not isinstance(value, int | float):
        return value
    return min(max(value, bounds.least), bounds.most)


__all__ = ["STARTS", "drawn", "drawn_anew"]
