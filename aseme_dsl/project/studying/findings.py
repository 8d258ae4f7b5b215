"""Findings: what the runs of a study say: which variant is best, how many agents are worth it, what slows."""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cache

from aseme_dsl.project.studying.study import Played, Run
from aseme_dsl.project.studying.variation import Variant
from aseme_dsl.records import dataclass

SURE = 0.95
"""How often an interval contains what it is about, if that is distributed normally."""
_SAME = 1e-12
"""Two measures that differ by no more than this share are the same: sums of floats are not exact."""


@dataclass(frozen=True, slots=True)
class Estimate:
    """A mean, with the interval in which it lies with 95 %; of how many runs."""

    mean: float
    low: float
    high: float
    runs: int

    @property
    def is_told_from_none(self) -> bool:
        """Whether it is not zero by random variation alone."""
        return self.low > 0 or self.high < 0


@dataclass(frozen=True, slots=True)
class Gain:
    """How much better runs are than others with the same seeds.

    `share` is the difference as a share of the mean of the others, and None where that is nothing. More is
    better in both, also where less of the measure is.
    """

    difference: Estimate
    share: Estimate | None

    def is_worth(self, least: float) -> bool:
        """Whether it is at least that share, and more than random variation. From nothing, anything is."""
        enough = self.share is None or self.share.mean >= least
        return enough and self.difference.mean > 0 and self.difference.is_told_from_none


@dataclass(frozen=True, slots=True)
class Row:
    """What one variant gave. `gain` is that over the variant before it.

    `busy` is the share of the agents' time in which their activities ran, by activity.
    """

    variant: Variant
    measure: Estimate | None
    gain: Gain | None
    busy: Mapping[str, float]
    runs: tuple[Run, ...] = field(repr=False)

    @property
    def unfinished(self) -> int:
        """In how many runs the measure is only the least that it can be."""
        return sum(run.at_least for run in self.runs)

    @property
    def without_measure(self) -> int:
        """How many runs gave none."""
        return sum(run.measure is None for run in self.runs)

    @property
    def failed(self) -> int:
        """In how many runs an agent failed."""
        return sum(bool(run.failures) for run in self.runs)

    @property
    def failures(self) -> Counter[str]:
        """Why agents failed, and in how many runs."""
        return Counter(text for run in self.runs for text in dict.fromkeys(run.failures))

    @property
    def faults(self) -> Counter[str]:
        """What could not be done, and in how many runs."""
        return Counter(text for run in self.runs for text in run.faults)


@dataclass(frozen=True, slots=True)
class Slower:
    """What would come of one activity if it were quicker: the gain, as a share of the measure.

    `is_bottleneck`: it gains more than nothing, and no other gains more than it beyond random variation.
    """

    activity: str
    gain: Estimate
    is_bottleneck: bool = False


def estimate(values: Sequence[float]) -> Estimate | None:
    """The mean of what was seen, with Student's interval of 95 %; None of nothing.

    What is always the same has an interval of no width, as has a single value.
    """
    if not values:
        return None
    mean = statistics.fmean(values)
    if min(values) == max(values):
        return Estimate(mean, mean, mean, len(values))
    half = student(len(values) - 1) * statistics.stdev(values) / math.sqrt(len(values))
    return Estimate(mean, mean - half, mean + half, len(values))


@cache
def student(freedom: int) -> float:
    """Within how many standard errors of its mean 95 % of Student's t with these degrees of freedom lies."""
    low, high = 1.9, 12.8  # that of the normal distribution, and that of one degree, are between
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if _within(middle, freedom) < SURE else (low, middle)
    return (low + high) / 2


