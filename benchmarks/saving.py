"""How fast charts are saved and loaded: `python -m benchmarks.saving [--only NAME] [--repeat N]`.

The examples are run in their worlds, the acceptance files in their scenarios. Steps of each class of charts
are taken out of these runs. Each is made again from the state before it; then the chart is saved, and loaded
with the state before. For *most* the step is given a message of every channel that the chart reads instead.

Times are in µs, the least of many: first those of saving and loading together, the mean over the steps and
the largest one. Then follow those of the steps themselves, which also copy what was saved before they change
it, and how many steps a chart makes in a second that was not saved.
"""

from __future__ import annotations

import argparse
import gc
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from aseme_dsl.runtime.chart.chart import Chart  # noqa: E402
from aseme_dsl.runtime.chart.inputs import Input, Outcome, Sample  # noqa: E402
from aseme_dsl.runtime.chart.saving import Saved  # noqa: E402
from benchmarks.models import RUNS, SCENARIOS, Made, Model, models  # noqa: E402

FIRST, TAKEN = 30, 400
"""So many steps of a class are left out at the beginning of the runs, and so many are recorded then."""

CHARTS = 20
"""So many objects are saved in a row, and then loaded: one alone is too quick for the clock."""


@dataclass(frozen=True, slots=True)
class Step:
    """A step of a run."""

    agent: str
    before: Saved
    now: int
    inputs: tuple[Input, ...]


def recorded(made: Made, part: str) -> dict[type[Chart], list[Step]]:
    """Steps of a run, by the class of the chart."""
    found: dict[type[Chart], list[Step]] = {}
    counts: dict[type[Chart], int] = {}
    usual = Chart.step

    def step(self: Chart, now: int, inputs: Iterable[Input]) -> Outcome:
        kind, given = type(self), tuple(inputs)
        counts[kind] = counts.get(kind, 0) + 1
        steps = found.setdefault(kind, [])
        if len(steps) < TAKEN and (counts[kind] > FIRST or not steps) and not self.finished:
            if counts[kind] == FIRST + 1:
                steps.clear()
            steps.append(Step(self.agent, self.save(), now, given))
        return usual(self, now, given)

    Chart.step = step  # type: ignore[method-assign]
    try:
        for _ in made.behaviours(1, part):
            pass
    finally:
        Chart.step = usual  # type: ignore[method-assign]
    return found


def together(charts: Sequence[Chart], before: Saved, after: Step, repeat: int) -> tuple[float, float, float]:
    """How long it takes to save after a step, to load what was before it, and to make it then; in µs."""
    saving = loading = stepping = sys.maxsize
    now, inputs = after.now, after.inputs
    for chart in charts:
        chart.load(before)
    for _ in range(repeat):
        begin = time.perf_counter_ns()
        for chart in charts:
            chart.step(now, inputs)
        stepped = time.perf_counter_ns()
        found = [chart.save() for chart in charts]  # as who saves keeps what was saved
        saved = time.perf_counter_ns()
        for chart in charts:
            chart.load(before)
        loaded = time.perf_counter_ns()
        stepping = min(stepping, stepped - begin)
        saving = min(saving, saved - stepped)
        loading = min(loading, loaded - saved)
        found.clear()
    each = 1000 * len(charts)
    return saving / each, loading / each, stepping / each


def everything(kind: type[Chart], step: Step) -> Step:
    """The same step with a message of every channel, of an agent that has sent nothing else."""
    samples = [
        Sample(info.name, kind_of(kind, info.message)(), "another", step.now, ("another", number))
        for number, info in enumerate(kind.PLAN.channels)
        if info.name in kind.READERS
    ]
    return Step(step.agent, step.before, step.now, tuple(samples))


def kind_of(kind: type[Chart], message: str) -> type:
    """The class of a message that a chart knows."""
    (own,) = (item.__module__ for item in kind.__mro__ if "REGIONS" in vars(item) and item.REGIONS)
    package = own.rsplit(".", 2)[0]
    return getattr(sys.modules[f"{package}.messages"], message)  # type: ignore[no-any-return]


def steps_a_second(kind: type[Chart], steps: Sequence[Step], repeat: int) -> float:
    """How many steps are made in a second by a chart that is not saved."""
    agent = steps[0].agent
    given = [(step.now, step.inputs) for step in steps if step.agent == agent]
    best = sys.maxsize
    for _ in range(repeat):
        chart = kind(agent)
        chart.load(steps[0].before)
        begin = time.perf_counter_ns()
        for now, inputs in given:
            chart.step(now, inputs)
        best = min(best, time.perf_counter_ns() - begin)
    return len(given) * 1e9 / best


def rows(model: Model, repeat: int) -> Iterator[str]:
    """A line for each class of charts of a model."""
    with TemporaryDirectory(prefix="saving-") as folder:
        made = Made.of(model, {}, Path(folder))
        assert made is not None
        for kind, steps in recorded(made, RUNS if made.is_run() else SCENARIOS).items():
            apart: list[tuple[float, float, float]] = []
            most: list[tuple[float, float, float]] = []
            for step in steps[:: max(1, len(steps) // 12)]:
                charts = [kind(step.agent) for _ in range(CHARTS)]
                apart.append(together(charts, step.before, step, repeat))
                most.append(together(charts, step.before, everything(kind, step), repeat))
            times = [
                figure
                for found in (apart, most)
                for both in [[saving + loading for saving, loading, _ in found]]
                for figure in (mean(both), max(both))
            ]
            times += [mean([step for _, _, step in found]) for found in (apart, most)]
            shown = " | ".join(f"{time:.2f}" for time in times)
            sizes = f"{len(kind.REGIONS)} | {len(kind.places)}"
            speed = steps_a_second(kind, steps, repeat)
            yield f"| {model.name} | {kind.__name__} | {sizes} | {shown} | {speed:.0f} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", metavar="NAME", help="only models whose name contains NAME")
    parser.add_argument("--repeat", type=int, default=60)
    options = parser.parse_args()
    columns = (
        "model",
        "class",
        "regions",
        "places",
        "apart",
        "largest",
        "most",
        "largest",
        "step",
        "its most",
    )
    print(f"| {' | '.join(columns)} | steps/s |")
    print("| --- | --- |" + " ---: |" * 9)
    gc.disable()
    for model in models():
        if options.only is None or options.only in model.name:
            for row in rows(model, options.repeat):
                print(row, flush=True)
            gc.collect()


if __name__ == "__main__":
    main()
