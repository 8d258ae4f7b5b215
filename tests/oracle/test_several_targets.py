"""Transitions into several regions of an AND: the generated code agrees with the interpreter."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import pytest

from aseme_dsl.runtime.chart import chart
from tests.oracle import interpreter
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, agree, forget, how_many
from tests.oracle.playing import Moment, moments
from tests.oracle.test_following import Followed
from tests.support import asleep
from tests.support.generated import generate

EXAMPLES = how_many(120)
"""Of these, one in three has such a transition."""

GAMES = 3
GROUPS = 4


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)
    monkeypatch.setattr(chart.Chart, "step", asleep.step)


@dataclass
class Splitting(Followed):
    """A game that counts the transitions with several targets that were taken."""

    split: int = 0

    def step(self, moment: Moment) -> None:
        super().step(moment)
        self.split += sum(bool(self.plan.transitions[numbers[-1]].into) for numbers in self.actual.taken)


def play(choices: Choices) -> Iterator[Splitting]:
    """A random text that has such a transition, compiled, and the games in which one was taken.

    Raises:
        AssertionError: the two engines differ.
    """
    written = text(choices, given=True)
    if " -> (" not in written:
        return
    made = generate(written)
    try:
        for _ in range(GAMES):
            game = Splitting(made, written)
            game.play(moments(choices))
            if game.split:
                yield game
    finally:
        forget(made)


@pytest.mark.parametrize("group", range(GROUPS))
def test_generated_code_agrees_with_the_interpreter(group: int) -> None:
    assert agree(play, EXAMPLES, group, GROUPS) > 5
