"""Playing: what the commands `run` and `node` have in common: options, and building what is to be played."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

import click

from aseme_dsl.cli.progress import progress_of
from aseme_dsl.cli.shared import (
    CommandT,
    FilePath,
    check_choice,
    folder_option,
    one_system,
    print_diagnostics,
    refuse,
    wants_colour,
    written_summary,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import Choice, Report
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.code.activity_files import WithoutCode
    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.team.network import Network
    from aseme_dsl.runtime.version.loading import Loaded

INTERRUPTED = 130
"""The exit code of what was ended by a signal."""


def duration_of(context: click.Context, parameter: click.Parameter, value: str | None) -> int | None:
    """A duration on the command line, in ns."""
    from aseme_dsl.project.files.duration import duration

    try:
        return None if value is None else duration(value)
    except ValueError as problem:
        raise click.BadParameter(f"{problem}.") from problem


def time_limit_of(context: click.Context, parameter: click.Parameter, value: str | None) -> int | None:
    """A duration on the command line that something lasts, in ns."""
    limit = duration_of(context, parameter, value)
    if limit == 0:
        raise click.BadParameter("the time limit must be greater than zero.")
    return limit


def function_of(context: click.Context, parameter: click.Parameter, value: str | None) -> str | None:
    """`MODULE:FUNCTION` on the command line."""
    if value is not None and not is_function(value):
        raise click.BadParameter(f"{value!r} does not have the form MODULE:FUNCTION.")
    return value


def bodies_of(context: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> dict[str, str]:
    """`[AGENT=]MODULE:FUNCTION` as functions by agent; "" is every agent."""
    found: dict[str, str] = {}
    for value in values:
        agent, _, function = value.rpartition("=")
        if not is_function(function):
            raise click.BadParameter(f"{value!r} does not have the form [AGENT=]MODULE:FUNCTION.")
        if agent in found:
            raise click.BadParameter(f"two bodies for {agent or 'every agent'}.")
        found[agent] = function
    return found


def is_function(text: str) -> bool:
    """Whether a text is `MODULE:FUNCTION`."""
    module, _, name = text.partition(":")
    return name.isidentifier() and all(part.isidentifier() for part in module.split("."))


def duration_option(text: str, may_be_zero: bool = True) -> Callable[[CommandT], CommandT]:
    """`--for DURATION`."""
    callback = duration_of if may_be_zero else time_limit_of
    return click.option("--for", "duration", metavar="DURATION", callback=callback, help=text)


def input_option(text: str) -> Callable[[CommandT], CommandT]:
    """`--input FILE.jsonl`."""
    return click.option("--input", "script", type=FilePath(path_type=Path), metavar="FILE.jsonl", help=text)


def trace_option(text: str) -> Callable[[CommandT], CommandT]:
    """`--trace FILE`."""
    return click.option("--trace", type=FilePath(path_type=Path), metavar="FILE", help=text)


def body_option(text: str) -> Callable[[CommandT], CommandT]:
    """`--body [AGENT=]MODULE:FUNCTION`, which may be repeated."""
    return click.option(
        "--body", "bodies", multiple=True, metavar="[AGENT=]MODULE:FUNCTION", callback=bodies_of, help=text
    )


def seed_option(command: CommandT) -> CommandT:
    """`--seed NUMBER`."""
    text = "Seed for random numbers.  [default: the project's, else 1]"
    return click.option("--seed", type=int, help=text)(command)


def network_option(text: str) -> Callable[[CommandT], CommandT]:
    """`--network WORDS`."""
    return click.option("--network", "network_words", metavar="WORDS", help=text)


def network_of(text: str | None) -> tuple[Network | None, list[Diagnostic]]:
    """The network that `--network` describes, and what is wrong with the description."""
    from aseme_dsl.grammar.text.network_words import NetworkWordsError, read_network

    try:
        return (None if text is None else read_network(text)), []
    except NetworkWordsError as error:
        place = Span(Source("--network", text or ""), error.start, error.end)
        return None, [Diagnostic(error.problem, place)]


def platform_option(text: str, platforms: Sequence[str]) -> Callable[[CommandT], CommandT]:
    """`--platform NAME`."""
    return click.option("--platform", type=click.Choice(platforms), help=text)


def state_option(command: CommandT) -> CommandT:
    """`--state DIR`."""
    text = "Directory for persistent states.  [default: the project's]"
    return folder_option("--state", text=text)(command)


def telling_options(command: CommandT) -> CommandT:
    """`--quiet` and `--verbose`."""
    quiet = click.option("-q", "--quiet", is_flag=True, help="Suppress progress output.")
    verbose = click.option("-v", "--verbose", is_flag=True, help="Print each transition and activity.")
    return quiet(verbose(command))


def build_target(
    target: str,
    output: Path | None,
    activities: Path | None,
    templates: Path | None,
    force: bool,
    as_json: bool,
    colour: str,
    backends: Sequence[str] = (),
) -> tuple[Report, Compiled, Choice, WithoutCode] | int:
    """Build the one system that the target means; or the exit code, after saying what is wrong.

    No activity is started: that is what `build` and `scaffold` are for.
    """
    from aseme_dsl.diagnostics import Severity
    from aseme_dsl.project.building.build import activities_folder, build, choose
    from aseme_dsl.project.code.activity_files import without_code
    from aseme_dsl.project.settings.configuration import OUTPUT

    compiled = one_system(target, activities)
    # Notes are about what is still to be written: `check` and `build` say them.
    found = tuple(item for item in compiled.diagnostics if item.severity is not Severity.NOTE)
    if compiled.system is None or has_errors(found):
        return refuse(found, as_json, colour)
    if not as_json:
        print_diagnostics(found, colour)
    choice = choose(
        compiled.configuration, backends=backends, activities=activities, templates=templates, force=force
    )
    chosen = output or compiled.configuration.output
    choice = replace(choice, starts_files=False, replaces=chosen is None)
    check_choice(choice, backends, [chart.name for chart in compiled.system.iacs])
    if choice.agents.usual not in choice.backends:  # what the project builds makes no agents
        choice = replace(choice, backends=(*choice.backends, choice.agents.usual))
    folder = chosen or Path(OUTPUT)
    with progress_of(compiled.system.name) as told:
        report = build(compiled.system, folder, choice, told=told, certificates=compiled.certificates)
    if has_errors(report.diagnostics):
        return refuse(report.diagnostics, as_json, colour)
    if not as_json:
        print_diagnostics(report.diagnostics, colour)
        click.echo(f"{report.system} -> {report.folder}: {written_summary(report.written)}")
    folder = activities_folder(report.folder, choice)
    return report, compiled, choice, without_code(compiled.system, folder)


def lines_without_code(found: WithoutCode, target: str, output: Path | None) -> list[str]:
    """Which activities only last, why, and what starts their files."""
    lines = []
    if found.simulated:
        lines.append(f"simulated (declared): {', '.join(found.simulated)}")
    if found.missing:
        into = "" if output is None else f" -o {click.format_filename(output)}"
        command = f"`asemec build {click.format_filename(target)}{into}` creates stubs"
        lines.append(f"simulated (no code): {', '.join(found.missing)}; {command}")
    if found.empty:
        lines.append(f"simulated (empty stub): {', '.join(found.empty)}")
    return lines


def telling_of(
    loaded: Loaded,
    configuration: Configuration,
    quiet: bool,
    verbose: bool,
    colour: str,
    *,
    alone: str | None,
    progress: bool,
    stream: TextIO,
) -> Telling:
    """The output of a run in progress; the project's own output is enough."""
    from aseme_dsl.cli.telling import Telling

    told_by_project = configuration.run is not None and configuration.run.progress is not None
    return Telling(
        loaded,
        alone=alone,
        activities=not quiet and (verbose or not told_by_project),
        transitions=verbose and not quiet,
        progress=progress,
        colour=wants_colour(colour, sys.stderr),
        stream=stream,
    )


def ending_left_processes() -> AbstractContextManager[None]:
    """Kill what activities have started and left, when what is inside has ended, and note it."""
    from aseme_dsl.runtime.workers.descendants import ending_descendants

    return ending_descendants(lambda line: click.echo(f"note: {line}", err=True))
