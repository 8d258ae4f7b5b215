"""`asemec run`: build and run a system."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

import click

from aseme_dsl.cli.playing import (
    INTERRUPTED,
    body_option,
    build_target,
    duration_option,
    ending_left_processes,
    function_of,
    input_option,
    lines_without_code,
    network_of,
    network_option,
    platform_option,
    seed_option,
    state_option,
    telling_of,
    telling_options,
    trace_option,
)
from aseme_dsl.cli.run_end import (
    allow_option,
    end_data,
    end_lines,
    exit_code,
    watched_data,
    watched_lines,
)
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    WRONG_USE,
    Refused,
    WronglyUsed,
    activities_option,
    check_choice,
    check_outputs,
    colour_option,
    count_lines,
    diagnostics_json,
    folder_option,
    gathered,
    given_options,
    json_option,
    leave_at_once,
    play_backend_option,
    print_diagnostics,
    print_json,
    refuse,
    refuse_options,
    stats_option,
    target_argument,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.diagnostics.problems.running import (
    AgentWithoutRole,
    NetworkOfOneAgent,
    OnOutputOfTarget,
    OnOutputWithoutBackend,
    OptionWithoutEffect,
    WithList,
    WithProcesses,
    WithQuiet,
)
from aseme_dsl.diagnostics.problems.scenarios.network import NetworkInRealTime, NetworkNotSimulated
from aseme_dsl.project.settings.platform_settings import IN_PROCESS, PLATFORMS, ZENOH
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import Choice, Report
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.code.activity_files import WithoutCode
    from aseme_dsl.project.playing.play import Played, Request
    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.project.testing.watching import Watch, Watched
    from aseme_dsl.runtime.version.loading import Loaded


@dataclass(frozen=True, slots=True)
class _Options:
    """What is on the command line."""

    target: str
    output: Path | None
    plan: str | None
    agent: str | None
    list_: bool
    duration: int | None
    seed: int | None
    real: bool
    team: bool
    process_per_agent: bool
    platform: str | None
    network_words: str | None
    script: Path | None
    trace: Path | None
    state: Path | None
    activities: Path | None
    templates: Path | None
    world: str | None
    backends: tuple[str, ...]
    bodies: dict[str, str]
    force: bool
    allowed: tuple[str, ...]
    strict: bool
    quiet: bool
    verbose: bool
    stats: bool
    as_json: bool
    colour: str


@dataclass(frozen=True, slots=True)
class _Prepared:
    """What is to be run, and what has been built for it."""

    systems: tuple[Loaded, ...]
    folder: Path
    configuration: Configuration
    choice: Choice
    report: Report | None
    bare: WithoutCode | None
    compiled: Compiled | None = None
    """The source, if it was built from that."""


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
@network_option(
    "Simulated network in virtual time, such as delay=0..300ms,loss=10%,reorder.  [default: the project's,"
    " else no delay]"
)
@input_option(
    "JSON Lines file of timed messages and events:"
    ' {"at": "1s", "channel": "vision.state.Ball", "message": {}}.'
)
@trace_option("Trace file.  [default: the project's, else OUTPUT/trace.jsonl.gz]")
@state_option
@activities_option
@folder_option("--templates", text="Directory of templates that override the backend's, by file name.")
@click.option(
    "--world",
    metavar="MODULE:FUNCTION",
    callback=function_of,
    help="Factory function of the simulated world.",
)
@play_backend_option
@body_option("Factory function of the body, for AGENT or all agents. Repeatable.")
@click.option("--force", is_flag=True, help="Overwrite edited files and files that asemec did not write.")
@allow_option
@click.option("--strict", is_flag=True, help="End the run when a property or a clause is broken.")
@stats_option
@telling_options
@json_option
@colour_option
@gathered(_Options)
def command(options: _Options) -> int:
    """Run; 1 if the file has errors, it cannot be run, or an agent fails, is idle or in a deadlock."""
    _check_usage(options)
    if code := refuse_options(_without_effect(options), options.target, options.as_json, options.colour):
        return code
    if wrong := _wrong_network(options):
        refuse(wrong, options.as_json, options.colour)
        return WRONG_USE
    from aseme_dsl.project.playing.play import NoSuchPlan, PlayError

    try:
        prepared = _prepared(options)
        return prepared if isinstance(prepared, int) else _run(options, prepared)
    except PlayError as problem:
        found = problem.problems(options.target)
        if options.as_json:
            print_json({"result": None, "problem": str(problem), **diagnostics_json(found)})
        refused = WronglyUsed if isinstance(problem, NoSuchPlan) else Refused
        raise refused(found, options.colour) from problem


def _check_usage(options: _Options) -> None:
    """Refuse, as wrong use, options that exclude each other, and a trace that would overwrite something."""
    plan, platform = options.plan, options.platform
    if plan is not None and (options.team or options.process_per_agent):
        raise click.UsageError("--role runs one role: not with --team or --process-per-agent.")
    if plan is not None and platform not in (None, IN_PROCESS):
        raise click.UsageError("--role runs one role in this process: not with --platform.")
    if options.process_per_agent and platform == IN_PROCESS:
        raise click.UsageError("--process-per-agent needs a transport between processes, such as zenoh.")
    if options.trace is not None:
        inputs: list[Path | str] = [options.target, *([options.script] if options.script is not None else [])]
        check_outputs([(options.trace, "trace")], inputs)


def _without_effect(options: _Options) -> list[OptionWithoutEffect]:
    """The options that would be ignored."""
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.project.playing.play import is_output

    unused: list[OptionWithoutEffect] = []
    if options.agent is not None and options.plan is None and not options.list_:
        unused.append(AgentWithoutRole("--agent"))
    if options.network_words is not None and options.plan is not None and not options.list_:
        unused.append(NetworkOfOneAgent("--network"))
    if options.list_:
        unused += [WithList(option) for option in given_options() if option not in _LISTED]
    elif options.quiet and options.verbose:
        unused.append(WithQuiet("--verbose"))
    if is_output(Path(options.target)):
        given = {
            "-o": options.output,
            "--templates": options.templates,
            "--force": options.force or None,
            "--stats": options.stats or None,
        }
        unused += [OnOutputOfTarget(option) for option, value in given.items() if value is not None]
        for name in dict.fromkeys(item.rpartition("=")[2] for item in options.backends):
            if name in AGENTS and not (Path(options.target) / name).is_dir():
                unused.append(OnOutputWithoutBackend(f"--backend {name}", name))
    return unused


def _wrong_network(options: _Options) -> list[Diagnostic]:
    """What is wrong with the simulated network."""
    network, wrong = network_of(options.network_words)
    in_real_time = _real_time_option(options)
    if network is not None and in_real_time is not None:
        return [Diagnostic(NetworkInRealTime(in_real_time), None, path=options.target)]
    return wrong


def _real_time_option(options: _Options) -> str | None:
    """The option that asks for real time, if one does."""
    if options.real:
        return "--real"
    if options.process_per_agent:
        return "--process-per-agent"
    return f"--platform {options.platform}" if options.platform not in (None, IN_PROCESS) else None


def _not_simulated(configuration: Configuration) -> list[Diagnostic]:
    """That the project's network is not simulated in real time."""
    from aseme_dsl.project.settings.configuration import places_of_run

    if configuration.run is None or configuration.run.network is None:
        return []
    problem = NetworkNotSimulated(str(configuration.run.network))
    place = places_of_run(configuration, ["network"]).get("network")
    return [Diagnostic(problem, place, path=str(configuration.path))]


