"""Who is woken by a variable, and who sees an event (semantics, "Steps", "Transitions", "Blackboards")."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

MOST = 20


def settled(run: Run) -> Run:
    """Make the steps that follow at the same instant."""
    for _ in range(MOST):
        if not run.last.again:
            return run
        run.step()
    raise AssertionError("steps follow without an end")


def test_a_write_wakes_another_region(play: Play) -> None:
    """ "on a write to a variable that such a transition reads (whoever wrote it …): if a step wrote it,
    another step follows at the same instant" """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = v || w  w = W1 . W2  v = A . B }
          control w { enter W2 : / n = 1 }
          control v { enter B : when [n > 0] }
        }
    """).step()
    assert settled(run.step(run.done("W1"))).active == ["B", "W2"]


def test_a_write_on_leaving_wakes_another_region(play: Play) -> None:
    run = play("""
        srm R {
          var k : int = 0
          liveness { R = A || (W . B) }
          control R { leave A : / k = k + 1  enter B : [k == 1] }
        }
    """).step()
    run.step(run.done("W"))
    assert "B" in settled(run.step(run.done("A"))).active


def test_a_write_inside_wakes_what_is_around(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = (v || w) . C  w = W1 . W2  v = A }
          control w { enter W2 : / n = 1 }
          control R { enter C : when [n > 0] }
        }
    """).step()
    assert settled(run.step(run.done("W1"))).active == ["C"]


def test_a_let_is_what_it_stands_for(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          let there = n > 0
          liveness { R = v || w  w = W1 . W2  v = A . B }
          control w { enter W2 : / n = 1 }
          control v { enter B : when [there] }
        }
    """).step()
    assert settled(run.step(run.done("W1"))).active == ["B", "W2"]


def test_a_write_wakes_a_choice(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = v || w  w = W1 . W2  v = A . (B | C) }
          control w { enter W2 : / n = 2 }
          control v { enter B : [n == 1]  enter C : [n == 2] }
        }
    """).step()
    run.step(run.done("A"))
    assert "C" in settled(run.step(run.done("W1"))).active


def test_what_is_read_by_nobody_wakes_nobody(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = v || w  w = W1 . W2  v = A . B }
          control w { enter W2 : / n = 1 }
          control v { enter B : / n = n + 1 }
        }
    """).step()
    run.step(run.done("W1"))
    assert not run.last.again


def test_an_event_that_is_taken_inside_is_spent_outside(play: Play) -> None:
    """ "consumed at once, for its region and for every region around it" """
    run = play("""
        srm R {
          liveness { R = nested  nested = (inner . B) . C  inner = (P . Q) || S }
          control inner { enter Q : bump }
          control nested { enter B : bump }
        }
    """).step()
    run.step(run.event("bump"))
    assert run.active == ["Q", "S"]
    run.step(run.event("bump"))
    assert run.active == ["B"]


def test_regions_beside_keep_their_copy_of_an_event(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = inner . C  inner = (P . Q) || (S . T) }
          control inner { enter Q : bump  enter T : bump }
          control R { enter C : bump }
        }
    """).step()
    run.step(run.event("bump"))
    assert run.active == ["Q", "T"]


def test_a_region_that_is_entered_does_not_see_the_event_of_the_step(play: Play) -> None:
    """ "regions that are entered during the step do not see it" """
    run = play("""
        srm R {
          liveness { R = A . inner  inner = (P . Q) || (S . T) }
          control R { enter inner : bump }
          control inner { enter Q : bump  enter T : bump or stop }
        }
    """).step()
    run.step(run.event("bump"))
    assert run.active == ["P", "S"]
    run.step(run.event("bump"))
    assert run.active == ["Q", "T"]


def test_a_region_that_is_entered_without_the_event_does_not_see_it_either(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A . B . inner  inner = (P . Q) || S }
          control R { enter B : bump  enter inner : when [n == 0] }
          control inner { enter Q : bump }
        }
    """).step()
    run.step(run.event("bump"))
    assert run.active == ["P", "S"]


def test_one_of_two_events_inside_is_not_taken_again_outside(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = inner . C  inner = (P . Q) || S }
          control inner { enter Q : bump or stop }
          control R { enter C : stop or bump }
        }
    """).step()
    assert run.step(run.event("stop")).active == ["Q", "S"]
    assert run.step(run.event("bump")).active == ["C"]


