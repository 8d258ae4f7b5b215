"""`asemec run`: build a system and play it."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.shared import (
    FilePath,
    check_backends,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    json_option,
    leave_at_once,
    one_system,
    print_diagnostics,
    print_json,
    wants_colour,
    written_summary,
)
from aseme_dsl.diagnostics import has_errors

INTERRUPTED = 130

if TYPE_CHECKING:
    from collections.abc import Iterable

    from aseme_dsl.build.build import Choice, Report
    from aseme_dsl.build.configuration import Configuration
    from aseme_dsl.build.play import Played
    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.diagnostics import Diagnostic
    from aseme_dsl.runtime.loading import Loaded


def _duration(context: click.Context, parameter: click.Parameter, value: str | None) -> int | None:
    from aseme_dsl.build.duration import duration

    try:
        return None if value is None else duration(value)
    except ValueError as problem:
        raise click.BadParameter(f"{problem}.") from problem


def _bodies(context: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> dict[str, str]:
    found: dict[str, str] = {}
    for value in values:
        agent, _, function = value.rpartition("=")
        if not _is_function(function):
            raise click.BadParameter(f"{value!r} is not [AGENT=]MODULE:FUNCTION.")
        if agent in found:
            raise click.BadParameter(f"two bodies for {agent or 'every agent'}.")
        found[agent] = function
    return found


def _world(context: click.Context, parameter: click.Parameter, value: str | None) -> str | None:
    if value is not None and not _is_function(value):
        raise click.BadParameter(f"{value!r} is not MODULE:FUNCTION.")
    return value


def _is_function(text: str) -> bool:
    module, _, name = text.partition(":")
    return name.isidentifier() and all(part.isidentifier() for part in module.split("."))


@click.command(
    short_help="Build a system and play it.",
    help="Build a system and play its team, in virtual time unless --real is given. TARGET is a file; or a"
    " project's folder, which is played as its pyproject.toml says; or the output folder of a build, whose"
    " plans are played as they are. Models, diagrams, Python and a trace are left in the output folder.",
    epilog="Example: asemec run team.aseme --for 30s   ·   asemec run out --plan player --real",
)
@click.argument("target", type=FilePath())
@folder_option("-o", "--output", text="Where to build.  [default: the project's, else out]")
@click.option("--plan", metavar="ROLE", help="Play one plan alone: ROLE, or SYSTEM.ROLE.")
@click.option("--agent", metavar="NAME", help="What the agent of --plan is called.")
@click.option("--list", "list_", is_flag=True, help="Play nothing; list the plans that there are.")
@click.option(
    "--for",
    "duration",
    metavar="DURATION",
    callback=_duration,
    help="How long to play, such as 90s or 2min.  [default: the project's, else 60s; with --real, no limit]",
)
@click.option("--seed", type=int, help="Where chance begins.  [default: the project's, else 1]")
@click.option("--real", is_flag=True, help="Play in real time.")
@click.option(
    "--input",
    "script",
    type=FilePath(path_type=Path),
    metavar="FILE.jsonl",
    help='What to give the agents, a line each: {"at": "1s", "channel": "vision.state.Ball", "message": {}}.',
)
@click.option(
    "--trace",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Where the trace goes.  [default: the project's, else OUTPUT/trace.jsonl]",
)
@folder_option(
    "--activities", text="Where your activities are.  [default: the project's, else OUTPUT/monas/activities]"
)
@folder_option("--templates", text="A folder of templates that replace the backend's own, by name.")
@click.option(
    "--world", metavar="MODULE:FUNCTION", callback=_world, help="Makes the simulated world to play in."
)
@click.option(
    "--body",
    "bodies",
    multiple=True,
    metavar="[AGENT=]MODULE:FUNCTION",
    callback=_bodies,
    help="Makes the body of an agent, or of all. May be repeated.",
)
@click.option("--force", is_flag=True, help="Overwrite files that asemec did not write, or that were edited.")
@click.option("-q", "--quiet", is_flag=True, help="Say nothing while it plays.")
@click.option("-v", "--verbose", is_flag=True, help="Say every transition and activity while it plays.")
@json_option
@colour_option
def command(
    target: str,
    output: Path | None,
    plan: str | None,
    agent: str | None,
    list_: bool,
    duration: int | None,
    seed: int | None,
    real: bool,
    script: Path | None,
    trace: Path | None,
    activities: Path | None,
    templates: Path | None,
    world: str | None,
    bodies: dict[str, str],
    force: bool,
    quiet: bool,
    verbose: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Play; 1 if the file has errors, it cannot be played, or an agent fails."""
    from aseme_dsl.build.build import activities_folder, choose
    from aseme_dsl.build.configuration import find_configuration
    from aseme_dsl.build.play import NoSuchPlan, PlayError, Request, carried, is_output, load, play, select
    from aseme_dsl.cli.telling import Telling

    report: Report | None = None
    try:
        if is_output(Path(target)):
            folder = Path(target)
            configuration, problems = find_configuration(folder)
            if has_errors(problems):
                return _refuse(problems, as_json, colour)
            systems = carried(folder, configuration)
            choice = choose(configuration, activities=activities)
        else:
            built = _build(target, output, activities, templates, force, as_json, colour)
            if isinstance(built, int):
                return built
            report, configuration, choice = built
            folder = report.folder
            systems = (load(folder, report.system, configuration),)
        if list_:
            return _list(systems, as_json)
        loaded, plan = select(systems, plan)
        if configuration.run is None or configuration.run.trace is None:
            trace = trace or folder / "trace.jsonl"
        request = Request(plan, agent, duration, seed, real, script, trace, world, bodies)
        telling = Telling(
            loaded,
            alone=plan,
            # What the project tells by itself is enough.
            activities=not quiet
            and (verbose or configuration.run is None or configuration.run.progress is None),
            transitions=verbose and not quiet,
            progress=not quiet,
            colour=wants_colour(colour, sys.stderr),
            stream=sys.stderr if as_json else sys.stdout,
        )
        played = play(
            loaded,
            activities_folder(folder, choice),
            configuration,
            request,
            tell=telling.line,
            listeners=(telling,),
            tick=telling.tick,
        )
    except PlayError as problem:
        if as_json:
            print_json({"result": None, "problem": str(problem), **diagnostics_json(())})
        if isinstance(problem, NoSuchPlan):
            raise click.UsageError(f"{problem}.") from problem
        raise click.ClickException(str(problem)) from problem
    telling.end()
    code = _print(played, loaded, report, folder, telling, as_json)
    if played.result.left:
        leave_at_once(code)
    return code


