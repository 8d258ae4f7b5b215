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


CHOICE = "enter Run : when [on] enter Rest : when [!on]"


def _roles(liveness: str, control: str) -> str:
    return f"""
    system S message Alarm {{ bool on }} topic site {{ state Alarm }}
    let on = site.state.Alarm.on
    srm role {{ liveness {{ {liveness} }} {control} }}"""


@pytest.mark.parametrize(
    ("liveness", "control"),
    [
        ("role = Wait . decide  decide = Run | Rest", f"control decide {{ {CHOICE} }}"),
        ("role = Wait . decide . End  decide = (Run | Rest) . Home", f"control decide {{ {CHOICE} }}"),
        ("role = Wait . a  a = b . Home  b = Run | Rest", f"control b {{ {CHOICE} }}"),
        ("role = Wait . a  a = b~  b = Run | Rest", f"control b {{ {CHOICE} }}"),
        ("role = Wait . (Look || decide)  decide = Run | Rest", f"control decide {{ {CHOICE} }}"),
        ("role = Wait . decide[2]  decide = Run | Rest", f"control decide {{ {CHOICE} }}"),
        ("role = (Wait . decide)~  decide = Run | Rest", f"control decide {{ {CHOICE} }}"),
        (
            "role = Wait . (decide [> Stop)  decide = Run | Rest",
            f"control decide {{ {CHOICE} }} control role {{ enter Stop : halt }}",
        ),
        (
            "role = Go . one . Back . two  one = Wait . decide  two = Stay . decide  decide = Run | Rest",
            f"control decide {{ {CHOICE} }}",
        ),
        ("role = Wait . decide  decide = [Run]", "control decide { enter Run : alarm  skip Run : else }"),
    ],
)
def test_the_choice_may_be_another_formulas(liveness: str, control: str) -> None:
    assert codes(_roles(liveness, control)) == ["W405"]


@pytest.mark.parametrize(
    ("liveness", "control"),
    [
        ("role = decide . Wait  decide = Run | Rest", f"control decide {{ {CHOICE} }}"),
        (
            "role = Wait . decide  decide = Run | Rest",
            f"control decide {{ {CHOICE} }} control role {{ enter decide : }}",
        ),
        (
            "role = Wait . decide  decide = Run | Rest",
            f"control decide {{ {CHOICE} }} control role {{ enter decide : when [on] }}",
        ),
        (
            "role = Wait . a  a = b . Home  b = Run | Rest",
            f"control b {{ {CHOICE} }} control a {{ enter b : }}",
        ),
        (
            "role = Wait . a  a = (Run | Rest) . Home",
            f"control a {{ {CHOICE} start (Run | Rest) : }}",
        ),
        (
            "role = Wait . decide  decide = Run | Rest",
            "control decide { enter Run : [on]  enter Rest : else }",
        ),
    ],
)
def test_what_says_in_any_formula_which_is_meant_is_not_reported(liveness: str, control: str) -> None:
    assert codes(_roles(liveness, control)) == []
