"""Courses: what an agent is given step by step, and where that leads it; for charts and for plain ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from importlib import import_module
from random import Random
from typing import NamedTuple, Protocol

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Completed,
    Crashed,
    Happened,
    Input,
    Outcome,
    Sample,
    Written,
)
from aseme_dsl.runtime.message.convert import converted, like
from aseme_dsl.runtime.plain.plain import Plain

Where = tuple[str, ...]
"""A configuration: the labels of the active leaves."""


@dataclass(frozen=True, slots=True)
class Given:
    """What there is for one step at `now` (ns)."""

    now: int
    inputs: tuple[Input, ...] = ()
    ahead: tuple[Sample, ...] = ()
    """What has arrived during the step, for `read_messages`."""
    gone: tuple[tuple[str, Sample | AgentMessage], ...] = ()
    """What the activities of states (by their labels) have taken away before the step."""


@dataclass(frozen=True, slots=True)
class Course:
    """The steps of one agent, the first of which enters the root, and where it was after each."""

    agent: str
    steps: tuple[Given, ...]
    trail: tuple[Where, ...]
    visited: frozenset[str]
    """The labels of all states that were active."""
    taken: frozenset[int]
    """The numbers of all transitions that were taken."""
    seed: int = 1
    queue: int = QUEUE
    until: str = ""
    """Why it is not longer than it is, where that is worth a word."""

    @property
    def inputs(self) -> int:
        """How many inputs there are in all."""
        return sum(len(given.inputs) for given in self.steps)


@dataclass(slots=True)
class Recorder:
    """A running chart that is given steps, and the course that comes of them."""

    chart: Chart
    agent: str
    seed: int = 1
    queue: int = QUEUE
    steps: list[Given] = field(default_factory=list)
    trail: list[Where] = field(default_factory=list)
    visited: set[str] = field(default_factory=set)
    taken: set[int] = field(default_factory=set)

    def play(self, given: Given) -> Outcome | None:
        """Make a step; None if the chart fails in it: then it does not belong to the course."""
        outcome = give(self.chart, given)
        if outcome.failure is not None:
            return None
        self.steps.append(given)
        self.trail.append(self.chart.configuration())
        self.visited.update(self.trail[-1])
        self.taken.update(number for numbers in outcome.taken for number in numbers)
        return outcome

    def course(self, until: str = "") -> Course:
        """What has been played so far."""
        steps, trail = tuple(self.steps), tuple(self.trail)
        visited, taken = frozenset(self.visited), frozenset(self.taken)
        return Course(self.agent, steps, trail, visited, taken, self.seed, self.queue, until)


# ---- the agent's face --------------------------------------------------------------------------


def begun(kind: type[Chart], agent: str, seed: int = 1, queue: int = QUEUE) -> Chart:
    """A chart as an agent of that name has it before its first step."""
    chart = kind(agent)
    chart.seed = seed
    chart.queue = queue
    chart.settle()
    return chart


def give(chart: Chart, given: Given) -> Outcome:
    """One step of a chart."""
    for label, item in given.gone:
        _take_away(chart, label, item)
    if given.ahead:
        chart.pending = lambda: given.ahead
    outcome = chart.step(given.now, given.inputs)
    if given.ahead:
        chart.pending = tuple
    return outcome


def player(chart: Chart, steps: Sequence[Given]) -> Callable[[], None]:
    """What gives a chart its steps, with as little around them as there can be."""
    if any(given.gone or given.ahead for given in steps):

        def play_all() -> None:
            for given in steps:
                give(chart, given)

        return play_all
    script = [(given.now, given.inputs) for given in steps]

    def play() -> None:
        step = chart.step
        for now, inputs in script:
            step(now, inputs)

    return play


def _take_away(chart: Chart, label: str, item: Sample | AgentMessage) -> None:
    """An activity takes a signal or an agent message."""
    if isinstance(item, AgentMessage):
        chart.give_mail(item)
        return
    board = chart.board_of(label)
    for host in (None, item.sender):
        found = board.newest(item.channel, host)
        if found is not None and found.identity == item.identity:
            board.take(item.channel, host)
            return


# ---- the plain face ----------------------------------------------------------------------------


class Runner(Protocol):
    """What runs a plain chart: itself, or a `Machine`."""

    def start(self) -> object: ...
    def step(self) -> bool: ...
    def done(self, label: str, outcome: str | None = None) -> bool: ...
    def failed(self, label: str, reason: str) -> bool: ...


class Doing(NamedTuple):  # unpacked in the loop that is timed: a tuple is the quickest
    """What a step is for a plain chart: what is put where on its blackboard, and what is called then."""

    now: int
    puts: tuple[tuple[str, object], ...]
    calls: tuple[tuple[Callable[..., object], tuple[str | None, ...]], ...]


def plain_begun(kind: type[Plain], course: Course, like_this: Chart) -> Plain:
    """A plain chart with the variables of a chart before its first step, and the same random numbers."""
    chart = kind()
    board = board_of(chart)
    messages = messages_of(kind)
    for name in type(like_this).VARIABLES:
        slot = kind.VARIABLES.get(name, name)
        setattr(board, slot, like(like_this.variable(name), getattr(board, slot), messages))
    if hasattr(chart, "chance"):
        setattr(chart, "chance", Random(f"{course.seed}/{course.agent}"))  # noqa: B010  of some classes only
    return chart


def doings(chart: Plain, runner: Runner, course: Course, reference: Chart, send: str = "send") -> list[Doing]:
    """What the steps of a course are for a plain chart that `runner` (itself, or a `Machine`) runs.

    The plain chart takes one event or end of an activity a step: several are several steps. `reference` is a
    chart that stands where the course begins; it is led along, for what comes too late to count.
    """
    board, messages = board_of(chart), messages_of(type(chart))
    found: list[Doing] = []
    for given in course.steps:
        puts: list[tuple[str, object]] = []
        calls: list[tuple[Callable[..., object], tuple[str | None, ...]]] = []
        for item in given.inputs:
            match item:
                case Sample(channel, message, sender):
                    news = converted(message, messages)
                    places = [s for s, c, host in chart.MESSAGES if c == channel and host in (None, sender)]
                    puts += [(slot, news) for slot in places]
                case Written(variable, value):
                    place = chart.VARIABLES.get(variable, variable)
                    puts.append((place, like(value, getattr(board, place), messages)))
                case Happened(name):
                    calls.append((getattr(runner, send), (name,)))
                case Completed(label, token, outcome) if runs(reference, label, token):
                    calls.append((runner.done, (label, outcome)))
                case Crashed(label, token, reason) if runs(reference, label, token):
                    calls.append((runner.failed, (label, reason)))
        if not found:
            calls = [(runner.start, ()), *calls]
        give(reference, given)
        found.append(Doing(given.now, tuple(puts), tuple(calls or [(runner.step, ())])))
    return found


def runs(chart: Chart, label: str, token: int) -> bool:
    """Whether the activity that was started with this token still runs."""
    leaf, owner, number = chart.RUNNING[label]
    return bool(getattr(chart, leaf) == number and getattr(chart, owner) == token)


def plain_player(chart: Plain, doing: Sequence[Doing]) -> Callable[[], None]:
    """What gives a plain chart its steps, with as little around them as there can be."""
    board = board_of(chart)
    changed = getattr(board, "changed", _nothing)
    timed = hasattr(chart, "now")

    def play() -> None:
        for now, puts, calls in doing:
            if timed:
                chart.now = now  # type: ignore[attr-defined]
            if puts:
                for slot, value in puts:
                    setattr(board, slot, value)
                changed()
            for call, arguments in calls:
                call(*arguments)

    return play


def _nothing() -> None:
    """Ignores that something has changed."""


def board_of(chart: Plain) -> object:
    """The blackboard of a plain chart; of each class another."""
    return getattr(chart, "bb")  # noqa: B009


def messages_of(kind: type[Plain]) -> Mapping[str, type[object]]:
    """The message classes and enums of a plain chart's package."""
    return vars(import_module(f"{kind.__module__.rpartition('.')[0]}.messages"))


__all__ = [
    "Course",
    "Doing",
    "Given",
    "Recorder",
    "begun",
    "board_of",
    "doings",
    "give",
    "messages_of",
    "plain_begun",
    "plain_player",
    "player",
    "runs",
]
