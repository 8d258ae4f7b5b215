"""A transition into several regions of an AND: which are accepted, and what is said of the others."""

from __future__ import annotations

import pytest

from tests.compiler.models.test_leading_out import PAIR
from tests.support.compiling import codes, printed, system

NESTED = """
  state 0.2.2.3 AND
  state 0.2.2.3.1 OR
  state 0.2.2.3.1.1 START
  state 0.2.2.3.1.2 BASIC E
  state 0.2.2.3.2 OR
  state 0.2.2.3.2.1 START
  state 0.2.2.3.2.2 BASIC F
  state 0.2.2.4 CONDITION
  0.2.2.2 -> 0.2.2.3 : after(2s)
  0.2.2.3.1.1 -> 0.2.2.3.1.2 :
  0.2.2.3.2.1 -> 0.2.2.3.2.2 :
  0.2.2.2 -> 0.2.2.4 : after(4s)
  0.2.2.4 -> 0.2.2.2 : [n == 2]
  0.2.2.4 -> 0.2.2.3 : else
"""


def written(line: str) -> str:
    return PAIR.format(line=NESTED + line)


@pytest.mark.parametrize(
    "line",
    [
        "0.1 -> (0.2.1.2, 0.2.2.2) : e",
        "0.4 -> (0.2.2.2, 0.2.1.3) : e / n = 1",
        "0.4.2 -> (0.2.1.3.2, 0.2.2.3) : e",
        "0.4 -> (0.2.1.2, 0.2.2.3.1.2, 0.2.2.3.2.2) : when [n == 4]",
        "0.4 -> (0.2.2.3.1.2, 0.2.2.3.2.2) : e",
        "0.2 -> (0.2.1.3, 0.2.2.2) : e",
        "0.2.1.2 -> (0.2.1.3, 0.2.2.3) : e",
        "0.2.2.2 -> (0.2.2.3.1.2, 0.2.2.3.2.2) : e",
        "0.3 -> (0.2.1.2, 0.2.2.2) : [n == 7]",
        "0.4 -> (0.2.2.2) : e",
    ],
)
def test_a_transition_may_lead_into_several_regions(line: str) -> None:
    assert codes(written(line)) == []


@pytest.mark.parametrize(
    ("line", "code", "message"),
    [
        ("0.4 -> (0.2.1.2, 0.2.1.3) : e", "E613", "0.2.1.2 and 0.2.1.3 are both in 0.2.1, which is a region"),
        ("0.1 -> (0.4, 0.2.2.2) : e", "E613", "0.4 and 0.2.2.2 are both in 0, which is not AND"),
        ("0.4 -> (0.2.2.3, 0.2.2.3.1.2) : e", "E613", "0.2.2.3.1.2 is inside the target 0.2.2.3"),
        ("0.4 -> (0.2.1.2, 0.2.1.2) : e", "E613", "0.2.1.2 is a target twice"),
        ("0.4 -> (0.2.1.2, 0.2.2) : e", "E613", "the target 0.2.2 is a region of 0.2"),
        ("0.4 -> (0.2.1.2, 0.2.2.4) : e", "E613", "the target 0.2.2.4 is a CONDITION"),
        ("0.4 -> (0.2.1.2, 0.2.2.1) : e", "E603", "0.2.2.1 is a START"),
        ("0.4 -> (0, 0.2.2.2) : e", "E409", "the root has no transitions"),
        ("0.5 -> (0.2.1.2, 0.2.2.2) : e", "E604", "0.5 is an END"),
        ("0.4 -> (0.2.1.2, 0.2.2.5) : e", "E410", "the statechart has no state 0.2.2.5"),
        ("0.2.1.2 -> (0.2.2.3.1.2, 0.2.2.3.2.2) : e", "E409", "leads into the region 0.2.2"),
    ],
)
def test_targets_that_cannot_be_entered_together(line: str, code: str, message: str) -> None:
    found = printed(written(line))
    assert codes(written(line)) == [code]
    assert message in found
    assert "hint: " in found or message.startswith("the root")


def test_the_targets_are_underlined_and_the_and_is_the_target() -> None:
    text = written("0.4 -> (0.2.2.2, 0.2.1.3) : e")
    way = next(item for item in system(text).iacs[0].transitions if item.into)
    assert (way.source, way.target, way.into) == ("0.4", "0.2", ("0.2.1.3", "0.2.2.2"))
    found = printed(written("0.4 -> (0.2.1.2, 0.2.1.3) : e"))
    assert "^" * len("0.2.1.2, 0.2.1.3") in found.splitlines()[2]


@pytest.mark.parametrize(
    ("missing", "found"),
    [
        ("  state 0.2 AND\n", ["E410"]),
        ("  state 0.2.1 OR\n", ["E410"]),
        ("  state 0.2.1.3 OR\n", ["E410"]),
        ("  state 0 OR\n", ["E600"]),
    ],
)
def test_a_state_that_is_missing_is_said_alone(missing: str, found: list[str]) -> None:
    text = PAIR.format(line="0.4 -> (0.2.1.3.2, 0.2.2.2) : e")
    assert missing in text
    assert set(found) <= set(codes(text.replace(missing, ""))) <= {"E410", "E600", "W602"}


def test_targets_of_two_roots() -> None:
    text = PAIR.format(line="state 1 OR  state 1.1 START  state 1.2 BASIC Z  0.4 -> (0.2.1.2, 1.2) : e")
    assert "E600" in codes(text)


@pytest.mark.parametrize("targets", ["()", "(0.2.1.2", "(0.2.1.2,)", "(0.2.1.2 0.2.2.2)", "0.2.1.2, 0.2.2.2"])
def test_what_is_no_list_of_targets(targets: str) -> None:
    assert codes(PAIR.format(line=f"0.4 -> {targets} : e"))[0] == "E100"


def test_a_formula_has_transitions_with_one_target() -> None:
    text = """system S
srm r {
  liveness { r = A . (B || C) . D }
  control r { 0.2 -> (0.3.2.1.2, 0.3.2.2.2) : e  enter (B || C) : }
}
"""
    assert "E613" in codes(text)
