"""`asemec bench`: the step time of the statecharts of a file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    check_outputs,
    colour_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    target_argument,
)
from aseme_dsl.diagnostics import closest, has_errors

if TYPE_CHECKING:
    from aseme_dsl.project.files.outputs import Kind
    from aseme_dsl.project.studying.bench import Bench


@click.command(
    short_help="Benchmark the step time of each role.",
    help="Generate the code of a system, feed inputs to each role, and measure the CPU time of a step. A"
    " role that has a plain statechart is measured in both forms. The inputs are random (--seed) or recorded"
    f" (--inputs). {TARGET_HELP}",
    epilog="Example: asemec bench team.aseme   ·   asemec bench team.aseme --role player --steps 9000 --json"
    "   ·   asemec bench team.aseme --inputs out/trace.jsonl.gz -o bench.md --plot bench.svg",
)
@target_argument
@click.option("--role", "roles", multiple=True, metavar="ROLE", help="Only this role. Repeatable.")
@click.option(
    "--inputs",
    "traces",
    multiple=True,
    metavar="TRACE",
    type=FilePath(path_type=Path),
    help="Replay the inputs recorded in TRACE. Repeatable.",
)
@click.option(
    "--steps",
    type=click.IntRange(1),
    help="Number of inputs per role.  [default: 2000; all recorded ones with --inputs]",
)
@click.option(
    "--rounds",
    type=click.IntRange(1),
    default=7,
    show_default=True,
    help="Timed repetitions; the median counts.",
)
@click.option("--seed", type=int, help="Seed for generated inputs.  [default: 1]")
@click.option(
    "-o",
    "--output",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Report file (Markdown).  [default: standard output]",
)
@click.option("--plot", type=FilePath(path_type=Path), metavar="FILE.svg", help="Plot file (SVG).")
@json_option
@colour_option
def command(
    target: str,
    roles: tuple[str, ...],
    traces: tuple[Path, ...],
    steps: int | None,
    rounds: int,
    seed: int | None,
    output: Path | None,
    plot: Path | None,
    as_json: bool,
    colour: str,
) -> int:
    """Print the report in Markdown; 1 if the file has errors, or two ways to run a role do not agree."""
    from tempfile import TemporaryDirectory

    from aseme_dsl.project.files.write import check_room

    if traces and seed is not None:
        raise click.UsageError("--seed generates inputs, --inputs replays recorded ones: choose one.")
    if plot is not None and plot.suffix != ".svg":
        raise click.BadParameter("the plot file must end in .svg.", param_hint="'--plot'")
    for number, trace in enumerate(traces):
        if os.path.realpath(trace) in map(os.path.realpath, traces[:number]):
            raise click.UsageError(f"{trace} is given twice.")
    compiled = one_system(target)
    if compiled.system is None or has_errors(compiled.diagnostics):
        print_diagnostics(compiled.diagnostics, colour)
        return 1
    known = [chart.name for chart in compiled.system.iacs]
    for role in roles:
        if role not in known:
            near = closest(role, known)
            hint = f"Did you mean {near!r}?" if near else f"Roles: {', '.join(known)}."
            raise click.UsageError(f"{compiled.system.name} has no role {role!r}. {hint}")
    outputs: list[tuple[Path | None, Kind]] = [(output, "bench"), (plot, "plot")]
    wanted = [(path, kind) for path, kind in outputs if path is not None]
    check_outputs(wanted, [target, *compiled.depends, *traces])
    problems = [problem for path, _ in wanted for problem in check_room(path)]
    if problems:
        print_diagnostics(problems, colour)
        return 1
    from aseme_dsl.project.studying.bench import Different, bench
    from aseme_dsl.project.studying.recorded import NotPlayable

    path = [
        compiled.configuration.folder,
        Path(compiled.root if isinstance(compiled.root, Path) else ".").parent,
    ]
    with TemporaryDirectory(prefix="asemec-bench-") as folder:
        try:
            found = bench(
                compiled.system,
                Path(folder),
                path,
                roles=roles,
                steps=steps,
                rounds=rounds,
                seed=1 if seed is None else seed,
                traces=traces,
            )
        except NotPlayable as problem:
            click.echo(f"asemec: {problem}", err=True)
            return 1
        except Different as problem:
            click.echo(f"asemec: no timing, because the backends disagree: {problem}", err=True)
            return 1
    return _leave(found, output, plot, as_json, colour)


def _leave(found: Bench, output: Path | None, plot: Path | None, as_json: bool, colour: str) -> int:
    """Write the files, and print what is to be printed; the exit code."""
    from dataclasses import asdict

    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.studying.bench_report import markdown
    from aseme_dsl.project.studying.plots import PlotsMissing, costs_plot

    files: dict[Path, bytes] = {}
    if plot is not None:
        try:
            files[plot] = costs_plot({item.role: item.ways for item in found.roles})
        except PlotsMissing as problem:
            raise click.ClickException(str(problem)) from problem
    if output is not None:
        picture = None if plot is None else Path(os.path.relpath(plot, output.parent)).as_posix()
        files[output] = markdown(found, picture).encode()
    for name, content in files.items():
        problems = write_file(name, content).diagnostics
        if has_errors(problems):
            print_diagnostics(problems, colour)
            return 1
    if as_json:
        print_json(asdict(found))
    elif output is None:
        click.echo(markdown(found), nl=False)
    if files and not as_json:
        click.echo("\n".join(str(name) for name in files))
    return 0
