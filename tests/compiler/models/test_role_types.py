"""SUC to AIP by role types, and as many regions of a participant as its number says."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.statechart import StateType
from tests.support.compiling import analysis, codes, system

_CASES = """
system S
suc {{
  role center, center_for : abstract
  role coach : {type}
  usecase attack by {by} includes walk, pass_ball
}}
"""


def _skeleton(type_: str, by: str) -> str | None:
    found = analysis(_CASES.format(type=type_, by=by)).missing
    return next((item.skeleton for item in found if item.note.code == "N701"), None)


@pytest.mark.parametrize("type_", ["human", "legacy", "external"])
def test_who_is_not_built_gets_no_process(type_: str) -> None:
    skeleton = _skeleton(type_, "center, coach, center_for")
    assert skeleton is not None
    assert "participant center {" in skeleton
    assert "participant center_for {" in skeleton
    assert "coach" not in skeleton
    assert _skeleton(type_, "center, coach") is None  # one party is left: no protocol


@pytest.mark.parametrize("type_", ["system", "abstract"])
def test_who_is_built_gets_a_process(type_: str) -> None:
    skeleton = _skeleton(type_, "center, coach")
    assert skeleton is not None
    assert "participant coach {" in skeleton


_ATTACK = """
system S
aip attack {{
  participant center {{ process = WalkTowardsBall . PassBall }}
  participant center_for {many} {{ var n : int = 0  process = WalkTowardsGoal . [KickBall] }}
  outcome "A goal."
  control center_for {{
    enter KickBall : [n > 0]
    skip KickBall : else
    0.2.2.2.2 -> 0.2.2.2.3 : after(3s) / n = 1
  }}
}}
srm one {{ plays attack.center liveness {{ one = center }} }}
srm two {{ plays attack.center_for liveness {{ two = center_for }} }}
"""


def _regions(many: str) -> list[str]:
    chart = system(_ATTACK.format(many=many)).eacs[0]
    (parallel,) = [node for node in chart.states if node.type is StateType.AND]
    return [node.name for node in chart.children(parallel.label)]


@pytest.mark.parametrize(
    ("many", "number"), [("", 1), ("[1]", 1), ("[2]", 2), ("[3..3]", 3), ("[1..2]", 1), ("[2..*]", 1)]
)
def test_a_participant_has_as_many_regions_as_its_number_says(many: str, number: int) -> None:
    assert _regions(many) == ["center", *["center_for"] * number]


def test_the_regions_of_one_participant_are_alike() -> None:
    chart = system(_ATTACK.format(many="[2]")).eacs[0]
    assert sorted(item.name for item in chart.variables) == ["n@0.2.2.2", "n@0.2.3.2"]

    def inside(region: str) -> list[tuple[str, str, bool]]:
        return [
            (item.source[len(region) :], item.target[len(region) :], item.expression.span is not None)
            for item in chart.transitions
            if item.source.startswith(region)
        ]

    assert inside("0.2.2.") == inside("0.2.3.")
    assert sum(written for *_, written in inside("0.2.2.")) == 3


def test_a_mistake_in_a_participant_of_two_regions_is_reported_once() -> None:
    one = _ATTACK.format(many="[1]").replace("[n > 0]", "[m > 0]")
    assert codes(one.replace("[1]", "[2]")) == codes(one)
    never = _ATTACK.format(many="[1]").replace("[n > 0]", "expired(never)")
    assert codes(never.replace("[1]", "[2]"), notes=True) == codes(never, notes=True)


def test_too_many_regions_are_too_many_states() -> None:
    assert "E304" in codes(_ATTACK.format(many="[1000000000]"))
