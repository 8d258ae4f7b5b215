"""Activities that hang, ignore their cancellation, end their process, fill its memory: nothing else stops."""

from __future__ import annotations

import asyncio
import pickle
import re
import textwrap
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.driver.real import RealDriver
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.trace import Record
from aseme_dsl.runtime.workers.processes import get
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.support.waiting import LONG

SOON = RealTime(cancel_within=200 * MS)

LEFT = """
system S
srm R {
  liveness { R = (Work . Next . Boss2) || Boss }
  activities { Next takes 10ms }
  control R { enter Next : stop }
}
"""


class Moment:
    """A moment of a run, for those who wait for it: when a line of the trace has these members."""

    def __init__(self, said: str = "", **members: Any) -> None:
        self._said = said
        self._members = members
        self.event = threading.Event()

    def look(self, record: Record) -> None:
        """The listener."""
        if record.items() >= self._members.items() and self._said in record.get("reason", ""):
            self.event.set()

    async def come(self, context: Context) -> None:
        """In an event loop: until it has come."""
        while not self.event.is_set():
            await context.sleep(0.01)


def stopping(tmp_path: Path, enough: Moment) -> dict[str, type[Any]]:
    """The other two of LEFT: they leave Work when it has begun, and go on until the trace says enough."""

    class Boss:
        async def execute(self, context: Context) -> None:
            while not (tmp_path / "begun").exists():
                await context.sleep(0.01)
            context.raise_event("stop")

    class Boss2:
        async def execute(self, context: Context) -> None:
            await enough.come(context)

    return {"Boss": Boss, "Boss2": Boss2}


def folder(tmp_path: Path, **modules: str) -> Path:
    for name, text in modules.items():
        (tmp_path / f"{name}.py").write_text(textwrap.dedent(text))
    return tmp_path


def run(
    text: str,
    tmp_path: Path,
    options: RealTime = SOON,
    classes: Mapping[str, type[Any]] | None = None,
    moments: Sequence[Moment] = (),
    stop: Callable[[Team], str | None] | None = None,
    **modules: str,
) -> Played:
    """A run in real time with activities from modules, and others that are here."""
    find, here = activities_in(folder(tmp_path, **modules)), classes or {}
    return play(
        text,
        lambda name: here.get(name) or find(name),
        clock="real",
        path=[tmp_path],
        real_time=options,
        until=round(LONG) * SECOND,
        listeners=[moment.look for moment in moments],
        stop=stop,
    )


def faults(played: Played) -> list[str]:
    return [fault["reason"] for fault in played.of("fault") if "W201" not in fault.get("code", "")]


def deaf(kind: str, tmp_path: Path, told: Moment, release: threading.Event) -> type[Any]:
    """An activity that ignores its cancellation: until that is told, or until it is released."""

    class InThread:
        def execute(self, context: Context) -> None:
            (tmp_path / "begun").touch()
            release.wait()

    class InLoop:
        async def execute(self, context: Context) -> None:
            (tmp_path / "begun").touch()
            while True:
                with suppress(asyncio.CancelledError):
                    await told.come(context)
                    return

    return InThread if kind == "thread" else InLoop


DEAF_PROCESS = """
    import time
    from pathlib import Path
    class Work:
        kind = "process"
        def execute(self, context):
            Path(__file__).with_name("begun").touch()
            while True:
                time.sleep(1000)
    """


@pytest.mark.parametrize("kind", ["thread", "async", "process"])
def test_an_activity_that_ignores_its_cancellation_is_reported_and_a_process_killed(
    kind: str, tmp_path: Path
) -> None:
    told, late = Moment("has not ended", kind="fault"), Moment(kind="activity", activity="Work", what="late")
    release = threading.Event()
    classes = stopping(tmp_path, told if kind == "thread" else late)
    modules = {"work": DEAF_PROCESS} if kind == "process" else {}
    if kind != "process":
        classes["Work"] = deaf(kind, tmp_path, told, release)
    try:
        played = run(LEFT, tmp_path, classes=classes, moments=[told, late], **modules)
    finally:
        release.set()
    assert played.result.reason == "finished"
    assert played.order("start", "end")[-1] == "end Boss2"  # the rest goes on
    (fault, *_) = played.of("fault", activity="Work")
    assert fault["agent"] == "me"
    assert "activity Work has not ended 0.2 s after it was cancelled" in fault["reason"]
    if kind == "thread":
        assert re.search(r"\(at test_activities\.py:\d+ in execute\)", fault["reason"])
    if kind == "process":
        (line,) = played.of("activity", what="late")
        assert line["reason"] == "it has not ended 0.2 s after it was cancelled, and was killed"
    assert played.result.left == (("me: Work",) if kind == "thread" else ())


