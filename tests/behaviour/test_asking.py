"""What conditions ask of states, and paced loops (semantics, "What is active, done, counted")."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run


def watched(question: str) -> str:
    return f"""
        srm R {{
          liveness {{ R = work || (Sleep . Wake)  work = (A . B)~ }}
          control R {{ enter Wake : when [{question}] }}
        }}
    """


def awake(run: Run) -> bool:
    return run.active[-1] == "Wake"


def test_in_holds_while_a_state_is_active(play: Play) -> None:
    """ "`in(T)`: whether T is active", in other regions, too, and in the same step"""
    run = play(watched("in(B)")).step()
    assert not awake(run)
    assert awake(run.step(run.done("A")))


def test_in_may_be_asked_of_a_formula(play: Play) -> None:
    """ "T is a formula, an activity or a played participant" """
    assert awake(play(watched("in(work)")).step())


def test_done_holds_from_completion_until_the_state_is_left(play: Play) -> None:
    """ "`done(T)`: whether T is active and complete" """
    text = """
        srm R {
          liveness { R = (A . B) || (Sleep . Wake) }
          control R { enter B : [has(t.state.M)]  enter Wake : when [done(A)] }
        }
    """
    run = play(text).step()
    assert not awake(run)
    assert awake(run.step(run.done("A")))


def test_they_are_two_valued(play: Play) -> None:
    """ "never absent" """
    assert awake(play(watched("!done(A) && !in(B)")).step())


def test_done_of_what_runs_beside_each_other(play: Play) -> None:
    text = """
        srm R {
          liveness { R = both . C || (Sleep . Wake)  both = A || B }
          control R { enter C : [has(t.state.M)]  enter Wake : when [done(both)] }
        }
    """
    run = play(text).step()
    run.step(run.done("A"))
    assert not awake(run)
    assert awake(run.step(run.done("B")))


def test_count_is_of_the_entries_since_the_loop_was_entered(play: Play) -> None:
    """ "`count(T)`: how often T was entered since its loop was" """
    text = """
        srm R {
          liveness { R = (pick . Move)~  pick = Grasp+ }
          control pick {
            repeat Grasp : [count(Grasp) < 2]
            leave  Grasp : else
          }
        }
    """
    run = play(text).step()
    for _ in range(2):
        assert run.active == ["Grasp"]
        run.step(run.done("Grasp"))
        assert run.active == ["Grasp"]
        run.step(run.done("Grasp"))
        assert run.active == ["Move"]
        run.step(run.done("Move"))


def test_the_loop_may_be_around_a_formula(play: Play) -> None:
    """ "its loop: the nearest state, itself or around it, with a transition to itself" """
    text = """
        srm R {
          liveness { R = (Try . [GiveUp])+ }
          control R {
            enter GiveUp : [count(Try) > 2]
            skip  GiveUp : else
            repeat (Try . [GiveUp]) : [count(Try) < 4]
            leave  (Try . [GiveUp]) : else
          }
        }
    """
    run = play(text).step()
    run.step(run.done("Try"))
    run.step(run.done("Try"))
    assert run.active == ["Try"]
    run.step(run.done("Try"))
    assert run.active == ["GiveUp"]


def test_without_a_loop_the_count_is_of_the_region(play: Play) -> None:
    text = """
        srm R {
          liveness { R = A . B . C }
          control R { enter C : [count(A) == 1] }
        }
    """
    run = play(text).step()
    run.step(run.done("A"))
    assert run.step(run.done("B")).active == ["C"]


def test_a_paced_loop_waits_from_start_to_start(play: Play) -> None:
    """ "`repeat T every D`: complete, but not before D has passed since T was entered" """
    text = """
        srm R {
          liveness { R = Blink~ }
          control R { repeat Blink every 200ms : }
        }
    """
    run = play(text).step()
    run.step(run.done("Blink"), ms=50)
    assert run.started == []
    assert run.due == 150
    assert run.step(ms=150).started == ["Blink"]
    assert run.step(ms=300).started == []
    assert run.step(run.done("Blink"), ms=20).started == ["Blink"]
    assert run.due == 200


def test_a_paced_loop_is_left_at_any_time(play: Play) -> None:
    text = """
        srm R {
          liveness { R = Blink+ . Rest }
          control R { repeat Blink every 200ms :  leave Blink : [has(t.state.M)] }
        }
    """
    run = play(text).step()
    run.step(run.done("Blink"), ms=20)
    assert run.step(run.heard("t.state.M"), ms=20).active == ["Rest"]
