"""The generated code and the interpreter agree on every step of random charts with random inputs.

`ORACLE_EXAMPLES=2000 pytest tests/oracle/test_agreement.py` looks at more charts than the usual run does.
"""

from __future__ import annotations

import os
import shutil
import sys

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime import chart
from tests.oracle import interpreter
from tests.oracle.charts import texts
from tests.oracle.playing import Game, Moment, moments
from tests.support.generated import Generated, generate

EXAMPLES = int(os.environ.get("ORACLE_EXAMPLES", "150"))
GAMES = 3
"""How many sequences of inputs are played with one chart."""

ROUNDS = 60
"""The bound of a step here: charts that do not settle are many, and a thousand rounds of them are slow."""


@pytest.fixture(autouse=True, scope="module")
def bound() -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart, "ROUNDS", ROUNDS)
        patch.setattr(interpreter, "ROUNDS", ROUNDS)
        yield


def forget(made: Generated) -> None:
    """Take the package of an example out of memory and off the disk."""
    name = made.package.__name__
    for module in [module for module in sys.modules if module == name or module.startswith(name + ".")]:
        del sys.modules[module]
    shutil.rmtree(made.folder)


@settings(
    max_examples=EXAMPLES,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.large_base_example],
)
@given(texts(), st.lists(moments(), min_size=1, max_size=GAMES))
def test_generated_code_agrees_with_the_interpreter(text: str, games: list[list[Moment]]) -> None:
    made = generate(text)
    try:
        for sequence in games:
            Game(made, text).play(sequence)
    finally:
        forget(made)
