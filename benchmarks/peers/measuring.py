"""Checks and measurements: who does the same, and how long it takes; CPU time, in interleaved rounds."""

from __future__ import annotations

import statistics
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from benchmarks.behaviours.counts import Course
from benchmarks.behaviours.description import Behaviour, as_json, entered, instrumented, left
from benchmarks.peers.contenders import BY_HAND, Contender, Failed, Process
from benchmarks.peers.loading import Loading

Run = Literal["ours", "peers"]
"""Ours and the code by hand are timed in many short rounds, the peers beside them in fewer, longer ones."""

SLICE: dict[Run, float] = {"ours": 0.03, "peers": 0.1}
"""Seconds of CPU time that one measurement aims at; slow contenders take one turn of the steps."""

WARM = 10
"""So many measurements go before those that count on Node, whose compiler works meanwhile; elsewhere one."""


@dataclass(slots=True)
class Series:
    """The times of one contender with one behaviour, round by round."""

    seconds: list[float] = field(default_factory=list)
    """Of one step."""
    ratios: list[float] = field(default_factory=list)
    """To the code by hand in the same round; empty if there is none."""

    @property
    def nanoseconds(self) -> float:
        """The median of a step."""
        return 1e9 * statistics.median(self.seconds)

    @property
    def ratio(self) -> float | None:
        """The median of the ratios."""
        return statistics.median(self.ratios) if self.ratios else None

    @property
    def spread(self) -> tuple[float, float] | None:
        """Between which ratios the middle half of the rounds lies."""
        if len(self.ratios) < 4:
            return (min(self.ratios), max(self.ratios)) if self.ratios else None
        first, _, third = statistics.quantiles(self.ratios, n=4)
        return first, third


@dataclass(slots=True)
class Results:
    """All that was found."""

    series: dict[tuple[Run, str, str], Series] = field(default_factory=dict)
    """By run, behaviour and contender."""
    refused: dict[tuple[str, str], str] = field(default_factory=dict)
    """Why a contender was not timed with a behaviour, or not counted: it cannot do it, or does otherwise."""
    differing: set[tuple[str, str]] = field(default_factory=set)
    """Those that were timed although they do otherwise: shown, and counted nowhere."""
    constructed: dict[tuple[str, str], float] = field(default_factory=dict)
    """Seconds to make a machine, the second time."""
    memory: dict[tuple[int, str], tuple[float, float]] = field(default_factory=dict)
    """Bytes (without the blackboard) and seconds an instance, by its number of regions and the contender."""
    versions: dict[str, str] = field(default_factory=dict)
    runtimes: dict[str, str] = field(default_factory=dict)
    """What the peers run on."""
    missing: list[str] = field(default_factory=list)
    """Peers that could not be installed."""
    figures: dict[str, float] = field(default_factory=dict)
    """Single figures by their names."""
    loadings: list[Loading] = field(default_factory=list)
    """What it costs to load what is compiled."""


def differences(found: Mapping[str, Any], behaviour: Behaviour, course: Course) -> str:
    """What a contender did otherwise than the reference interpreter; "" if nothing.

    One that counts all entries and exits (an instrumented description) is compared in these, others in their
    own counters and in the active states after every step: with these, all entries and exits are known.
    """
    expected = dict(course.counters)
    expected |= {entered(name): number for name, number in course.entries.items()}
    expected |= {left(name): number for name, number in course.exits.items()}
    for counter in behaviour.counters:
        if found["counters"][counter] != expected[counter]:
            return f"{counter} is {found['counters'][counter]}, not {expected[counter]}"
    if found["leaves"] is not None:
        for step, (here, there) in enumerate(zip(found["leaves"], course.leaves, strict=True)):
            if tuple(here) != there:
                return f"after step {step} in {', '.join(here)}, not in {', '.join(there)}"
    return ""


def check(process: Process, behaviour: Behaviour, course: Course, steps: int) -> str:
    """Whether a contender does what the reference interpreter does: "" or what is different.

    Raises:
        Failed: it cannot do the behaviour at all.
    """
    peer = process.contender.group == "peer"
    for form in (instrumented(behaviour), behaviour) if peer else (behaviour,):
        found = process.ask("check", behaviour=as_json(form), steps=steps)
        different = differences(found | {"leaves": found.get("leaves")}, form, course)
        if different:
            return different
    return ""


def time_in_rounds(
    run: Run,
    processes: Sequence[Process],
    behaviour: Behaviour,
    rounds: int,
    results: Results,
) -> None:
    """Time the contenders that may be timed, in rounds whose order is reversed every second time."""
    pairs = [process for process in processes if may_be_timed(process.contender, behaviour, results)]
    turns: dict[str, int] = {}
    for process in pairs:
        key = process.contender.key
        process.ask("load", behaviour=as_json(behaviour))
        # The second time, so that what is made once for all is there.
        results.constructed[behaviour.name, key] = process.ask("load", behaviour=as_json(behaviour))[
            "seconds"
        ]
        turn = process.ask("time", name=behaviour.name, times=1)["seconds"]
        turn = min(turn, process.ask("time", name=behaviour.name, times=1)["seconds"])
        turns[key] = max(1, round(SLICE[run] / max(turn, 1e-6)))
        warm = WARM if process.contender.is_node else 1
        process.ask("time", name=behaviour.name, times=warm * turns[key])
    for number in range(rounds):
        seconds: dict[str, float] = {}
        for process in pairs if number % 2 == 0 else reversed(pairs):
            key = process.contender.key
            spent = process.ask("time", name=behaviour.name, times=turns[key])["seconds"]
            seconds[key] = spent / (turns[key] * len(behaviour.steps))
        for key, spent in seconds.items():
            series = results.series.setdefault((run, behaviour.name, key), Series())
            series.seconds.append(spent)
            if BY_HAND.key in seconds:
                series.ratios.append(spent / seconds[BY_HAND.key])


def may_be_timed(contender: Contender, behaviour: Behaviour, results: Results) -> bool:
    """Whether a contender reproduces the counts, or is shown with a mark though it does not."""
    key = behaviour.name, contender.key
    return key not in results.refused or key in results.differing


def check_all(
    processes: Iterable[Process], behaviour: Behaviour, course: Course, steps: int, results: Results
) -> None:
    """Check all contenders with a behaviour; those that fail are entered with the reason."""
    for process in processes:
        key = behaviour.name, process.contender.key
        try:
            different = check(process, behaviour, course, steps)
        except Failed as error:
            results.refused[key] = str(error)
            continue
        if different:
            results.refused[key] = different
            if process.contender.group == "peer":
                results.differing.add(key)


def ratio_between(results: Results, run: Run, behaviour: str, slow: str, fast: str) -> float | None:
    """How many times as long one contender takes as another: the median over the rounds of a run."""
    one, other = results.series.get((run, behaviour, slow)), results.series.get((run, behaviour, fast))
    if one is None or other is None or (behaviour, slow) in results.differing:
        return None
    pairs = zip(one.seconds, other.seconds, strict=True)
    return statistics.median(a / b for a, b in pairs)
