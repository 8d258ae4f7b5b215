"""How long compact drawings of statecharts take, and how that grows.

Run by hand: `python3 dev.py long`, or `python benchmarks/compact.py`. It draws and checks the player of
`examples/robocup`, and made charts of about 250, 500, 1000 and 2000 states: regions, a long line, choices.
Times are CPU time, the least of a few runs. They stand beside the time that the compiler takes for the same
file, and beside a chart of half the size: twice the states may take little more than twice the time.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeVar

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

import aseme_dsl  # noqa: E402
from aseme_dsl.amola.statechart import Statechart  # noqa: E402
from aseme_dsl.diagrams.compact.check import faults  # noqa: E402
from aseme_dsl.diagrams.compact.layout import layout  # noqa: E402
from aseme_dsl.source import Source  # noqa: E402

RUNS = 5
SIZES = (250, 500, 1000, 2000)
_T = TypeVar("_T")


def regions(states: int) -> str:
    """Endless sequences beside each other."""
    return " || ".join(f"({' . '.join(f'R{row}A{n}' for n in range(20))})~" for row in range(states // 26))


def line(states: int) -> str:
    """One sequence, which takes many rows."""
    return " . ".join(f"A{n}" for n in range(states - 3))


def choices(states: int) -> str:
    """A sequence of choices."""
    return " . ".join(f"(A{n} | B{n} . [C{n}])" for n in range(states // 10))


SHAPES: dict[str, Callable[[int], str]] = {"regions": regions, "line": line, "choices": choices}


def timed(make: Callable[[], _T], runs: int = RUNS) -> tuple[float, _T]:
    """The least CPU time of a few runs, in ms, and what they made."""
    best = float("inf")
    for _ in range(runs):
        begun = time.process_time()
        made = make()
        best = min(best, 1000 * (time.process_time() - begun))
    return best, made


def compiled(formula: str) -> Statechart:
    """The statechart of a role with this formula."""
    text = f"system Large\nsrm robot {{ liveness {{ robot = {formula} }} }}\n"
    return aseme_dsl.compile(Source("large.aseme", text)).iacs[0]


def row(name: str, chart: Statechart, compiling: float, half: float) -> float:
    """Measure one chart and print its row; gives the time of its drawing."""
    drawing, picture = timed(lambda: layout(chart))
    checking, found = timed(lambda: faults(chart, picture))
    assert found == [], found
    whole = drawing + checking
    growth = f"{whole / half:.1f}" if half else ""
    times = f"{drawing:.1f} | {checking:.1f} | {whole / compiling:.2f} | {growth}"
    print(f"| {name} | {len(chart.states)} | {times} | {picture.width:.0f} × {picture.height:.0f} |")
    return whole


def main() -> None:
    """Measure all, and print a table."""
    print("| chart | states | drawing, ms | checking, ms | part of compiling | growth | size, px |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    example = ROOT / "examples" / "robocup" / "kouretes.aseme"
    compiling, system = timed(lambda: aseme_dsl.compile(example), 2)
    player = next(item for item in system.iacs if item.name == "player")
    row("player of robocup", player, compiling, 0)
    for name, made in SHAPES.items():
        before = 0.0
        for states in SIZES:
            compiling, chart = timed(partial(compiled, made(states)), 1)
            before = row(name, chart, compiling, before)


if __name__ == "__main__":
    main()
