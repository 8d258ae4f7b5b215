"""Conditions and values: absence, faults, arithmetic (semantics, "Absent values", and the expressions)."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play

CONDITION = """
srm R {
  var n : int = 3
  var f : bool = true
  var d : double = 2.5
  var s : string = "abc"
  var c : Colour = Colour.GREEN
  liveness { R = A | B | C }
  control R {
    enter A : [%s]
    enter B : [!(%s)]
    enter C : else
  }
}
"""

T, F, ABSENT = "A", "B", "C"

KLEENE = [
    ("t.state.M.on", ABSENT),
    ("!t.state.M.on", ABSENT),
    ("t.state.M.on && true", ABSENT),
    ("t.state.M.on && false", F),
    ("false && t.state.M.on", F),
    ("true && t.state.M.on", ABSENT),
    ("t.state.M.on || true", T),
    ("true || t.state.M.on", T),
    ("t.state.M.on || false", ABSENT),
    ("t.state.M.on || t.state.M.on", ABSENT),
    ("t.state.M.on && t.state.M.on", ABSENT),
    ("!(t.state.M.on && false)", T),
    ("!(t.state.M.on || true)", F),
    ("!(t.state.M.on || false)", ABSENT),
    ("!!t.state.M.on", ABSENT),
    ("t.state.M.x == 3", ABSENT),
    ("!(t.state.M.x == 3)", ABSENT),
    ("t.state.M.x != 3", ABSENT),
    ("t.state.M.x == t.state.M.x", ABSENT),
    ("t.state.M.x + 1 > 0", ABSENT),
    ("-t.state.M.x < 0", ABSENT),
    ("abs(t.state.M.x) < 3", ABSENT),
    ("even(t.state.M.x)", ABSENT),
    ("far(t.state.M)", ABSENT),
    ("age(t.state.M) > 0ms", ABSENT),
    ("at(t.data.M.x, -1ms) > 0", ABSENT),
    ("mean(t.data.M.x, 1s) > 0", ABSENT),
    ("(t.state.M.on && false) == false", T),
    ("(t.state.M.on || true) == true", T),
    ("(t.state.M.on || false) == true", ABSENT),
    ("(t.state.M.on && f) == f", ABSENT),
    ("has(t.state.M)", F),
    ("!has(t.state.M)", T),
    ("has(t.data.M) == has(t.state.M)", T),
    ("has(ann.t.signal.M)", F),
    ("expired(pace)", F),
    ("t.state.M.on && even(n) && fails(n)", F),
    ("!even(n) || fails(n)", T),
]


@pytest.mark.parametrize(("condition", "branch"), KLEENE, ids=[text for text, _ in KLEENE])
def test_absent_values(play: Play, condition: str, branch: str) -> None:
    """ "A condition over a message that has not arrived is neither true nor false: `&&`, `||`, `!` follow
    Kleene's three-valued logic, comparisons and functions of an absent value are absent, and a transition
    needs *true*. `has(…)` is always two-valued." """
    run = play(CONDITION % (condition, condition)).step()
    assert run.active == [branch]


COMPUTED = [
    ("7 / 2 == 3.5", T),
    ("6 / 3 == 2", T),
    ("-7 % 3 == 2", T),
    ("7 % -3 == -2", T),
    ("2 + 3 * 4 == 14", T),
    ("(2 + 3) * 4 == 20", T),
    ("7 - 2 - 3 == 2", T),
    ("8 / 4 / 2 == 1", T),
    ("2 * d == 5.0", T),
    ("n + d == 5.5", T),
    ("5.5 % 2 == 1.5", T),
    ("-n == 0 - 3", T),
    ("- -n == n", T),
    ("n < d", F),
    ("n >= 3 && n <= 3", T),
    ('s == "abc"', T),
    ('s < "abd"', T),
    ('s != "a\\"c"', T),
    ("c == Colour.GREEN", T),
    ("c != Colour.RED", T),
    ("c == Colour.BLUE", F),
    ("f == true", T),
    ("(n > 2) == f", T),
    ("abs(-n) == 3", T),
    ("abs(0 - d) == 2.5", T),
    ("min(n, 2) + max(n, 2) == 5", T),
    ("200ms + 0.3s == 500ms", T),
    ("2min - 1s == 119s", T),
    ("2 * 100ms == 200ms", T),
    ("100ms * 2.5 == 250ms", T),
    ("1s / 4 == 250ms", T),
    ("1s / 250ms == 4", T),
    ("1s / 2 > 400ms", T),
    ("inverse(2) == 0.5", T),
    ("even(n + 1)", T),
    ("n == 1 or n == 3 and not f", F),
    ("not (n == 1) and f", T),
]


