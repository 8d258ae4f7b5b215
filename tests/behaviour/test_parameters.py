"""Parameters of activities and formulas (semantics, "Activities", "Parameters")."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime.chart.inputs import Sending
from tests.behaviour.conftest import Play


def test_what_an_activity_is_given_is_computed_on_entry(play: Play) -> None:
    """ "What an activity is given is computed when its state is entered." """
    run = play("""
        srm R {
          var n : int = 1
          liveness { R = Count(n + 1)+ . Rest }
          activities { Count(to : int) }
          control R { repeat Count : [n < 3] / n = n + 1  leave Count : else }
        }
    """).step()
    assert run.did == ["start Count(to=2)"]
    assert run.step(run.done("Count")).did == ["start Count(to=3)"]
    assert run.step(run.done("Count")).did == ["start Count(to=4)"]
    assert run.step(run.done("Count")).did == ["start Rest"]


def test_any_type_and_any_pure_expression(play: Play) -> None:
    run = play("""
        let twice = t.state.M.x * 2
        srm R {
          liveness { R = A . Do(Colour.GREEN, t.state.M, twice, 200ms, "x", far(t.state.M), t.state.M.x) }
          activities { Do(c : Colour, m : M, n : int, d : duration, s : string, b : bool, f : double) }
        }
    """).step()
    run.step(run.heard("t.state.M", x=4))
    assert (
        run.step(run.done("A")).did[-1]
        == ("start Do(c=GREEN, m={x=4}, n=8, d=200000000, s='x', b=False, f=4.0)")
        or run.did[-1] == "start Do(c=GREEN, m={x=4}, n=8, d=200000000, s='x', b=False, f=4)"
    )


def test_actions_of_the_way_in_are_seen(play: Play) -> None:
    """ "then the actions run; then the target is entered" """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A . Count(n) }
          activities { Count(to : int) }
          control R { enter Count(n) : / n = 7 }
        }
    """).step()
    assert run.step(run.done("A")).did == ["start Count(to=7)"]


ABSENT = """
    srm R {
      liveness { R = A . Count(t.state.M.x) . Rest }
      activities { Count(to : int) }
      control R { enter Rest :  enter Rest : error }
    }
"""


def test_an_absent_argument_fails_the_state_at_once(play: Play) -> None:
    """ "If something of it is absent, or raises, the state has failed at once: `error` takes it." """
    run = play(ABSENT).step()
    assert run.step(run.done("A")).did == ["start Rest"]
    assert run.taken == ["0.2 -> 0.3", "0.3 -> 0.4"]


def test_without_an_error_transition_the_agent_stops_and_says_which(play: Play) -> None:
    run = play(ABSENT.replace("enter Rest : error", "")).step()
    run.step(run.done("A"))
    assert run.last.failure is not None and "the argument `to` is absent" in run.last.failure
    assert run.did == []


def test_one_that_raises_fails_the_state(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = A . Count(1 / n) . Rest }
          activities { Count(to : double) }
          control R { enter Rest :  enter Rest : error }
        }
    """).step()
    assert run.step(run.done("A")).did == ["start Rest"]


def test_arguments_use_the_innermost_region_around_them(play: Play) -> None:
    """ "Conditions, actions and activities use the innermost region around them." """
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = (A . Count(n)) || (B . C) }
          activities { Count(to : int) }
          control R { enter C : / n = 5  enter Count : }
        }
    """).step()
    run.step(run.done("A"), run.done("B"))
    assert run.did == ["start Count(to=0)", "start C"]


# ---- formulas ------------------------------------------------------------------------------------

DELIVER = """
    srm R {
      var first : int = 1
      liveness {
        R = deliver(first, 2) . deliver(3, first)
        deliver(from, to) = MoveTo(from) . Grasp . MoveTo(to)
      }
      activities { MoveTo(goal : int) }
      control deliver {
        enter Grasp : when [from == 3]
        enter Grasp : / first = to
        enter MoveTo(to) :
      }
    }
"""


def test_a_formulas_parameters_stand_for_what_it_is_given(play: Play) -> None:
    """ "A parameter of a formula stands for what it is given, wherever the formula stands." """
    run = play(DELIVER).step()
    assert run.did == ["start MoveTo(goal=1)"]
    run.step(run.done("0.2.2"))
    assert run.did == ["start Grasp"]
    assert run.variable("first") == 2
    run.step(run.done("0.2.3"))
    assert run.did == ["start MoveTo(goal=2)"]
    run.step(run.done("0.2.4"))
    assert run.did == ["start MoveTo(goal=3)", "cancel MoveTo", "start Grasp"]
    run.step(run.done("0.3.3"))
    assert run.did == ["start MoveTo(goal=2)"]


def test_states_are_called_by_what_they_are_given(play: Play) -> None:
    run = play(DELIVER)
    names = {state.label: state.name for state in run.plan.states}
    assert names["0.2"] == "deliver(first, 2)"
    assert names["0.2.2"] == "MoveTo(first)"
    assert names["0.3.2"] == "MoveTo(3)"
    assert run.plan.by_label["0.3.2"].activity == "MoveTo"


