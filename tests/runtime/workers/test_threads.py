"""Threads of activities: as many from the beginning as the charts can need at once, and no more later."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.trace.trace import Record
from tests.faults.changing import version
from tests.faults.test_activities import folder
from tests.runtime.playing import MS, SECOND, make
from tests.support.generated import generate
from tests.support.waiting import LONG

TEXT = """
system S
srm R {
  liveness { R = (First . Second . (Third | Fourth))~ || (Fifth . Sixth)~ || Codeless~ || Waits~ || Boss }
  activities { Codeless takes 3ms }
  control R {
    enter Third : [true]
    enter Fourth : else
    repeat Waits : again
    leave Boss : finished
  }
}
"""
ROUNDS = 50


@pytest.fixture(autouse=True)
def never_late(monkeypatch: pytest.MonkeyPatch) -> None:
    """What waits for long, as on a machine that stands still for a while, gets another thread: not here."""
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.LOOK", 600.0)


def activity_threads() -> set[threading.Thread]:
    return {thread for thread in threading.enumerate() if thread.name.startswith("aseme activity")}


def counts(agents: int, **options: int) -> list[int]:
    """How many threads of activities there were in a run, each time an activity began."""
    seen: list[int] = []
    enough = 20 * ROUNDS * agents
    before = activity_threads()  # those of other runs, which may come to their end meanwhile

    class Quick:
        def execute(self, context: Context) -> None:
            seen.append(len(activity_threads() - before))

    class Waits:
        def execute(self, context: Context) -> None:
            seen.append(len(activity_threads() - before))
            context.wait(60)

    class Boss:
        async def execute(self, context: Context) -> None:
            for _ in range(ROUNDS):
                await context.sleep(0.002)
                context.raise_event("again")
            context.raise_event("finished")

    quick = dict.fromkeys(("First", "Second", "Third", "Fourth", "Fifth", "Sixth"), Quick)
    team, _ = make(
        TEXT,
        {**quick, "Waits": Waits, "Boss": Boss},
        agents=[(f"robot{number}", "R") for number in range(agents)],
        clock="real",
        until=round(LONG) * SECOND,
        stop=lambda team: "enough" if len(seen) > enough else None,
        real_time=RealTime(**options),
    )
    team.run()
    return seen[:enough]  # at the end they go


@pytest.mark.parametrize("agents", [1, 4])
def test_no_thread_is_added_when_one_activity_follows_another(agents: int) -> None:
    """One for each of three regions, and one each for what is on its way out when the next begins."""
    assert set(counts(agents)) == {2 * 3 * agents}


def test_no_more_are_made_than_there_may_be() -> None:
    assert max(counts(1, threads=2)) == 2


def test_another_plan_that_needs_more_has_them_when_it_begins() -> None:
    text = """
    system S
    srm R { liveness { R = Short } }
    srm W { liveness { W = Wide~ || Wider~ || Widest~ } }
    team T { me : R }
    """
    generated = generate(text)
    begun = threading.Event()

    class Short:
        def execute(self, context: Context) -> None:
            begun.set()
            context.wait(60)

    seen: list[int] = []
    before = activity_threads()

    class Wide:
        def execute(self, context: Context) -> None:
            seen.append(len(activity_threads() - before))
            context.wait(0.001)

    classes = {"Short": Short, "Wide": Wide, "Wider": Wide, "Widest": Wide}
    team, _ = make(
        generated,
        classes,
        version=version(generated, classes),
        clock="real",
        until=round(LONG) * SECOND,
        stop=lambda team: "enough" if len(seen) > 300 else None,
    )
    (agent,) = team.agents

    def choose() -> None:
        if begun.is_set():
            agent.errand(change)
        else:
            team.driver.at(team.driver.clock.now() + MS, choose)

    def change() -> None:
        team.choose(agent, "W", "operator")

    team.driver.at(50 * MS, choose)
    team.run()
    assert begun.is_set() and set(seen[:300]) == {6}


def test_one_activity_after_the_other_keeps_one_process(tmp_path: Path) -> None:
    """A process that has just returned is preferred to a new one."""
    text = """
    system S
    srm R { liveness { R = (A . B)~ } activities { A as process  B as process } }
    """
    code = "import os\nclass {}:\n    def execute(self, context):\n        context.log(str(os.getpid()))\n"
    logs: list[str] = []

    def heed(record: Record) -> None:
        if record["kind"] == "log":
            logs.append(record["text"])

    team, _ = make(
        text,
        activities_in(folder(tmp_path, a=code.format("A"), b=code.format("B"))),
        path=[tmp_path],
        clock="real",
        until=round(LONG) * SECOND,
        listeners=[heed],
        stop=lambda team: "enough" if len(logs) > 40 else None,
    )
    team.run()
    assert len(set(logs)) == 1
