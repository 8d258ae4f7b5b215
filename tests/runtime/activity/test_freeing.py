"""What activities leave behind is freed as they end: it does not wait for Python's collector of cycles."""

from __future__ import annotations

import gc
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.activity.execution import Execution
from tests.runtime.playing import MS, SECOND, make

TEXT = """
system S
srm R {
  liveness { R = (Quick~ || Waiting~ || Sleeping~ || Stepping~ || Failing~ || Boss) }
  control R {
    repeat Waiting : again   repeat Sleeping : again   repeat Stepping : again   repeat Failing : error
  }
}
"""


class Quick:
    def execute(self, context: Context) -> None:
        context.wait(0.001)


class Waiting:
    def execute(self, context: Context) -> None:
        context.wait(1000)


class Sleeping:
    async def execute(self, context: Context) -> None:
        await context.sleep(1000)


class Stepping:
    def execute(self, context: Context) -> Any:
        yield 1000


class Failing:
    def execute(self, context: Context) -> None:
        context.wait(0.001)
        raise ValueError("it fails")


class Boss:
    async def execute(self, context: Context) -> None:
        while True:
            await context.sleep(0.002)
            context.raise_event("again")


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_activities_that_have_ended_are_freed_at_once(clock: str) -> None:
    kinds = [Quick, Waiting, Sleeping, Stepping, Failing, Boss]
    counts: list[int] = []
    steps = 0

    def look(team: object) -> str | None:
        nonlocal steps
        steps += 1
        if steps in (50, 250):
            counts.append(sum(type(item) is Execution for item in gc.get_objects()))
        return "enough" if len(counts) == 2 else None

    team, _ = make(
        TEXT, {kind.__name__: kind for kind in kinds}, clock=clock, stop=look, until=60 * SECOND + MS
    )
    gc.collect()
    gc.disable()
    try:
        team.run()
    finally:
        gc.enable()
    assert counts[1] <= counts[0] + 60, counts  # those that run just now; else it would be thousands
