"""`asemec export`: statecharts as files of other tools."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    colour_option,
    diagnostics_json,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    print_written,
    target_argument,
)

if TYPE_CHECKING:
    from aseme_dsl.diagnostics import Diagnostic
    from aseme_dsl.interop.export.scxml import DataModel
    from aseme_dsl.project.building.project import Compiled

FORMATS = ("scxml", "xstate", "stct", "sismic", "mermaid", "plantuml", "bpmn", "promela")


@click.command(
    short_help="Export statecharts to other tools.",
    help="Export the statecharts of a system as files of another tool. FORMAT is scxml (W3C SCXML), xstate"
    " (XState 5: JSON, and its guards and actions in TypeScript), stct (a model of KSE) or sismic (YAML with"
    " Python). Or it is mermaid or plantuml (drawings), bpmn (BPMN 2.0, a process), or promela (for SPIN:"
    " the team and each protocol, with properties and clauses as LTL). What the format cannot"
    f" express is an error with its place, and nothing is written. {TARGET_HELP}",
    epilog="Example: asemec export scxml team.aseme --chart player --datamodel python -o scxml",
)
@click.argument("format_", metavar="FORMAT", type=click.Choice(FORMATS))
@target_argument
@click.option(
    "--chart",
    "charts",
    multiple=True,
    metavar="NAME",
    help="Statechart to export: iac.ROLE, eac.PROTOCOL or a role. Repeatable.  [default: all roles]"
    " For promela: team, or a protocol.  [default: all]",
)
@click.option(
    "--datamodel",
    type=click.Choice(["ecmascript", "python"]),
    help="Language of the expressions in scxml.  [default: ecmascript]",
)
@click.option(
    "-o",
    "--output",
    default="export",
    show_default=True,
    type=FilePath(),
    help="Directory of the files, or - to print the only one.",
)
@click.option("--force", is_flag=True, help="Overwrite edited files and files that asemec did not write.")
@json_option
@colour_option
def command(
    format_: str,
    target: str,
    charts: tuple[str, ...],
    datamodel: DataModel | None,
    output: str,
    force: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Export and write; 1 if the file has errors or the format cannot express something."""
    from aseme_dsl.interop.export.formats import Format
    from aseme_dsl.project.building.export import NoSuchChart, chosen, exported, into_folder, written_out

    if datamodel is not None and format_ != Format.SCXML:
        raise click.UsageError("--datamodel is about scxml: leave it out.")
    compiled = one_system(target)
    found = compiled.diagnostics
    files: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()
    if compiled.system is not None and format_ == "promela":
        files, found = _models(compiled, charts)
    elif compiled.system is not None:
        try:
            selected = chosen(compiled.system, charts)
        except NoSuchChart as problem:
            raise click.UsageError(f"{problem}.") from problem
        files, found = exported(compiled.system, selected, Format(format_), datamodel or "ecmascript")
        notes = written_out(selected, Format(format_))
    if compiled.system is None or found:
        if as_json:
            print_json({"files": [], **diagnostics_json(found)})
        else:
            print_diagnostics(found, colour)
        return 1
    if output == "-":
        if len(files) != 1:
            names = ", ".join(name for name, _ in files) or "none"
            raise click.UsageError(f"- prints one file, but {len(files)} are to be written: {names}.")
        sys.stdout.buffer.write(files[0][1].encode())
        for note in notes:
            click.echo(f"note: {note}", err=True)
        return 0
    return print_written(
        into_folder(compiled.system, Path(output), files, force=force), notes, as_json, colour
    )


def _models(
    compiled: Compiled, names: tuple[str, ...]
) -> tuple[tuple[tuple[str, str], ...], tuple[Diagnostic, ...]]:
    """The models for SPIN, and what they cannot say."""
    from aseme_dsl.project.playing.operate import OperateError
    from aseme_dsl.project.proving.spin.models import models_of
    from aseme_dsl.runtime.version.loading import LoadError

    try:
        return models_of(compiled, names)
    except LookupError as problem:
        raise click.UsageError(f"{problem.args[0]}.") from problem
    except (LoadError, OperateError) as problem:
        raise click.ClickException(str(problem)) from problem
