"""How late the runtime is: its timers and its reactions, beside what a thread of one's own would do.

Run by hand: `python3 dev.py long`, or `python benchmarks/latency.py [SECONDS]` (of each measurement).
Absolute figures depend on the machine and on what else it does; what is to hold are the ratios, of one run:

- a 1 kHz timer, 99th percentile of its lateness: at most 2 x that of a thread that sleeps with `time.sleep`,
  when idle and beside process activities that compute; and beside a thread that computes at least 10 x better
  than such a sleeping thread in an interpreter as it is by default;
- from `post` to the reaction beside a thread that computes: the 99th percentile at least 50 x better than
  what a queue to another thread takes.

`--alone` gives the whole process a real-time priority, where that is permitted: then other programs on the
same processors do not disturb the measurement.

With a real-time priority for the timers alone, where the system permits one, absolutely: 100 µs beside
processes, 300 µs beside a thread, 50 µs from `post` to the reaction. The system prefers a thread with such a
priority, so that a queue to it is often quick, too: the ratio to that says little.
"""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from queue import SimpleQueue

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.runtime.chart.inputs import Happened
from aseme_dsl.runtime.driver.real import RealDriver
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.team.team import Setup, Team
from aseme_dsl.runtime.time.timer_thread import may_raise_priority
from tests.support.generated import generate

MILLISECOND = 1_000_000
PERIOD = MILLISECOND
ROUNDS = 3
"""Each measurement is made so often, in turn with the others; the median counts."""
DEFAULT_SWITCH = 5 * MILLISECOND

TEXT = """
system Echo
function reacts(int n) : int = "latency:reacts"
srm echo {
  var heard : int = 0
  liveness { echo = Listen+ }
  activities { Listen takes 60min }
  control echo { repeat Listen : ping / heard = reacts(heard)  leave Listen : stop }
}
"""


