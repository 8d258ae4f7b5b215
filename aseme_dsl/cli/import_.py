"""`asemec import`: convert the files of other tools to `.aseme` text."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    FilePath,
    colour_option,
    diagnostics_json,
    folder_option,
    json_option,
    print_diagnostics,
    print_json,
)


@click.command(
    short_help="Convert models of KSE, and state machines of SCXML.",
    help="Write a project in DIR from models of KSE and the ASEME IDE, and from Monas' agents.xml. FILE is a"
    " .sag, .suc, .aip, .srm, .stct, .sct, .iac, .eac or .model file. State machines become a project, too:"
    " FILE is a .scxml file, or the JSON of an XState 5 machine. Missing conditions become holes."
    " import-report.md lists what became of each element. Messages come from the .proto files beside the"
    " models, or from those in FILE; constants come from C++ headers in FILE. An existing file is never"
    " overwritten. An agents.xml alone is printed as a `modules` block.",
    epilog="Example: asemec import models/Goalie.stct src/messages/*.proto -o goalie",
)
@click.argument("files", metavar="FILE...", nargs=-1, required=True, type=FilePath(path_type=Path))
@folder_option("-o", "--output", text="Directory of the project.  [default: the name of the first model]")
@json_option
@colour_option
def command(files: Sequence[Path], output: Path | None, as_json: bool, colour: str) -> int:
    """Write the project, or print the modules; 1 if a file cannot be read or written."""
    if output is None and len(files) == 1 and files[0].suffix.lower() == ".xml":
        return _modules(files[0], as_json, colour)
    from aseme_dsl.diagnostics import has_errors
    from aseme_dsl.interop.emf.report import summary, worth_reading
    from aseme_dsl.project.editing.import_models import import_models, write_project

    project = import_models(files)
    folder = output or Path(project.system.lower() or ".")
    project = write_project(project, folder)
    if as_json:
        created = [str(path) for path in project.created]
        rows = [
            {"fate": row.fate, "element": row.element, "place": str(row.place or ""), "now": row.now}
            for row in project.rows
        ]
        print_json({"created": created, "elements": rows, **diagnostics_json(project.diagnostics)})
    else:
        print_diagnostics(project.diagnostics, colour)
        if project.created:
            for line in worth_reading(project.rows):
                click.echo(line)
            click.echo(f"{summary(project.rows)}\n")
            for path in project.created:
                click.echo(path)
            click.echo(f"Next: asemec check {click.format_filename(folder)}")
    return int(has_errors(project.diagnostics))


def _modules(file: Path, as_json: bool, colour: str) -> int:
    from aseme_dsl.diagnostics import has_errors
    from aseme_dsl.project.files.foreign import imported_modules

    text, found = imported_modules(file)
    if as_json:
        print_json({"text": text, **diagnostics_json(found)})
    else:
        print_diagnostics(found, colour)
        click.echo(text, nl=False)
    return int(has_errors(found))
