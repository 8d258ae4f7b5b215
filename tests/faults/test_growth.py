"""Thousands of starts and cancellations leave no threads, files, processes or timers behind."""

from __future__ import annotations

import gc
import os
import threading
from contextlib import suppress
from pathlib import Path

import psutil
import pytest

from aseme_dsl.runtime import activities_in
from aseme_dsl.runtime.driver.real_time import RealTime
from tests.faults.test_activities import folder
from tests.runtime.playing import MS, make
from tests.support.waiting import LONG, wait_until

STARTS = int(os.environ.get("FAULT_STARTS", "600"))
"""How many starts of each kind; more when there is time."""

TEXT = """
system S
srm R {
  liveness { R = Sitting~ || Waiting~ || Stepping~ || Thinking~ || Boss }
  control R {
    repeat Sitting : again    repeat Waiting : again
    repeat Stepping : again   repeat Thinking : again
  }
}
"""
MODULES = {
    "sitting": "class Sitting:\n    def execute(self, context):\n        context.wait(1000)\n",
    "waiting": "class Waiting:\n    async def execute(self, context):\n        await context.sleep(1000)\n",
    "stepping": "class Stepping:\n    def execute(self, context):\n        yield 1000\n",
    "thinking": (
        "class Thinking:\n    kind = 'process'\n    def execute(self, context):\n        context.wait(1000)\n"
    ),
    "boss": (
        "class Boss:\n    async def execute(self, context):\n        while True:\n"
        "            await context.sleep(0.002)\n            context.raise_event('again')\n"
    ),
}


def there() -> tuple[set[object], ...]:
    """The threads, open files and child processes that there are."""
    files = set()
    for entry in Path("/proc/self/fd").iterdir():
        with suppress(FileNotFoundError):  # it was that of the list
            files.add((entry.name, entry.readlink()))
    return set(threading.enumerate()), files, {child.pid for child in psutil.Process().children()}


@pytest.mark.long
def test_starts_and_cancellations_leave_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # What waits for long, as on a machine that stands still for a while, gets another thread: not here.
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.LOOK", 600.0)
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.GRACE", LONG)
    counts: dict[str, int] = {}
    levels: list[list[int]] = []

    def new() -> list[int]:
        """How many there are of each that were not there before; others' may come to their end meanwhile."""
        return [len(now - earlier) for now, earlier in zip(there(), before, strict=True)]

    def count(record: dict[str, object]) -> None:
        if record.get("what") == "late":
            name = str(record["activity"])
            counts[name] = counts.get(name, 0) + 1

    def enough(team: object) -> str | None:
        done = min(counts.get(name, 0) for name in ("Sitting", "Waiting", "Stepping", "Thinking"))
        if done >= STARTS * (len(levels) + 1) // 4:
            gc.collect()
            levels.append(new())
        return "enough" if done >= STARTS else None

    before = there()
    team, _ = make(
        TEXT,
        activities_in(folder(tmp_path, **MODULES)),
        clock="real",
        path=[tmp_path],
        stop=enough,
        listeners=[count],
        real_time=RealTime(cancel_within=2000 * MS),
        until=(60_000 + 100 * STARTS) * MS,
    )
    result = team.run()
    assert result.reason == "enough" and not result.left
    # One may just have ended that is started again.
    assert all(last <= max(others) for last, *others in zip(levels[-1], *levels[:-1], strict=True)), levels
    wait_until(lambda: not any(new()))  # the system takes a moment to forget a thread that has ended
