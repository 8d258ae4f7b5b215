"""`on T` and `exit T`: what is done in a state, and whenever it is left (semantics, "Staying")."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play


def counting(line: str, formula: str = "A . B", more: str = "") -> str:
    return f"""
        srm R {{
          var n : int = 0
          var m : int = 0
          liveness {{ R = {formula} }}
          control R {{ {line} / n = n + 1 {more} }}
        }}
    """


def test_on_leaves_and_enters_nothing(play: Play) -> None:
    """ "Nothing is left or entered." """
    run = play(counting("on A : go")).step()
    run.step(run.event("go"))
    assert (run.did, run.active, run.variable("n")) == ([], ["A"], 1)
    assert run.taken == ["0.2 -> 0.2"]


def test_an_event_is_taken_each_time(play: Play) -> None:
    run = play(counting("on A : go")).step()
    run.step(run.event("go"))
    run.step(run.event("go"), ms=1)
    assert run.variable("n") == 2


def test_an_event_needs_the_condition(play: Play) -> None:
    run = play(counting("on A : go [t.state.M.on]")).step()
    run.step(run.event("go"))
    assert run.variable("n") == 0
    run.step(run.event("go"), run.heard("t.state.M", on=True))
    assert run.variable("n") == 1
    run.step(run.heard("t.state.M", on=True), ms=1)
    assert run.variable("n") == 1


def test_when_is_taken_once_while_nothing_changes(play: Play) -> None:
    """ "Without an event it is taken when its condition holds" """
    run = play(counting("on A : when [t.state.M.x > 3]")).step()
    run.step(run.heard("t.state.M", x=4))
    run.step(ms=5)
    assert run.variable("n") == 1


def test_when_is_taken_again_for_a_newer_message(play: Play) -> None:
    """ "or something it reads has been written or has arrived since (a newer message …)" """
    run = play(counting("on A : when [t.state.M.x > 3]")).step()
    run.step(run.heard("t.state.M", x=4))
    run.step(run.heard("t.state.M", x=4), ms=5)
    assert run.variable("n") == 2


def test_when_is_taken_again_when_it_has_not_held_in_between(play: Play) -> None:
    """ "and again each time it holds and has not held in between" """
    run = play(counting("on A : when [m == 1]")).step()
    run.step(run.wrote("m", 1))
    run.step(run.wrote("m", 2))
    run.step(run.wrote("m", 1))
    assert run.variable("n") == 2


def test_when_is_not_taken_again_for_the_same_value(play: Play) -> None:
    run = play(counting("on A : when [m > 0]")).step()
    run.step(run.wrote("m", 1))
    run.step(run.wrote("m", 1))
    assert run.variable("n") == 1
    run.step(run.wrote("m", 2))
    assert run.variable("n") == 2


def test_what_its_own_actions_write_does_not_count(play: Play) -> None:
    """ "What its own actions write does not count." """
    run = play(counting("on A : when [n < 5]")).step()
    assert run.variable("n") == 1
    run.step(ms=1)
    assert run.variable("n") == 1


def test_what_another_line_writes_counts(play: Play) -> None:
    run = play(counting("on A : when [m > 0]", more="on A : go / m = m + 1")).step()
    run.step(run.event("go"))
    run.step(run.event("go"))
    assert run.variable("n") == 2


def test_a_timer_that_is_started_anew_counts(play: Play) -> None:
    text = counting(
        "on A : when [expired(p)]", more="; start_timer(p, 10ms) on A : go / start_timer(p, 10ms)"
    )
    run = play(text).step()
    run.step(run.event("go"))
    assert run.due == 10
    run.step(ms=10)
    run.step(ms=10)
    run.step(ms=10)
    assert run.variable("n") == 3


def test_each_signal_counts(play: Play) -> None:
    """ "A signal that is there always counts: it is consumed." """
    run = play(counting("on A : when [q.signal.M.x > 0]")).step()
    signals = [run.heard("q.signal.M", x=1), run.heard("q.signal.M", x=1), run.heard("q.signal.M", x=2)]
    run.step(*signals)
    assert run.variable("n") == 3


def test_time_is_waited_for_once_an_entry(play: Play) -> None:
    """ "`after(d)`: once an entry" """
    text = counting("on A : after(10ms)", "A+", more="repeat A : go")
    run = play(text).step()
    assert run.due == 10
    run.step(ms=10)
    run.step(ms=10)
    assert (run.variable("n"), run.due) == (1, None)
    run.step(run.event("go"))
    run.step(ms=10)
    assert run.variable("n") == 2


def test_several_times_are_waited_for_one_after_the_other(play: Play) -> None:
    run = play(counting("on A : after(10ms) or after(20ms)")).step()
    for _ in range(6):
        run.step(ms=5)
    assert run.variable("n") == 2


def test_without_event_and_when_it_waits_for_completion(play: Play) -> None:
    text = counting("on A :", more="enter B : go")
    run = play(text).step()
    assert run.variable("n") == 0
    run.step(run.done("A"))
    run.step(ms=1)
    assert run.variable("n") == 1


def test_what_it_has_seen_is_forgotten_with_each_entry(play: Play) -> None:
    run = play(counting("on A : when [t.state.M.on]", "A+", more="repeat A : go")).step()
    run.step(run.heard("t.state.M", on=True))
    run.step(run.event("go"))
    assert run.variable("n") == 2


def test_it_takes_its_turn_among_the_lines(play: Play) -> None:
    run = play(counting("on A : go", more="enter B : go")).step()
    run.step(run.event("go"))
    assert (run.variable("n"), run.active) == (1, ["A"])  # it has spent the event
    run = play("""
        srm R { var n : int = 0  liveness { R = A . B } control R { enter B : go  on A : go / n = n + 1 } }
    """).step()
    run.step(run.event("go"))
    assert (run.variable("n"), run.active) == (0, ["B"])


def test_of_a_formula_it_is_looked_at_whatever_is_active_inside(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = work . C  work = A . B || D }
          control R { on work : when [t.state.M.on] / n = n + 1 }
        }
    """).step()
    run.step(run.heard("t.state.M", on=True))
    run.step(run.heard("t.state.M", on=True), run.done("A"))
    assert (run.variable("n"), run.active) == (2, ["B", "D"])


