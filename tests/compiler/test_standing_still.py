"""W438: states that are left by conditions alone, of which nothing can change what they read."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source

pytest.importorskip("z3")

GRIPPER = """system S
message Load {{ double weight }}
topic arm {{ state Load }}
srm robot {{
  var tries : int
  var ready : bool
  liveness {{ robot = {formula} }}
  activities {{ Grasp takes 1s ends held, slipped  Lift takes 1s  {writes} }}
  control robot {{ {control} }}
}}
team T {{ r : robot }}
"""


def found(control: str, formula: str = "(Grasp . Lift)~", writes: str = "") -> list[Diagnostic]:
    text = GRIPPER.format(control=control, formula=formula, writes=writes)
    analysis = analyse(Source("one.aseme", text))
    assert not [item for item in analysis.diagnostics if item.code[0] == "E"], analysis.diagnostics
    return [item for item in analysis.diagnostics if item.code == "W438"]


def test_an_outcome_that_leads_nowhere() -> None:
    [item] = found("enter Lift : [outcome(Grasp) == held]")
    assert item.message == "`Grasp` can wait for ever: nothing leads on when outcome(Grasp) = slipped"
    assert item.span is not None and item.span.text == "outcome(Grasp) == held"


def test_a_variable_that_nothing_writes_meanwhile() -> None:
    [item] = found("enter Grasp : / tries = tries + 1  enter Lift : [tries < 3]")
    assert "tries = 3" in item.message


@pytest.mark.parametrize(
    "control",
    [
        "enter Lift : [outcome(Grasp) == held]  enter Lift : [outcome(Grasp) == slipped] / tries = 0",
        "enter Lift : [outcome(Grasp) == held]  enter Lift : after(3s)",
        "enter Lift : [outcome(Grasp) == held]  enter Lift : else / tries = 0",
        "enter Lift : [outcome(Grasp) == held || arm.state.Load.weight > 1]",
        "enter Lift : [outcome(Grasp) != held || outcome(Grasp) == held]",
        "enter Lift : [tries == 0]",  # nothing sets it: N437 says so
    ],
)
def test_what_leads_on_or_may_change(control: str) -> None:
    assert found(control) == []


def test_a_variable_that_another_region_writes() -> None:
    control = "enter Grasp : / ready = false  enter Lift : [ready]  repeat Look : / ready = true"
    assert found(control, "(Grasp . Lift)~ || Look~") == []
    [item] = found(control.replace("/ ready = true", "/ tries = 1"), "(Grasp . Lift)~ || Look~")
    assert item.message == "`Grasp` can wait for ever: nothing leads on when ready = false"


def test_an_activity_beside_it_writes_the_variable() -> None:
    control = "enter Grasp : / ready = false  enter Lift : [ready]"
    assert found(control, "(Grasp . Lift)~ || Watch~", "Watch takes 1s writes ready") == []


def test_a_state_around_it_may_be_left() -> None:
    control = "enter Lift : [outcome(Grasp) == held]  enter Look : {}"
    assert found(control.format("after(10s)"), "(Grasp . Lift) [> Look") == []
    assert found(control.format("when [arm.state.Load.weight > 9]"), "(Grasp . Lift) [> Look") == []


def test_a_protocol_that_two_roles_play_is_told_once() -> None:
    text = """system S
aip p {
  participant a {
    engage "Always."
    process = Grasp . Lift
  }
  control a { enter Lift : [outcome(Grasp) == held] }
}
srm r { plays p.a  liveness { r = a }  activities { Grasp takes 1s ends held, slipped } }
srm q { plays p.a  liveness { q = a } }
"""
    found = [item for item in analyse(Source("one.aseme", text)).diagnostics if item.code[0] != "N"]
    assert [item.code for item in found] == ["W438"]
