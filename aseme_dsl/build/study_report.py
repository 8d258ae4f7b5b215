"""The report of a study: Markdown for people, JSON for programs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from aseme_dsl.build.findings import Estimate, Row, Slower
from aseme_dsl.build.study import TIME, Played
from aseme_dsl.build.table import table
from aseme_dsl.build.variation import Knob, Variant

_BUSIEST = 3


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
    """The share that a further agent must gain to be worth it."""
    times: float
    """How much quicker the activities were tried."""
    played: tuple[Played, ...]
    rows: tuple[Row, ...]
    chosen: Row | None
    """The variant that is worth it, or the best."""
    quicker: tuple[Played, ...] = ()
    slowest: tuple[Slower, ...] = ()
    without_takes: tuple[str, ...] = ()
    """Activities that say no `takes`: whether their being quicker would help was not tried."""

    @property
    def what(self) -> str:
        """The measure in words."""
        if self.measure == TIME:
            return "time until all have finished (s)"
        return self.measure if ":" in self.measure else f"{self.measure} per minute"


def markdown(study: Study) -> str:
    """The report for people."""
    lines = [
        f"# {study.system}: {', '.join(_knob(knob) for knob in study.knobs) or 'as it is'}",
        "",
        f"Measured: {study.what}{', less is better' if study.less_is_better else ''}. "
        f"{_times(len(study.seeds), 'run')} of each, {_seeds(study.seeds)}, "
        f"{study.length / 1e9:g} s of virtual time. {_intervals(study)}",
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
    "An activity's per cents are its share of the time of all agents; what an agent does several times at"
    " once is counted as often, and may come to more than 100 %."
)


def _seeds(seeds: tuple[int, ...]) -> str:
    return f"seed {seeds[0]}" if len(seeds) == 1 else f"seeds {seeds[0]} to {seeds[-1]}"


def _intervals(study: Study) -> str:
    if len(study.seeds) == 1:
        return "One run has no interval: what is left to chance is not seen."
    return "Intervals are of 95 % (bootstrap)."


def _table(study: Study) -> list[str]:
    head = [
        *(knob.name for knob in study.knobs),
        study.what,
        "95 %",
        "gain of this step",
        "busiest activities",
    ]
    body = [
        [
            *(value for _, value in row.variant),
            _number(row.measure.mean) if row.measure else "–",
            _interval(row.measure) if row.measure else "–",
            _share(row.gain) if row.gain else "",
            ", ".join(f"{name} {100 * share:.0f} %" for name, share in list(row.busy.items())[:_BUSIEST]),
        ]
        for row in study.rows
    ]
    return list(table(head, body))


def _conclusion(study: Study) -> list[str]:
    lines: list[str] = []
    is_measured = any(row.measure is not None for row in study.rows)
    if is_measured and len(study.seeds) > 1 and all(_are_alike(item) for item in study.played):
        lines.append(
            "- Every seed gave the same: nothing here was left to chance, and one run would have been enough."
        )
    for row in study.rows:
        if row.unfinished:
            text = f"{_times(row.unfinished, 'run')} of {_variant(row.variant)} gave no measure"
            lines.append(f"- {text}: {'it did not finish in time' if study.measure == TIME else 'None'}.")
        lines += [f"- With {_variant(row.variant)}, an agent failed: {text}." for text in row.failures]
    if not is_measured:
        return [*lines, "", "**Nothing was measured:** no run gave a number.", ""]
    if study.chosen is None:
        return lines
    if len(study.rows) > 1:
        lines += [""] if lines else []
        lines += [_worth(study, study.chosen) if _is_count(study) else _best(study, study.chosen)]
    return [*lines, ""] if lines else lines


def _are_alike(played: Played) -> bool:
    return len({(run.measure, run.time, *sorted(run.done.items())) for run in played.runs}) == 1


def _is_count(study: Study) -> bool:
    return len(study.knobs) == 1 and study.knobs[0].counts


def _worth(study: Study, chosen: Row) -> str:
    name = study.knobs[0].name
    value = chosen.variant[0][1]
    place = study.rows.index(chosen)
    if place + 1 == len(study.rows):
        return f"**Worth it: {value} {name}**, and perhaps more: the last step still gained enough."
    after = study.rows[place + 1]
    then = after.variant[0][1]
    if after.gain is None:
        none = " it gives nothing" if chosen.measure and chosen.measure.mean == 0 else ""
        why = f", for with {value}{none}" if none else ""
        return f"**Worth it: {value} {name}.** What {then} would gain cannot be told as a share{why}."
    why = (
        f"less than {100 * study.least:g} %"
        if after.gain.mean < study.least
        else "not more than chance may do"
    )
    return f"**Worth it: {value} {name}.** Going on to {then} gains {_share(after.gain)}: {why}."


def _best(study: Study, chosen: Row) -> str:
    measure = f"{_number(chosen.measure.mean)}" if chosen.measure else "–"
    near = [
        row
        for row in study.rows
        if row is not chosen and row.measure and chosen.measure and _overlap(row.measure, chosen.measure)
    ]
    text = f"**Best: {_variant(chosen.variant)}** with {measure}."
    if near:
        text += f" Not to be told from it by these runs: {'; '.join(_variant(row.variant) for row in near)}."
    return text


def _overlap(one: Estimate, other: Estimate) -> bool:
    return one.low <= other.high and other.low <= one.high


_UNTRIED = "Not tried, for how long they last is said by their code or the world, and not by a `takes`"


def _bottleneck(study: Study) -> list[str]:
    if study.chosen is None or not (study.slowest or study.without_takes):
        return []
    at = f" with {_variant(study.chosen.variant)}" if study.knobs else ""
    lines = [f"## If an activity were {study.times:g} times as quick{at}", ""]
    if study.quicker and not study.slowest:
        lines += ["What they would gain cannot be told: there is nothing of which it were a share."]
    if study.slowest:
        lines += [_slowest(study), ""]
        width = max(len(item.activity) for item in study.slowest)
        lines += [f"- {item.activity:<{width}}  {_share(item.gain)}" for item in study.slowest]
    if study.without_takes:
        names = ", ".join(study.without_takes)
        lines += ["", f"{_UNTRIED}: {names}."]
    return lines


def _slowest(study: Study) -> str:
    names = [item.activity for item in study.slowest if item.is_bottleneck]
    tried = f"the {len(study.slowest)} that could be tried" if study.without_takes else ""
    if not names:
        return f"None of {tried or 'them'} is a bottleneck: none would gain more than chance may do."
    among = f"Of {tried}, the" if tried else "The"
    if len(names) == 1:
        return f"**{among} bottleneck is {names[0]}.**"
    return f"**{among} bottleneck is {', '.join(names[:-1])} or {names[-1]}**: these runs do not tell which."


def _variant(variant: Variant) -> str:
    return ", ".join(f"{knob.name} = {value}" for knob, value in variant) or "the team as it is"


def _knob(knob: Knob) -> str:
    return f"{knob.name} = {', '.join(knob.values)}"


def _times(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _number(value: float) -> str:
    return f"{value:.4g}"


def _percent(share: float) -> str:
    return f"{100 * share:+.1f} %"


def _interval(item: Estimate) -> str:
    if item.runs == 1:
        return ""
    return "all the same" if item.low == item.high else f"{_number(item.low)} to {_number(item.high)}"


def _share(gain: Estimate) -> str:
    if gain.low == gain.high:
        return _percent(gain.mean)
    return f"{_percent(gain.mean)} ({_percent(gain.low)} to {_percent(gain.high)})"


# ---- for programs ------------------------------------------------------------------------------


def as_json(study: Study) -> dict[str, Any]:
    """All that was found, and every run; times in ns, gains as shares."""
    return {
        "system": study.system,
        "knobs": [{"name": knob.name, "values": list(knob.values)} for knob in study.knobs],
        "measure": study.measure,
        "less_is_better": study.less_is_better,
        "seeds": list(study.seeds),
        "length": study.length,
        "rows": [
            {
                "variant": _values(row.variant),
                "measure": _estimate(row.measure),
                "gain": _estimate(row.gain),
                "busy": dict(row.busy),
                "unfinished": row.unfinished,
                "failures": list(row.failures),
            }
            for row in study.rows
        ],
        "chosen": _values(study.chosen.variant) if study.chosen is not None else None,
        "quicker": {
            "times": study.times,
            "gains": [{"activity": item.activity, **(_estimate(item.gain) or {})} for item in study.slowest],
            "bottleneck": [item.activity for item in study.slowest if item.is_bottleneck],
            "untried": list(study.without_takes),
        },
        "runs": [
            {
                "variant": _values(item.case.variant),
                "quicker": item.case.quicker,
                "seed": run.seed,
                "measure": run.measure,
                "time": run.time,
                "agents": run.agents,
                "done": dict(sorted(run.done.items())),
                "busy": dict(sorted(run.busy.items())),
                "failures": list(run.failures),
            }
            for item in (*study.played, *study.quicker)
            for run in item.runs
        ],
    }


def _values(variant: Variant) -> dict[str, str]:
    return {knob.name: value for knob, value in variant}


def _estimate(item: Estimate | None) -> dict[str, Any] | None:
    if item is None:
        return None
    return {"mean": item.mean, "low": item.low, "high": item.high, "runs": item.runs}
