"""What is aimed at, and whether it is reached."""

from __future__ import annotations

import statistics
from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks.behaviours.catalogue import BEHAVIOURS, MANY
from benchmarks.peers.contenders import (
    CORE_DICT,
    CORE_TYPED,
    NATIVE,
    POST,
    POST_DICT,
    PYTHON_STATEMACHINE,
    SEND,
    SEND_DICT,
    SISMIC,
    SISMIC_UNCHECKED,
    STATECHART,
    TRANSITIONS,
    XSTATE,
    XSTATE_PYTHON,
    Contender,
)
from benchmarks.peers.loading import GUARDED, SIMPLE
from benchmarks.peers.measuring import Results, ratio_between

MEASURED = ("two_states", "deep_leaf", "deep_top", "regions", "player", "idle")
"""The behaviours that are compared with code by hand."""

PEERS_AT_LEAST = {
    STATECHART: 15,
    XSTATE_PYTHON: 75,
    SISMIC: 600,
    TRANSITIONS: 700,
    PYTHON_STATEMACHINE: 700,
    XSTATE: 40,
}
"""How many times as long a peer takes with the player as our complete runtime."""

ENDS = ("loop", "loops")
"""The behaviours that are driven by ends of activities."""


@dataclass(frozen=True, slots=True)
class Row:
    """A figure with what is wanted of it; one without a wish is for comparison."""

    what: str
    found: str
    wanted: str
    is_met: bool | None
    miss: str = ""
    """By how much it is missed."""


def rows(results: Results) -> Iterator[Row]:
    """All figures that could be measured, in the order of the report."""
    core = {name: _ratio(results, name, CORE_DICT) for name in MEASURED}
    for name, found in core.items():
        if found is not None:
            yield at_most(f"core step, {BEHAVIOURS[name].title}", found, 1.15, "× by hand")
    known = [found for found in core.values() if found is not None]
    if len(known) == len(MEASURED):
        yield at_most("core step, geometric mean", statistics.geometric_mean(known), 1.05, "× by hand")
    for name, limit in (("player", 0.65), ("idle", 0.5)):
        found = _ratio(results, name, CORE_TYPED)
        if found is not None:
            yield at_most(
                f"core step with typed blackboard, {BEHAVIOURS[name].title}", found, limit, "× by hand"
            )
    for name, limit in (("player", 1.3), ("two_states", 1.7)):
        found = _ratio(results, name, SEND)
        if found is not None:
            yield at_most(f"complete runtime, {BEHAVIOURS[name].title}", found, limit, "× by hand")
    found = _ratio(results, "player", POST)
    if found is not None:
        yield at_most("thread-safe `post`, the player", found, 1.8, "× by hand")
    for what, contender in (("complete runtime", SEND_DICT), ("thread-safe `post`", POST_DICT)):
        found = _ratio(results, "player", contender)
        if found is not None:
            yield beside(f"{what} with a dictionary, the player", found, "× by hand")
    for peer, least in PEERS_AT_LEAST.items():
        found = ratio_between(results, "peers", "player", peer.key, SEND.key)
        if found is not None:
            yield at_least(f"{peer.title} against the complete runtime, the player", found, least, "×")
    found = ratio_between(results, "peers", "player", SISMIC_UNCHECKED.key, SEND.key)
    if found is not None:
        yield beside(f"{SISMIC_UNCHECKED.title}, against the complete runtime, the player", found, "×")
    for form, contender in (("core `done`", CORE_TYPED), ("`Machine.done`", SEND)):
        for name in ENDS:
            found = _ratio(results, name, contender)
            if found is not None:
                yield beside(f"{form}, {BEHAVIOURS[name].title}", found, "× by hand")
    yield from _idle(results)
    yield from _single(results)
    for name, least in (("player", 2), ("idle", 10)):
        found = _ratio(results, name, NATIVE)
        if found is not None:
            yield at_least(
                f"native build, {BEHAVIOURS[name].title}", 1 / found, least, "× as fast as by hand"
            )


def _idle(results: Results) -> Iterator[Row]:
    series = results.series.get(("ours", "idle", CORE_TYPED.key))
    if series is None or series.ratio is None:
        return
    yield at_most("idle tick", series.nanoseconds, 60, "ns")
    yield at_least("idle tick", 1 / series.ratio, 5, "× as fast as by hand")


def _single(results: Results) -> Iterator[Row]:
    figures = results.figures
    if "size" in figures:
        yield at_most("1 000 states against 100, an event", figures["size"], 1.2, "×")
    for loading in results.loadings:
        if loading.key == SIMPLE:
            yield at_most("loading a compiled chart, 1 000 states", 1e3 * loading.again, 0.1, "ms")
        elif loading.key == GUARDED:
            what = "loading a compiled chart, 1 000 states, each with a guard and an action"
            yield beside(what, 1e3 * loading.again, "ms")
    for regions in MANY:
        if (regions, CORE_TYPED.key) in results.memory:
            size, _ = results.memory[regions, CORE_TYPED.key]
            what = f"memory of an instance without its blackboard, {regions_said(regions)}"
            yield at_most(what, size, 100 + 8 * regions, "bytes")


def _ratio(results: Results, behaviour: str, contender: Contender) -> float | None:
    series = results.series.get(("ours", behaviour, contender.key))
    return series.ratio if series is not None else None


def at_most(what: str, found: float, limit: float, unit: str) -> Row:
    """A figure that is not to be above its limit."""
    miss = "" if found <= limit else f"{100 * (found / limit - 1):.0f} % above"
    return Row(what, f"{number(found)} {unit}", f"≤ {number(limit)}", found <= limit, miss)


def beside(what: str, found: float, unit: str) -> Row:
    """A figure of which nothing is wanted."""
    return Row(what, f"{number(found)} {unit}", "–", None)


def regions_said(number: int) -> str:
    """How many regions."""
    return "one region" if number == 1 else f"{number} regions"


def at_least(what: str, found: float, limit: float, unit: str) -> Row:
    """A figure that is not to be below its limit."""
    miss = "" if found >= limit else f"{100 * (1 - found / limit):.0f} % below"
    return Row(what, f"{number(found)} {unit}", f"≥ {number(limit)}", found >= limit, miss)


def number(value: float) -> str:
    """A figure with about three digits."""
    if value >= 99.5:
        return f"{value:,.0f}".replace(",", " ")
    if value >= 9.95:
        return f"{value:.1f}".removesuffix(".0")
    return f"{value:.2f}" if value < 1 or round(value, 2) != round(value) else f"{value:.0f}"
