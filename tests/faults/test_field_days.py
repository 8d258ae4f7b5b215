"""Days in the field: a team in simulated time with all faults at once, and memory and threads that stay flat.

Four robots with states, queued signals, data and conversations. Their links lose, double, delay and reorder
messages and are cut; robots crash and start again; the team is swapped to and fro; signals come in floods.
`FIELD_HOURS=24` simulates a day and prints a line an hour; without it, periods are of half a minute.
"""

from __future__ import annotations

import gc
import os
import random
import threading
import time
from collections import Counter
from dataclasses import dataclass, replace
from typing import Any

import psutil
import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.team.faults import Crash, Faults, Partition
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, make
from tests.support.generated import Generated, generate

HOURS = int(os.environ.get("FIELD_HOURS", "0"))
PERIODS = HOURS or 8
PERIOD = 3600 * SECOND if HOURS else 30 * SECOND
"""After each, what there is is counted. Its last tenth is without faults."""
SEED = int(os.environ.get("FIELD_SEED", "1"))
WARM = 3
"""So many periods may still grow: caches and queues become as large as they get."""

FIELD = """
system Field
message Task { int n }
message Note { int n  string text }
topic line { signal Note queued  state Note  data Note }
aip deal {
  participant asker {
    sends request Task
    receives inform Task
    process = Ask . Hear
  }
  participant teller {
    sends inform Task
    receives request Task
    process = Think . Tell
  }
  control asker {
    enter Ask  : / send request Task { n = 1 } to teller
    enter Hear : inform Task from teller or after(3s)
  }
  control teller {
    enter Think : request Task from asker
    leave Tell  : / send inform Task { n = 2 } to asker
  }
}
srm chief {
  plays deal.asker
  liveness { chief = (Rest . asker)~ || Speak~ || Flood~ }
  activities {
    Rest takes 2s  Ask takes 10ms  Hear takes 10ms
    Speak every 1s writes line.signal.Note, line.state.Note, line.data.Note
    Flood every 20s writes line.signal.Note
  }
}
srm worker {
  plays deal.teller
  liveness { worker = teller~ || (Look . Act)~ }
  activities {
    Think takes 20ms  Tell takes 10ms  Look takes 500ms
    Act takes 500ms reads line.signal.Note, line.state.Note, line.data.Note
  }
  control worker { enter Act : when [line.signal.Note.n >= 0] }
}
team T { ann : chief  bob, cid, dan : worker }
"""
AFTER = FIELD.replace(
    "message Note { int n  string text }", "message Note { int n  string text  optional bool loud }"
)


def activities(made: Generated) -> dict[str, type[Any]]:
    """The code of a version, with its messages."""
    note = made.messages.Note

    class Speak:
        def execute(self, context: Context) -> None:
            for way in ("signal", "state", "data"):
                context.publish(f"line.{way}.Note", note(n=context.now_ns % 1000, text="x" * 40))

    class Flood:
        """Two hundred signals at once."""

        def execute(self, context: Context) -> None:
            for number in range(200):
                context.publish("line.signal.Note", note(n=number, text="flood"))

    return {"Speak": Speak, "Flood": Flood}


@dataclass(frozen=True)
class Count:
    """What there is at the end of a period."""

    objects: int
    memory: int
    threads: int
    steps: int


def faults_of(number: int) -> Faults:
    """What goes wrong in a period."""
    chance = random.Random(f"{SEED}/{number}")
    begin, span = number * PERIOD, PERIOD * 9 // 10
    times = max(1, PERIOD // (600 * SECOND))

    def moments(longest: int) -> list[int]:
        return sorted(begin + chance.randrange(max(1, span - longest)) for _ in range(times))

    down = min(20 * SECOND, PERIOD // 10)
    crashes = [Crash(chance.choice("bcd"), moment, down) for moment in moments(down)]
    crashes = [replace(item, agent={"b": "bob", "c": "cid", "d": "dan"}[item.agent]) for item in crashes]
    crashes = [
        item for n, item in enumerate(crashes) if all(item.at > other.at + down for other in crashes[:n])
    ]
    cuts = [
        Partition(frozenset(chance.sample(["ann", "bob", "cid", "dan"], chance.randint(1, 2))), moment, lasts)
        for lasts in (PERIOD // 30, PERIOD // 120)
        for moment in moments(lasts)
    ]
    return Faults(SEED, 0.05, 0.02, 80 * MS, tuple(crashes), tuple(cuts))


@pytest.mark.long
def test_memory_and_threads_stay_flat() -> None:
    kinds: Counter[str] = Counter()
    counts: list[Count] = []
    records: list[Any] = []

    def listen(record: dict[str, Any]) -> None:
        kinds[f"{record['kind']} {record.get('what', '')}".strip()] += 1
        if len(records) > 1000:
            records.clear()

    first = faults_of(0)
    before, after = generate(FIELD), generate(AFTER)
    team, records = make(
        before,
        activities(before),
        until=PERIODS * PERIOD,
        faults=replace(first, crashes=()),
        listeners=[listen],
        seed=SEED,
        real_time=RealTime(queue=100),
    )
    versions = [version(after, activities(after)), version(before, activities(before))]
    driver = team.driver
    began = time.monotonic()

    def begin(number: int) -> None:
        found = faults_of(number)
        team.bus.links.faults = replace(found, crashes=())  # type: ignore[union-attr]
        for crash in found.crashes:
            agent = team.agent(crash.agent)
            driver.at(crash.at, agent.crash)
            driver.at(crash.at + crash.down, agent.restart)
        for turn in range(2):
            at = number * PERIOD + (1 + turn) * PERIOD // 3
            driver.at(at, lambda at=at, turn=turn: team.swap(versions[turn], at=at, within=PERIOD // 10))
        driver.at((number + 1) * PERIOD - 1, lambda: end(number))

    def end(number: int) -> None:
        records.clear()
        gc.collect()
        memory = psutil.Process().memory_info().rss
        steps = sum(agent.steps for agent in team.agents)
        counts.append(Count(len(gc.get_objects()), memory, threading.active_count(), steps))
        if HOURS:
            wall = time.monotonic() - began
            print(
                f"hour {number + 1:>2}: {counts[-1].objects:>7} objects, {memory / 2**20:6.1f} MiB, "
                f"{counts[-1].threads} threads, {steps:>9} steps, {wall:6.0f} s",
                flush=True,
            )
        if number + 1 < PERIODS:
            begin(number + 1)

    driver.at(0, lambda: begin(0))
    result = team.run()
    if HOURS:
        print(dict(sorted(kinds.items())), flush=True)
    assert result.reason == "time" and not result.failed, [agent.failure for agent in result.agents]
    assert len(counts) == PERIODS
    for kind in ("life crash", "swap done", "agent_message", "overload"):
        assert any(name.startswith(kind) for name in kinds), (kind, kinds)
    settled = counts[WARM:]
    half = len(settled) // 2
    early, late = settled[:half], settled[half:]
    assert {count.threads for count in settled} == {settled[0].threads}
    assert max(c.objects for c in late) <= max(c.objects for c in early) * 1.03 + 500, counts
    assert max(c.memory for c in late) <= max(c.memory for c in early) + (8 << 20), counts
    assert late[-1].steps > early[0].steps
