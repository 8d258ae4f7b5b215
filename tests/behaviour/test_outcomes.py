"""Outcomes and deadlines of activities, and `error` at any depth (semantics, "Outcomes and deadlines")."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

CELL = """
    srm R {
      liveness { R = (Grasp . (Place | Again))~ }
      activities { Grasp ends held, slipped }
      control R {
        enter Place : [outcome(Grasp) == held]
        enter Again : [outcome(Grasp) != held]
      }
    }
"""


def end(run: Run, outcome: str, activity: str = "Grasp") -> Run:
    return run.step(run.done(activity, outcome=outcome))


@pytest.mark.parametrize(("outcome", "next_one"), [("held", "Place"), ("slipped", "Again")])
def test_an_outcome_decides(play: Play, outcome: str, next_one: str) -> None:
    """ "`outcome(Grasp) == held`: the name with which the activity has ended" """
    run = play(CELL).step()
    assert run.started == ["Grasp"]
    assert end(run, outcome).active == [next_one]


def test_an_outcome_is_absent_until_the_activity_has_ended(play: Play) -> None:
    """ "absent from the entry of such a state until it ends with an outcome": neither `==` nor `!=` holds"""
    run = play("""
        srm R {
          liveness { R = (Grasp || Watch) . Rest }
          activities { Grasp ends held, slipped }
          control R { enter Rest : when [outcome(Grasp) == held || outcome(Grasp) != held] }
        }
    """).step()
    assert run.step(run.done("Watch")).active[0] == "Grasp"
    run.step(run.done("Grasp", outcome="slipped"))
    assert run.active == ["Rest"]


def test_an_outcome_is_absent_again_when_the_state_is_entered_again(play: Play) -> None:
    """ "absent from the entry of such a state until it ends" """
    run = play("""
        srm R {
          liveness { R = Grasp+ . Rest }
          activities { Grasp ends held, slipped }
          control R {
            repeat Grasp : [outcome(Grasp) == slipped]
            leave Grasp : [outcome(Grasp) == held]
            enter Rest : when [outcome(Grasp) == slipped]
          }
        }
    """).step()
    assert end(run, "slipped").did == ["start Grasp"]
    assert run.step().active == ["Grasp"]


def test_an_outcome_stays_when_the_state_is_left(play: Play) -> None:
    """ "stays after the state is left" """
    run = play("""
        srm R {
          liveness { R = Grasp . Move . (Place | Again) }
          activities { Grasp ends held, slipped }
          control R { enter Place : [outcome(Grasp) == held]  enter Again : else }
        }
    """).step()
    end(run, "held")
    assert run.step(run.done("Move")).active == ["Place"]


def test_each_decides_by_what_was_done_before_it(play: Play) -> None:
    """ "of several states there, the one that ended or was entered last" """
    run = play("""
        srm R {
          liveness { R = first . second  first = Grasp . [A]  second = Grasp . [B] }
          activities { Grasp ends held, slipped }
          control first { enter A : [outcome(Grasp) == held]  skip A : else }
          control second { enter B : [outcome(Grasp) == held]  skip B : else }
        }
    """).step()
    end(run, "held")
    assert run.active == ["A"]
    run.step(run.done("A"))
    assert run.active == ["Grasp"]
    label = run.plan.by_label[run.chart.configuration()[0]].label
    run.step(run.done(label, outcome="slipped"))
    assert run.last.finished


def test_what_is_done_before_a_loop_decides_whether_it_is_entered(play: Play) -> None:
    """ "of several states there, the one that ended or was entered last": not the one inside the loop"""
    run = play("""
        srm R {
          liveness { R = Grasp . (Rest . Grasp)* }
          activities { Grasp ends held, slipped }
          control R {
            enter (Rest . Grasp) : [outcome(Grasp) == held]
            skip (Rest . Grasp) : else
            repeat (Rest . Grasp) : [outcome(Grasp) == held]
            leave (Rest . Grasp) : else
          }
        }
    """).step()
    end(run, "held")
    assert run.active == ["Rest"]
    run.step(run.done("Rest"))
    run.step(run.done(run.chart.configuration()[0], outcome="slipped"))
    assert run.last.finished


def test_two_regions_do_not_disturb_each_other(play: Play) -> None:
    """ "the innermost region around the transition in which something performs it" """
    run = play("""
        srm R {
          liveness { R = arm[2]  arm = Grasp . (Place | Open) }
          activities { Grasp ends held, slipped }
          control arm { enter Place : [outcome(Grasp) == held]  enter Open : else }
        }
    """).step()
    first, second = (run.plan.by_label[label].label for label in run.chart.configuration()[1:])
    run.step(run.done(first, outcome="held"))
    run.step(run.done(second, outcome="slipped"))
    assert run.active == ["Place", "Open"]


def test_of_several_states_the_one_that_ended_or_was_entered_last(play: Play) -> None:
    """ "of several states there, the one that ended or was entered last" """
    run = play("""
        srm R {
          liveness { R = Grasp . Grasp . Rest . Rest }
          activities { Grasp ends held, slipped }
          control R {
            enter Rest#1 : when [outcome(Grasp) == held]
            enter Rest#2 : [outcome(Grasp) == slipped]
          }
        }
    """).step()
    run.step(run.done("0.2", outcome="held"))
    assert run.active == ["Grasp"]  # the second one, which was entered last
    run.step(run.done("0.3", outcome="held"))
    assert run.active == ["Rest"]
    run.step(run.done("0.4"))
    assert run.active == ["Rest"] and run.taken == []


def test_an_outcome_of_another_region_is_seen_at_once(play: Play) -> None:
    """ "as of the moment of evaluation, other regions included" """
    run = play("""
        srm R {
          liveness { R = arm || (Wait . Go)  arm = Grasp . Rest }
          activities { Grasp ends held, slipped }
          control R { enter Go : when [outcome(Grasp) == held] }
        }
    """).step()
    assert end(run, "held").active == ["Rest", "Go"]


def test_a_participants_activity_that_the_role_has_bound_is_the_one_that_is_asked(play: Play) -> None:
    run = play("""
        aip hand_over {
          participant giver { process = Reach . [Let] }
          control giver { enter Let : [outcome(Reach) == there]  skip Let : else }
          outcome "Given."
        }
        srm R {
          plays hand_over.giver with Reach = Stretch
          liveness { R = giver }
          activities { Stretch ends there, short }
        }
        srm other { plays hand_over.giver  liveness { other = giver } activities { Reach ends there, short } }
    """).step()
    assert end(run, "there", "Stretch").active == ["Let"]


# ---- deadlines -----------------------------------------------------------------------------------

PATIENT = """
    srm R {
      liveness { R = Grasp . Place }
      activities { Grasp within 5s }
      control R { enter Place :  enter Place : error }
    }
