"""What a plain class does when an activity returns, or a method of the program raises something."""

from __future__ import annotations

import logging
from typing import Any

import pytest

from aseme_dsl.codegen.plain.options import PlainOptions
from aseme_dsl.runtime.plain.machine import Machine
from aseme_dsl.runtime.plain.plain import NotStarted
from tests.support.generated import generate
from tests.support.plain_engine import plain_class

BARE, WATCHED = PlainOptions(), PlainOptions(watched=True)


def made(text: str, options: PlainOptions = BARE) -> Any:
    return plain_class(generate(text), "R", options)


def started(text: str, options: PlainOptions = BARE) -> Any:
    chart = made(text, options)()
    chart.start()
    return chart


LETTERS = "ABCDEFGHIJKLMNOP"
WIDE = " || ".join(f"({LETTERS[n]} . {LETTERS[n + 1]})~" for n in range(0, 16, 2))


@pytest.mark.parametrize("options", [BARE, WATCHED], ids=["bare", "watched"])
def test_nothing_else_is_looked_at_where_nothing_else_can_move(options: PlainOptions) -> None:
    """An AND of eight activities: who returns is found, and no step is made beside that."""
    kind = made(f"system S srm R {{ liveness {{ R = {WIDE} }} }}", options)

    class Counting(kind):  # type: ignore[misc, valid-type]
        steps = 0

        def step(self) -> bool:
            Counting.steps += 1
            taken: bool = super().step()
            return taken

    chart = Counting()
    chart.start()
    chart.done("A")  # finds out where it is
    Counting.steps = 0
    for name in "BACPOD":
        chart.done(name)
    assert Counting.steps == 1  # P does not run: any step
    assert chart.names() == ("B", "C", "E", "G", "I", "K", "M", "P")


def test_what_else_is_enabled_is_taken_in_the_same_step() -> None:
    text = """
system S
message Road { int cars }
topic road { state Road }
srm R {
  liveness { R = (A . B)~ || (C . D)~ }
  control R { enter D : [road.state.Road.cars > 0] }
}
"""
    module = generate(text)
    chart = plain_class(module, "R", BARE)()
    chart.start()
    assert not chart.done("C")
    chart.bb.road_state_Road = module.messages.Road(cars=1)
    assert chart.done("A")
    assert chart.names() == ("B", "D")


def test_what_follows_in_further_rounds_is_taken() -> None:
    chart = started("system S srm R { liveness { R = (A . (B || C . D) . E)~ } }")
    for name in ("A", "C", "D"):
        assert chart.done(name)
    assert chart.names() == ("B",)
    assert chart.done("B")
    assert chart.names() == ("E",)


def test_a_large_chart_finds_what_has_returned() -> None:
    names = [f"S{number}" for number in range(300)]
    lines = " || ".join(f"({' . '.join(names[n : n + 3])})~" for n in range(0, 300, 3))
    chart = started(f"system S srm R {{ liveness {{ R = {lines} }} }}")
    for name in ("S0", "S150", "S297", "S151", "S1"):
        assert chart.done(name)
    assert [name for name in chart.names() if int(name[1:]) % 3] == ["S2", "S152", "S298"]
    long = started(f"system S srm R {{ liveness {{ R = ({' . '.join(names)})~ }} }}")
    for name in names:
        assert long.done(name), name
        assert not long.done(name), name
    assert long.names() == ("S0",)


TWICE = "system S srm R { liveness { R = Go . Wait . Go } }"


def test_a_state_is_called_by_its_label_or_by_a_name_that_only_it_has() -> None:
    chart = started(TWICE)
    assert chart.done("0.2")
    assert chart.done("Wait")
    assert chart.names() == ("Go 0.4",)
    with pytest.raises(KeyError, match=r"several states Go: 0\.2, 0\.4"):
        chart.done("Go")
    with pytest.raises(KeyError, match=r"no state Gp; it has 0\.2 Go, 0\.3 Wait, 0\.4 Go"):
        chart.done("Gp")
    with pytest.raises(KeyError, match="no state Gp"):
        chart.failed("Gp", "no battery")
    watched = started(TWICE, WATCHED)
    watched.done("0.2")
    with pytest.raises(RuntimeError, match="no battery"):
        watched.failed("Wait", "no battery")


ARM = """
system S
srm R {
  liveness { R = pick . Rest  pick = Grasp . (Place | Open) }
  activities { Grasp takes 2s ends held, slipped }
  control pick { enter Place : [outcome(Grasp) == held]  enter Open : [outcome(Grasp) == slipped] }
}
"""


