"""A plain class of many states and events is generated in linear time."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

from aseme_dsl.codegen.plain import PlainOptions, generate_plain
from tests.support.generated import system_of


@pytest.mark.parametrize("watched", [False, True], ids=["bare", "watched"])
def test_four_times_the_states_and_events_are_four_times_the_work(watched: bool) -> None:
    calls = [_calls(lambda n=n: _generated(n, watched)) for n in (100, 400)]
    assert calls[1] < 5 * calls[0]


def _generated(states: int, watched: bool) -> None:
    """Generate the class of a chart with an event for each state."""
    names = [f"S{number}" for number in range(states)]
    ways = " ".join(f"enter {name} : e{name}" for name in names[1:])
    formula = f"R = ({' . '.join(names)})~"
    text = f"system S srm R {{ liveness {{ {formula} }} control R {{ {ways} leave {names[-1]} : again }} }}"
    system = system_of(text)
    chart = system.iac("R")
    assert chart is not None
    generate_plain(system, chart, "R", PlainOptions(watched=watched))


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
