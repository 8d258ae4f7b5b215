"""`asemec new`: create a project."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    FilePath,
    colour_option,
    diagnostics_json,
    json_option,
    print_diagnostics,
    print_json,
)
from aseme_dsl.diagnostics import has_errors


@click.command(
    short_help="Create a project.",
    help="Create a small project in DIR: an .aseme file, activities, a test and a pyproject.toml. An existing"
    " file is never overwritten.",
    epilog="Example: asemec new patrol   ·   cd patrol   ·   asemec run .",
)
@click.argument("folder", metavar="DIR", type=FilePath(path_type=Path))
@click.option("--name", help="Name of the system.  [default: the name of DIR]")
@json_option
@colour_option
def command(folder: Path, name: str | None, as_json: bool, colour: str) -> int:
    """Write it; 1 if something is in the way."""
    from aseme_dsl.project.editing.new import BadName, new_project

    try:
        written = new_project(folder, name)
    except BadName as problem:
        raise click.UsageError(f"{problem}.") from problem
    if as_json:
        created = [str(path) for path in written.created]
        print_json({"created": created, **diagnostics_json(written.diagnostics)})
    else:
        print_diagnostics(written.diagnostics, colour)
        for path in written.created:
            click.echo(path)
        if written.created:
            click.echo(f"Next: asemec run {click.format_filename(folder)}")
    return int(has_errors(written.diagnostics))