def _prepared(options: _Options) -> _Prepared | int:
    """The systems of an output folder, or that which is built; or the exit code, after telling why."""
    from aseme_dsl.project.building.build import choose
    from aseme_dsl.project.playing.play import carried, is_output, load
    from aseme_dsl.project.settings.configuration import find_configuration

    folder = Path(options.target)
    if is_output(folder):
        configuration, problems = find_configuration(folder)
        if has_errors(problems):
            return refuse(problems, options.as_json, options.colour)
        choice = choose(configuration, backends=options.backends, activities=options.activities)
        systems = carried(folder, configuration, choice)
        check_choice(choice, options.backends, [role for item in systems for role in item.charts])
        return _Prepared(systems, folder, configuration, choice, None, None)
    built = build_target(
        options.target,
        options.output,
        options.activities,
        options.templates,
        options.force,
        options.as_json,
        options.colour,
        options.backends,
    )
    if isinstance(built, int):
        return built
    report, compiled, choice, bare = built
    configuration = compiled.configuration
    system = load(report.folder, report.system, configuration, choice)
    return _Prepared((system,), report.folder, configuration, choice, report, bare, compiled)


def _run(options: _Options, prepared: _Prepared) -> int:
    """List the roles, or run them in this process or in one for each agent; the exit code."""
    from aseme_dsl.project.playing.play import select

    if options.list_:
        return _list(prepared.systems, options.as_json)
    run = prepared.configuration.run
    if options.trace is None and run is not None and run.trace is not None:
        check_outputs([(run.trace, "trace")])
    loaded, plan = select(prepared.systems, options.plan)
    if _real_time_option(options) is not None and not options.as_json:
        print_diagnostics(_not_simulated(prepared.configuration), options.colour)
    platform = options.platform
    if platform is None and plan is None and (options.real or options.process_per_agent):
        platform = prepared.configuration.platform
    if platform == ZENOH or options.process_per_agent:
        return _run_processes(options, prepared, loaded, platform)
    return _run_here(options, prepared, loaded, plan, platform)


