"""States and transitions: completion, conditions, events, scopes (semantics, "States" and "Transitions")."""

from __future__ import annotations

from tests.behaviour.conftest import Play


def test_the_first_activity_starts_with_the_first_step(play: Play) -> None:
    run = play("srm R { liveness { R = A . B } }").step()
    assert run.active == ["A"]
    assert run.did == ["start A"]
    assert run.taken == ["0.1 -> 0.2"]


def test_a_state_stays_complete_until_it_is_left(play: Play) -> None:
    """ "A state stays complete until it is left: completion is a fact, not an event that can be missed." """
    run = play("srm R { liveness { R = A . B } control R { enter B : [t.state.M.on] } }").step()
    assert run.step(run.done("A")).active == ["A"]
    assert run.step(run.heard("t.state.M", x=3), ms=10).active == ["A"]
    assert run.step(run.heard("t.state.M", on=True), ms=10).active == ["B"]


def test_a_condition_that_holds_first_waits_for_completion(play: Play) -> None:
    """ "the source is complete and `c` holds, now or later" """
    run = play("srm R { liveness { R = A . B } control R { enter B : [t.state.M.on] } }").step()
    assert run.step(run.heard("t.state.M", on=True)).active == ["A"]
    assert run.step(run.done("A")).did == ["start B"]


def test_an_or_is_complete_when_its_end_is_active(play: Play) -> None:
    """ "an OR when its END is active" """
    run = play("srm R { liveness { R = first . C  first = A . B } }").step()
    run.step(run.done("A"))
    assert run.active == ["B"]
    run.step(run.done("B"))
    assert run.taken == ["0.2.3 -> 0.2.4", "0.2 -> 0.3"]
    assert run.active == ["C"]


def test_an_and_is_complete_when_all_its_regions_are(play: Play) -> None:
    """ "an AND when all its regions are complete" """
    run = play("srm R { liveness { R = (A || B) . C } }").step()
    assert run.active == ["A", "B"]
    assert run.step(run.done("B")).active == ["A", "0.2.2.2.3"]
    assert run.step(run.done("A")).active == ["C"]


def test_a_region_without_end_never_completes(play: Play) -> None:
    """ "an AND when all its regions are complete (so one with an END-less region never is)" """
    text = "srm R { liveness { R = (A || B~) . C } control R { enter C : when [t.state.M.on] } }"
    run = play(text).step()
    run.step(run.done("A"), run.done("B"))
    assert run.started == ["B"]
    assert "C" not in run.active
    run.step(run.heard("t.state.M", on=True))
    assert run.did == ["cancel B", "start C"]


def test_the_end_of_the_root_finishes_the_agent(play: Play) -> None:
    """ "With the root's END active the agent has finished." """
    run = play("srm R { liveness { R = A } }").step()
    assert not run.last.finished
    assert run.step(run.done("A")).last.finished
    assert run.active == ["0.3"]


def test_a_finished_agent_does_nothing_more(play: Play) -> None:
    run = play("srm R { liveness { R = A } control R { leave A : go } }").step()
    run.step(run.event("go"))
    run.step(run.event("go"), run.heard("t.state.M"), ms=5)
    assert run.last.finished
    assert (run.did, run.taken, run.due) == ([], [], None)


def test_an_event_does_not_wait_for_completion(play: Play) -> None:
    """ "while the source is active, complete or not, when event `e` is there" """
    run = play("srm R { liveness { R = A . B } control R { enter B : go } }").step()
    assert run.step(run.event("go")).did == ["cancel A", "start B"]


def test_an_event_does_not_need_the_running_activity(play: Play) -> None:
    """ "complete or not" """
    run = play("srm R { liveness { R = A . B } control R { enter B : go } }").step()
    assert run.step(run.done("A")).active == ["A"]
    assert run.step(run.event("go")).did == ["start B"]


def test_completion_alone_does_not_take_an_event(play: Play) -> None:
    run = play("srm R { liveness { R = A . B } control R { enter B : go or after(1s) } }").step()
    assert run.step(run.done("A"), run.event("stop")).active == ["A"]


