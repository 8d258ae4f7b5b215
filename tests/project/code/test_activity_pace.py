"""W439: loops all of whose activities return at once; and what a run says of one."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.project.code.activity_code import check_code
from tests.support.compiling import system

ROBOT = """
system Patrol
message Ball {{ bool visible }}
topic vision {{ state Ball }}
srm robot {{
  var n : int
  liveness {{ robot = {formula} }}
  activities {{ Look {look}  Think }}
  control robot {{ {control} }}
}}
team T {{ r : robot }}
"""
LOOP = "(Look . [Think])~"
THINKS = "enter Think : [vision.state.Ball.visible]  skip Think : else"
AT_ONCE = 'context.log("looked")'


def codes(
    folder: Path, look: str, *, formula: str = LOOP, control: str = THINKS, said: str = ""
) -> list[str]:
    for name, body in (("Look", look), ("Think", "n = len([1])")):
        text = f"class {name}:\n    def execute(self, context):\n        {body}\n"
        (folder / f"{name.lower()}.py").write_text(text, "utf-8")
    text = ROBOT.format(formula=formula, control=control, look=said)
    return [item.code for item in check_code(system(text), folder)[0]]


def test_a_loop_that_nothing_paces(tmp_path: Path) -> None:
    assert codes(tmp_path, AT_ONCE) == ["W439"]


@pytest.mark.parametrize(
    "look", ["context.wait(0.1)", "yield 0.1", "helper()", "self.camera.grab()", "pass", "while True: pass"]
)
def test_an_activity_that_may_take_time(tmp_path: Path, look: str) -> None:
    assert "W439" not in codes(tmp_path, look)


@pytest.mark.parametrize(
    "control",
    [
        THINKS + "  repeat (Look . [Think]) every 100ms :",
        THINKS + "  repeat (Look . [Think]) : after(1s)",
        THINKS + "  repeat (Look . [Think]) : [n < 3] / n = n + 1",
    ],
)
def test_a_loop_that_something_paces(tmp_path: Path, control: str) -> None:
    assert "W439" not in codes(tmp_path, AT_ONCE, control=control)


def test_what_the_activities_write_may_end_the_loop(tmp_path: Path) -> None:
    ends = THINKS + "  repeat (Look . [Think]) : [n < 3]"
    assert "W439" in codes(tmp_path, AT_ONCE, control=ends)
    assert "W439" not in codes(tmp_path, 'context.set_variable("n", 3)', control=ends, said="writes n")


def test_an_activity_with_a_period(tmp_path: Path) -> None:
    assert "W439" not in codes(tmp_path, AT_ONCE, said="every 100ms")
