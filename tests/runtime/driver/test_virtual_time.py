"""Virtual time: what takes how long, in which order, and that it is always the same."""

from __future__ import annotations

import asyncio
import contextvars
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Cancelled, Context
from aseme_dsl.runtime.driver import virtual
from tests.runtime.playing import MS, SECOND, play
from tests.support.waiting import wait_until

LOOP = """
system S
message M { int n }
topic t { state M }
srm R { liveness { R = (A | B) . C } activities { A takes 30ms } }
"""


def test_an_activity_without_code_lasts_what_it_takes_or_100_ms_with_a_warning() -> None:
    """ "An activity without code lasts `takes`, or 100 ms with a warning." """
    run = play("system S srm R { liveness { R = A . B . B } activities { A takes 30ms } }")
    assert run.activities() == [
        "0 start A",
        "30 end A",
        "30 start B",
        "130 end B",
        "130 start B",
        "230 end B",
    ]
    assert [fault["code"] for fault in run.of("fault")] == ["W201"]
    assert (run.result.reason, run.result.end_ns) == ("finished", 230 * MS)


def test_an_empty_execute_is_no_code() -> None:
    class A:
        def execute(self, context: Context) -> None:
            """Not written yet."""

    run = play("system S srm R { liveness { R = A } }", {"A": A})
    assert run.activities() == ["0 start A", "100 end A"]


def test_pass_is_code_that_does_nothing() -> None:
    class A:
        def execute(self, context: Context) -> None:
            pass

    class B:
        def execute(self, context: Context) -> None:
            """Nothing is to be done."""
            return

    class C:
        @staticmethod
        def execute(context: Context) -> None: ...

    class D:
        def execute(
            self,
            context: Context,
        ) -> None:
            """Not written
            yet."""

    class E:
        execute = lambda self, context: None  # noqa: E731

    activities: dict[str, type[Any]] = {"A": A, "B": B, "C": C, "D": D, "E": E}
    run = play("system S srm R { liveness { R = A . B . C . D . E } }", activities)
    assert run.activities() == [
        "0 start A",
        "0 end A",
        "0 start B",
        "0 end B",
        "0 start C",
        "100 end C",
        "100 start D",
        "200 end D",
        "200 start E",
        "200 end E",
    ]
    assert [fault["reason"] for fault in run.of("fault")] == [
        "activity C has neither code nor `takes`: it lasts 0.1 s",
        "activity D has neither code nor `takes`: it lasts 0.1 s",
    ]


def test_code_without_takes_lasts_as_long_as_it_waits() -> None:
    class A:
        def execute(self, context: Context) -> None:
            context.wait(0.02)
            context.wait(0.03)

    class B:
        def execute(self, context: Context) -> None:
            context.log(f"it is {context.now_ns}")

    run = play("system S srm R { liveness { R = A . B } }", {"A": A, "B": B})
    assert run.activities() == ["0 start A", "50 end A", "50 start B", "50 end B"]
    assert run.of("log")[0]["text"] == f"it is {50 * MS}"


def test_with_takes_the_code_runs_at_the_start_and_its_results_count_at_the_end() -> None:
    """ "its code, if it runs there, runs at the start and its results count at the end" """
    seen: list[int] = []
    text = """
    system S
    message M { int n }
    topic t { state M }
    srm R {
      var done : bool = false
      liveness { R = A || (B . C) }
      activities { A takes 40ms writes t.state.M, done  B takes 10ms }
      control R { enter C : when [has(t.state.M) && done] }
    }
    """
    from tests.support.generated import generate

    generated = generate(text)

    class A:
        def execute(self, context: Context) -> None:
            seen.append(context.now_ns)
            context.publish("t.state.M", generated.message("M", n=1))
            context.set_variable("done", True)

    run = play(generated, {"A": A})
    assert seen == [0]
    assert run.of("message")[0]["time"] == 40 * MS
    assert "40 start C" in run.activities()


def test_code_that_waits_longer_than_takes_is_an_overrun() -> None:
    class A:
        def execute(self, context: Context) -> None:
            context.wait(0.05)

    run = play("system S srm R { liveness { R = A } activities { A takes 20ms } }", {"A": A})
    assert run.activities() == ["0 start A", "50 overrun A", "50 end A"]


