"""`asemec scaffold`: add skeletons for missing declarations to a file."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    TARGETS_HELP,
    colour_option,
    diagnostics_json,
    folder_option,
    json_option,
    plural,
    print_diagnostics,
    print_json,
    standard_input,
    targets_argument,
)


@click.command(
    short_help="Add skeletons for missing declarations.",
    help="Add skeletons for missing protocols, roles, formulas and control lines to a file, and change"
    " nothing else in it. In a project with a directory of activities, also create a stub for each activity"
    " that has no file and is not `simulated`. Renew the stubs that are not edited. A file with errors is"
    f" skipped. Standard input is printed to standard output. {TARGETS_HELP}",
    epilog="Example: asemec scaffold --diff team.aseme   ·   asemec scaffold team.aseme",
)
@targets_argument
@folder_option("--activities", text="Directory of the activities' Python code.  [default: the project's]")
@click.option("--diff", is_flag=True, help="Print the additions, do not write them.")
@json_option
@colour_option
def command(targets: tuple[str, ...], activities: Path | None, diff: bool, as_json: bool, colour: str) -> int:
    """Complete each file; 1 if one has errors or cannot be written."""
    from aseme_dsl.diagnostics import Severity, has_errors, render_json
    from aseme_dsl.project.building.project import inputs_of
    from aseme_dsl.project.editing.complete import complete
    from aseme_dsl.source import STANDARD_INPUT

    inputs = inputs_of(targets, standard_input)
    completed = [complete(root, write=not diff, activities=activities) for root in inputs.roots]
    # What is missing is written now, or was left out of the file on purpose: `check` says it.
    found = [*inputs.diagnostics, *(item for one in completed for item in one.diagnostics)]
    serious = [item for item in found if item.severity is not Severity.NOTE]
    if as_json:
        rows = [
            {
                "file": item.path,
                "added": render_json(item.added),
                "advised": render_json(item.advised),
                "code": [str(path) for path in item.code],
                "renewed": [str(path) for path in item.renewed],
                "difference": item.difference,
            }
            for item in completed
        ]
        print_json({"files": rows, **diagnostics_json(found)})
        return int(has_errors(found))
    print_diagnostics(serious, colour)
    for item in completed:
        if diff:
            click.echo(item.difference, nl=False)
        elif item.path == STANDARD_INPUT:
            click.echo(item.text, nl=False)
        elif not has_errors(item.diagnostics):
            for note in item.added:
                click.echo(f"{note.span or item.path}: {note.message}: skeleton added", err=True)
            for note in item.advised:
                place = note.span or item.path
                click.echo(f"{place}: {note.message}: comment added", err=True)
            counted = plural(len(item.added), "skeleton")
            counted += f" and {plural(len(item.advised), 'comment')}" if item.advised else ""
            click.echo(f"{item.path}: {counted} added", file=sys.stdout)
            if item.wait:
                click.echo(f"{item.path}: activity stubs follow when no hole is left")
            for path in item.code:
                click.echo(f"{path}: created", file=sys.stdout)
            for path in item.renewed:
                click.echo(f"{path}: renewed", file=sys.stdout)
    return int(has_errors(found))
