"""What several commands have in common: their options, and how they print diagnostics."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import wraps
from pathlib import Path
from typing import IO, TYPE_CHECKING, NoReturn, TypeVar

import click
from click.core import ParameterSource

from aseme_dsl.diagnostics import (
    Diagnostic,
    Severity,
    closest,
    has_errors,
    in_order,
    render_json,
    render_text,
)
from aseme_dsl.diagnostics.problems.running import AgentNotInTrace, OptionWithoutEffect, TraceNotRead

if TYPE_CHECKING:
    from aseme_dsl.project.building.build import Choice
    from aseme_dsl.project.building.counting import Count
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.files.inputs import Inputs
    from aseme_dsl.project.files.outputs import Kind
    from aseme_dsl.project.files.write import Written
    from aseme_dsl.project.spreading.cluster import Cluster
    from aseme_dsl.proofs.certificate.certify import Certificate

CommandT = TypeVar("CommandT", bound=Callable[..., object])
OptionsT = TypeVar("OptionsT")

FORMAT = 1
"""The version of what `--json` prints."""


class FilePath(click.Path):
    """A path that need not exist. The empty path is refused: it would mean this folder, by mistake."""

    def convert(
        self, value: str | os.PathLike[str], param: click.Parameter | None, ctx: click.Context | None
    ) -> str | bytes | os.PathLike[str]:
        if value == "":
            self.fail("the path must not be empty.", param, ctx)
        return super().convert(value, param, ctx)


def gathered(kind: Callable[..., OptionsT]) -> Callable[[Callable[[OptionsT], int]], Callable[..., int]]:
    """Gives a command all its options in one object, which `kind` makes of them."""

    def gather(command: Callable[[OptionsT], int]) -> Callable[..., int]:
        @wraps(command)
        def with_options(**given: object) -> int:
            return command(kind(**given))

        return with_options

    return gather


def json_option(command: CommandT) -> CommandT:
    """`--json`: the result on standard output for programs."""
    return click.option("--json", "as_json", is_flag=True, help="Print the result as JSON.")(command)


def colour_option(command: CommandT) -> CommandT:
    """`--color auto|always|never`; `NO_COLOR` in the environment turns `auto` into `never`."""
    return click.option(
        "--color",
        "colour",
        type=click.Choice(["auto", "always", "never"]),
        default="auto",
        show_default=True,
        help="Coloured output; auto: on a terminal, unless NO_COLOR is set.",
    )(command)


def stats_option(command: CommandT) -> CommandT:
    """`--stats`: how much of the code is generated."""
    text = "Print the numbers of generated and hand-written lines (--json always has them)."
    return click.option("--stats", is_flag=True, help=text)(command)


def watch_option(command: CommandT) -> CommandT:
    """`--watch`."""
    text = "Repeat whenever an input file changes, until Ctrl-C."
    return click.option("-w", "--watch", is_flag=True, help=text)(command)


def activities_option(command: CommandT) -> CommandT:
    """`--activities DIR`."""
    text = "Directory of the activities' Python code.  [default: the project's, else OUTPUT/monas/activities]"
    return folder_option("--activities", text=text)(command)


def cluster_option(command: CommandT) -> CommandT:
    """`--cluster ADDRESS`."""
    text = (
        "Play on the workers of the Dask cluster whose scheduler has this address, such as tcp://lab1:8786."
    )
    return click.option("--cluster", metavar="ADDRESS", help=text)(command)


def crew_of(jobs: int | None, cluster: str | None) -> int | Cluster:
    """Who plays many runs: so many processes, or a cluster. Both at once are wrong use."""
    from aseme_dsl.project.spreading.cluster import Cluster

    if jobs is not None and cluster is not None:
        raise click.UsageError("--jobs is about this machine, and --cluster about others: give one of them.")
    return jobs or os.cpu_count() or 1 if cluster is None else Cluster(cluster)


def moment_of(context: click.Context, parameter: click.Parameter, value: str | None) -> int | None:
    """A time on the command line, in ns."""
    from aseme_dsl.project.files.duration import duration

    try:
        return None if value is None else duration(value)
    except ValueError as problem:
        raise click.BadParameter(f"{problem}.") from problem


def wants_colour(choice: str, stream: IO[str]) -> bool:
    """Whether to colour what goes to `stream`."""
    if choice != "auto":
        return choice == "always"
    if os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb":
        return False
    return stream.isatty()


def print_diagnostics(diagnostics: Iterable[Diagnostic], choice: str, *, error: bool = True) -> None:
    """All diagnostics for people, on standard error unless they are what the command is for.

    On a terminal, lines are cut to its width; with colours, the codes are links to their pages.
    """
    stream = sys.stderr if error else sys.stdout
    found = tuple(diagnostics)
    if found:
        colour = wants_colour(choice, stream)
        is_terminal = stream.isatty()
        columns = shutil.get_terminal_size().columns if is_terminal else None
        link = _page if colour and is_terminal else None
        text = render_text(found, colour=colour, link=link, columns=columns)
        click.echo(text, file=stream, nl=False, color=True)


def _page(code: str) -> str | None:
    """The address of the page about a code, which is installed with the program."""
    from aseme_dsl.diagnostics.pages import file_of

    path = file_of(code)
    return path.as_uri() if path is not None else None


def refuse(found: Iterable[Diagnostic], as_json: bool, colour: str) -> int:
    """Print what is wrong; the exit code."""
    if as_json:
        print_json({"result": None, **diagnostics_json(found)})
    else:
        print_diagnostics(found, colour)
    return 1


def say_unreadable(problem: object, path: Path, colour: str = "auto") -> None:
    """Say that a trace cannot be read, or only up to a line."""
    print_diagnostics([Diagnostic(TraceNotRead(str(problem)), None, path=str(path))], colour)


def refuse_unreadable(problem: object, path: Path, as_json: bool, colour: str) -> int:
    """Say that a trace cannot be read at all; the exit code."""
    return refuse([Diagnostic(TraceNotRead(str(problem)), None, path=str(path))], as_json, colour)


def not_in_traces(unknown: Iterable[str], team: Collection[str], files: Sequence[Path]) -> list[Diagnostic]:
    """What is wrong with agents that traces have nothing about."""
    problems = []
    for name in unknown:
        near = closest(name, team)
        absent = AgentNotInTrace(name, near, tuple(team))
        problems.append(Diagnostic(absent, None, path=", ".join(map(str, files))))
    return problems


WRONG_USE = 2
"""The exit code of a call that cannot be meant."""


class Refused(click.ClickException):
    """What was asked for cannot be done: diagnostics, which are shown as all others are."""

    def __init__(self, found: Sequence[Diagnostic], colour: str = "auto") -> None:
        super().__init__("\n".join(item.message for item in found))
        self.found = tuple(found)
        self._colour = colour

    def show(self, file: object = None) -> None:
        """Print them on standard error."""
        print_diagnostics(self.found, self._colour)


class WronglyUsed(Refused):
    """What was asked for cannot be meant."""

    exit_code = WRONG_USE


def given_options() -> list[str]:
    """The options that were written on the command line, by their usual names; an argument is `TARGET`."""
    context = click.get_current_context()
    return [
        max(parameter.opts, key=len) if isinstance(parameter, click.Option) else str(parameter.name).upper()
        for parameter in context.command.params
        if context.get_parameter_source(str(parameter.name)) is ParameterSource.COMMANDLINE
    ]


def refuse_options(found: Sequence[OptionWithoutEffect], target: str, as_json: bool, colour: str) -> int:
    """Refuse options that have no effect on a target.

    The exit code: 0 if there are none.
    """
    if not found:
        return 0
    refuse([Diagnostic(problem, None, path=target) for problem in found], as_json, colour)
    return WRONG_USE


def print_json(result: Mapping[str, object]) -> None:
    """A result for programs: one JSON document, which begins with the version of its format."""
    import json

    click.echo(json.dumps({"format": FORMAT, **result}, indent=2, ensure_ascii=False))


def diagnostics_json(diagnostics: Iterable[Diagnostic]) -> dict[str, object]:
    """The diagnostics with their numbers, as the part that every `--json` has."""
    found = in_order(diagnostics)
    return {
        "errors": count(found, Severity.ERROR),
        "warnings": count(found, Severity.WARNING),
        "notes": count(found, Severity.NOTE),
        "diagnostics": render_json(found),
    }


def count(diagnostics: Iterable[Diagnostic], severity: Severity) -> int:
    """How many there are of a severity."""
    return sum(item.severity is severity for item in diagnostics)


def plural(number: int, noun: str) -> str:
    """`1 file`, `2 files`, `2 activities`."""
    many = f"{noun[:-1]}ies" if noun.endswith("y") else f"{noun}s"
    return f"{number} {noun if number == 1 else many}"


def summary(diagnostics: Iterable[Diagnostic], files: int) -> str:
    """`2 errors, 1 warning in 1 file`; `no problems found in 1 file` without diagnostics."""
    found = tuple(diagnostics)
    counts = [(count(found, severity), severity.value) for severity in Severity]
    said = ", ".join(plural(number, noun) for number, noun in counts if number)
    if not said:
        return f"no problems found in {plural(files, 'file')}"
    return f"{said} in {plural(files, 'file')}" if files else said


def standard_input() -> bytes:
    """The bytes of standard input, not many more than a file may have."""
    from aseme_dsl.compiler.read.load import LARGEST

    return sys.stdin.buffer.read(LARGEST + 1)


TARGET_HELP = (
    "TARGET is a file, a project directory or the output directory of a build. Default: the project in the"
    " current directory."
)
TARGETS_HELP = (
    "TARGET is a file, a project directory, any other directory (all .aseme files in it), the output"
    " directory of a build, a quoted pattern, or - for standard input."
    " Default: the project in the current directory."
)


def one_system(target: str, activities: Path | None = None) -> Compiled:
    """The one system that a target means, compiled; what is more or less than one is wrong use.

    `activities` is the folder with the code of its activities, if an option says so.
    """
    from aseme_dsl.project.building.project import Compiled, compile_root, inputs_of
    from aseme_dsl.project.settings.configuration import Configuration

    inputs = inputs_of([target], standard_input)
    if inputs.diagnostics:
        return Compiled(Path(target), Configuration(Path()), None, inputs.diagnostics)
    if len(inputs.roots) != 1:
        raise click.UsageError(_not_one(target, inputs))
    return compile_root(inputs.roots[0], activities=activities, output=inputs.output_of(inputs.roots[0]))


def one_file(target: str) -> Path | tuple[Diagnostic, ...]:
    """The one file that declares the system that a target means, or what is wrong with that; more or less
    than one is wrong use."""
    from aseme_dsl.compiler.read.load import read_source
    from aseme_dsl.project.building.project import inputs_of

    if target == "-":
        raise click.UsageError("Standard input cannot be read a second time: name a file.")
    inputs = inputs_of([target], standard_input)
    if inputs.diagnostics:
        return inputs.diagnostics
    if len(inputs.roots) != 1:
        raise click.UsageError(_not_one(target, inputs))
    (root,) = inputs.roots
    assert isinstance(root, Path)
    source = read_source(root)
    return (source,) if isinstance(source, Diagnostic) else root


def _not_one(target: str, inputs: Inputs) -> str:
    names = ", ".join(str(getattr(root, "path", root)) for root in inputs.roots) or "no `system` declaration"
    return f"{target} contains {len(inputs.roots)} systems ({names}), not one: name a file with one system."


def check_outputs(outputs: Iterable[tuple[Path, Kind]], inputs: Iterable[Path | str] = ()) -> None:
    """Refuse, as wrong use, to write over what is not asemec's, or is among what is read, or twice."""
    from aseme_dsl.project.files import outputs as files

    try:
        files.check_outputs(outputs, inputs)
    except files.NotOurs as problem:
        raise click.UsageError(f"{problem}.") from problem


