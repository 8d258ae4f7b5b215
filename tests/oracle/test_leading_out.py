"""Formulas whose concurrent parts are left from inside: the generated code agrees with the interpreter.

Transitions by label are added to the random texts of `charts.py`, out of the ANDs that their formulas make.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from aseme_dsl.amola.messages import INT
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagnostics import Severity
from aseme_dsl.runtime.chart import chart
from tests.oracle import interpreter
from tests.oracle.charts import EVENTS, text
from tests.oracle.choices import Choices
from tests.oracle.examples import ROUNDS, agree, forget, how_many
from tests.oracle.playing import Game, moments
from tests.support import asleep
from tests.support.compiling import analysis
from tests.support.generated import generate

EXAMPLES = how_many(60)
GAMES = 3
GROUPS = 5


@pytest.fixture(autouse=True)
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chart, "ROUNDS", ROUNDS)
    monkeypatch.setattr(interpreter, "ROUNDS", ROUNDS)
    monkeypatch.setattr(chart.Chart, "step", asleep.step)


def play(choices: Choices) -> Iterator[Game]:
    """A random text with transitions out of its ANDs, compiled, and some games with it.

    Raises:
        AssertionError: the two engines differ.
    """
    written = _with_ways_out(text(choices), choices)
    if written is None:
        return
    made = generate(written)
    try:
        for _ in range(GAMES):
            game = Game(made, written)
            game.play(moments(choices))
            yield game
    finally:
        forget(made)


_SEVERAL = re.compile(r"^    R = .*\[> \(.* \| ", re.MULTILINE)
"""Branches that interrupt each by itself: with a line by label in their block they would be one choice."""


def _with_ways_out(written: str, choices: Choices) -> str | None:
    """The text with one to three more lines in the control of its role; None if it has no place for any."""
    if "srm R {" not in written:
        return None
    if _SEVERAL.search(written):
        return None
    found = analysis(written).system
    assert found is not None
    made = found.iacs[0]
    lines = [line for _ in range(choices.number(1, 3)) if (line := _way_out(made, choices)) is not None]
    if not lines:
        return None
    more = "".join(f"    {line}\n" for line in lines)
    for head in ("  control R {\n", "  control R reactive {\n"):
        if head in written:
            return written.replace(head, head + more)
    return None  # a block of its own would have to decide everything else, too


def _way_out(made: Statechart, choices: Choices) -> str | None:
    inside = [
        node.label
        for node in made.states
        if node.type not in (StateType.END, StateType.AND, StateType.CONDITION)
        and made.region_of(node.label) != "0"
        and made.branch_of(node.label) is None
    ]
    if not inside:
        return None
    source = choices.one_of(inside)
    around = {made.region_of(node.label) for node in made.ancestors(source)} - {made.region_of(source)}
    targets = [
        node.label
        for node in made.states
        if node.type in (StateType.BASIC, StateType.OR, StateType.END)
        and node.parent is not None
        and not made.is_region(node.label)
        and made.region_of(node.label) in around
        and (made.branch_of(node.label) in (None, node.label))
    ]
    if not targets:
        return None
    numbers = [item.name for item in made.variables if item.type == INT and item.scope is None]
    events = [*EVENTS, "after(5ms)", "", "error", *(f"when [{name} > 1]" for name in numbers)]
    actions = [f"start_timer(pace, {choices.number(1, 9)}ms)"]
    actions += [f"{name} = ({name} + 2) % 5" for name in numbers]
    actions.append("t.state.M.x = 3; write_messages.t.state.M")
    action = f" / {choices.one_of(actions)}" if choices.one_in(2) else ""
    return f"{source} -> {choices.one_of(targets)} : {choices.one_of(events)}{action}"


def test_the_lines_are_accepted() -> None:
    """What this file adds to texts is not refused, and there is enough of it."""
    count = 0
    for seed in range(40):
        choices = Choices(seed)
        written = _with_ways_out(text(choices), choices)
        if written is not None:
            count += 1
            problems = analysis(written).diagnostics
            assert [item for item in problems if item.severity is Severity.ERROR] == []
    assert count > 3


@pytest.mark.parametrize("group", range(GROUPS))
def test_generated_code_agrees_with_the_interpreter(group: int) -> None:
    agree(play, EXAMPLES, group, GROUPS)
