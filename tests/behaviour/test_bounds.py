"""Bounds of variables: what is written outside of them is not, and the state that is entered fails."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play


def counting(by: int, formula: str = "A . B", more: str = "") -> str:
    control = f"control R {{ enter B : / n = n + {by}{more} }}"
    return f"srm R {{ var n : int 0..2 = 1  liveness {{ R = {formula} }} {control} }}"


@pytest.mark.parametrize("by", [1, -1])
def test_both_ends_are_inside(play: Play, by: int) -> None:
    run = play(counting(by)).step()
    run.step(run.done("A"))
    assert (run.active, run.variable("n")) == (["B"], 1 + by)


@pytest.mark.parametrize("by", [2, -2])
def test_a_write_outside_ends_the_agent_and_is_not_made(play: Play, by: int) -> None:
    """ "is not made, and the state that is entered fails" """
    run = play(counting(by)).step()
    run.step(run.done("A"))
    assert "n" in str(run.last.failure)
    assert str(1 + by) in str(run.last.failure)
    assert run.variable("n") == 1


def test_the_activity_that_would_begin_does_not(play: Play) -> None:
    run = play(counting(5, "(A . B) . C")).step()
    run.step(run.done("A"))
    assert not [line for line in run.did if line == "start B"]


def test_an_error_transition_takes_it(play: Play) -> None:
    """ "taken by the nearest `error` transition outwards" """
    run = play(counting(5, "(A . B) . C", " enter C : error")).step()
    run.step(run.done("A"))
    assert (run.active, run.last.failure) == (["C"], None)


def test_what_is_entered_inside_a_composite_fails(play: Play) -> None:
    text = (
        "srm R { var n : int 0..2  liveness { R = (A . inner) . C  inner = B . D }"
        " control R { enter inner : / n = n + 9  enter C : error } }"
    )
    run = play(text).step()
    run.step(run.done("A"))
    assert run.active == ["C"]
    assert "start B" not in run.did


def test_an_action_that_stays_fails_the_state_around_it(play: Play) -> None:
    text = (
        "srm R { var n : int 0..2  liveness { R = A . B }"
        " control R { on A : go / n = n + 9  enter B : error } }"
    )
    run = play(text).step()
    run.step(run.event("go"))
    assert run.did[-2:] == ["cancel A", "start B"]


def test_where_nothing_starts_the_agent_ends(play: Play) -> None:
    run = play("srm R { var n : int 0..2  liveness { R = A } control R { leave A : / n = n + 9 } }").step()
    run.step(run.done("A"))
    assert "n" in str(run.last.failure)


def test_the_other_actions_of_the_way_are_done(play: Play) -> None:
    text = (
        "srm R { var n : int 0..2  var k : int  liveness { R = (A . B) . C }"
        " control R { enter B : / n = n + 9; k = 7  enter C : error } }"
    )
    run = play(text).step()
    run.step(run.done("A"))
    assert run.variable("k") == 7


def test_doubles_have_bounds_too(play: Play) -> None:
    text = "srm R { var d : double -0.5..0.5  liveness { R = A . B } control R { enter B : / d = d - 0.75 } }"
    run = play(text).step()
    run.step(run.done("A"))
    assert "-0.75" in str(run.last.failure)
