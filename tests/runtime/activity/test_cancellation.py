"""Cancellation, re-entry and failure, for the four kinds of activity, in virtual and in real time."""

from __future__ import annotations

import os
import textwrap
from pathlib import Path

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.time.clock import RealClock
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.playing import MS, Played, play
from tests.support.generated import generate

KINDS = ("thread", "async", "process", "step")
CLOCKS = ("virtual", "real")

CANCELLED = """
system S
message M { int n }
topic t { state M }
srm R {
  var late : bool = false
  liveness { R = (Work . Next) || Boss }
  activities { Work writes t.state.M, late  Next takes 10ms  Boss takes 30ms }
  control R { enter Next : stop }
}
"""

# Each kind as its user would write it; all go on for ever, and try to publish when they are cancelled.
WORK = {
    "thread": """
        from pathlib import Path
        class Work:
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    while True:
                        context.wait(0.01)
                finally:
                    context.set_variable("late", True)
        """,
    "async": """
        import asyncio
        from pathlib import Path
        class Work:
            async def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    await context.sleep(1000)
                except asyncio.CancelledError:
                    context.set_variable("late", True)
        """,
    "process": """
        from pathlib import Path
        class Work:
            kind = "process"
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    context.wait(1000)
                finally:
                    context.set_variable("late", True)
        """,
    "step": """
        from pathlib import Path
        class Work:
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    while True:
                        yield 0.01
                finally:
                    context.set_variable("late", True)
        """,
}
BOSS = """
from pathlib import Path

class Boss:
    async def execute(self, context):
        await context.sleep(0.05)
        while not Path(__file__).with_name("begun").exists():
            await context.sleep(0.01)
        context.raise_event("stop")
"""
"""Once Work has begun, which on a busy machine may take a while."""


def folder(tmp_path: Path, **modules: str) -> Path:
    for name, text in modules.items():
        (tmp_path / f"{name}.py").write_text(textwrap.dedent(text))
    return tmp_path


