"""`asemec fmt`: format files."""

from __future__ import annotations

import sys

import click

from aseme_dsl.cli.shared import (
    TARGETS_HELP,
    colour_option,
    diagnostics_json,
    json_option,
    plural,
    print_diagnostics,
    print_json,
    standard_input,
    targets_argument,
    wants_colour,
)

_COLOURS = {"+": "green", "-": "red", "@": "cyan"}


@click.command(
    short_help="Format files.",
    help="Format files in the canonical layout. Only white space and line breaks change. A file with syntax"
    " errors is skipped. In a project directory, all files are formatted. Standard input is printed to"
    f" standard output. {TARGETS_HELP}",
    epilog="Example: asemec fmt   ·   asemec fmt --check --diff examples/",
)
@targets_argument
@click.option(
    "--check", is_flag=True, help="List unformatted files, do not write them; exit with 1 if there are any."
)
@click.option("--diff", is_flag=True, help="Print the changes, do not write them.")
@json_option
@colour_option
def command(targets: tuple[str, ...], check: bool, diff: bool, as_json: bool, colour: str) -> int:
    """Lay out each file; 1 if one has errors or cannot be written, or with --check if one would change."""
    from aseme_dsl.diagnostics import has_errors
    from aseme_dsl.project.editing.format import files_to_format, format_file
    from aseme_dsl.source import STANDARD_INPUT

    inputs = files_to_format(targets, standard_input)
    look_only = check or diff
    done = [format_file(file, write=not look_only) for file in (*inputs.roots, *inputs.others)]
    found = [*inputs.diagnostics, *(problem for one in done for problem in one.diagnostics)]
    code = int(has_errors(found) or (check and any(one.changed for one in done)))
    if as_json:
        rows = [{"file": one.path, "changed": one.changed, "difference": one.difference} for one in done]
        print_json({"files": rows, **diagnostics_json(found)})
        return code
    print_diagnostics(found, colour)
    coloured = wants_colour(colour, sys.stdout)
    filtered = False
    for one in done:
        if one.path == STANDARD_INPUT and not look_only:
            filtered = True
            if not one.diagnostics:
                click.echo(one.text, nl=False)
        elif diff:
            click.echo(_shown(one.difference, coloured), nl=False, color=coloured)
        if one.changed and not filtered and (check or not diff):
            click.echo(f"{one.path}: {'would be ' if check else ''}formatted", err=diff)
    if done and not filtered:
        laid_out = [one.changed for one in done if not one.diagnostics]
        click.echo(_summary(laid_out, len(done) - len(laid_out), look_only), err=diff)
    return code


def _shown(difference: str, coloured: bool) -> str:
    if not coloured:
        return difference
    lines = difference.splitlines(keepends=True)
    return "".join(click.style(line, fg=_COLOURS.get(line[:1])) for line in lines)


def _summary(changed: list[bool], bad: int, look_only: bool) -> str:
    """`2 files formatted, 1 file unchanged, 1 file skipped`."""
    number, fine = sum(changed), len(changed) - sum(changed)
    would = "would be " if look_only else ""
    parts = [f"{plural(number, 'file')} {would}formatted"] if number else []
    if fine or not (number or bad):
        parts.append(f"{plural(fine, 'file')} unchanged")
    if bad:
        parts.append(f"{plural(bad, 'file')} skipped because of errors")
    return ", ".join(parts)
