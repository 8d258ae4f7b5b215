"""`asemec node`: play one robot of a team in this process."""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from aseme_dsl.cli.playing import (
    INTERRUPTED,
    QUIET_AND_VERBOSE,
    body_option,
    build_target,
    duration_option,
    ending_left_processes,
    input_option,
    lines_without_code,
    platform_option,
    seed_option,
    state_option,
    telling_options,
    trace_option,
)
from aseme_dsl.cli.run_end import end_data, end_lines, exit_code
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
    given_options,
    leave_at_once,
    play_backend_option,
    refuse,
    refuse_options,
    target_argument,
    wants_colour,
)
from aseme_dsl.diagnostics import has_errors

if TYPE_CHECKING:
    from collections.abc import Callable

    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.control.control import Changed

GRACE = 2.0
"""After so many seconds without its supervisor a robot ends, whatever it does."""


@click.command(
    short_help="Play one robot of a team in this process.",
    help="Play ROBOT, one of the team that TARGET declares, in real time, and talk with the others, which are"
    f" processes of their own. {TARGET_HELP} Nothing is built if it is an output folder with agents. How the"
    " robots reach each other stands in [tool.asemec.deploy] of the pyproject.toml; without it, only this"
    " machine is asked.",
    epilog="Example: asemec node robot1 team.aseme   ·   asemec node robot1 --from out",
)
@click.argument("robot")
@target_argument
@folder_option("--from", "source", text="The output folder of a build; nothing is built.")
@folder_option("-o", "--output", text="Where to build.  [default: the project's, else out]")
@click.option("--system", metavar="NAME", help="Which of the systems in the output folder.")
@duration_option("How long to play.  [default: no limit]")
@seed_option
@platform_option(
    "What carries the messages.  [default: the project's, else zenoh]", "zenoh", "spade", "mango"
)
@input_option("What to give the robot.")
@trace_option("Where the trace goes.  [default: OUTPUT/trace.ROBOT.jsonl]")
@state_option
@activities_option
@play_backend_option
@body_option("Makes the robot's body.")
@click.option(
    "--control",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="The operators' keys with which the robot can be controlled over its network."
    "  [default: the project's, else it cannot]",
)
@telling_options
@click.option("--project", type=FilePath(path_type=Path), hidden=True)
@click.option("--world-at", hidden=True)
@click.option("--in-version", "version", hidden=True)
@click.option("--supervised", is_flag=True, hidden=True)
@colour_option
def command(
    robot: str,
    target: str,
    source: Path | None,
    output: Path | None,
    system: str | None,
    duration: int | None,
    seed: int | None,
    platform: str | None,
    script: Path | None,
    trace: Path | None,
    state: Path | None,
    activities: Path | None,
    backends: tuple[str, ...],
    bodies: dict[str, str],
    control: Path | None,
    quiet: bool,
    verbose: bool,
    project: Path | None,
    world_at: str | None,
    version: str | None,
    supervised: bool,
    colour: str,
) -> int:
    """Play; 1 if there are errors, it cannot be played, or the robot fails."""
    from aseme_dsl.cli.telling import Telling
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.play import (
        NoSuchPlan,
        PlayError,
        Request,
        carried,
        in_version,
        is_output,
        load,
        play,
    )
    from aseme_dsl.project.playing.supervisor import WORLD
    from aseme_dsl.project.settings.configuration import find_configuration, read_configuration
    from aseme_dsl.project.settings.deployment import Deployment
    from aseme_dsl.project.settings.platform_settings import IN_PROCESS

    if trace is not None:
        check_outputs([(trace, "trace")], [target, *([script] if script is not None else [])])
    folder = source or Path(target)
    played_as_it_is = source is not None or is_output(folder)
    given = given_options()
    unused: list[tuple[str, str, str]] = []
    if source is not None and "TARGET" in given:
        unused.append((f"TARGET {target}", "with `--from`", "name one of them"))
    if played_as_it_is and output is not None:
        unused.append(("-o", "on an output folder, which is played as it is", "leave it out"))
    if not played_as_it_is and system is not None:
        unused.append(("--system", "on what has one system", "leave it out, or name the output folder"))
    if quiet and verbose:
        unused.append(QUIET_AND_VERBOSE)
    if code := refuse_options(unused, str(folder), False, colour):
        return code
    try:
        if played_as_it_is:
            configuration: Configuration
            configuration, problems = read_configuration(project) if project else find_configuration(folder)
            if has_errors(problems):
                return refuse(problems, False, colour)
            choice = choose(configuration, backends=backends, activities=activities)
            there = carried(folder, configuration, choice)
            check_choice(choice, backends, [role for item in there for role in item.charts])
            systems = [item for item in there if system in (None, item.name)]
            if len(systems) != 1:
                known = ", ".join(item.name for item in there)
                what = f"there is no system `{system}`" if system else "there are several systems"
                raise NoSuchPlan(what, f"choose one with --system; there are {known}")
            loaded = systems[0] if version is None else in_version(systems[0], version, configuration)
        else:
            built = build_target(target, output, activities, None, False, False, colour, backends)
            if isinstance(built, int):
                return built
            report, configuration, choice, bare = built
            if not quiet:
                for line in lines_without_code(bare, target, output):
                    click.echo(line)
            folder = report.folder
            loaded = load(folder, report.system, configuration, choice)
        if control is not None:
            deploy = replace(configuration.deploy or Deployment(), control=control)
            configuration = replace(configuration, deploy=deploy)
        telling = Telling(
            loaded,
            alone=None,
            activities=not quiet
            and (verbose or configuration.run is None or configuration.run.progress is None),
            transitions=verbose and not quiet,
            progress=False,
            colour=wants_colour(colour, sys.stderr),
            stream=sys.stdout,
        )
        key = bytes.fromhex(os.environ.get(WORLD, ""))
        request = Request(
            duration=duration,
            seed=seed,
            real=True,
            script=script,
            trace=trace or folder / f"trace.{robot}.jsonl",
            bodies=bodies,
            state=state,
            platform=platform or (configuration.platform if configuration.platform != IN_PROCESS else None),
            robot=robot,
            world_at=(world_at, key) if world_at is not None else None,
            begin=_told_to_begin() if supervised else lambda: None,
            changed=_tell_change if supervised else None,
        )
        with ending_left_processes():
            played = play(
                loaded,
                activities_folder(folder, choice),
                configuration,
                request,
                tell=telling.line,
                listeners=(telling,),
            )
    except PlayError as problem:
        refused = WronglyUsed if isinstance(problem, NoSuchPlan) else Refused
        raise refused(problem.problems(str(source or target)), colour) from problem
    telling.end()
    result = played.result
    for agent in result.agents:
        if agent.failure is not None:
            place = f" ({agent.at})" if agent.at else ""
            click.echo(f"{agent.name} ({agent.role}) failed: {agent.failure}{place}", err=True)
    if result.reason == "replaced":
        click.echo(f"{robot} ends here: it is played by a newer process", err=True)
    if result.trace_error is not None:
        click.echo(result.trace_error, err=True)
    elif not supervised:
        click.echo(f"played {result.time / 1e9:g} s\n  trace: {played.trace}")
    lines = list(end_lines(result))
    if supervised:
        agents = [asdict(agent) for agent in result.agents]
        _tell_end({"result": {"agents": agents, **end_data(result)}, "lines": lines})
    else:
        for line in lines:
            click.echo(f"  {line}")
    code = exit_code(result, (), INTERRUPTED)
    if result.left:
        leave_at_once(code)
    return code


