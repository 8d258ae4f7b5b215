"""Many agents in one process share clocks, threads and processes."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.driver.real_time import RealTime
from tests.faults.test_activities import folder
from tests.runtime.playing import SECOND, make, play
from tests.support.waiting import LONG

SMALL = """
system S
srm R {
  var n : int = 0
  liveness { R = (Look . Act)+ || Listen }
  activities { Look takes 20ms }
  control R { repeat (Look . Act) : [n < 3] / n = n + 1  leave (Look . Act) : else }
}
"""


class Act:
    def execute(self, context: Context) -> Iterator[float]:
        yield 0.001


class Listen:
    async def execute(self, context: Context) -> None:
        await context.sleep(0.01)


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_a_thousand_small_agents_run_in_one_process(clock: str) -> None:
    most = threading.active_count()
    team, _ = make(
        SMALL,
        {"Act": Act, "Listen": Listen},
        agents=[(f"robot{number}", "R") for number in range(1000)],
        clock=clock,
        until=round(LONG) * SECOND,
    )

    def count(team: object) -> None:
        nonlocal most
        most = max(most, threading.active_count())

    before = most
    team._stop = count
    result = team.run()
    assert result.reason == "finished" and not result.failed
    assert all(agent.finished for agent in result.agents)
    assert most <= before + 3  # the timers, the event loop, and one that goes on stepping on a slow machine


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_a_team_of_22_shares_threads_and_processes(clock: str, tmp_path: Path) -> None:
    text = """
    system S
    srm R { liveness { R = Pause . Think . Walk } activities { Pause every 10ms  Think as process } }
    """
    walk = "class Walk:\n    def execute(self, context):\n        context.wait(0.02)\n"
    think = (
        "import os\nclass Think:\n    def execute(self, context):\n"
        "        context.log(f'{os.getpid()}')\n        sum(range(100000))\n"
    )
    pause = "class Pause:\n    def execute(self, context):\n        context.wait(0.01)\n"
    run = play(
        text,
        activities_in(folder(tmp_path, walk=walk, think=think, pause=pause)),
        agents=[(f"robot{number}", "R") for number in range(22)],
        clock=clock,
        path=[tmp_path],
        real_time=RealTime(processes=6),
        until=round(LONG) * SECOND,
    )
    assert run.result.reason == "finished" and not run.result.failed
    used = {record["text"] for record in run.of("log")}
    assert len(used) <= (6 if clock == "real" else 22) and (clock == "real") == (str(os.getpid()) not in used)
