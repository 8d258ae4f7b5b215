"""Participants and agent messages: branches, mail, variables (semantics, "Agent messages")."""

from __future__ import annotations

from tests.behaviour.conftest import Play

PROTOCOL = """
aip p {
  participant a {
    engage   "Always."
    var best : int = 3
    sends    cfp Note
    receives inform Note, refuse Note
    process  = A . B . C
  }
  participant b {
    engage   "Always."
    sends    inform Note, refuse Note
    receives cfp Note
    process  = X
  }
  outcome "Done."
  control a {
    enter A : / send cfp Note to b
    enter B : inform Note from b / best = best + 1
    enter C : inform Note from b or refuse Note from b
  }
}
"""

ONE = PROTOCOL + "srm R { plays p.a  liveness { R = D . a~ } }"


def test_a_participation_is_joined_and_left(play: Play) -> None:
    """ "entering/leaving a participation gives Joined/Left" """
    run = play(ONE).step()
    run.step(run.done("D"))
    branch = run.plan.branches[0].label
    assert run.did == [f"join {branch}", "send cfp Note to b", "start A"]
    run.step(run.mail("inform", "Note"), run.mail("inform", "Note"))
    run.step(run.done("C"))
    assert run.did == [f"complete {branch}", f"join {branch}", "send cfp Note to b", "start A"]


def test_one_message_is_taken_by_one_transition(play: Play) -> None:
    """ "An agent message waits in its conversation until exactly one transition or activity takes it" """
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(run.mail("inform", "Note", "ann"))
    assert run.active == ["B"]
    assert sorted(run.did) == ["cancel A", "start B", "take mail of ann"]
    run.step(run.mail("refuse", "Note", "bob"))
    assert run.active == ["C"]


def test_a_message_that_comes_early_is_not_lost(play: Play) -> None:
    """ "A message that a participant `receives` waits in its conversation until a transition or an activity
    takes it (so one that comes early is not lost)" """
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(run.mail("refuse", "Note", "bob"))
    assert run.active == ["A"]
    run.step(run.done("A"), ms=50)
    run.step(run.mail("inform", "Note", "ann"), ms=50)
    assert run.active == ["C"]
    assert [line for line in run.did if line.startswith("take")] == ["take mail of ann", "take mail of bob"]


def test_the_oldest_message_of_a_kind_is_taken(play: Play) -> None:
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(
        run.mail("refuse", "Note", "eve"),
        run.mail("inform", "Note", "ann"),
        run.mail("inform", "Note", "bob"),
    )
    assert [line for line in run.did if line.startswith("take")] == ["take mail of ann", "take mail of bob"]


def test_the_first_event_listed_that_is_there_is_spent(play: Play) -> None:
    """ "the first listed that is there is the one spent" """
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(run.mail("refuse", "Note", "eve"))
    run.step(run.mail("inform", "Note", "ann"), run.mail("inform", "Note", "bob"))
    assert [line for line in run.did if line.startswith("take")] == ["take mail of ann", "take mail of bob"]


def test_what_waits_is_given_up_with_the_conversation(play: Play) -> None:
    """ "one … of a closed conversation, is unexpected" """
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(run.mail("inform", "Note"), run.mail("refuse", "Note"), run.mail("inform", "Note"))
    run.step(run.done("C"))
    assert run.active == ["A"]


def test_a_participants_variables_start_anew(play: Play) -> None:
    """ "A participant's variables start anew each time its branch is entered." """
    run = play(ONE).step()
    run.step(run.done("D"))
    run.step(run.mail("inform", "Note"))
    assert run.variable("best") == 4
    run.step(run.mail("refuse", "Note"))
    run.step(run.done("C"))
    assert run.active == ["A"]
    assert run.variable("best") == 3


