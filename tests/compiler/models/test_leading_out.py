"""Transitions that lead from inside an AND out of it: which are accepted, and what is said of the others."""

from __future__ import annotations

import pytest

from tests.support.compiling import codes, printed, role_chart, system

PAIR = """system S
statechart r {{
  var n : int = 0
  state 0 OR
  state 0.1 START
  state 0.2 AND
  state 0.2.1 OR
  state 0.2.1.1 START
  state 0.2.1.2 BASIC A
  state 0.2.1.3 OR
  state 0.2.1.3.1 START
  state 0.2.1.3.2 BASIC B
  state 0.2.2 OR
  state 0.2.2.1 START
  state 0.2.2.2 BASIC C
  state 0.3 CONDITION
  state 0.4 OR
  state 0.4.1 START
  state 0.4.2 BASIC D
  state 0.5 END
  0.1 -> 0.2 :
  0.2 -> 0.3 : after(9s)
  0.3 -> 0.4 : [n == 1]
  0.3 -> 0.5 : else
  0.4.1 -> 0.4.2 :
  0.4 -> 0.5 : after(1s)
  0.2.1.1 -> 0.2.1.2 :
  0.2.1.2 -> 0.2.1.3 : after(1s)
  0.2.1.3.1 -> 0.2.1.3.2 :
  0.2.2.1 -> 0.2.2.2 :
  {line}
}}
"""


@pytest.mark.parametrize(
    "line",
    [
        "0.2.1.2 -> 0.4 : e",
        "0.2.1.3.2 -> 0.4.2 : e",
        "0.2.1.3 -> 0.5 : e",
        "0.2.1 -> 0.5 : e",
        "0.2.2.2 -> 0.2 : e / n = 1",
        "0.2.2.1 -> 0.5 : when [n == 4]",
        "0.4 -> 0.2.2.2 : e",
        "0.4.2 -> 0.2.1.3.2 : e / n = 1",
        "0.2 -> 0.2.2.2 : e",
        "on 0.2.1 : e / n = 1",
        "exit 0.2.2 : / n = 1",
    ],
)
def test_a_transition_may_lead_out_of_an_and(line: str) -> None:
    assert codes(PAIR.format(line=line)) == []


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("0.2.1.2 -> 0.2.2.2 : e", "a transition from 0.2.1.2 to 0.2.2.2 leads into the region 0.2.2"),
        ("0.2.1 -> 0.2.2.2 : e", "a transition from 0.2.1 to 0.2.2.2 leads into the region 0.2.2"),
        ("0.2.1 -> 0.2.1.2 : e", "a transition from 0.2.1 to 0.2.1.2 leads into the region 0.2.1"),
        ("0.2.1.2 -> 0.2.1 : e", "0.2.1 is a region of 0.2: it is entered with it, not by a transition"),
        ("0.4 -> 0.2.2 : e", "0.2.2 is a region of 0.2: it is entered with it, not by a transition"),
        ("0.2.1.2 -> 0.3 : e", "0.3 is a CONDITION of another region than 0.2.1.2"),
        ("0 -> 0.4 : e", "the root has no transitions: nothing is around it"),
    ],
)
def test_what_concerns_a_single_region_is_refused(line: str, message: str) -> None:
    text = PAIR.format(line=line)
    assert codes(text) == ["E409"]
    assert f"error[E409]: {message}" in printed(text)


def test_out_of_the_inner_one_of_two_ands_is_inside_the_outer_one() -> None:
    text = """system S statechart r {
      state 0 OR  state 0.1 START  state 0.2 AND
      state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 AND
      state 0.2.1.2.1 OR  state 0.2.1.2.1.1 START  state 0.2.1.2.1.2 BASIC A
      state 0.2.1.2.2 OR  state 0.2.1.2.2.1 START  state 0.2.1.2.2.2 BASIC B
      state 0.2.1.3 BASIC C
      state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC D
      state 0.3 END
      0.1 -> 0.2 :  0.2.1.1 -> 0.2.1.2 :  0.2.1.2.1.1 -> 0.2.1.2.1.2 :  0.2.1.2.2.1 -> 0.2.1.2.2.2 :
      0.2.2.1 -> 0.2.2.2 :
      0.2.1.2.1.2 -> 0.2.1.3 : e
      0.2.1.2.2.2 -> 0.3 : f
      0.2 -> 0.3 : after(9s)
    }"""
    chart = system(text).iacs[0]
    out = {item.source: chart.acts_in(item) for item in chart.transitions if item.expression.events}
    assert out == {"0.2.1.2.1.2": "0.2.1", "0.2.1.2.2.2": "0", "0.2": "0"}


def test_a_role_may_add_one_by_label() -> None:
    chart = role_chart("R = (Look || Walk) . Rest", "control R { 0.2.2.1.2 -> 0.3 : after(5s) }")
    assert chart.acts_in(chart.transitions[-1]) == "0"


def test_a_timer_that_it_starts_belongs_to_the_region_around() -> None:
    started = "0.2.1.2 -> 0.4 : e / start_timer(t, 1s)  "
    assert codes(PAIR.format(line=started + "0.4 -> 0.5 : when [expired(t)]")) == []
    assert codes(PAIR.format(line=started + "0.2.1.3 -> 0.2.1.2 : when [expired(t)]")) == ["W501"]


def test_what_only_such_a_transition_leads_to_is_reached() -> None:
    line = "0.2.1.2 -> 0.6 : e  state 0.6 BASIC E  0.6 -> 0.5 :"
    assert codes(PAIR.format(line=line)) == []


def test_an_and_that_restarts_itself_without_waiting_is_reported() -> None:
    assert codes(PAIR.format(line="0.2.2.1 -> 0.2 : when [true]")) == ["W403"]


@pytest.mark.parametrize("line", ["0.2.1.1 -> 0.5 : when [n == 0]", "0.2.1 -> 0.5 : when [n == 0]"])
def test_regions_that_wake_each_other_until_one_of_them_leaves(line: str) -> None:
    text = f"""system S statechart r {{
      var n : int = 0  var m : int = 0
      state 0 OR  state 0.1 START  state 0.2 AND  state 0.5 END
      state 0.2.1 OR  state 0.2.1.1 START  state 0.2.1.2 BASIC A  state 0.2.1.3 END
      state 0.2.2 OR  state 0.2.2.1 START  state 0.2.2.2 BASIC B  state 0.2.2.3 END
      0.1 -> 0.2 :  0.2 -> 0.5 :  {line}
      0.2.1.1 -> 0.2.1.2 : [n == 1] / m = m + 1  0.2.1.2 -> 0.2.1.3 :
      0.2.2.1 -> 0.2.2.2 : [m >= 0] / n = n + 1  0.2.2.2 -> 0.2.2.3 :
    }}"""
    assert "W436" not in codes(text)
