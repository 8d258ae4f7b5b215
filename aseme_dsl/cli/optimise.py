"""`asemec optimise`: compare team sizes and settings by many runs in virtual time."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import duration_option, network_of, network_option
from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    WRONG_USE,
    activities_option,
    check_outputs,
    cluster_option,
    colour_option,
    crew_of,
    diagnostics_json,
    folder_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    refuse,
    target_argument,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.diagnostics.problems.writing import InTheWay, Obstacle

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.project.files.outputs import Kind
    from aseme_dsl.project.studying.study_report import Study
    from aseme_dsl.project.studying.variation import Knob


def _knobs(context: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> tuple[Knob, ...]:
    from aseme_dsl.project.studying.variation import VariationError, knob

    try:
        knobs = tuple(knob(value) for value in values)
    except VariationError as problem:
        raise click.BadParameter(f"{problem}.") from problem
    names = [item.name for item in knobs]
    if len(set(names)) < len(names):
        double = next(name for name in names if names.count(name) > 1)
        raise click.BadParameter(f"{double} is given twice.")
    return knobs


@click.command(
    short_help="Compare team sizes and settings; find bottlenecks.",
    help="Run a team in virtual time with different numbers of agents or settings, compare the variants, and"
    " find the bottleneck activity. All variants run with the same seeds. The report, its data and its plots"
    f" are written to the output directory. {TARGET_HELP}",
    epilog="Example: asemec optimise warehouse.aseme --vary carrier=1..8 --measure Deliver --runs 20",
)
@target_argument
@click.option(
    "--vary",
    "knobs",
    multiple=True,
    callback=_knobs,
    metavar="NAME=VALUES",
    help="Parameter and its values: an agent range (carrier=1..8) or a variable (keeper.limit=60,80)."
    " Repeat for all combinations.",
)
@click.option(
    "--measure",
    metavar="WHAT",
    help="Measure (required): ACTIVITY (completions per minute), `time` (seconds until all agents complete),"
    " or MODULE:FUNCTION (a number computed from the world at the end).",
)
@click.option("--minimise", is_flag=True, help="Prefer lower values (always so for `time`).")
@click.option(
    "--runs",
    type=click.IntRange(1, 100_000),
    default=20,
    show_default=True,
    help="Runs per variant, each with its own seed.",
)
@click.option("--seed", type=int, default=1, show_default=True, help="First seed.")
@duration_option("Time limit of each run.  [default: the project's, else 60s]", may_be_zero=False)
@click.option(
    "--worth",
    type=click.FloatRange(0, min_open=False),
    default=5.0,
    show_default=True,
    metavar="PERCENT",
    help="Minimum gain (percent) to accept the next team size.",
)
@click.option(
    "--quicker",
    type=click.FloatRange(1, 1000),
    default=2.0,
    show_default=True,
    metavar="TIMES",
    help="Speed-up factor for the bottleneck search; 1 disables it.",
)
@click.option(
    "-j",
    "--jobs",
    type=click.IntRange(1),
    help="Parallel runs.  [default: the number of cores]",
)
@cluster_option
@click.option("--world", metavar="MODULE:FUNCTION", help="Factory function of the simulated world.")
@network_option(
    "Simulated network, such as delay=0..300ms,loss=10%,reorder.  [default: the project's, else no delay]"
)
@folder_option(
    "-o", "--output", text="Directory of the report.  [default: `optimise` in the project's output directory]"
)
@activities_option
@click.option("-q", "--quiet", is_flag=True, help="Suppress progress output.")
@json_option
@colour_option
def command(
    target: str,
    knobs: tuple[Knob, ...],
    measure: str | None,
    minimise: bool,
    runs: int,
    seed: int,
    duration: int | None,
    worth: float,
    quicker: float,
    jobs: int | None,
    cluster: str | None,
    world: str | None,
    network_words: str | None,
    output: Path | None,
    activities: Path | None,
    quiet: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Run and report; 1 if the file has errors or cannot be run so."""
    from aseme_dsl.cli.playing import is_function
    from aseme_dsl.diagnostics import Severity
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.settings.configuration import OUTPUT
    from aseme_dsl.project.spreading.cluster import ClusterError
    from aseme_dsl.project.studying.optimise import Question, optimise
    from aseme_dsl.project.studying.study import TIME, Plan, StudyError
    from aseme_dsl.project.studying.variation import VariationError

    if measure is not None and ":" in measure and not is_function(measure):
        raise click.BadParameter(
            f"{measure!r} does not have the form MODULE:FUNCTION.", param_hint="'--measure'"
        )
    crew = crew_of(jobs, cluster)
    network, wrong = network_of(network_words)
    if wrong:
        refuse(wrong, as_json, colour)
        return WRONG_USE
    compiled = one_system(target, activities)
    found = tuple(item for item in compiled.diagnostics if item.severity is not Severity.NOTE)
    if compiled.system is None or has_errors(found):
        return refuse(found, as_json, colour)
    if measure is None:
        raise click.UsageError(_measures(compiled.system))
    if not as_json:
        print_diagnostics(found, colour)
    configuration = compiled.configuration
    home = configuration.output or Path(OUTPUT)
    choice = choose(configuration, activities=activities)
    length = duration or configuration.length
    plan = Plan(measure, length, world, activities_folder(home, choice), configuration, network)
    question = Question(
        knobs,
        tuple(range(seed, seed + runs)),
        minimise or measure == TIME,
        worth / 100,
        quicker,
        min(crew, runs) if isinstance(crew, int) else crew,
    )
    folder = output or home / "optimise"
    check_outputs([(folder / name, kind) for name, kind in _FILES.items()], [target, *compiled.depends])
    in_the_way = _in_the_way(folder)
    if in_the_way:
        return refuse(in_the_way, as_json, colour)
    progress = Progress(quiet or as_json)
    counted = _Counted(progress)
    try:
        study = optimise(compiled.system, question, plan, choice, total=counted.total, told=counted.told)
    except (ClusterError, StudyError, VariationError) as problem:
        if as_json:
            print_json({"result": None, "problem": str(problem), **diagnostics_json(())})
        raise click.ClickException(f"{problem}{'' if str(problem).endswith('?') else '.'}") from problem
    finally:
        progress.end()
    return _leave(study, folder, as_json, colour)


