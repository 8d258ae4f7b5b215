"""What is not decided yet is a note; what can never be taken, or never be reached, is a warning."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis, codes

_CHART = """
system S
statechart lamp {{
  state 0 OR
  state 0.1 START
  state 0.2 {kind}
  state 0.3 BASIC A
  state 0.4 BASIC B
  state 0.5 END
  0.1 -> 0.2 :
  0.2 -> 0.3 : {expression}
  0.2 -> 0.4 :
  0.3 -> 0.5 :
  0.4 -> 0.5 :
}}
"""


def _role(formula: str, control: str, before: str = "") -> str:
    return f"system S {before} srm role {{ liveness {{ role = {formula} }} control role {{ {control} }} }}"


def test_an_empty_control_block_is_undecided_as_one_that_is_not_there() -> None:
    assert codes(_role("A | B", ""), notes=True).count("N704") == 1
    assert codes(_role("(A+ . [B]) [> C", "")) == []
    (missing,) = [item for item in analysis(_role("A | B", "")).missing if item.note.code == "N704"]
    assert missing.skeleton.startswith("enter A")


def test_a_control_block_with_one_line_is_still_held_to_its_choices() -> None:
    assert "E405" in codes(_role("A | B", "enter A : / start_timer(t, 1s)"))


@pytest.mark.parametrize("kind", ["CONDITION", "BASIC Look"])
def test_a_statechart_without_any_expression_is_a_note(kind: str) -> None:
    text = _CHART.format(kind=kind, expression="")
    assert codes(text) == []
    assert "N704" in codes(text, notes=True)


def test_a_statechart_with_an_expression_is_held_to_its_choices() -> None:
    assert "E404" in codes(_CHART.format(kind="CONDITION", expression="[in(A)]"))


@pytest.mark.parametrize(
    ("before", "condition"),
    [
        ("", "false"),
        ("", "1 > 2"),
        ("let demo = false", "demo"),
        ("enum Place { BELT TABLE } let here = Place.BELT", "here == Place.TABLE"),
    ],
)
def test_a_condition_that_is_always_false_in_a_sequence(before: str, condition: str) -> None:
    assert codes(_role("A . B", f"enter B : [{condition}]", before)) == ["W404"]
    assert codes(_role("A . B", f"leave B : after(1s) [{condition}]", before)) == ["W404"]
    chart = _CHART.format(kind="BASIC Look", expression="when [in(B)]")
    chart = chart.replace("0.4 -> 0.5 :", f"0.4 -> 0.5 : [{condition}]")
    assert "W404" in codes(chart.replace("system S", f"system S {before}"))


def test_a_condition_that_can_hold_is_not_reported() -> None:
    assert codes(_role("A . B", "enter B : [true]")) == []


_INSIDE = """
system S
statechart lamp {{
  state 0 OR
  state 0.1 START
  state 0.2 OR
  state 0.2.1 START
  state 0.2.2 BASIC A
  state 0.2.3 BASIC B
  state 0.2.4 END
  state 0.3 BASIC C
  0.1 -> 0.2 :
  0.2.1 -> 0.2.2 :
  0.2.2 -> 0.2.2 :
  {entry}
  0.2.3 -> 0.2.4 :
  0.2 -> 0.3 :
  0.3 -> 0.3 :
}}
"""


@pytest.mark.parametrize("entry", ["0.2 -> 0.2.3 : t", "0.3 -> 0.2.3 : t"])
def test_a_state_that_is_entered_past_the_start_of_the_state_around_it_is_reached(entry: str) -> None:
    assert codes(_INSIDE.format(entry=entry)) == []


def test_a_state_that_nothing_enters_is_not_reached() -> None:
    assert "W600" in codes(_INSIDE.format(entry=""))