def _within(t: float, freedom: int) -> float:
    """How much of Student's t lies between -t and t (Abramowitz and Stegun, 26.7.3 and 26.7.4)."""
    angle = math.atan(t / math.sqrt(freedom))
    sine, cosine = math.sin(angle), math.cos(angle)
    odd = freedom % 2
    term, total = cosine if odd else 1.0, 0.0
    for place in range((freedom - odd) // 2):
        total += term
        term *= cosine * cosine * (2 * place + 1 + odd) / (2 * place + 2 + odd)
    return 2 / math.pi * (angle + sine * total) if odd else sine * total


def gain(before: Sequence[Run], after: Sequence[Run], *, less_is_better: bool) -> Gain | None:
    """How much better the runs are than those before with the same seeds; None where there are no pairs."""
    old = {run.seed: run.measure for run in before}
    pairs = [
        (known, run.measure)
        for run in after
        if (known := old.get(run.seed)) is not None and run.measure is not None
    ]
    sign = -1 if less_is_better else 1
    differences = [
        0.0 if math.isclose(new, known, rel_tol=_SAME) else sign * (new - known) for known, new in pairs
    ]
    difference = estimate(differences)
    if difference is None:
        return None
    base = abs(statistics.fmean(known for known, _ in pairs))
    return Gain(difference, estimate([item / base for item in differences]) if base else None)


def rows(played: Sequence[Played], *, less_is_better: bool) -> tuple[Row, ...]:
    """A row for each case; gains are over the row before where only the last parameter's value differs."""
    found: list[Row] = []
    for place, item in enumerate(played):
        before = played[place - 1] if place else None
        is_next = before is not None and before.case.variant[:-1] == item.case.variant[:-1]
        better = gain(before.runs, item.runs, less_is_better=less_is_better) if before and is_next else None
        measured = [run.measure for run in item.runs if run.measure is not None]
        found.append(Row(item.case.variant, estimate(measured), better, _busy(item.runs), item.runs))
    return tuple(found)


def is_measured(found: Sequence[Row]) -> bool:
    """Whether anything is known of any variant, but that it took longer than it was given."""
    return any(row.without_measure + row.unfinished < len(row.runs) for row in found)


def judged(found: Sequence[Row]) -> list[Row]:
    """The rows that can be compared: all of whose runs gave a measure.

    What only some gave is that of the lucky ones. Where there is one row there is nothing to compare.
    """
    if not is_measured(found):
        return []
    if len(found) == 1:
        return list(found)
    return [row for row in found if row.without_measure == 0]


def _busy(runs: Sequence[Run]) -> dict[str, float]:
    """The most time first."""
    whole = sum(run.time * run.agents for run in runs) or 1
    total: dict[str, int] = {}
    for run in runs:
        for name, time in run.busy.items():
            total[name] = total.get(name, 0) + time
    return {name: time / whole for name, time in sorted(total.items(), key=lambda pair: (-pair[1], pair[0]))}


def best(found: Sequence[Row], *, less_is_better: bool) -> Row | None:
    """The row with the best mean; None if none can be judged. Of equals the first."""
    sign = -1 if less_is_better else 1
    means = [(sign * row.measure.mean, row) for row in judged(found) if row.measure is not None]
    return max(means, key=lambda item: item[0], default=(0.0, None))[1]


def near(found: Sequence[Row], chosen: Row, *, less_is_better: bool) -> tuple[Row, ...]:
    """The other rows that the runs do not tell from the chosen one, compared seed by seed."""
    others = [row for row in judged(found) if row is not chosen]
    gains = [(row, gain(chosen.runs, row.runs, less_is_better=less_is_better)) for row in others]
    return tuple(row for row, better in gains if better and not better.difference.is_told_from_none)


def worth(found: Sequence[Row], least: float, *, less_is_better: bool) -> Row | None:
    """The last row up to which each step gained at least that share, beyond random variation.

    None if none can be judged. The rows are those of one parameter that says how many agents there are. Sizes
    that give nothing do not end the search while a later one gives something.
    """
    usable = judged(found)
    if not usable:
        return None
    reached = usable[0]
    for row in usable[1:]:
        step = gain(reached.runs, row.runs, less_is_better=less_is_better)
        if step is not None and step.is_worth(least):
            reached = row
        elif less_is_better or not gives_nothing(reached):
            break
    return reached


def gives_nothing(row: Row) -> bool:
    """Whether the measure was nothing in each run."""
    return row.measure is not None and row.measure.low == row.measure.high == 0


def later(
    found: Sequence[Row], chosen: Row, least: float, *, less_is_better: bool
) -> tuple[tuple[Row, Gain], ...]:
    """The rows after the chosen one that gain at least that share over it, beyond random variation."""
    usable = judged(found)
    gains = [
        (row, gain(chosen.runs, row.runs, less_is_better=less_is_better))
        for row in usable[usable.index(chosen) + 1 :]
    ]
    return tuple((row, better) for row, better in gains if better is not None and better.is_worth(least))


def slowest(base: Played, quicker: Sequence[Played], *, less_is_better: bool) -> tuple[Slower, ...]:
    """What each activity's being quicker would gain, the most first."""
    gains = [
        (item.case.quicker, better.share, item.runs)
        for item in quicker
        if item.case.quicker is not None
        and (better := gain(base.runs, item.runs, less_is_better=less_is_better)) is not None
        and better.share is not None
    ]
    gains.sort(key=lambda item: (-item[1].mean, item[0]))

    def is_bottleneck(better: Estimate, runs: Sequence[Run]) -> bool:
        more = gain(runs, gains[0][2], less_is_better=less_is_better)
        return better.low > 0 and more is not None and not more.difference.is_told_from_none

    return tuple(Slower(name, better, is_bottleneck(better, runs)) for name, better, runs in gains)
