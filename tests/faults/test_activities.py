"""Activities that hang, ignore their cancellation, end their process, fill its memory: nothing else stops."""

from __future__ import annotations

import textwrap
import threading
from pathlib import Path

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.real_time import RealTime
from tests.runtime.playing import MS, Played, play

SOON = RealTime(cancel_within=200 * MS)

LEFT = """
system S
srm R {
  liveness { R = (Work . Next . Boss2) || Boss }
  activities { Next takes 10ms }
  control R { enter Next : stop }
}
"""
BOSS = """
class Boss:
    async def execute(self, context):
        await context.sleep(0.1)
        context.raise_event("stop")
"""
BEGUN = """
from pathlib import Path
class Boss:
    async def execute(self, context):
        while not Path(__file__).with_name("begun").exists():
            await context.sleep(0.01)
        context.raise_event("stop")
"""
"""One that waits for what has begun in another process, which takes a busy machine long."""
BOSS2 = """
class Boss2:
    async def execute(self, context):
        await context.sleep(0.6)
"""


def folder(tmp_path: Path, **modules: str) -> Path:
    for name, text in modules.items():
        (tmp_path / f"{name}.py").write_text(textwrap.dedent(text))
    return tmp_path


def run(
    text: str, tmp_path: Path, options: RealTime = SOON, until: int | None = None, **modules: str
) -> Played:
    find = activities_in(folder(tmp_path, **modules))
    return play(text, find, clock="real", path=[tmp_path], real_time=options, until=until)


def faults(played: Played) -> list[str]:
    return [fault["reason"] for fault in played.of("fault") if "W201" not in fault.get("code", "")]


DEAF = {
    "thread": """
        import time
        class Work:
            def execute(self, context):
                time.sleep(2.5)
        """,
    "async": """
        import asyncio
        class Work:
            async def execute(self, context):
                for _ in range(15):
                    try:
                        await asyncio.sleep(0.1)
                    except asyncio.CancelledError:
                        pass
        """,
    "process": """
        import time
        from pathlib import Path
        class Work:
            kind = "process"
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                while True:
                    time.sleep(1000)
        """,
}


@pytest.mark.parametrize("kind", DEAF)
def test_an_activity_that_ignores_its_cancellation_is_reported_and_a_process_killed(
    kind: str, tmp_path: Path
) -> None:
    played = run(LEFT, tmp_path, work=DEAF[kind], boss=BEGUN if kind == "process" else BOSS, boss2=BOSS2)
    assert played.result.reason == "finished"
    assert played.order("start", "end")[-1] == "end Boss2"  # the rest goes on
    (fault, *_) = played.of("fault", activity="Work")
    assert fault["agent"] == "me"
    assert "activity Work has not ended 0.2 s after it was cancelled" in fault["reason"]
    if kind == "thread":
        assert "(at work.py:5 in execute)" in fault["reason"]
    if kind == "process":
        (late,) = played.of("activity", what="late")
        assert late["reason"] == "it has not ended 0.2 s after it was cancelled, and was killed"
        assert not played.result.left
    elif kind == "thread":
        assert played.result.left == ("me: Work",)


def test_a_stuck_thread_takes_no_place_in_the_pool(tmp_path: Path) -> None:
    """With one thread alone, the next activity runs although the first one never returns."""
    release = threading.Event()

    class Work:
        def execute(self, context: Context) -> None:
            release.wait()

    class Next:
        def execute(self, context: Context) -> None:
            release.set()

    class Boss:
        async def execute(self, context: Context) -> None:
            await context.sleep(0.05)
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
    played = run(text, tmp_path, work=DEAF["thread"], boss=BOSS, until=3200 * MS)
    order = [line for line in played.order() if line.endswith(" Work")]
    assert order[:5] == ["start Work", "cancel Work", "wait Work", "late Work", "start Work"]


def test_an_activity_that_blocks_the_event_loop_holds_up_only_those_in_it(tmp_path: Path) -> None:
    block = """
    import time
    class Block:
        async def execute(self, context):
            time.sleep(2.5)
    """
    later = """
    class Later:
        async def execute(self, context):
            await context.sleep(0.01)
    """
    text = """
    system S
    srm R { liveness { R = Block || (Wait . Later) } activities { Wait takes 1500ms } }
    """
    options = RealTime(cancel_within=500 * MS)
    played = run(text, tmp_path, options, block=block, later=later)
    assert played.result.reason == "finished"
    assert any("blocks the event loop (at block.py:5 in execute)" in reason for reason in faults(played))
    assert played.order("end")[:2] == ["end Wait", "end Later"]


def test_a_step_activity_that_blocks_is_reported_with_its_place(tmp_path: Path) -> None:
    work = """
    import time
    class Work:
        def execute(self, context):
            yield 0.01
            time.sleep(1.5)
    """
    text = "system S srm R { liveness { R = Work } } srm Q { liveness { Q = Other } } team T { a : R  b : Q }"
    other = """
    class Other:
        def execute(self, context):
            context.wait(0.05)
    """
    played = run(text, tmp_path, RealTime(cancel_within=500 * MS), work=work, other=other)
    assert played.result.reason == "finished"
    (reason,) = faults(played)
    assert reason.startswith("a has been in one step for 0.5 s (at work.py:6 in execute)")
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
    class Work:
        kind = "process"
        def execute(self, context):
            os.kill(os.getpid(), signal.SIGSTOP)
    """
    played = run(LEFT, tmp_path, work=work, boss=BOSS, boss2=BOSS2)
    assert played.result.reason == "finished"
    (late,) = played.of("activity", what="late")
    assert "was killed" in late["reason"]


def test_the_deadline_leaves_those_alone_that_return(tmp_path: Path) -> None:
    slow = """
    import time
    class Work:
        def execute(self, context):
            try:
                context.wait(1000)
            finally:
                time.sleep(0.05)
    """
    played = run(LEFT, tmp_path, work=slow, boss=BOSS, boss2=BOSS2)
    assert played.result.reason == "finished" and not faults(played) and not played.result.left


def test_waiting_starts_are_forgotten_when_they_are_cancelled(tmp_path: Path) -> None:
    """At the maximum, what waits for a thread and is cancelled has never run."""
    ran: list[str] = []
    release = threading.Event()

    class Long:
        def execute(self, context: Context) -> None:
            release.wait()

    class Work:
        def execute(self, context: Context) -> None:
            ran.append("Work")

    class Boss:
        async def execute(self, context: Context) -> None:
            await context.sleep(0.1)
            context.raise_event("stop")
            await context.sleep(0.1)
            release.set()

    text = """system S srm R { liveness { R = Long || (Pause . Work . Next) || Boss }
    activities { Pause takes 50ms  Next takes 10ms } control R { enter Next : stop } }"""
    played = play(
        text, {"Long": Long, "Work": Work, "Boss": Boss}, clock="real", real_time=RealTime(threads=1)
    )
    assert played.result.reason == "finished" and not ran
    assert [line for line in played.order() if line.endswith(" Work")] == [
        "start Work",
        "cancel Work",
        "late Work",
    ]