@pytest.mark.parametrize(("condition", "branch"), COMPUTED, ids=[text for text, _ in COMPUTED])
def test_computed_values(play: Play, condition: str, branch: str) -> None:
    """ "`/` on numbers gives double (int/int too); `%` is Python's; …" """
    run = play(CONDITION % (condition, condition)).step()
    assert run.active == [branch]


RAISES = [
    "1 / (n - 3) > 0",
    "1 % (n - 3) == 0",
    "fails(n)",
    "fails(n) || true",
    "!fails(n)",
    "inverse(n - 3) > 0 || f",
    "f && fails(n)",
    "1s / (n - 3) > 1s",
]


@pytest.mark.parametrize("condition", RAISES)
def test_what_raises_makes_the_whole_condition_not_hold(play: Play, condition: str) -> None:
    """ "One that raises makes its condition not hold; the error is traced with its place in the source, never
    swallowed." """
    run = play(CONDITION % (condition, condition)).step()
    assert run.active == ["C"]
    assert run.did[:1] == ["fault 0.2 -> 0.3"] and "fault 0.2 -> 0.4" in run.did


def test_a_fault_is_recorded_once_a_step(play: Play) -> None:
    """ "a fault is recorded once per transition and step" """
    run = play("""
        srm R {
          var v : int = 0
          liveness { R = (A . B) || C }
          control R { leave C : when [1 / v > 1] / v = 1 }
        }
    """).step()
    run.step(run.done("A"))
    assert [line for line in run.did if line.startswith("fault")] == ["fault 0.2.2.2 -> 0.2.2.3"]


def test_a_decided_condition_calls_no_more_functions(play: Play) -> None:
    """ "from the left, stopping as soon as decided" """
    run = play(CONDITION % ("even(n) && even(4)", "even(n) && even(4)")).step()
    assert run.did == ["even(int) is False"] * 2 + ["start B"]


def test_functions_see_whole_messages(play: Play) -> None:
    run = play("srm R { liveness { R = A . B } control R { enter B : when [far(t.state.M)] } }").step()
    run.step(run.heard("t.state.M", x=10))
    assert run.did == ["far(M) is False"]
    assert run.step(run.heard("t.state.M", x=11)).active == ["B"]


def test_an_absent_value_in_an_action_is_a_fault(play: Play) -> None:
    """ "In an action, an absent or raising value means that this one action is not done, with a fault." """
    run = play("""
        srm R {
          var v : int = 7
          var w : double = 7
          liveness { R = A }
          control R { enter A : / v = t.state.M.x; w = inverse(0); v = v + 1; start_timer(pace, 1ms) }
        }
    """).step()
    assert (run.variable("v"), run.variable("w")) == (8, 7)
    assert run.did == ["fault 0.1 -> 0.2", "start A"]


def test_a_let_stands_for_its_expression(play: Play) -> None:
    """ "`let NAME = expression` … names a pure, typed expression; it stands for it everywhere" """
    run = play("""
        let near = t.state.M.x < 10
        srm R {
          let seen = has(t.state.M) && near
          liveness { R = A . B }
          control R { enter B : when [seen && !(near == false)] }
        }
    """).step()
    assert run.active == ["A"]
    assert run.step(run.heard("t.state.M", x=11)).active == ["A"]
    assert run.step(run.heard("t.state.M", x=9)).active == ["B"]


def test_a_function_as_an_action(play: Play) -> None:
    """ "an expression as an action … its value is dropped" """
    run = play("srm R { liveness { R = A } control R { enter A : / even(3); fails(1); even(2) } }").step()
    assert run.did == ["even(int) is False", "fault 0.1 -> 0.2", "even(int) is True", "start A"]


def test_an_enum_and_a_text_in_variables(play: Play) -> None:
    run = play("""
        srm R {
          var c : Colour = Colour.GREEN
          var s : string = "a"
          liveness { R = A . B }
          control R { enter A : / c = t.state.M.colour; s = t.state.M.s
          enter B : [c == Colour.BLUE && s == "b"] }
        }
    """)
    run.step(run.heard("t.state.M", colour=2, s="b"))
    assert run.step(run.done("A")).active == ["B"]