_FILES: Mapping[str, Kind] = {
    "report.md": "study",
    "report.json": "study",
    "measure.svg": "plot",
    "bottleneck.svg": "plot",
}
"""What is left in the folder."""


def _in_the_way(folder: Path) -> tuple[Diagnostic, ...]:
    """Why nothing can be written there, as far as that is known before all is played."""
    from aseme_dsl.project.files.write import check_room

    around = (folder, *folder.absolute().parents)
    there = next(place for place in around if os.path.exists(place))  # noqa: PTH110  raises nothing
    if not there.is_dir():
        obstacle = Obstacle.FILE_ABOVE if there != folder else Obstacle.FILE_INSTEAD
    elif not os.access(there, os.W_OK | os.X_OK):
        obstacle = Obstacle.READ_ONLY_ABOVE if there != folder else Obstacle.READ_ONLY_ITSELF
    else:
        return tuple(problem for name in _FILES for problem in check_room(folder / name))[:1]
    return (Diagnostic(InTheWay(str(folder), obstacle), None, path=str(folder)),)


def _measures(system: System) -> str:
    """The error text for a missing `--measure`: it lists the possible measures."""
    from aseme_dsl.project.studying.optimise import activities_of

    names = ", ".join(activities_of(system))
    lines = [
        "Missing option '--measure'. Choose one of",
        *([f"an activity (completions per minute): {names};"] if names else []),
        "time (seconds until all agents complete);",
        "MODULE:FUNCTION (a number computed from the world at the end).",
    ]
    return "\n  ".join(lines)


class _Counted:
    """How many of the runs are done."""

    def __init__(self, progress: Progress) -> None:
        self._progress = progress
        self._of = 0
        self._done = 0

    def total(self, runs: int) -> None:
        self._of = runs

    def told(self) -> None:
        self._done += 1
        self._progress.say(f"{self._done} of {self._of} runs")


def _leave(study: Study, folder: Path, as_json: bool, colour: str) -> int:
    """Write the report, its data and its plots, and print it; the exit code."""
    import json

    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.studying.findings import is_measured
    from aseme_dsl.project.studying.plots import PlotsMissing, gains_plot, measure_plot
    from aseme_dsl.project.studying.study_report import as_json as data_of
    from aseme_dsl.project.studying.study_report import markdown

    text, data = markdown(study), data_of(study)
    measured = is_measured(study.rows)
    files = {"report.md": text.encode(), "report.json": (json.dumps(data, indent=2) + "\n").encode()}
    missing = ""
    try:
        if study.knobs and measured:
            files["measure.svg"] = measure_plot(
                study.knobs, study.rows, study.what, study.chosen, "worth it" if study.counts else "best"
            )
        if study.slowest:
            files["bottleneck.svg"] = gains_plot(study.slowest, study.times, study.what)
    except PlotsMissing as problem:
        missing = str(problem)
    problems: tuple[Diagnostic, ...] = ()
    left: list[str] = []
    for name, content in sorted(files.items()):
        problems = write_file(folder / name, content).diagnostics
        if has_errors(problems):
            break
        left.append(name)
    else:
        for name in _FILES.keys() - files.keys():  # of an earlier question
            if (folder / name).is_file():
                (folder / name).unlink()
    if as_json:
        result: dict[str, object] = {**data, "folder": str(folder), "files": left}
        print_json({"result": result, **diagnostics_json(problems)})
    else:
        click.echo(text)
        if left:
            click.echo(f"{', '.join(left)} -> {folder}")
        print_diagnostics(problems, colour)
    if missing:
        click.echo(missing, err=True)
    return 1 if has_errors(problems) or not measured else 0
