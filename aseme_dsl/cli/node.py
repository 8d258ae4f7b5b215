"""`asemec node`: run one agent of a team in this process."""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import (
    INTERRUPTED,
    body_option,
    build_target,
    duration_option,
    ending_left_processes,
    input_option,
    lines_without_code,
    platform_option,
    seed_option,
    state_option,
    telling_of,
    telling_options,
    trace_option,
)
from aseme_dsl.cli.run_end import end_data, end_lines, exit_code, watched_lines
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    Refused,
    WronglyUsed,
    activities_option,
    check_choice,
    check_outputs,
    colour_option,
    folder_option,
    gathered,
    given_options,
    leave_at_once,
    play_backend_option,
    print_diagnostics,
    refuse,
    refuse_options,
    target_argument,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.diagnostics.problems.running import (
    NoSuchSystem,
    OnOneSystem,
    OnOutput,
    OptionWithoutEffect,
    WithFrom,
    WithQuiet,
)
from aseme_dsl.diagnostics.problems.settings import CertificateUnusable, Incomplete, SimulatedHere
from aseme_dsl.project.settings.platform_settings import IN_PROCESS, PLATFORMS
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.operating.endpoint import Address
    from aseme_dsl.project.operating.json_log import JsonLog
    from aseme_dsl.project.playing.play import Played, Request
    from aseme_dsl.project.playing.seen import Seen
    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.project.testing.watching import Watch, Watched
    from aseme_dsl.runtime.control.control import Changed
    from aseme_dsl.runtime.version.loading import Loaded
    from aseme_dsl.source import Source

OUTLIVED = "outlived"
"""Why a run ends that a supervisor should start again."""
GRACE = 2.0
"""After so many seconds without its supervisor a robot ends, even if it is busy."""


@dataclass(frozen=True, slots=True)
class _Options:
    """What is on the command line."""

    robot: str
    target: str
    source: Path | None
    output: Path | None
    system: str | None
    duration: int | None
    seed: int | None
    platform: str | None
    script: Path | None
    trace: Path | None
    state: Path | None
    activities: Path | None
    backends: tuple[str, ...]
    bodies: dict[str, str]
    control: Path | None
    health: Address | None
    otel: bool
    log: str
    strict: bool
    quiet: bool
    verbose: bool
    project: Path | None
    world_at: str | None
    version: str | None
    fresh: bool
    supervised: bool
    watched: str | None
    colour: str

    @property
    def folder(self) -> Path:
        """What is given to run: an output folder, or what is to be built."""
        return self.source or Path(self.target)


def _address(context: click.Context, parameter: click.Parameter, value: str | None) -> Address | None:
    from aseme_dsl.project.operating.endpoint import AddressError, address_of

    try:
        return None if value is None else address_of(value)
    except AddressError as problem:
        raise click.BadParameter(f"{problem}.") from problem


@click.command(
    short_help="Run one agent of a team in this process.",
    help="Run AGENT of the team of TARGET in this process, in real time. The other agents run in processes of"
    " their own. [tool.asemec.deploy] of the pyproject.toml says how the processes reach each other; without"
    f" it, only processes on this machine do. {TARGET_HELP}",
    epilog="Example: asemec node robot1 team.aseme   ·   asemec node robot1 --from out",
)
@click.argument("robot", metavar="AGENT")
@target_argument
@folder_option("--from", "source", text="Output directory of a build; nothing is built.")
@folder_option("-o", "--output", text="Output directory.  [default: the project's, else out]")
@click.option("--system", metavar="NAME", help="System to run, if the output directory has several.")
@duration_option("Time limit.  [default: none]")
@seed_option
@platform_option(
    "Transport of the messages.  [default: the project's, else zenoh]",
    tuple(name for name in PLATFORMS if name != IN_PROCESS),
)
@input_option("JSON Lines file of timed messages and events for the agent.")
@trace_option("Trace file.  [default: OUTPUT/trace.AGENT.jsonl.gz]")
@state_option
@activities_option
@play_backend_option
@body_option("Factory function of the agent's body.")
@click.option(
    "--control",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Keys of the operators who may control the agent over the network."
    "  [default: the project's, else none]",
)
@click.option(
    "--health",
    metavar="ADDRESS",
    callback=_address,
    help="Serve /health, /alive and /metrics (for Prometheus) on unix:PATH, or on 127.0.0.1:PORT.",
)
@click.option("--otel", is_flag=True, help="Export metrics by OpenTelemetry. Needs the extra `otel`.")
@click.option(
    "--log",
    type=click.Choice(["text", "json"]),
    default="text",
    show_default=True,
    help="Format of the lines on standard output; json: one object a line.",
)
@click.option("--strict", is_flag=True, help="End the run when the agent breaks a property or a clause.")
@telling_options
@click.option("--project", type=FilePath(path_type=Path), hidden=True)
@click.option("--world-at", hidden=True)
@click.option("--in-version", "version", hidden=True)
@click.option("--fresh", is_flag=True, hidden=True)
@click.option("--supervised", is_flag=True, hidden=True)
@click.option("--watched", hidden=True)
@colour_option
@gathered(_Options)
def command(options: _Options) -> int:
    """Run; 1 if there are errors, it cannot be run, or the agent fails."""
    from aseme_dsl.project.playing.play import NoSuchPlan, PlayError

    if options.trace is not None:
        inputs: list[Path | str] = [options.target, *([options.script] if options.script is not None else [])]
        check_outputs([(options.trace, "trace")], inputs)
    if code := refuse_options(_without_effect(options), str(options.folder), False, options.colour):
        return code
    try:
        prepared = _prepared(options)
        return prepared if isinstance(prepared, int) else _run(options, *prepared)
    except PlayError as problem:
        refused = WronglyUsed if isinstance(problem, NoSuchPlan) else Refused
        raise refused(problem.problems(str(options.source or options.target)), options.colour) from problem


