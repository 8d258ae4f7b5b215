"""`asemec build`: everything that follows from a file, into a folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.report import Report, form_of, print_report, report_options
from aseme_dsl.cli.shared import (
    FILES_HELP,
    FilePath,
    activities_option,
    backend_option,
    check_backends,
    check_choice,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    print_diagnostics,
    standard_input,
    written_json,
    written_summary,
)
from aseme_dsl.diagnostics import has_errors, in_order

if TYPE_CHECKING:
    from aseme_dsl.build.build import Report as Built


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
@backend_option(
    "The backend to generate code with, for all or also for a role. May be repeated."
    "  [default: the project's, else monas]"
)
@activities_option
@folder_option("--templates", text="A folder of templates that replace the backend's own, by name.")
@click.option(
    "--labels",
    type=click.Choice(["plain", "original"]),
    help="original: name states as the original tools do, to compare.  [default: the project's, else plain]",
)
@click.option("--force", is_flag=True, help="Overwrite files that asemec did not write, or that were edited.")
@report_options("--report")
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
    form: str | None,
    as_json: bool,
    report: Path | None,
    colour: str,
) -> int:
    """Build each system; 1 if there is an error in a file, or something cannot be written."""
    from aseme_dsl.build.build import PARTS, build, choose
    from aseme_dsl.build.configuration import OUTPUT
    from aseme_dsl.build.project import compile_root, inputs_of, once, path_of

    form = form_of(form, as_json, report)
    check_backends((item for item in only if item not in PARTS), PARTS)
    inputs = inputs_of(files, standard_input)
    compiled = [compile_root(root, activities=activities) for root in inputs.roots]
    found = [*inputs.diagnostics, *(problem for item in compiled for problem in item.diagnostics)]
    built: list[Built] = []
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
            check_choice(
                choice, backends, [c.name for one in compiled if one.system for c in one.system.iacs]
            )
            folder = output or item.configuration.output or Path(OUTPUT)
            folder = folder / item.system.name if len(compiled) > 1 else folder
            built.append(build(item.system, folder, choice))
            found += built[-1].diagnostics
    told = Report(
        "build",
        in_order(found),
        once(problem for item in compiled for problem in item.suppressed),
        [path_of(root) for root in inputs.roots],
        lambda: {"systems": [_json(item) for item in built], **diagnostics_json(found)},
        "".join(f"{line}\n" for item in built for line in _lines(item)),
    )
    for note in (note for item in built for note in item.notes):
        click.echo(f"note: {note}", err=True)
    failed = False
    if form == "text" and report is None:
        print_diagnostics(told.diagnostics, colour)
    else:
        failed = print_report(told, form, report, colour)
    if form == "text" or report is not None:
        click.echo(told.closing, nl=False)
    return int(failed or has_errors(found))


def _lines(built: Built) -> list[str]:
    """What became of a system, for people; nothing where it could not be built."""
    if has_errors(built.diagnostics):
        return []
    said = f"{built.system} -> {built.folder}: {written_summary(built.written)}"
    return [said, *(f"  {line}" for line in count_lines(built.count))]


def _json(built: Built) -> dict[str, Any]:
    from dataclasses import asdict

    return {
        "system": built.system,
        "folder": str(built.folder),
        **written_json(built.written),
        "count": asdict(built.count) if built.count is not None else None,
        "remarks": list(built.notes),
    }
