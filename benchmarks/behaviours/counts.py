"""What a behaviour has to do, by the reference interpreter: entries and exits of each state, and the end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from aseme_dsl.project.studying import course as recorded
from aseme_dsl.runtime.chart.inputs import Completed, Happened, Input, Sample, Written
from aseme_dsl.runtime.chart.plan import Plan
from benchmarks.behaviours.aseme import camel, channel, labels, names, text_of
from benchmarks.behaviours.description import Behaviour, Change
from tests.oracle.interpreter import Reference
from tests.support.generated import generate


@dataclass(frozen=True, slots=True)
class Course:
    """What came of some steps."""

    entries: dict[str, int]
    exits: dict[str, int]
    counters: dict[str, int]
    flags: dict[str, bool]
    leaves: tuple[tuple[str, ...], ...]
    """The active basic states after the start and after each step, in document order."""


class Counting(Reference):
    """The reference interpreter, with a count of what is entered and left."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.entries_of: dict[str, int] = {}
        self.exits_of: dict[str, int] = {}

    def enter(self, label: str, *further: Any, **named: Any) -> None:
        self.entries_of[label] = self.entries_of.get(label, 0) + 1
        super().enter(label, *further, **named)

    def leave(self, label: str) -> None:
        self.exits_of[label] = self.exits_of.get(label, 0) + 1
        super().leave(label)


def counts_of(
    plan: Plan, course: recorded.Course, messages: Mapping[str, Any]
) -> tuple[dict[str, int], dict[str, int], list[tuple[str, ...]]]:
    """The entries and exits of each label, and the configuration after each step of a recorded course."""
    reference = Counting(plan, course.agent, messages)
    trail = []
    for given in course.steps:
        reference.step(given.now, list(given.inputs))
        trail.append(reference.configuration())
    return reference.entries_of, reference.exits_of, trail


def course_of(behaviour: Behaviour, steps: int) -> Course:
    """Interpret the text of the behaviour for so many steps."""
    made = generate(text_of(behaviour))
    reference = Counting(made.plan(behaviour.name), "agent", {})
    called = names(behaviour)
    label = labels(behaviour)
    ends = dict(behaviour.ends)
    basic = {state.name for state in behaviour.states if state.kind == "basic"}

    def active() -> tuple[str, ...]:
        return tuple(called[here] for here in reference.configuration() if called.get(here) in basic)

    def written(change: Change, now: int) -> Iterator[Input]:
        for name, value in change:
            message, dot, member = name.partition(".")
            if dot:
                arrived = made.message(camel(message), **{member: value})
                yield Sample(channel(message), arrived, "camera", now, ("camera", now))
            else:
                yield Written(name, value)

    def given(event: str) -> Input:
        if event not in ends:
            return Happened(event)
        state = label[ends[event]]
        return Completed(state, reference.token.get(state, 0))

    reference.step(0, [])
    leaves = [active()]
    for number in range(steps):
        event, change = behaviour.steps[number % len(behaviour.steps)]
        reference.step(number + 1, [*written(change, number + 1), given(event)])
        leaves.append(active())
    below = [state.name for state in behaviour.states[1:]]
    return Course(
        {name: reference.entries_of.get(label[name], 0) for name in below},
        {name: reference.exits_of.get(label[name], 0) for name in below},
        {counter: reference.variable(counter) for counter in behaviour.counters},
        {flag: reference.variable(flag) for flag in behaviour.flags},
        tuple(leaves),
    )
