"""`asemec run`: build and run a system."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.playing import (
    INTERRUPTED,
    body_option,
    build_target,
    duration_option,
    ending_left_processes,
    input_option,
    is_function,
    lines_without_code,
    platform_option,
    seed_option,
    state_option,
    telling_options,
    trace_option,
)
from aseme_dsl.cli.run_end import allow_option, end_data, end_lines, exit_code
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    Refused,
    WronglyUsed,
    activities_option,
    check_choice,
    check_outputs,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    given_options,
    json_option,
    leave_at_once,
    play_backend_option,
    print_json,
    refuse,
    refuse_options,
    stats_option,
    target_argument,
    wants_colour,
)
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.diagnostics.problems.running import (
    AgentWithoutRole,
    OnOutputOfTarget,
    OnOutputWithoutBackend,
    OptionWithoutEffect,
    WithList,
    WithProcesses,
    WithQuiet,
)
from aseme_dsl.project.settings.platform_settings import IN_PROCESS, PLATFORMS, ZENOH

if TYPE_CHECKING:
    from collections.abc import Iterable

    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import Report
    from aseme_dsl.project.code.activity_files import WithoutCode
    from aseme_dsl.project.playing.play import Played, Request
    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.version.loading import Loaded


def _world(context: click.Context, parameter: click.Parameter, value: str | None) -> str | None:
    if value is not None and not is_function(value):
        raise click.BadParameter(f"{value!r} does not have the form MODULE:FUNCTION.")
    return value


@click.command(
    short_help="Build and run a system.",
    help="Build a system and run its team, in virtual time unless --real is given. Models, diagrams, Python"
    " code and a trace are written to the output directory. Defaults come from [tool.asemec.run] of the"
    f" project. An output directory is run as it is, without a build. {TARGET_HELP}",
    epilog="Example: asemec run team.aseme --for 30s   ·   asemec run out --role player --real",
)
@target_argument
@folder_option("-o", "--output", text="Output directory.  [default: the project's, else out]")
@click.option("--role", "plan", metavar="ROLE", help="Run only this role (ROLE or SYSTEM.ROLE).")
@click.option("--agent", metavar="NAME", help="Name of the agent that runs --role.")
@click.option("--list", "list_", is_flag=True, help="List the compiled roles and exit.")
@duration_option("Time limit, such as 90s or 2min.  [default: the project's, else 60s; none with --real]")
@seed_option
@click.option("--real", is_flag=True, help="Run in real time.")
@click.option("--team", is_flag=True, help="Run the whole team (the default).")
@click.option(
    "--process-per-agent", is_flag=True, help="Run in real time, each agent in a process of its own."
)
@platform_option(
    "Transport of the messages in real time. spade and mango admit external agents.  [default: the project's,"
    " else zenoh with --process-per-agent and in_process with --real]",
    PLATFORMS,
)
@input_option(
    "JSON Lines file of timed messages and events:"
    ' {"at": "1s", "channel": "vision.state.Ball", "message": {}}.'
)
@trace_option("Trace file.  [default: the project's, else OUTPUT/trace.jsonl]")
@state_option
@activities_option
@folder_option("--templates", text="Directory of templates that override the backend's, by file name.")
@click.option(
    "--world", metavar="MODULE:FUNCTION", callback=_world, help="Factory function of the simulated world."
)
@play_backend_option
@body_option("Factory function of the body, for AGENT or all agents. Repeatable.")
@click.option("--force", is_flag=True, help="Overwrite edited files and files that asemec did not write.")
@allow_option
@stats_option
@telling_options
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
    team: bool,
    process_per_agent: bool,
    platform: str | None,
    script: Path | None,
    trace: Path | None,
    state: Path | None,
    activities: Path | None,
    templates: Path | None,
    world: str | None,
    backends: tuple[str, ...],
    bodies: dict[str, str],
    force: bool,
    allowed: tuple[str, ...],
    quiet: bool,
    verbose: bool,
    stats: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Run; 1 if the file has errors, it cannot be run, or an agent fails or is in a deadlock."""
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.play import (
        NoSuchPlan,
        PlayError,
        Request,
        carried,
        is_output,
        load,
        play,
        select,
    )
    from aseme_dsl.project.settings.configuration import find_configuration

    if plan is not None and (team or process_per_agent):
        raise click.UsageError("--role runs one role: not with --team or --process-per-agent.")
    if plan is not None and platform not in (None, IN_PROCESS):
        raise click.UsageError("--role runs one role in this process: not with --platform.")
    if process_per_agent and platform == IN_PROCESS:
        raise click.UsageError("--process-per-agent needs a transport between processes, such as zenoh.")
    if trace is not None:
        check_outputs([(trace, "trace")], [target, *([script] if script is not None else [])])
    report: Report | None = None
    bare: WithoutCode | None = None
    played_as_it_is = is_output(Path(target))
    unused: list[OptionWithoutEffect] = []
    if agent is not None and plan is None and not list_:
        unused.append(AgentWithoutRole("--agent"))
    if list_:
        unused += [WithList(option) for option in given_options() if option not in _LISTED]
    elif quiet and verbose:
        unused.append(WithQuiet("--verbose"))
    if played_as_it_is:
        given = {"-o": output, "--templates": templates, "--force": force or None, "--stats": stats or None}
        unused += [OnOutputOfTarget(option) for option, value in given.items() if value is not None]
        for name in dict.fromkeys(item.rpartition("=")[2] for item in backends):
            if name in AGENTS and not (Path(target) / name).is_dir():
                unused.append(OnOutputWithoutBackend(f"--backend {name}", name))
    if code := refuse_options(unused, target, as_json, colour):
        return code
    try:
        if played_as_it_is:
            folder = Path(target)
            configuration, problems = find_configuration(folder)
            if has_errors(problems):
                return refuse(problems, as_json, colour)
            choice = choose(configuration, backends=backends, activities=activities)
            systems = carried(folder, configuration, choice)
            check_choice(choice, backends, [role for item in systems for role in item.charts])
        else:
            built = build_target(target, output, activities, templates, force, as_json, colour, backends)
            if isinstance(built, int):
                return built
            report, configuration, choice, bare = built
            folder = report.folder
            systems = (load(folder, report.system, configuration, choice),)
        if list_:
            return _list(systems, as_json)
        if trace is None and configuration.run is not None and configuration.run.trace is not None:
            check_outputs([(configuration.run.trace, "trace")])
        loaded, plan = select(systems, plan)
        if platform is None and plan is None and (real or process_per_agent):
            platform = configuration.platform
        if platform == ZENOH or process_per_agent:
            if allowed:
                return refuse_options([WithProcesses("--allow")], target, as_json, colour)
            if not quiet and not as_json and bare is not None:
                for line in lines_without_code(bare, target, output):
                    click.echo(line)
            request = Request(
                duration=duration,
                seed=seed,
                trace=trace,
                world=world,
                bodies=bodies,
                platform=platform if platform != IN_PROCESS else None,
            )
            options = _options_of_robots(
                configuration, duration, seed, script, state, backends, bodies, quiet, verbose, colour
            )
            place = activities_folder(folder, choice)
            code = _supervise(loaded, folder, place, configuration, request, options, quiet, as_json)
            if stats and report is not None and not as_json:
                for line in count_lines(report.count):
                    click.echo(line)
            return code
        if configuration.run is None or configuration.run.trace is None:
            trace = trace or folder / "trace.jsonl"
        real = real or platform not in (None, IN_PROCESS)
        request = Request(
            plan, agent, duration, seed, real, script, trace, world, bodies, state=state, platform=platform
        )
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
        with ending_left_processes():
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
        found = problem.problems(target)
        if as_json:
            print_json({"result": None, "problem": str(problem), **diagnostics_json(found)})
        refused = WronglyUsed if isinstance(problem, NoSuchPlan) else Refused
        raise refused(found, colour) from problem
    telling.end()
    code = exit_code(played.result, allowed, INTERRUPTED)
    _print(played, loaded, report, folder, telling, as_json, bare, target, output, real, stats)
    if played.result.left:
        leave_at_once(code)
    return code


