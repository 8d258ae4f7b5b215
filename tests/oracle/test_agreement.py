"""The generated code and the interpreter agree on every step of random charts with random inputs.

The examples are the same in every run. `ORACLE_EXAMPLES=5000 pytest tests/oracle/test_agreement.py` looks at
more of them, `ORACLE_FIRST=1000000` at others.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from aseme_dsl.runtime.chart import chart
from tests.oracle import interpreter
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, agree, forget, how_many
from tests.oracle.playing import Game, moments
from tests.support import asleep
from tests.support.generated import generate

EXAMPLES = how_many(60)
GAMES = 3
"""How many sequences of inputs are played with one chart."""

GROUPS = 10


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)
    monkeypatch.setattr(chart.Chart, "step", asleep.step)


def play(choices: Choices) -> Iterator[Game]:
    """A random text, compiled, and some games with it.

    Raises:
        AssertionError: the text does not compile, or the two engines differ.
    """
    written = text(choices)
    made = generate(written)
    try:
        for number in range(GAMES):
            game = Game(
                made, written, goes_back=number == len(written) % (2 * GAMES)
            )  # each second chart once
            game.play(moments(choices))
            yield game
    finally:
        forget(made)


ACCEPTANCE = ("testbehavior", "kouretes", "contract_net")


@pytest.mark.parametrize("name", ACCEPTANCE)
def test_they_agree_on_the_texts_of_the_papers(name: str) -> None:
    """The acceptance files, with inputs as random as those above."""
    written = (Path(__file__).parents[1] / "acceptance" / f"{name}.aseme").read_text("utf-8")
    made = generate(written)
    try:
        for role in made.charts:
            for seed in range(20):
                choices = Choices(f"{role} {seed}")
                game = Game(made, written, role, goes_back=seed % 10 == 0)
                for _ in range(3):
                    game.play(moments(choices))
                assert game.taken > 0
    finally:
        forget(made)


@pytest.mark.parametrize("group", range(GROUPS))
def test_generated_code_agrees_with_the_interpreter(group: int) -> None:
    assert agree(play, EXAMPLES, group, GROUPS) > 0
