"""A plot of metrics: for each state, goal and protocol how often and how long it was, run by run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from html import escape
from statistics import quantiles

from aseme_dsl.project.studying.metrics_report import Row

_NAMES, _PANEL, _GAP, _HEIGHT, _TOP = 300, 300, 60, 26, 56
_STYLE = """\
.aseme-metrics{--paper:#ffffff;--ink:#1b1f24;--soft:#57606a;--edge:#d0d7de;--mark:#0b5cad;--box:#cfe3f7}
@media (prefers-color-scheme:dark){.aseme-metrics{--paper:#11151a;--ink:#e6edf3;--soft:#a3adb8;
--edge:#30363d;--mark:#79b8ff;--box:#16304d}}
.aseme-metrics rect.paper{fill:var(--paper)}.aseme-metrics text{font:12px Arial,sans-serif;fill:var(--ink)}
.aseme-metrics text.soft{fill:var(--soft)}.aseme-metrics line{stroke:var(--edge)}
.aseme-metrics line.mark{stroke:var(--mark);stroke-width:1.5}
.aseme-metrics rect.box{fill:var(--box);stroke:var(--mark)}.aseme-metrics circle{fill:var(--mark)}
"""


def plot(title: str, found: Sequence[Row]) -> str:
    """An SVG with two panels: how often each began in a run, and how long it lasted in a run.

    Each run is a dot. A box holds the middle half of the runs, its line is their median.
    """
    width, height = _NAMES + 2 * _PANEL + 2 * _GAP, _TOP + _HEIGHT * len(found) + 20
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
        f' viewBox="0 0 {width} {height}" class="aseme-metrics" role="img">',
        f"<title>{escape(title)} - asemec metrics</title><style>{_STYLE}</style>",
        f'<rect class="paper" width="{width}" height="{height}"/>',
        f'<text x="10" y="20" font-weight="bold">{escape(title)}</text>',
    ]
    for number, row in enumerate(found):
        y = _TOP + _HEIGHT * number + _HEIGHT // 2
        name = row.title if len(row.title) <= 44 else f"{row.title[:43]}…"
        tip = f"<title>{escape(row.title)}</title>"
        parts.append(f'<text x="{_NAMES - 10}" y="{y + 4}" text-anchor="end">{tip}{escape(name)}</text>')
    parts += _panel(_NAMES, "times a run", [row.times for row in found], lambda value: f"{value:g}")
    seconds = [[total / 1e9 for total in row.totals] for row in found]
    parts += _panel(_NAMES + _PANEL + _GAP, "seconds a run", seconds, lambda value: f"{value:g}")
    return "\n".join([*parts, "</svg>", ""])


def _panel(
    left: int, title: str, found: Sequence[Sequence[float]], text: Callable[[float], str]
) -> Iterator[str]:
    most = max((value for values in found for value in values), default=0)
    step = _step(most)
    last = max(1, -(-most // step)) * step
    yield f'<text class="soft" x="{left}" y="{_TOP - 34 + 14}">{title}</text>'
    bottom = _TOP + _HEIGHT * len(found)
    for number in range(round(last / step) + 1):
        x = left + _PANEL * number * step / last
        yield f'<line x1="{x:.1f}" y1="{_TOP}" x2="{x:.1f}" y2="{bottom}"/>'
        place = f'x="{x:.1f}" y="{bottom + 15}"'
        yield f'<text class="soft" {place} text-anchor="middle">{text(number * step)}</text>'
    for number, values in enumerate(found):
        y = _TOP + _HEIGHT * number + _HEIGHT / 2
        yield from _box([left + _PANEL * value / last for value in values], y)


def _step(most: float) -> float:
    """The distance of grid lines: at most six of them, 1, 2 or 5 with zeros."""
    size = 1e-9
    while size * 50 < most:
        size *= 10
    return next(size * factor for factor in (1, 2, 5, 10) if size * factor * 5 >= most)


def _box(places: Sequence[float], y: float) -> Iterator[str]:
    if len(places) > 1:
        low, middle, high = quantiles(places, n=4, method="inclusive")
        yield f'<line class="mark" x1="{min(places):.1f}" y1="{y:.1f}" x2="{max(places):.1f}" y2="{y:.1f}"/>'
        yield (
            f'<rect class="box" x="{low:.1f}" y="{y - 6:.1f}" width="{high - low:.1f}" height="12"/>'
            f'<line class="mark" x1="{middle:.1f}" y1="{y - 6:.1f}" x2="{middle:.1f}" y2="{y + 6:.1f}"/>'
        )
    for x in places:
        yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill-opacity="0.6"/>'


__all__ = ["plot"]