def test_parameters_are_passed_on_through_formulas(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 1
          liveness {
            R = outer(n + 1, 5)
            outer(a, b : int) = inner(a) || inner(b)
            inner(c) = Count(c)
          }
          activities { Count(to : int) }
        }
    """)
    assert run.step().did == ["start Count(to=2)", "start Count(to=5)"]


def test_a_parameter_hides_a_variable_and_is_not_seen_outside(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 1
          liveness { R = [twice(n + 3)]  twice(n) = Count(n) }
          activities { Count(to : int) }
          control R { enter twice : [n == 1]  skip twice : else }
          control twice { enter Count : [n == 4] }
        }
    """)
    assert run.step().did == ["start Count(to=4)"]


def test_a_participants_formula_with_parameters(play: Play) -> None:
    run = play("""
        aip tour {
          participant guide {
            var at : int = 3
            process = leg(at) . leg(at + 1)
            leg(to) = Walk(to) . Show
          }
          outcome "Seen."
        }
        srm R {
          plays tour.guide with Walk = Drive
          liveness { R = guide }
          activities { Drive(metres : int)  Show takes 1s }
        }
        srm other { plays tour.guide  liveness { other = guide } activities { Walk(goal : int) } }
    """).step()
    assert run.did == ["join 0.2", "start Drive(metres=3)"]


@pytest.mark.parametrize("text", ["enter Move : go", "enter Move#1 : go", "enter Move(n) : go"])
def test_a_term_with_arguments_in_control(play: Play, text: str) -> None:
    """ "The term may be written with what it is given, or without, where only one stands in the formula." """
    run = play(f"""
        srm R {{
          var n : int = 0
          liveness {{ R = A . Move(n) . B }}
          activities {{ Move(to : int) }}
          control R {{ {text} }}
        }}
    """).step()
    assert run.step(run.event("go")).did == ["cancel A", "start Move(to=0)"]


def test_an_activity_may_be_given_how_often_it_was_entered(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = (Try(count(Try)) . Look)~ }
          activities { Try(time : int) }
        }
    """).step()
    assert run.did == ["start Try(time=1)"]
    run.step(run.done("Try"))
    assert run.step(run.done("Look")).did == ["start Try(time=2)"]


def test_parameters_in_actions_that_stay_and_at_the_exit(play: Play) -> None:
    run = play("""
        srm R {
          var n : int = 0
          liveness { R = first(4) . Rest  first(by : int) = Work . Idle }
          control R { enter Rest : go }
          control first { on Work : step / n = n + by  exit Work : / n = n * by }
        }
    """).step()
    run.step(run.event("step"))
    assert run.variable("n") == 4
    run.step(run.event("go"))
    assert run.variable("n") == 16


def test_what_cuts_a_formula_short_may_have_parameters(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = safe(3)~  safe(limit : int) = Work [> Stop(limit) }
          activities { Stop(how : int) }
          control safe { enter Stop : when [t.state.M.x > limit] }
        }
    """).step()
    assert run.step(run.heard("t.state.M", x=3)).did == []
    assert run.step(run.heard("t.state.M", x=4)).did == ["cancel Work", "start Stop(how=3)"]


def test_what_goes_on_is_given_its_arguments_anew(play: Play) -> None:
    """ "a BASIC that was running starts anew", with what it is given now"""
    run = play("""
        srm R {
          var n : int = 1
          liveness { R = ((Work(n) . Idle) . Stop)~ }
          activities { Work(on : int) }
          control R {
            enter Stop : stop / n = n + 1
            resume ((Work(n) . Idle) . Stop) :
            resume (Work(n) . Idle) :
          }
        }
    """).step()
    assert run.did == ["start Work(on=1)"]
    run.step(run.event("stop"))
    assert run.did == ["cancel Work", "start Stop"]
    assert run.step(run.done("Stop")).did == ["start Work(on=2)"]


def test_a_reactive_choice_with_parameters(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = guard(3)~  guard(limit : int) = Walk(limit) | Rest }
          activities { Walk(to : int) }
          control guard reactive { enter Walk : [t.state.M.x > limit]  enter Rest : else }
        }
    """).step()
    assert run.active == ["Rest"]
    assert run.step(run.heard("t.state.M", x=4)).did == ["cancel Rest", "start Walk(to=3)"]
    assert run.step(run.heard("t.state.M", x=3)).did == ["cancel Walk", "start Rest"]


def test_a_message_filled_with_a_parameter(play: Play) -> None:
    run = play("""
        aip deal {
          participant a { sends inform Note  process = say("x") . Wait  say(what) = Think(what) . Done }
          participant b { receives inform Note  process = Hear }
          control say { enter Done : / send inform Note { text = what } to b }
          outcome "x"
        }
        srm R { plays deal.a  liveness { R = a } activities { Think(of : string) } }
        srm other { plays deal.b  liveness { other = b } }
    """).step()
    run.step(run.done("Think"))
    (sent,) = run.last.of(Sending)
    assert sent.content.text == "x"


def test_states_with_arguments_are_asked_for_by_their_name(play: Play) -> None:
    run = play("""
        srm R {
          liveness { R = ((go(1) . go(2)) || Watch) . Done  go(n) = Walk(n) . Turn }
          activities { Walk(to : int) }
          control R { enter Done : when [in(Turn) && !in(Walk) && in(go)] }
        }
    """).step()
    assert run.active == ["Walk", "Watch"]
    (walk, _) = run.chart.configuration()[-2:]
    assert run.step(run.done(walk)).active == ["Done"]
