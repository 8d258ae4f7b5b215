"""A plain class of many states and events is generated in linear time."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

from aseme_dsl.codegen.plain.generate import generate_plain
from aseme_dsl.codegen.plain.options import PlainCode, PlainOptions
from tests.support.generated import generate, system_of
from tests.support.plain_engine import plain_class


@pytest.mark.parametrize("watched", [False, True], ids=["bare", "watched"])
def test_four_times_the_states_and_events_are_four_times_the_work(watched: bool) -> None:
    calls = [_calls(lambda n=n: _generated(n, watched)) for n in (50, 200)]
    assert calls[1] < 5 * calls[0]


@pytest.mark.parametrize("watched", [False, True], ids=["bare", "watched"])
@pytest.mark.parametrize(
    "also", ["e{} or after({}s)", "e{} enter S{} : after(5s)", "e{} enter S{} : [x == {}]"]
)
def test_four_times_the_states_that_do_not_only_wait_for_events_are_four_times_the_text(
    also: str, watched: bool
) -> None:
    lines = [len(_generated(n, watched, also).body) for n in (50, 200)]
    assert lines[1] < 5 * lines[0]
    assert lines[0] < 7_500


def test_so_they_are_in_several_regions() -> None:
    lines = []
    for states in (25, 100):
        names = [[f"{region}{number}" for number in range(states)] for region in "AB"]
        formula = " || ".join(f"({' . '.join(of)})~" for of in names)
        ways = " ".join(
            f"enter {name} : e{name} enter {name} : after(1s) / x{name[0]} = x{name[0]} + 1"
            for of in names
            for name in of[1:]
        )
        values = "var xA : int = 0 var xB : int = 0"
        text = f"system S srm R {{ {values} liveness {{ R = {formula} }} control R {{ {ways} }} }}"
        lines.append(len(_class(text, watched=False).body))
    assert lines[1] < 5 * lines[0]


def test_a_step_with_an_event_takes_what_all_events_share() -> None:
    made = generate(_text(40, "e{} or after({}s)"))
    chart = plain_class(made, "R", PlainOptions())()
    chart.start()
    taken = []
    for now, event in ((0, "eS2"), (1, "eS1"), (1, "eS3"), (2, "eS1"), (3, "again"), (4, "eS9")):
        chart.now = now * 10**9
        taken.append((chart.send(event), *chart.names()))
    assert taken == [
        (False, "S0"),
        (True, "S1"),
        (False, "S1"),
        (False, "S1"),
        (True, "S2"),
        (False, "S2"),
    ]


def _generated(states: int, watched: bool, also: str = "e{}") -> PlainCode:
    """Generate the class of a chart with an event for each state."""
    return _class(_text(states, also), watched)


def _text(states: int, also: str) -> str:
    names = [f"S{number}" for number in range(states)]
    waits = [also.replace("e{}", f"e{name}").replace("{}", name[1:]) for name in names]
    ways = " ".join(f"enter {name} : {wait}" for name, wait in zip(names[1:], waits[1:], strict=True))
    formula = f"R = ({' . '.join(names)})~"
    control = f"control R {{ {ways} leave {names[-1]} : again }}"
    return f"system S srm R {{ var x : int = 0 liveness {{ {formula} }} {control} }}"


def _class(text: str, watched: bool) -> PlainCode:
    system = system_of(text)
    chart = system.iac("R")
    assert chart is not None
    return generate_plain(system, chart, "R", PlainOptions(watched=watched))


def _calls(do: Callable[[], None]) -> int:
    """How many functions of the generator are called, after what is kept has been made."""
    do()
    count = 0

    def counting(frame: Any, event: str, argument: Any) -> None:
        nonlocal count
        count += event == "call" and "codegen" in frame.f_code.co_filename

    sys.setprofile(counting)
    try:
        do()
    finally:
        sys.setprofile(None)
    return count
