"""Blackboards: states, data, signals, drafts, publishing (semantics, "Blackboards and messages")."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play


def test_a_state_keeps_the_latest_value_of_any_sender(play: Play) -> None:
    """ "`state`: the latest value of each sender (and of any)" """
    run = play("srm R { liveness { R = A . B } control R { enter B : when [t.state.M.x == 3] } }").step()
    run.step(run.heard("t.state.M", "ann", x=3), run.heard("t.state.M", "bob", x=4))
    assert run.active == ["A"]
    assert run.step(run.heard("t.state.M", "ann", x=3)).active == ["B"]


def test_a_state_keeps_the_latest_value_of_each_sender(play: Play) -> None:
    """ "`state`: the latest value of each sender (and of any)" """
    run = play("""
        srm R { liveness { R = A . B }
        control R { enter B : when [ann.t.state.M.x == 3 && bob.t.state.M.x == 4] } }
    """).step()
    run.step(run.heard("t.state.M", "ann", x=3))
    assert run.active == ["A"]
    assert run.step(run.heard("t.state.M", "bob", x=4), run.heard("t.state.M", "eve", x=5)).active == ["B"]


def test_data_is_ordered_by_its_time_of_measurement(play: Play) -> None:
    """ "`data`: values with their time of measurement" """
    run = play("srm R { liveness { R = A . B } control R { enter B : when [t.data.M.x == 1] } }").step()
    run.step(run.heard("t.data.M", x=2, ms_ago=1), run.heard("t.data.M", x=1, ms_ago=2))
    assert run.active == ["A"]
    assert run.step(run.heard("t.data.M", x=1)).active == ["B"]


def test_data_of_one_sender(play: Play) -> None:
    """ "`data`: values with their time of measurement, kept as long as the longest history that the program
    asks for" """
    run = play("""
        srm R { liveness { R = A . B } control R { enter B : when [ann.t.data.M.x == 1 && t.data.M.x == 2] } }
    """).step()
    run.step(run.heard("t.data.M", "ann", x=1, ms_ago=2), run.heard("t.data.M", "bob", x=2, ms_ago=1))
    assert run.active == ["B"]


def test_looking_back(play: Play) -> None:
    """ "`at(x, -d)` = newest value whose time ≤ now - d, else absent." """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . B~ }
          control R { enter B : / v = at(t.data.M.x, -20ms)  repeat B : go / v = at(t.data.M.x, -20ms) }
        }
    """).step()
    run.step(run.heard("t.data.M", x=1, ms_ago=5), run.done("A"))
    assert (run.variable("v"), run.did) == (0, ["fault 0.2 -> 0.3", "start B"])
    run.step(run.heard("t.data.M", x=2), ms=10)
    run.step(run.event("go"), ms=5)
    assert run.variable("v") == 1
    run.step(run.event("go"), ms=15)
    assert run.variable("v") == 2


def test_the_mean_over_a_window(play: Play) -> None:
    """ "`mean(x.m, w)` = mean over values with time ≥ now - w, absent if none." """
    run = play("""
        srm R {
          var v : double = 0
          liveness { R = A~ }
          control R { repeat A : go / v = mean(t.data.M.x, 20ms) }
        }
    """).step()
    run.step(run.heard("t.data.M", x=1, ms_ago=5), run.heard("t.data.M", x=4))
    run.step(run.event("go"), ms=15)
    assert run.variable("v") == 2.5
    run.step(run.event("go"), ms=1)
    assert run.variable("v") == 4
    run.step(run.event("go"), ms=10)
    assert run.variable("v") == 4
    assert "fault 0.2.2 -> 0.2.2" in run.did or "fault 0.2 -> 0.2" in run.did


TWO_READERS = """
srm R {
  liveness { R = first~ || second~  first = A . B  second = C . D }
  control first { enter B : [t.signal.M.on] }
  control second { enter D : [t.signal.M.on] }
}
"""


def test_each_region_has_its_own_copy_of_a_signal(play: Play) -> None:
    """ "`signal`: each region that reads it has its own copy" """
    run = play(TWO_READERS).step()
    run.step(run.done("A"), run.heard("t.signal.M", on=True))
    assert run.active == ["B", "C"]
    assert run.step(run.done("C")).active == ["B", "D"]


def test_a_signal_waits_until_it_is_looked_at(play: Play) -> None:
    """ "it goes at the end of the first step in which a condition that names it was evaluated" """
    run = play("srm R { liveness { R = A . B } control R { enter B : [t.signal.M.on] } }").step()
    run.step(run.heard("t.signal.M", on=True))
    run.step(ms=50)
    assert run.step(run.done("A"), ms=50).active == ["B"]


def test_a_signal_that_was_looked_at_is_gone(play: Play) -> None:
    """ "whatever the outcome" """
    run = play("""
        srm R { liveness { R = A . B } control R { enter B : [t.state.M.on && t.signal.M.on] } }
    """).step()
    run.step(run.heard("t.signal.M", on=True), run.done("A"))
    assert run.step(run.heard("t.state.M", on=True)).active == ["A"]
    assert run.step(run.heard("t.signal.M", on=True)).active == ["B"]


def test_a_signal_can_be_looked_at_in_the_whole_step(play: Play) -> None:
    """ "it goes at the end of the first step" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : / read_messages  enter B : [t.signal.M.x == 1]
          enter C : when [t.signal.M.x == 2] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=2), run.done("A"))
    assert run.did == ["start B", "cancel B", "start C"]


