"""The plot: a field for each behaviour, a point for each contender, on a logarithmic axis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from html import escape

from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.peers.contenders import (
    BY_HAND,
    CORE_DICT,
    CORE_TYPED,
    NATIVE,
    PEERS,
    POST,
    SEND,
    SISMIC_UNCHECKED,
    Contender,
)
from benchmarks.peers.measuring import Results, Run, Series
from benchmarks.peers.targets import ENDS, MEASURED, number

SHOWN: tuple[tuple[Run, Contender], ...] = (
    ("ours", BY_HAND),
    ("ours", CORE_TYPED),
    ("ours", CORE_DICT),
    ("ours", SEND),
    ("ours", POST),
    ("ours", NATIVE),
    *(("peers", peer) for peer in PEERS),
)
TITLES = {name: BEHAVIOURS[name].title for name in (*MEASURED, *ENDS, "ring_100", "ring_1000")}
SHORT = {
    CORE_TYPED.key: "core, typed blackboard",
    CORE_DICT.key: "core, dictionary",
    SEND.key: "complete runtime",
    POST.key: "thread-safe post",
    NATIVE.key: "native build",
    SISMIC_UNCHECKED.key: "sismic, no contracts",
}
COLOURS = {"hand": "#444444", "ours": "#1b7f5c", "peer": "#8fa3b8"}
HALO = 'stroke="#ffffff" stroke-width="3" paint-order="stroke"'
NIGHT = (
    ("rect", "fill:#11151a"),
    ("text", "fill:#e6edf3"),
    ("text[fill]", "fill:#a3adb8"),
    ("text[stroke]", "stroke:#11151a"),
    ('[stroke="#dddddd"]', "stroke:#2b333c"),
    (f'[stroke="{COLOURS["hand"]}"]', "stroke:#c3cad1"),
    (f'[fill="{COLOURS["hand"]}"]', "fill:#c3cad1"),
    (f'[stroke="{COLOURS["ours"]}"]', "stroke:#3fbf90"),
    (f'[fill="{COLOURS["ours"]}"]', "fill:#3fbf90"),
)
"""The colours for readers who prefer dark ones."""
COLUMNS = 2
WIDTH, LABELS, BAR, ROW, HEAD, GAP = 470, 150, 215, 17, 30, 24
"""Pixels: a field, what stands left of the points, the axis, a row, the head, between fields."""


def plot_of(results: Results, titles: Mapping[str, str] = TITLES, beside: str = "by hand") -> str:
    """The picture as SVG: a field for each of the behaviours that have a title; ratios are to `beside`."""
    behaviours = [name for name in titles if any(b == name for _, b, _ in results.series)]
    timed = {(run, key) for run, _, key in results.series}
    shown = [(run, item) for run, item in SHOWN if (run, item.key) in timed]
    largest = max((series.nanoseconds for series in results.series.values()), default=1.0)
    least = min((series.nanoseconds for series in results.series.values()), default=1.0)
    low, high = math.floor(math.log10(least)), math.ceil(math.log10(largest))
    height = HEAD + ROW * len(shown) + 22
    columns = min(COLUMNS, max(1, len(behaviours)))
    total_width = max(WIDTH + 200, columns * WIDTH + (columns - 1) * GAP + 20)
    field_rows = math.ceil(len(behaviours) / columns)
    total_height = 40 + field_rows * (height + GAP)
    night = "".join(f".aseme-plot {what}{{{rule}}}" for what, rule in NIGHT)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{total_width}" height="{total_height}" '
        f'viewBox="0 0 {total_width} {total_height}" class="aseme-plot" '
        'font-family="Helvetica, sans-serif" font-size="11">',
        "<title>Time of a step, by behaviour and contender</title>",
        f"<style>@media (prefers-color-scheme:dark){{{night}}}</style>",
        f'<rect width="{total_width}" height="{total_height}" fill="#ffffff"/>',
        '<text x="10" y="22" font-size="14" font-weight="bold">CPU time of a step (logarithmic), '
        f"and how many times as long as {escape(beside)}</text>",
    ]
    for place, name in enumerate(behaviours):
        row, column = divmod(place, columns)
        x, y = 10 + column * (WIDTH + GAP), 40 + row * (height + GAP)
        parts.append(f'<g transform="translate({x},{y})">')
        parts += field(results, name, titles[name], shown, low, high)
        parts.append("</g>")
    return "\n".join([*parts, "</svg>", ""])


def field(
    results: Results, behaviour: str, title: str, shown: list[tuple[Run, Contender]], low: int, high: int
) -> Iterator[str]:
    """The points of one behaviour."""

    def length(nanoseconds: float) -> float:
        return BAR * (math.log10(nanoseconds) - low) / (high - low)

    bottom = HEAD + ROW * len(shown)
    yield f'<text x="0" y="14" font-size="12" font-weight="bold">{escape(title)}</text>'
    for power in range(low, high + 1):
        x = LABELS + length(10.0**power)
        yield f'<line x1="{x:.1f}" y1="{HEAD - 6}" x2="{x:.1f}" y2="{bottom}" stroke="#dddddd"/>'
        below = f'x="{x:.1f}" y="{bottom + 13}" text-anchor="middle"'
        yield f'<text {below} fill="#666666" font-size="10">{readable(10.0**power)}</text>'
    for place, (run, contender) in enumerate(shown):
        y = HEAD + place * ROW
        series = results.series.get((run, behaviour, contender.key))
        name = SHORT.get(contender.key, contender.title)
        yield f'<text x="{LABELS - 6}" y="{y + 10}" text-anchor="end">{escape(name)}</text>'
        if series is None:
            yield f'<text x="{LABELS + 4}" y="{y + 10}" fill="#999999">–</text>'
            continue
        differs = (behaviour, contender.key) in results.differing
        bar = max(1.0, length(series.nanoseconds))
        opacity = "0.35" if differs else "1"
        colour = f'="{COLOURS[contender.group]}" opacity="{opacity}"'
        end, middle = LABELS + bar, y + 6
        along = f'x1="{LABELS}" y1="{middle}" x2="{end:.1f}" y2="{middle}"'
        yield f'<line {along} stroke{colour} stroke-width="2"/>'
        yield f'<circle cx="{end:.1f}" cy="{middle}" r="4.5" fill{colour}/>'
        beside = escape(said(series, contender, differs))
        yield f'<text x="{end + 8:.1f}" y="{y + 10}" {HALO}>{beside}</text>'


def said(series: Series, contender: Contender, differs: bool) -> str:
    """What stands beside a point."""
    time = readable(series.nanoseconds)
    if differs:
        return f"{time} (does otherwise)"
    if series.ratio is None or contender is BY_HAND:
        return time
    return f"{time}, {number(series.ratio)} ×"


def readable(nanoseconds: float) -> str:
    """A time in the unit that fits."""
    for unit, size in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return f"{number(nanoseconds / size)} {unit}"
    return f"{number(nanoseconds)} ns"
