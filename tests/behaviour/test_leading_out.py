"""A transition from inside an AND out of it (semantics, "Transitions", "Steps"; language, `control`)."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.test_conversations import PROTOCOL
from tests.behaviour.test_waking import settled

AND = """
    statechart R {
      var n : int = 0
      state 0 OR  state 0.1 START  state 0.5 BASIC E  state 0.9 END
      state 0.2 AND
      state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A  state 0.2.1.3 BASIC A2  state 0.2.1.4 END
      state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC B  state 0.2.2.3 BASIC B2  state 0.2.2.4 END
      0.1 -> 0.2 :  0.2.1.1 -> 0.2.1.2 :  0.2.2.1 -> 0.2.2.2 :
      0.2.1.3 -> 0.2.1.4 :  0.2.2.3 -> 0.2.2.4 :
      0.2 -> 0.9 :  0.5 -> 0.9 :
"""


def test_all_regions_are_left_and_their_activities_cancelled(play: Play) -> None:
    """ "One that leads out of the AND leaves all its regions"; "innermost first" """
    run = play(AND + "0.2.2.2 -> 0.5 : e }").step()
    assert run.active == ["A", "B"]
    run.step(run.event("e"))
    assert run.active == ["E"]
    assert run.did == ["cancel A", "cancel B", "start E"]


def test_it_waits_for_the_completion_of_its_source_alone(play: Play) -> None:
    run = play(AND + "0.2.1.2 -> 0.5 : }").step()
    run.step(run.done("B"))
    assert run.active == ["A", "B"]
    run.step(run.done("A"))
    assert run.active == ["E"]


def test_a_region_that_is_complete_may_lead_out(play: Play) -> None:
    """ "an OR when its END is active": the first of the regions that is complete ends the AND."""
    run = play(AND + "0.2.1.2 -> 0.2.1.4 :  0.2.1 -> 0.5 : }").step()
    run.step(run.done("A"))
    assert run.active == ["E"]
    assert run.taken == ["0.2.1.2 -> 0.2.1.4", "0.2.1 -> 0.5"]


def test_of_two_regions_that_want_to_leave_the_first_does(play: Play) -> None:
    """ "of two regions that want to leave in one step, the first in document order does" """
    run = play(AND + "0.2.2.2 -> 0.9 : e  0.2.1.2 -> 0.5 : e }").step()
    run.step(run.event("e"))
    assert run.taken == ["0.2.1.2 -> 0.5"]
    assert run.active == ["E"]


def test_a_later_region_does_not_move_any_more(play: Play) -> None:
    run = play(AND + "0.2.1.2 -> 0.5 : e  0.2.2.2 -> 0.2.2.3 : e / n = 7 }").step()
    settled(run.step(run.event("e")))
    assert run.active == ["E"]
    assert run.variable("n") == 0


def test_an_earlier_region_has_moved_already(play: Play) -> None:
    """ "Each region, in document order, takes at most one transition" """
    run = play(AND + "0.2.1.2 -> 0.2.1.3 : e / n = 7  0.2.2.2 -> 0.5 : e }").step()
    run.step(run.event("e"))
    assert run.did == ["cancel A", "start A2", "cancel A2", "cancel B", "start E"]
    assert settled(run).variable("n") == 7


def test_a_state_around_does_not_move_in_the_same_round(play: Play) -> None:
    """ "a transition of an enclosing state is taken only if no region inside it moved" """
    run = play(AND + "0.2.1.2 -> 0.5 : e / n = 1  0.2 -> 0.9 : e / n = 2 }").step()
    settled(run.step(run.event("e")))
    assert run.active == ["E"]
    assert run.variable("n") == 1


def test_the_event_is_spent_for_the_regions_around(play: Play) -> None:
    """ "consumed at once, for its region and for every region around it" """
    run = play(AND + "0.2.1.2 -> 0.5 : e  0.5 -> 0.9 : e }").step()
    run.step(run.event("e"))
    assert run.active == ["E"]
    run.step(run.event("e"))
    assert run.last.finished


def test_an_and_that_is_entered_anew_does_not_move_in_the_same_round(play: Play) -> None:
    """ "regions that are entered during the step do not see it" """
    run = play(AND + "0.2.1.2 -> 0.2 : e  0.2.2.2 -> 0.2.2.3 : e }").step()
    run.step(run.event("e"))
    assert run.active == ["A", "B"]
    assert run.did == ["cancel A", "cancel B", "start A", "start B"]


def test_what_it_writes_is_seen_at_once_where_it_leads(play: Play) -> None:
    run = play(
        AND
        + """
      state 0.6 OR  state 0.6.1 START  state 0.6.2 CONDITION  state 0.6.3 BASIC F  state 0.6.4 BASIC G
      state 0.6.5 END  0.6.1 -> 0.6.2 :  0.6.2 -> 0.6.3 : [n == 3]  0.6.2 -> 0.6.4 : else
      0.6.3 -> 0.6.5 :  0.6.4 -> 0.6.5 :  0.6 -> 0.9 :
      0.2.2.2 -> 0.6 : e / n = 2; n = n + 1 }"""
    ).step()
    run.step(run.event("e"))
    assert run.active == ["F"]
    assert run.variable("n") == 3


def test_a_timer_that_it_starts_goes_on(play: Play) -> None:
    run = play(AND + "0.2.1.2 -> 0.5 : e / start_timer(t, 5ms)  0.5 -> 0.9 : when [expired(t)] }").step()
    run.step(run.event("e"))
    assert run.due == 5
    assert run.step(ms=5).last.finished


def test_its_condition_and_values_are_those_of_its_region(play: Play) -> None:
    """ "Conditions, actions and activities use the innermost region around them"; what it took is consumed"""
    run = play(
        AND
        + """state 0.6 BASIC F  0.6 -> 0.9 : [t.signal.M.x > 0]
      0.2.1.2 -> 0.6 : when [t.signal.M.x > 0] / n = t.signal.M.x }"""
    ).step()
    run.step(run.heard("t.signal.M", x=4))
    assert run.active == ["F"]
    assert settled(run).variable("n") == 4
    assert run.step(run.done("F")).active == ["F"]


def test_what_it_publishes_is_seen_at_once_around(play: Play) -> None:
    run = play(
        AND
        + """0.5 -> 0.9 : when [t.state.M.x == 5]
      0.2.1.2 -> 0.5 : e / t.state.M.x = 5; write_messages.t.state.M }"""
    ).step()
    run.step(run.event("e"))
    assert run.last.finished


def test_what_is_done_on_leaving_comes_before_its_actions(play: Play) -> None:
    run = play(
        AND
        + """0.2.1.2 -> 0.5 : e / n = 10; write_messages.t.signal.M
      exit 0.2.2.2 : / write_messages.t.state.M  exit 0.2.2 : / write_messages.t.data.M
      exit 0.2 : / write_messages.q.signal.M }"""
    ).step()
    run.step(run.event("e"))
    published = [line.split(" ")[1] for line in run.did if line.startswith("publish")]
    assert published == ["t.state.M", "t.data.M", "q.signal.M", "t.signal.M"]


def test_an_error_inside_a_region_may_lead_out(play: Play) -> None:
    run = play(AND + "0.2.1 -> 0.5 : error }").step()
    run.step(run.crashed("A"))
    assert run.active == ["E"]


def test_on_of_a_region_is_done_while_its_and_is_active(play: Play) -> None:
    run = play(AND + "on 0.2.2 : e / n = n + 1 }").step()
    settled(run.step(run.event("e")))
    settled(run.step(run.event("e")))
    assert run.variable("n") == 2
    assert run.active == ["A", "B"]


NESTED = """
    statechart R {
      var n : int = 0
      state 0 OR  state 0.1 START  state 0.5 BASIC E  state 0.9 END
      state 0.2 AND
      state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.3 BASIC C
      state 0.2.1.2 AND
      state 0.2.1.2.1 OR  state 0.2.1.2.1.1 START  state 0.2.1.2.1.2 BASIC A
      state 0.2.1.2.2 OR  state 0.2.1.2.2.1 START  state 0.2.1.2.2.2 BASIC B  state 0.2.1.2.2.3 BASIC B2
      state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC D  state 0.2.2.3 BASIC D2
      0.1 -> 0.2 :  0.2.1.1 -> 0.2.1.2 :  0.2.1.2.1.1 -> 0.2.1.2.1.2 :  0.2.1.2.2.1 -> 0.2.1.2.2.2 :
      0.2.2.1 -> 0.2.2.2 :  0.2.2.2 -> 0.2.2.3 : e / n = n + 1
      0.2 -> 0.9 : after(9s)  0.5 -> 0.9 :  0.2.1.3 -> 0.2.1.3 : after(9s)
      0.2.1.2.2.2 -> 0.2.1.2.2.3 : e
"""


def test_out_of_the_inner_and_the_outer_one_goes_on(play: Play) -> None:
    run = play(NESTED + "0.2.1.2.1.2 -> 0.2.1.3 : e }").step()
    run.step(run.event("e"))
    assert run.active == ["C", "D2"]
    assert run.did == ["cancel A", "cancel B", "start C", "cancel D", "start D2"]


def test_out_of_both_nothing_else_moves(play: Play) -> None:
    run = play(NESTED + "0.2.1.2.1.2 -> 0.5 : e }").step()
    settled(run.step(run.event("e")))
    assert run.active == ["E"]
    assert run.variable("n") == 0


def test_into_another_and(play: Play) -> None:
    """What leads from inside one AND to another one enters all regions of that."""
    run = play(
        AND
        + """state 0.7 AND  state 0.7.1 OR  state 0.7.1.1 START  state 0.7.1.2 BASIC F
      state 0.7.2 OR  state 0.7.2.1 START  state 0.7.2.2 BASIC G
      0.7.1.1 -> 0.7.1.2 :  0.7.2.1 -> 0.7.2.2 : [n == 1]  0.7 -> 0.9 : after(9s)
      0.2.2.2 -> 0.7 : e / n = 1 }"""
    ).step()
    run.step(run.event("e"))
    assert run.active == ["F", "G"]


def test_a_part_beside_it_is_left_in_another_way_than_by_its_end(play: Play) -> None:
    """ "If it is left in any other way (an outer transition, …)": its conversation is given up."""
    run = play(
        PROTOCOL
        + """srm R { plays p.a  liveness { R = (W || a) . D }
          control R { 0.2.2.1.2 -> 0.3 : e } }"""
    ).step()
    branch = run.plan.branches[0].label
    assert sorted(run.active) == ["A", "W"]
    run.step(run.event("e"), run.mail("inform", "Note"))
    assert run.active == ["D"]
    assert run.did[-4:] == ["cancel W", "cancel A", f"part {branch}", "start D"]


def test_a_state_around_remembers_where_its_and_was(play: Play) -> None:
    """ "T continues in the configuration in which it was last cut short" """
    run = play("""
        srm R {
          liveness { R = (shift | Charge)+  shift = A . ((B1 . B2) || C) }
          control R {
            resume shift : [!has(t.state.M)]
            enter Charge : else
            repeat (shift | Charge) :
            leave (shift | Charge) : halt
            0.2.3.3.2.1.2.3 -> 0.2.4 : e
          }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.done("B1"))
    assert sorted(run.active) == ["B2", "C"]
    run.step(run.event("e"))
    assert run.active == ["Charge"]
    run.step(run.done("Charge"))
    assert sorted(run.active) == ["B2", "C"]


