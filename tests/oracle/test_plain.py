"""The plain face and the interpreter agree on every step of random charts with random inputs.

The examples are the same in every run. `ORACLE_EXAMPLES=5000 pytest tests/oracle/test_plain.py` looks at more
of them, `ORACLE_FIRST=1000000` at others.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import cycle
from random import Random
from typing import Any

import pytest

from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.codegen.program import sizes
from aseme_dsl.runtime.chart.inputs import (
    Cancel,
    Completed,
    Crashed,
    Fault,
    Happened,
    Input,
    Outcome,
    Sample,
    Start,
    Written,
)
from aseme_dsl.runtime.plain import plain
from tests.oracle import interpreter
from tests.oracle.charts import EVENTS, HOSTS, MS, text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, agree, forget, how_many
from tests.oracle.interpreter import Reference
from tests.oracle.plain import without_limits
from tests.oracle.playing import filled, like
from tests.support.generated import Generated, imported, system_of
from tests.support.plain_engine import CannotDo, PlainEngine, plain_class

EXAMPLES = how_many(80)
LARGE = {
    "SHARED": 0,
    "TABLE": 3,
    "CHUNK": 2,
    "IN_LINE": 0,
    "BRANCHES": 1,
    "GUARDS": 2,
    "NESTED": 1,
    "DEEP": 4,
}
"""From where on a chart is written as large ones are."""

GAMES = 3
GROUPS = 4


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plain, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)


@pytest.fixture
def large(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take the small charts of here for large ones."""
    for name, value in LARGE.items():
        monkeypatch.setattr(sizes, name, value)


@dataclass
class Game:
    """The interpreter, a watched class and bare ones of the same chart, side by side."""

    made: Generated
    text: str
    now: int = 0
    running: dict[str, int] = field(default_factory=dict)
    numbers: int = 0
    is_over: bool = False
    story: list[str] = field(default_factory=list)
    first: tuple[str, ...] = ()
    """The configuration after the first of the steps of an instant."""

    def __post_init__(self) -> None:
        self.plan = self.made.plan("R")
        self.expected = Reference(self.plan, "me", vars(self.made.messages))
        self.actual = PlainEngine(self.made, "R")
        self.mapped = plain_class(self.made, "R", PlainOptions(mapping=True))()
        self.run_by(plain_class(self.made, "R", PlainOptions()))

    def run_by(self, kind: Any) -> None:
        """Let this be the bare class."""
        self.bare = kind()
        self.others = [self.bare, self.mapped]
        board = type(self.bare.bb)
        if hasattr(board, "tracked"):
            self.others.append(kind(board(tracked=True)))
        for chart in self.others:
            if hasattr(chart, "chance"):
                chart.chance = Random("1/me")

    def play(self, choices: Choices) -> None:
        self.step([], None)
        for _ in range(choices.number(1, 25)):
            if self.is_over or self.expected.finished or self.expected.failure is not None:
                break
            self.now += choices.one_of((0, MS, 5 * MS, 10 * MS, 20 * MS))
            board = [self.on_board(choices) for _ in range(choices.weighted(none=3, one=2, two=1) != "none")]
            self.step([item for item in board if item is not None], self.call(choices))

    def on_board(self, choices: Choices) -> Input | None:
        if choices.one_in(2) and self.plan.variables:
            variable = choices.one_of(self.plan.variables)
            before, number = self.expected.variable(variable.name), choices.number(0, 3)
            if before is None and variable.type != "agent":
                return None  # a message that nothing has set
            return Written(variable.name, like(before, number))
        channels = [info for info in self.plan.channels if info.name.startswith("t.state")]
        if not channels:
            return None
        info = choices.one_of(channels)
        members = tuple(choices.number(0, 3) for _ in range(6))
        message = filled(getattr(self.made.messages, info.message), cycle(members))
        sender = choices.one_of(HOSTS)
        self.numbers += 1
        return Sample(info.name, message, sender, self.now, (sender, self.numbers))

    def call(self, choices: Choices) -> Input | None:
        kind = choices.weighted(event=6, done=6, nothing=2)
        if kind == "event":
            names = sorted({e[1] for way in self.plan.transitions for e in way.events if e[0] == "raised"})
            return Happened(choices.one_of(names or EVENTS))
        if kind == "done" and self.running:
            label = choices.one_of(list(self.running))
            token = self.running.pop(label)
            return Crashed(label, token, "no battery") if choices.one_in(6) else Completed(label, token)
        return None

    def step(self, board: list[Input], call: Input | None) -> None:
        inputs = [*board, *([] if call is None else [call])]
        self.story.append(f"at {self.now / MS} ms: {inputs}")
        expected = self.settled(inputs)
        if isinstance(call, Completed | Crashed):  # what starts in one round may start in another order
            inputs[-1] = replace(call, token=self.actual.token.get(call.label, 0))
        try:
            actual = self.actual.step(self.now, inputs)
        except CannotDo:
            self.compare("the failure", expected.failure is not None, True)
            return
        if self.actual.is_outside:  # the program is told at once, whatever would follow
            self.compare("a fault", any(isinstance(item, Fault) for item in expected.effects), True)
            self.is_over = True
            return
        self.compare("the step", _seen(expected, self.plan), _seen(actual, self.plan))
        if expected.failure is not None:
            return
        self.follow(expected)
        self.compare("the configuration", self.expected.configuration(), self.actual.configuration())
        for chart in self.others:
            self.drive(chart, board, call)
            self.compare("the bare configuration", self.expected.configuration(), chart.configuration())
        for variable in self.plan.variables:
            name = variable.name
            value = self.expected.variable(name)
            self.compare(f"the variable {name}", value, self.actual.variable(name))
            for chart in self.others:
                if chart is not self.mapped:
                    self.compare(f"the bare variable {name}", value, getattr(chart.bb, name))
            self.compare(f"the variable {name} in the mapping", value, self.mapped.bb[name])

    def settled(self, inputs: list[Input]) -> Outcome:
        """What a step and those that follow it at the same instant do: the plain face makes them itself."""
        whole = self.expected.step(self.now, inputs)
        self.first = self.expected.configuration() if whole.failure is None else ()
        steps, again = 0, whole.again
        while again and steps < ROUNDS and whole.failure is None:
            step = self.expected.step(self.now, [])
            whole.taken += step.taken
            whole.effects += step.effects
            whole.finished, whole.failure, again = step.finished, step.failure, step.again
            steps += 1
        if again and whole.failure is None:
            whole.failure = "does not settle"
        return whole

    def drive(self, chart: Any, board: list[Input], call: Input | None) -> None:
        """The same for a class that is not watched."""

        def put(name: str, value: Any) -> None:
            if isinstance(chart.bb, dict):
                chart.bb[name] = value
            else:
                setattr(chart.bb, name, value)

        if hasattr(type(chart), "now"):
            chart.now = self.now
        for item in board:
            if isinstance(item, Written):
                put(item.variable, item.value)
            elif isinstance(item, Sample):
                for (channel, host), slot in self.actual.slots.items():
                    if channel == item.channel and host in (None, item.sender):
                        put(slot, item.message)
        if board and getattr(chart.bb, "tracked", False):
            chart.bb.changed()
        if len(self.story) == 1:
            chart.start()
        elif isinstance(call, Happened):
            chart.send(call.name)
        elif isinstance(call, Completed):
            chart.done(call.label)
        elif isinstance(call, Crashed):
            try:
                chart.failed(call.label, call.reason)
            except plain.ActivityFailed:  # it may have been left and entered again, as `failed` says
                if hasattr(chart, "failures") or call.label not in self.first:
                    raise
        else:
            chart.step()

    def follow(self, outcome: Outcome) -> None:
        for effect in outcome.effects:
            if isinstance(effect, Start) and effect.label not in _waiting(self.plan):
                self.running[effect.label] = effect.token
            elif isinstance(effect, Cancel):
                self.running.pop(effect.label, None)

    def compare(self, what: str, expected: Any, actual: Any) -> None:
        if expected != actual:
            lines = [f"{what} differs", f"interpreter: {expected}", f"plain:       {actual}", ""]
            raise AssertionError("\n".join([*lines, *self.story, "", self.text]))