def _run_processes(options: _Options, prepared: _Prepared, loaded: Loaded, platform: str | None) -> int:
    """Run each agent in a process of its own; the exit code."""
    from aseme_dsl.project.building.build import activities_folder
    from aseme_dsl.project.playing.play import Request

    if options.allowed:
        return refuse_options([WithProcesses("--allow")], options.target, options.as_json, options.colour)
    if not options.quiet and not options.as_json and prepared.bare is not None:
        for line in lines_without_code(prepared.bare, options.target, options.output):
            click.echo(line)
    request = Request(
        duration=options.duration,
        seed=options.seed,
        trace=options.trace,
        world=options.world,
        bodies=options.bodies,
        platform=platform if platform != IN_PROCESS else None,
    )
    place = activities_folder(prepared.folder, prepared.choice)
    watch = _watch(options, prepared, loaded, None, True, lambda line: click.echo(line, err=options.as_json))
    code = _supervise(
        loaded,
        prepared.folder,
        place,
        prepared.configuration,
        request,
        _options_of_robots(options),
        watch,
        options.quiet,
        options.as_json,
    )
    if options.stats and prepared.report is not None and not options.as_json:
        for line in count_lines(prepared.report.count):
            click.echo(line)
    return code


def _run_here(
    options: _Options, prepared: _Prepared, loaded: Loaded, plan: str | None, platform: str | None
) -> int:
    """Run all agents in this process; the exit code."""
    from aseme_dsl.project.building.build import activities_folder
    from aseme_dsl.project.playing.play import Request, play
    from aseme_dsl.runtime.trace.trace_files import USUAL

    configuration, trace = prepared.configuration, options.trace
    if configuration.run is None or configuration.run.trace is None:
        trace = trace or prepared.folder / USUAL
    real = options.real or platform not in (None, IN_PROCESS)
    request = Request(
        plan,
        options.agent,
        options.duration,
        options.seed,
        real,
        options.script,
        trace,
        options.world,
        options.bodies,
        state=options.state,
        platform=platform,
        network=network_of(options.network_words)[0],
    )
    telling = telling_of(
        loaded,
        configuration,
        options.quiet,
        options.verbose,
        options.colour,
        alone=plan,
        progress=not options.quiet,
        stream=sys.stderr if options.as_json else sys.stdout,
    )
    watch = _watch(options, prepared, loaded, plan, real, telling.line)
    with ending_left_processes():
        played = play(
            loaded,
            activities_folder(prepared.folder, prepared.choice),
            configuration,
            request,
            tell=telling.line,
            listeners=(telling,),
            tick=telling.tick,
            watch=watch,
        )
    telling.end()
    watched = () if watch is None else watch.end()
    code = exit_code(played.result, options.allowed, INTERRUPTED)
    if code == 0 and any(item.verdict == "broken" for item in watched):
        code = 1
    _print(options, prepared, played, loaded, telling, real, watched)
    if played.result.left:
        leave_at_once(code)
    return code


def _watch(
    options: _Options,
    prepared: _Prepared,
    loaded: Loaded,
    plan: str | None,
    real: bool,
    tell: Callable[[str], None],
) -> Watch | None:
    """What watches the properties and clauses of the system; None, and told, if nothing can."""
    from aseme_dsl.play.scenario import Refused
    from aseme_dsl.project.testing.watching import Watch, script_of

    team = dict(loaded.team)
    if plan is not None:
        usual = next((name for name, role in loaded.team if role == plan), plan)
        team = {options.agent or usual: plan}
    root = None if prepared.compiled is None else prepared.compiled.root
    script = script_of(loaded, root, prepared.configuration, team or {name: name for name in loaded.charts})
    if script is None:
        return None
    if isinstance(script, Refused):
        tell(f"properties and clauses are not watched: {script.span}: {script.reason}")
        return None
    return Watch(script, tell, options.strict, loaded.plans if real else None)


def _options_of_robots(options: _Options) -> list[str]:
    """What is passed on to the process of each robot."""
    found = ["--color", options.colour]
    if options.duration is not None:
        found += ["--for", f"{options.duration // 1_000_000}.{options.duration % 1_000_000:06}ms"]
    if options.seed is not None:
        found += ["--seed", str(options.seed)]
    if options.script is not None:
        found += ["--input", str(options.script.absolute())]
    if options.state is not None:
        found += ["--state", str(options.state.absolute())]
    for backend in options.backends:
        found += ["--backend", backend]
    for agent, function in options.bodies.items():
        found += ["--body", f"{agent}={function}" if agent else function]
    return found + ["-q"] * options.quiet + ["-v"] * options.verbose