def test_regions_that_are_entered_anew_start_with_the_copy_around(play: Play) -> None:
    """ "elsewhere from the next step": what one of the regions wrote before is not seen around yet."""
    run = play("""
        statechart R {
          var n : int = 0
          state 0 OR  state 0.1 START  state 0.9 END
          state 0.2 AND
          state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A  state 0.2.1.3 OR  state 0.2.1.3.1 START
          state 0.2.1.4 BASIC B
          state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC C
          0.1 -> 0.2 :  0.2 -> 0.9 : after(9s)  0.2.2.1 -> 0.2.2.2 :
          0.2.1.1 -> 0.2.1.2 : [n == 0]  0.2.1.1 -> 0.2.1.4 : else
          0.2.1.2 -> 0.2.1.3 : e / n = 1
          0.2.1.3.1 -> 0.2 : [n == 1]
          0.2.1.4 -> 0.2 : after(1s)
        }
    """).step()
    run.step(run.event("e"))
    assert run.active == ["A", "C"]
    assert settled(run).variable("n") == 1


def test_into_a_region_the_others_are_entered_at_their_starts(play: Play) -> None:
    """ "outermost first" """
    run = play(AND + "0.5 -> 0.2.2.3 : e / n = n + 1  0.2.1.2 -> 0.5 : e }").step()
    run.step(run.event("e"))
    assert run.active == ["E"]
    run.step(run.event("e"))
    assert run.active == ["A", "B2"]
    assert sorted(run.did) == ["cancel E", "start A", "start B2"]
    assert run.variable("n") == 1


def test_from_an_and_into_one_of_its_regions(play: Play) -> None:
    run = play(AND + "0.2 -> 0.2.1.3 : e }").step()
    run.step(run.event("e"))
    assert run.active == ["A2", "B"]
    assert sorted(run.did) == ["cancel A", "cancel B", "start A2", "start B"]


def test_deep_into_an_and_in_another(play: Play) -> None:
    run = play(NESTED + "0.5 -> 0.2.1.2.2.3 : e  0.2.2.2 -> 0.5 : f / n = 1 }").step()
    run.step(run.event("f"))
    assert run.active == ["E"]
    run.step(run.event("e"))
    assert run.active == ["A", "B2", "D"]
    assert run.variable("n") == 1