def print_written(written: Written, notes: Iterable[str], as_json: bool, colour: str) -> int:
    """What became of the files; 1 if they could not be written."""
    if as_json:
        print_json({**written_json(written), "remarks": list(notes), **diagnostics_json(written.diagnostics)})
    else:
        print_diagnostics(written.diagnostics, colour)
        for note in notes:
            click.echo(f"note: {note}", err=True)
        if not has_errors(written.diagnostics):
            click.echo(written_summary(written))
    return int(has_errors(written.diagnostics))


def written_json(written: Written) -> dict[str, object]:
    """Which files were created, changed, left as they were, removed, or are the user's."""
    return {
        "created": [str(path) for path in written.created],
        "changed": [str(path) for path in written.changed],
        "unchanged": [str(path) for path in written.unchanged],
        "removed": [str(path) for path in written.removed],
        "kept": [str(path) for path in written.kept],
    }


def written_summary(written: Written) -> str:
    """`3 files created, 1 changed`, with the files where they are few."""
    parts = [
        (len(written.created), "created"),
        (len(written.changed), "changed"),
        (len(written.removed), "removed"),
        (len(written.unchanged), "unchanged"),
        (len(written.kept), "of yours kept"),
    ]
    said = [f"{number} {what}" for number, what in parts if number]
    return f"files: {', '.join(said)}" if said else "no files"