def test_waiting_activities_of_several_regions_go_on_in_the_order_of_time() -> None:
    def waiting(*pauses: float) -> type:
        class Waiting:
            def execute(self, context: Context) -> None:
                for pause in pauses:
                    context.wait(pause)
                    context.log(context.activity)

        return Waiting

    run = play(
        "system S srm R { liveness { R = A || B || C } }",
        {"A": waiting(0.03, 0.03), "B": waiting(0.02, 0.02, 0.02), "C": waiting(0.05)},
    )
    logged = [(record["time"] // MS, record["text"]) for record in run.of("log")]
    assert logged == [(20, "B"), (30, "A"), (40, "B"), (50, "C"), (60, "A"), (60, "B")]


def test_async_activities_wait_in_virtual_time() -> None:
    class A:
        async def execute(self, context: Context) -> None:
            async def tick(name: str, pause: float) -> None:
                await asyncio.sleep(pause)
                context.log(name)

            await asyncio.gather(tick("late", 0.3), tick("early", 0.1))
            await context.sleep(0.1)
            assert await asyncio.to_thread(sum, [1, 2]) == 3
            with pytest.raises(TimeoutError):
                await asyncio.wait_for(asyncio.Event().wait(), 1.0)

    run = play("system S srm R { liveness { R = A } }", {"A": A})
    assert run.activities() == ["0 start A", "1400 end A"]
    assert [(r["time"] // MS, r["text"]) for r in run.of("log")] == [(100, "early"), (300, "late")]


def test_step_activities_are_advanced_inside_the_step() -> None:
    class A:
        def execute(self, context: Context) -> Iterator[float | None]:
            yield 0.05
            yield None
            context.log("done")

    run = play("system S srm R { liveness { R = A } }", {"A": A})
    assert run.activities() == ["0 start A", "60 end A"]


def test_a_step_or_async_activity_must_not_block() -> None:
    class A:
        async def execute(self, context: Context) -> None:
            context.wait(1)

    run = play("system S srm R { liveness { R = A } }", {"A": A})
    assert "must not block" in (run.result.agents[0].failure or "")


def test_process_activities_see_a_snapshot() -> None:
    from tests.support.generated import generate

    generated = generate("""
    system S
    message M { int n }
    topic t { state M }
    srm R {
      var sum : int = 0
      liveness { R = A || B }
      activities { A as process reads t.state.M, sum writes sum  B writes t.state.M }
    }
    """)

    class A:
        kind = "process"

        def execute(self, context: Context) -> None:
            before = context.latest_message("t.state.M")
            context.wait(0.05)
            assert context.latest_message("t.state.M") is before
            context.set_variable("sum", context.get_variable("sum") + before.n)

    class B:
        def execute(self, context: Context) -> None:
            context.wait(0.01)
            context.publish("t.state.M", generated.message("M", n=7))

    script = [{"at": 0, "channel": "t.state.M", "message": {"n": 3}}]
    run = play(generated, {"A": A, "B": B}, script=script)
    assert run.of("variable")[0]["value"] == 3
    assert run.result.reason == "finished"


def test_a_period_is_from_start_to_start_and_missed_beats_are_counted() -> None:
    """ "A period (`every 33ms`) is from start to start, per node … never caught up in a burst." """

    class A:
        def execute(self, context: Context) -> None:
            context.wait(0.005 if context.now_ns < 100 * MS else 0.08)

    run = play("system S srm R { liveness { R = A~ } activities { A every 33ms } }", {"A": A}, until=300 * MS)
    assert run.activities("start", "missed") == [
        "0 start A",
        "33 start A",
        "66 start A",
        "99 start A",
        "132 start A",
        "212 missed A",
        "212 start A",
        "292 missed A",
        "292 start A",
    ]
    assert [r["beats"] for r in run.of("activity", what="missed")] == [2, 2]


def test_a_period_holds_back_the_start_but_not_the_state() -> None:
    """ "the state is entered at once, only the activity's start is held back" """
    text = """system S srm R { liveness { R = (A . B)~ } activities { A every 100ms takes 10ms  B takes 10ms }
    control R { enter B : after(50ms) } }"""
    run = play(text, until=250 * MS)
    assert run.activities("start", "cancel") == [
        "0 start A",
        "50 start B",
        "100 start A",
        "110 start B",
        "170 cancel A",
        "170 start B",
        "200 start A",
        "230 start B",
        "250 cancel A",
    ]


def test_steps_that_do_not_end_at_one_instant_are_an_error_that_names_the_cycle() -> None:
    class A:
        def execute(self, context: Context) -> None:
            context.log("at once")

    run = play("system S srm R { liveness { R = A~ } }", {"A": A})
    failure = run.result.agents[0].failure or ""
    assert "1000 steps at 0 s" in failure and "activities A" in failure
    assert run.result.agents[0].at.startswith("test.aseme:1")


WAKING = """
system S
srm R {
  var n : int = 0
  var m : int = 0
  liveness { R = a || b  a = A~  b = B~ }
  control a { repeat A : when [n > m] / m = n }
  control b { repeat B : when [n == m] / n = n + 1 }
  activities { A takes 1s  B takes 1s }
}
"""


RAISING = """
system S
srm R {
  liveness { R = A }
  control R { enter A : / raise ping  on A : ping / raise pong  on A : pong / raise ping }
  activities { A takes 1s }
}
"""


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_events_that_raise_each_other_for_ever_stop_their_agent(clock: str) -> None:
    failure = play(RAISING, clock=clock).result.agents[0].failure or ""
    assert "steps follow each other" in failure
    assert "its actions raise events without an end" in failure
    assert "wake" not in failure


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_regions_that_wake_each_other_for_ever_stop_their_agent(clock: str) -> None:
    """ "steps that do not end at one instant of virtual time, are a reported error that names the cycle" """
    run = play(WAKING, clock=clock)
    failure = run.result.agents[0].failure or ""
    assert "A (test.aseme:6:" in failure and "B (test.aseme:6:" in failure


def test_a_step_that_does_not_settle_names_states_and_lines() -> None:
    run = play(
        "system S srm R { var n : int = 0 liveness { R = A~ } control R { repeat A : when [n == 0] } }"
    )
    assert "1000 rounds: A -> A (test.aseme:1:" in (run.result.agents[0].failure or "")


QUEUED = """
system S
message M { int n }
topic t { signal M queued }
srm Reader {
  var n : int = 0
  var m : int = 0
  liveness { Reader = a || b  a = Read~  b = Watch~ }
  control a { repeat Read : when [m == n && t.signal.M.n > 0] / n = n + 1 }
  control b { repeat Watch : when [n > m] / m = n }
  activities { Read takes 1s  Watch takes 1s }
}
team T { bob : Reader }
"""


def test_a_long_queue_does_not_stop_who_reads_it() -> None:
    """At one instant, far more than a thousand steps: each takes a signal or writes what the other reads."""
    messages = [{"at": "1ms", "channel": "t.signal.M", "message": {"n": 1}} for _ in range(2000)]
    run = play(QUEUED, script=messages, until=SECOND // 2)
    result, chart = run.result.agents[0], run.team.agent("bob").chart
    assert result.failure is None and result.steps > 1000
    assert chart.variable("m") == chart.variable("n") > 400


LOOP_ON_A_QUEUE = """
system S
message M { int n }
topic t { signal M queued }
srm Reader {
  var n : int = 0
  liveness { Reader = Read~ [> Stop }
  control Reader { repeat Read : when [t.signal.M.n > 0] / n = n + 1  enter Stop : when [n >= 3000] }
  activities { Read takes 1s  Stop takes 1ms }
}
team T { bob : Reader }
"""


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_a_loop_that_takes_a_signal_each_round_is_no_cycle(clock: str) -> None:
    """A finite queue of inputs, three times as long as the bound."""
    messages = [{"at": "1ms", "channel": "t.signal.M", "message": {"n": 1}} for _ in range(3000)]
    run = play(LOOP_ON_A_QUEUE, script=messages, clock=clock)
    result, chart = run.result.agents[0], run.team.agent("bob").chart
    assert result.failure is None
    assert chart.variable("n") == 3000


REFILLING = """
system S
message M { int n }
topic t { signal M queued }
topic u { signal M queued }
srm R {
  liveness { R = a || b  a = A~  b = B~ }
  control R { start (a || b) : / write_messages.t.signal.M { n = 1 } }
  control a { repeat A : when [t.signal.M.n > 0] / write_messages.u.signal.M { n = 1 } }
  control b { repeat B : when [u.signal.M.n > 0] / write_messages.t.signal.M { n = 1 } }
  activities { A takes 1s  B takes 1s }
}
team T { bob : R }
"""


def test_two_regions_that_refill_each_other_s_queues_are_a_cycle() -> None:
    run = play(REFILLING, until=SECOND)
    failure = run.result.agents[0].failure or ""
    assert "A (test.aseme:7:" in failure and "B (test.aseme:7:" in failure


TWO_REFILLING = """
system S
message M { int n }
topic t { signal M queued  signal N queued }
message N { int n }
srm R {
  liveness { R = A~ }
  control R { start A~ : / write_messages.t.signal.M { n = 1 }
              repeat A : when [t.signal.N.n > 0] / write_messages.t.signal.M { n = 1 } }
  activities { A takes 1s }
}
srm Q {
  liveness { Q = B~ }
  control Q { repeat B : when [t.signal.M.n > 0] / write_messages.t.signal.N { n = 1 } }
  activities { B takes 1s }
}
team T { bob : R  ann : Q }
"""


@pytest.mark.parametrize("text", [REFILLING, TWO_REFILLING], ids=["regions", "agents"])
def test_in_real_time_a_cycle_is_told_and_the_run_ends(text: str) -> None:
    run = play(text, clock="real", until=SECOND)
    assert run.result.reason == "time"
    told = [fault.reason for fault in run.result.faults]
    assert any(
        "has not come to rest for 1000 steps" in reason and "A (test.aseme:" in reason for reason in told
    )
    assert run.result.left == ()


def test_a_run_ends_when_nothing_would_ever_happen() -> None:
    run = play(
        "system S srm R { liveness { R = A . B } control R { enter B : bell } activities { A takes 1s } }"
    )
    assert (run.result.reason, run.result.end_ns) == ("idle", SECOND)


def test_a_run_ends_with_its_duration() -> None:
    run = play("system S srm R { liveness { R = A~ } activities { A takes 1s } }", until=10 * SECOND)
    assert (run.result.reason, run.result.end_ns) == ("time", 10 * SECOND)
    assert run.activities("start")[-1] == "10000 start A"
    assert run.activities()[-1] == "10000 cancel A" or run.activities()[-2] == "10000 cancel A"


def test_a_stop_condition_ends_a_run() -> None:
    run = play(
        "system S srm R { liveness { R = A~ } activities { A takes 1s } }",
        stop=lambda team: "enough" if team.driver.clock.now() >= 3 * SECOND else None,
    )
    assert (run.result.reason, run.result.end_ns) == ("enough", 3 * SECOND)


TEAM = """
system S
message M { int n }
topic t { state M  signal M }
srm R {
  liveness { R = Play~ || Listen~ }
  activities { Play every 40ms takes 10ms writes t.state.M  Listen reads t.state.M every 70ms takes 20ms }
}
team T { ann, bob : R }
"""


class Play:
    def execute(self, context: Context) -> None:
        context.wait(context.random.random() / 100)
        context.log(f"{context.random.randrange(1000)}")


class Listen:
    async def execute(self, context: Context) -> None:
        await context.sleep(context.random.random() / 100)
        context.log(f"{context.random.randrange(1000)}")


def test_one_seed_gives_the_same_bytes(tmp_path: Path) -> None:
    """ "With the virtual clock and one seed, a run is the same to the bit" """
    paths = [tmp_path / f"{n}.jsonl" for n in range(3)]
    for path, seed in zip(paths, (1, 1, 2), strict=True):
        play(TEAM, {"Play": Play, "Listen": Listen}, until=2 * SECOND, seed=seed, trace=path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert paths[0].read_bytes() != paths[2].read_bytes()
    assert paths[0].stat().st_size > 10_000


def test_agents_that_are_due_at_one_instant_step_in_the_order_of_the_team() -> None:
    run = play(TEAM, until=400 * MS)
    steps = [(r["time"], r["agent"]) for r in run.of("step")]
    firsts = [agent for time, agent in steps if time == 0]
    assert firsts[:2] == ["ann", "bob"]
    assert all(
        agents == sorted(agents)
        for moment in {time for time, _ in steps}
        for agents in [list(dict.fromkeys(agent for time, agent in steps if time == moment))]
    )


def test_cancelled_is_no_exception() -> None:
    assert not issubclass(Cancelled, Exception)


def test_it_is_told_once_which_activity_does_not_return_and_where(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(virtual, "LOOK", 0.001)
    start = "activity A of me has not returned for 0.02 s (at "

    class A:
        def execute(self, context: Context) -> None:
            for _ in range(2):
                context.wait(1)
                wait_until(lambda: start in caplog.text)
                time.sleep(0.1)

    run = play("system S srm R { liveness { R = A } }", {"A": A})
    assert caplog.text.count(start) == 1
    assert run.result.left == () and run.result.reason == "finished"
    assert not run.of("fault")


def test_what_runs_and_is_no_activity_is_told_too(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(virtual, "LOOK", 0.001)
    driver = virtual.VirtualDriver()
    told = "what runs has not returned for 0.02 s (at "
    driver.at(5, lambda: wait_until(lambda: told in caplog.text) and None)
    driver.run()
    assert caplog.text.count(told) == 1


STILL = "activity A of me lets no time pass: it has waited "


def test_it_is_told_once_which_activity_waits_and_lets_no_time_pass(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(virtual, "LOOK", 0.001)

    class A:
        def execute(self, context: Context) -> None:
            context.wait(1)
            waited = 0
            while waited < 5000 or STILL not in caplog.text:
                context.wait(0)
                waited += 1

    class B:
        def execute(self, context: Context) -> None:
            context.wait(2)

    run = play("system S srm R { liveness { R = A || B } }", {"A": A, "B": B})
    (line,) = (record.getMessage() for record in caplog.records)
    assert line.startswith(STILL)
    assert "times at 1 s" in line
    assert line.endswith(" in execute)")
    assert run.result.reason == "finished" and run.result.end_ns == 2 * SECOND


def test_what_rings_for_ever_at_one_instant_is_told(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(virtual, "LOOK", 0.001)
    told = "no time passes at 0.005 s: timers are due again and again"
    driver = virtual.VirtualDriver()

    def again() -> None:
        if told not in caplog.text:
            driver.at(5 * MS, lambda: driver.soon(again))

    again()
    driver.run()
    assert caplog.text.count(told) == 1


def test_a_long_instant_in_which_much_is_done_is_not_told_of(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(virtual, "LOOK", 0.001)
    driver = virtual.VirtualDriver()

    def work() -> None:
        time.sleep(0.001)

    for _ in range(100):
        driver.soon(work)
    driver.run()
    assert "no time passes" not in caplog.text


def test_code_sees_the_context_of_who_asks_for_the_run() -> None:
    wanted: contextvars.ContextVar[int] = contextvars.ContextVar("wanted", default=0)
    seen = []

    class A:
        def execute(self, context: Context) -> None:
            seen.append(wanted.get())
            context.wait(1)
            seen.append(wanted.get())

    class B:
        def execute(self, context: Context) -> None:
            context.wait(0.5)
            seen.append(wanted.get())

    wanted.set(7)
    play("system S srm R { liveness { R = A || B } }", {"A": A, "B": B})
    assert seen == [7, 7, 7]


def test_who_debugs_a_thread_sees_the_code_run_in_it() -> None:
    threads = []

    class A:
        def execute(self, context: Context) -> None:
            threads.append(threading.current_thread())

    before = sys.gettrace()
    sys.settrace(lambda frame, event, argument: None)
    try:
        play("system S srm R { liveness { R = A } }", {"A": A})
    finally:
        sys.settrace(before)
    assert threads == [threading.current_thread()]


@pytest.mark.parametrize(
    ("repeat", "rounds"),
    [("every 200ms :", 16), (": after(500ms)", 7), (": [expired(pace)] / start_timer(pace, 1s)", 4)],
)
def test_a_loop_that_does_nothing_rests_in_each_round_that_waits(repeat: str, rounds: int) -> None:
    run = play(
        "system S srm R { var n : int = 0 liveness { R = [A]~ } control R {"
        " enter [A] : / start_timer(pace, 1s)"
        f" enter A : [n < 0]  skip A : else  repeat [A] {repeat} }} }}",
        until=3 * SECOND,
    )
    times = {step["time"] for step in run.of("step") if step["time"] <= 3 * SECOND}
    assert (run.result.end_ns, len(times)) == (3 * SECOND, rounds)