def _options_of_robots(
    configuration: Configuration,
    duration: int | None,
    seed: int | None,
    script: Path | None,
    state: Path | None,
    backends: tuple[str, ...],
    bodies: dict[str, str],
    quiet: bool,
    verbose: bool,
    colour: str,
) -> list[str]:
    """What is passed on to the process of each robot."""
    options = ["--color", colour]
    if duration is not None:
        options += ["--for", f"{duration // 1_000_000}.{duration % 1_000_000:06}ms"]
    if seed is not None:
        options += ["--seed", str(seed)]
    if script is not None:
        options += ["--input", str(script.absolute())]
    if state is not None:
        options += ["--state", str(state.absolute())]
    for backend in backends:
        options += ["--backend", backend]
    for agent, function in bodies.items():
        options += ["--body", f"{agent}={function}" if agent else function]
    return options + ["-q"] * quiet + ["-v"] * verbose


def _supervise(
    loaded: Loaded,
    folder: Path,
    activities: Path,
    configuration: Configuration,
    request: Request,
    options: list[str],
    quiet: bool,
    as_json: bool,
) -> int:
    """Play with a process for each robot, and say how it ended; the exit code."""
    from aseme_dsl.project.playing.supervisor import supervise

    width = max((len(name) for name, _ in loaded.team), default=0)

    def say(name: str, line: str, wrong: bool) -> None:
        if wrong or not quiet:
            click.echo(f"{name:<{width}} | {line}" if name else line, err=wrong or as_json)

    with ending_left_processes():
        ended = supervise(loaded, folder, activities, configuration, request, options, say)
    code = INTERRUPTED if ended.reason == "interrupted" else int(ended.failed)
    if as_json:
        robots = [
            {
                "name": robot.name,
                "code": robot.code,
                "starts": robot.starts,
                "traces": [str(path) for path in robot.traces],
                "end": robot.end.get("result"),
            }
            for robot in ended.robots
        ]
        result = {"system": loaded.name, "reason": ended.reason, "robots": robots, "folder": str(folder)}
        print_json({"result": result, **diagnostics_json(())})
        return code
    processes = f"({count_processes(len(ended.robots))})"
    click.echo(_end_of(ended.reason, processes, sum(bool(robot.code) for robot in ended.robots)))
    for robot in ended.robots:
        starts = f", started {robot.starts} times" if robot.starts > 1 else ""
        click.echo(f"  {robot.name}{starts}  trace: {', '.join(map(str, robot.traces))}")
        for line in robot.end.get("lines", ()):
            click.echo(f"    {line}")
    return code


