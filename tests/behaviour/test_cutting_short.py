"""`A [> B`: what cuts another short (semantics, "Transitions")."""

from __future__ import annotations

from tests.behaviour.conftest import Play

CELL = """
srm R {
  liveness { R = work [> Stop  work = A . B }
  control R { enter Stop : when [t.state.M.on]  leave work : [t.state.M.x == 1] }
}
"""


def test_it_cuts_short_whatever_is_active(play: Play) -> None:
    """ "It is tried before anything inside" """
    run = play(CELL).step()
    run.step(run.done("A"))
    run.step(run.done("B"), run.heard("t.state.M", on=True))
    assert run.taken == ["0.2 -> 0.3"]
    assert run.did == ["start Stop"]


def test_an_activity_that_runs_is_cancelled(play: Play) -> None:
    run = play(CELL).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.did == ["cancel A", "start Stop"]


def test_without_it_the_first_part_is_left_when_it_is_complete(play: Play) -> None:
    run = play(CELL).step()
    run.step(run.done("A"))
    run.step(run.done("B"))
    assert run.active == ["0.2.4"]
    run.step(run.heard("t.state.M", x=1))
    assert run.last.finished


def test_it_comes_before_the_way_on_of_what_is_complete(play: Play) -> None:
    run = play(CELL).step()
    run.step(run.done("A"))
    run.step(run.done("B"))
    run.step(run.heard("t.state.M", x=1, on=True))
    assert run.active == ["Stop"]


def test_what_cuts_short_is_not_cut_by_its_own_condition(play: Play) -> None:
    run = play(CELL).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.step(ms=5).taken == []
    assert run.step(run.done("Stop")).last.finished


def test_it_cuts_all_regions_short(play: Play) -> None:
    run = play("""
        srm R { liveness { R = (A~ || B) [> Stop } control R { enter Stop : go } }
    """).step()
    run.step(run.event("go"), run.done("B"))
    assert run.did == ["cancel A", "start Stop"]
    assert run.taken == ["0.2 -> 0.3"]


def test_the_outermost_is_tried_first(play: Play) -> None:
    """ "the outermost first" """
    run = play("""
        srm R {
          liveness { R = (inner || C) [> Stop  inner = A [> Pause }
          control R { enter Stop : go }
          control inner { enter Pause : go or hop }
        }
    """).step()
    assert run.step(run.event("hop")).active == ["Pause", "C"]
    run = play("""
        srm R {
          liveness { R = (inner || C) [> Stop  inner = A [> Pause }
          control R { enter Stop : go }
          control inner { enter Pause : go or hop }
        }
    """).step()
    assert run.step(run.event("go")).active == ["Stop"]


def test_it_is_tried_before_the_transitions_of_regions(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A . B || C) [> Stop }
          control R { enter B : go  enter Stop : go }
        }
    """).step()
    run.step(run.event("go"))
    assert run.taken == ["0.2 -> 0.3"]


def test_of_several_each_can_cut_what_is_before_it(play: Play) -> None:
    """ "`A [> B [> C` is `(A [> B) [> C`" """
    text = "srm R { liveness { R = A [> B [> C } control R { enter B : go  enter C : hop } }"
    run = play(text).step()
    assert run.step(run.event("go")).active == ["B"]
    assert run.step(run.event("hop")).did == ["cancel B", "start C"]
    run = play(text).step()
    assert run.step(run.event("go"), run.event("hop")).active == ["C"]


def test_a_time_limit_may_cut_short(play: Play) -> None:
    run = play("srm R { liveness { R = (A . B) [> Stop } control R { enter Stop : after(10ms) } }").step()
    run.step(run.done("A"), ms=4)
    assert run.due == 6
    assert run.step(ms=6).active == ["Stop"]


def test_errors_are_taken_where_they_are_nearest(play: Play) -> None:
    """ "The nearest `error` transition outwards is taken", also where one cuts short on `error`."""
    text = """
        srm R {
          liveness { R = work [> Stop  work = A . B }
          control R { enter Stop : error }
          control work { enter B : error [t.state.M.on]  enter B : }
        }
    """
    run = play(text).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.step(run.crashed("A")).active == ["B"]
    assert run.step(run.crashed("B")).active == ["Stop"]


def test_nothing_said_means_never(play: Play) -> None:
    run = play("srm R { liveness { R = A [> Stop } }").step()
    assert run.step(run.done("A")).last.finished


def test_a_loop_around_it_begins_again(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A [> Stop)~ }
          control R { enter Stop : go }
        }
    """).step()
    run.step(run.event("go"))
    assert run.step(run.done("Stop")).active == ["A"]


