"""Figures that are not about a step of one behaviour: the size of a chart, and the measurement itself."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable
from pathlib import Path

from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.behaviours.description import Behaviour
from benchmarks.peers.adapters import by_hand, compiled
from benchmarks.peers.driving import blackboard, driver, with_attributes, with_dictionary
from benchmarks.peers.measuring import Results

ROUNDS = 31
TURNS = 40
LARGE, SMALL, PLAYER = "ring_1000", "ring_100", "player"


def single_figures(folder: Path, behaviours: list[Behaviour], results: Results) -> None:
    """What an event costs with more states, and the measurement itself."""
    names = {behaviour.name for behaviour in behaviours}
    if {LARGE, SMALL} <= names:
        large, small = (
            driver(compiled.running(BEHAVIOURS[name], str(folder), "typed"), BEHAVIOURS[name])
            for name in (LARGE, SMALL)
        )
        results.figures["size"] = ratio(lambda: large(40), lambda: small(40))
    if PLAYER in names:
        for form in by_hand.FORMS:
            results.figures[f"around_{form}"] = 1e9 * around(BEHAVIOURS[PLAYER], form)


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


def around(behaviour: Behaviour, form: by_hand.Form) -> float:
    """Seconds a step that is not the machine's: the loop of the measurement, and what sets flags before."""

    def nothing(event: str) -> bool:
        return False

    if form == "dict":
        running = with_dictionary(nothing, blackboard(behaviour))
    else:
        running = with_attributes(nothing, by_hand.board_of(behaviour)())
    drive = driver(running, behaviour)
    return min(spent(lambda: drive(TURNS)) for _ in range(ROUNDS)) / (TURNS * len(behaviour.steps))


def spent(what: Callable[[], object]) -> float:
    """CPU seconds."""
    gc.collect()
    begun = time.process_time()
    what()
    return time.process_time() - begun
