"""The metrics of runs in words, for people, and as data, for programs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from statistics import fmean, median

from aseme_dsl.amola.system import System
from aseme_dsl.play.metrics import RunMetrics, Times, state_title
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import shown

Cell = str | int


@dataclass(frozen=True, slots=True)
class Row:
    """What was measured of one thing: in each run how often it began, and how long it lasted in all (ns)."""

    kind: str
    of: str
    name: str
    label: str
    times: tuple[int, ...]
    totals: tuple[int, ...]
    lasted: tuple[int, ...]
    """How long it lasted each time, in all runs."""
    open: int

    @property
    def title(self) -> str:
        """Its name, behind that of its role where it has one."""
        return f"{self.of}: {self.name}" if self.of else self.name


def rows(system: System, runs: Sequence[RunMetrics]) -> list[Row]:
    """A row for each state, goal and protocol that occurred in some run."""
    charts = {chart.name: chart for chart in system.iacs}
    places = [
        (chart.name, state.label)
        for chart in system.iacs
        for state in chart.states
        if any((chart.name, state.label) in run.states for run in runs)
    ]
    found = [
        _row("state", place[0], state_title(charts, place), place[1], [run.states.get(place) for run in runs])
        for place in places
    ]
    for goal in system.sag.goals:
        found.append(_row("goal", "", goal.name, "", [run.goals.get(goal.name) for run in runs]))
    for name in dict.fromkeys(name for run in runs for name in run.protocols):
        found.append(_row("protocol", "", name, "", [run.protocols.get(name) for run in runs]))
    return found


def _row(kind: str, of: str, name: str, label: str, found: Iterable[Times | None]) -> Row:
    measured = [Times() if item is None else item for item in found]
    return Row(
        kind,
        of,
        name,
        label,
        tuple(item.began for item in measured),
        tuple(item.total for item in measured),
        tuple(lasted for item in measured for lasted in item.lasted),
        sum(item.open for item in measured),
    )


def lines(system: System, runs: Sequence[RunMetrics]) -> Iterator[str]:
    """Tables of states, goals, protocols, and how parts and activities ended."""
    said = f"{len(runs)} run" if len(runs) == 1 else f"{len(runs)} runs"
    yield f"metrics of {system.name}: {said}, {shown(sum(run.end for run in runs))}"
    found = rows(system, runs)
    for kind in ("state", "goal", "protocol"):
        table = [_cells(row, runs) for row in found if row.kind == kind]
        yield from _table((kind, *_HEAD), table)
    messages = {name for run in runs for name in run.messages}
    yield from _table(
        ("protocol", "messages"),
        [(name, _some([run.messages[name] for run in runs], _whole)) for name in sorted(messages)],
    )
    parts = sorted({(protocol, participant) for run in runs for protocol, participant, _ in run.parts})
    yield from _table(
        ("protocol", "participant", "completed", "left", "open"),
        [
            (
                protocol,
                participant,
                *(
                    _some([run.parts[protocol, participant, how] for run in runs], _whole)
                    for how in ("completed", "left", "open")
                ),
            )
            for protocol, participant in parts
        ],
    )
    outcomes = sorted({key for run in runs for key in run.outcomes})
    yield from _table(
        ("activity", "outcome", "times"),
        [(*key, _some([run.outcomes[key] for run in runs], _whole)) for key in outcomes],
    )


_HEAD = ("times", "time", "share", "shortest", "median", "longest")


def _cells(row: Row, runs: Sequence[RunMetrics]) -> tuple[str, ...]:
    whole = sum(run.end * (run.agents[row.of] if row.of else 1) for run in runs)
    share = f"{sum(row.totals) / whole:.0%}" if whole else "-"
    lasted = (min(row.lasted), int(median(row.lasted)), max(row.lasted)) if row.lasted else ()
    return (
        row.title if len(row.title) <= 50 else f"{row.title[:49]}…",
        _some(row.times, _whole),
        _some(row.totals, _seconds),
        share,
        *(_seconds(item) for item in lasted),
    )


def _some(values: Sequence[int], text: Callable[[float], str]) -> str:
    """One value, or of several runs the mean with the least and the greatest."""
    least, most = min(values), max(values)
    if least == most:
        return text(least)
    return f"{text(fmean(values))} ({text(least)} to {text(most)})"


def _whole(value: float) -> str:
    return f"{value:g}" if value == int(value) else f"{value:.1f}"


def _seconds(nanoseconds: float) -> str:
    return f"{nanoseconds / 1e9:.3f} s"


def _table(head: Sequence[str], table: Sequence[Sequence[str]]) -> Iterator[str]:
    """A table with its head, after a blank line; nothing, if it has no rows. The first column stands left."""
    if not table:
        return
    yield ""
    whole = [tuple(head), *(tuple(row) + ("",) * (len(head) - len(row)) for row in table)]
    widths = [max(len(row[column]) for row in whole) for column in range(len(head))]
    for row in whole:
        cells = [
            cell.ljust(width) if column == 0 or head[column] in _LEFT else cell.rjust(width)
            for column, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        yield "  ".join(cells).rstrip()


_LEFT = ("participant", "outcome")


def data(system: System, runs: Sequence[RunMetrics]) -> dict[str, object]:
    """The metrics for programs: all values, run by run; times are in ns."""
    return {
        "system": system.name,
        "runs": [{"seed": run.seed, "time_ns": run.end} for run in runs],
        "rows": [
            {
                "kind": row.kind,
                "of": row.of,
                "name": row.name,
                "label": row.label,
                "times": list(row.times),
                "totals_ns": list(row.totals),
                "lasted_ns": list(row.lasted),
                "open": row.open,
            }
            for row in rows(system, runs)
        ],
        "messages": {
            name: [run.messages[name] for run in runs]
            for name in sorted({name for run in runs for name in run.messages})
        },
        "parts": [
            {
                "protocol": protocol,
                "participant": participant,
                **{
                    how: [run.parts[protocol, participant, how] for run in runs]
                    for how in ("completed", "left", "open")
                },
            }
            for protocol, participant in sorted({key[:2] for run in runs for key in run.parts})
        ],
        "outcomes": [
            {"activity": activity, "outcome": how, "times": [run.outcomes[activity, how] for run in runs]}
            for activity, how in sorted({key for run in runs for key in run.outcomes})
        ],
    }


__all__ = ["Row", "data", "lines", "rows"]
