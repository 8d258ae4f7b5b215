"""`on` and `exit` in a `statechart`: what is done in a state without leaving it, and when it is left."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.statechart import Statechart, transition_text
from tests.support.compiling import analysis, codes, printed, system

LAMP = """system S
message Button {{ bool pressed }}  message Ring {{ int times }}
topic panel {{ state Button  signal Ring }}
statechart lamp {{
  var n : int = 0
  state 0 OR
  state 0.1 START
  state 0.2 BASIC Glow
  state 0.3 AND
  state 0.3.1 OR
  state 0.3.1.1 START
  state 0.3.1.2 BASIC Hum
  state 0.3.2 OR
  state 0.3.2.1 START
  state 0.3.2.2 BASIC Blink
  state 0.4 END
  0.1 -> 0.2 :
  0.2 -> 0.3 : [n == 1]
  0.3 -> 0.4 : after(3s)
  0.3.1.1 -> 0.3.1.2 :
  0.3.2.1 -> 0.3.2.2 :
  {lines}
}}
"""


def lamp(lines: str) -> Statechart:
    return system(LAMP.format(lines=lines)).iacs[0]


def staying(chart: Statechart) -> list[tuple[str, str, str, str]]:
    return [
        (item.name, item.kind.value, item.source, item.target)
        for item in chart.transitions
        if not item.changes_state
    ]


def test_lines_that_stay_are_transitions_of_their_state() -> None:
    chart = lamp("on 0.2 : when [panel.state.Button.pressed] / n = 1  exit 0.3 : / n = 2")
    assert staying(chart) == [("GlowON", "on", "0.2", "0.2"), ("0.3EXIT", "exit", "0.3", "0.3")]


def test_a_line_may_stand_anywhere_in_the_block() -> None:
    chart = lamp("exit 0.3.1 : / n = 3  let big = n > 3  on 0.2 : knock [big] / n = 1  var m : int = 0")
    assert [kind for _, kind, _, _ in staying(chart)] == ["exit", "on"]


def test_on_takes_its_turn_in_the_order_of_the_lines() -> None:
    chart = lamp("on 0.2 : when [n > 3] / n = 1  0.2 -> 0.4 : when [n > 4]")
    assert [item.kind.value for item in chart.outgoing("0.2")] == ["external", "on", "external"]


def test_ignored_signals_come_before_the_other_lines() -> None:
    lines = "0.2 -> 0.4 : when [has(panel.signal.Ring)]  on 0.2 : ignores panel.signal.Ring"
    chart = lamp(lines)
    first, *_ = chart.outgoing("0.2")
    assert transition_text(first) == "on ignores panel.signal.Ring"


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("on 0.2 : else / n = 1", "E422"),
        ("on 0.2 : error / n = 1", "E422"),
        ("on 0.2 : when [n > 1]", "E423"),
        ("exit 0.2 : ", "E423"),
        ("exit 0.2 : [n > 1] / n = 2", "E424"),
        ("exit 0.1 : / n = 1", "E612"),
        ("on 0.4 : knock / n = 1", "E612"),
        ("on 0 : knock / n = 1", "E409"),
        ("on 0.7 : knock / n = 1", "E410"),
        ("on 0.2 : knock / m = 1", "E200"),
        ("on 0.2 : knock [1 > 2] / n = 1", "W404"),
        ("enter 0.2 : knock", "E100"),
        ("exit 0.2 : ignores panel.signal.Ring", "E424"),
        ("0.2 -> 0.3 : ignores panel.signal.Ring", "E435"),
        ("on 0.2 : ignores panel.state.Button", "E435"),
        ("on 0.2 : ignores panel.signal.Ring.times", "E435"),
        ("on 0.2 : ignores n", "E435"),
        ("on 0.2 : ignores panel.signal.Ring, panel.state.Button", "E435"),
        ("on 0.2 : ignores panel.signal.Bell", "E502"),
        ("on 0.2 : ignores panel.signal.Ring [n == 1]", "E102"),
    ],
)
def test_what_is_wrong_with_a_line_is_said(line: str, code: str) -> None:
    assert codes(LAMP.format(lines=line)) == [code]


def test_a_mistake_is_shown_where_it_is() -> None:
    text = printed(LAMP.format(lines="exit 0.1 : / n = 1"))
    assert "test.aseme:22:8: error[E612]: 0.1 is START: an agent does not stay in it" in text
    assert "hint: write `exit` for a BASIC, OR or AND state" in text


def test_a_state_may_be_called_on_or_exit() -> None:
    text = """system S statechart r {
      var on : int = 0
      state 0 OR on  state 0.1 START  state 0.2 BASIC exit  state 0.3 END exit 0.2 : / on = on + 1
      0.1 -> 0.2 :  0.2 -> 0.3 : [on == 0]
    }"""
    chart = system(text).iacs[0]
    assert [node.name for node in chart.states] == ["on", "0.1", "exit", "0.3"]
    assert staying(chart) == [("exitEXIT", "exit", "0.2", "0.2")]


def test_on_abandon_of_a_role_says_where_it_stands() -> None:
    text = "system S srm r { liveness { r = A }  control r { on abandon : / x = 1 }  var x : int = 0 }"
    hints = [item.hint for item in analysis(text).diagnostics if item.code == "E400"]
    assert hints == ["`on abandon` stands in the control of a participant: write it in the `aip`"]
