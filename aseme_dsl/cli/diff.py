"""`asemec diff`: what two versions of a system do differently, and the shortest runs that show it."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import time_limit_of
from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.shared import FilePath, Refused, colour_option, json_option, print_json, refuse
from aseme_dsl.diagnostics import Severity, has_errors

if TYPE_CHECKING:
    from aseme_dsl.project.comparing.compatible import Compatibility
    from aseme_dsl.project.comparing.report import Report
    from aseme_dsl.project.comparing.versions import Compiled

_NANOSECOND = 1e-9


@click.command(
    short_help="Compare the behaviour of two versions.",
    help="Compare two versions of a system: what was added, removed, changed or renamed. For each role and"
    " protocol, show the shortest runs that differ: with the same inputs, one version does what the other"
    " does not. OLD and NEW are files, project directories or git revisions. REVISION:PATH names a file of a"
    " revision, and PATH that of both. Default: the project in the current directory, and for NEW what is"
    " there now. Exit codes: 0 no difference, 1 a difference or errors in a file, 3 undecided.",
    epilog="Example: asemec diff HEAD~1 HEAD team.aseme   ·   asemec diff before.aseme after.aseme",
)
@click.argument("old", type=str)
@click.argument("new", required=False)
@click.argument("path", required=False, metavar="[PATH]")
@click.option(
    "--budget",
    default="20s",
    show_default=True,
    callback=time_limit_of,
    metavar="D",
    help="Processor time for the search in each role and participant.",
)
@click.option(
    "--states",
    type=click.IntRange(1),
    default=50_000,
    show_default=True,
    metavar="N",
    help="Number of states, at most, in each role and participant.",
)
@click.option(
    "--most",
    type=click.IntRange(1, 20),
    default=3,
    show_default=True,
    metavar="N",
    help="Number of differences to show of each role and participant.",
)
@click.option(
    "--picture",
    "-o",
    "folder",
    type=FilePath(),
    metavar="DIR",
    help="Directory for drawings of the statecharts that have changed.",
)
@click.option(
    "--format",
    "format_",
    type=click.Choice(["text", "markdown", "github"]),
    default="text",
    show_default=True,
    help="Output format; markdown or github: a comment on a change.",
)
@json_option
@colour_option
def command(
    old: str,
    new: str | None,
    path: str | None,
    budget: int,
    states: int,
    most: int,
    folder: str | None,
    format_: str,
    as_json: bool,
    colour: str,
) -> int:
    """Compare; 1 if something is different or a file has errors, 3 if something is undecided."""
    from aseme_dsl.project.comparing.behaviour import behaviour_of
    from aseme_dsl.project.comparing.compatible import compatibility
    from aseme_dsl.project.comparing.elements import elements_of
    from aseme_dsl.project.comparing.report import Report
    from aseme_dsl.project.comparing.structure import changes_of
    from aseme_dsl.project.comparing.versions import NotAVersion, opened
    from aseme_dsl.project.playing.operate import OperateError
    from aseme_dsl.project.settings.target import project_here
    from aseme_dsl.proofs.compare.search import Bounds
    from aseme_dsl.runtime.version.loading import LoadError

    here = path if path is not None else project_here()
    progress = Progress(as_json)
    with ExitStack() as stack:
        try:
            first = stack.enter_context(opened(old, here))
            second = stack.enter_context(opened(new if new is not None else here, here))
        except NotAVersion as problem:
            raise click.UsageError(f"{problem}.") from problem
        for version in (first, second):
            if version.system is None:
                wrong = [item for item in version.diagnostics if item.severity is Severity.ERROR]
                assert has_errors(wrong)
                return refuse(wrong, as_json, colour)
        assert first.system is not None and second.system is not None
        structure = changes_of(elements_of(first.system), elements_of(second.system))
        bounds = Bounds(states, budget * _NANOSECOND, most)
        try:
            results = behaviour_of(first, second, structure, bounds, progress.say)
        except (LoadError, OperateError) as problem:
            raise click.ClickException(str(problem)) from problem
        finally:
            progress.end()
        report = Report(first, second, structure, results)
        pictures = _draw(report, first, second, folder) if folder is not None else ()
        _print(report, pictures, format_, as_json, compatibility(first.system, second.system))
        return code_of(report)


def code_of(report: Report) -> int:
    """0 if there is no difference in behaviour, 1 if there is one, 3 if it was not decided."""
    from typing import assert_never

    from aseme_dsl.project.comparing.behaviour import Verdict

    match report.verdict:
        case Verdict.EQUAL:
            return 0
        case Verdict.DIFFERENT:
            return 1
        case Verdict.UNDECIDED:
            return 3
        case _:
            assert_never(report.verdict)


def _draw(report: Report, old: Compiled, new: Compiled, folder: str) -> tuple[str, ...]:
    from aseme_dsl.project.comparing.pictures import pictures
    from aseme_dsl.project.files.write import write_file

    written = []
    for name, content in pictures(report):
        place = Path(folder) / name
        found = write_file(place, content).diagnostics
        if has_errors(found):
            raise Refused(found)
        written.append(str(place))
    return tuple(written)


def _print(
    report: Report, pictures: tuple[str, ...], format_: str, as_json: bool, messages: Compatibility
) -> None:
    from aseme_dsl.project.comparing import compatible
    from aseme_dsl.project.comparing.markdown import markdown
    from aseme_dsl.project.comparing.report import as_json as to_json
    from aseme_dsl.project.comparing.report import lines

    if as_json:
        compared = compatible.as_json(messages)
        print_json({**to_json(report), "pictures": list(pictures), "compatibility": compared})
        return
    for line in lines(report) if format_ == "text" else markdown(report, pictures):
        click.echo(line)
    if messages.incompatible:
        refused = ", ".join(f"{item.kind} {item.name}" for item in messages.incompatible)
        click.echo(f"\nrobots of the two versions refuse messages of each other: {refused}")
        click.echo("for details: asemec check --compatible-with OLD")
    if format_ == "text" and pictures:
        click.echo(f"\ndrawn: {', '.join(pictures)}")


__all__ = ["command"]
