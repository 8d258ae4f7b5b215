"""Random inputs, and two engines that are given the same ones and must do the same."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from itertools import cycle
from typing import Any

from aseme_dsl.runtime.chart.board import Known, whole
from aseme_dsl.runtime.chart.inputs import (
    LOST,
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Effect,
    Fault,
    Happened,
    Identity,
    Input,
    Outcome,
    Publication,
    Sample,
    Start,
    Written,
)
from aseme_dsl.runtime.chart.saving import Saved
from tests.oracle.charts import EVENTS, HOSTS, MS
from tests.oracle.choices import Choices
from tests.oracle.interpreter import Reference
from tests.support.generated import Generated

Operation = tuple[Any, ...]


@dataclass(frozen=True)
class Moment:
    """A step: after a wait in ns (or when the chart is due), with what, and what comes while it is made."""

    wait: int | None
    operations: tuple[Operation, ...]
    late: tuple[Operation, ...] = ()


def moments(choices: Choices) -> list[Moment]:
    """A sequence of steps. What an operation means depends on the chart: `("done", 1)` is one that runs."""
    found = [Moment(0, ())]
    for _ in range(choices.number(1, 20)):
        wait = choices.one_of((0, None, MS, 5 * MS, 10 * MS, 20 * MS, 1))
        operations = tuple(_operation(choices) for _ in range(choices.number(0, 4)))
        late = tuple(_arrival(choices) for _ in range(choices.number(1, 2))) if choices.one_in(6) else ()
        found.append(Moment(wait, operations, late))
    return found


def _operation(choices: Choices) -> Operation:
    match choices.weighted(done=12, arrival=12, event=6, back=5, mail=6, write=2, stale=2, crash=1):
        case "done":
            return ("done", choices.number(0, 3))
        case "arrival":
            return _arrival(choices)
        case "event":
            return ("event", choices.number(0, 2))
        case "back":
            return ("back",)
        case "mail":
            members = tuple(choices.number(0, 3) for _ in range(6))
            return ("mail", choices.number(0, 3), choices.number(0, 2), choices.one_of(HOSTS), members)
        case "write":
            return ("write", choices.number(0, 9), choices.number(0, 3))
        case "stale":
            return ("stale", choices.number(0, 9))
    return ("crash", choices.number(0, 3))


def _arrival(choices: Choices) -> Operation:
    age = choices.one_of((0, 0, MS, 5 * MS, 10 * MS, 30 * MS))
    members = tuple(choices.number(0, 3) for _ in range(6))
    return ("arrival", choices.number(0, 9), choices.one_of(HOSTS), age, members)


def filled(kind: Any, numbers: Iterator[int]) -> Any:
    """A message whose members are made of small numbers."""
    message = kind()
    members = {item.name: _member(item.type, getattr(message, item.name), numbers) for item in fields(kind)}
    return kind(**members)


def _member(annotation: Any, default: Any, numbers: Iterator[int]) -> Any:
    if is_dataclass(default):
        return filled(type(default), numbers)
    number = next(numbers)
    if default is None:
        return number if number and str(annotation).startswith("int") else None
    return like(default, number)


def _mail(event: Any) -> tuple[str, str, str] | None:
    """What mail an event waits for, if any: performative, message and participant."""
    match event:
        case ("received", performative, message, participant):
            return performative, message, participant
        case ("lost", participant):
            return LOST, "", participant
    return None


def like(example: Any, number: int) -> Any:
    """A value of the same type."""
    match example:
        case None:
            return ("ann", "bob", "me", "eve")[number]  # an agent
        case bool():
            return number > 1
        case Enum():
            constants = list(type(example))
            return constants[number % len(constants)]
        case int():
            return number
        case float():
            return number / 2
        case str():
            return ("", "a", "b", "c")[number]
    return example


@dataclass
class MadeStep:
    """A step that was made, and from where."""

    now: int
    inputs: list[Input]
    late: list[Any]
    before: Saved
    contents: object
    outcome: object = None


def plain(saved: Saved) -> object:
    """What was saved, read anew: nothing that was found out before is asked."""
    boards = [None if board is None else whole(board) for board in saved.boards]
    contents = [
        held and (Known(held[0].states, held[0].data, held[0].signals).messages(), held[1:])
        for held in boards
    ]
    return saved.values, contents, saved.seldom


@dataclass
class Game:
    """The interpreter and the generated class of a role, side by side."""

    made: Generated
    text: str
    role: str = "R"
    now: int = 0
    running: dict[str, int] = field(default_factory=dict)
    old: list[tuple[str, int]] = field(default_factory=list)
    """Activities that have ended or were cancelled, with their tokens."""
    published: list[Publication] = field(default_factory=list)
    late: list[Sample] = field(default_factory=list)
    numbers: dict[str, int] = field(default_factory=dict)
    story: list[str] = field(default_factory=list)
    taken: int = 0
    goes_back: bool = False
    """Whether each step is made twice, the second time from what was saved before the first; and in the end
    the second half once more."""
    made_before: list[MadeStep] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.plan = self.made.plan(self.role)
        self.expected = Reference(self.plan, "me", vars(self.made.messages))
        self.actual = self.made.chart(self.role, "me")

    def play(self, sequence: list[Moment]) -> None:
        """Give both the same inputs, and compare them after each step."""
        for moment in sequence:
            self.step(moment)
            if self.expected.finished or self.expected.failure is not None:
                break
        self.go_far_back()

    def step(self, moment: Moment) -> None:
        due = self.expected.due(self.now)
        self.now += moment.wait if moment.wait is not None else 0 if due is None else due - self.now
        inputs: list[Input] = list(self.late)
        for operation in moment.operations:
            inputs += self.inputs(operation)
        late: list[Any] = [item for operation in moment.late for item in self.inputs(operation)]
        self.late = late
        self.expected.pending = lambda: late
        self.actual.pending = lambda: late
        self.story.append(f"at {self.now / MS} ms: {inputs}" + (f", during it {late}" if late else ""))

        if self.goes_back:
            self.go_back(inputs)
        expected = self.expected.step(self.now, inputs)
        actual = self.actual.step(self.now, inputs)
        self.compare("the step", shown(expected), shown(actual))
        if self.goes_back:
            self.made_before[-1].outcome = shown(actual)
        self.compare("the configuration", self.expected.configuration(), self.actual.configuration())
        self.compare("due", self.expected.due(self.now), self.actual.due(self.now))
        for variable in self.plan.variables:
            name = variable.name
            self.compare(f"the variable {name}", self.expected.variable(name), self.actual.variable(name))
        self.follow(expected)

    def go_back(self, inputs: list[Input]) -> None:
        """Both make the step, and are put back to before it: one in its place, a new one to where that was.

        That the step can then be made as if nothing had been, is compared as always.
        """
        self.expected.load(self._stepped(self.expected, inputs))
        before = self._stepped(self.actual, inputs)
        if len(self.story) % 2:
            self.actual = self.made.chart(self.role, "me")
            self.actual.pending = lambda: self.late
        self.actual.load(before)
        self.compare("what is saved anew", before, self.actual.save())
        self.made_before.append(MadeStep(self.now, inputs, self.late, before, plain(before)))

    def go_far_back(self) -> None:
        """A new chart does the second half once more: from what was saved, which has stayed as it was."""
        again = self.made_before[len(self.made_before) // 2 :]
        self.made_before = []
        chart = self.made.chart(self.role, "me")
        for number, step in enumerate(again):
            self.compare("what was saved", step.contents, plain(step.before))
            if number == 0:
                chart.load(step.before)
            self.compare("what is saved later", step.before, chart.save())
            chart.pending = lambda late=step.late: late
            self.compare("the step made later", step.outcome, shown(chart.step(step.now, step.inputs)))

    def _stepped(self, engine: Any, inputs: list[Input]) -> Any:
        """What an engine saves before a step that it makes."""
        before = engine.save()
        hash(before)  # nothing in it can change
        engine.step(self.now, inputs)
        return before

    def compare(self, what: str, expected: Any, actual: Any) -> None:
        if expected != actual:
            raise AssertionError(
                "\n".join(
                    [
                        f"{what} differs",
                        f"interpreter: {expected}",
                        f"generated:   {actual}",
                        "",
                        *self.story,
                        "",
                        self.text,
                    ]
                )
            )

    def follow(self, outcome: Outcome) -> None:
        """Remember what runs now and what was published."""
        self.taken += len(outcome.taken)
        for effect in outcome.effects:
            match effect:
                case Start(label=label, token=token):
                    self.running[label] = token
                case Cancel(label=label, token=token):
                    self.running.pop(label, None)
                    self.old.append((label, token))
                case Publication(host=host) if host in (None, "me"):
                    self.published.append(effect)

    def inputs(self, operation: Operation) -> list[Input]:
        """What an operation is for this chart: nothing, where it has nothing to be about."""
        match operation:
            case ("done" | "crash" as kind, number):
                if not self.running:
                    return []
                label = list(self.running)[number % len(self.running)]
                token = self.running.pop(label)
                self.old.append((label, token))
                return [Completed(label, token) if kind == "done" else Crashed(label, token, "no battery")]
            case ("stale", number):
                if not self.old:
                    return []
                label, token = self.old[number % len(self.old)]
                return [Completed(label, token) if number < 5 else Crashed(label, token, "too late")]
            case ("event", number):
                ways = self.plan.transitions
                names = sorted({e[1] for way in ways for e in way.events if e[0] == "raised"}) or EVENTS
                return [Happened(names[number % len(names)])]
            case ("write", number, value):
                if not self.plan.variables:
                    return []
                variable = self.plan.variables[number % len(self.plan.variables)]
                before = self.expected.variable(variable.name)
                if before is None and variable.type != "agent":
                    return []  # a message that nothing has set
                return [Written(variable.name, like(before, value))]
            case ("mail", kind, number, sender, members):
                if not self.plan.branches:
                    return []
                branch = self.plan.branches[number % len(self.plan.branches)].label
                awaited = [_mail(e) for way in self.plan.transitions for e in way.events]
                kinds = list(dict.fromkeys(item for item in awaited if item is not None))
                if not kinds:
                    return []
                performative, message, participant = kinds[kind % len(kinds)]
                content = filled(getattr(self.made.messages, message), cycle(members)) if message else None
                identity = self.identity(sender)
                sent = None if number == 0 else self.now - 5_000_000 * kind
                return [
                    AgentMessage(
                        branch, performative, message, content, participant, sender, identity, sent=sent
                    )
                ]
            case ("back",):
                # a message of its own for both engines: each has published another object
                back = [
                    self.arrived(p.channel, replace(p.message), "me", 0, p.region) for p in self.published
                ]
                self.published.clear()
                return list(back)
            case ("arrival", number, sender, age, members):
                if not self.plan.channels:
                    return []
                info = self.plan.channels[number % len(self.plan.channels)]
                message = filled(getattr(self.made.messages, info.message), cycle(members))
                return [self.arrived(info.name, message, sender, age, None)]
        raise ValueError(operation)

    def arrived(self, channel: str, message: Any, sender: str, age: int, region: str | None) -> Sample:
        return Sample(channel, message, sender, self.now - age, self.identity(sender), region)

    def identity(self, sender: str) -> Identity:
        self.numbers[sender] = self.numbers.get(sender, 0) + 1
        return sender, self.numbers[sender]


def shown(outcome: Outcome) -> tuple[Any, ...]:
    """What must agree: all but the words of faults and failures."""
    effects = [_shown(effect) for effect in outcome.effects]
    return outcome.taken, effects, outcome.finished, outcome.again, outcome.failure is not None


def _shown(effect: Effect) -> Any:
    return ("Fault", effect.transition) if isinstance(effect, Fault) else effect
