"""N442: the same `on` line for each activity of a formula."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis

ROLE = """system Fight
srm boss {
  var hp : int = 100
  liveness {
    boss   = (attack | Rest)~
    attack = Roar . Jab . Sweep
  }
  activities { Roar takes 1s  Jab takes 1s  Sweep takes 1s  Rest takes 1s }
  control boss {
    on    Roar  : %s
    on    Jab   : %s
    on    Sweep : %s
    %s
    enter attack : [hp > 3]
    enter Rest   : else
  }
}
"""
HIT = "hit / hp -= 1"


def said(*lines: str, more: str = "") -> list[tuple[str, str | None]]:
    found = analysis(ROLE % (*lines, more)).diagnostics
    return [(item.message, item.hint) for item in found if item.code == "N442"]


def test_one_line_is_enough() -> None:
    hint = "write it once: `on attack : …`"
    assert said(HIT, HIT, "hit/hp-=1") == [("all 3 activities of `attack` have this line", hint)]


def test_of_a_group_and_of_the_whole_role() -> None:
    [(message, hint)] = said(HIT, HIT, HIT, more=f"on Rest : {HIT}")
    assert message == "all 4 activities of `(attack | Rest)` have this line"
    assert hint == "write it once: `on (attack | Rest) : …`"
    lines = " ".join(f"on {name} : {HIT}" for name in "ABC")
    text = f"system S srm r {{ var hp : int = 9 liveness {{ r = A . B . C }} control r {{ {lines} }} }}"
    [found] = [item for item in analysis(text).diagnostics if item.code == "N442"]
    assert found.hint == "write it once, with the whole formula of `r`: `on ( … ) : …`"


@pytest.mark.parametrize(
    "lines",
    [
        (HIT, HIT, "hit / hp -= 2"),
        ("after(1s) / hp -= 1",) * 3,  # since each was entered
        ("error / hp -= 1",) * 3,
    ],
)
def test_lines_that_mean_something_else(lines: tuple[str, str, str]) -> None:
    assert said(*lines) == []


def test_a_part_of_a_formula() -> None:
    text = ROLE.replace("    on    Sweep : %s\n", "") % (HIT, HIT, f"on Rest : {HIT}")
    assert "N442" not in [item.code for item in analysis(text).diagnostics]
