"""What `asemec check` says of conditions that cannot be right, and of which it says nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import Snapshot
from tests.support.compiling import analysis, codes, printed

pytest.importorskip("z3", reason="conditions are compared by z3: pip install 'aseme-dsl[check]'")

CASES = sorted((Path(__file__).parent / "cases").glob("*.aseme"))


@pytest.mark.parametrize("case", CASES, ids=lambda path: path.stem)
def test_what_is_said(case: Path, snapshot: Snapshot) -> None:
    snapshot(printed(case.read_text("utf-8")), f"{case.stem}.txt")


def test_what_is_fine_is_not_mentioned() -> None:
    assert codes((Path(__file__).parent / "cases" / "fine.aseme").read_text("utf-8"), notes=True) == []


def test_a_misspelt_topic_is_an_error_and_if_it_is_declared_the_witness_shows_it() -> None:
    text = (Path(__file__).parent / "cases" / "goalie.aseme").read_text("utf-8")
    leave = text.index("leave  Localize")
    misspelt = text[:leave] + text[leave:].replace("worldstate.", "worlstate.", 1)
    (error,) = analysis(misspelt).diagnostics
    assert error.code == "E502"
    assert "`worldstate`" in str(error.hint)
    declared = misspelt.replace(
        "topic worldstate", "topic worlstate { state GameStateMessage }\ntopic worldstate"
    )
    said = [item for item in analysis(declared).diagnostics if item.code == "W410"]
    assert "worlstate.state.GameStateMessage.player_state" in said[0].message


ROLE = """
system Test
message Ball {{ bool visible  double distance }}
topic vision {{ state Ball }}
srm robot {{
  var steps : int = 0
  liveness {{ robot = {formula} }}
  control robot {{ {control} }}
}}
"""


def role(formula: str, control: str) -> list[str]:
    return codes(ROLE.format(formula=formula, control=control), notes=True)


class TestCycles:
    """A cycle whose conditions contradict each other comes to rest (W403)."""

    def test_it_is_not_reported(self) -> None:
        control = """
          enter A : when [steps < 3]
          enter B : when [steps > 3]
          leave B : when [steps < 2]
        """
        assert "W403" not in role("(A . B)~", control)

    def test_what_may_go_on_is_reported(self) -> None:
        control = "enter A : when [steps < 3]  enter B : when [steps > 0]  repeat (A . B) : when [steps != 7]"
        assert "W403" in role("(A . B)+", control)

    def test_what_an_action_changes_is_no_contradiction(self) -> None:
        control = """
          enter A : / steps = 5
          enter B : when [steps < 3]
          leave B : when [steps > 3]
        """
        assert "W403" in role("(A . B)~", control)

    def test_of_two_ways_one_is_enough(self) -> None:
        control = """
          enter A : when [steps < 3]
          enter B : when [steps > 3]
          enter B : when [steps < 2]
          leave B : when [steps < 3]
        """
        assert "W403" in role("(A . B)~", control)
        assert "W403" not in role("(A . B)~", control.replace("enter B : when [steps < 2]", ""))

    def test_an_else_contradicts_what_it_is_the_else_of(self) -> None:
        control = """
          enter B : [vision.state.Ball.distance < 20]
          enter A : else
          leave A : when [LEFT]
          leave A :
        """
        for left in ("vision.state.Ball.distance < 20", "vision.state.Ball.distance < 10"):
            assert "W403" not in role("(A | B)~", control.replace("LEFT", left))
        assert "W403" in role("(A | B)~", control.replace("LEFT", "vision.state.Ball.distance < 30"))

    def test_the_when_inside_is_pointed_at(self) -> None:
        control = "enter B : [f()]  enter A : else  leave A : when [steps < 2]"
        text = ROLE.format(formula="(A | B)~", control=control) + 'function f() : bool = "m:f"'
        [item] = [item for item in analysis(text).diagnostics if item.code == "W403"]
        assert [place.span.text for place in item.related] == ["leave A : when [steps < 2]"]


@pytest.mark.parametrize(
    "conditions",
    [
        [f"steps == {place}" for place in range(80)],
        [f"{'shift(' * 90}steps{')' * 90} > {place}" for place in range(2)],
        [" || ".join(f"(steps > {place} && steps < {place + 2})" for place in range(900))] * 2,
    ],
    ids=["many branches", "deep calls", "long conditions"],
)
def test_what_is_too_large_is_not_looked_at(conditions: list[str]) -> None:
    branches = [f"A{place}" for place in range(len(conditions))]
    lines = [
        f"enter {branch} : [{condition}]" for branch, condition in zip(branches, conditions, strict=True)
    ]
    text = ROLE.format(formula=f"({' | '.join(branches)})~", control="\n".join(lines))
    if "shift" in text:
        text = text.replace("srm robot", 'function shift(int steps) : int = "m:shift"\nsrm robot')
    assert codes(text, notes=True) == ["N711"]


def test_what_is_too_hard_is_said_once() -> None:
    sum_of_cubes = "steps * steps * steps + more * more * more + most * most * most"
    text = ROLE.format(
        formula="(A | B)~", control=f"enter A : [{sum_of_cubes} == 33]  enter B : [{sum_of_cubes} != 33]"
    )
    assert codes(
        text.replace("liveness", "var more : int = 0  var most : int = 0  liveness"), notes=True
    ) == ["N711"]


def test_a_way_into_a_choice_that_nothing_leaves() -> None:
    text = """
system Dead
statechart player {
  var i : int = 0
  state 0 OR
  state 0.1 START
  state 0.2 CONDITION
  0.1 -> 0.2 : [i > 1 && i < 0]
}
team Dead { one : player }
"""
    assert codes(text) == ["W601", "W412"]
