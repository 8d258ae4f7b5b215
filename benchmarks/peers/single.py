"""Figures that are not about a step of one behaviour: the size of a chart, and loading one."""

from __future__ import annotations

import gc
import marshal
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.behaviours.aseme import camel
from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.behaviours.description import Behaviour
from benchmarks.peers.adapters import compiled
from benchmarks.peers.driving import driver
from benchmarks.peers.measuring import Results

ROUNDS = 31
LOADS = 200
LARGE, SMALL = "ring_1000", "ring_100"
STATES = 1000
"""Of the large one."""


def single_figures(folder: Path, behaviours: list[Behaviour], results: Results) -> None:
    """What an event costs with more states, what it costs to load a module, and the measurement itself."""
    names = {behaviour.name for behaviour in behaviours}
    if {LARGE, SMALL} <= names:
        large, small = (
            driver(compiled.running(BEHAVIOURS[name], str(folder), "typed"), BEHAVIOURS[name])
            for name in (LARGE, SMALL)
        )
        results.figures["size"] = ratio(lambda: large(40), lambda: small(40))
    if LARGE in names:
        module = folder / LARGE / "typed" / camel(LARGE) / f"{LARGE}.py"
        results.figures["load"] = 1e3 * loading(module) * 1000 / STATES
    results.figures["loop"] = 1e9 * empty_loop()


def ratio(one: Callable[[], object], other: Callable[[], object]) -> float:
    """How many times as long one thing takes as another: the median over rounds, in turns."""
    found = []
    one(), other()
    for number in range(ROUNDS):
        if number % 2:
            second, first = spent(other), spent(one)
        else:
            first, second = spent(one), spent(other)
        found.append(first / second)
    return statistics.median(found)


def loading(module: Path) -> float:
    """Seconds to load a module from the bytes of its `.pyc`: what is read is made into code, and run.

    The shortest of many counts: it is so short that whatever else the machine does is longer.
    """
    code = compile(module.read_text("utf-8"), module.name, "exec")
    data = marshal.dumps(code)

    def load() -> float:
        namespace: dict[str, Any] = {"__name__": "loaded"}
        begun = time.process_time()
        exec(marshal.loads(data), namespace)
        return time.process_time() - begun

    return min(load() for _ in range(LOADS))


def empty_loop() -> float:
    """Seconds a step that the loop of the measurement itself takes, with a function that does nothing."""

    def nothing(event: str) -> bool:
        return False

    events = ["tick"] * 512

    def loop() -> None:
        for _ in range(40):
            for event in events:
                nothing(event)

    return min(spent(loop) for _ in range(ROUNDS)) / (40 * len(events))


def spent(what: Callable[[], object]) -> float:
    """CPU seconds."""
    gc.collect()
    begun = time.process_time()
    what()
    return time.process_time() - begun
