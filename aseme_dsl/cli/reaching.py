"""How commands reach robots: by the control sockets of this machine, or over the network with a key."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import CommandT, FilePath, Refused, print_json
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.running import NotDone, NotOneTeam

if TYPE_CHECKING:
    from collections.abc import Callable

    from aseme_dsl.project.playing.operate import OperateError
    from aseme_dsl.project.playing.remote import Robot


def key_option(command: CommandT) -> CommandT:
    """`--key`: reach the robots over their network."""
    return click.option(
        "--key",
        type=FilePath(path_type=Path),
        metavar="FILE",
        help="Reach the agents over the network with the last key of FILE.  [default: the control sockets of"
        " this machine]",
    )(command)


def within_option(usual: str, text: str) -> Callable[[CommandT], CommandT]:
    """`--within`: a duration, which the command gets in seconds."""

    def seconds(context: click.Context, parameter: click.Parameter, value: str) -> float:
        from aseme_dsl.project.files.duration import duration

        try:
            return duration(value) / 1e9
        except ValueError as problem:
            raise click.BadParameter(f"{problem}.") from problem

    return click.option(
        "--within", metavar="DURATION", default=usual, show_default=True, callback=seconds, help=text
    )


@contextmanager
def reached(key: Path | None, output: Path, system: str | None = None) -> Iterator[Sequence[Robot] | None]:
    """The robots of the build in an output folder; None without a key.

    Raises:
        Refused: they cannot be reached.
    """
    if key is None:
        yield None
        return
    from aseme_dsl.diagnostics import has_errors
    from aseme_dsl.project.building.build import choose
    from aseme_dsl.project.playing.play import PlayError, carried
    from aseme_dsl.project.playing.remote import RemoteError, robots_of
    from aseme_dsl.project.settings.configuration import find_configuration

    configuration, problems = find_configuration(output)
    if has_errors(problems):
        raise Refused(problems)
    try:
        systems = [
            item
            for item in carried(output, configuration, choose(configuration))
            if item.team and system in (None, item.name)
        ]
    except PlayError as problem:
        raise Refused(problem.problems(str(output))) from problem
    if len(systems) != 1:
        names = tuple(item.name for item in systems)
        raise Refused([Diagnostic(NotOneTeam(str(output), names), None, path=str(output))])
    team = [name for name, _ in systems[0].team]
    try:
        with robots_of(systems[0].name, team, configuration, key) as robots:
            yield robots
    except RemoteError as problem:
        raise not_done([str(problem)], output) from problem


def cannot(
    problem: OperateError, output: Path, as_json: bool, first: str | None = None, **members: object
) -> int:
    """Report what cannot be done: as JSON, with further members, and exit code 1; or as a refusal, of which
    `first` says what became of the team.

    Raises:
        Refused: without JSON.
    """
    if not as_json:
        raise not_done(problem.args, output, first) from problem
    print_json({"ok": False, **members, "reasons": list(problem.args)})
    return 1


def not_done(reasons: Iterable[object], output: Path, first: str | None = None) -> Refused:
    """What cannot be done with robots that run from an output folder; `first` says what became of them."""
    about = [] if first is None else [first]
    problem = NotDone((*about, *map(str, reasons)))
    return Refused([Diagnostic(problem, None, path=str(output))])