def test_an_event_with_a_condition_needs_both(play: Play) -> None:
    """ "when event `e` is there and `c` holds" """
    run = play("srm R { liveness { R = A . B } control R { enter B : go [t.state.M.on] } }").step()
    assert run.step(run.event("go")).active == ["A"]
    assert run.step(run.heard("t.state.M", on=True)).active == ["A"]
    assert run.step(run.event("go")).active == ["B"]


def test_one_of_several_events_is_enough(play: Play) -> None:
    """ "Events may be joined by `or`." """
    run = play("srm R { liveness { R = A . B } control R { enter B : go or after(10ms) or hop } }").step()
    assert run.step(run.event("hop")).active == ["B"]
    run = play("srm R { liveness { R = A . B } control R { enter B : go or after(10ms) or hop } }").step()
    assert run.step(ms=10).active == ["B"]


def test_when_leaves_as_soon_as_the_condition_holds(play: Play) -> None:
    """ "`when [c]`: while the source is active, complete or not, as soon as `c` holds" """
    run = play("srm R { liveness { R = A . B } control R { enter B : when [t.state.M.x > 3] } }").step()
    assert run.step(run.heard("t.state.M", x=3)).active == ["A"]
    assert run.step(run.heard("t.state.M", x=4)).did == ["cancel A", "start B"]


def test_after_counts_from_the_entry_of_its_source(play: Play) -> None:
    """ "once `d` has passed since the source was entered, complete or not" """
    run = play("srm R { liveness { R = A . B . C } control R { enter C : after(10ms) } }").step()
    run.step(run.done("A"), ms=7)
    assert run.due == 10
    assert run.step(run.done("B"), ms=9).active == ["B"]
    assert run.step(ms=1).active == ["C"]


def test_after_counts_anew_with_each_entry(play: Play) -> None:
    """ "since the source was entered" """
    text = "srm R { liveness { R = A+ } control R { repeat A : go  leave A : after(10ms) } }"
    run = play(text).step()
    run.step(run.event("go"), ms=9)
    assert run.step(ms=9).active == ["A"]
    assert run.step(ms=1).last.finished


def test_done_or_after_a_while(play: Play) -> None:
    """ "So `enter Verify :` and `enter Verify : after(10s)` together mean "when done, or after 10 s"." """
    text = "srm R { liveness { R = A . B } control R { enter B :  enter B : after(10s) } }"
    run = play(text).step()
    assert run.step(run.done("A")).did == ["start B"]
    run = play(text).step()
    assert run.step(ms=10_000).did == ["cancel A", "start B"]


CHOICE = """
srm R {
  liveness { R = A . (B | C) . D }
  control R {
    enter B : [t.state.M.on]
    enter C : else
  }
}
"""


def test_else_is_for_when_no_sibling_is_enabled(play: Play) -> None:
    """ "the source is complete and no sibling is enabled" """
    run = play(CHOICE).step()
    run.step(run.heard("t.state.M", on=False))
    assert run.step(run.done("A")).active == ["C"]
    run = play(CHOICE).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.step(run.done("A")).active == ["B"]


def test_for_else_an_absent_condition_counts_as_not_enabled(play: Play) -> None:
    """ "(an absent condition counts as not enabled)" """
    run = play(CHOICE).step()
    assert run.step(run.done("A")).active == ["C"]


def test_else_waits_for_completion(play: Play) -> None:
    """ "the source is complete and no sibling is enabled" """
    run = play("""
        srm R { liveness { R = A+ } control R { repeat A : when [t.state.M.on]  leave A : else } }
    """).step()
    assert run.step(run.heard("t.state.M", on=False)).active == ["A"]
    assert run.step(run.done("A")).last.finished


def test_start_and_choice_are_passed_in_one_go(play: Play) -> None:
    """ "START→CONDITION→X is one compound transition" """
    run = play("""
        srm R { liveness { R = A | B } control R { enter A : [t.state.M.on]  enter B : [!t.state.M.on] } }
    """)
    run.step(run.heard("t.state.M"))
    assert run.taken == ["0.1 -> 0.2 -> 0.4"]