def test_a_signal_is_consumed_by_the_transition_that_asked_for_it(play: Play) -> None:
    """ "a signal that a taken transition was triggered by, or asked for, is consumed for its region at
    once" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : when [t.signal.M.on]  enter C : when [t.signal.M.on] }
        }
    """).step()
    assert run.step(run.heard("t.signal.M", on=True)).active == ["B"]
    assert run.step(run.heard("t.signal.M", on=True)).active == ["C"]


def test_a_signal_is_consumed_by_the_action_that_reads_it(play: Play) -> None:
    """ "or asked for" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . B . C }
          control R { enter B : go / v = t.signal.M.x  enter C : when [has(t.signal.M)] }
        }
    """).step()
    run.step(run.heard("t.signal.M", x=4), run.event("go"))
    assert run.active == ["B"]
    assert run.variable("v") == 4


def test_the_first_queued_signal_is_consumed_and_the_next_one_seen(play: Play) -> None:
    """ "consumed … at once"; "the one that was seen" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : when [q.signal.M.x == 1]  enter C : when [q.signal.M.x == 2] }
        }
    """).step()
    run.step(run.heard("q.signal.M", x=1), run.heard("q.signal.M", x=2))
    assert run.active == ["C"]
    assert not run.last.again


def test_a_newer_signal_replaces_an_unread_one_of_the_same_sender(play: Play) -> None:
    """ "a newer one of the same sender, topic and type replaces an unread one unless the topic says
    `queued`" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : [t.signal.M.x == 2]  enter C : when [t.signal.M.x == 3] }
        }
    """).step()
    run.step(run.heard("t.signal.M", "ann", x=1), run.heard("t.signal.M", "bob", x=3))
    run.step(run.heard("t.signal.M", "ann", x=2))
    run.step(run.done("A"))
    assert run.active == ["C"]


def test_an_unread_signal_is_gone_when_it_expires(play: Play) -> None:
    """ "gone once it is so old as its topic says with `expires`" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : [has(q.signal.Note)]  enter C : when [has(q.signal.Note)] }
        }
    """).step()
    run.step(run.heard("q.signal.Note"))
    run.step(run.done("A"), ms=20)
    assert run.active == ["A"]
    run.step(run.heard("q.signal.Note"))
    assert run.active == ["B"]