def certified(certificates: Sequence[Certificate]) -> str:
    """`; 3 statecharts certified`, and of how many a part, or all, could not be compared with a formula."""
    if not certificates:
        return ""
    whole = sum(item.is_whole for item in certificates)
    said = f"; {plural(whole, 'statechart')} certified"
    return said if whole == len(certificates) else f"{said}, {len(certificates) - whole} not or in part"


def target_argument(command: CommandT) -> CommandT:
    """`TARGET`: what the command works on (`project/settings/target.py`); without it, the project here."""
    return click.argument("target", required=False, type=FilePath(), default=_project_here)(command)


def targets_argument(command: CommandT) -> CommandT:
    """`[TARGET]...`: the same of what works on several; empty without one."""
    return click.argument("targets", nargs=-1, metavar="[TARGET]...", type=FilePath())(command)


def _project_here() -> str:
    from aseme_dsl.project.settings.target import project_here

    return project_here()


def folder_option(*names: str, text: str) -> Callable[[CommandT], CommandT]:
    """An option that names a folder, which need not exist."""
    return click.option(*names, type=FilePath(path_type=Path), metavar="DIR", help=text)


def running_option(command: CommandT) -> CommandT:
    """`-o`: the output folder that something runs from; the project's, if nothing is said."""

    def default(context: click.Context, parameter: click.Parameter, value: Path | None) -> Path:
        from aseme_dsl.project.settings.configuration import OUTPUT, find_configuration

        return value or find_configuration(Path())[0].output or Path(OUTPUT)

    return click.option(
        "-o",
        "--output",
        type=FilePath(path_type=Path),
        metavar="DIR",
        callback=default,
        help="Output directory that the team runs from.  [default: the project's, else out]",
    )(command)