def _is_output(options: _Options) -> bool:
    """Whether an output folder is run as it is, without a build."""
    from aseme_dsl.project.playing.play import is_output

    return options.source is not None or is_output(options.folder)


def _without_effect(options: _Options) -> list[OptionWithoutEffect]:
    """The options that would be ignored."""
    unused: list[OptionWithoutEffect] = []
    if options.source is not None and "TARGET" in given_options():
        unused.append(WithFrom(f"TARGET {options.target}"))
    if _is_output(options):
        if options.output is not None:
            unused.append(OnOutput("-o"))
    elif options.system is not None:
        unused.append(OnOneSystem("--system"))
    if options.quiet and options.verbose:
        unused.append(WithQuiet("--verbose"))
    return unused


def _prepared(options: _Options) -> tuple[Loaded, Path, Configuration, Choice, Path | Source | None] | int:
    """The system, its folder and its settings, and its file if that was built; or the exit code, after
    telling why."""
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.play import NoSuchPlan, carried, load
    from aseme_dsl.project.settings.configuration import find_configuration, read_configuration

    folder = options.folder
    if not _is_output(options):
        built = build_target(
            options.target,
            options.output,
            options.activities,
            None,
            False,
            False,
            options.colour,
            options.backends,
        )
        if isinstance(built, int):
            return built
        report, compiled, choice, bare = built
        configuration = compiled.configuration
        if not options.quiet and options.log == "text":
            for line in lines_without_code(bare, options.target, options.output):
                click.echo(line)
        loaded = load(report.folder, report.system, configuration, choice)
        return loaded, report.folder, configuration, choice, compiled.root
    configuration, problems = (
        read_configuration(options.project) if options.project else find_configuration(folder)
    )
    if has_errors(problems):
        return refuse(problems, False, options.colour)
    if incomplete := _incomplete(options, configuration):
        return refuse(incomplete, False, options.colour)
    choice = choose(configuration, backends=options.backends, activities=options.activities)
    there = carried(folder, configuration, choice)
    check_choice(choice, options.backends, [role for item in there for role in item.charts])
    systems = [item for item in there if options.system in (None, item.name)]
    if len(systems) != 1:
        known = tuple(item.name for item in there)
        raise NoSuchPlan(NoSuchSystem(options.system, known))
    loaded = systems[0]
    _warn_of_simulated(options, loaded, activities_folder(folder, choice))
    return loaded, folder, configuration, choice, None


def _incomplete(options: _Options, configuration: Configuration) -> list[Diagnostic]:
    """What is missing or wrong of a bundle, or of the certificate that belongs to it."""
    from aseme_dsl.project.deploying.start_check import bad_certificate, bundle_of, incomplete

    folder = bundle_of(options.folder)
    if folder is None:
        return []
    path = str(options.folder)
    found = [Diagnostic(Incomplete(reason), None, path=path) for reason in incomplete(folder, options.robot)]
    reason = None if found else bad_certificate(configuration, options.robot)
    if reason is not None:
        found.append(Diagnostic(CertificateUnusable(reason), None, path=path))
    return found


