"""What activities are given as they run: of all four kinds, in both clocks, and in the trace."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from tests.faults.changing import version
from tests.runtime.playing import MS, make, play

TEXT = """
system S
enum Place { TRAY BENCH }
message Load { int grams }
topic scale { state Load }
srm R {
  var load : int = 2
  liveness { R = Carry(Place.BENCH, load * 3, 1s) . Rest }
  activities { Carry(to : Place, grams : double, slowly : duration) ends done  Rest takes 10ms }
  control R { enter Rest : [outcome(Carry) == done] }
}
"""


def checked(to: Any, grams: Any, slowly: Any) -> str:
    assert (to.name, int(to), grams, slowly) == ("BENCH", 1, 6.0, 1_000_000_000)
    assert isinstance(grams, float)
    return "done"


class InThread:
    def execute(self, context: Context, to: Any, grams: float, slowly: int) -> str:
        return checked(to, grams, slowly)


class InLoop:
    async def execute(self, context: Context, to: Any, grams: float, slowly: int) -> str:
        return checked(to, grams, slowly)


class InStep:
    def execute(self, context: Context, slowly: int, grams: float, to: Any) -> Iterator[float]:
        yield 0.01
        return checked(to, grams, slowly)


class InProcess:
    kind = "process"

    def execute(self, context: Context, **given: Any) -> str:
        return checked(**given)


@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize("code", [InThread, InLoop, InStep, InProcess])
def test_execute_is_given_its_arguments_by_name(code: type[Any], clock: str) -> None:
    run = play(TEXT, {"Carry": code}, clock=clock, path=[Path(__file__).parent])
    assert run.result.reason == "finished", run.of("error")
    (start, _) = run.of("activity", what="start")
    assert start["arguments"] == {"to": "BENCH", "grams": 6.0, "slowly": 1_000_000_000}


def test_an_execute_that_does_not_take_them_fails_and_says_so() -> None:
    class Carry:
        def execute(self, context: Context) -> str:
            return "done" + str(context.now_ns)

    run = play(TEXT, {"Carry": Carry})
    (error,) = run.of("error")
    assert "unexpected keyword argument 'to'" in error["reason"]


def test_an_absent_argument_is_said_with_its_place() -> None:
    text = TEXT.replace("load * 3", "scale.state.Load.grams")
    run = play(text, {"Carry": InThread})
    (error,) = run.of("error")
    name = "Carry(Place.BENCH, scale.state.Load.grams, 1s)"
    assert error["reason"] == f"activity {name} of state 0.2 failed: the argument `grams` is absent"
    assert error["at"].startswith("test.aseme:8:")


MOVING = """
system S
srm R {
  var far : int = 2
  liveness { R = Move(far + 1) . Rest }
  activities { Move(metres : int) takes 1s  Rest takes 1s }
}
"""


@pytest.mark.parametrize(
    ("change", "starts"),
    [
        (("Move(far + 1) . Rest", "Look . Move(far + 1) . Rest"), ["Move 3", "Rest"]),
        (("far + 1", "far + 5"), ["Move 3", "Move 7", "Rest"]),
    ],
)
def test_after_a_swap_an_activity_that_is_given_something_else_begins_anew(
    change: tuple[str, str], starts: list[str]
) -> None:
    team, records = make(MOVING)
    team.swap(version(MOVING.replace(*change)), at=500 * MS)
    team.run()
    told = [
        " ".join([record["activity"], *map(str, record.get("arguments", {}).values())])
        for record in records
        if record["kind"] == "activity" and record["what"] == "start"
    ]
    assert told == starts
