"""`control F reactive`: a decision that is always current (semantics, "Choosing again")."""

from __future__ import annotations

from tests.behaviour.conftest import Play

GUARD = """
srm R {
  liveness { R = (A | B | C) . D }
  control R reactive {
    enter A : [t.state.M.x > 10]
    enter B : [t.state.M.x > 5]
    enter C : else
  }
}
"""


def test_another_branch_is_taken_as_soon_as_choosing_again_would_take_it(play: Play) -> None:
    """ "every branch of the choice is also left as soon as choosing again would take another" """
    run = play(GUARD).step()
    assert run.active == ["C"]
    run.step(run.heard("t.state.M", x=7))
    assert run.did == ["cancel C", "start B"]
    assert run.taken == ["0.2.5 -> 0.2.2 -> 0.2.4"]
    assert run.step(run.heard("t.state.M", x=20)).active == ["A"]
    assert run.step(run.heard("t.state.M", x=0)).active == ["C"]


def test_it_stays_while_choosing_again_would_take_it(play: Play) -> None:
    run = play(GUARD).step(play(GUARD).heard("t.state.M", x=7))
    for x in (6, 8, 10):
        run.step(run.heard("t.state.M", x=x))
        assert run.taken == []


def test_earlier_branches_win(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = A | B }
          control R reactive { enter A : [t.state.M.on]  enter B : [t.state.M.x > 0] }
        }
    """).step()
    run.step(run.heard("t.state.M", x=1))
    assert run.active == ["B"]
    run.step(run.heard("t.state.M", x=1, on=True))
    assert run.active == ["A"]
    assert run.step(run.heard("t.state.M", x=1, on=True)).taken == []
    assert run.step(run.heard("t.state.M", x=0, on=False)).taken == []  # neither is open: it stays


def test_what_is_done_is_left_by_completion(play: Play) -> None:
    """ "Tried after all other transitions of T_i (also after plain completion …)" """
    run = play(GUARD).step()
    run.step(run.done("C"), run.heard("t.state.M", x=7))
    assert run.active == ["D"]


def test_an_option_is_left_when_it_would_be_skipped(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = [A] . B }
          control R reactive { enter A : [t.state.M.on]  skip A : else }
        }
    """)
    run.step(run.heard("t.state.M", on=True))
    assert run.active == ["A"]
    run.step(run.heard("t.state.M", on=False))
    assert run.did == ["cancel A", "start B"]


def test_events_lead_from_branch_to_branch(play: Play) -> None:
    """ "Branches entered by an event: T_i → T_j with that branch's own expression." """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A | B | C }
          control R reactive { enter A : go / n = n + 1  enter B : hop  enter C : else }
        }
    """).step()
    assert run.step(run.event("go")).active == ["A"]
    assert run.variable("n") == 1
    assert run.step(run.event("go")).taken == []
    assert run.step(run.event("hop")).active == ["B"]


def test_the_actions_of_the_new_branch_are_done(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A | B }
          control R reactive { enter A : [t.state.M.on]  enter B : else / n = n + 1 }
        }
    """)
    run.step(run.heard("t.state.M", on=True))
    run.step(run.heard("t.state.M", on=False))
    assert (run.active, run.variable("n")) == (["B"], 1)


def test_what_is_absent_does_not_hold(play: Play) -> None:
    """ "the two-valued value `holds(c)` (never absent)" """
    run = play("""
        srm R {
          liveness { R = A | B }
          control R reactive {
            enter A : [!(t.state.M.on || q.signal.M.on)]
            enter B : [!has(t.state.M) || t.state.M.on]
          }
        }
    """).step()
    assert run.active == ["B"]
    run.step(run.heard("t.state.M", on=False))
    assert run.active == ["B"]


def test_only_the_formulas_own_choices_are_reactive(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = work | B  work = A | C }
          control R reactive { enter work : [t.state.M.on]  enter B : else }
          control work { enter A : [t.state.M.x > 0]  enter C : else }
        }
    """)
    run.step(run.heard("t.state.M", on=True, x=1))
    run.step(run.heard("t.state.M", on=True, x=0))
    assert run.active == ["A"]
    run.step(run.heard("t.state.M", on=False))
    assert run.active == ["B"]


def test_a_branch_with_parts_is_left_as_a_whole(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (A . B || C) | D }
          control R reactive { enter (A . B || C) : [t.state.M.on]  enter D : else }
        }
    """)
    run.step(run.heard("t.state.M", on=True))
    run.step(run.heard("t.state.M", on=False))
    assert run.did == ["cancel A", "cancel C", "start D"]


def test_a_participant_may_choose_again(play: Play) -> None:
    run = play("""
        aip p {
          participant a {
            engage "Always." var n : int = 0 sends inform Note receives inform Note
            process = Ask | Give
          }
          participant b { engage "Always." sends inform Note receives inform Note process = Hear }
          outcome "Done."
          control a reactive { enter Ask : [t.state.M.on] / n = n + 1  enter Give : [!t.state.M.on] }
        }
        srm R { plays p.a  liveness { R = a } }
    """)
    run.step(run.heard("t.state.M", on=True))
    run.step(run.heard("t.state.M", on=False))
    assert (run.active, run.variable("n")) == (["Give"], 1)
