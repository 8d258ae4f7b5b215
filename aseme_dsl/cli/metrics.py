"""`asemec metrics`: how often and how long agents were in states, in one run or in many."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    FilePath,
    check_outputs,
    colour_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    refuse,
    targets_argument,
)
from aseme_dsl.diagnostics import Diagnostic, Severity, has_errors
from aseme_dsl.diagnostics.problems.running import TraceNotRead


@click.command(
    short_help="Measure states, goals and protocols in recorded runs.",
    help="Tell how often and how long agents were in each state, goals were served and conversations lasted,"
    " and how they ended. Of several runs, such as those of several seeds, tell the mean with the least and"
    " the greatest. TARGET is a trace. A file, a project directory or an output directory stands for the"
    " traces of its last run. Default: the project in the current directory.",
    epilog="Example: asemec metrics seed1.jsonl seed2.jsonl seed3.jsonl --plot metrics.svg",
)
@targets_argument
@click.option(
    "--source",
    metavar="FILE",
    help="The .aseme file or project directory of the system.  [default: that of the traces]",
)
@click.option(
    "--plot",
    "picture",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Output file of a plot (.svg) with a dot for each run.",
)
@json_option
@colour_option
def command(
    targets: tuple[str, ...], source: str | None, picture: Path | None, as_json: bool, colour: str
) -> int:
    """Print the metrics; 1 if something cannot be read or written."""
    from aseme_dsl.play.coverage.seen import Seen
    from aseme_dsl.play.metrics import Measuring, RunMetrics
    from aseme_dsl.project.building.build import choose
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.studying.metrics_plot import plot
    from aseme_dsl.project.studying.metrics_report import data, lines, rows
    from aseme_dsl.project.testing.coverage import model_of, read_runs, source_of_runs

    files, problems = all_traces_of(targets)
    if picture is not None:
        if picture.suffix != ".svg":
            raise click.UsageError("--plot: the name of the file must end in .svg.")
        check_outputs([(picture, "metrics")], files)
    if has_errors(problems):
        return refuse(problems, as_json, colour)
    compiled = one_system(source or source_of_runs(targets, files))
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, as_json, colour)
    model = model_of(compiled.system, choose(compiled.configuration))
    found: list[Diagnostic] = []
    runs: list[RunMetrics] = []
    left_out: list[str] = []
    for file in files:
        if file.suffix == ".json":
            reason = "it is a file of `asemec test --coverage-file`, not a trace"
            found.append(Diagnostic(TraceNotRead(reason), None, path=str(file)))
            continue
        measuring, seen = Measuring(model.system, model.hashes.values()), Seen()
        found += read_runs(model, [file], seen, [measuring])
        if seen.traces:
            runs.append(measuring.end())
            left_out += seen.left_out
    if not runs:
        return refuse(found, as_json, colour)
    print_diagnostics(found, colour)
    if picture is not None:
        text = plot(f"{model.system.name}, {len(runs)} runs", rows(model.system, runs))
        written = write_file(picture, text.encode()).diagnostics
        print_diagnostics(written, colour)
        found += written
    if as_json:
        print_json({"metrics": {**data(model.system, runs), "left_out": left_out}})
    else:
        for line in left_out:
            click.echo(f"note: {line}")
        for line in lines(model.system, runs):
            click.echo(line)
    return int(has_errors(found))