def test_a_start_without_open_branch_waits(play: Play) -> None:
    """ "If no branch is open, the START stays active and waits." """
    run = play("""
        srm R { liveness { R = A | B }
        control R { enter A : [t.state.M.x == 1]  enter B : [t.state.M.x == 2] } }
    """).step()
    assert run.active == ["0.1"]
    assert run.step(run.heard("t.state.M", x=3)).active == ["0.1"]
    assert run.step(run.heard("t.state.M", x=1)).active == ["A"]


def test_conditions_of_a_compound_transition_come_before_its_actions(play: Play) -> None:
    """ "its conditions are all evaluated before any of its actions runs" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A | B }
          control R { start R : / v = 1  enter A : [v == 1]  enter B : [v == 0] / v = v + 10 }
        }
    """).step()
    assert run.active == ["B"]
    assert run.variable("v") == 11


def test_a_way_into_a_composite_is_seen_by_its_own_start(play: Play) -> None:
    """ "The actions of the way into a composite are seen by the conditions of that composite's own START,
    which is a compound transition of its own." """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . (B | C) }
          control R { enter (B | C) : / v = 1  enter B : [v == 1]  enter C : [v == 0] }
        }
    """).step()
    run.step(run.done("A"))
    assert run.active == ["B"]
    assert run.taken == ["0.2 -> 0.3", "0.3.1 -> 0.3.2 -> 0.3.3"]


def test_after_on_a_branch_counts_from_the_waiting_source(play: Play) -> None:
    """ "on a branch of a choice, since the waiting source was" """
    run = play("""
        srm R { liveness { R = A . [B] } control R { enter B : go  skip B : after(10ms) } }
    """).step()
    run.step(run.done("A"), ms=5)
    assert run.active == ["0.3.1"]
    assert run.due == 10
    assert run.step(ms=9).active == ["0.3.1"]
    assert run.step(ms=1).last.finished


def test_the_innermost_source_comes_first(play: Play) -> None:
    """ "Order: innermost source first" """
    run = play("""
        srm R {
          liveness { R = inner . C  inner = A . B }
          control R { enter C : when [t.state.M.on] }
          control inner { enter B : when [t.state.M.on] }
        }
    """).step()
    run.step(run.heard("t.state.M", on=True))
    assert run.did == ["cancel A", "start B", "cancel B", "start C"]
    assert run.taken == ["0.2.2 -> 0.2.3", "0.2 -> 0.3"]


def test_the_order_of_the_control_lines_decides(play: Play) -> None:
    """ "among the transitions of one source, the order of the `control` lines, then the template's" """
    run = play("""
        srm R {
          liveness { R = A . (B | C | D) }
          control R { enter C : [t.state.M.x > 1]  enter B : [t.state.M.x > 0]  enter D : [t.state.M.x == 0] }
        }
    """).step()
    run.step(run.heard("t.state.M", x=5), run.done("A"))
    assert run.active == ["C"]


def test_a_line_without_event_and_condition_comes_last(play: Play) -> None:
    """ "those with neither event nor condition, and `else`, last" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . B }
          control R { enter B : / v = 1  enter B : [t.state.M.on] / v = 2 }
        }
    """).step()
    run.step(run.heard("t.state.M", on=True), run.done("A"))
    assert run.variable("v") == 2


def test_a_self_transition_leaves_and_enters(play: Play) -> None:
    """ "A self-transition leaves and enters" """
    run = play("srm R { liveness { R = A~ } control R { repeat A : go } }").step()
    assert run.step(run.event("go")).did == ["cancel A", "start A"]


def test_a_completed_composite_starts_again_at_its_start(play: Play) -> None:
    """ "a completed OR starts again at its START" """
    run = play("srm R { liveness { R = (A . B)~ } }").step()
    run.step(run.done("A"))
    run.step(run.done("B"))
    assert run.did == ["start A"]


def test_a_composite_left_halfway_starts_again_at_its_start(play: Play) -> None:
    run = play("srm R { liveness { R = (A . B)~ } control R { repeat (A . B) : go } }").step()
    run.step(run.done("A"))
    assert run.step(run.event("go")).did == ["cancel B", "start A"]


def test_everything_inside_the_scope_is_left_innermost_first(play: Play) -> None:
    """ "Everything active inside the scope is left, innermost first; then the actions run; then the target is
    entered" """
    run = play("""
        srm R {
          liveness { R = (A || (B || C)) . D }
          control R { enter D : go / t.state.M.x = 1; write_messages.t.state.M }
        }
    """).step()
    run.step(run.event("go"))
    assert run.did == ["cancel A", "cancel B", "cancel C", "publish t.state.M {x=1}", "start D"]


