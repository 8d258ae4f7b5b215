"""Steps and time: snapshots, rounds, settling, timers, waking (semantics, "Steps" and "Time")."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run
from tests.oracle.interpreter import Reference
from tests.support.plain_engine import PlainEngine


def test_inputs_are_taken_together(play: Play) -> None:
    """ "Inputs that have arrived … are taken together: one **snapshot**." """
    run = play("""
        srm R { liveness { R = A . B . C }
        control R { enter B : [t.state.M.x == 1]  enter C : [t.state.M.x == 2] } }
    """).step()
    run.step(run.heard("t.state.M", x=1), run.done("A"), run.heard("t.state.M", x=2))
    assert run.active == ["A"]


def test_a_step_goes_on_until_nothing_is_enabled(play: Play) -> None:
    """ "Again from 2 until nothing is enabled: the step is over" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : when [t.state.M.on]  enter C : when [t.state.M.on] }
        }
    """).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.did == ["cancel A", "start B", "cancel B", "start C"]


def test_regions_take_turns_in_document_order(play: Play) -> None:
    """ "Each region, in document order, takes at most one transition" """
    run = play("srm R { liveness { R = (A . B) || (C . D) } }").step()
    run.step(run.done("C"), run.done("A"))
    assert run.did == ["start B", "start D"]


def test_an_enclosing_transition_waits_until_no_region_moves(play: Play) -> None:
    """ "a transition of an enclosing state is taken only if no region inside it moved (and, for `when` and
    events, in the first such round: all its regions are then left and their activities cancelled)" """
    run = play("""
        srm R {
          liveness { R = (A || (B . C)) . D }
          control R { enter D : when [t.state.M.on] }
        }
    """).step()
    run.step(run.heard("t.state.M", on=True), run.done("B"))
    assert run.did == ["start C", "cancel A", "cancel C", "start D"]


def test_a_write_is_seen_at_once_in_its_region(play: Play) -> None:
    """ "plus the writes of the step's own actions, each in its own region" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . B . C }
          control R { enter B : / v = v + 1; v = v * 10  enter C : when [v == 10] }
        }
    """).step()
    assert run.step(run.done("A")).active == ["C"]


def test_a_write_is_seen_elsewhere_from_the_next_step(play: Play) -> None:
    """ "A write is seen at once in its region, elsewhere from the next step, which follows at the same
    instant if anything there reads it" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = first || second  first = A . B  second = C . D }
          control first { enter B : / v = 1 }
          control second { enter D : when [v == 1] }
        }
    """).step()
    run.step(run.done("A"))
    if not isinstance(run.chart, PlainEngine):  # a plain class makes the step that follows itself
        assert (run.active, run.last.again) == (["B", "C"], True)
        run.step()
    assert run.variable("v") == 1
    assert run.active == ["B", "D"]


def test_of_two_writers_the_last_in_document_order_stays(play: Play) -> None:
    """ "of two writes in one step the last in document order stays" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = first || second  first = A . B . C  second = D . E }
          control first { enter B : / v = v + 1  enter C : when [v == 1] / v = v + 1 }
          control second { enter E : / v = v + 10 }
        }
    """).step()
    run.step(run.done("A"), run.done("D"))
    assert run.active == ["C", "E"]
    assert run.variable("v") == 10


def test_a_region_entered_later_starts_with_a_copy(play: Play) -> None:
    """ "and by regions entered later in the same step inside it (they start with a copy)" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . (first || C)  first = B | D }
          control R { enter (first || C) : / v = 5 }
          control first { enter B : [v == 5]  enter D : else }
        }
    """).step()
    run.step(run.done("A"))
    assert run.active == ["B", "C"]