def backend_option(text: str) -> Callable[[CommandT], CommandT]:
    """`--backend [ROLE=]NAME`, which may be repeated."""
    return click.option("--backend", "backends", multiple=True, metavar="[ROLE=]NAME", help=text)


def play_backend_option(command: CommandT) -> CommandT:
    """`--backend` of what plays agents."""
    text = (
        "Backend that runs the agents, for all roles or for ROLE. Repeatable."
        "  [default: the project's, else monas]"
    )
    return backend_option(text)(command)


def check_choice(choice: Choice, asked: Iterable[str], roles: Iterable[str], *, plays: bool = True) -> None:
    """Refuse unknown backends as wrong use, and check the backends `asked` for (`ROLE=NAME`).

    Their roles must be in the system. If the command `plays` agents, their backends must make agents.
    """
    from aseme_dsl.backends.backend import AGENTS

    check_backends(choice.generated)
    known = list(roles)
    for item in asked:
        role, given, name = item.partition("=")
        if given and plays and name not in AGENTS:
            raise click.UsageError(
                f"Backend {name} cannot run agents; use one of {', '.join(AGENTS)} for {role}."
            )
        if given and role not in known:
            near = closest(role, known)
            hint = f"Did you mean {near!r}?" if near else f"Roles: {', '.join(known) or 'none'}."
            raise click.UsageError(f"Unknown role {role!r}. {hint}")


def check_backends(names: Iterable[str], others: Sequence[str] = ()) -> None:
    """Refuse, as wrong use, what is neither a backend nor one of `others`."""
    from aseme_dsl.backends.backend import OWN, backend_names

    ours = {*others, *OWN}
    for name in names:
        if name not in ours and name not in (known := (*others, *backend_names())):
            near = closest(name, known)
            hint = f"Did you mean {near!r}?" if near else f"Available: {', '.join(known)}."
            raise click.UsageError(f"Unknown {'part or ' if others else ''}backend {name!r}. {hint}")


def count_lines(count: Count | None) -> list[str]:
    """How many lines are generated and how many are hand-written (`--stats`)."""
    if count is None:
        return []
    generated, by_hand, source = count.generated, count.by_hand, count.source
    lines = f"{generated.lines} of {count.lines} lines ({_percent(generated.lines, count.lines)})"
    size = f"{_kilobytes(generated.bytes)} of {_kilobytes(count.bytes)} KB"
    hand = "no activity code"
    if by_hand.files:
        hand = f"{plural(by_hand.lines, 'line')} of activities in {plural(by_hand.files, 'file')}"
    text = f"{plural(source.lines, 'line')} of .aseme ({_kilobytes(source.bytes)} KB)"
    return [
        f"generated: {lines} of code, {size} ({_percent(generated.bytes, count.bytes)})",
        f"hand-written: {hand}, {text}",
    ]


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / whole:.0f} %" if whole else "-"


def _kilobytes(number: int) -> str:
    return f"{number / 1000:.1f}"


def leave_at_once(code: int) -> NoReturn:
    """End this process without waiting for threads that do not end."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)