def test_an_ignored_signal_does_not_fire_later(play: Play) -> None:
    """ "What waits when T is entered is dropped, and so is what comes while T is active." """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R {
            on A : ignores t.signal.M
            enter B : [has(q.signal.M)]
            enter C : when [t.signal.M.x > 0]
          }
        }
    """).step()
    run.step(run.heard("t.signal.M", "ann", x=1), run.heard("t.signal.M", "bob", x=2))
    run.step(run.heard("t.signal.M", "ann", x=1), run.heard("q.signal.M"), run.done("A"))
    assert run.active == ["B"]
    run.step(run.heard("t.signal.M", "ann", x=1))
    assert run.active == ["C"]


def test_what_waits_where_it_is_ignored_is_dropped(play: Play) -> None:
    """ "what waits when T is entered is dropped", all of a queue and of each signal that is named"""
    run = play("""
        srm R {
          liveness { R = A . f . C  f = B . D }
          control R {
            enter C : when [has(q.signal.M) || has(t.signal.M)]
            on f : ignores q.signal.M, t.signal.M
          }
        }
    """).step()
    run.step(*(run.heard("q.signal.M", x=x) for x in range(3)), run.heard("t.signal.M"))
    for done in "ABD":
        run.step(run.done(done))
    assert "C" not in run.active


def test_a_state_inside_takes_a_signal_before_it_is_ignored(play: Play) -> None:
    """ "A state inside T that waits for the signal takes it first." """
    run = play("""
        srm R {
          liveness { R = f . C  f = A . B }
          control R { on f : ignores t.signal.M }
          control f { enter B : when [t.signal.M.x == 2] }
        }
    """).step()
    run.step(run.heard("t.signal.M", "ann", x=1))
    assert run.active == ["A"]
    run.step(run.heard("t.signal.M", "ann", x=2))
    assert run.active == ["B"]


def test_a_signal_of_one_sender(play: Play) -> None:
    """ "`host.t.signal.M` the oldest of that sender" """
    run = play("""
        srm R {
          liveness { R = A . B . C }
          control R { enter B : [bob.q.signal.M.x == 2]  enter C : when [q.signal.M.x == 1] }
        }
    """).step()
    run.step(
        run.heard("q.signal.M", "ann", x=1),
        run.heard("q.signal.M", "bob", x=2),
        run.heard("q.signal.M", "bob", x=3),
    )
    run.step(run.done("A"))
    assert run.active == ["C"]


def test_another_step_where_a_signal_waits_behind_a_dropped_one(play: Play) -> None:
    """ "`again` = some region still has a signal waiting behind one that was dropped." """
    run = play("srm R { liveness { R = A . B } control R { enter B : when [q.signal.M.x == 2] } }").step()
    run.step(run.heard("q.signal.M", x=1), run.heard("q.signal.M", x=2))
    assert (run.active, run.last.again) == (["A"], True)
    run.step()
    assert (run.active, run.last.again) == (["B"], False)


ENTERED = """
srm R {
  liveness { R = A . (first || D)  first = B . C }
  control R { enter (first || D) : [t.state.M.on || has(t.signal.M) || has(t.data.M)]
              enter (first || D) : }
  control first { enter C : when [%s] }
}
"""


@pytest.mark.parametrize(
    ("channel", "seen"), [("t.state.M", True), ("t.data.M", True), ("t.signal.M", False)]
)
def test_what_a_region_starts_with(play: Play, channel: str, seen: bool) -> None:
    """ "it starts with the surrounding one's states and histories, without signals" """
    run = play(ENTERED % f"has({channel})").step()
    run.step(run.heard(channel))
    run.step(run.done("A"))
    assert run.active == (["C", "D"] if seen else ["B", "D"])


def test_the_blackboard_is_dropped_when_the_and_is_left(play: Play) -> None:
    """ "A region's blackboard is made when its AND is entered … and is dropped when the AND is left." """
    run = play("""
        srm R {
          liveness { R = (first || C)~  first = A . B }
          control R { repeat (first || C) : go }
          control first { enter B : [has(t.signal.M)] }
        }
    """).step()
    run.step(run.heard("t.signal.M"))
    run.step(run.event("go"))
    assert run.step(run.done("A")).active == ["A", "C"]


def test_a_message_is_for_the_regions_that_are_active(play: Play) -> None:
    """ "an arrived message is put on the board of every active region that reads its channel" """
    run = play("""
        srm R {
          liveness { R = A . (first || D)  first = B . C }
          control first { enter C : when [has(t.signal.M)] }
        }
    """).step()
    run.step(run.heard("t.signal.M"))
    run.step(run.done("A"))
    assert run.active == ["B", "D"]


def test_a_draft_is_filled_and_published(play: Play) -> None:
    """ "assignment (it fills a draft that `write_messages` publishes)" """
    run = play("""
        srm R {
          liveness { R = A . B }
          control R {
            enter A : / t.state.M.x = 3; t.state.M.colour = Colour.BLUE
            enter B : / t.state.M.on = true; write_messages.t.state.M; write_messages.t.state.M
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.did == ["publish t.state.M {x=3 on=True colour=BLUE}", "publish t.state.M {}", "start B"]


def test_a_draft_for_one_host(play: Play) -> None:
    """ "with a `host.` it goes to that host alone"; "in the order they were begun" """
    run = play("""
        srm R {
          liveness { R = A . B }
          control R {
            enter B : / bob.t.state.M.x = 1; t.state.M.x = 2; bob.t.state.M.on = true;
                        write_messages.t.state.M
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.did == ["publish t.state.M {x=1 on=True} to bob", "publish t.state.M {x=2}", "start B"]


def test_drafts_belong_to_the_region(play: Play) -> None:
    """ "Drafts belong to the region" """
    run = play("""
        srm R {
          liveness { R = first || second  first = A . B  second = C . D }
          control first { enter B : / t.state.M.x = 3 }
          control second { enter D : / write_messages.t.state.M }
        }
    """).step()
    run.step(run.done("A"))
    assert run.step(run.done("C")).did == ["publish t.state.M {}", "start D"]


OWN = """
srm R {
  liveness { R = first || second  first = A . B . E  second = C . D }
  control first { enter B : / t.state.M.on = true; write_messages.t.state.M
  enter E : when [me.t.state.M.on] }
  control second { enter D : when [t.state.M.on] }
}
"""


def test_a_region_sees_its_own_message_at_once_and_others_in_their_next_step(play: Play) -> None:
    """ "Within the sender, a region sees its own write at once; others see it in their next step." """
    run = play(OWN).step()
    run.step(run.done("A"))
    assert run.active == ["E", "C"]
    assert run.step(run.came_back()).active == ["E", "D"]


def test_an_own_signal_is_not_seen_twice(play: Play) -> None:
    """ "(but not the region that wrote it, which saw it at once)" """
    run = play("""
        srm R {
          liveness { R = A . B . C . D }
          control R {
            enter B : / write_messages.t.signal.M
            enter C : when [has(t.signal.M)]
            enter D : when [has(t.signal.M)]
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.active == ["C"]
    assert run.step(run.came_back()).active == ["C"]


def test_reading_messages_in_the_middle_of_a_step(play: Play) -> None:
    """ "`read_messages` renews the executing region's snapshot for the later rounds of the step" """
    run = play("""
        srm R {
          liveness { R = first || second  first = A . B . E  second = C . D }
          control first { enter B : / read_messages  enter E : when [has(t.signal.M)] }
          control second { enter D : when [has(t.signal.M)] }
        }
    """).step()
    late = run.heard("t.signal.M")
    run.chart.pending = lambda: (late,)
    run.step(run.done("A"))
    assert run.active == ["E", "C"]
    run.chart.pending = tuple
    assert run.step(late).active == ["E", "D"]


def test_what_was_read_ahead_does_not_come_twice(play: Play) -> None:
    """ "Nothing else is needed: reading is automatic at step 1." """
    run = play("""
        srm R {
          liveness { R = A . B . C . D }
          control R {
            enter B : / read_messages
            enter C : [has(t.signal.M)] / read_messages
            enter D : when [has(t.signal.M)]
          }
        }
    """).step()
    late = run.heard("t.signal.M")
    run.chart.pending = lambda: (late,)
    run.step(run.done("A"))
    run.step(late, run.done("B"))
    run.chart.pending = tuple
    assert run.active == ["C"]
    assert run.step(late).active == ["C"]
    assert run.step(run.heard("t.signal.M")).active == ["D"]


def test_an_own_signal_that_an_action_reads_is_consumed(play: Play) -> None:
    """ "or an action reads one, that channel is "asked""; "(the one that was seen)" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A . B . C }
          control R {
            enter B : [!has(t.signal.M)] / t.signal.M.x = 5; write_messages.t.signal.M; v = t.signal.M.x
            enter C : when [has(t.signal.M)]
          }
        }
    """).step()
    run.step(run.done("A"))
    assert run.active == ["B"]
    assert run.variable("v") == 5


def test_what_a_region_read_ahead_comes_to_the_region_entered_after_it(play: Play) -> None:
    """ "an arrived message is put on the board of every active region that reads its channel" """
    run = play("""
        srm R {
          liveness { R = (first || C)~  first = A . B . D }
          control R { repeat (first || C) : when [q.signal.M.on] }
          control first { enter B : / read_messages  enter D : [has(t.signal.M)] }
        }
    """).step()
    late = run.heard("t.signal.M")
    run.chart.pending = lambda: (late,)
    run.step(run.done("A"), run.heard("q.signal.M", on=True))
    assert run.active == ["A", "C"]
    run.chart.pending = tuple
    run.step(late, run.done("A"))
    assert run.step(run.done("B")).active == ["D", "C"]


def test_the_mean_has_every_value_of_its_window(play: Play) -> None:
    """ "mean over values with time ≥ now - w" """
    run = play("""
        srm R {
          var v : double = 0
          liveness { R = A~ }
          control R { repeat A : go / v = mean(t.data.M.x, 10ms) }
        }
    """).step()
    run.step(run.heard("t.data.M", x=1), run.heard("t.data.M", x=3))
    run.step(run.heard("t.data.M", x=8), run.event("go"), ms=10)
    assert run.variable("v") == 4


def test_looking_back_at_one_sender(play: Play) -> None:
    """ "`at(x, -d)` = newest value whose time ≤ now - d" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = A~ }
          control R { repeat A : go / v = at(ann.t.data.M.x, -10ms) }
        }
    """).step()
    run.step(run.heard("t.data.M", "ann", x=1), ms=1)
    run.step(run.heard("t.data.M", "bob", x=2), ms=1)
    run.step(run.heard("t.data.M", "bob", x=3), ms=20)
    run.step(run.event("go"))
    assert run.variable("v") == 1


def test_a_message_for_one_host_is_seen_here_only_if_it_is_for_me(play: Play) -> None:
    """ "with a `host.` it goes to that host alone"; "the region itself sees it at once" """
    text = """
        srm R {
          liveness { R = A . B . C }
          control R {
            enter B : / %s.t.state.M.on = true; write_messages.t.state.M
            enter C : when [t.state.M.on]
          }
        }
    """
    run = play(text % "bob").step()
    assert run.step(run.done("A")).active == ["B"]
    run = play(text % "me").step()
    assert run.step(run.done("A")).active == ["C"]