def main(seconds: float) -> None:
    """Print the lateness of each way beside each load, and the ratios."""
    problem = may_raise_priority()
    priorities: list[int | None] = [None] if problem else [None, 40]
    if problem:
        print(f"without real-time priority: {problem}")
    for priority in priorities:
        print(
            f"\n{'real-time priority' if priority else 'usual priority'}; µs at the 50th and 99th percentile"
        )
        found: dict[str, list[tuple[float, float]]] = {}
        for _ in range(ROUNDS):
            for name, measure in _measurements(seconds, priority).items():
                found.setdefault(name, []).append(percentiles(measure()))
        result = {
            name: tuple(sorted(part)[ROUNDS // 2] for part in zip(*rounds, strict=True))
            for name, rounds in found.items()
        }
        for name, (half, most) in result.items():
            print(f"  {name:<42} {half:9.1f} {most:9.1f}")
        late = {name: most for name, (_, most) in result.items()}
        idle = late["timer, idle"] / late["sleep, idle"]
        beside = late["timer, beside processes"] / late["sleep, beside processes"]
        thread = late["sleep, beside a thread, default"] / late["timer, beside a thread"]
        post = late["queue, beside a thread, default"] / late["post, beside a thread"]
        print(f"  timer / sleep, idle                       {idle:6.2f} x   (at most 2)")
        print(f"  timer / sleep, beside processes           {beside:6.2f} x   (at most 2)")
        print(f"  sleep by default / timer, beside a thread {thread:6.1f} x   (at least 10)")
        bar = "at least 50" if priority is None else "no bar: see above"
        print(f"  queue by default / post, beside a thread  {post:6.1f} x   ({bar})")
        if priority is not None:
            figures = late["timer, beside processes"], late["timer, beside a thread"]
            print(
                f"  absolutely: timer beside processes {figures[0]:.0f} µs (100), beside a thread"
                f" {figures[1]:.0f} µs (300), post {late['post, beside a thread']:.0f} µs (50)"
            )


def percentiles(values: list[int]) -> tuple[float, float]:
    """The 50th and the 99th, in µs, of values in ns."""
    values = sorted(values)
    return values[len(values) // 2] / 1e3, values[int(len(values) * 0.99)] / 1e3


def _measurements(seconds: float, priority: int | None) -> dict[str, Callable[[], list[int]]]:
    beats = int(seconds * 1e9) // PERIOD

    def beside(load: Callable[[], object], measure: Callable[[], list[int]]) -> Callable[[], list[int]]:
        def run() -> list[int]:
            with load():  # type: ignore[attr-defined]
                return measure()

        return run

    def sleeps() -> list[int]:
        return with_switch(DEFAULT_SWITCH, lambda: sleeping(beats, priority))

    def timers() -> list[int]:
        return timer(beats, priority)

    return {
        "sleep, idle": sleeps,
        "timer, idle": timers,
        "sleep, beside processes": beside(processes, sleeps),
        "timer, beside processes": beside(processes, timers),
        "sleep, beside a thread, default": beside(busy_thread, sleeps),
        "timer, beside a thread": beside(busy_thread, timers),
        "queue, beside a thread, default": beside(
            busy_thread, lambda: with_switch(DEFAULT_SWITCH, lambda: queue(beats // 4, priority))
        ),
        "post, beside a thread": beside(busy_thread, lambda: post(beats // 4, priority)),
    }


def with_switch(interval: int, measure: Callable[[], list[int]]) -> list[int]:
    """Measure with another switch interval of the interpreter."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(interval / 1e9)
    try:
        return measure()
    finally:
        sys.setswitchinterval(before)


# ---- loads -------------------------------------------------------------------------------------


def _compute(stop: Callable[[], bool]) -> None:
    number = 0
    while not stop():
        for number in range(1000):
            number = number * 7 % 11


def _compute_for_ever() -> None:
    _compute(lambda: False)


@contextmanager
def processes() -> Iterator[None]:
    """One process for each processor that computes, as `process` activities do; one is left for us."""
    spawned = multiprocessing.get_context("spawn")
    started = [spawned.Process(target=_compute_for_ever, daemon=True)]
    for item in started:
        item.start()
    time.sleep(0.5)
    try:
        yield
    finally:
        for item in started:
            item.terminate()
            item.join()


@contextmanager
def busy_thread() -> Iterator[None]:
    """A thread of this process that computes."""
    over = threading.Event()
    thread = threading.Thread(target=_compute, args=(over.is_set,), daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


# ---- what is measured --------------------------------------------------------------------------


def _raised(priority: int | None) -> None:
    if priority is not None:
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(priority))


def sleeping(beats: int, priority: int | None) -> list[int]:
    """A thread that sleeps to each beat with `time.sleep`."""
    late: list[int] = []

    def work() -> None:
        _raised(priority)
        moment = time.monotonic_ns()
        for _ in range(beats):
            moment += PERIOD
            rest = moment - time.monotonic_ns()
            if rest > 0:
                time.sleep(rest / 1e9)
            late.append(max(0, time.monotonic_ns() - moment))
            moment = max(moment, time.monotonic_ns() - PERIOD)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    return late


def timer(beats: int, priority: int | None) -> list[int]:
    """The runtime's timers, in a run with nothing else in it."""
    driver = RealDriver(options=RealTime(priority=priority))
    late: list[int] = []
    moment = driver.clock.now() + 10 * MILLISECOND

    def beat() -> None:
        nonlocal moment
        now = driver.clock.now()
        late.append(now - moment)
        if len(late) == beats:
            driver.stop("enough")
            return
        moment = max(moment + PERIOD, now)
        driver.at(moment, beat)

    driver.at(moment, beat)
    driver.run()
    return late


def queue(events: int, priority: int | None) -> list[int]:
    """From putting an event into a queue to the moment at which another thread has it."""
    waiting: SimpleQueue[int] = SimpleQueue()
    late: list[int] = []

    def react() -> None:
        _raised(priority)
        for _ in range(events):
            begun = waiting.get()
            late.append(time.monotonic_ns() - begun)

    thread = threading.Thread(target=react)
    thread.start()
    for _ in range(events):
        time.sleep(0.004)
        waiting.put(time.monotonic_ns())
    thread.join()
    return late


def post(events: int, priority: int | None) -> list[int]:
    """From posting an event to an agent to the action of the transition that reacts to it."""
    generated = generate(TEXT)
    team = Team(
        [("echo", generated.charts["echo"])],
        {},
        Setup(
            clock="real",
            real_time=RealTime(priority=priority),
            path=[generated.folder, Path(__file__).parent],
        ),
    )
    (agent,) = team.agents
    late: list[int] = []

    def send() -> None:
        _raised(priority)
        for number in range(1, events + 1):
            time.sleep(0.004)
            begun = time.monotonic_ns()
            agent.post(("input", number), Happened("ping"))
            while agent.chart.variable("heard") < number:  # another thread was stepping, and has taken it
                time.sleep(0)
            late.append(REACTED[-1] - begun)
        agent.post(("input", events + 1), Happened("stop"))

    thread = threading.Thread(target=send)
    team.driver.at(20 * MILLISECOND, thread.start)
    team.run()
    thread.join()
    return late


REACTED: list[int] = []
"""The moments of the reactions."""


def reacts(heard: int) -> int:
    """The action of the agent's transition."""
    REACTED.append(time.monotonic_ns())
    return heard + 1


if __name__ == "__main__":
    sys.modules["latency"] = sys.modules[__name__]  # where the agent finds its function
    given = [item for item in sys.argv[1:] if item != "--alone"]
    if "--alone" in sys.argv:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(10))
    main(float(given[0]) if given else 2.0)
