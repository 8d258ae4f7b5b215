"""What the transitions that random charts take leave and enter is what the interpreter leaves and enters."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pytest

from aseme_dsl.runtime.chart import chart
from aseme_dsl.runtime.chart.following import Change, Following, Shape
from tests.oracle import interpreter
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import FIRST, ROUNDS, forget, how_many
from tests.oracle.interpreter import Reference
from tests.oracle.playing import Game, Moment, moments
from tests.support.generated import generate

USUAL = 50
EXAMPLES = how_many(USUAL)
GROUPS = 2


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)


class Recording(Reference):
    """An interpreter that notes what it leaves and enters."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.notes: list[str] = []

    def enter(self, label: str, *arguments: Any, **named: Any) -> None:
        self.notes.append(f"+{label}")
        super().enter(label, *arguments, **named)

    def be_in(self, label: str, *arguments: Any) -> None:
        if self.notes[-1] != f"+{label}":  # of a part that goes on, `enter` has noted its branch
            self.notes.append(f"+{label}")
        super().be_in(label, *arguments)

    def leave(self, label: str) -> None:
        super().leave(label)
        self.notes.append(f"-{label}")


@dataclass
class Followed(Game):
    """A game in which what the generated chart says it has taken is followed."""

    notes: list[str] = field(default_factory=list)
    resumed: int = 0

    def __post_init__(self) -> None:
        super().__post_init__()
        self.expected = Recording(self.plan, "me", vars(self.made.messages))
        self.following = Following(Shape(self.plan))

    def step(self, moment: Moment) -> None:
        begun = self.actual.started
        super().step(moment)
        assert isinstance(self.expected, Recording)
        notes = [] if begun else _noted(self.following.begin())
        for numbers in self.actual.taken:
            notes += _noted(self.following.take(numbers))
            self.resumed += self.plan.transitions[numbers[-1]].resume
        if self.actual.failure is not None:
            notes += _noted(self.following.end())
        self.compare("what was left and entered", self.expected.notes, notes)
        self.compare("what is active", self.expected.active, self.following.active)
        self.expected.notes.clear()


def _noted(change: Change) -> list[str]:
    return [*(f"-{label}" for label in change.left), *(f"+{label}" for label in change.entered)]


@pytest.mark.parametrize("group", range(GROUPS))
def test_random_charts(group: int) -> None:
    moved = resumed = 0
    for seed in range(FIRST + group, FIRST + EXAMPLES, GROUPS):
        choices = Choices(seed)
        written = text(choices)
        made = generate(written)
        try:
            game = Followed(made, written)
            game.play(moments(choices))
        finally:
            forget(made)
        moved += game.taken
        resumed += game.resumed
    assert moved > 100
    assert resumed or EXAMPLES < USUAL
