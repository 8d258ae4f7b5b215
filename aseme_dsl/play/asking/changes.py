"""Changes: what could be otherwise at a moment, tried out on the step class of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from enum import Enum
from functools import partial
from random import Random
from typing import assert_never, cast

from aseme_dsl.play.asking.parts import Fact, Part
from aseme_dsl.play.asking.reading import MADE_UP, Reading, is_unknown, readings
from aseme_dsl.play.replay import Model
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.following import Following, Shape
from aseme_dsl.runtime.chart.functions import TYPES
from aseme_dsl.runtime.chart.inputs import (
    LOST,
    AgentMessage,
    Completed,
    Crashed,
    Effect,
    Happened,
    Identity,
    Input,
    Sample,
)
from aseme_dsl.runtime.chart.saving import Saved
from aseme_dsl.runtime.chart.stepping import RECEIVE
from aseme_dsl.runtime.message.as_json import from_json
from aseme_dsl.runtime.trace.records import Record

OUTSIDE: Identity = ("?", MADE_UP)
"""Who sends what a trial makes up."""
STEPS = 100
"""A trial makes so many steps at one instant at the most."""

# ---- what could be otherwise ------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Holding:
    """The fact of a part of a condition is true, or not. What is `absent` in it comes: channel and sender."""

    part: Part
    is_true: bool
    absent: tuple[tuple[str, str | None], ...] = ()


@dataclass(frozen=True, slots=True)
class Ending:
    """The activity of a state ends, with an outcome if it has several."""

    label: str
    outcome: str | None = None


@dataclass(frozen=True, slots=True)
class Failing:
    """The activity of a state fails."""

    label: str


@dataclass(frozen=True, slots=True)
class Waiting:
    """So much time (ns) has passed since a state was entered, or (negative) it has not passed yet."""

    label: str
    duration: int


@dataclass(frozen=True, slots=True)
class Raising:
    """An event is raised."""

    event: str


@dataclass(frozen=True, slots=True)
class Coming:
    """An agent message comes for a branch; that an agent is `lost` is one, too.

    It is one that was sent and is still `waiting`, if there is one.
    """

    branch: str
    performative: str
    message: str
    participant: str
    waiting: AgentMessage | None = None


@dataclass(frozen=True, slots=True)
class Lacking:
    """An input of the step has not come, or an agent message does not wait, by its identity."""

    input: Input


@dataclass(frozen=True, slots=True)
class Drawing:
    """This weighted branch is drawn, after so many that are not."""

    transition: int
    passed: int


Change = Holding | Ending | Failing | Waiting | Raising | Coming | Lacking | Drawing


# ---- trials -----------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Moment:
    """An agent between two steps: its state, the time (ns), and what its next step takes.

    `answers` are what functions of the document gave in this step, in order, as JSON has it.
    """

    saved: Saved
    now: int
    inputs: tuple[Input, ...] = ()
    answers: tuple[tuple[str, object], ...] = ()


@dataclass(frozen=True, slots=True)
class Made:
    """A step that the agent has made, from this moment, and the transitions that it took."""

    moment: Moment
    taken: tuple[tuple[int, ...], ...]


@dataclass(slots=True)
class Tried:
    """What came of a trial.

    `told` has what the probes have told: by their numbers, and how many transitions had been taken then.
    """

    after: Saved
    now: int
    taken: list[tuple[int, ...]] = field(default_factory=list)
    effects: list[Effect] = field(default_factory=list)
    entered: set[str] = field(default_factory=set)
    told: dict[int, dict[int, bool]] = field(default_factory=dict)
    failure: str | None = None

    def holds(self, part: Part, place: int | None = None) -> bool | None:
        """What a part came to last, or behind so many transitions; None if it was not asked."""
        found = self.told.get(part.number)
        if found is None:
            return None
        return found[max(found)] if place is None else found.get(place)


class Trial:
    """Makes the next steps of an agent with something changed. Nothing of the project's code runs."""

    def __init__(
        self,
        model: Model,
        parts: Sequence[Part],
        agent: str,
        seed: int,
        given: Mapping[str, object],
    ) -> None:
        """`model` has probes of these parts; `given` is what functions of the document gave last, by name."""
        self._messages = model.messages
        self._forced: dict[Fact, bool] = {}
        self._told: dict[int, dict[int, bool]] = {}
        self._taken = 0
        self._makes_up = False
        """Whether a trial has made up a message."""
        self._noted: int | None = None
        self._notes: list[tuple[int, bool, tuple[Reading, ...]]] = []
        """What the noted part has read: behind so many transitions, and whether it held by itself."""
        self._given = given
        self._last = dict(given)
        """What functions have given last in the trial in hand."""
        self._answers: list[tuple[str, object]] = []

        def probe(chart: Chart, number: int, holds: bool) -> bool:
            if number == self._noted:
                read = readings(parts[number], chart, chart.now, self._last)
                self._notes.append((self._taken + len(chart.taken), holds, read))
            if self._makes_up and is_unknown(parts[number], chart):
                holds = False
            if self._forced and (wanted := self._forced.get(parts[number].fact)) is not None:
                holds = wanted is not parts[number].negated
            self._told.setdefault(number, {})[self._taken + len(chart.taken)] = holds
            return holds

        members: dict[str, object] = {"__slots__": (), "probe": probe}
        kind = cast("type[Chart]", type(model.kind.__name__, (model.kind,), members))
        self.plan = kind.PLAN
        self.shape = Shape(self.plan)
        self.chart = kind(agent)
        self.chart.seed = seed
        self.chart.stand_in(
            {name: partial(self._answer, name, result) for name, _, result, _ in self.plan.functions}
        )

    def _answer(self, function: str, result: str, *arguments: object) -> object:
        """What a function gives: the same as in the step, or as last, or nothing in particular."""
        value = self._given.get(function)
        for item in self._answers:
            if item[0] == function:
                self._answers.remove(item)
                value = self._last[function] = item[1]
                break
        kind = TYPES[result][-1] if result in TYPES else self._messages.get(result)
        if kind is None:
            return value
        if value is not None:
            return from_json(kind, value)
        return next(iter(kind)) if issubclass(kind, Enum) else kind()

    def look(self, moment: Moment) -> Chart:
        """The chart as it is at a moment, with what its step takes, to be looked at."""
        self.chart.load(moment.saved)
        self.chart.now = moment.now
        for item in moment.inputs:
            RECEIVE[type(item)](self.chart, item)
        self.chart.events.clear()
        return self.chart

    def decided(
        self, part: Part, moment: Moment, changes: Sequence[Change], holds: bool, place: int | None = None
    ) -> tuple[Reading, ...]:
        """What a part read when it was decided: behind so many transitions; if that is not given, when it
        last came to the value that decided. As it is at the moment, where the step does not look at it."""
        self._noted = part.number
        self._notes.clear()
        try:
            self.run(moment, changes)
        finally:
            self._noted = None
        notes = [item for item in self._notes if place is None or item[0] == place]
        found = [item for item in notes if item[1] is (holds is not part.negated)] or notes
        if found:
            return found[-1][2]
        return readings(part, self.look(moment), moment.now, self._last)

    def run(self, moment: Moment, changes: Sequence[Change] = ()) -> Tried:
        """The steps of this instant, if something of the moment was otherwise."""
        chart = self.chart
        chart.load(moment.saved)
        self._told.clear()
        self._taken = 0
        self._forced.clear()
        self._answers = list(moment.answers)
        self._last = dict(self._given)
        inputs = self._prepared(moment, changes)
        following = Following(self.shape)
        if chart.started:
            following.stand(chart.configuration())
        before = frozenset(following.active)
        tried = Tried(moment.saved, moment.now)
        for _ in range(STEPS):
            begins = not chart.started
            outcome = chart.step(moment.now, inputs)
            if begins:
                tried.entered.update(following.begin().entered)
            for way in outcome.taken:
                tried.entered.update(following.take(way).entered)
            tried.taken += outcome.taken
            tried.effects += outcome.effects
            self._taken = len(tried.taken)
            inputs = []
            if not outcome.again or outcome.finished or outcome.failure is not None:
                break
        following.stand(() if chart.finished or chart.failure is not None else chart.configuration())
        tried.entered |= following.active - before  # also what was resumed
        tried.failure = outcome.failure
        tried.told = {number: dict(found) for number, found in self._told.items()}
        tried.after = chart.save()
        return tried

    # ---- what is changed -----------------------------------------------------------------------

    def _prepared(self, moment: Moment, changes: Sequence[Change]) -> list[Input]:
        """Change the chart, and what its next step takes."""
        chart = self.chart
        inputs = list(moment.inputs)
        numbers: list[float] = []
        for change in changes:
            match change:
                case Holding(part=part, is_true=is_true, absent=absent):
                    self._forced[part.fact] = is_true
                    self._makes_up |= bool(absent)
                    inputs += (self._sample(moment, *place) for place in absent)
                case Ending(label=label, outcome=outcome):
                    inputs.append(Completed(label, self._token(label), outcome))
                case Failing(label=label):
                    inputs.append(Crashed(label, self._token(label), "as is asked"))
                case Waiting(label=label, duration=duration):
                    setattr(chart, chart.TIMES[label], moment.now - duration)
                case Raising(event=event):
                    inputs.append(Happened(event))
                case Coming(waiting=waiting):
                    self._makes_up |= waiting is None
                    inputs.append(waiting or self._message(change, moment.now))
                case Lacking(input=AgentMessage(branch=branch, identity=identity)):
                    chart.mail[branch] = tuple(
                        [item for item in chart.mail[branch] if item.identity != identity]
                    )
                    inputs = [item for item in inputs if item is not change.input]
                case Lacking(input=gone):
                    inputs = [item for item in inputs if item is not gone]
                case Drawing(passed=passed):
                    numbers += [*[_LAST] * passed, 0.0]
                case _:
                    assert_never(change)
        if numbers:
            chart.chance = _Numbers(numbers)
        return inputs

    def _token(self, label: str) -> int:
        return int(getattr(self.chart, self.chart.RUNNING[label][1]))

    def _sample(self, moment: Moment, channel: str, host: str | None) -> Sample:
        """A message of a channel that says nothing in particular."""
        content = self._messages[channel.rpartition(".")[2]]()
        sender = OUTSIDE[0] if host is None else host
        return Sample(channel, content, sender, moment.now, (sender, MADE_UP))

    def waiting(self, coming: Coming, record: Record) -> AgentMessage:
        """The agent message of a line that tells of its sending."""
        content = from_json(self._messages[coming.message], record["content"])
        identity = record["agent"], record["sequence"]
        return AgentMessage(
            coming.branch,
            coming.performative,
            coming.message,
            content,
            coming.participant,
            record["agent"],
            identity,
            in_reply_to=record.get("in_reply_to", ""),
            sent=record["time"],
        )

    def _message(self, coming: Coming, now: int) -> AgentMessage:
        lost = coming.performative == LOST
        content = "left" if lost else self._messages[coming.message]()
        return AgentMessage(
            coming.branch,
            coming.performative,
            coming.message,
            content,
            coming.participant,
            OUTSIDE[0],
            OUTSIDE,
            sent=now,
        )


_LAST = 1 - 2**-53
"""The largest number that can be drawn."""


class _Numbers(Random):
    """Draws these numbers first."""

    def __init__(self, numbers: Sequence[float]) -> None:
        super().__init__(0)
        self._numbers = iter(numbers)

    def random(self) -> float:
        return next(self._numbers, super().random())


__all__ = [
    "Change",
    "Coming",
    "Drawing",
    "Ending",
    "Failing",
    "Holding",
    "Lacking",
    "Made",
    "Moment",
    "Raising",
    "Trial",
    "Tried",
    "Waiting",
]
