"""`asemec check`: what is wrong with files."""

from __future__ import annotations

import click

from aseme_dsl.cli.shared import (
    FILES_HELP,
    FilePath,
    colour_option,
    diagnostics_json,
    json_option,
    print_diagnostics,
    print_json,
    standard_input,
    summary,
)


@click.command(
    short_help="Say what is wrong with files.",
    help=f"Say everything that is wrong with files, and what is not said yet. {FILES_HELP}"
    " Without FILE: what the project's pyproject.toml names, or every file below here.",
    epilog="Example: asemec check team.aseme   ·   asemec check --strict --json examples/",
)
@click.argument("files", nargs=-1, metavar="[FILE]...", type=FilePath())
@click.option("--strict", is_flag=True, help="Let warnings count as errors for the exit code.")
@json_option
@colour_option
def command(files: tuple[str, ...], strict: bool, as_json: bool, colour: str) -> int:
    """Print the diagnostics and a summary; 1 if there is an error."""
    from aseme_dsl.build.project import check, inputs_of
    from aseme_dsl.diagnostics import Severity

    diagnostics, number = check(inputs_of(files, standard_input))
    if as_json:
        print_json({"files": number, **diagnostics_json(diagnostics)})
    else:
        print_diagnostics(diagnostics, colour, error=False)
        click.echo(("\n" if diagnostics else "") + summary(diagnostics, number))
    bad = {Severity.ERROR, Severity.WARNING} if strict else {Severity.ERROR}
    return int(any(item.severity in bad for item in diagnostics))