def test_what_is_done_inside_for_an_event_spends_it_outside(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = inner . C  inner = P || S }
          control inner { on P : bump / n = n + 1 }
          control R { enter C : bump }
        }
    """).step()
    run.step(run.event("bump"))
    assert (run.active, run.variable("n")) == (["P", "S"], 1)


def test_what_cuts_short_is_asked_first(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = inner [> C  inner = (P . Q) || S }
          control inner { enter Q : bump }
          control R { enter C : bump }
        }
    """).step()
    assert run.step(run.event("bump")).active == ["C"]


def test_a_signal_that_is_taken_inside_is_spent_outside(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (inner . B) . C  inner = (P . Q) || S }
          control inner { enter Q : when [t.signal.M.on] }
          control R { enter B : when [t.signal.M.on] }
        }
    """).step()
    run.step(run.heard("t.signal.M", on=True))
    assert run.active == ["Q", "S"]
    assert run.step(run.heard("t.signal.M", on=True)).active == ["B"]


def test_a_signal_that_two_regions_take_is_there_for_both(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (P . Q) || (S . T) }
          control R { enter Q : when [t.signal.M.on]  enter T : when [t.signal.M.on] }
        }
    """).step()
    assert run.step(run.heard("t.signal.M", on=True)).active == ["Q", "T"]


def test_of_two_failures_the_inner_error_transition_comes_first(play: Play) -> None:
    """ "If two activities fail in one step, the inner `error` transition is tried first." """
    run = play("""
        srm R {
          liveness { R = both . Rescue  both = (P . Mend) || S }
          control both { enter Mend : error }
          control R { enter Rescue : error }
        }
    """).step()
    run.step(run.crashed("S"), run.crashed("P"))
    assert run.did == ["start Mend", "cancel Mend", "start Rescue"]


def test_a_signal_that_goes_unused_may_be_what_another_transition_waits_for(play: Play) -> None:
    """ "The engine sleeps when nothing is enabled." After the step the signal is absent."""
    run = play("""
        srm R {
          liveness { R = A . B }
          control R { enter B : when [has(t.state.M) && !has(t.signal.M)] }
        }
    """).step()
    run.step(run.heard("t.signal.M"), run.heard("t.state.M"))
    assert run.active == ["A"]
    assert settled(run).active == ["B"]


def test_a_choice_is_reconsidered_when_a_signal_has_gone(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A | B }
          control R reactive { enter A : [has(t.signal.M)]  enter B : [!has(t.signal.M)] }
        }
    """).step()
    assert run.active == ["B"]
    run.step(run.heard("t.signal.M"))
    assert settled(run).active == ["B"]
    assert run.taken[-1].endswith("-> 0.2.3") or "B" in run.started


def test_a_function_that_raises_for_a_signal_is_asked_again_without_it(play: Play) -> None:
    run = play("""
        srm R {
          var ready : bool = true
          liveness { R = A . B }
          control R { enter B : when [inverse(t.signal.M.x) > 9.0 || (ready && has(t.state.M))] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=0), run.heard("t.state.M"))
    assert run.active == ["A"]
    assert settled(run).active == ["B"]


def test_a_signal_that_nobody_misses_wakes_nobody(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A . B }
          control R { enter B : when [t.signal.M.x > 3] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=1))
    assert not run.last.again
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : when [t.signal.M.x > 3]  enter C : when [!has(t.signal.M)] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=1))
    assert not run.last.again


def test_a_signal_is_missed_only_in_the_region_that_asked_for_it(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = v || w  v = A . B  w = P . Q }
          control v { enter B : when [has(t.state.M) && !has(t.signal.M)] }
          control w { enter Q : when [t.signal.M.x > 3] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=1), run.heard("t.state.M"))
    assert settled(run).active == ["B", "P"]


def test_a_signal_is_not_asked_for_before_its_event_is_there(play: Play) -> None:
    """ "it goes at the end of the first step in which a condition that names it was evaluated" """
    run = play("""
        srm R {
          liveness { R = A~ }
          control R { repeat A every 5ms : go [t.signal.M.on] }
        }
    """).step()
    run.step(run.heard("t.signal.M", on=True), ms=10)
    run.step(run.event("go"))
    assert run.started == ["A"]
