"""What was found, as Markdown, with a plot beside it."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path

from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.peers.contenders import BY_HAND, BY_HAND_SLOTS, OURS, PEERS, SEND, SEND_DICT, Contender
from benchmarks.peers.measuring import Results, Run, ratio_between
from benchmarks.peers.plot import plot_of
from benchmarks.peers.targets import Row, number, regions_said, rows

PLOT = "performance.svg"
BEGIN, END = "<!-- measured by", "<!-- /measured -->"


def written(results: Results, into: Path) -> Path:
    """Write the report, its plot and the figures as JSON; return the path of the report."""
    into.mkdir(parents=True, exist_ok=True)
    (into / PLOT).write_text(plot_of(results), encoding="utf-8")
    (into / "performance.json").write_text(json.dumps(figures(results), indent=1) + "\n", encoding="utf-8")
    report = into / "performance.md"
    text = "\n".join(["# How fast generated statecharts are", *lines(results, PLOT), ""])
    report.write_text(text, encoding="utf-8")
    return report


def missed(results: Results) -> list[str]:
    """The targets that are missed, a line each."""
    return [
        f"{row.what}: {row.found}, wanted {row.wanted} ({row.miss})"
        for row in rows(results)
        if row.is_met is False
    ]


def wrongs(results: Results) -> list[str]:
    """What is ours, or written by hand, and does not do what it should, a line each."""
    ours = {contender.key: contender for contender in (BY_HAND, BY_HAND_SLOTS, *OURS)}
    return [
        f"{ours[key].title}, {BEHAVIOURS[behaviour].title}: {reason}"
        for (behaviour, key), reason in results.refused.items()
        if key in ours and not is_left_out(reason)
    ]


def is_left_out(reason: str) -> bool:
    """Whether a contender has not failed, but does not take part."""
    return reason.startswith("NotImplementedError")


def into_page(results: Results, page: Path) -> None:
    """Put the figures between the two marks of a page, and the plot among its pictures.

    Raises:
        ValueError: the page has no such marks.
    """
    text = page.read_text("utf-8")
    head, begin, rest = text.partition(BEGIN)
    command, arrow, rest = rest.partition("-->")
    _, end, tail = rest.partition(END)
    if not (begin and arrow and end):
        raise ValueError(f"{page} has no place for the figures")
    picture = page.parent / "pictures" / PLOT
    picture.write_text(plot_of(results), encoding="utf-8")
    found = "\n".join(lines(results, f"pictures/{PLOT}")).replace("\n## ", "\n### ")
    page.write_text(f"{head}{begin}{command}{arrow}\n{found}\n{end}{tail}", encoding="utf-8")


def lines(results: Results, plot: str) -> Iterator[str]:
    """The report."""
    yield ""
    yield machine()
    yield "Times are CPU time of a step. A ratio is the median over rounds of the time divided by that of the"
    yield "code by hand in the same round. The middle half of the rounds lies between the ratios in brackets."
    yield ""
    yield f"![CPU time of a step, by behaviour and contender]({plot})"
    yield ""
    yield "## Targets"
    yield ""
    yield "| | found | wanted | |"
    yield "| --- | --- | --- | --- |"
    for row in rows(results):
        yield f"| {row.what} | {row.found} | {row.wanted} | {verdict(row)} |"
    yield ""
    yield "## Ours"
    yield ""
    yield from table(results, "ours", (BY_HAND, BY_HAND_SLOTS, *OURS))
    yield ""
    yield "What has a dictionary as its blackboard is for comparison only: `asemec` builds the typed one."
    yield "With ends of activities, a step is `done(label)`; `post` is for events."
    if {"around_dict", "around_slots"} <= results.figures.keys():
        in_dict, in_slots = (number(results.figures[f"around_{form}"]) for form in ("dict", "slots"))
        yield f"Of a step of the player, {in_dict} ns are the measurement and the setting of four flags,"
        yield f"with slots {in_slots} ns."
    if any(run == "peers" for run, _, _ in results.series):
        yield ""
        yield "## The peers"
        yield ""
        yield from table(results, "peers", (BY_HAND, BY_HAND_SLOTS, SEND, SEND_DICT, *PEERS))
        yield ""
        yield "\\* does something else than the reference interpreter: shown, but counted nowhere."
        yield from peers(results)
        against = list(like_for_like(results, "player"))
        if against:
            yield ""
            yield f"## How many times as long, {BEHAVIOURS['player'].title}"
            yield ""
            yield from against
    if results.memory:
        yield ""
        yield "## Many of a small machine"
        yield ""
        yield from instances(results)
    if results.loadings:
        yield ""
        yield "## Loading a compiled chart of 1 000 states"
        yield ""
        yield from loaded(results)
    constructed = list(construction(results))
    if constructed:
        yield ""
        yield "## Making a machine of 1 000 states"
        yield ""
        yield from constructed


def machine() -> str:
    """What it was measured on, without a name."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return (
        f"{platform.python_implementation()} {platform.python_version()}, {cores} cores, {platform.system()}."
    )


def verdict(row: Row) -> str:
    """Whether a target is met, if there is one."""
    if row.is_met is None:
        return ""
    return "met" if row.is_met else f"**missed**, {row.miss}"