def _supervise(
    loaded: Loaded,
    folder: Path,
    activities: Path,
    configuration: Configuration,
    request: Request,
    options: list[str],
    watch: Watch | None,
    quiet: bool,
    as_json: bool,
) -> int:
    """Play with a process for each robot, and say how it ended; the exit code."""
    from aseme_dsl.project.playing.supervisor import supervise
    from aseme_dsl.runtime.version.loading import importing

    width = max((len(name) for name, _ in loaded.team), default=0)

    def say(name: str, line: str, wrong: bool) -> None:
        if wrong or not quiet:
            click.echo(f"{name:<{width}} | {line}" if name else line, err=wrong or as_json)

    # The functions of the document, which properties may call, are looked for in the project.
    with ending_left_processes(), importing([configuration.folder.resolve(), *loaded.path]):
        ended = supervise(loaded, folder, activities, configuration, request, options, say, watch)
    watched = () if watch is None else watch.end()
    is_broken = any(item.verdict == "broken" for item in watched)
    code = INTERRUPTED if ended.reason == "interrupted" else int(ended.failed or is_broken)
    if as_json:
        robots = [
            {
                "name": robot.name,
                "code": robot.code,
                "starts": robot.starts,
                "traces": [str(path) for path in robot.traces],
                "end": robot.end.result,
            }
            for robot in ended.robots
        ]
        result = {
            "system": loaded.name,
            "reason": ended.reason,
            "robots": robots,
            "watched": watched_data(watched),
            "folder": str(folder),
        }
        print_json({"result": result, **diagnostics_json(())})
        return code
    processes = f"({count_processes(len(ended.robots))})"
    click.echo(_end_of(ended.reason, processes, sum(bool(robot.code) for robot in ended.robots)))
    for robot in ended.robots:
        starts = f", started {robot.starts} times" if robot.starts > 1 else ""
        click.echo(f"  {robot.name}{starts}  trace: {', '.join(map(str, robot.traces))}")
        for line in robot.end.lines:
            click.echo(f"    {line}")
    for line in watched_lines(watched):
        click.echo(f"  {line}")
    return code


def count_processes(robots: int) -> str:
    """`1 process`, `4 processes`."""
    return "1 process" if robots == 1 else f"{robots} processes"


class _Compiled(TypedDict):
    """A compiled role and its agents, as `--list` shows it."""

    plan: str
    states: int
    transitions: int
    model: str
    agents: list[str]


def _list(systems: Iterable[Loaded], as_json: bool) -> int:
    """The compiled roles, as registered."""
    rows = [
        _Compiled(
            plan=f"{plan.system}.{plan.name}",
            states=len(plan.states),
            transitions=len(plan.transitions),
            model=plan.model,
            agents=[name for name, role in loaded.team if role == plan.name],
        )
        for loaded in systems
        for plan in loaded.plans
    ]
    if as_json:
        print_json({"plans": rows})
        return 0
    width = max((len(row["plan"]) for row in rows), default=0)
    for row in rows:
        agents = ", ".join(row["agents"]) or "no agent"
        size = f"{row['states']:4} states {row['transitions']:4} transitions"
        click.echo(f"{row['plan']:<{width}}  {size}  model {row['model']}  {agents}")
    return 0


def _print(
    options: _Options,
    prepared: _Prepared,
    played: Played,
    loaded: Loaded,
    telling: Telling,
    real: bool,
    watched: Sequence[Watched],
) -> None:
    """How it ended, and what is left behind."""
    from dataclasses import asdict

    result, report, bare = played.result, prepared.report, prepared.bare
    if options.as_json:
        print_json(
            {
                "result": {
                    "system": loaded.name,
                    "reason": result.reason,
                    "time": result.end_ns,
                    "seed": played.seed,
                    "network": str(played.network) if played.network is not None else None,
                    "agents": [asdict(agent) for agent in result.agents],
                    "faults": telling.faults,
                    **end_data(result),
                    "untaken": telling.untaken,
                    "unexpected": telling.unexpected,
                    "watched": watched_data(watched),
                    "summary": played.summary,
                    "folder": str(prepared.folder),
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
    network = f", network {played.network}" if played.network is not None else ""
    length = f"after {result.end_ns / 1e9:g} s ({clock}, seed {played.seed}{network})"
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
    for line in watched_lines(watched):
        click.echo(f"  {line}")
    for line in lines_without_code(bare, options.target, options.output) if bare is not None else ():
        click.echo(f"  {line}")
    if result.trace_error is not None:
        click.echo(f"  {result.trace_error}", err=True)
    else:
        click.echo(f"  trace: {played.trace}")
    if report is not None:
        click.echo(f"  models, diagrams and code: {prepared.folder}")
        for line in count_lines(report.count) if options.stats else ():
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
    "terminated": "terminated by SIGTERM",
}
"""Why a run stopped before its agents completed."""
