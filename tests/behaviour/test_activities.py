"""Activities: tokens, cancellation, failures (semantics, "Transitions" and "Activities")."""

from __future__ import annotations

from tests.behaviour.conftest import Play


def test_leaving_cancels_and_the_late_result_is_dropped(play: Play) -> None:
    """ "Leaving a BASIC state whose activity still runs cancels the activity: it is told, and its late result
    is dropped." """
    run = play("srm R { liveness { R = (A . B)~ } control R { repeat (A . B) : go } }").step()
    late = run.done("A")
    assert run.step(run.event("go")).did == ["cancel A", "start A"]
    assert run.step(late).active == ["A"]
    assert run.step(run.done("A")).active == ["B"]


def test_a_state_that_is_complete_has_nothing_to_cancel(play: Play) -> None:
    """ "a BASIC whose activity still runs gives Cancel" """
    run = play("srm R { liveness { R = A . B } control R { enter B : [t.state.M.on] } }").step()
    run.step(run.done("A"))
    assert run.step(run.heard("t.state.M", on=True)).did == ["start B"]


def test_each_start_has_a_token_of_its_own(play: Play) -> None:
    """ "BASIC gives Start with a new token (a counter of the chart, from 1)" """
    run = play("srm R { liveness { R = (A || B) . C } }").step()
    assert [start.token for start in run.last.effects] == [1, 2]  # type: ignore[union-attr]
    run.step(run.done("A", token=2))
    assert run.active == ["A", "B"]


def test_a_result_of_a_state_that_is_not_active_is_dropped(play: Play) -> None:
    """ "if that state is active with the same token (else dropped)" """
    run = play("srm R { liveness { R = A . B . C } }").step()
    late = run.done("A")
    run.step(late)
    assert run.step(late).active == ["B"]


def test_a_failure_without_error_transition_stops_the_agent(play: Play) -> None:
    """ "otherwise the agent stops in a safe way and says where" """
    run = play("srm R { liveness { R = A || B || C } }").step()
    run.step(run.crashed("B", "no battery"))
    assert run.last.failure is not None
    assert "B" in run.last.failure and "no battery" in run.last.failure
    assert run.did == ["cancel A", "cancel C"]
    assert not run.last.finished


def test_a_stopped_agent_does_nothing_more(play: Play) -> None:
    run = play("srm R { liveness { R = A || B } }").step()
    done = run.done("A")
    run.step(run.crashed("B"))
    failure = run.last.failure
    run.step(done)
    assert (run.did, run.taken, run.last.failure) == ([], [], failure)


def test_a_failure_is_taken_by_the_error_transition_of_its_state(play: Play) -> None:
    """ "taken by the nearest `error` transition outwards" """
    run = play("srm R { liveness { R = A . B } control R { enter B : error } }").step()
    assert run.step(run.crashed("A")).did == ["start B"]
    assert run.last.failure is None


def test_a_failure_bubbles_outwards_to_the_nearest(play: Play) -> None:
    """ "taken by the nearest `error` transition outwards" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = outer . D  outer = inner . C  inner = A . B }
          control R { enter D :  enter D : error / v = 1 }
          control outer { enter C :  enter C : error / v = 2 }
        }
    """).step()
    run.step(run.crashed("A"))
    assert run.active == ["C"]
    assert run.variable("v") == 2


def test_a_failure_in_a_region_reaches_the_and(play: Play) -> None:
    """ "it bubbles outwards" """
    run = play("""
        srm R { liveness { R = (A || B) . C } control R { enter C :  enter C : error } }
    """).step()
    run.step(run.crashed("B"))
    assert run.did == ["cancel A", "start C"]


def test_a_failed_state_is_not_complete(play: Play) -> None:
    """ "One that raises leaves its state *failed*" """
    run = play("""
        srm R { liveness { R = A . B . C } control R { enter B :  enter B : error [t.state.M.on] } }
    """).step()
    run.step(run.crashed("A"))
    assert run.last.failure is not None
    assert run.taken == []


def test_a_failed_state_may_be_left_by_another_event(play: Play) -> None:
    """ "if a failed state is still active the agent stops" """
    run = play("srm R { liveness { R = A . B } control R { enter B : go } }").step()
    run.step(run.crashed("A"), run.event("go"))
    assert run.last.failure is None
    assert run.did == ["start B"]


def test_a_late_failure_is_dropped(play: Play) -> None:
    run = play("srm R { liveness { R = A . B } control R { enter B : go } }").step()
    late = run.crashed("A")
    run.step(run.event("go"))
    assert run.step(late).last.failure is None


def test_an_activitys_writes_count_from_its_next_input(play: Play) -> None:
    """ "an activity's writes count from its next input" """
    run = play("""
        srm R { var v : int = 0  liveness { R = A . B } control R { enter B : when [v == 4] } }
    """).step()
    assert run.step(run.wrote("v", 3)).active == ["A"]
    assert run.step(run.wrote("v", 4)).active == ["B"]
    assert run.variable("v") == 4