def test_of_a_loop_it_is_the_body_or_the_whole(play: Play) -> None:
    """ "of a loop `T+` … mean the body T, `on T+` the loop's node" """
    text = """
        srm R {
          var n : int = 0
          var m : int = 0
          liveness { R = A+ . B }
          control R {
            repeat A : go
            exit A  : / n = n + 1
            exit A+ : / m = m + 1
          }
        }
    """
    run = play(text).step()
    run.step(run.event("go"))
    run.step(run.done("A"))
    assert (run.variable("n"), run.variable("m")) == (2, 1)


def test_exit_is_done_however_the_state_is_left(play: Play) -> None:
    """ "when T is left in any way" """
    text = counting("exit A :", more="enter B : hop enter B :")
    for how in ("hop", "done"):
        run = play(text).step()
        run.step(run.event("hop") if how == "hop" else run.done("A"))
        assert run.variable("n") == 1
        assert run.did == (["cancel A", "start B"] if how == "hop" else ["start B"])


def test_exit_comes_after_the_cancel_and_before_the_transitions_actions(play: Play) -> None:
    """ "before the transition's own actions, after the Cancel of T's activity" """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A . B }
          control R {
            exit A  : / t.state.M.x = 1; write_messages.t.state.M; n = n + 1
            enter B : go / t.state.M.x = 2; write_messages.t.state.M; n = n * 10
          }
        }
    """).step()
    run.step(run.event("go"))
    assert [line.split()[0] for line in run.did] == ["cancel", "publish", "publish", "start"]
    assert run.variable("n") == 10


def test_exits_are_done_from_the_inside_outwards(play: Play) -> None:
    """ "innermost first" """
    run = play("""
        srm R {
          var n : int = 1
          liveness { R = outer [> Stop  outer = (inner || D) . E  inner = A . B }
          control R { enter Stop : go  exit outer : / n = n * 10 }
          control outer { exit inner : / n = n + 1  exit D : / n = n + 2 }
          control inner { exit A : / n = n * 5 }
        }
    """).step()
    run.step(run.event("go"))
    names = [run.plan.by_label[way.split(" -> ")[0]].name for way in run.taken]
    assert names == ["outer", "A", "inner", "D", "outer"]


def test_exit_of_an_inner_region_is_seen_outside_from_the_next_step(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 1
          liveness { R = (A || B) [> Stop }
          control R { enter Stop : go  exit B : / n = 7 }
        }
    """).step()
    run.step(run.event("go"))
    assert run.variable("n") == 7


def test_exit_is_done_when_the_agent_stops(play: Play) -> None:
    run = play(counting("exit A :", more="; t.state.M.x = 1; write_messages.t.state.M")).step()
    run.step(run.crashed("A"))
    assert run.last.failure is not None
    assert [line.split()[0] for line in run.did] == ["publish"]


def test_several_lines_are_done_in_order(play: Play) -> None:
    run = play(counting("exit A :", more="exit A : / n = n * 10")).step()
    run.step(run.done("A"))
    assert run.variable("n") == 10


def test_a_branch_is_left_after_what_its_role_does_on_exit(play: Play) -> None:
    text = """
        aip p {
          participant a {
            engage "Always." sends inform Note receives inform Note
            process = Ask . Give
          }
          participant b { engage "Always." sends inform Note receives inform Note process = Hear }
          outcome "Done."
          control a { exit Ask : / send inform Note to b }
        }
        srm R {
          plays p.a
          var n : int = 0
          liveness { R = a [> Stop }
          control R { enter Stop : go  exit a : / n = 1 }
        }
    """
    run = play(text).step()
    run.step(run.event("go"))
    assert [line.split()[0] for line in run.did] == ["cancel", "send", "part", "start"]
    assert run.variable("n") == 1


@pytest.mark.parametrize("times", [1, 2])
def test_instances_have_their_own(play: Play, times: int) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A[2] . B }
          control R { on A : go / n = n + 1 }
        }
    """).step()
    run.step(*[run.event("go")] * times)
    assert len(run.taken) == 2


def test_an_outcome_counts_when_it_is_another(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = (Grasp || B) . C }
          activities { Grasp ends held, slipped }
          control R { on (Grasp || B) : when [outcome(Grasp) == held] / n = n + 1 }
        }
    """).step()
    run.step(run.done("Grasp", outcome="held"))
    run.step(run.done("B"))
    assert run.variable("n") == 1


def test_a_fault_of_what_is_done_on_leaving_is_told_once(play: Play) -> None:
    """ "a fault is recorded once per transition and step", also when the agent stops in it"""
    run = play("""
        srm R {
          liveness { R = A || B~ }
          control R { repeat B : go  exit B : / t.state.M.x = t.data.M.x }
        }
    """).step()
    run.step(run.event("go"), run.crashed("A"))
    assert [line.split()[0] for line in run.did].count("fault") == 1
