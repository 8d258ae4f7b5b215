"""Plots as SVG: of a study, what was measured over what was varied; of a bench, what steps cost."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from aseme_dsl.project.studying.bench import Timed
from aseme_dsl.project.studying.findings import Row, Slower
from aseme_dsl.project.studying.variation import Knob

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.typing import RcKeyType

_SETTINGS: dict[RcKeyType, object] = {
    "svg.hashsalt": "aseme-dsl",  # the same study gives the same bytes
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "axes.axisbelow": True,
}
_DARK = b""" <style type="text/css">
@media (prefers-color-scheme:dark){svg{filter:invert(.93) hue-rotate(180deg)}}
 </style>
"""
"""In the dark all colours are turned round, but for their hues."""
_BLUE, _GREY, _RED = "#2a6fb0", "#9a9a9a", "#b0402a"


class PlotsMissing(Exception):
    """matplotlib, which draws, is not installed."""


def measure_plot(
    knobs: Sequence[Knob], found: Sequence[Row], what: str, chosen: Row | None, chosen_as: str
) -> bytes:
    """The measure with its intervals, a line for each combination of all parameters but the last.

    Combinations that gave the same are one line. What is chosen has a ring, called `chosen_as`.

    Raises:
        PlotsMissing: there is nothing to draw with.
    """
    figure, axes = _figure()
    last = knobs[-1]
    places = _places(last)
    for number, (points, names) in enumerate(_lines(knobs, found, places).items()):
        line, marker = _LINES[number % len(_LINES)], _MARKERS[number % len(_MARKERS)]
        known = [x for x, *_ in points]
        colour = f"C{number}" if len(knobs) > 1 else _BLUE
        label = _some(names) or None
        axes.plot(known, [mean for _, mean, *_ in points], line, marker=marker, label=label, color=colour)
        axes.fill_between(
            known,
            [low for _, _, low, _ in points],
            [high for *_, high in points],
            alpha=0.2,
            color=colour,
            linewidth=0,
        )
    seen = [(places[row.variant[-1][1]], row.measure.mean, row) for row in found if row.measure is not None]
    least = [(x, mean) for x, mean, row in seen if row.unfinished]
    if least:
        axes.plot(
            *zip(*least, strict=True),
            linestyle="",
            color="white",
            markeredgecolor="#444444",
            marker="^",
            markersize=9,
            label="at least: not all runs finished",
        )
    if chosen is not None and chosen.measure is not None:
        axes.plot(
            [places[chosen.variant[-1][1]]],
            [chosen.measure.mean],
            marker="o",
            markersize=13,
            fillstyle="none",
            color=_RED,
            linestyle="",
            label=chosen_as,
        )
    if any(row.measure is not None and row.measure.low < row.measure.high for row in found):
        axes.fill_between([], [], [], color=_GREY, alpha=0.4, linewidth=0, label="95 %")
    axes.set_xticks(list(places.values()), list(places))
    axes.set_xlabel(last.name if not last.counts else f"agents of {last.name}")
    axes.set_ylabel(what)
    if all(run.measure is None or run.measure >= 0 for row in found for run in row.runs):
        axes.set_ylim(bottom=0)
    labels = axes.get_legend_handles_labels()[1]
    if labels:
        longest = max(map(len, labels))
        figure.legend(loc="outside upper left", ncols=max(1, min(4, 80 // (longest + 8))), frameon=False)
    return _svg(figure)


_LINES = ("-", "--", "-.", ":")
_MARKERS = ("o", "s", "D", "v", "P", "X")
_MOST_NAMED = 3


def _some(names: Sequence[str]) -> str:
    more = len(names) - _MOST_NAMED
    return "; ".join(names) if more <= 0 else f"{'; '.join(names[:_MOST_NAMED])} and {more} more"


_Point = tuple[float, float, float, float]


def _lines(
    knobs: Sequence[Knob], found: Sequence[Row], places: Mapping[str, float]
) -> dict[tuple[_Point, ...], list[str]]:
    """The points of each line, with the interval, from left to right; and what it is of."""
    points: dict[tuple[str, ...], list[_Point]] = {}
    for row in found:
        line = points.setdefault(tuple(value for _, value in row.variant[:-1]), [])
        if row.measure is not None:
            x, item = places[row.variant[-1][1]], row.measure
            line.append((x, item.mean, item.low, item.high))
    lines: dict[tuple[_Point, ...], list[str]] = {}
    for key, seen in points.items():
        label = ", ".join(f"{knob.name} = {value}" for knob, value in zip(knobs, key, strict=False))
        lines.setdefault(tuple(sorted(seen)), []).extend([label] if label else [])
    return lines


def gains_plot(found: Sequence[Slower], times: float, what: str) -> bytes:
    """A bar for each activity, with its interval: what it would gain if it were so many times quicker.

    Raises:
        PlotsMissing: there is nothing to draw with.
    """
    figure, axes = _figure(height=1.5 + 0.35 * len(found))
    names = [item.activity for item in found]
    places = range(len(found))
    colours = [_RED if item.is_bottleneck else _BLUE for item in found]
    bars = axes.barh(places, [100 * item.gain.mean for item in found], color=colours, height=0.6)
    slowest = [bar for bar, item in zip(bars, found, strict=True) if item.is_bottleneck]
    called = "the bottleneck" if len(slowest) == 1 else "one of these is the bottleneck"
    legend: dict[str, Artist] = {called: slowest[0]} if slowest else {}
    for place, item in enumerate(found):
        if item.gain.low < item.gain.high:
            ends = [100 * item.gain.low, 100 * item.gain.high]
            (legend["95 %"],) = axes.plot(ends, [place, place], color=_GREY, linewidth=2)
    axes.set_yticks(list(places), names)
    axes.invert_yaxis()
    axes.axvline(0, color="#444444", linewidth=0.8)
    axes.set_xlabel(f"gain of {what} in %, if it were {times:g} times as quick")
    if legend:
        figure.legend(list(legend.values()), list(legend), loc="outside upper left", ncols=2, frameon=False)
    return _svg(figure)


def costs_plot(found: Mapping[str, Mapping[str, Timed]]) -> bytes:
    """Two points for each way to run a role, on a logarithmic axis: a step, and one without an input.

    Raises:
        PlotsMissing: there is nothing to draw with.
    """
    rows = [(role, way, timed) for role, ways in found.items() for way, timed in ways.items()]
    figure, axes = _figure(height=1.3 + 0.3 * len(rows))
    from matplotlib.ticker import LogLocator

    places = range(len(rows))
    axes.hlines(
        places, [item.idle for _, _, item in rows], [item.step for _, _, item in rows], color="#cccccc"
    )
    for colour, label, times in (
        (_GREY, "idle tick", [timed.idle for _, _, timed in rows]),
        (_BLUE, "step with its inputs", [timed.step for _, _, timed in rows]),
    ):
        axes.plot(times, places, marker="o", linestyle="", color=colour, label=label)
        for time, place in zip(times, places, strict=True):
            is_least = time == min(rows[place][2].idle, rows[place][2].step)
            axes.annotate(
                _duration(time),
                (time, place),
                ha="right" if is_least else "left",
                fontsize=8,
                xytext=(-7 if is_least else 7, 0),
                textcoords="offset points",
                va="center",
            )
    axes.set_yticks(places, [f"{role}, {way}" for role, way, _ in rows])
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")
    axes.set_xscale("log")
    axes.margins(x=0.18)
    low, high = axes.get_xlim()
    if high < 100 * low:
        axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(lambda value, _: _duration(value))
    axes.xaxis.set_minor_formatter("")
    axes.set_xlabel("CPU time (logarithmic)")
    figure.legend(loc="outside upper left", ncols=2, frameon=False)
    return _svg(figure, "asemec bench")


def _duration(nanoseconds: float) -> str:
    """A time in the unit that fits."""
    for unit, size in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def _places(knob: Knob) -> dict[str, float]:
    """Where a value stands: numbers at their place, others one after the other."""
    try:
        return {value: float(value) for value in knob.values}
    except ValueError:
        return {value: float(place) for place, value in enumerate(knob.values)}


def _figure(height: float = 4.0) -> tuple[Figure, Axes]:
    try:
        from matplotlib import rc_context
        from matplotlib.figure import Figure
    except ImportError as missing:
        raise PlotsMissing("plots need matplotlib: pip install 'aseme-dsl[plot]'") from missing
    with rc_context(_SETTINGS):
        figure = Figure(figsize=(6.4, height), layout="constrained")
        return figure, figure.subplots()


def _svg(figure: Figure, creator: str = "asemec optimise") -> bytes:
    from matplotlib import rc_context

    out = io.BytesIO()
    with rc_context(_SETTINGS):
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": creator})
    head, tag, rest = out.getvalue().partition(b" <defs>")
    return head + _DARK + tag + rest