def _build(
    target: str,
    output: Path | None,
    activities: Path | None,
    templates: Path | None,
    force: bool,
    as_json: bool,
    colour: str,
) -> tuple[Report, Configuration, Choice] | int:
    """Build the one system that the target means; or the exit code, after saying what is wrong."""
    from aseme_dsl.build.build import build, choose
    from aseme_dsl.build.configuration import OUTPUT
    from aseme_dsl.diagnostics import Severity

    compiled = one_system(target)
    # Notes are about what is still to be written: `check` and `build` say them.
    found = tuple(item for item in compiled.diagnostics if item.severity is not Severity.NOTE)
    if compiled.system is None:
        return _refuse(found, as_json, colour)
    if not as_json:
        print_diagnostics(found, colour)
    choice = choose(compiled.configuration, activities=activities, templates=templates, force=force)
    check_backends(choice.backends)
    report = build(compiled.system, output or compiled.configuration.output or Path(OUTPUT), choice)
    if has_errors(report.diagnostics):
        return _refuse(report.diagnostics, as_json, colour)
    if not as_json:
        print_diagnostics(report.diagnostics, colour)
        click.echo(f"{report.system} -> {report.folder}: {written_summary(report.written)}")
    return report, compiled.configuration, choice


def _refuse(found: Iterable[Diagnostic], as_json: bool, colour: str) -> int:
    if as_json:
        print_json({"result": None, **diagnostics_json(found)})
    else:
        print_diagnostics(found, colour)
    return 1


def _list(systems: Iterable[Loaded], as_json: bool) -> int:
    """The plans that are carried, as registered."""
    rows: list[dict[str, Any]] = [
        {
            "plan": f"{plan.system}.{plan.name}",
            "states": len(plan.states),
            "transitions": len(plan.transitions),
            "model": plan.model,
            "agents": [name for name, role in loaded.team if role == plan.name],
        }
        for loaded in systems
        for plan in loaded.plans
    ]
    if as_json:
        print_json({"plans": rows})
        return 0
    width = max((len(str(row["plan"])) for row in rows), default=0)
    for row in rows:
        agents = ", ".join(row["agents"]) or "no agent of a team"
        size = f"{row['states']:4} states {row['transitions']:4} transitions"
        click.echo(f"{row['plan']:<{width}}  {size}  model {row['model']}  {agents}")
    return 0


def _print(
    played: Played, loaded: Loaded, report: Report | None, folder: Path, telling: Telling, as_json: bool
) -> int:
    """How it ended, and what is left behind; the exit code."""
    from dataclasses import asdict

    result = played.result
    failed = result.failed or result.trace_error is not None
    code = INTERRUPTED if result.reason == "interrupted" else int(failed)
    if as_json:
        print_json(
            {
                "result": {
                    "system": loaded.name,
                    "reason": result.reason,
                    "time": result.time,
                    "seed": played.seed,
                    "agents": [asdict(agent) for agent in result.agents],
                    "faults": telling.faults,
                    "summary": played.summary,
                    "folder": str(folder),
                    "trace": str(played.trace),
                    "trace_error": result.trace_error,
                    "count": asdict(report.count) if report is not None and report.count else None,
                },
                **diagnostics_json(()),
            }
        )
        return code
    if played.summary:
        click.echo(played.summary)
    reason = _REASONS.get(result.reason, result.reason)
    if result.reason == "finished" and result.failed:
        reason = "all agents have ended, not all of them well"
    click.echo(f"played {result.time / 1e9:g} s with seed {played.seed}: {reason}")
    for agent in result.agents:
        if agent.failure is not None:
            place = f" ({agent.at})" if agent.at else ""
            click.echo(f"  {agent.name} ({agent.role}) failed: {agent.failure}{place}", err=True)
        elif agent.finished:
            click.echo(f"  {agent.name} ({agent.role}) has finished")
    if result.trace_error is not None:
        click.echo(f"  {result.trace_error}", err=True)
    else:
        click.echo(f"  trace: {played.trace}")
    if report is not None:
        click.echo(f"  models, diagrams and code: {folder}")
        for line in count_lines(report.count):
            click.echo(f"  {line}")
    return code


_REASONS = {
    "finished": "all agents have finished",
    "time": "the time is over",
    "idle": "nothing would happen any more",
    "interrupted": "stopped",
}
