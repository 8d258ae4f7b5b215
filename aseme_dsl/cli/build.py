"""`asemec build`: write models, diagrams, messages and code into a directory."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

import click

from aseme_dsl.cli.progress import progress_of
from aseme_dsl.cli.report import Report, form_of, print_report, report_options
from aseme_dsl.cli.shared import (
    TARGETS_HELP,
    activities_option,
    backend_option,
    certified,
    check_backends,
    check_choice,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    print_diagnostics,
    standard_input,
    stats_option,
    summary,
    targets_argument,
    watch_option,
    written_json,
    written_summary,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors, in_order

if TYPE_CHECKING:
    from aseme_dsl.cli.watching import Done
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.building.build import Report as Built
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.building.workshop import Workshop
    from aseme_dsl.project.files.inputs import Inputs


@click.command(
    short_help="Write models, diagrams, messages and code.",
    help="Write the models (JSON), diagrams (SVG), messages (.proto) and code of a system to the output"
    " directory; several systems get a subdirectory each. With an error in a file, nothing is written. Edited"
    " files, and files that asemec did not write, are only overwritten with --force; activities never are."
    f" {TARGETS_HELP}",
    epilog="Example: asemec build team.aseme -o out   ·   asemec build team.aseme -o out --only diagrams",
)
@targets_argument
@folder_option("-o", "--output", text="Output directory.  [default: the project's, else out]")
@click.option(
    "--only",
    multiple=True,
    metavar="PART",
    help="Write only PART: models, diagrams, proto or a backend. Repeatable.",
)
@backend_option(
    "Backend that generates the code, for all roles or also for ROLE. Repeatable."
    "  [default: the project's, else monas]"
)
@activities_option
@folder_option("--templates", text="Directory of templates that override the backend's, by file name.")
@click.option(
    "--labels",
    type=click.Choice(["plain", "original"]),
    help="State labels; original: as in the original ASEME tools.  [default: the project's, else plain]",
)
@click.option(
    "--native",
    is_flag=True,
    help="Also compile the classes of `--backend plain` to machine code (mypyc).",
)
@click.option("--force", is_flag=True, help="Overwrite edited files and files that asemec did not write.")
@stats_option
@watch_option
@report_options("--report")
@colour_option
def command(
    targets: tuple[str, ...],
    output: Path | None,
    only: tuple[str, ...],
    backends: tuple[str, ...],
    activities: Path | None,
    templates: Path | None,
    labels: str | None,
    native: bool,
    force: bool,
    stats: bool,
    watch: bool,
    form: str | None,
    as_json: bool,
    report: Path | None,
    colour: str,
) -> int:
    """Build each system; 1 if there is an error in a file, or something cannot be written."""
    from aseme_dsl.project.building.build import PARTS
    from aseme_dsl.project.building.project import once, path_of

    form = form_of(form, as_json, report)
    check_backends((item for item in only if item not in PARTS), PARTS)
    check_backends(item.rpartition("=")[2] for item in backends)
    do = partial(
        _built,
        targets,
        output,
        _Chosen(
            only=only,
            backends=backends,
            activities=activities,
            templates=templates,
            labels=labels,
            native=native,
            force=force,
        ),
    )
    if watch:
        from aseme_dsl.cli import watching

        watching.refuse_to_watch(targets, form, report)
        return watching.watch(partial(_once, do), targets, activities, templates, colour)
    inputs, compiled, built, found = do(None)
    told = Report(
        "build",
        in_order(found),
        once(problem for item in compiled for problem in item.suppressed),
        [path_of(root) for root in inputs.roots],
        lambda: {"systems": [_json(item) for item in built], **diagnostics_json(found)},
        "".join(f"{line}\n" for item in built for line in _lines(item, stats)),
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


class _Chosen(TypedDict):
    """What the options choose, as `choose` takes it."""

    only: tuple[str, ...]
    backends: tuple[str, ...]
    activities: Path | None
    templates: Path | None
    labels: str | None
    native: bool
    force: bool


_Done = tuple["Inputs", list["Compiled"], list["Built"], list[Diagnostic]]
"""What was meant, what it compiled to, what was built of it, and all that there is to say."""


def _built(
    targets: tuple[str, ...], output: Path | None, chosen: _Chosen, workshop: Workshop | None
) -> _Done:
    """Compile and build once; with an error in any of the systems, none is built."""
    from aseme_dsl.project.building.build import build, choose
    from aseme_dsl.project.building.project import compile_root, inputs_of, path_of
    from aseme_dsl.project.settings.configuration import OUTPUT

    inputs = inputs_of(targets, standard_input)
    compiled = [
        compile_root(
            root, activities=chosen["activities"], output=output or inputs.output_of(root), workshop=workshop
        )
        for root in inputs.roots
    ]
    found = [*inputs.diagnostics, *(problem for item in compiled for problem in item.diagnostics)]
    built: list[Built] = []
    if not has_errors(found):
        for item in compiled:
            assert item.system is not None
            choice = choose(item.configuration, **chosen)
            check_choice(
                choice,
                chosen["backends"],
                [c.name for one in compiled if one.system for c in one.system.iacs],
                plays=False,
            )
            if choice.native:
                _check_native(choice)
            alone = output or item.configuration.output or Path(OUTPUT)
            among = alone / item.system.name
            several = len(compiled) > 1 and (output is not None or inputs.output_of(item.root) is None)
            folder, other = (among, alone) if several else (alone, among)
            choice = replace(choice, replaces=output is None and item.configuration.output is None)
            earlier = None if workshop is None else workshop.about(path_of(item.root)).begin(item.layout)
            with progress_of(item.system.name) as told:
                done = build(
                    item.system, folder, choice, earlier=earlier, told=told, certificates=item.certificates
                )
            built.append(replace(done, notes=(*done.notes, *_left_behind(item.system.name, folder, other))))
            found += built[-1].diagnostics
    return inputs, compiled, built, found


def _left_behind(system: str, folder: Path, other: Path) -> Iterator[str]:
    """The note about an older build of the system in the other folder, if there is one.

    A system built alone and a system built with others go to different folders. This build leaves the other
    folder unchanged, as programs may still import it.
    """
    from aseme_dsl.project.files.manifest import DamagedManifest, read_manifest

    try:
        before = read_manifest(other).system
    except (DamagedManifest, OSError):
        return  # a build into that folder reports it
    if before == system:
        yield f"{other} has an older build of {system}, which is unchanged; the new one is in {folder}"


def _check_native(choice: Choice) -> None:
    """Raises a usage error if nothing is generated that could be compiled; another where mypyc is missing."""
    from aseme_dsl.project.building.native import BACKEND, NativeError, check_installed

    if BACKEND not in (choice.only or choice.generated):
        raise click.UsageError(f"--native requires --backend {BACKEND}.")
    try:
        check_installed()
    except NativeError as problem:
        raise click.ClickException(str(problem)) from problem


def _once(do: Callable[[Workshop], _Done], workshop: Workshop) -> Done:
    """The same for `--watch`: what was written, in a few lines."""
    from aseme_dsl.cli.watching import Done, named

    _, compiled, built, found = do(workshop)
    said = [
        line
        for item in built
        if not has_errors(item.diagnostics)
        for line in (_changed(item, named), *item.notes)
    ]
    if has_errors(found):
        said = [f"{summary(found, 0).partition(' in ')[0]}; the previous build is unchanged"]
    written = [
        path
        for item in built
        for path in (*item.written.created, *item.written.changed, *item.written.removed)
    ]
    return Done(in_order(found), tuple(compiled), "\n".join(said), tuple(written))


def _changed(built: Built, named: Callable[[Sequence[str | Path]], str]) -> str:
    """Which files have changed, where they are few."""
    parts = (
        (built.written.created, "new"),
        (built.written.changed, "changed"),
        (built.written.removed, "removed"),
    )
    said = [
        f"{what} {named([_inside(path, built.folder) for path in paths])}" for paths, what in parts if paths
    ]
    return f"{built.system} -> {built.folder}: {'; '.join(said) or 'no change'}"


def _inside(path: Path, folder: Path) -> str:
    return str(path.relative_to(folder) if path.is_relative_to(folder) else path)


def _lines(built: Built, stats: bool) -> list[str]:
    """What became of a system, for people; nothing where it could not be built."""
    if has_errors(built.diagnostics):
        return []
    said = (
        f"{built.system} -> {built.folder}: {written_summary(built.written)}{certified(built.certificates)}"
    )
    return [said, *(f"  {line}" for line in (count_lines(built.count) if stats else ()))]


def _json(built: Built) -> dict[str, object]:
    from dataclasses import asdict

    return {
        "system": built.system,
        "folder": str(built.folder),
        **written_json(built.written),
        "count": asdict(built.count) if built.count is not None else None,
        "remarks": list(built.notes),
        "certified": [asdict(item) for item in built.certificates],
    }
