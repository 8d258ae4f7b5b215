"""The report of a study: Markdown for people, JSON for programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

from aseme_dsl.project.studying.findings import (
    Estimate,
    Gain,
    Row,
    Slower,
    gain,
    gives_nothing,
    is_measured,
    judged,
    later,
    near,
)
from aseme_dsl.project.studying.study import TIME, Played
from aseme_dsl.project.studying.table import table
from aseme_dsl.project.studying.variation import Knob, Variant
from aseme_dsl.records import dataclass

_BUSIEST = 3
_MOST_NAMED = 3
"""How many variants, or reasons, a sentence names."""
_MOST_FAULTS = 10
"""How many faults the report for people has."""


@dataclass(frozen=True, slots=True)
class Untried:
    """Activities of which it was not tried what their being quicker would gain, by why not."""

    by_code: tuple[str, ...] = ()
    """How long they last is said by their code or the world."""
    without_code: tuple[str, ...] = ()
    """They have neither code nor a `takes`: nothing says how long they last."""
    no_time: tuple[str, ...] = ()
    """They say `takes 0s`."""

    @property
    def names(self) -> tuple[str, ...]:
        """All of them that last."""
        return (*self.by_code, *self.without_code)


@dataclass(frozen=True, slots=True)
class Study:
    """What was asked, what was played, and what was found."""

    system: str
    knobs: tuple[Knob, ...]
    measure: str
    less_is_better: bool
    seeds: tuple[int, ...]
    length: int
    least: float
    """The share that a further step must gain to be worth it."""
    times: float
    """How much quicker the activities were tried."""
    played: tuple[Played, ...]
    rows: tuple[Row, ...]
    chosen: Row | None
    """The variant that is worth it, or the best."""
    quicker: tuple[Played, ...] = ()
    slowest: tuple[Slower, ...] = ()
    untried: Untried = Untried()
    network: str | None = None
    """The words of the simulated network."""

    @property
    def what(self) -> str:
        """The measure in words."""
        if self.measure == TIME:
            return "time until all have finished (s)"
        return self.measure if ":" in self.measure else f"{self.measure} per minute"

    @property
    def is_measured(self) -> bool:
        """Whether there is a number from which something may be concluded."""
        return is_measured(self.rows)

    @property
    def counts(self) -> bool:
        """Whether it is asked how many agents are worth it, and not which variant is best."""
        return len(self.knobs) == 1 and self.knobs[0].counts

    @property
    def near(self) -> tuple[Row, ...]:
        """What these runs do not tell from the best."""
        if self.chosen is None or self.counts:
            return ()
        return near(self.rows, self.chosen, less_is_better=self.less_is_better)

    @property
    def later(self) -> tuple[tuple[Row, Gain], ...]:
        """The larger sizes that gain something over the one that is worth it, beyond a step that did not."""
        if self.chosen is None or not self.counts:
            return ()
        return later(self.rows, self.chosen, self.least, less_is_better=self.less_is_better)


def markdown(study: Study) -> str:
    """The report for people."""
    lines = [
        f"# {study.system}: {', '.join(_knob(knob) for knob in study.knobs) or 'as it is'}",
        "",
        f"Measured: {study.what}{', less is better' if study.less_is_better else ''}. "
        f"{_times(len(study.seeds), 'run')} of each, {_seeds(study.seeds)}, "
        f"{study.length / 1e9:g} s of virtual time{_over(study)}. {_intervals(study)}",
        "",
        *_table(study),
        "",
        _SHARES,
        "",
        *_conclusion(study),
        *_bottleneck(study),
    ]
    return "\n".join(lines).rstrip() + "\n"


_SHARES = (
    "An activity's per cents are its share of the time of all agents. What an agent does several times at"
    " once is counted as often, and may come to more than 100 %."
)


def _seeds(seeds: tuple[int, ...]) -> str:
    return f"seed {seeds[0]}" if len(seeds) == 1 else f"seeds {seeds[0]} to {seeds[-1]}"


def _intervals(study: Study) -> str:
    if len(study.seeds) == 1:
        return "One run has no interval: random effects are not visible."
    return "Intervals are of 95 % (Student's t)."


def _table(study: Study) -> list[str]:
    lacks = any(row.unfinished or row.without_measure for row in study.rows)
    head = [
        *(knob.name for knob in study.knobs),
        study.what,
        "95 %",
        *(["finished" if study.measure == TIME else "runs with a number"] if lacks else []),
        "gain of this step",
        "busiest activities",
    ]
    body = [
        [
            *(value for _, value in row.variant),
            _mean(row),
            _interval(row.measure) if row.measure else "–",
            *([f"{_known(row)} of {len(row.runs)}"] if lacks else []),
            _gain(row.gain) if row.gain else "",
            ", ".join(f"{name} {100 * share:.0f} %" for name, share in list(row.busy.items())[:_BUSIEST]),
        ]
        for row in study.rows
    ]
    return list(table(head, body))


def _mean(row: Row) -> str:
    if row.measure is None:
        return "–"
    return f"{'≥ ' if row.unfinished else ''}{_number(row.measure.mean)}"


def _known(row: Row) -> int:
    return len(row.runs) - row.without_measure - row.unfinished


def _conclusion(study: Study) -> list[str]:
    lines: list[str] = []
    if study.is_measured and len(study.seeds) > 1 and all(_are_alike(item) for item in study.played):
        lines.append("- Every seed gave the same: these runs show no random effect.")
    for row in study.rows:
        lines += _incomplete(study, row)
    lines += _faults(study.rows)
    if not study.is_measured:
        why = f"within {study.length / 1e9:g} s no run finished" if study.measure == TIME else ""
        return [*lines, "", f"**Nothing was measured:** {why or 'no run gave a number'}.", ""]
    if len(study.rows) > 1:
        lines += [""] if lines else []
        lines += [_chosen(study)]
    return [*lines, ""] if lines else lines


def _chosen(study: Study) -> str:
    if study.chosen is None:
        return "**Nothing is chosen:** no variant gave a number in each of its runs."
    text = (_worth if study.counts else _best)(study, study.chosen)
    fit = judged(study.rows)
    unfit = [row for row in study.rows if row not in fit]
    if unfit:
        text += f" Not judged, as not each of their runs gave a number: {_variants(unfit)}."
    return text


def _incomplete(study: Study, row: Row) -> list[str]:
    """What did not go as it should with a variant."""
    lines = []
    of = f"{_of(len(row.runs))} of {_variant(row.variant)}"
    if row.failed:
        reasons = [
            reason if count == row.failed else f"{reason} ({_of(count)})"
            for reason, count in row.failures.most_common(_MOST_NAMED)
        ]
        more = len(row.failures) - len(reasons)
        text = "; ".join([*reasons, *([f"and {more} other reasons"] if more else [])])
        none = " Such a run has no time." if study.measure == TIME else ""
        lines.append(f"- An agent failed in {row.failed} of {of}: {text}.{none}")
    if row.unfinished:
        length = f"{study.length / 1e9:g} s"
        counts = f"it counts as {length}" if row.unfinished == 1 else f"they count as {length} each"
        lines.append(f"- {row.unfinished} of {of} had not finished: {counts}, and would take longer.")
    if row.without_measure and study.measure != TIME:
        lines.append(f"- {row.without_measure} of {of} gave no number: {study.measure} said None.")
    return lines


def _faults(found: Sequence[Row]) -> list[str]:
    """What could not be done, once each, and where."""
    counts: Counter[str] = Counter()
    where: dict[str, list[Row]] = {}
    for row in found:
        counts.update(row.faults)
        for reason in row.faults:
            where.setdefault(reason, []).append(row)
    total = sum(len(row.runs) for row in found)
    lines = []
    for reason in list(where)[:_MOST_FAULTS]:
        of = "" if len(where[reason]) == len(found) else f" of {_variants(where[reason])}"
        runs = sum(len(row.runs) for row in where[reason])
        share = "each run" if counts[reason] == total else f"{counts[reason]} of {_of(runs)}"
        lines.append(f"- In {share}{of}: {reason}.")
    more = len(where) - len(lines)
    return [*lines, *([f"- {more} other faults are in report.json."] if more else [])]


def _are_alike(played: Played) -> bool:
    return len({(run.measure, run.time, *sorted(run.done.items())) for run in played.runs}) == 1


def _worth(study: Study, chosen: Row) -> str:
    name = study.knobs[0].name
    value = chosen.variant[0][1]
    if gives_nothing(chosen) and not study.less_is_better:
        gives = f"{value} {name} gives nothing"
        return f"**None is worth it:** {gives}, and no gain is larger than random variation."
    fit = judged(study.rows)
    place = fit.index(chosen)
    if place + 1 == len(fit):
        if place == 0:
            return f"**Worth it: {value} {name}**, the only size that can be judged."
        return f"**Worth it: {value} {name}**, and perhaps more: the last step still gained enough."
    after = fit[place + 1]
    then = after.variant[0][1]
    text = f"**Worth it: {value} {name}.**"
    step = gain(chosen.runs, after.runs, less_is_better=study.less_is_better)
    if step is not None:
        is_less = step.share is not None and step.share.mean < study.least
        why = f"less than {100 * study.least:g} %" if is_less else "not more than random variation"
        text += f" Going on to {then} gains {_gain(step)}: {why}."
    return text + _later(study, name)


def _later(study: Study, name: str) -> str:
    """That a plateau is not the end."""
    if not study.later:
        return ""
    row, gained = study.later[0]
    text = f" **But more are better again:** {row.variant[0][1]} {name} gain {_gain(gained)} over it"
    best = max(study.later, key=lambda item: item[1].difference.mean)
    if best[0] is not row:
        text += f", and {best[0].variant[0][1]}, the most here, {_gain(best[1])}"
    return f"{text}."


def _best(study: Study, chosen: Row) -> str:
    mean = (
        f"{'at least ' if chosen.unfinished else ''}{_number(chosen.measure.mean) if chosen.measure else '–'}"
    )
    text = f"**Best: {_variant(chosen.variant)}** with {mean}."
    if study.near:
        names = "; ".join(_variant(row.variant) for row in study.near)
        text += f" Not to be told from it by these runs: {names}."
    return text


def _bottleneck(study: Study) -> list[str]:
    untried = study.untried
    if study.chosen is None or not (study.slowest or untried.names):
        return []
    at = f" with {_variant(study.chosen.variant)}" if study.knobs else ""
    lines = [f"## If an activity were {study.times:g} times as quick{at}"]
    if study.quicker and not study.slowest:
        lines += ["", "What they would gain cannot be told: there is nothing of which it were a share."]
    if study.slowest:
        lines += ["", _slowest(study), ""]
        width = max(len(item.activity) for item in study.slowest)
        lines += [f"- {item.activity:<{width}}  {_share(item.gain)}" for item in study.slowest]
    for names, why in (
        (untried.by_code, "for how long they last is said by their code or the world, and not by a `takes`"),
        (untried.without_code, "for they have neither code nor a `takes`, and how long they last is made up"),
        (untried.no_time, "for their `takes` is 0s"),
    ):
        if names:
            lines += ["", f"Not tried, {why}: {', '.join(names)}."]
    return lines


def _slowest(study: Study) -> str:
    names = [item.activity for item in study.slowest if item.is_bottleneck]
    tried = f"the {len(study.slowest)} that could be tried" if study.untried.names else ""
    if not names:
        return f"None of {tried or 'them'} is a bottleneck: no gain is larger than random variation."
    among = f"Of {tried}, the" if tried else "The"
    if len(names) == 1:
        return f"**{among} bottleneck is {names[0]}.**"
    return f"**{among} bottleneck is {', '.join(names[:-1])} or {names[-1]}**: these runs do not tell which."


def _variant(variant: Variant) -> str:
    return ", ".join(f"{knob.name} = {value}" for knob, value in variant) or "the team as it is"


def _variants(found: Sequence[Row]) -> str:
    """Variants by name, if they are not too many."""
    if len(found) > _MOST_NAMED:
        return f"{len(found)} variants"
    return "; ".join(_variant(row.variant) for row in found)


def _knob(knob: Knob) -> str:
    return f"{knob.name} = {', '.join(knob.values)}"


def _times(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _of(runs: int) -> str:
    return _times(runs, "run")


def _number(value: float) -> str:
    return f"{value:.4g}"


def _percent(share: float) -> str:
    return f"{100 * share:+.1f} %"


def _interval(item: Estimate) -> str:
    if item.runs == 1:
        return ""
    return "all the same" if item.low == item.high else f"{_number(item.low)} to {_number(item.high)}"


def _gain(found: Gain) -> str:
    """A gain as a share; what is gained from nothing has none."""
    if found.share is not None:
        return _share(found.share)
    return f"{found.difference.mean:+.4g} from 0" if found.difference.mean else "nothing"


def _share(gained: Estimate) -> str:
    mean, low, high = map(_percent, (gained.mean, gained.low, gained.high))
    return mean if low == high else f"{mean} ({low} to {high})"


# ---- for programs ------------------------------------------------------------------------------


FORMAT = 1
"""The version of the format of `report.json`."""


def _over(study: Study) -> str:
    return f" over a network with {study.network}" if study.network else ""


def as_json(study: Study) -> dict[str, object]:
    """All that was found, and every run; times in ns, gains as shares."""
    return {
        "format": FORMAT,
        "system": study.system,
        "knobs": [{"name": knob.name, "values": list(knob.values)} for knob in study.knobs],
        "measure": study.measure,
        "less_is_better": study.less_is_better,
        "seeds": list(study.seeds),
        "length": study.length,
        "network": study.network,
        "rows": [
            {
                "variant": _values(row.variant),
                "measure": _estimate(row.measure),
                "gain": _estimate(row.gain.share if row.gain else None),
                "difference": _estimate(row.gain.difference if row.gain else None),
                "busy": dict(row.busy),
                "unfinished": row.unfinished,
                "without_measure": row.without_measure,
                "failed": row.failed,
                "failures": _counted(row.failures),
                "faults": _counted(row.faults),
            }
            for row in study.rows
        ],
        "chosen": _values(study.chosen.variant) if study.chosen is not None else None,
        "near": [_values(row.variant) for row in study.near],
        "later": [_values(row.variant) for row, _ in study.later],
        "quicker": {
            "times": study.times,
            "gains": [{"activity": item.activity, **(_estimate(item.gain) or {})} for item in study.slowest],
            "bottleneck": [item.activity for item in study.slowest if item.is_bottleneck],
            "untried": list((*study.untried.names, *study.untried.no_time)),
        },
        "runs": [
            {
                "variant": _values(item.case.variant),
                "quicker": item.case.quicker,
                "seed": run.seed,
                "measure": run.measure,
                "at_least": run.at_least,
                "time": run.time,
                "agents": run.agents,
                "done": dict(sorted(run.done.items())),
                "busy": dict(sorted(run.busy.items())),
                "failures": list(run.failures),
                "faults": list(run.faults),
            }
            for item in (*study.played, *study.quicker)
            for run in item.runs
        ],
    }


def _counted(found: Mapping[str, int]) -> list[dict[str, object]]:
    return [{"reason": reason, "runs": runs} for reason, runs in found.items()]


def _values(variant: Variant) -> dict[str, str]:
    return {knob.name: value for knob, value in variant}


def _estimate(item: Estimate | None) -> dict[str, object] | None:
    if item is None:
        return None
    return {"mean": item.mean, "low": item.low, "high": item.high, "runs": item.runs}
