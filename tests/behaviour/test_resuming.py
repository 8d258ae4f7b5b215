"""`resume T`: T goes on where it was last cut short (semantics, "Going on")."""

from __future__ import annotations

from tests.behaviour.conftest import Play

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


def test_conversations_do_not_resume(play: Play) -> None:
    """ "At a protocol branch it stops: the branch is entered anew." """
    run = play("""
        aip p {
          participant a {
            engage "Always." var n : int = 0 sends inform Note receives inform Note
            process = Ask . Give
            }
          participant b { engage "Always." sends inform Note receives inform Note process = Hear }
          outcome "Done."
          control a { enter Give : / n = n + 1 }
        }
        srm R {
          plays p.a
          liveness { R = (shift [> Charge)~  shift = A . a . B }
          control R { resume shift :  enter Charge : go }
        }
    """).step()
    run.step(run.done("A"))
    run.step(run.done("Ask"))
    assert run.variable("n") == 1
    run.step(run.event("go"))
    run.step(run.done("Charge"))
    assert [line.split()[0] for line in run.did] == ["join", "start"]
    assert (run.active, run.variable("n")) == (["Ask"], 0)


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
