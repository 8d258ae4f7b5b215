"""`plays P.x with A = f`: a formula of the role stands for an activity of the participant."""

from __future__ import annotations

from tests.behaviour.conftest import Play

TEXT = """
aip p {
  participant a {
    var n : int = 5
    process = A . again+ . [C]
    again   = B(n)
  }
  control a {
    enter  again+ : / n = n + 1
    repeat again  : [n < 8] / n = n + 1
    leave  again  : else
    enter  C      : [done(again) || n == 8]
    skip   C      : else
  }
}
srm R {
  plays p.a with B = work
  var n : int = 100
  liveness {
    R          = a
    work(goal) = (Go(goal) . Do(n)) || X
  }
  activities { Go(to : int)  Do(what : int)  B(m : int) }
  control work { enter Do : [goal < 7] / n = n + goal  enter Do : else }
}
"""


def test_what_the_formula_is_given_and_reads(play: Play) -> None:
    """The argument is in terms of the participant, all else in the formula in terms of the role."""
    run = play(TEXT).step()
    run.step(run.done("A"))
    assert "start Go(to=6)" in run.did and "start X" in run.did
    run.step(run.done("Go"))
    assert "start Do(what=106)" in run.did
    run.step(run.done("X"))
    run.step(run.done("Do"))
    assert "start Go(to=7)" in run.did
    run.step(run.done("Go"))
    assert "start Do(what=106)" in run.did
    run.step(run.done("X"))
    run.step(run.done("Do"))
    assert "start Go(to=8)" in run.did
    run.step(run.done("Go"), run.done("X"))
    run.step(run.done("Do"))
    assert run.active == ["C"]


def test_what_is_asked_of_the_activity_is_asked_of_the_formula(play: Play) -> None:
    run = play("""
        aip p {
          participant a { var n : int  process = Work || Watch }
          control a { on Watch : when [in(Work)] / n = n + 1  enter Work : after(1s)  }
        }
        srm R {
          plays p.a with Work = work
          liveness { R = a . work  work = First . Second }
        }
    """).step()
    run.step(ms=1000)
    assert run.active == ["First", "Watch"]
    run.step(run.done("First"))
    assert run.active == ["Second", "Watch"]


def test_instances_have_their_number_in_the_formula(play: Play) -> None:
    run = play("""
        aip p { participant a { process = Work } }
        srm R {
          plays p.a with Work = work
          liveness { R = a[2]  work = Do(index) }
          activities { Do(number : int) }
        }
    """).step()
    started = [line for line in run.did if line.startswith("start")]
    assert started == ["start Do(number=1)", "start Do(number=2)"]


NESTED = """
aip p {
  participant a {
    sends inform Note  receives request Note
    process = A . Work . B
  }
  participant z { sends request Note  receives inform Note  process = Z }
  control a { enter B : inform2 }
  control z { enter Z : / send request Note { text = "" } to a  leave Z : inform Note from a }
}
aip q {
  participant c { sends request Note  receives inform Note  process = C . D }
  participant d { sends inform Note  receives request Note  process = E }
  control c {
    enter C : / send request Note { text = "x" } to d; start_timer(late, 5s)
    enter D : inform Note from d or after(4s)
    leave D : when [expired(late)]
  }
  control d { enter E : request Note from c / send inform Note { text = "" } to c }
}
srm R {
  plays p.a with Work = work
  plays q.c
  var n : int = 0
  liveness { R = (a [> Stop)~  work = First . c }
  control R {
    enter Stop : when [n == 1]
    resume a : [n > 0] / n = 2
    enter a : else
  }
}
"""


def test_a_part_inside_a_part_goes_on_with_it(play: Play) -> None:
    """Time stands still in both; the inner one is told after the outer one."""
    text = NESTED.replace(
        "  control a { enter B : inform2 }", "  control a { leave B : / send inform Note { .. } to z }"
    )
    run = play(text).step()
    for activity in ("A", "First"):
        run.step(run.done(activity))
    assert run.active == ["C"]
    run.step(run.wrote("n", 1), ms=3000)
    assert run.active == ["Stop"]
    outer, inner = (b.label for b in run.plan.branches)
    assert [line for line in run.did if "suspend" in line] == [f"suspend {inner}", f"suspend {outer}"]
    run.step(run.done("Stop"), ms=7000)
    assert [line for line in run.did if "resume" in line] == [f"resume {outer}", f"resume {inner}"]
    assert run.active == ["C"]
    run.step(ms=900)
    assert run.active == ["C"]
    run.step(ms=100)
    assert run.active == ["D"]
    run.step(ms=900)
    assert run.active == ["D"]
    run.step(ms=100)
    assert run.active == ["B"]
