"""`asemec goals`: what serves each goal of a system, and how often runs have reached it."""

from __future__ import annotations

import click

from aseme_dsl.cli.shared import (
    colour_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    refuse,
    target_argument,
)
from aseme_dsl.diagnostics import Diagnostic, Severity, has_errors


@click.command(
    short_help="Tell what serves each goal of a system.",
    help="List each goal with the use cases, formulas, states and scenarios that serve it, then what serves"
    " no goal."
    " TARGET is a file, a project directory or the output directory of a build. Default: the project in"
    " the current directory. With records of RUNS, tell how often each goal was reached: traces, files of"
    " `asemec test --coverage-file`, and output directories for their last run.",
    epilog="Example: asemec goals team.aseme match1.jsonl match2.jsonl",
)
@target_argument
@click.argument("runs", nargs=-1, metavar="[RUNS]...")
@json_option
@colour_option
def command(target: str, runs: tuple[str, ...], as_json: bool, colour: str) -> int:
    """Print the goals; 1 if something cannot be read."""
    from aseme_dsl.play.coverage.goals import goals_of
    from aseme_dsl.play.coverage.seen import Seen
    from aseme_dsl.project.building.build import choose
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.testing.coverage import model_of, read_runs
    from aseme_dsl.project.testing.goals_report import data, lines
    from aseme_dsl.project.testing.playing import scenarios_in

    compiled = one_system(target)
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, as_json, colour)
    files, problems = all_traces_of(runs) if runs else ((), ())
    if has_errors(problems):
        return refuse(problems, as_json, colour)
    model = model_of(compiled.system, choose(compiled.configuration))
    seen: list[Seen] = []
    found: list[Diagnostic] = []
    for file in files:
        one = Seen()
        found += read_runs(model, [file], one)
        if one.traces or one.scenarios:
            seen.append(one)
    if found and not seen:
        return refuse(found, as_json, colour)
    print_diagnostics(found, colour)
    goals = goals_of(model.system, scenarios_in(compiled), seen)
    if as_json:
        print_json({"goals": data(goals)})
    else:
        for line in lines(goals):
            click.echo(line)
    return int(has_errors(found))