"""


def test_past_its_deadline_an_activity_is_cancelled_and_its_state_fails(play: Play) -> None:
    """ "Past its deadline the activity is cancelled and its state has failed, in the same step." """
    run = play(PATIENT).step()
    assert run.due == 5000
    assert run.step(ms=4999).did == []
    assert run.step(ms=1).did == ["cancel Grasp", "start Place"]
    assert run.last.failure is None


def test_a_deadline_without_an_error_transition_stops_the_agent(play: Play) -> None:
    """ "otherwise the agent stops in a safe way and says where" """
    run = play("srm R { liveness { R = Grasp || Look } activities { Grasp within 5s } }").step()
    run.step(ms=5000)
    assert run.did == ["cancel Grasp", "cancel Look"]
    assert run.last.failure is not None and "not done within 5 s" in run.last.failure


def test_completion_at_the_same_instant_wins(play: Play) -> None:
    """ "Inputs come first: what completes at that instant has kept it." """
    run = play(PATIENT).step()
    assert run.step(run.done("Grasp"), ms=5000).did == ["start Place"]


def test_a_deadline_counts_from_each_entry_and_only_while_the_activity_runs(play: Play) -> None:
    """ "counted from the entry of the state" """
    run = play("""
        srm R {
          liveness { R = Grasp+ . Place }
          activities { Grasp within 5s }
          control R {
            repeat Grasp : again
            leave Grasp : [t.state.M.on]
            enter Place :
            enter Place : error
          }
        }
    """).step()
    run.step(run.event("again"), ms=3000)
    assert run.step(ms=4000).did == []
    run.step(run.done("Grasp"))
    assert run.due is None
    assert run.step(ms=9000).did == []


def test_a_late_result_is_dropped(play: Play) -> None:
    """ "it is told, and its late result is dropped" """
    run = play(PATIENT.replace("error", "error [t.state.M.on]")).step(ms=0)
    run.step(run.heard("t.state.M", on=True))
    late = run.done("Grasp")
    assert run.step(ms=5000).active == ["Place"]
    assert run.step(late).active == ["Place"]


def test_a_deadline_in_a_region(play: Play) -> None:
    """ "It bubbles outwards", out of a region of an AND, too."""
    run = play("""
        srm R {
          liveness { R = ((Grasp . Lift) || Look) . Place }
          activities { Grasp within 1s }
          control R { enter Place :  enter Place : error }
        }
    """).step()
    assert run.step(ms=1000).did == ["cancel Grasp", "cancel Look", "start Place"]


# ---- error at any depth --------------------------------------------------------------------------


def test_an_error_is_taken_by_the_nearest_at_any_depth(play: Play) -> None:
    """ "taken by the nearest `error` transition outwards", through states and regions that take none"""
    run = play("""
        srm R {
          liveness {
            R = outer . Home
            outer = (deep || Look) . Report
            deep = [middle] . D
            middle = (A . B)+
          }
          control R { enter Home :  enter Home : error }
          control deep { enter middle : [true]  skip middle : else }
        }
    """).step()
    assert run.active == ["A", "Look"]
    assert run.step(run.crashed("A")).did == ["cancel Look", "start Home"]
    assert run.last.failure is None


def test_the_nearest_is_in_the_region_where_there_is_one(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = outer . Home  outer = ((A . B) || Look) . Report }
          control R { enter Home :  enter Home : error }
          control outer { enter B :  enter B : error }
        }
    """).step()
    assert run.step(run.crashed("A")).active == ["B", "Look"]


def test_one_error_takes_failures_of_two_regions_at_once(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A || B || C) . Home }
          control R { enter Home :  enter Home : error }
        }
    """).step()
    run.step(run.crashed("A"), run.crashed("C"))
    assert run.did == ["cancel B", "start Home"]
    assert run.last.failure is None


def test_an_error_transition_with_a_condition_that_does_not_hold_lets_it_bubble(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = outer . Home  outer = A . B }
          control R { enter Home :  enter Home : error }
          control outer { enter B :  enter B : error [t.state.M.on] }
        }
    """).step()
    assert run.step(run.crashed("A")).active == ["Home"]


def test_a_loop_takes_the_error_of_its_body(play: Play) -> None:
    run = play("""
        srm R {
          var tries : int = 0
          liveness { R = (A . B)~ }
          control R { repeat (A . B) :  repeat (A . B) : error / tries = tries + 1 }
        }
    """).step()
    assert run.step(run.crashed("A")).did == ["start A"]
    assert run.variable("tries") == 1
