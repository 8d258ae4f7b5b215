"""The thread of the timers: order, deadlines, priorities; and time that jumps."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.time.clock import MILLISECOND, RealClock
from aseme_dsl.runtime.time.timer_thread import Timekeeper, may_raise_priority
from aseme_dsl.runtime.time.timers import Timer, Timers
from tests.runtime.playing import MS, make, play
from tests.support.waiting import LONG, wait_until


def keeper() -> tuple[Timekeeper, RealClock, list[BaseException]]:
    clock = RealClock()
    errors: list[BaseException] = []
    return Timekeeper(clock, errors.append), clock, errors


def test_calls_are_made_in_the_order_of_their_moments_and_never_early() -> None:
    kept, clock, errors = keeper()
    made: list[tuple[int, int]] = []
    done = threading.Event()
    for moment in (30, 10, 20):
        kept.at(moment * MS, lambda moment=moment: made.append((moment, clock.now())))  # type: ignore[misc]
    kept.at(40 * MS, done.set)
    kept.start(None)
    assert done.wait(LONG)
    assert kept.stop(LONG) and not errors
    assert [moment for moment, _ in made] == [10, 20, 30]
    assert all(now >= moment * MS for moment, now in made)


def test_a_timer_that_is_the_earliest_wakes_the_thread() -> None:
    kept, clock, _ = keeper()
    kept.start(None)
    for _ in range(100):
        done = threading.Event()
        kept.at(10**15, lambda: None)
        kept.at(clock.now() + MS // 2, done.set)
        assert done.wait(LONG)
    assert kept.stop(LONG)


def test_nothing_is_called_after_the_end() -> None:
    kept, clock, _ = keeper()
    made: list[int] = []
    kept.at(5 * MS, lambda: made.append(5))
    kept.at(15 * MS, lambda: made.append(15))
    kept.start(10 * MS)
    wait_until(lambda: made and clock.now() >= 30 * MS)
    assert kept.stop(LONG)
    assert made == [5]


def test_a_call_that_raises_is_told_and_the_last_one() -> None:
    kept, _, errors = keeper()
    made: list[int] = []

    def wrong() -> None:
        raise ValueError("wrong")

    kept.at(0, wrong)
    kept.at(1, lambda: made.append(1))
    kept.start(None)
    wait_until(lambda: errors)
    assert kept.stop(LONG)
    assert isinstance(errors[0], ValueError) and not made


def test_a_priority_that_is_not_to_be_had_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr("os.sched_setscheduler", refuse)
    run = play(
        "system S srm R { liveness { R = Work } activities { Work takes 10ms } }",
        clock="real",
        real_time=RealTime(priority=10),
    )
    assert run.result.reason == "finished"
    (fault,) = run.of("fault")
    assert fault["reason"] == (
        "a real-time priority is not permitted here (Operation not permitted): it needs `ulimit -r 10` or "
        "CAP_SYS_NICE"
    )
    assert may_raise_priority() is not None


def test_a_clock_on_the_wall_that_jumps_moves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the monotonic clock is looked at: the date may be set while a team plays."""
    true, jumps = time.time, iter(range(0, 10**9, 3600))

    def jumping() -> float:
        return true() + 86400 * 365 * (-1) ** next(jumps) * 10

    monkeypatch.setattr("time.time", jumping)
    monkeypatch.setattr("time.time_ns", lambda: int(jumping() * 1e9))

    class Work:
        def execute(self, context: Context) -> None:
            context.wait(0.02)

    class Listen:
        async def execute(self, context: Context) -> None:
            await context.sleep(0.02)

    text = """system S srm R { liveness { R = Work . Listen . Rest } activities { Rest takes 20ms } }"""
    run = play(text, {"Work": Work, "Listen": Listen}, clock="real", until=60_000 * MS)
    assert run.result.reason == "finished"
    moments = [record["time"] for record in run.records]
    assert moments == sorted(moments)
    assert 60 * MILLISECOND <= run.result.end_ns < 60_000 * MS


def test_cancelled_timers_do_not_fill_the_memory() -> None:
    """A state that is left and entered again has a new timer each time, and the old one was far away."""
    timers = Timers()
    kept = [timers.add(number, lambda: None) for number in range(10)]
    for number in range(100_000):
        timers.add(10**12 + number, lambda: None).cancel()
        assert len(timers) < 200
    assert [timers.take(100) for _ in range(10)] == kept


def test_a_period_keeps_its_beat_however_late_each_start_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """A timer is always a little late in real time; that does not add up, and what is missed is counted."""

    class Walk:
        def execute(self, context: Context) -> None:
            context.log("a step")

    text = "system S srm R { liveness { R = Walk~ } activities { Walk every 10ms } }"
    team, records = make(text, {"Walk": Walk}, until=110 * MS)
    at, lateness = team.driver.at, iter([3, 3, 3, 38, 3, 3, 3])

    def lately(moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        timer = at(moment + next(lateness, 3) * MS, call, background)
        timer.moment = moment
        return timer

    monkeypatch.setattr(team.driver, "at", lately)
    team.run()
    lines = [
        f"{record['time'] // MS} {record['what']}"
        for record in records
        if record["kind"] == "activity" and record["what"] in ("start", "missed")
    ]
    assert lines == [
        *("0 start", "13 start", "23 start", "33 start"),
        *("78 missed", "78 start", "83 start", "93 start", "103 start"),
    ]
    assert [record["beats"] for record in records if record.get("what") == "missed"] == [3]
