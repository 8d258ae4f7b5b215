"""What is set in agents, their numbers, and chance (semantics, "Agents")."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from aseme_dsl.runtime.chart.inputs import Completed, Start
from tests.behaviour.conftest import Play
from tests.oracle.interpreter import Reference
from tests.support.generated import Generated, generate

TEAM = """
system S
enum Side { LEFT RIGHT }
srm R {
  var limit : int = 50
  var side : Side = Side.LEFT
  var near : double = 1
  liveness { R = Count(limit + index) . Turn(side, near) }
  activities { Count(to : int)  Turn(side : Side, near : double) }
}
team T {
  plain : R
  keeper : R with limit = 80, side = Side.RIGHT
  many[2..3] : R with limit = index * 100, near = index / 2
}
"""


def engines(made: Generated, agent: str) -> list[Any]:
    return [Reference(made.plan("R"), agent, vars(made.messages)), made.chart("R", agent)]


@pytest.mark.parametrize(
    ("agent", "given"),
    [
        ("plain", [51, 0, 1.0]),
        ("keeper", [81, 1, 1.0]),
        ("many2", [202, 0, 1.0]),
        ("many3", [303, 0, 1.5]),
    ],
)
def test_variables_hold_what_the_team_sets_and_index_is_the_number(agent: str, given: list[float]) -> None:
    """ "What is set in an agent holds at first", and "index is the agent's number in its range, else 1" """
    for engine in engines(generate(TEAM), agent):
        (start,) = engine.step(0, []).of(Start)
        (turn,) = engine.step(1, [Completed(start.label, start.token)]).of(Start)
        assert [*dict(start.arguments).values(), *dict(turn.arguments).values()] == given


def test_in_an_instance_index_is_its_number(play: Play) -> None:
    """ "in the n-th instance of `A[3]` it is n, of the innermost" """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = part[2]  part = Count(index)[2] . Say(index) }
          activities { Count(to : int)  Say(who : int) }
          control part { enter Say : when [index == 2] / n = index }
        }
    """).step()
    assert run.did == [
        "start Count(to=1)",
        "start Count(to=2)",
        "start Count(to=1)",
        "start Count(to=2)",
        "cancel Count",
        "cancel Count",
        "start Say(who=2)",
    ]
    assert run.variable("n") == 2


def test_chance_is_the_same_for_one_seed_and_one_agent(play: Play) -> None:
    """ "one generator an agent, from the run's seed and the agent's name" """
    run = play("""
        srm R {
          var d : double
          liveness { R = Roll(random())+ }
          activities { Roll(of : double) }
          control R { repeat Roll : / d = random() * 2 + 1  leave Roll : stop }
        }
    """).step()
    chance = Random("1/me")
    first = chance.random()
    assert run.did == [f"random is {first}", f"start Roll(of={first})"]
    run.step(run.done("Roll"))
    assert run.variable("d") == chance.random() * 2 + 1
    assert run.did[-1] == f"start Roll(of={chance.random()})"


def test_nothing_is_drawn_for_an_action_that_is_not_done(play: Play) -> None:
    run = play("""
        srm R {
          var d : double
          liveness { R = A+ }
          control R { repeat A : / d = random() + t.state.M.d  leave A : stop }
        }
    """).step()
    assert run.step(run.done("A")).did == ["fault 0.2 -> 0.2", "start A"]