def test_a_region_entered_again_in_the_same_step_starts_with_the_copy_around_it(play: Play) -> None:
    """ "elsewhere from the next step"; "they start with a copy" """
    run = play("""
        srm R {
          var v : int = 0
          var seen : int = 9
          liveness { R = (first || D)~  first = A . B }
          control R { repeat (first || D) : when [t.signal.M.on] }
          control first { enter A : / seen = v  enter B : / v = 3 }
        }
    """).step()
    run.step(run.done("A"), run.heard("t.signal.M", on=True))
    assert run.active == ["A", "D"]
    assert (run.variable("v"), run.variable("seen")) == (3, 0)
    run.step(run.heard("t.signal.M", on=True))
    assert run.variable("seen") == 3


def test_a_step_that_does_not_settle_is_reported(play: Play) -> None:
    """ "A step that does not settle within a bound … [is] a reported error that names the cycle" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . (B . C)~ }
          control R {
            enter C : when [v == 0]
            repeat (B . C) : when [v == 0]
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.last.failure is not None
    if isinstance(run.chart, Reference):  # which knows no places
        assert "0.3.2.2 -> 0.3.2.3" in run.last.failure and "0.3.2 -> 0.3.2" in run.last.failure
    else:
        assert "B" in run.last.failure and "C" in run.last.failure
        assert ".aseme:21:" in run.last.failure and ".aseme:22:" in run.last.failure
    if not isinstance(run.chart, PlainEngine):  # which takes some ways together
        assert len(run.taken) == 1000
    assert run.step().did == []


def test_expired_is_false_before_the_timer_is_started(play: Play) -> None:
    """ "`expired(t)` is false before `start_timer`" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : / start_timer(pace, 10ms)  enter C : when [expired(pace)]  leave C : go }
        }
    """).step(ms=100)
    run.step(run.done("A"))
    assert run.active == ["B"]
    assert run.step(ms=10).active == ["C"]


def test_a_timer_is_expired_from_its_due_time_on(play: Play) -> None:
    """ "true from the due time until it is started again" """
    run = play("""
        srm R {
          liveness { R = A . B . C . D }
          control R {
            enter B : / start_timer(pace, 10ms)
            enter C : [expired(pace)] / start_timer(pace, 20ms)
            enter D : [expired(pace)]
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.due == 10
    assert run.step(run.done("B"), ms=9.999999).active == ["B"]
    assert run.due == 0.000001
    assert run.step(ms=0.000001).active == ["C"]
    assert run.step(run.done("C"), ms=19).active == ["C"]
    assert run.step(ms=50).active == ["D"]


def test_timers_belong_to_the_region_that_starts_them(play: Play) -> None:
    """ "Timers belong to the region that starts them" """
    run = play("""
        srm R {
          liveness { R = first || second  first = A . B  second = C . D }
          control first { enter A : / start_timer(pace, 10ms)  enter B : when [expired(pace)] }
          control second { enter D : when [expired(pace)] }
        }
    """).step()
    assert run.step(ms=10).active == ["B", "C"]


def test_leaving_the_region_drops_its_timers(play: Play) -> None:
    """ "leaving the region drops its timers" """
    run = play("""
        srm R {
          liveness { R = (first || C)~  first = A . B }
          control R { repeat (first || C) : go }
          control first {
            enter A : [!expired(pace)] / start_timer(pace, 10ms)
            enter A : [expired(pace)]
            enter B : when [expired(pace)]
          }
        }
    """).step()
    run.step(run.event("go"), ms=9)
    assert run.due == 10
    assert run.step(ms=1).active == ["A", "C"]


def test_an_inner_region_does_not_see_the_timers_around_it(play: Play) -> None:
    """ "it starts with the surrounding one's states and histories, without signals and timers" """
    run = play("""
        srm R {
          liveness { R = A . (first || D)  first = B . C }
          control R { enter A : / start_timer(pace, 0ms) }
          control first { enter C : when [expired(pace)] }
        }
    """).step()
    run.step(run.done("A"))
    assert run.step(ms=5).active == ["B", "D"]


def test_the_chart_sleeps_when_time_changes_nothing(play: Play) -> None:
    """ "The engine sleeps when nothing is enabled." """
    run = play("srm R { liveness { R = A . B } control R { enter B : [t.state.M.on] } }").step()
    assert run.due is None


def test_the_chart_wakes_when_an_age_crosses_its_constant(play: Play) -> None:
    """ "at the moment when `age(x)` crosses the constant it is compared with" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : when [age(t.state.M) > 100ms]  enter C : when [100ms <= age(t.data.M)
                                                                              && 200ms <= age(t.state.M)] }
        }
    """).step()
    assert run.due is None
    run.step(run.heard("t.state.M", ms_ago=30))
    assert run.due == 70.000001
    assert run.step(ms=70).active == ["A"]
    assert run.step(ms=0.000001).active == ["B"]
    assert run.due == 99.999999


def test_a_constant_may_be_computed(play: Play) -> None:
    """ "the constant it is compared with" """
    run = play("""
        let patience = 2 * 100ms + 1s / 2
        srm R { liveness { R = A . B } control R { enter B : when [-(-patience) <= age(t.state.M)] } }
    """).step()
    run.step(run.heard("t.state.M"))
    assert run.due == 700


def test_the_earliest_of_several_moments_counts(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A || (B . C) }
          control R { leave A : after(50ms)  start R : / start_timer(pace, 1s)
          enter C : after(20ms) or after(30ms) }
        }
    """).step()
    assert run.due == 20
    run.step(run.event("nothing"), ms=10)
    assert run.due == 10


def queue(run: Run, count: int) -> Run:
    """A step with so many signals of a queued channel, numbered from 1."""
    return run.step(*(run.heard("q.signal.M", x=number) for number in range(1, count + 1)))


def test_a_long_queue_is_taken_in_one_step(play: Play) -> None:
    """A finite queue of inputs is no cycle, however many rounds it takes."""
    run = play("""
        srm R {
          var sum : int = 0
          liveness { R = A~ }
          control R { repeat A : when [q.signal.M.x > 0] / sum = sum + 1 }
        }
    """).step()
    queue(run, 3500)
    assert (run.last.failure, run.variable("sum")) == (None, 3500)


def test_a_queue_may_take_several_rounds_for_each_signal(play: Play) -> None:
    run = play("""
        srm R {
          var sum : int = 0
          liveness { R = (A . B . C)~ }
          control R {
            enter B : when [q.signal.M.x > 0] / sum = sum + 1
            enter C : when [sum > 0]
            repeat (A . B . C) : when [in(C)]
          }
        }
    """).step()
    queue(run, 2500)
    assert (run.last.failure, run.variable("sum")) == (None, 2500)


def test_agent_messages_that_wait_are_no_cycle(play: Play) -> None:
    run = play("""
        aip p {
          participant a {
            engage "Always."  receives inform Note  sends cfp Note  process = X~
          }
          participant b { engage "Always."  sends inform Note  receives cfp Note  process = Y }
          outcome "Done."
          control a { repeat X : inform Note from b  start a : / send cfp Note to b }
        }
        srm R { plays p.a  liveness { R = a } }
    """).step()
    run.step(*(run.mail("inform", "Note", text="x") for _ in range(1500)))
    assert run.last.failure is None
    assert run.started.count("X") == 1500


def test_a_loop_that_refills_its_own_queue_is_a_cycle(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A~ }
          control R { repeat A : when [q.signal.M.x > 0] / write_messages.q.signal.M { x = 1 } }
        }
    """).step()
    queue(run, 10)
    assert run.last.failure is not None
    assert len(run.taken) <= 2000


def test_a_cycle_beside_a_queue_is_found_when_the_queue_is_empty(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = v || w  v = A~  w = B . (P . Q)~ }
          control v { repeat A : when [q.signal.M.x > 0] }
          control w { enter Q : when [n == 0]  repeat (P . Q) : when [n == 0] }
        }
    """).step()
    run.step(*(run.heard("q.signal.M", x=1) for _ in range(1500)), run.done("B"))
    assert run.last.failure is not None
    assert len(run.taken) > 1500
    if not isinstance(run.chart, Reference):  # which knows no places
        assert "P -> Q (test.aseme:21:" in run.last.failure