def test_one_event_carries_a_region_through_one_guard(play: Play) -> None:
    """ "An event is spent by what takes it … So one message cannot carry a region through two equal
    guards" """
    run = play("srm R { liveness { R = A . B . C } control R { enter B : go  enter C : go } }").step()
    assert run.step(run.event("go")).active == ["B"]
    assert run.step(run.event("go")).active == ["C"]


def test_a_loop_on_an_event_settles(play: Play) -> None:
    """ "and a loop on an event settles" """
    run = play("srm R { liveness { R = A~ } control R { repeat A : go } }").step()
    run.step(run.event("go"))
    assert run.taken == ["0.2 -> 0.2"]
    assert run.last.failure is None


def test_every_region_can_take_an_event_once(play: Play) -> None:
    """ "an event raised is there for every region until the end of the step or until that region spends
    it" """
    run = play("""
        srm R { liveness { R = A~ || (B . C) } control R { repeat A : go  enter C : go } }
    """).step()
    run.step(run.event("go"))
    assert run.did == ["cancel A", "start A", "cancel B", "start C"]


def test_an_event_that_nobody_takes_is_gone(play: Play) -> None:
    """ "until the end of the step" """
    run = play("srm R { liveness { R = A . B . C } control R { enter C : go } }").step()
    run.step(run.event("go"))
    assert run.step(run.done("A")).active == ["B"]


def test_an_event_reaches_a_state_entered_in_the_same_step(play: Play) -> None:
    """ "Conditions of the whole step see this snapshot" """
    run = play("srm R { liveness { R = A . B . C } control R { enter C : go } }").step()
    run.step(run.done("A"), run.event("go"))
    assert run.did == ["start B", "cancel B", "start C"]


def test_an_option_is_entered_or_skipped(play: Play) -> None:
    text = "srm R { liveness { R = A . [B] . C } control R { enter B : [t.state.M.on]  skip B : else } }"
    run = play(text).step()
    run.step(run.done("A"))
    assert run.did == ["start C"]
    assert run.taken == ["0.2 -> 0.3", "0.3.1 -> 0.3.2 -> 0.3.4", "0.3 -> 0.4"]
    run = play(text).step()
    run.step(run.heard("t.state.M", on=True), run.done("A"))
    assert run.did == ["start B"]