def test_a_stuck_thread_takes_no_place_in_the_pool(tmp_path: Path) -> None:
    """With one thread alone, the next activity runs although the first one never returns."""
    begun, release = threading.Event(), threading.Event()

    class Work:
        def execute(self, context: Context) -> None:
            begun.set()
            release.wait()

    class Next:
        def execute(self, context: Context) -> None:
            release.set()

    class Boss:
        async def execute(self, context: Context) -> None:
            while not begun.is_set():
                await context.sleep(0.01)
            context.raise_event("stop")

    text = "system S srm R { liveness { R = (Work . Next) || Boss } control R { enter Next : stop } }"
    options = RealTime(cancel_within=100 * MS, threads=1)
    played = play(text, {"Work": Work, "Next": Next, "Boss": Boss}, clock="real", real_time=options)
    assert played.result.reason == "finished"
    assert any("all 1 threads for activities are busy: Next" in reason for reason in faults(played))
    assert "end Next" in played.order()


def test_the_wait_for_one_that_does_not_return_is_in_the_trace(tmp_path: Path) -> None:
    text = """
    system S
    srm R { liveness { R = (Work . Next)~ || Boss } control R { repeat (Work . Next) : stop } }
    """
    waits, starts = Moment(kind="activity", what="wait"), list[None]()

    class Work:
        def execute(self, context: Context) -> None:
            starts.append(None)
            (tmp_path / "begun").touch()
            waits.event.wait(LONG)

    classes = {"Work": Work, "Boss": stopping(tmp_path, waits)["Boss"]}
    played = run(
        text, tmp_path, classes=classes, moments=[waits], stop=lambda _: "twice" if len(starts) > 1 else None
    )
    assert played.result.reason == "twice"
    order = [line for line in played.order() if line.endswith(" Work")]
    assert order[:5] == ["start Work", "cancel Work", "wait Work", "late Work", "start Work"]


def test_an_activity_that_blocks_the_event_loop_holds_up_only_those_in_it(tmp_path: Path) -> None:
    told, ended = (
        Moment("blocks the event loop", kind="fault"),
        Moment(kind="activity", what="end", activity="Later"),
    )

    class Block:
        async def execute(self, context: Context) -> None:
            ended.event.wait(LONG)

    class Wait:
        def execute(self, context: Context) -> None:
            told.event.wait(LONG)

    class Later:
        async def execute(self, context: Context) -> None:
            await context.sleep(0.01)

    played = run(
        "system S srm R { liveness { R = Block || (Wait . Later) } }",
        tmp_path,
        RealTime(cancel_within=500 * MS),
        classes={"Block": Block, "Wait": Wait, "Later": Later},
        moments=[told, ended],
    )
    assert played.result.reason == "finished"
    (reason,) = faults(played)
    assert re.search(r"blocks the event loop \(at test_activities\.py:\d+ in execute\)", reason)
    assert played.order("end") == ["end Wait", "end Later", "end Block"]


def test_a_step_activity_that_blocks_is_reported_with_its_place(tmp_path: Path) -> None:
    told, ended = Moment("in one step", kind="fault"), Moment(kind="activity", what="end", activity="Other")

    class Work:
        def execute(self, context: Context) -> Iterator[float]:
            yield 0.01
            ended.event.wait(LONG)
            told.event.wait(LONG)

    class Other:
        def execute(self, context: Context) -> None:
            context.wait(0.05)

    text = "system S srm R { liveness { R = Work } } srm Q { liveness { Q = Other } } team T { a : R  b : Q }"
    played = run(
        text,
        tmp_path,
        RealTime(cancel_within=500 * MS),
        classes={"Work": Work, "Other": Other},
        moments=[told, ended],
    )
    assert played.result.reason == "finished"
    (reason,) = faults(played)
    assert re.match(r"a has been in one step for 0\.5 s \(at test_activities\.py:\d+ in execute\)", reason)
    assert played.order("end") == ["end Other", "end Work"]


ENDS = {
    "sys.exit(3)": "SystemExit: 3",
    "os._exit(3)": "its process has ended with code 3",
    "os.kill(os.getpid(), signal.SIGKILL)": "its process was killed by SIGKILL",
    "os.kill(os.getpid(), signal.SIGSEGV)": "its process was killed by SIGSEGV",
    "bytearray(10**10)": "MemoryError",
}


@pytest.mark.parametrize("what", ENDS)
def test_a_process_activity_that_ends_its_process_fails_and_the_next_one_has_another(
    what: str, tmp_path: Path
) -> None:
    work = f"""
    import os, signal, sys
    class Work:
        kind = "process"
        def execute(self, context):
            {what}
    """
    after = """
    class After:
        kind = "process"
        def execute(self, context):
            context.log("alive")
    """
    text = "system S srm R { liveness { R = Work . After } control R { enter After : error } }"
    played = run(text, tmp_path, RealTime(process_memory=2_000_000_000), work=work, after=after)
    assert played.result.reason == "finished" and not played.result.failed
    (crash,) = played.of("activity", what="crash")
    assert crash["reason"] == ENDS[what]
    assert played.of("log")[0]["text"] == "alive"


