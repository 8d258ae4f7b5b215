"""Large messages over a slow link: signals of the same agents pass by.

NETWORK_RUNS=N sends them N times, and prints what it has measured: `dev.py long` does.
"""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from pathlib import Path

import pytest

from aseme_dsl.runtime.transport.settings import LARGEST, LARGEST_IN_ORDER
from tests.network.machines import machines
from tests.network.talkers import NAMES, Story, Talkers, deployed, project

RUNS = int(os.environ.get("NETWORK_RUNS", "0"))
RATE = 10e6 / 8
"""10 Mbit/s, in bytes a second."""
HEARD = 0.5
"""So many seconds after it was sent each signal is there."""
PAIR = NAMES[0], NAMES[2]
"""Who speaks, and who hears."""

TEAM = """
system TALK
message Tick { int n  string who }
message Load { bytes load }
topic team { signal Tick queued  state Load  data Load }

srm speaker {
  liveness { speaker = Say~ || Load~ }
  activities { Say every 50ms writes team.signal.Tick  Load writes team.state.Load, team.data.Load }
}
srm ear {
  liveness { ear = Hear~ }
  activities { Hear every 50ms reads robot1.team.signal.Tick, robot1.team.state.Load, robot1.team.data.Load }
}
team T { robot1 : speaker  robot2 : ear  robot3 : ear  robot4 : ear }
"""
LOAD = """
from aseme_dsl.runtime import Context
from monas.TALK.messages import Load as Loaded


class Load:
    def execute(self, context: Context) -> None:
        context.wait(6)
        for kind, size in LOADS:
            context.log(f"{kind} {size}")
            context.publish(f"team.{kind}.Load", Loaded(load=bytes(size)))
            context.wait(8)
        context.wait(600)
"""

pytest.importorskip("zenoh")
pytestmark = pytest.mark.skipif(not RUNS, reason="long: set NETWORK_RUNS, or run python3 dev.py long")
LOADS = [
    ("state", LARGEST_IN_ORDER - 1000),
    *(("data", 1000 * size) for size in (60, 120, 240, 500, 1000, 2000, 4000)),
    ("data", LARGEST - 1000),
]
"""The kinds and sizes of large messages, one every 8 s."""


@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_signals_pass_by_large_messages(tmp_path: Path, run: int) -> None:
    with machines(NAMES, run) as network:
        load = LOAD.replace("LOADS", repr(LOADS))
        folder = project(tmp_path / "p", deployed(tmp_path, network), TEAM, load=load)
        network.between(*PAIR, rate=RATE, delay=0.005)
        team = Talkers(folder, network, {})
        for robot in PAIR:
            team.begin(robot)
        time.sleep(10.0 + 8.0 * len(LOADS))
        stories = team.end()
        said, heard = (stories[robot] for robot in PAIR)
    found = [measured(said, heard, *load) for load in loads(said)]
    for one in found:
        print(one, flush=True)
    assert max(one.delay for one in found) < HEARD
    assert heard.misplaced(PAIR[0]) == []


@dataclass(frozen=True, slots=True)
class Measured:
    """A large message, and what it did to the signals."""

    kind: str
    size: int
    delay: float
    """The longest delay of a signal that was sent in its time, in seconds."""
    own: list[float]
    """Its own delay, if it has come."""

    def __str__(self) -> str:
        came = f"came after {self.own[0]:.2f} s" if self.own else "did not come"
        return f"{self.kind:5} of {self.size / 1024:5.0f} KiB {came}; signals came after {self.delay:.3f} s"


def loads(said: Story) -> list[tuple[float, str, int]]:
    """When each large message was sent, its kind and its size."""
    logs = [record for record in said.records if record["kind"] == "log"]
    found = [(said.at(record), *record["text"].split()) for record in logs]
    return [(when, kind, int(size)) for when, kind, size in found]


def measured(said: Story, heard: Story, when: float, kind: str, size: int) -> Measured:
    """What a large message, which was sent at a moment, did."""
    came = {number: at for at, number in heard.heard[PAIR[0]]}
    sent = {
        record["message"]["n"]: said.at(record)
        for record in said.records
        if record["kind"] == "message" and record["channel"] == "team.signal.Tick"
    }
    delays = [came[n] - at for n, at in sent.items() if when - 0.2 < at < when + 7.0]
    own = [
        heard.at(record) - when
        for record in heard.records
        if record["kind"] == "arrived"
        and record.get("channel") == f"team.{kind}.Load"
        and 0 < heard.at(record) - when < 8.0
    ]
    return Measured(kind, size, max(delays), own)