def test_a_protocol_may_cut_its_own_process_short(play: Play) -> None:
    run = play("""
        aip p {
          participant a { engage "Always." sends inform Note receives inform Note process = Ask [> Give }
          participant b { engage "Always." sends inform Note receives inform Note process = Hear }
          outcome "Done."
          control a { enter Give : inform Note from b }
        }
        srm R { plays p.a  liveness { R = a } }
    """).step()
    run.step(run.mail("inform", "Note"))
    assert run.did[-2:] == ["cancel Ask", "start Give"]


MENDED = """
    srm R {
      liveness { R = work [> Stop  work = inner || S  inner = A . Mend }
      control R { enter Stop : error }
      control inner { enter Mend : error }
    }
"""


def test_of_two_failures_the_inner_error_transition_comes_before_the_one_that_cuts_short(play: Play) -> None:
    """ "If two activities fail in one step, the inner `error` transition is tried first." """
    run = play(MENDED).step()
    run.step(run.crashed("S"), run.crashed("A"))
    assert run.did == ["start Mend", "cancel Mend", "start Stop"]


def test_a_failure_beside_an_inner_error_transition_goes_outwards(play: Play) -> None:
    run = play(MENDED).step()
    assert run.step(run.crashed("S")).active == ["Stop"]


def test_a_failure_that_is_mended_inside_does_not_go_outwards(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = ((work [> Halt) [> Stop)  work = inner || S  inner = A . Mend }
          control R { enter Stop : error  enter Halt : error }
          control inner { enter Mend : error }
        }
    """).step()
    assert run.step(run.crashed("A")).active == ["Mend", "S"]
    assert run.step(run.crashed("Mend")).active == ["Halt"]
    assert run.step(run.crashed("Halt")).active == ["Stop"]


def test_of_two_that_cut_short_on_errors_the_inner_one_is_nearer(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A || B) [> Halt [> Stop }
          control R { enter Stop : error  enter Halt : error }
        }
    """).step()
    assert run.step(run.crashed("A"), run.crashed("B")).active == ["Halt"]


def test_an_error_beside_another_event_takes_its_turn(play: Play) -> None:
    """ "The nearest `error` transition outwards is taken"; the other event comes before anything inside."""
    text = """
        srm R {
          liveness { R = work [> Stop  work = A . B . C }
          control R { enter Stop : error or go }
          control work { enter B : error  enter B :  enter C : go  enter C : }
        }
    """
    run = play(text).step()
    run.step(run.crashed("A"))
    assert run.active == ["B"]
    run.step(run.event("go"))
    assert run.active == ["Stop"]
    run = play(text).step()
    run.step(run.done("A"))
    run.step(run.crashed("B"))
    assert run.active == ["Stop"], "nothing inside takes this one"


SHOP = """
srm R {
  liveness { R = (Sell . Give) [> (Refund | Alarm) }
  control R { enter Alarm : bell  enter Refund : coin  enter Refund : when [t.state.M.on] }
}
"""


def test_each_branch_of_a_choice_interrupts_by_its_own_trigger(play: Play) -> None:
    run = play(SHOP).step()
    run.step(run.event("coin"))
    assert run.did == ["cancel Sell", "start Refund"] and run.taken == ["0.2 -> 0.3"]
    run = play(SHOP).step()
    run.step(run.done("Sell"))
    run.step(run.event("bell"))
    assert run.did == ["cancel Give", "start Alarm"] and run.taken == ["0.2 -> 0.4"]


def test_branches_that_interrupt_are_tried_in_the_order_of_their_lines(play: Play) -> None:
    run = play(SHOP).step()
    run.step(run.event("coin"), run.event("bell"), run.heard("t.state.M", on=True))
    assert run.active == ["Alarm"]


def test_a_choice_that_a_line_names_interrupts_as_a_whole(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = Sell [> (Refund | Alarm) }
          control R { enter (Refund | Alarm) : stop  enter Alarm : [t.state.M.on]  enter Refund : else }
        }
    """).step()
    run.step(run.event("stop"))
    assert run.did == ["cancel Sell", "start Refund"] and run.taken[0] == "0.2 -> 0.3"
