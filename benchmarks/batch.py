"""What 10 000 players cost at once and one by one: NumPy and numba against the plain class.

Run by hand: `python3 dev.py long`, or `python benchmarks/batch.py [INSTANCES]`. The player is that of
`benchmarks/behaviours`, driven with its recorded changes of four flags before each event; each instance is at
another phase of them. The plain class has a dictionary as its blackboard. What is timed is the whole of a
tick: the inputs of all instances are written, each side by the fastest of its means, and the step is made.
First all three must have done the same in a sample of instances, step by step; then numba compiles, too.

Times are CPU time. The three take turns in rounds, and what counts is the median of the ratios of a round. As
dictionaries are luck (where their keys lie depends on a seed), the rounds are shared among processes with
different seeds.
"""

from __future__ import annotations

import gc
import importlib
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from numba import njit

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.batch import BACKEND as BATCH
from benchmarks.behaviours.catalogue import BEHAVIOURS, INPUTS
from benchmarks.peers.adapters.python_code import function
from benchmarks.peers.compiling import compiled_into, system_of, write
from benchmarks.peers.driving import blackboard

PLAYER = BEHAVIOURS["player"]
STEPS = len(PLAYER.steps)
EVENTS = [event for event, _ in PLAYER.steps]
SIZE = 10_000
SAMPLE = 50
SCALARS = 40
"""How many players are stepped one by one in a round; what one costs does not depend on that."""

SEEDS, ROUNDS = 5, 5
"""How many processes there are, and how many rounds each of them makes."""
TARGETS = {"numba": 35.0, "numpy": 6.0}
TITLES = {"numba": "numba", "numpy": "NumPy"}
LIMIT = 300
"""How long a process may take, in s."""

Drive = Callable[[], object]


def recorded() -> Any:
    """The inputs before each step of the pattern, a row a step, as they are once it has been gone through."""
    flags = dict.fromkeys(INPUTS, False)
    rows: list[list[bool]] = []
    for _, change in PLAYER.steps * 2:
        flags.update(change)
        rows.append(list(flags.values()))
    return np.array(rows[STEPS:])


def phases(size: int) -> Any:
    """At which step of the pattern the inputs of each instance begin."""
    return np.arange(size) % STEPS


def by_numpy(batch: Any, after: Drive | None = None) -> Drive:
    """What drives a batch of NumPy through the pattern: an input of all instances is copied at once."""
    size, flags = batch.size, recorded()
    # Neighbours are one step apart: so what all see of a flag is a piece of its course, from one step on.
    courses = [np.resize(flags[:, place], size + STEPS) for place in range(len(INPUTS))]
    arrays = [getattr(batch.bb, flag) for flag in INPUTS]

    def drive() -> None:
        for step, event in enumerate(EVENTS):
            for array, course in zip(arrays, courses, strict=True):
                array[:] = course[step : step + size]
            batch.send(event)
            if after is not None:
                after()

    return drive


@njit(cache=False)
def set_flags(table: Any, rows: Any, values: Any, phase: Any, step: int) -> None:
    """Change four flags of each instance."""
    count = np.uint64(len(rows))  # numba would look whether what has a sign is negative, at each use
    for instance in range(len(phase)):
        at = phase[instance] + step
        if at >= count:
            at -= count
        for place in range(4):
            table[rows[at, place], instance] = values[at, place]


def by_numba(batch: Any, after: Drive | None = None) -> Drive:
    """What drives a batch of numba through the pattern: what changes is set by a compiled loop."""
    flags = recorded()
    for place, flag in enumerate(INPUTS):
        getattr(batch.bb, flag)[:] = flags[phases(batch.size) - 1, place]
    table, _ = batch.table(INPUTS[0])
    rows = np.array([[batch.table(flag)[1] for flag, _ in change] for _, change in PLAYER.steps], np.uint64)
    values = np.array([[value for _, value in change] for _, change in PLAYER.steps])
    phase = phases(batch.size).astype(np.uint64)

    def drive() -> None:
        for step, event in enumerate(EVENTS):
            set_flags(table, rows, values, phase, np.uint64(step))
            batch.send(event)
            if after is not None:
                after()

    return drive


DRIVERS = {"numba": by_numba, "numpy": by_numpy}


CHANGES = [
    function("bb", [f"bb[{flag!r}] = {value}" for flag, value in change], {}) for _, change in PLAYER.steps
]
"""What changes four flags of a dictionary, for each step of the pattern; all players share them."""


class Scalar:
    """A player alone, at a phase of the pattern."""

    def __init__(self, kind: Any, phase: int) -> None:
        self.bb = blackboard(PLAYER)
        self.bb.update(zip(INPUTS, recorded()[phase - 1].tolist(), strict=True))
        self.chart = kind(self.bb)
        self.changes = [*CHANGES[phase:], *CHANGES[:phase]]
        self.chart.start()

    def drive(self) -> None:
        """Go once through the pattern."""
        send, bb = self.chart.send, self.bb
        for change, event in zip(self.changes, EVENTS, strict=True):
            change(bb)
            send(event)


