"""`asemec coverage`: what recorded runs have reached of a system."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.covering import Wanted, check_page, fail_under_option, html_option, too_little, write_page
from aseme_dsl.cli.shared import (
    colour_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    refuse,
    targets_argument,
)
from aseme_dsl.diagnostics import Severity, has_errors


@click.command(
    short_help="Tell what runs have reached of a system.",
    help="Count which goals, use cases, formulas, states, transitions and outcomes of a system recorded runs"
    " have reached. TARGET is a trace, or a file of `asemec test --coverage-file`; several count together."
    " A file, a project directory or an output directory stands for the traces of its last run."
    " Default: the project in the current directory.",
    epilog="Example: asemec coverage match1.jsonl match2.mcap scenarios.json --fail-under transitions=80",
)
@targets_argument
@click.option(
    "--source",
    metavar="FILE",
    help="The .aseme file or project directory of the system.  [default: that of the traces]",
)
@html_option
@fail_under_option
@json_option
@colour_option
def command(
    targets: tuple[str, ...],
    source: str | None,
    html: Path | None,
    wanted: Wanted,
    as_json: bool,
    colour: str,
) -> int:
    """Print the coverage; 1 if something cannot be read, or too little is covered."""
    from aseme_dsl.play.coverage.measure import measured
    from aseme_dsl.play.coverage.seen import Seen
    from aseme_dsl.project.building.build import choose
    from aseme_dsl.project.settings.target import all_traces_of
    from aseme_dsl.project.testing.coverage import model_of, read_runs, source_of_runs
    from aseme_dsl.project.testing.coverage_report import data, lines

    files, problems = all_traces_of(targets)
    check_page(html, files)
    if has_errors(problems):
        return refuse(problems, as_json, colour)
    compiled = one_system(source or source_of_runs(targets, files))
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, as_json, colour)
    seen = Seen()
    model = model_of(compiled.system, choose(compiled.configuration))
    found = read_runs(model, files, seen, conditions=True)
    if found and not (seen.traces or seen.scenarios):
        return refuse(found, as_json, colour)
    print_diagnostics(found, colour)
    coverage = measured(model.system, seen)
    written = write_page(html, model.system, coverage, colour)
    if as_json:
        print_json({"coverage": data(coverage)})
    else:
        for line in lines(coverage):
            click.echo(line)
    return max(written, int(has_errors(found)), too_little(coverage, wanted))