def count_processes(robots: int) -> str:
    """`1 process`, `4 processes`."""
    return "1 process" if robots == 1 else f"{robots} processes"


def _list(systems: Iterable[Loaded], as_json: bool) -> int:
    """The compiled roles, as registered."""
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
        agents = ", ".join(row["agents"]) or "no agent"
        size = f"{row['states']:4} states {row['transitions']:4} transitions"
        click.echo(f"{row['plan']:<{width}}  {size}  model {row['model']}  {agents}")
    return 0


def _print(
    played: Played,
    loaded: Loaded,
    report: Report | None,
    folder: Path,
    telling: Telling,
    as_json: bool,
    bare: WithoutCode | None,
    target: str,
    output: Path | None,
    real: bool,
    stats: bool,
) -> None:
    """How it ended, and what is left behind."""
    from dataclasses import asdict

    result = played.result
    if as_json:
        print_json(
            {
                "result": {
                    "system": loaded.name,
                    "reason": result.reason,
                    "time": result.end_ns,
                    "seed": played.seed,
                    "agents": [asdict(agent) for agent in result.agents],
                    "faults": telling.faults,
                    **end_data(result),
                    "untaken": telling.untaken,
                    "unexpected": telling.unexpected,
                    "summary": played.summary,
                    "folder": str(folder),
                    "trace": str(played.trace),
                    "trace_error": result.trace_error,
                    "without_code": asdict(bare) if bare is not None else None,
                    "count": asdict(report.count) if report is not None and report.count else None,
                },
                **diagnostics_json(()),
            }
        )
        return
    if played.summary:
        click.echo(played.summary)
    clock = "real time" if real else "virtual"
    length = f"after {result.end_ns / 1e9:g} s ({clock}, seed {played.seed})"
    failed = sum(agent.failure is not None for agent in result.agents)
    click.echo(_end_of(result.reason, length, failed))
    for agent in result.agents:
        if agent.failure is not None:
            place = f" ({agent.at})" if agent.at else ""
            click.echo(f"  {agent.name} ({agent.role}) failed: {agent.failure}{place}", err=True)
        elif agent.finished:
            click.echo(f"  {agent.name} ({agent.role}) completed")
    for line in end_lines(result):
        click.echo(f"  {line}")
    for line in lines_without_code(bare, target, output) if bare is not None else ():
        click.echo(f"  {line}")
    if result.trace_error is not None:
        click.echo(f"  {result.trace_error}", err=True)
    else:
        click.echo(f"  trace: {played.trace}")
    if report is not None:
        click.echo(f"  models, diagrams and code: {folder}")
        for line in count_lines(report.count) if stats else ():
            click.echo(f"  {line}")


_LISTED = frozenset(
    "TARGET --list --output --templates --backend --activities --force --json --color".split()
)
"""What has an effect on the list of plans: which they are, and how they are said."""


def _end_of(reason: str, how: str, failed: int) -> str:
    """`finished after 25 s (virtual, seed 1): all agents completed`; `how` is the part in the middle."""
    if reason == "finished":
        return f"finished {how}: all agents {f'ended; {failed} failed' if failed else 'completed'}"
    return f"stopped {how}: {_REASONS.get(reason, reason)}"


_REASONS = {
    "time": "time limit reached",
    "idle": "no pending inputs, timers or activities",
    "interrupted": "interrupted",
}
"""Why a run stopped before its agents completed."""
