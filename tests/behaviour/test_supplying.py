"""`given` and `result`: what a role supplies to a participant, and when it gets something back."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play

INPUT = """
aip p {
  participant a {
    given limit : int
    var n : int = 7
    let near = n - limit
    process = A . later(limit + 1)
    later(m : int) = [B]
  }
  control a { enter A : [limit > 0 && near == 5] }
  control later {
    enter B : [n > limit && m == limit + 1]
    skip  B : else
  }
}
srm R {
  plays p.a with limit = n * 2
  var n : int = 0
  liveness { R = a || Count+ }
  control R { repeat Count : / n = n + 1  leave Count : after(1h) }
}
""".replace("1h", "60min")


def test_the_names_of_an_input_are_those_of_the_role(play: Play) -> None:
    """Participant and role have a variable `n`; the value is the current one wherever it is read."""
    run = play(INPUT).step()
    assert run.active == ["0.2.1.2.1", "Count"]
    run.step(run.done("Count"))
    run.step()
    assert run.active == ["A", "Count"]
    assert run.variable("n") == 1
    run.step(run.done("A"))
    assert run.active == ["B", "Count"]


RESULT = """
aip p {
  participant a {
    result best : int = 1
    process = A . B
  }
  participant b { sends inform Note  receives request Note  process = X }
  control a {
    enter B : / best = 2
    leave B : / best = best + 5
  }
}
srm R {
  plays p.a with best = last
  var best : int = 40
  var last : int = 30
  liveness { R = (a [> Stop) . (C | D) }
  control R {
    enter Stop : after(10s)
    enter C : [last == 7]
    enter D : else
  }
}
"""


def test_a_result_is_there_when_the_part_is_complete(play: Play) -> None:
    run = play(RESULT).step()
    run.step(run.done("A"))
    assert (run.variable("last"), run.variable("best")) == (30, 40)
    run.step(run.done("B"))
    assert (run.variable("last"), run.variable("best")) == (7, 40)
    assert run.active == ["C"]


def test_a_part_that_is_left_early_gives_no_result(play: Play) -> None:
    run = play(RESULT).step()
    run.step(run.done("A"))
    run.step(ms=10_000)
    assert run.active == ["Stop"]
    run.step(run.done("Stop"))
    assert run.variable("last") == 30
    assert run.active == ["D"]


def test_each_place_of_a_participant_is_supplied(play: Play) -> None:
    run = play("""
        aip p {
          participant a { given n : int  result next : int  process = A(n) }
          control a { leave A : / next = n + 1 }
        }
        srm R {
          plays p.a with n = x, next = x
          plays p.a as other with A = C, n = 2 * (x + size([1, 2])), next = y
          var x : int = 1  var y : int
          liveness { R = a . other }
          activities { A(n : int)  C(n : int) }
        }
    """).step()
    assert run.did[-1] == "start A(n=1)"
    assert run.step(run.done("A")).did[-1] == "start C(n=8)"
    run.step(run.done("C"))
    assert (run.variable("x"), run.variable("y")) == (2, 9)


@pytest.mark.parametrize("value", ["has(t.state.M) && t.state.M.on", "!has(t.state.M) || t.state.M.on"])
def test_an_input_wakes_the_participant(play: Play, value: str) -> None:
    run = play(f"""
        aip p {{
          participant a {{ given ready : bool  process = A . B }}
          control a {{ enter B : when [ready] }}
        }}
        srm R {{ plays p.a with ready = {value}  liveness {{ R = a }} }}
    """)
    run.step(run.heard("t.state.M", on=False))
    assert run.active == ["A"]
    run.step(run.heard("t.state.M", on=True))
    assert run.active == ["B"]


MESSAGES = """
message Inner { int y }
message Order { int id  Inner inner }
aip p {
  participant a {
    given order : Order
    var kept : Order
    let far = order.inner.y > 5
    process = A . [B(order.id)] . C
  }
  control a {
    enter B : [far && order.id == 3]
    skip  B : else
    enter C : [order.id == 4] / kept = order
  }
}
srm R {
  plays p.a with order = GIVEN
  var now : Order
  var q : list of Order
  activities { B(n : int) takes 1s }
  liveness { R = Wait . (a || Change) }
  control R { enter (a || Change) : / now = Order { id = 3, inner = Inner { y = 7 } }; append(q, now) }
}
"""


@pytest.mark.parametrize("given", ["now", "q[0]", "size(q) > 0 ? now : q[0]"])
def test_an_input_is_a_message(play: Play, given: str) -> None:
    run = play(MESSAGES.replace("GIVEN", given)).step()
    run.step(run.done("Wait"))
    run.step(run.done("A"))
    assert "B" in run.active
    run.step(run.done("B"))
    assert "C" not in run.active


def test_an_input_without_a_message_is_absent(play: Play) -> None:
    """The role has not set the variable: conditions over its members do not hold."""
    run = play(MESSAGES.replace("GIVEN", "other").replace("var now", "var other : Order  var now")).step()
    run.step(run.done("Wait"))
    run.step(run.done("A"))
    assert "B" not in run.active
