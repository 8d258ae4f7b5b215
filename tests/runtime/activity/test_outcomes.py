"""Outcomes and deadlines as they run: activities of all four kinds, those without code, the trace."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from tests.runtime.playing import Played, play

TEXT = """
system S
srm R {
  liveness { R = Grasp . (Place | Open) }
  activities { Grasp ends held, slipped  Place takes 1s  Open takes 1s }
  control R { enter Place : [outcome(Grasp) == held]  enter Open : else }
}
"""


class InThread:
    def execute(self, context: Context) -> str:
        context.wait(0.1)
        return "slipped"


class InLoop:
    async def execute(self, context: Context) -> str:
        await context.sleep(0.1)
        return "slipped"


class InStep:
    def execute(self, context: Context) -> Iterator[float]:
        yield 0.1
        return "slipped"


class AtOnce:
    kind = "step"

    def execute(self, context: Context) -> str:
        return "slipped"


class InProcess:
    kind = "process"

    def execute(self, context: Context) -> str:
        return "slipped"


def ends(run: Played) -> list[Any]:
    return [record.get("outcome") for record in run.of("activity", what="end")]


@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize("code", [InThread, InLoop, InStep, AtOnce, InProcess])
def test_what_execute_returns_is_the_outcome(code: type[Any], clock: str) -> None:
    text = TEXT.replace("1s", "10ms")
    run = play(text, {"Grasp": code}, clock=clock, path=[Path(__file__).parent])
    assert ends(run) == ["slipped", None]
    assert run.order("end") == ["end Grasp", "end Open"]
    assert run.result.reason == "finished"


def test_without_code_the_first_one_listed_is_the_outcome() -> None:
    run = play(TEXT)
    assert ends(run) == ["held", None]
    assert run.order("end") == ["end Grasp", "end Place"]


class Gone:
    def execute(self, context: Context) -> str:
        return "gone"


class Nothing:
    def execute(self, context: Context) -> None:
        context.log("done")


class Three:
    kind = "process"

    def execute(self, context: Context) -> int:
        return 3


@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize(
    ("code", "said"),
    [
        (Gone, "it returned gone: it ends held or slipped"),
        (Nothing, "it returned nothing: it ends held or slipped"),
        (Three, "it returned <int>: it ends held or slipped"),
    ],
)
def test_anything_else_fails_the_state(code: type[Any], said: str, clock: str) -> None:
    run = play(TEXT, {"Grasp": code}, clock=clock, path=[Path(__file__).parent])
    (crash,) = run.of("activity", what="crash")
    assert crash["reason"] == f"ActivityError: {said}"
    (error,) = run.of("error")
    assert said in error["reason"] and error["at"].startswith("test.aseme:4:")


def test_what_an_activity_without_outcomes_returns_is_ignored() -> None:
    run = play("system S srm R { liveness { R = Grasp } }", {"Grasp": Gone})
    assert run.result.reason == "finished"
    assert ends(run) == [None]


# ---- deadlines -----------------------------------------------------------------------------------

LATE = """
system S
srm R {
  liveness { R = Grasp . Open }
  activities { Grasp within 5s  Open takes 1s }
  control R {
    enter Open :
    enter Open : error
  }
}
"""


class Slow:
    def execute(self, context: Context) -> None:
        context.wait(60)
        raise AssertionError("it is cancelled before")


class Stubborn:
    async def execute(self, context: Context) -> None:
        for _ in range(2):
            try:
                await context.sleep(8)
            except BaseException:
                context.log("not yet")


def test_past_its_deadline_an_activity_is_told_and_the_failure_is_taken() -> None:
    run = play(LATE, {"Grasp": Slow})
    assert run.activities("start", "cancel", "late", "end") == [
        "0 start Grasp",
        "5000 cancel Grasp",
        "5000 start Open",
        "5000 late Grasp",
        "6000 end Open",
    ]
    (cancel,) = run.of("activity", what="cancel")
    assert cancel["reason"] == "not done within 5 s"


def test_one_that_does_not_listen_delays_nothing() -> None:
    run = play(LATE, {"Grasp": Stubborn})
    assert run.activities("cancel", "start")[1:] == ["5000 cancel Grasp", "5000 start Open"]


def test_a_deadline_that_nobody_takes_stops_the_agent_at_its_place() -> None:
    run = play(
        "system S srm R { liveness { R = A . Grasp } activities { Grasp within 1s } }", {"Grasp": Slow}
    )
    (error,) = run.of("error")
    assert error["reason"] == "activity Grasp of state 0.3 failed: not done within 1 s"
    assert error["at"].startswith("test.aseme:1:")
    assert error["time"] == 1_100_000_000


def test_the_deadline_counts_from_the_entry_not_from_the_start() -> None:
    """ "counted from the entry of the state": a period that holds the start back takes from it"""
    run = play(
        """
        system S
        srm R {
          liveness { R = (Grasp . Rest)~ }
          activities { Grasp every 10s takes 1s within 5s  Rest takes 1s }
          control R {
            repeat (Grasp . Rest) :
            repeat (Grasp . Rest) : error
          }
        }
        """,
        until=12_000_000_000,
    )
    assert run.activities("start", "cancel")[:4] == [
        "0 start Grasp",
        "1000 start Rest",
        "7000 cancel Grasp",
        "10000 start Grasp",
    ]