@pytest.mark.parametrize("clock", CLOCKS)
@pytest.mark.parametrize("kind", KINDS)
def test_who_is_cancelled_is_told_and_what_it_still_does_is_dropped(
    kind: str, clock: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """ "Leaving a BASIC state whose activity still runs cancels the activity: it is told, and its late result
    is dropped." """
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.GRACE", 10.0)  # a process may still be about to begin
    find = activities_in(folder(tmp_path, work=WORK[kind], boss=BOSS))
    run = play(CANCELLED, find, clock=clock, path=[tmp_path])
    assert run.result.reason == "finished"
    assert [line for line in run.order() if line.endswith("Work")] == [
        "start Work",
        "cancel Work",
        "late Work",
    ]
    assert run.of("activity", what="late")[0]["dropped"] == 1
    assert not run.of("variable")
    assert run.order("end").count("end Next") == 1


PASSED = """
system S
srm R {
  var there : bool = true
  liveness { R = First . Move . Last }
  activities { First takes 10ms simulated  Last takes 10ms simulated }
  control R { enter Last : when [there] }
}
"""


@pytest.mark.parametrize("clock", CLOCKS)
@pytest.mark.parametrize("kind", KINDS)
def test_what_one_step_starts_and_cancels_does_not_run(kind: str, clock: str, tmp_path: Path) -> None:
    move = WORK[kind].replace("class Work", "class Move")
    run = play(PASSED, activities_in(folder(tmp_path, move=move)), clock=clock, path=[tmp_path])
    assert run.result.reason == "finished"
    (record,) = run.of("activity", activity="Move")
    assert (record["what"], record["started"]) == ("cancel", False)
    assert not (tmp_path / "begun").exists()


REENTRY = """
system S
srm R {
  liveness { R = (Work . Next)~ || Boss }
  control R { repeat (Work . Next) : again }
}
"""

# Each kind, slow to come to its end after it was cancelled, where it can be.
SLOW = {
    "thread": """
        import time
        from pathlib import Path
        class Work:
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    context.wait(1000)
                finally:
                    time.sleep(0.05)
        """,
    "async": """
        import asyncio
        from pathlib import Path
        class Work:
            async def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    await context.sleep(1000)
                finally:
                    await asyncio.sleep(0.05)
        """,
    "process": """
        import time
        from pathlib import Path
        class Work:
            kind = "process"
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                try:
                    context.wait(1000)
                finally:
                    time.sleep(0.05)
        """,
    "step": """
        from pathlib import Path
        class Work:
            def execute(self, context):
                Path(__file__).with_name("begun").touch()
                yield 1000
        """,
}


@pytest.mark.parametrize("clock", CLOCKS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_state_that_is_entered_again_waits_for_its_cancelled_activity(
    kind: str, clock: str, tmp_path: Path
) -> None:
    """ "the new one starts when the old one has, and the state is incomplete until then" """
    boss = BOSS.replace("stop", "again")
    find = activities_in(folder(tmp_path, work=SLOW[kind], boss=boss))
    started: list[Record] = []

    def second_start(record: Record) -> None:
        if record.get("what") == "start" and record["activity"] == "Work":
            started.append(record)

    run = play(
        generate(REENTRY),
        find,
        clock=clock,
        path=[tmp_path],
        until=60_000 * MS,
        stop=lambda team: "seen" if len(started) > 1 else None,
        listeners=[second_start],
    )
    assert run.result.reason == "seen"
    lines = [line for line in run.order() if line.endswith(" Work")]
    wait = [] if kind == "step" else ["wait Work"]  # a generator is ended where it stands
    assert lines[: 4 + len(wait)] == ["start Work", "cancel Work", *wait, "late Work", "start Work"]


CRASH = """
system S
srm R {
  liveness { R = Work || Other }
  activities { Other takes 10s }
}
"""
BAD = {
    "thread": "class Work:\n    def execute(self, context):\n        raise ValueError('no battery')\n",
    "async": "class Work:\n    async def execute(self, context):\n        raise ValueError('no battery')\n",
    "process": (
        "class Work:\n    kind = 'process'\n    def execute(self, context):\n"
        "        raise ValueError('no battery')\n"
    ),
    "step": (
        "class Work:\n    def execute(self, context):\n        yield\n"
        "        raise ValueError('no battery')\n"
    ),
}


@pytest.mark.parametrize("clock", CLOCKS)
@pytest.mark.parametrize("kind", KINDS)
def test_an_activity_that_raises_stops_the_agent_which_says_where(
    kind: str, clock: str, tmp_path: Path
) -> None:
    """ "otherwise the agent stops in a safe way and says where" """
    find = activities_in(folder(tmp_path, work=BAD[kind]))
    run = play(CRASH, find, clock=clock, path=[tmp_path])
    (agent,) = run.result.agents
    assert run.result.failed
    assert "ValueError: no battery" in (agent.failure or "")
    assert agent.at.startswith("test.aseme:4:")
    assert run.order("cancel") == ["cancel Other"]
    (crash,) = run.of("activity", what="crash")
    assert (crash["traceback"][-1]["file"], crash["traceback"][-1]["function"]) == ("work.py", "execute")
    (error,) = run.of("error")
    assert error["at"] == agent.at


def test_an_error_transition_takes_a_failure() -> None:
    class Work:
        def execute(self, context: Context) -> None:
            raise RuntimeError

    text = """system S srm R { liveness { R = (Work . Next) } activities { Next takes 10ms }
    control R { enter Next : error } }"""
    run = play(text, {"Work": Work})
    assert run.order() == ["start Work", "crash Work", "start Next", "end Next"]
    assert run.result.reason == "finished" and not run.result.failed


def test_an_activity_that_waits_while_it_is_cancelled_at_the_end_of_a_run_comes_to_its_end() -> None:
    ended: list[str] = []

    class Work:
        def execute(self, context: Context) -> None:
            try:
                context.wait(100)
            finally:
                ended.append(context.activity)

    run = play("system S srm R { liveness { R = Work } }", {"Work": Work}, until=50 * MS)
    assert ended == ["Work"]
    assert run.order() == ["start Work", "cancel Work", "late Work"]


def test_a_real_run_reports_an_activity_that_does_not_end(monkeypatch: pytest.MonkeyPatch) -> None:
    import threading

    release, begun = threading.Event(), threading.Event()
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.GRACE", 0.1)

    class Work:
        def execute(self, context: Context) -> None:
            begun.set()
            context.raise_event("begun")
            release.wait()

    run = play(
        "system S srm R { liveness { R = Work } }",
        {"Work": Work},
        clock="real",
        stop=lambda team: "begun" if begun.is_set() else None,
    )
    release.set()
    assert run.result.reason == "begun"
    assert any("has not ended" in fault["reason"] for fault in run.of("fault"))


def test_a_worker_process_that_dies_is_a_failure_and_the_next_one_lives(tmp_path: Path) -> None:
    text = """system S srm R { liveness { R = Work . Work2 } control R { enter Work2 : error } }"""
    die = (
        "import os\nclass Work:\n    kind = 'process'\n    def execute(self, context):\n        os._exit(3)\n"
    )
    work2 = die.replace("Work", "Work2").replace("os._exit(3)", "print('to the errors')")
    find = activities_in(folder(tmp_path, work=die, work2=work2))
    run = play(text, find, clock="real", path=[tmp_path])
    assert run.order() == ["start Work", "crash Work", "start Work2", "end Work2"]
    assert run.of("activity", what="crash")[0]["reason"] == "its process has ended with code 3"


def test_process_activities_run_elsewhere_and_read_publish_and_write(tmp_path: Path) -> None:
    generated = generate("""
    system S
    message M { int n }
    topic t { state M  signal M }
    srm R {
      var sum : int = 0
      liveness { R = Work . Check }
      activities { Work as process reads t.state.M, t.signal.M writes t.state.M, sum }
      control R { enter Check : [sum == 12 && t.state.M.n == 8] }
    }
    """)
    work = f"""
    import os
    from {generated.package.__name__}.messages import M

    class Work:
        def execute(self, context):
            message = context.read("t.state.M", M)
            signal = context.consume("t.signal.M")
            assert context.consume("t.signal.M") is None
            context.publish("t.state.M", M(n=message.n + 1))
            context.set_variable("sum", message.n + signal.n)
            context.log(str(os.getpid()))
    """
    find = activities_in(folder(tmp_path, work=work))
    script = [
        {"at": 0, "channel": "t.state.M", "message": {"n": 7}},
        {"at": 0, "channel": "t.signal.M", "message": {"n": 5}},
    ]
    for clock in CLOCKS:
        run = play(generated, find, clock=clock, path=[tmp_path], script=script)
        assert _finished(run), run.result
        assert (run.of("log")[0]["text"] == str(os.getpid())) == (clock == "virtual")
        assert run.of("consumed")[0]["input"] == ["input", 2]


def _finished(run: Played) -> bool:
    return all(agent.finished for agent in run.result.agents)


def test_threads_are_resident(monkeypatch: pytest.MonkeyPatch) -> None:
    """ "never a new thread per start" """
    names: set[str] = set()

    class Work:
        def execute(self, context: Context) -> None:
            import threading

            names.add(threading.current_thread().name)
            if len(starts) > 50:
                context.raise_event("enough")
            starts.append(1)

    starts: list[int] = []
    # What waits for long, as on a machine that stands still for a while, gets another thread: not here.
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.LOOK", 600.0)
    text = """system S srm R { liveness { R = Work+ } control R { leave Work : enough  repeat Work :  } }"""
    run = play(text, {"Work": Work}, clock="real")
    assert _finished(run)
    assert len(starts) > 50 and len(names) <= 3


def test_the_real_clock_never_goes_back() -> None:
    clock = RealClock()
    moments = [clock.now() for _ in range(1000)]
    assert moments[0] >= 0 and moments == sorted(moments)
