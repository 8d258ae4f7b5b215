"""`weight 3`: choices by chance (semantics, "Transitions")."""

from __future__ import annotations

from random import Random

import pytest

from tests.behaviour.conftest import Play
from tests.support.compiling import analysis

BOSS = """
srm R {
  liveness { R = attack~  attack = Jab | Sweep | Roar }
  control attack {
    enter Jab   : weight 3
    enter Sweep : [t.state.M.x > 0] weight 2
    enter Roar  : [t.state.M.on] weight 1
  }
}
"""


def _drawn(chance: Random, weights: dict[str, int]) -> str:
    """Which of the open branches is taken, as the reference says: each in turn, by its share of the rest."""
    left = sum(weights.values())
    for name, weight in weights.items():
        if chance.random() * left < weight:
            return name
        left -= weight
    raise AssertionError("the last one is always taken")


def test_an_open_branch_is_taken_as_often_as_its_weight_says(play: Play) -> None:
    """ "of the branches that are open, one is taken by chance": those that are not open do not count."""
    run, chance = play(BOSS).step(), Random("1/me")
    taken = []
    for number in range(40):
        x = number % 2
        taken.append(run.active[0])
        open_before = {"Sweep": 2, "Jab": 3} if number and (number - 1) % 2 else {"Jab": 3}
        assert taken[-1] == _drawn(chance, open_before)
        run.step(run.heard("t.state.M", x=x))
        run.step(run.done(taken[-1]))
    assert {*taken} == {"Jab", "Sweep"}


def test_nothing_is_drawn_while_no_branch_is_open(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A | B)~ }
          control R { enter A : [t.state.M.x == 1] weight 1  enter B : [t.state.M.x == 2] weight 9 }
        }
    """).step()
    run.step(run.heard("t.state.M", x=3))
    assert run.last.effects == []
    run.step(run.heard("t.state.M", x=1))
    assert run.active == ["A"]


def test_a_draw_looks_at_all_conditions(play: Play) -> None:
    """ "All conditions of the choice are looked at": the signal is consumed whichever branch is taken."""
    run = play("""
        srm R {
          liveness { R = (A | B)~ }
          control R { enter A : weight 1  enter B : [t.signal.M.on] weight 9 }
        }
    """).step()
    taken = []
    for number in range(20):
        heard = [run.heard("t.signal.M", on=True)] if number % 2 == 0 else []
        run.step(*heard)
        run.step(run.done(run.active[0]))
        taken.append(run.active[0])
    assert "B" in taken[::2]
    assert {*taken[1::2]} == {"A"}


@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("enter A : weight 3  enter B : [1 > 2]", "enter B : [1 > 2]"),
        ("enter A : weight 3", "B"),
        ("enter A : weight 3  enter B : weight 0", "weight 0"),
        ("enter A : weight 3  enter B : after(1s) weight 1", "weight 1"),
        ("enter A : weight 3  enter B : else weight 1", "weight 1"),
        ("enter A : weight 3  enter B : weight 1  repeat (A | B) : weight 2", "weight 2"),
        ("0.2.2 -> 0.2.3 : weight 4  enter A : [true]  enter B : else", "weight 4"),
    ],
)
def test_a_weight_belongs_to_each_branch_of_a_choice(lines: str, place: str) -> None:
    text = f"system S srm R {{ liveness {{ R = (A | B)~ }} control R {{ {lines} }} }}"
    found = [item for item in analysis(text).diagnostics if item.code == "E434"]
    assert [item.span.text for item in found if item.span is not None] == [place]


def test_else_is_taken_where_no_branch_is_open(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A | B | C)~ }
          control R {
            enter A : [t.state.M.x == 1] weight 1
            enter B : [t.state.M.x == 1] weight 1
            enter C : else
          }
        }
    """).step()
    assert run.active == ["C"]