def _warn_of_simulated(options: _Options, loaded: Loaded, activities: Path) -> None:
    """Warn of activities of the agent that have no code here: they only last for a while."""
    from aseme_dsl.runtime.message.naming import module_name

    role = dict(loaded.team).get(options.robot)
    if options.supervised or role is None or role not in loaded.charts or loaded.code is not None:
        return
    if any(activities.glob("*_agent.py")):  # methods of its behaviours are the code
        return
    missing = [
        info.name
        for info in loaded.charts[role].PLAN.activities
        if not (info.simulated or info.waits or (activities / f"{module_name(info.name)}.py").is_file())
    ]
    if missing:
        problem = SimulatedHere(tuple(missing), str(activities))
        print_diagnostics([Diagnostic(problem, None, path=str(options.folder))], options.colour)


def _run(
    options: _Options,
    loaded: Loaded,
    folder: Path,
    configuration: Configuration,
    choice: Choice,
    root: Path | Source | None,
) -> int:
    """Run the agent; the exit code."""
    from aseme_dsl.project.building.build import activities_folder
    from aseme_dsl.project.operating.telling import UNSYNCHRONISED
    from aseme_dsl.project.playing.play import in_epoch, play
    from aseme_dsl.project.playing.seen import Seen
    from aseme_dsl.project.playing.supervisor import SEEN
    from aseme_dsl.project.settings.deployment import Deployment
    from aseme_dsl.runtime.time.synchronised import synchronised

    loaded, epoch = in_epoch(loaded, options.robot, configuration, options.version, fresh=options.fresh)
    if options.control is not None:
        deploy = replace(configuration.deploy or Deployment(), control=options.control)
        configuration = replace(configuration, deploy=deploy)
    telling = _telling(options, loaded, configuration)
    if configuration.deploy is not None and configuration.deploy.tls and synchronised() is False:
        telling.line(f"note: the clock of this machine {UNSYNCHRONISED}")
    watch = _watch(options, loaded, root, configuration, telling)
    seen = None if options.watched is None else Seen(options.watched, lambda text: _say(SEEN + text))
    with ending_left_processes():
        played = play(
            loaded,
            activities_folder(folder, choice),
            configuration,
            replace(_request(options, folder, configuration, seen, telling), epoch=epoch),
            tell=telling.line,
            listeners=(telling,),
            watch=watch or seen,
        )
    telling.end()
    watched = () if watch is None else watch.end()
    _print(options, played, watched, telling)
    code = exit_code(played.result, (), INTERRUPTED)
    if code == 0 and (played.result.reason == OUTLIVED or any(item.verdict == "broken" for item in watched)):
        code = 1
    if played.result.left:
        leave_at_once(code)
    return code


def _telling(options: _Options, loaded: Loaded, configuration: Configuration) -> Telling | JsonLog:
    """What prints the lines of the run."""
    if options.log == "json":
        from aseme_dsl.project.operating.json_log import JsonLog

        return JsonLog(activities=not options.quiet)
    return telling_of(
        loaded,
        configuration,
        options.quiet,
        options.verbose,
        options.colour,
        alone=None,
        progress=False,
        stream=sys.stdout,
    )


def _watch(
    options: _Options,
    loaded: Loaded,
    root: Path | Source | None,
    configuration: Configuration,
    telling: Telling | JsonLog,
) -> Watch | None:
    """What watches the properties and clauses that this agent decides; our supervisor watches all of them."""
    from aseme_dsl.play.scenario import Refused as NotWatched
    from aseme_dsl.project.testing.watching import script_of, watch_of_agent

    if options.supervised or options.robot not in dict(loaded.team):
        return None

    def tell(line: str) -> None:
        if not options.quiet:
            _inform(telling, line)

    script = script_of(loaded, root, configuration, dict(loaded.team))
    if isinstance(script, NotWatched):
        tell(f"properties and clauses are not watched: {script.span}: {script.reason}")
        return None
    if script is None:
        return None
    return watch_of_agent(script, options.robot, tell, options.strict, loaded.plans)


