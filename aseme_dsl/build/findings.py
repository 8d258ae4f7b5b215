"""Findings: what the runs of a study say: which variant is best, how many agents are worth it, what slows."""

from __future__ import annotations

import random
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from aseme_dsl.build.study import Played, Run
from aseme_dsl.build.variation import Variant

RESAMPLES = 2000
"""How often runs are drawn anew for an interval of 95 % (bootstrap by percentiles)."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A mean, with the interval in which it lies with 95 %; of how many runs."""

    mean: float
    low: float
    high: float
    runs: int

    @property
    def is_told_from_none(self) -> bool:
        """Whether it is not zero by chance alone."""
        return self.low > 0 or self.high < 0


@dataclass(frozen=True, slots=True)
class Row:
    """What one variant gave. `gain` is that over the variant before it, as a share of it.

    `busy` is the share of the agents' time in which their activities ran, by activity.
    """

    variant: Variant
    measure: Estimate | None
    gain: Estimate | None
    busy: Mapping[str, float]
    unfinished: int
    failures: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Slower:
    """What would come of one activity if it were quicker: the gain, as a share of the measure.

    `is_bottleneck`: it gains more than nothing, and no other gains more than it beyond chance.
    """

    activity: str
    gain: Estimate
    is_bottleneck: bool = False


def estimate(values: Sequence[float]) -> Estimate | None:
    """The mean of what was seen; None of nothing. The same values give the same interval."""
    if not values:
        return None
    mean = statistics.fmean(values)
    if len(values) == 1 or min(values) == max(values):
        return Estimate(mean, mean, mean, len(values))
    draw = random.Random(len(values))
    means = sorted(statistics.fmean(draw.choices(values, k=len(values))) for _ in range(RESAMPLES))
    return Estimate(mean, means[RESAMPLES // 40], means[-1 - RESAMPLES // 40], len(values))


def gain(before: Sequence[Run], after: Sequence[Run], *, less_is_better: bool) -> Estimate | None:
    """How much better the runs are than those before with the same seeds, as a share of these.

    None where no pair can be compared, or what it is a share of is nothing.
    """
    old = {run.seed: run.measure for run in before}
    pairs = [
        (known, run.measure)
        for run in after
        if (known := old.get(run.seed)) is not None and run.measure is not None
    ]
    base = statistics.fmean(known for known, _ in pairs) if pairs else 0.0
    if base == 0:
        return None
    sign = -1 if less_is_better else 1
    return estimate([sign * (new - known) / abs(base) for known, new in pairs])


def rows(played: Sequence[Played], *, less_is_better: bool) -> tuple[Row, ...]:
    """A row for each case; gains are over the row before where only the last knob's value differs."""
    found: list[Row] = []
    for place, item in enumerate(played):
        before = played[place - 1] if place else None
        is_next = before is not None and before.case.variant[:-1] == item.case.variant[:-1]
        better = gain(before.runs, item.runs, less_is_better=less_is_better) if before and is_next else None
        measured = [run.measure for run in item.runs if run.measure is not None]
        failures = tuple(dict.fromkeys(text for run in item.runs for text in run.failures))
        missing = len(item.runs) - len(measured)
        found.append(Row(item.case.variant, estimate(measured), better, _busy(item.runs), missing, failures))
    return tuple(found)


def _busy(runs: Sequence[Run]) -> dict[str, float]:
    """The most time first."""
    whole = sum(run.time * run.agents for run in runs) or 1
    total: dict[str, int] = {}
    for run in runs:
        for name, time in run.busy.items():
            total[name] = total.get(name, 0) + time
    return {name: time / whole for name, time in sorted(total.items(), key=lambda pair: (-pair[1], pair[0]))}


def best(found: Sequence[Row], *, less_is_better: bool) -> Row | None:
    """The row with the best mean; None if nothing was measured. Of equals the first."""
    sign = -1 if less_is_better else 1
    with_measure = [row for row in found if row.measure is not None]
    return max(with_measure, key=lambda row: sign * (row.measure.mean if row.measure else 0), default=None)


def worth(found: Sequence[Row], least: float) -> Row | None:
    """The last row up to which each step gained at least that share, beyond chance.

    None if nothing was measured. The rows are those of one knob that says how many agents there are.
    """
    reached = next((row for row in found if row.measure is not None), None)
    if reached is None:
        return None
    for row in found[found.index(reached) + 1 :]:
        if row.gain is None or row.gain.mean < least or not row.gain.is_told_from_none:
            break
        reached = row
    return reached


def slowest(base: Played, quicker: Sequence[Played], *, less_is_better: bool) -> tuple[Slower, ...]:
    """What each activity's being quicker would gain, the most first."""
    gains = [
        (item.case.quicker, better, item.runs)
        for item in quicker
        if item.case.quicker is not None
        and (better := gain(base.runs, item.runs, less_is_better=less_is_better)) is not None
    ]
    gains.sort(key=lambda item: (-item[1].mean, item[0]))

    def is_bottleneck(better: Estimate, runs: Sequence[Run]) -> bool:
        more = gain(runs, gains[0][2], less_is_better=less_is_better)
        return better.low > 0 and more is not None and not more.is_told_from_none

    return tuple(Slower(name, better, is_bottleneck(better, runs)) for name, better, runs in gains)