def test_a_process_that_leaks_ends_with_its_memory_and_a_new_one_begins(tmp_path: Path) -> None:
    work = """
    import os
    kept = []
    class Work:
        kind = "process"
        def execute(self, context):
            context.log(f"{os.getpid()}")
            kept.append(bytearray(100_000_000))
    """
    text = """
    system S
    srm R { liveness { R = Work~ } control R { repeat Work : error  repeat Work :  } }
    """
    find = activities_in(folder(tmp_path, work=work))
    crashes: list[object] = []

    def count(record: dict[str, object]) -> None:
        if record.get("what") == "crash":
            crashes.append(record["reason"])

    played = play(
        text,
        find,
        clock="real",
        path=[tmp_path],
        listeners=[count],
        real_time=RealTime(process_memory=700_000_000),
        stop=lambda team: "enough" if len(crashes) == 2 else None,
    )
    assert crashes == ["MemoryError", "MemoryError"]
    assert len({record["text"] for record in played.of("log")}) >= 2


def test_a_deadline_that_passes_just_as_a_process_returns_is_not_that_of_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The worker is killed when it has told its end and nobody has looked: it is not given anything more."""
    code = "class {}:\n    kind = 'process'\n    def execute(self, context):\n        context.log('here')\n"
    find = activities_in(folder(tmp_path, work=code.format("Work"), after=code.format("After")))
    text = "system S srm R { liveness { R = Work . After } }"
    team, records = make(text, find, clock="real", path=[tmp_path], until=round(LONG) * SECOND)
    driver, late = team.driver, list[bool]()
    assert isinstance(driver, RealDriver)

    def hear(file: IO[bytes]) -> bytes | None:
        data = get(file)
        if data is not None and pickle.loads(data)[0] == "end" and not late:
            (execution,) = driver.activities._live
            late.append(driver.activities._worker_processes().kill(execution, "it was late"))
        return data

    monkeypatch.setattr("aseme_dsl.runtime.workers.processes.get", hear)
    result = team.run()
    assert late == [True]
    assert result.reason == "finished" and not result.failed, result
    assert [record["activity"] for record in records if record["kind"] == "log"] == ["Work", "After"]


def test_a_thread_activity_that_calls_exit_only_fails(tmp_path: Path) -> None:
    work = """
    import sys
    class Work:
        def execute(self, context):
            sys.exit(3)
    """
    played = run("system S srm R { liveness { R = Work } }", tmp_path, work=work)
    (agent,) = played.result.agents
    assert agent.failure == "activity Work of state 0.2 failed: SystemExit: 3"


def test_a_stopped_worker_holds_up_no_step_and_is_killed(tmp_path: Path) -> None:
    """A worker that listens to nothing (SIGSTOP), and whose pipe is full."""
    work = """
    import os, signal
    from pathlib import Path
    class Work:
        kind = "process"
        def execute(self, context):
            Path(__file__).with_name("begun").touch()
            os.kill(os.getpid(), signal.SIGSTOP)
    """
    late = Moment(kind="activity", activity="Work", what="late")
    played = run(LEFT, tmp_path, classes=stopping(tmp_path, late), moments=[late], work=work)
    assert played.result.reason == "finished"
    (line,) = played.of("activity", what="late")
    assert "and was killed" in line["reason"]


def test_the_deadline_leaves_those_alone_that_return(tmp_path: Path) -> None:
    within = 2 * SECOND

    class Work:
        def execute(self, context: Context) -> None:
            (tmp_path / "begun").touch()
            try:
                context.wait(1000)
            finally:
                time.sleep(0.05)

    class Boss2:
        async def execute(self, context: Context) -> None:
            await context.sleep(1.1 * within / SECOND)  # until the deadline has passed

    classes = {**stopping(tmp_path, Moment()), "Work": Work, "Boss2": Boss2}
    played = run(LEFT, tmp_path, RealTime(cancel_within=within), classes=classes)
    assert played.result.reason == "finished" and not faults(played) and not played.result.left


def test_waiting_starts_are_forgotten_when_they_are_cancelled(tmp_path: Path) -> None:
    """At the maximum, what waits for a thread and is cancelled has never run."""
    ran: list[str] = []
    started, late = (Moment(kind="activity", activity="Work", what=what) for what in ("start", "late"))

    class Long:
        def execute(self, context: Context) -> None:
            late.event.wait(LONG)

    class Work:
        def execute(self, context: Context) -> None:
            ran.append("Work")

    class Boss:
        async def execute(self, context: Context) -> None:
            await started.come(context)
            context.raise_event("stop")

    text = """system S srm R { liveness { R = Long || (Pause . Work . Next) || Boss }
    activities { Pause takes 50ms  Next takes 10ms } control R { enter Next : stop } }"""
    played = run(
        text,
        tmp_path,
        RealTime(threads=1),
        classes={"Long": Long, "Work": Work, "Boss": Boss},
        moments=[started, late],
    )
    assert played.result.reason == "finished" and not ran
    assert [line for line in played.order() if line.endswith(" Work")] == [
        "start Work",
        "cancel Work",
        "late Work",
    ]