def _request(
    options: _Options,
    folder: Path,
    configuration: Configuration,
    seen: Seen | None,
    telling: Telling | JsonLog,
) -> Request:
    """How the agent is to be run."""
    from aseme_dsl.project.operating.service import served
    from aseme_dsl.project.playing.play import Request
    from aseme_dsl.project.playing.supervisor import WORLD
    from aseme_dsl.runtime.trace.trace_files import name_for

    usual = configuration.platform if configuration.platform != IN_PROCESS else None
    world_at = options.world_at
    return Request(
        duration=options.duration,
        seed=options.seed,
        real=True,
        script=options.script,
        trace=options.trace or folder / name_for(options.robot),
        bodies=options.bodies,
        state=options.state,
        platform=options.platform or usual,
        robot=options.robot,
        world_at=(world_at, bytes.fromhex(os.environ.get(WORLD, ""))) if world_at is not None else None,
        serve=lambda team, recent: served(
            team, recent, options.health, options.otel, lambda text: _inform(telling, text)
        ),
        begin=_told_to_begin(seen) if options.supervised else lambda: None,
        changed=_tell_change if options.supervised else None,
    )


def _inform(telling: Telling | JsonLog, text: str, wrong: bool = False) -> None:
    """Print a line that is not of the run."""
    from aseme_dsl.project.operating.json_log import JsonLog

    if isinstance(telling, JsonLog):
        telling.warn(text) if wrong else telling.line(text)
    else:
        click.echo(text, err=wrong)


def _print(options: _Options, played: Played, watched: Sequence[Watched], telling: Telling | JsonLog) -> None:
    """How the agent has ended, and what is left behind."""
    result = played.result
    for agent in result.agents:
        if agent.failure is not None:
            place = f" ({agent.at})" if agent.at else ""
            _inform(telling, f"{agent.name} ({agent.role}) failed: {agent.failure}{place}", True)
    if result.reason == "replaced":
        _inform(telling, f"{options.robot} stopped: a newer process runs it", True)
    if result.reason == OUTLIVED:
        text = f"{options.robot} stopped: the others have followed a newer process of it, which has ended"
        _inform(telling, f"{text}: start it again", True)
    if result.trace_error is not None:
        _inform(telling, result.trace_error, True)
    elif not options.supervised:
        _inform(telling, f"stopped after {result.end_ns / 1e9:g} s\n  trace: {played.trace}")
    lines = list(end_lines(result))
    if options.supervised:
        agents = [asdict(agent) for agent in result.agents]
        _tell_end({"result": {"agents": agents, **end_data(result)}, "lines": lines})
    else:
        for line in (*lines, *watched_lines(watched)):
            _inform(telling, f"  {line}")


def _told_to_begin(seen: Seen | None) -> Callable[[], int | None]:
    """Says that we are ready and waits for the beginning; from then on we end when our supervisor does."""
    from aseme_dsl.project.playing.supervisor import READY

    def begin() -> int | None:
        _say(READY)
        lines = _lines_of_supervisor()
        origin = next(lines, None)
        if origin is None:
            os._exit(INTERRUPTED)
        threading.Thread(
            target=_end_with_supervisor, args=(lines, seen), name="aseme supervisor", daemon=True
        ).start()
        return int(origin)

    return begin


def _lines_of_supervisor() -> Iterator[str]:
    """What our supervisor writes, as long as it runs.

    From the file descriptor, not the stream: at the interpreter's end no thread must hold the stream's lock.
    """
    rest = b""
    while got := os.read(0, 4096):
        *lines, rest = (rest + got).split(b"\n")
        yield from (line.decode() for line in lines)


def _say(line: str) -> None:
    """Say something to our supervisor."""
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def _tell_change(change: Changed) -> None:
    """Says that we play another version now, which our supervisor takes if it starts us again."""
    from aseme_dsl.project.playing.supervisor import CHANGED

    _say(CHANGED + json.dumps(asdict(change), default=str))


def _tell_end(end: dict[str, object]) -> None:
    """Say what our run has left open, which our supervisor shows when all have ended."""
    from aseme_dsl.project.playing.supervisor import ENDED

    _say(ENDED + json.dumps(end))


def _end_with_supervisor(lines: Iterator[str], seen: Seen | None) -> None:
    """Record what our supervisor finds broken, until it has ended; then end, too."""
    from aseme_dsl.runtime.workers.descendants import kill_descendants

    for line in lines:
        if seen is not None:
            seen.record(line)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    kill_descendants(lambda line: None)
    os._exit(INTERRUPTED)