def test_zero_or_more(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A . B* . C }
          control R {
            enter B : [t.state.M.x > 0]  skip B : else
            repeat B : [t.state.M.x > 1]  leave B : else
          }
        }
    """).step()
    run.step(run.heard("t.state.M", x=2), run.done("A"))
    assert run.did == ["start B"]
    assert run.step(run.done("B")).did == ["start B"]
    assert run.step(run.heard("t.state.M", x=1), run.done("B")).did == ["start C"]


def test_three_instances(play: Play) -> None:
    run = play("srm R { liveness { R = A[3] . B } }").step()
    assert run.did == ["start A", "start A", "start A"]
    labels = [start.label for start in run.last.effects]  # type: ignore[union-attr]
    run.step(*(run.done(label) for label in labels[:2]))
    assert run.did == []
    assert run.step(run.done(labels[2])).did == ["start B"]


def test_a_target_inside_a_composite_is_entered_through_it(play: Play) -> None:
    """ "then the target is entered, outermost first" """
    run = play("""
        statechart R {
          state 0 OR
          state 0.1 START
          state 0.2 BASIC A
          state 0.3 OR
          state 0.3.1 START
          state 0.3.2 BASIC B
          state 0.3.3 BASIC C
          0.1 -> 0.2 :
          0.2 -> 0.3.3 : go
          0.3 -> 0.2 : after(10ms)
          0.3.1 -> 0.3.2 :
          0.3.3 -> 0.3.2 :
        }
    """).step()
    run.step(run.event("go"), ms=3)
    assert run.did == ["cancel A", "start C"]
    assert run.due == 10
    run.step(run.done("C"), ms=5)
    assert run.step(ms=5).did == ["cancel B", "start A"]


def test_the_scope_is_the_lowest_or_that_holds_source_and_target(play: Play) -> None:
    """ "The scope of a transition is the lowest OR state that holds source and target." """
    run = play("""
        statechart R {
          var v : int = 0
          state 0 OR
          state 0.1 START
          state 0.2 OR
          state 0.2.1 START
          state 0.2.2 BASIC A
          state 0.2.3 BASIC B
          state 0.3 END
          0.1 -> 0.2 :
          0.2 -> 0.3 : after(10ms)
          0.2 -> 0.2.3 : hop
          0.2.1 -> 0.2.2 :
          0.2.2 -> 0.2.3 : go
        }
    """).step()
    run.step(run.event("go"), ms=9)
    assert run.due == 1  # 0.2 was not left
    run.step(run.event("hop"))
    assert run.did == ["cancel B", "start B"]
    assert run.due == 10  # 0.2 was left and entered


def test_a_way_through_an_outer_choice_leaves_what_is_inside(play: Play) -> None:
    """ "START→CONDITION→X is one compound transition"; "Everything active inside the scope is left" """
    run = play("""
        statechart R {
          state 0 OR
          state 0.1 START
          state 0.2 OR
          state 0.2.1 START
          state 0.2.2 BASIC A
          state 0.2.3 BASIC B
          state 0.3 CONDITION
          state 0.4 BASIC C
          0.1 -> 0.2 :
          0.2 -> 0.4 : after(10ms)
          0.2.1 -> 0.2.2 :
          0.2.2 -> 0.3 : go
          0.3 -> 0.2.3 : [t.state.M.on]
          0.3 -> 0.4 : else
        }
    """).step()
    run.step(run.heard("t.state.M", on=True), run.event("go"), ms=9)
    assert run.taken == ["0.2.2 -> 0.3 -> 0.2.3"]
    assert run.did == ["cancel A", "start B"]
    assert run.due == 10


def test_a_choice_without_a_way_out_is_never_entered(play: Play) -> None:
    """ "If the target is a CONDITION, one of its outgoing branches must be enabled too (recursively)" """
    run = play("""
        statechart R {
          state 0 OR
          state 0.1 START
          state 0.2 BASIC A
          state 0.3 CONDITION
          state 0.4 BASIC B
          0.1 -> 0.2 :
          0.2 -> 0.3 : go
          0.2 -> 0.4 : go or hop
        }
    """).step()
    run.step(run.event("go"))
    assert run.active == ["B"]


def test_a_choice_that_leads_to_a_choice(play: Play) -> None:
    """ "one of its outgoing branches must be enabled too (recursively)" """
    run = play("""
        statechart R {
          state 0 OR
          state 0.1 START
          state 0.2 BASIC A
          state 0.3 CONDITION
          state 0.4 CONDITION
          state 0.5 BASIC B
          state 0.6 BASIC C
          0.1 -> 0.2 :
          0.2 -> 0.3 : go
          0.3 -> 0.4 : [t.state.M.x > 0]
          0.3 -> 0.6 : else
          0.4 -> 0.5 : [t.state.M.x > 1]
          0.4 -> 0.6 : [t.state.M.x > 2]
        }
    """).step()
    run.step(run.heard("t.state.M", x=1), run.event("go"))
    assert run.taken == ["0.2 -> 0.3 -> 0.6"]
    run = play("""
        statechart R {
          state 0 OR
          state 0.1 START
          state 0.2 BASIC A
          state 0.3 CONDITION
          state 0.4 CONDITION
          state 0.5 BASIC B
          0.1 -> 0.2 :
          0.2 -> 0.3 : when [t.state.M.on]
          0.3 -> 0.4 : [t.state.M.x > 0]
          0.3 -> 0.2 : [t.state.M.x < 0]
          0.4 -> 0.5 : go
          0.4 -> 0.2 : [t.state.M.x > 2]
        }
    """).step()
    run.step(run.heard("t.state.M", x=1, on=True))
    assert run.active == ["A"]
    assert run.step(run.event("go")).taken == ["0.2 -> 0.3 -> 0.4 -> 0.5"]
