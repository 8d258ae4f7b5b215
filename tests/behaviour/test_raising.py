"""`raise e` as an action: the event comes alone in a step that follows (semantics, "Messages")."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run


def settled(run: Run) -> Run:
    """Make the steps that follow at the same instant."""
    for _ in range(20):
        if not run.last.again:
            return run
        run.step()
    raise AssertionError("steps follow without an end")


def test_a_raised_event_comes_in_the_next_step(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : go / raise onward  enter C : onward }
        }
    """).step()
    run.step(run.event("go"))
    assert (run.active, run.last.again) == (["B"], True)
    assert settled(run).active == ["C"]


def test_raised_events_come_one_by_one_in_order(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A . B . (C | D) . E }
          control R {
            enter B : go / raise zero; raise second; raise first
            enter (C | D) : zero
            enter C : first
            enter D : second
            enter E : first
          }
        }
    """).step()
    run.step(run.event("go"))
    assert run.step().last.again
    assert run.step().active == ["D"]
    assert run.step().active == ["E"]
    assert not run.last.again


def test_one_that_no_transition_takes_is_dropped(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : go / raise nothing  enter C : late }
        }
    """).step()
    assert settled(run.step(run.event("go"))).active == ["B"]
    assert settled(run.step(run.event("late"))).active == ["C"]


def test_an_event_from_another_region_reaches_this_one(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = v || w  w = W1 . W2  v = A . B }
          control w { enter W2 : go / raise moved }
          control v { enter B : moved }
        }
    """).step()
    assert settled(run.step(run.event("go"))).active == ["B", "W2"]


def test_on_and_exit_raise_too(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A . B . C }
          control R {
            on A    : tick / n = n + 1; raise ticked
            exit A  : / raise gone
            enter B : ticked [n > 1]
            enter C : gone
          }
        }
    """).step()
    assert settled(run.step(run.event("tick"))).active == ["A"]
    assert settled(run.step(run.event("tick"))).active == ["C"]