def _told_to_begin() -> Callable[[], int | None]:
    """Says that we are ready and waits for the beginning; from then on we end when our supervisor does."""
    from aseme_dsl.project.playing.supervisor import READY

    def begin() -> int | None:
        sys.stdout.write(READY + "\n")
        sys.stdout.flush()
        line = sys.stdin.readline()
        if not line:
            os._exit(INTERRUPTED)
        threading.Thread(target=_end_with_supervisor, name="aseme supervisor", daemon=True).start()
        return int(line)

    return begin


def _tell_change(change: Changed) -> None:
    """Says that we play another version now, which our supervisor takes if it starts us again."""
    from aseme_dsl.project.playing.supervisor import CHANGED

    sys.stdout.write(CHANGED + json.dumps(asdict(change), default=str) + "\n")
    sys.stdout.flush()


def _tell_end(end: dict[str, Any]) -> None:
    """Say what our run has left open, which our supervisor shows when all have ended."""
    from aseme_dsl.project.playing.supervisor import ENDED

    sys.stdout.write(ENDED + json.dumps(end) + "\n")
    sys.stdout.flush()


def _end_with_supervisor() -> None:
    from aseme_dsl.runtime.workers.descendants import kill_descendants

    # The file descriptor, not the stream: at the interpreter's end nobody must hold the stream's lock.
    while os.read(0, 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    kill_descendants(lambda line: None)
    os._exit(INTERRUPTED)
