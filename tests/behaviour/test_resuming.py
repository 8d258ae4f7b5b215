"""`resume T`: T goes on where it was last cut short (semantics, "Going on")."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

SHIFT = """
srm R {
  liveness { R = (shift [> Charge)~  shift = A . B . C }
  control R {
    resume shift :
    enter Charge : go
  }
}
"""


def test_it_goes_on_where_it_was_left(play: Play) -> None:
    """ "T continues in the configuration in which it was last cut short; activities restart" """
    run = play(SHIFT).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    assert run.did == ["cancel B", "start Charge"]
    run.step(run.done("Charge"))
    assert run.did == ["start B"]
    assert run.step(run.done("B")).active == ["C"]


def test_completion_clears_the_memory(play: Play) -> None:
    """ "completion clears the memory" """
    run = play(SHIFT).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    run.step(run.done("B"))
    run.step(run.done("C"))
    assert run.active == ["A"]


def test_without_memory_it_is_an_ordinary_entry(play: Play) -> None:
    assert play(SHIFT).step().active == ["A"]


def test_the_memory_is_spent(play: Play) -> None:
    """ "Then the memory is spent." """
    run = play("""
        srm R {
          liveness { R = (shift [> Charge)~  shift = A . B }
          control R { resume shift : [t.state.M.on]  enter shift : else  enter Charge : go }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    run.step(run.done("Charge"), run.heard("t.state.M", on=True))
    assert run.active == ["B"]
    run.step(run.event("go"))
    run.step(run.done("Charge"), run.heard("t.state.M", on=False))
    assert run.active == ["A"]


def test_regions_go_on_deeply(play: Play) -> None:
    """ "the active leaf of each region inside (deep), and which BASIC are complete" """
    run = play("""
        srm R {
          liveness { R = (shift [> Charge)~  shift = (A . B || C . D || E) . F }
          control R { resume shift :  enter Charge : go }
          control shift { leave E : hop }
        }
    """).step()
    run.step(run.done("A"), run.done("E"))
    assert run.active == ["B", "C", "E"]
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert run.did == ["start B", "start C"]  # E is complete
    run.step(run.event("hop"), run.done("B"), run.done("C"))
    assert run.step(run.done("D")).active == ["F"]


def test_regions_get_new_blackboards(play: Play) -> None:
    """ "AND regions get new boards": timers are gone"""
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = (shift [> Charge)~  shift = A || B . C }
          control R { resume shift :  enter Charge : go }
          control shift { enter B : / start_timer(p, 10ms)  enter C : when [expired(p)] / n = 1 }
        }
    """).step()
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert (run.active, run.due) == (["A", "B"], None)


def test_time_counts_from_the_new_entry(play: Play) -> None:
    """ "after() counts from re-entry" """
    run = play("""
        srm R {
          liveness { R = (shift [> Charge)~  shift = A . B }
          control R { resume shift :  enter Charge : go }
          control shift { enter B : after(10ms) }
        }
    """).step()
    run.step(run.event("go"), ms=8)
    run.step(run.done("Charge"), ms=5)
    assert run.due == 10


def test_a_start_that_waited_waits(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (shift [> Charge)~  shift = A . (B | C) }
          control R { resume shift :  enter Charge : go }
          control shift { enter B : [t.state.M.x == 1]  enter C : [t.state.M.x == 2] }
        }
    """).step()
    run.step(run.done("A"))
    before = run.active
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert (run.active, run.did) == (before, [])
    assert run.step(run.heard("t.state.M", x=2)).active == ["C"]


def test_of_a_loops_body_it_is_the_way_round(play: Play) -> None:
    """ "where T has no `enter` (a loop's body) as `repeat T`" """
    run = play("""
        srm R {
          liveness { R = (A . B)~ }
          control R { resume (A . B) : go }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    assert run.did == ["cancel B", "start B"]


def test_exits_are_done_when_it_is_cut_short(play: Play) -> None:
    """ "Exit actions ran when it was cut." """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = (shift [> Charge)~  shift = A . B }
          control R { resume shift :  enter Charge : go  exit shift : / n = n + 1 }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert (run.variable("n"), run.active) == (1, ["B"])


CONVERSATION = """
aip p {
  participant a {
    engage "Always." var n : int = 0 sends inform Note receives inform Note
    process = Ask . Give
    }
  participant b { engage "Always." sends inform Note receives inform Note process = Hear }
  outcome "Done."
  control a { enter Give : inform Note from b / n = n + 1 }
}
srm R {
  plays p.a
  liveness { R = (shift [> Charge)~  shift = A . a . B }
  control R { resume shift : [t.state.M.on]  enter shift : else  enter Charge : go }
}
"""


def words(run: Run) -> list[str]:
    return [line.split()[0] for line in run.did]


def test_a_conversation_is_suspended_and_goes_on(play: Play) -> None:
    """ "The conversation stays open, mail waits in it, its activities are cancelled" """
    run = play(CONVERSATION).step()
    run.step(run.done("A"))
    run.step(run.mail("inform", "Note"))
    assert (run.active, run.variable("n")) == (["Give"], 1)
    run.step(run.event("go"))
    assert words(run) == ["cancel", "suspend", "start"]
    run.step(run.mail("inform", "Note"))
    run.step(run.done("Charge"), run.heard("t.state.M", on=True))
    assert words(run) == ["resume", "start"]
    assert (run.active, run.variable("n")) == (["Give"], 1)
    run.step(run.done("Give"))
    assert [line.split()[0] for line in run.did] == ["complete", "start"]


def test_mail_of_a_suspended_conversation_is_taken_when_it_goes_on(play: Play) -> None:
    run = play(CONVERSATION).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    run.step(run.mail("inform", "Note"))
    assert run.did == []
    run.step(run.done("Charge"), run.heard("t.state.M", on=True))
    assert run.active == ["Give"]


def test_by_enter_it_is_discarded(play: Play) -> None:
    """ "The part is discarded, which is leaving, when `enter` is taken instead" """
    run = play(CONVERSATION).step()
    run.step(run.done("A"))
    run.step(run.event("go"), run.heard("t.state.M", on=False))
    run.step(run.mail("inform", "Note"))
    run.step(run.done("Charge"))
    assert words(run) == ["part", "start"]
    run.step(run.done("A"))
    assert (run.active, words(run)) == (["Ask"], ["join", "start"])


def test_it_is_discarded_with_the_region_that_remembers_it(play: Play) -> None:
    """ "… or the region that remembers it is left" """
    text = CONVERSATION.replace(
        "liveness { R = (shift [> Charge)~",
        "liveness { R = ((work || Z) [> Halt)~  work = (shift [> Charge)~",
    ).replace("control R {", "control R { enter Halt : stop } control work {")
    run = play(text).step()
    run.step(run.done("A"))
    run.step(run.event("go"))
    assert words(run) == ["cancel", "suspend", "start"]
    run.step(run.event("stop"))
    assert words(run) == ["cancel", "part", "cancel", "start"]


def test_its_own_time_stands_still(play: Play) -> None:
    """ "The part's own `after` and timers stand still; on resumption they go on" """
    text = CONVERSATION.replace(
        "enter Give : inform Note from b / n = n + 1",
        "enter Ask : / start_timer(t, 30ms)  enter Give : after(10ms) / n = n + 1"
        "  leave Give : when [expired(t)] / n = n + 2",
    )
    run = play(text).step()
    run.step(run.done("A"))
    run.step(run.event("go"), ms=8)
    run.step(run.done("Charge"), run.heard("t.state.M", on=True), ms=50)
    assert (run.active, run.due) == (["Ask"], 2)
    run.step(ms=2)
    assert (run.active, run.due) == (["Give"], 20)
    run.step(ms=20)
    assert run.active == ["B"]


@pytest.mark.parametrize("inner", [False, True])
def test_a_timer_that_an_exit_starts_stands_still_too(inner: bool, play: Play) -> None:
    """The exit is done while the part is left: its timer is the one that goes on."""
    text = CONVERSATION.replace(
        "enter Give : inform Note from b / n = n + 1",
        "enter Ask : / start_timer(t, 30ms)  exit Ask : / start_timer(t, 70ms)"
        "  enter Give : when [expired(t)] / n = n + 1",
    )
    if inner:
        text = text.replace("Ask . Give", "both  both = (ask || Other)  ask = Ask . Give")
        text = text.replace("control a {", "control ask {")
    run = play(text).step()
    run.step(run.done("A"))
    run.step(run.event("go"), ms=8)
    run.step(run.done("Charge"), run.heard("t.state.M", on=True), ms=50)
    assert run.due == 70
    run.step(ms=70)
    assert run.variable("n") == 1


def test_a_timer_ends_with_the_part(play: Play) -> None:
    text = CONVERSATION.replace("A . a . B", "a~").replace(
        "enter Give : inform Note from b / n = n + 1",
        "enter Give : [n == 0] / start_timer(t, 30ms)  leave Give : inform Note from b or after(1s)"
        "  on Give : when [expired(t)] / n = n + 1",
    )
    run = play(text).step()
    run.step(run.done("Ask"))
    assert run.due == 30
    run.step(run.mail("inform", "Note"), ms=1)
    run.step(ms=500)
    assert (run.active, run.variable("n")) == (["Ask"], 0)


def test_a_participant_itself_is_resumed(play: Play) -> None:
    text = CONVERSATION.replace("shift", "a").replace("a = A . a . B", "")
    run = play(text).step()
    run.step(run.mail("inform", "Note"))
    run.step(run.event("go"))
    assert words(run) == ["cancel", "suspend", "start"]
    run.step(run.done("Charge"), run.heard("t.state.M", on=True))
    assert (run.active, run.variable("n"), words(run)) == (["Give"], 1, ["resume", "start"])
    run.step(run.done("Give"))
    assert words(run)[0] == "complete"


def test_each_state_has_its_own_memory(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (outer [> Charge)~  outer = (inner [> Look)+ . Z  inner = A . B . C }
          control R { resume outer :  enter Charge : go }
          control outer { resume inner :  enter Look : hop  repeat (inner [> Look) : [t.state.M.on] }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.event("hop"))
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert run.active == ["Look"]
    run.step(run.heard("t.state.M", on=True), run.done("Look"))
    assert run.active == ["B"]
