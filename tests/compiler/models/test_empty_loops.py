"""A loop whose body may be empty is refused (E303), unless each round waits for time or an event."""

from __future__ import annotations

import pytest

from tests.support.compiling import codes

_BRANCHES = "enter [A] : [go] skip A : else enter A : [go] enter B : else"
_LEAVE = "leave ([A] | B) : [!go]"


def _role(formula: str, control: str, more: str = "") -> str:
    return f"""
    system S message Go {{ bool on }} topic site {{ state Go }}
    let go = has(site.state.Go)
    srm role {{ liveness {{ role = {formula} {more} }} activities {{ A takes 1s B takes 1s }}
    control role {{ {control} }} }}"""


@pytest.mark.parametrize(
    "repeat",
    [
        "repeat ([A] | B) every 200ms : [go]",
        "repeat ([A] | B) every 200ms :",
        "repeat ([A] | B) : after(1s)",
        "repeat ([A] | B) : again [go]",
        "repeat ([A] | B) : [expired(pace) && go] / start_timer(pace, 1s)",
        "repeat ([A] | B) : after(1s) repeat ([A] | B) : again",
    ],
)
def test_a_loop_whose_rounds_wait_is_accepted(repeat: str) -> None:
    control = f"{_BRANCHES} {repeat} {_LEAVE}"
    assert "E303" not in codes(_role("([A] | B)+", control))
    assert "W403" not in codes(_role("([A] | B)+", control))


@pytest.mark.parametrize(
    "repeat",
    [
        "repeat ([A] | B) : [go]",
        "repeat ([A] | B) : when [go]",
        "repeat ([A] | B) : after(0s)",
        "repeat ([A] | B) : after(1s) or after(0s)",
        "repeat ([A] | B) : [expired(pace)]",
        "repeat ([A] | B) : [expired(pace) || go] / start_timer(pace, 1s)",
        "repeat ([A] | B) : [expired(pace)] / start_timer(pace, 0s)",
        "repeat ([A] | B) every 200ms : [go] repeat ([A] | B) : [!go]",
        "",
    ],
)
def test_a_loop_with_a_round_that_does_not_wait_is_refused(repeat: str) -> None:
    assert "E303" in codes(_role("([A] | B)+", f"{_BRANCHES} {repeat} {_LEAVE}"))


def test_a_wait_inside_the_body_is_enough() -> None:
    control = "enter A : [go] skip A : after(1s) repeat [A] : [true]"
    assert "E303" not in codes(_role("[A]~", control))
    assert "E303" in codes(_role("[A]~", control.replace("after(1s)", "else")))
    control = "enter [A] : again enter B : [go] enter A : [go] skip A : else"
    assert "E303" not in codes(_role("([A] | B)~", control))


def test_a_loop_around_one_with_a_pace_needs_a_pace_of_its_own() -> None:
    inner = "enter A : [go] skip A : else repeat [A] every 1s : [go] leave [A] : else"
    assert "E303" in codes(
        _role("inner~", "", "inner = [A]+").replace("control role {  }", f"control inner {{ {inner} }}")
    )
    paced = f"control inner {{ {inner} }} control role {{ repeat inner every 1s : }}"
    assert "E303" not in codes(_role("inner~", "", "inner = [A]+").replace("control role {  }", paced))