def _seen(outcome: Outcome, plan: Any) -> Any:
    """What must agree: what each region does is in order; whether they do it in turns is not asked."""
    regions: dict[str, list[Any]] = {}
    for taken in outcome.taken:
        regions.setdefault(_region(plan, plan.transitions[taken[0]].source), []).append(taken)
    effects: dict[str, list[Any]] = {}
    waiting = _waiting(plan)
    for effect in outcome.effects:
        if isinstance(effect, Start | Cancel) and effect.label not in waiting:
            effects.setdefault(_region(plan, effect.label), []).append((type(effect).__name__, effect.label))
    # how many steps follow that take nothing is not asked
    faults = sorted({effect.transition for effect in outcome.effects if isinstance(effect, Fault)})
    if outcome.failure is not None:
        return "failed"
    return regions, effects, faults, outcome.finished


def _waiting(plan: Any) -> set[str]:
    """The states that never complete by themselves: a plain class has nothing to start there."""
    named = {item.name for item in plan.activities if item.waits}
    return {state.label for state in plan.states if state.activity in named}


def _region(plan: Any, label: str) -> str:
    while (
        plan.by_label[label].parent is not None and plan.by_label[plan.by_label[label].parent].type != "AND"
    ):
        label = plan.by_label[label].parent
    return label


def play(choices: Choices) -> Iterator[Game]:
    """A random text, compiled, and some games with it; none if it is about agents.

    Raises:
        AssertionError: it does not compile, or the two engines differ.
    """
    written = text(choices)
    system = without_limits(system_of(written), simple=False)
    if system is None:
        return
    made = imported(system)
    try:
        for _ in range(GAMES):
            game = Game(made, written)
            game.play(choices)
            yield game
    finally:
        forget(made)


@pytest.mark.parametrize("group", range(GROUPS))
def test_the_plain_face_agrees_with_the_interpreter(group: int) -> None:
    assert agree(play, EXAMPLES, group, GROUPS) > 0


@pytest.mark.usefixtures("large")
@pytest.mark.parametrize("group", range(GROUPS))
def test_it_does_as_it_is_written_for_large_charts(group: int) -> None:
    assert agree(play, EXAMPLES // 2, group, GROUPS) > 0