def test_a_participant_in_two_places(play: Play) -> None:
    """ "A participant may stand in several places of a role." """
    run = play(PROTOCOL + "srm R { plays p.a  liveness { R = (a . D) || (a . E) } }").step()
    first, second = (branch.label for branch in run.plan.branches)
    assert run.did == [
        f"join {first}",
        f"join {second}",
        "send cfp Note to b",
        "start A",
        "send cfp Note to b",
        "start A",
    ]
    run.step(run.mail("inform", "Note", at=second))
    assert run.active == ["A", "B"]
    names = {variable.scope: variable.name for variable in run.plan.variables}
    assert [run.chart.variable(names[label]) for label in (first, second)] == [3, 4]


def test_bound_activities_replace_those_of_the_protocol(play: Play) -> None:
    run = play(PROTOCOL + "srm R { plays p.a with A = Ask  liveness { R = a } }").step()
    assert run.active == ["Ask"]


def test_a_variable_of_a_branch_that_is_left_and_entered_in_one_step(play: Play) -> None:
    """ "A participant's variables start anew each time its branch is entered." """
    run = play("""
        aip p {
          participant a {
            engage  "Always."
            var v : int = 3
            process = (inner || B)
            inner   = A . E
          }
          participant b { engage "Always."  process = X }
          outcome "Done."
          control inner { enter E : / v = 7 }
        }
        srm R { plays p.a  liveness { R = a~ } control R { repeat a : when [t.signal.M.on] } }
    """).step()
    run.step(run.done("A"), run.heard("t.signal.M", on=True))
    assert run.active == ["A", "B"]
    assert run.variable("v") == 3


def test_a_compound_transition_takes_one_message(play: Play) -> None:
    """ "exactly one transition or activity takes it"; "The whole is one compound transition" """
    run = play("""
        aip p {
          participant a {
            engage   "Always."
            receives inform Note
            process  = A | B
          }
          participant b { engage "Always."  sends inform Note  process = X }
          outcome "Done."
          control a {
            start a : inform Note from b
            enter A : inform Note from b
            enter B : else
          }
        }
        srm R { plays p.a  liveness { R = a } }
    """).step()
    run.step(run.mail("inform", "Note", "ann"), run.mail("inform", "Note", "bob"))
    assert run.did == ["take mail of ann", "start A"]


PATIENT = """
aip p {
  participant a {
    engage   "Always."
    var old : duration = 0s
    sends    cfp Note
    receives inform Note, refuse Note
    process  = A . B . C
  }
  participant b { engage "Always."  sends inform Note, refuse Note  receives cfp Note  process = X }
  outcome "Done."
  control a {
    enter A : / send cfp Note to b
    enter B : inform Note n from b [age(n) > 100ms] / old = age(n)
    enter C : refuse Note from b [age(refuse.Note) < 50ms] / old = age(refuse.Note) + 1ms
  }
}
srm R { plays p.a  liveness { R = a } }
"""


def test_a_message_is_taken_when_it_is_old_enough(play: Play) -> None:
    """ "`age(m)` = now - when it was sent"; "at the moment when it crosses the constant" """
    run = play(PATIENT).step()
    assert run.due is None
    run.step(run.mail("inform", "Note", "ann", ms_ago=30), run.mail("inform", "Note", "bob", ms_ago=20))
    assert run.due == 70.000001
    assert run.step(ms=70).active == ["A"]
    assert run.step(ms=0.000001).did == ["take mail of ann", "cancel A", "start B"]
    assert run.variable("old") == 100_000_001


def test_a_message_may_be_too_old(play: Play) -> None:
    run = play(PATIENT).step()
    run.step(run.mail("inform", "Note", ms_ago=200))
    run.step(run.mail("refuse", "Note", "ann", ms_ago=50), run.mail("refuse", "Note", "bob", ms_ago=49))
    assert "take mail of bob" in run.did
    assert run.variable("old") == 50_000_000


def test_an_age_counts_from_arrival_where_nothing_says_when_it_was_sent(play: Play) -> None:
    run = play(PATIENT).step()
    run.step(ms=10)
    run.step(run.mail("inform", "Note", "ann"))
    assert run.due == 100.000001
    assert "take mail of ann" in run.step(ms=100.000001).did
