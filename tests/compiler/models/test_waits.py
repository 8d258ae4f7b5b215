"""A choice behind a term is reached when the term is complete: its events wait for that (W405)."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis, codes


def _role(formula: str, control: str, more: str = "") -> str:
    return f"""
    system S message Alarm {{ bool on }} topic site {{ state Alarm }}
    let on = site.state.Alarm.on
    srm role {{ liveness {{ role = {formula} {more} }} control role {{ {control} }} }}"""


@pytest.mark.parametrize(
    ("formula", "control"),
    [
        ("Wait . (Run | Rest)", "enter Run : when [on] enter Rest : when [!on]"),
        ("Wait . (Run | Rest)", "enter Run : after(5s) enter Rest : when [on]"),
        ("Wait . [Run]", "enter Run : when [on] skip Run : else"),
        ("Wait . [Run]", "enter Run : [on] skip Run : error"),
        ("Wait . Run*", "enter Run : when [on] skip Run : [!on] repeat Run : [on] leave Run : else"),
        ("Wait . ((Run | Rest) . Home)", "enter Run : alarm enter Rest : when [on]"),
        (
            "Wait . (Run | Rest)+",
            "enter Run : when [on] enter Rest : when [!on] "
            "repeat (Run | Rest) : [on] leave (Run | Rest) : else",
        ),
        ("Go . Wait . (Run | Rest) . End", "enter Run : when [on] enter Rest : when [!on]"),
    ],
)
def test_an_event_of_a_branch_waits_for_the_term_before_the_choice(formula: str, control: str) -> None:
    assert codes(_role(formula, control)).count("W405") == 1


@pytest.mark.parametrize(
    ("formula", "control"),
    [
        ("Wait . Run", "enter Run : when [on]"),
        ("Wait . [Run]", "enter Run : [on] skip Run : after(1s)"),
        ("(Run | Rest) . Wait", "enter Run : when [on] enter Rest : when [!on]"),
        ("Wait . (Run | Rest)", "enter Run : [on] enter Rest : else"),
        ("Wait . (Run | Rest)", "enter (Run | Rest) : enter Run : when [on] enter Rest : when [!on]"),
        ("Wait . (Run | Rest)", "enter (Run | Rest) : when [on] enter Run : [on] enter Rest : else"),
        ("Wait . [Run]", "enter [Run] : enter Run : when [on] skip Run : when [!on]"),
    ],
)
def test_what_says_which_is_meant_is_not_reported(formula: str, control: str) -> None:
    assert codes(_role(formula, control)) == []


def test_the_hint_names_both_ways_as_control_writes_them() -> None:
    text = _role("Wait . (Run | Rest)", "enter Run : when [on] enter Rest : when [!on]")
    (problem,) = analysis(text).diagnostics
    assert "`Wait`" in problem.message
    assert problem.hint is not None
    assert "`enter (Run | Rest) : when [ … ]`" in problem.hint
    assert "`enter (Run | Rest) :`" in problem.hint
