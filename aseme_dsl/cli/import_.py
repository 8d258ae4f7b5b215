"""`asemec import`: convert the files of other tools to `.aseme` text."""

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


@click.command(
    short_help="Convert a Monas agents.xml to a `modules` block.",
    help="Convert FILE, an agents.xml of Monas, to a `modules` block for an srm and print it. Add by hand"
    " what the modules read and write.",
    epilog="Example: asemec import config/agents.xml",
)
@click.argument("file", type=FilePath(path_type=Path))
@json_option
@colour_option
def command(file: Path, as_json: bool, colour: str) -> int:
    """Print the text; 1 if the file cannot be read."""
    from aseme_dsl.diagnostics import has_errors
    from aseme_dsl.project.files.foreign import imported_modules

    text, found = imported_modules(file)
    if as_json:
        print_json({"text": text, **diagnostics_json(found)})
    else:
        print_diagnostics(found, colour)
        click.echo(text, nl=False)
    return int(has_errors(found))
