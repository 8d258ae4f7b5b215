"""Agents that talk, in one process: how fast a team starts, and how long a message takes.

Run by hand: `python benchmarks/agents.py [--spade PYTHON] [--against FOLDER]`. With the Python of an
environment in which SPADE 4.1 is installed (`python -m venv DIR && DIR/bin/pip install "spade<5" greenlet`),
hand-written SPADE agents hand the same ball to and fro in one process, in turn with ours. What is to hold:

- a team of 1000 agents is made and in its first states in less than 2 s;
- the median of the way of a message, from the action that sends it to the action that takes it, is at most
  3 x that of SPADE's own dispatch between two agents of one process.

With `--against`, the folder of an earlier checkout, both send in turn, and the processor time of a message is
compared: it is to be at most 1.15 x that of the earlier one. The earlier one is driven by its own copy of
this file, which knows how a team is made there. A thousand conversations among a hundred agents are compared,
too, with the test of each checkout that has them: they are to take no longer than before.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

from aseme_dsl.runtime.team.team import Setup, Team
from tests.support.generated import Generated, generate

PASSES = 2000
ROUNDS = 7
"""So often each measurement is made, in turn with the others; the median of the medians counts."""
TURNS = 15
AGENTS = 1000
SECOND = 1_000_000_000

TEXT = """
system Rally
message Ball { int t }
function now() : int = "agents:now"
function reacts(int t) : int = "agents:reacts"
aip rally {
  participant left {
    var seen : int = 0
    sends inform Ball  receives inform Ball
    process = Serve . Play
  }
  participant right {
    var seen : int = 0
    sends inform Ball  receives inform Ball
    process = Return
  }
  control left {
    enter Play : / send inform Ball { t = now() } to right
    on Play : inform Ball b from right / seen = reacts(b.t) ; send inform Ball { t = now() } to right
  }
  control right {
    on Return : inform Ball b from left / seen = reacts(b.t) ; send inform Ball { t = now() } to left
  }
}
srm server {
  plays rally.left
  liveness { server = left }
  activities { Serve takes 1ms  Play takes 60min }
}
srm returner {
  plays rally.right
  liveness { returner = right }
  activities { Return takes 60min }
}
"""

delays: list[int] = []


def now() -> int:
    """The time now, for what is sent."""
    return time.perf_counter_ns()


def reacts(t: int) -> int:
    """What was sent at `t` has come."""
    delays.append(time.perf_counter_ns() - t)
    return len(delays)


def main(spade: str | None) -> int:
    """Measure, print, and say whether what is to hold does."""
    generated = generate(TEXT)
    starts = sorted(start(generated) for _ in range(5))
    print(f"{AGENTS} agents are in their first states after {starts[2] * 1000:.0f} ms (median of 5)")
    ours: list[float] = []
    theirs: list[float] = []
    process = None if spade is None else serve(spade)
    try:
        for _ in range(ROUNDS):
            ours.append(median(rally(generated)))
            if process is not None:
                theirs.append(median(rally_of(process)))
    finally:
        if process is not None:
            process.kill()
            process.wait()
    mine = median(ours)
    print(f"one way, ours:  {mine / 1000:.1f} µs (median of {ROUNDS} medians of {PASSES})")
    if not theirs:
        print("SPADE was not measured: give the Python of an environment that has it with --spade")
        return int(starts[2] >= 2)
    its = median(theirs)
    print(f"one way, SPADE: {its / 1000:.1f} µs")
    print(f"ratio: {mine / its:.2f} (at most 3 is wanted)")
    return int(starts[2] >= 2 or mine > 3 * its)


def compare(folder: str) -> int:
    """Measure in turn with an earlier checkout, each in a process of its own."""
    here, there = (measuring(Path(item)) for item in (Path(__file__).parents[1], folder))
    try:
        is_dearer = in_turn(here, there, "message", TURNS, "µs of processor time", 1000)
        is_slower = in_turn(here, there, "crowd", ROUNDS, "s for a thousand conversations", 1e9)
    finally:
        for process in (here, there):
            process.kill()
            process.wait()
    return int(is_dearer > 1.15 or is_slower > 1.05)


def measuring(checkout: Path) -> subprocess.Popen[str]:
    """A process that measures a checkout, with the modules of that checkout."""
    program = Path(__file__).with_name("agents_measured.py")
    # -P: what a process finds beside its program is not what that checkout has.
    command = [sys.executable, "-P", str(program), str(checkout.resolve())]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def in_turn(
    here: subprocess.Popen[str], there: subprocess.Popen[str], what: str, turns: int, unit: str, scale: float
) -> float:
    """How many times as much `what` takes now as it did earlier, after a first turn that warms both."""
    found: tuple[list[float], list[float]] = [], []
    for turn in range(turns + 1):
        for process, values in zip((here, there), found, strict=True):
            assert process.stdin is not None and process.stdout is not None
            process.stdin.write(f"{what}\n")
            process.stdin.flush()
            value = float(process.stdout.readline())
            if turn:
                values.append(value)
    mine, its = median(found[0]), median(found[1])
    load = os.getloadavg()[0]
    print(f"{what}, now:     {mine / scale:.2f} {unit} (median of {turns} runs, load {load:.1f})")
    print(f"{what}, earlier: {its / scale:.2f} {unit}")
    print(f"ratio: {mine / its:.2f}")
    return mine / its


def start(generated: Generated) -> float:
    """How many seconds pass until a team is made and all have stepped."""
    begun = time.perf_counter()
    team = Team(
        [(f"r{n}", generated.charts["returner"]) for n in range(AGENTS)],
        {},
        Setup(
            messages=messages(generated),
            clock="real",
            stop=lambda team: "begun" if all(agent.steps for agent in team.agents) else None,
            until_ns=60 * SECOND,
        ),
    )
    result = team.run()
    assert result.reason == "begun", result
    return time.perf_counter() - begun


def rally(generated: Generated) -> list[int]:
    """The delays of our messages, in ns."""
    delays.clear()
    team = Team(
        [("ann", generated.charts["server"]), ("bob", generated.charts["returner"])],
        {},
        Setup(
            messages=messages(generated),
            clock="real",
            stop=lambda team: "enough" if len(delays) >= PASSES else None,
            until_ns=60 * SECOND,
            path=[Path(__file__).parent],
        ),
    )
    result = team.run()
    assert result.reason == "enough", result
    return list(delays)


def messages(generated: Generated) -> dict[str, Any]:
    """The message classes of a generated system."""
    return {name: kind for name, kind in vars(generated.messages).items() if isinstance(kind, type)}


def serve(python: str) -> subprocess.Popen[str]:
    """SPADE's side, ready to play."""
    program = Path(__file__).with_name("agents_spade.py")
    # -P: this folder has a spade.py, which is not SPADE.
    process = subprocess.Popen(
        [python, "-P", str(program)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    if process.stdout.readline().strip() != "ready":
        raise SystemExit(f"{python} cannot run {program.name}")
    return process


def rally_of(process: subprocess.Popen[str]) -> list[int]:
    """The delays of SPADE's messages, in ns."""
    assert process.stdin is not None and process.stdout is not None
    process.stdin.write(f"{PASSES}\n")
    process.stdin.flush()
    found: list[int] = json.loads(process.stdout.readline())
    return found


def median(values: list[Any]) -> float:
    """The value in the middle."""
    return float(sorted(values)[len(values) // 2])


if __name__ == "__main__":
    sys.modules["agents"] = sys.modules[__name__]
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--spade", metavar="PYTHON", help="the Python of an environment that has SPADE")
    parser.add_argument("--against", metavar="FOLDER", help="an earlier checkout, to compare with")
    given = parser.parse_args()
    raise SystemExit(main(given.spade) if given.against is None else compare(given.against))
