"""The report on a file of anybody's: Markdown, a plot and the figures as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

from aseme_dsl.project.studying.table import table
from benchmarks.peers.contenders import CORE_TYPED, PEERS, POST, SEND
from benchmarks.peers.measuring import Results
from benchmarks.peers.own import Found, Role
from benchmarks.peers.plot import plot_of, readable
from benchmarks.peers.report import machine
from benchmarks.peers.targets import number

CONTENDERS = (CORE_TYPED, SEND, POST, *PEERS)
BESIDE = "the complete runtime"


def written(found: Found, into: Path) -> Path:
    """Write the report, its plot and the figures; return the path of the report."""
    into.mkdir(parents=True, exist_ok=True)
    stem = found.system.lower()
    results = Results()
    titles: dict[str, str] = {}
    for role in found.roles:
        titles[role.name] = f"{found.system}, {role.name}"
        for contender in CONTENDERS:
            if contender.key in role.series:
                run = "peers" if contender.group == "peer" else "ours"
                results.series[run, role.name, contender.key] = role.series[contender.key]  # type: ignore[index]
    if results.series:
        (into / f"{stem}.svg").write_text(plot_of(results, titles, BESIDE), encoding="utf-8")
    (into / f"{stem}.json").write_text(json.dumps(asdict(found), indent=1) + "\n", encoding="utf-8")
    report = into / f"{stem}.md"
    text = "\n".join(lines(found, f"{stem}.svg" if results.series else ""))
    report.write_text(f"{text}\n", encoding="utf-8")
    return report


def lines(found: Found, plot: str) -> Iterator[str]:
    """The report."""
    yield f"# {found.system} beside its peers"
    yield ""
    yield machine()
    yield f"Inputs: {found.origin}; one event or end of an activity a step. Times are CPU time of a step."
    yield f"A ratio is the median over rounds of the time divided by that of {BESIDE} in the same round."
    yield "Only libraries that enter and leave every state as often as the reference interpreter are timed."
    if plot:
        yield ""
        yield f"![CPU time of a step, by role and contender]({plot})"
    for role in found.roles:
        yield ""
        yield f"## {role.name}"
        yield ""
        yield from _role(role, found)


def _role(role: Role, found: Found) -> Iterator[str]:
    if role.refused:
        yield f"Not compared: {role.refused}."
        if role.places:
            yield ""
            yield "```text"
            yield role.places.rstrip()
            yield "```"
        return
    steps = f"{role.steps} steps{f' of {role.agent}' if role.agent else ''}"
    yield f"{role.states} states, {role.transitions} transitions, {steps}."
    yield ""
    rows = []
    for contender in CONTENDERS:
        series = role.series.get(contender.key)
        if series is not None:
            title = " ".join(filter(None, (contender.title, found.versions.get(contender.key, ""))))
            ratio = number(series.ratio) if series.ratio is not None else ""
            rows.append((title, readable(series.nanoseconds), ratio))
    yield from table(("", "a step", "times as long"), rows, 1)
    if role.left_out:
        yield ""
    for contender in CONTENDERS:
        if contender.key in role.left_out:
            yield f"- {contender.title} is left out: {role.left_out[contender.key]}."