def check(kind: Any, batch_kind: Any) -> None:
    """Compare a sample of instances after every step of one round through the pattern.

    Raises:
        AssertionError: they differ.
    """
    names = [name for name, _, _, is_seen in batch_kind.ARRAYS if is_seen]
    for engine, drive_by in DRIVERS.items():
        alone = [Scalar(kind, phase) for phase in range(SAMPLE)]
        batch = batch_kind(SAMPLE, engine)
        drive_by(batch, comparison(engine, alone, batch, names))()
        never = [name for name in names if name.startswith("entered_") and not getattr(batch.bb, name).any()]
        assert not never, f"never in the sample: {', '.join(never)}"


def comparison(engine: str, alone: list[Scalar], batch: Any, names: list[str]) -> Drive:
    """What makes the next step of those that are alone, and compares them with the batch."""
    batch.start()
    steps = iter(range(STEPS))

    def compare() -> None:
        step = next(steps)
        for place, scalar in enumerate(alone):
            scalar.changes[step](scalar.bb)
            scalar.chart.send(EVENTS[step])
            same = batch.configuration(place) == scalar.chart.configuration() and all(
                getattr(batch.bb, name)[place] == scalar.bb[name] for name in names
            )
            assert same, f"{engine}, instance {place}, step {step}: it differs from the plain class"

    return compare


def timed(drive: Drive) -> float:
    """CPU time of a call, in s."""
    gc.collect()
    gc.disable()
    begun = time.process_time()
    drive()
    took = time.process_time() - begun
    gc.enable()
    return took


def measured(folder: Path, size: int) -> dict[str, list[float]]:
    """Nanoseconds of a step of one instance, a number a round, by engine, and of the plain class."""
    sys.path[:0] = [str(folder / "player" / "dict"), str(folder / "batch")]
    kind = importlib.import_module("Player.player").Player
    for name in ("Player.player", "Player"):
        del sys.modules[name]
    sys.path.pop(0)
    batch_kind = importlib.import_module("Player.player").PlayerBatch
    check(kind, batch_kind)
    scalars = [Scalar(kind, phase * STEPS // SCALARS) for phase in range(SCALARS)]

    def one_by_one() -> None:
        for scalar in scalars:
            scalar.drive()

    contenders: list[tuple[str, Drive, int]] = [("scalar", one_by_one, SCALARS)]
    for engine, drivers in DRIVERS.items():
        batch = batch_kind(size, engine)
        drive = drivers(batch)
        batch.start()
        contenders.append((engine, drive, size))
    found: dict[str, list[float]] = {name: [] for name, _, _ in contenders}
    for number in range(ROUNDS + 1):
        for name, drive, count in contenders[:: 1 if number % 2 else -1]:
            took = timed(drive)
            if number:  # the first is to get warm
                found[name].append(1e9 * took / (count * STEPS))
    return found


def main(size: int) -> int:
    """Measure, and print a table; 1 if a target is missed."""
    found: dict[str, list[float]] = {"scalar": [], **{engine: [] for engine in TARGETS}}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        compiled_into(folder, [PLAYER])
        write(folder / "batch", BATCH.generate(system_of(PLAYER), BackendOptions()))
        for seed in range(1, SEEDS + 1):
            ran = subprocess.run(
                [sys.executable, __file__, str(size), str(folder)],
                env=dict(os.environ, PYTHONHASHSEED=str(seed)),
                stdout=subprocess.PIPE,
                text=True,
                timeout=LIMIT,
                check=True,
            )
            for contender, times in json.loads(ran.stdout).items():
                found[contender] += times
    scalar = found["scalar"]
    alone = statistics.median(scalar)
    print(f"{size} players, {STEPS} steps. One by one, with a dictionary: {alone:.0f} ns a step.")
    print()
    print("| | ns a step of an instance | found | wanted | |")
    print("| --- | --- | --- | --- | --- |")
    missed = 0
    for engine, target in TARGETS.items():
        ratio = statistics.median(one / other for one, other in zip(scalar, found[engine], strict=True))
        verdict = "met" if ratio >= target else f"missed by {1 - ratio / target:.0%}"
        missed += ratio < target
        median = statistics.median(found[engine])
        print(f"| {TITLES[engine]} | {median:.1f} | {ratio:.1f} × | ≥ {target:g} | {verdict} |")
    return min(missed, 1)


if __name__ == "__main__":
    arguments = sys.argv[1:]
    instances = int(arguments[0]) if arguments else SIZE
    if len(arguments) > 1:
        print(json.dumps(measured(Path(arguments[1]), instances)))
        sys.exit(0)
    sys.exit(main(instances))
