"""`asemec build`: everything that follows from a file, into a folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.shared import (
    FILES_HELP,
    FilePath,
    check_backends,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    json_option,
    print_diagnostics,
    print_json,
    standard_input,
    written_json,
    written_summary,
)
from aseme_dsl.diagnostics import has_errors

if TYPE_CHECKING:
    from aseme_dsl.build.build import Report


@click.command(
    short_help="Write models, diagrams, messages and code.",
    help="Write every model (JSON), diagram (SVG), the messages (.proto) and the code of a system into a"
    f" folder; nothing is written if there is an error. {FILES_HELP} Several systems get a folder each."
    " Files that asemec did not write, or that were edited, are never overwritten without --force;"
    " activities, which you fill in, not even with it.",
    epilog="Example: asemec build team.aseme -o out   ·   asemec build team.aseme -o out --only diagrams",
)
@click.argument("files", nargs=-1, metavar="[FILE]...", type=FilePath())
@folder_option("-o", "--output", text="Where to write.  [default: the project's, else out]")
@click.option(
    "--only",
    multiple=True,
    metavar="PART",
    help="Renew only models, diagrams, proto or a backend's code. May be repeated.",
)
@click.option(
    "--backend",
    "backends",
    multiple=True,
    metavar="NAME",
    help="The backend to generate code with. May be repeated.  [default: the project's, else monas]",
)
@folder_option(
    "--activities", text="Where your activities are.  [default: the project's, else OUTPUT/monas/activities]"
)
@folder_option("--templates", text="A folder of templates that replace the backend's own, by name.")
@click.option(
    "--labels",
    type=click.Choice(["plain", "original"]),
    help="original: name states as the original tools do, to compare.  [default: the project's, else plain]",
)
@click.option("--force", is_flag=True, help="Overwrite files that asemec did not write, or that were edited.")
@json_option
@colour_option
def command(
    files: tuple[str, ...],
    output: Path | None,
    only: tuple[str, ...],
    backends: tuple[str, ...],
    activities: Path | None,
    templates: Path | None,
    labels: str | None,
    force: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Build each system; 1 if there is an error in a file, or something cannot be written."""
    from aseme_dsl.build.build import PARTS, build, choose
    from aseme_dsl.build.configuration import OUTPUT
    from aseme_dsl.build.project import compile_root, inputs_of

    check_backends((item for item in only if item not in PARTS), PARTS)
    check_backends(backends)
    inputs = inputs_of(files, standard_input)
    compiled = [compile_root(root, activities=activities) for root in inputs.roots]
    found = [*inputs.diagnostics, *(problem for item in compiled for problem in item.diagnostics)]
    reports: list[Report] = []
    if not has_errors(found):
        for item in compiled:
            assert item.system is not None
            choice = choose(
                item.configuration,
                only=only,
                backends=backends,
                activities=activities,
                templates=templates,
                labels=labels,
                force=force,
            )
            check_backends(choice.backends)
            folder = output or item.configuration.output or Path(OUTPUT)
            folder = folder / item.system.name if len(compiled) > 1 else folder
            reports.append(build(item.system, folder, choice))
            found += reports[-1].diagnostics
    if as_json:
        print_json({"systems": [_json(report) for report in reports], **diagnostics_json(found)})
    else:
        print_diagnostics(found, colour)
        for report in reports:
            _print(report)
    return int(has_errors(found))


def _print(report: Report) -> None:
    for note in report.notes:
        click.echo(f"note: {note}", err=True)
    if not has_errors(report.diagnostics):
        click.echo(f"{report.system} -> {report.folder}: {written_summary(report.written)}")
        for line in count_lines(report.count):
            click.echo(f"  {line}")


def _json(report: Report) -> dict[str, Any]:
    from dataclasses import asdict

    return {
        "system": report.system,
        "folder": str(report.folder),
        **written_json(report.written),
        "count": asdict(report.count) if report.count is not None else None,
        "remarks": list(report.notes),
    }