def table(results: Results, run: Run, contenders: Sequence[Contender]) -> Iterator[str]:
    """Nanoseconds a step and the ratio to the code by hand, a line a contender."""
    behaviours = [name for name in BEHAVIOURS if any((r, b) == (run, name) for r, b, _ in results.series)]
    yield "| | " + " | ".join(BEHAVIOURS[name].title for name in behaviours) + " |"
    yield "| --- |" + " --- |" * len(behaviours)
    for contender in contenders:
        cells = [cell(results, run, name, contender.key) for name in behaviours]
        if any(item != "–" for item in cells):
            yield f"| {named(contender, results)} | " + " | ".join(cells) + " |"


def named(contender: Contender, results: Results) -> str:
    """The title, with the version of a peer."""
    version = results.versions.get(contender.key)
    return f"{contender.title} {version}" if version else contender.title


def cell(results: Results, run: Run, behaviour: str, key: str) -> str:
    """What is said of a contender with a behaviour."""
    series = results.series.get((run, behaviour, key))
    if series is None:
        return "–"
    time = (
        f"{number(series.nanoseconds)} ns"
        if series.nanoseconds < 1e4
        else f"{number(series.nanoseconds / 1e3)} µs"
    )
    if (behaviour, key) in results.differing:
        return f"{time} \\*"
    if series.ratio is None or series.spread is None or key == BY_HAND.key:
        return time
    low, high = series.spread
    return f"{time}, {number(series.ratio)} × ({number(low)}–{number(high)})"


def peers(results: Results) -> Iterator[str]:
    """Who could not take part, and what the others run on."""
    yield ""
    yield "Run on " + ", ".join(sorted(set(results.runtimes.values()))) + "."
    if results.missing:
        yield f"Not installed: {', '.join(results.missing)}."
    for behaviour, key in sorted(results.differing):
        title = next(peer.title for peer in PEERS if peer.key == key)
        reason = results.refused[behaviour, key]
        yield f"{title}, {BEHAVIOURS[behaviour].title}: its counts differ ({reason})."


def like_for_like(results: Results, behaviour: str) -> Iterator[str]:
    """How many times as long each peer takes as ours and as the code by hand, with either blackboard."""
    others = (SEND, SEND_DICT, BY_HAND_SLOTS, BY_HAND)
    rows = []
    for peer in PEERS:
        found = [ratio_between(results, "peers", behaviour, peer.key, other.key) for other in others]
        if any(found):
            cells = ["–" if ratio is None else f"{number(ratio)} ×" for ratio in found]
            rows.append(f"| {named(peer, results)} | {' | '.join(cells)} |")
    if rows:
        yield (
            "| | of the complete runtime, typed blackboard | of the complete runtime, a dictionary "
            "| of the code by hand, slots | of the code by hand, a dictionary |"
        )
        yield "| --- | --- | --- | --- | --- |"
        yield from rows


def instances(results: Results) -> Iterator[str]:
    """Memory and time of one of many, by the number of regions."""
    counts = sorted({regions for regions, _ in results.memory})
    titles = [regions_said(regions) for regions in counts]
    sizes = " | ".join(f"bytes, {title}" for title in titles)
    yield f"| | {sizes} | {' | '.join(f'µs to make and start, {title}' for title in titles)} |"
    yield "| --- |" + " --- |" * 2 * len(counts)
    for contender in (BY_HAND, BY_HAND_SLOTS, *OURS, *PEERS):
        found = [results.memory.get((regions, contender.key)) for regions in counts]
        if any(found):
            cells = ["–" if item is None else number(item[0]) for item in found]
            cells += ["–" if item is None else number(1e6 * item[1]) for item in found]
            yield f"| {named(contender, results)} | {' | '.join(cells)} |"


def loaded(results: Results) -> Iterator[str]:
    """What it costs to load what is compiled."""
    yield "| | kB | again, ms | in a new process, ms |"
    yield "| --- | --- | --- | --- |"
    for item in results.loadings:
        cells = number(item.size / 1e3), number(1e3 * item.again), number(1e3 * item.cold)
        yield f"| {item.title} | {' | '.join(cells)} |"


def construction(results: Results) -> Iterator[str]:
    """How long the largest behaviour takes until it can be sent an event."""
    if not any(("ring_1000", peer.key) in results.constructed for peer in PEERS):
        return
    yield "| | ms |"
    yield "| --- | --- |"
    for contender in (SEND, *PEERS):
        if ("ring_1000", contender.key) not in results.constructed:
            continue
        seconds = results.constructed["ring_1000", contender.key]
        yield f"| {named(contender, results)} | {number(1e3 * seconds)} |"


def figures(results: Results) -> dict[str, object]:
    """All figures, for programs."""
    return {
        "steps": [
            {
                "run": run,
                "behaviour": behaviour,
                "contender": key,
                "nanoseconds": round(series.nanoseconds, 2),
                "ratio": None if series.ratio is None else round(series.ratio, 4),
                "spread": None if series.spread is None else [round(item, 4) for item in series.spread],
                "differs": (behaviour, key) in results.differing,
            }
            for (run, behaviour, key), series in results.series.items()
        ],
        "memory": {
            f"{key}, {regions_said(regions)}": {"bytes": size, "seconds": seconds}
            for (regions, key), (size, seconds) in results.memory.items()
        },
        "loading": [asdict(item) for item in results.loadings],
        "versions": results.versions,
        "single": results.figures,
        "targets": [
            {"what": row.what, "found": row.found, "wanted": row.wanted, "met": row.is_met}
            for row in rows(results)
        ],
    }