@pytest.mark.parametrize("options", [BARE, WATCHED], ids=["bare", "watched"])
def test_how_an_activity_has_ended_must_be_one_of_its_ends(options: PlainOptions) -> None:
    chart = started(ARM, options)
    machine = Machine(chart)
    for done in (chart.done, machine.done):
        with pytest.raises(ValueError, match=r"Grasp ends with 'held' or 'slipped'; not with 'slpped'"):
            done("Grasp", "slpped")
        with pytest.raises(ValueError, match="'held' or 'slipped'; it was not said how"):
            done("Grasp")
        assert not done("Place", "held")  # no outcome is expected of it, as in an agent
    assert chart.done("Grasp", "slipped")
    assert chart.names() == ("Open",)
    assert chart.done("Open")


@pytest.mark.parametrize("text", [TWICE, ARM, f"system S srm R {{ liveness {{ R = {WIDE} }} }}"])
def test_a_step_before_the_start_says_what_is_missing(text: str) -> None:
    chart = made(text)()
    calls = (chart.step, lambda: chart.send("tick"), chart.configuration)
    label = next(label for label in chart.RUNNING)
    for call in (*calls, lambda: chart.done(label, *chart.ENDS.get(label, ())[:1])):
        with pytest.raises(NotStarted, match=r"call start\(\) first"):
            call()
    assert "not started" in repr(chart)
    chart.start()
    chart.step()


TWO = """
system S
srm R {
  var n : int = 0
  var m : int = 0
  liveness { R = (A . B)~ || (C . D)~ }
  control R {
    enter B : go / n = n + 1
    leave B : back / n = n + 10
    enter D : go / m = m + n
    leave D : back
  }
}
"""


def test_what_was_written_before_something_is_raised_is_written() -> None:
    """What a region writes reaches the blackboard at the end of the step, also of one that is cut off."""

    class Raising(made(TWO, WATCHED)):  # type: ignore[misc]
        armed = True

        def start_B(self, label: str) -> None:
            if self.armed:
                raise OSError(label)

    chart = Raising()
    chart.start()
    with pytest.raises(OSError, match=r"0\.2"):
        chart.send("go")
    assert (chart.names(), chart.bb.n, chart.bb.m) == (("B", "C"), 1, 0)
    chart.armed = False
    chart.send("go")
    assert (chart.names(), chart.bb.n, chart.bb.m) == (("B", "D"), 1, 1)


def test_a_region_sees_at_the_start_what_it_has_written() -> None:
    text = """
system S
srm R {
  var n : int = 0
  liveness { R = x || y  x = A . B  y = C . D }
  control x { enter A : / n = n + 1  enter B : when [n > 0] / n = n + 10 }
  control y { enter C : when [n > 0]  enter D : go / n = n + 100 }
}
"""
    for options in (BARE, WATCHED):
        chart = started(text, options)
        # The other region sees it in the step that follows the write, which `start` makes as well.
        assert (chart.names(), chart.bb.n) == (("B", "C"), 11)
        assert not chart.step()


def test_a_condition_before_a_choice_that_leads_nowhere_may_fail(caplog: pytest.LogCaptureFixture) -> None:
    text = """
system S
statechart R {
 var k : int = 0
 state 0 OR
 state 0.1 START
 state 0.2 BASIC A
 state 0.3 CONDITION
 state 0.4 BASIC B
  0.1 -> 0.2 :
  0.2 -> 0.3 : go [1 / k > 2]
  0.2 -> 0.4 : go
}
"""
    chart = plain_class(generate(text), "R", BARE)()
    chart.start()
    with caplog.at_level(logging.WARNING, "aseme_dsl.plain"):
        assert chart.send("go")
    assert "division by zero" in caplog.text
    assert chart.names() == ("B",)


@pytest.mark.parametrize("options", [BARE, WATCHED], ids=["bare", "watched"])
def test_a_state_that_waits_has_no_activity_that_returns(options: PlainOptions) -> None:
    chart = started(
        """system S
srm R {
  liveness { R = (Idle . Work)~ }
  activities { Idle waits  Work takes 1s }
  control R { enter Work : go or error }
}""",
        options,
    )
    assert not chart.done("Idle")
    assert chart.names() == ("Idle",)
    assert not hasattr(chart, "start_Idle") and not hasattr(chart, "stop_Idle")
    assert chart.send("go")
    assert chart.names() == ("Work",)
    assert chart.done("Work")
    assert chart.names() == ("Idle",)


@pytest.mark.parametrize("options", [BARE, WATCHED], ids=["bare", "watched"])
def test_what_waits_in_vain_for_a_state_is_never_entered(options: PlainOptions) -> None:
    chart = started(
        "system S srm R { liveness { R = Idle . Work } activities { Idle waits  Work takes 1s } }", options
    )
    assert not chart.done("Idle")
    assert chart.names() == ("Idle",)
