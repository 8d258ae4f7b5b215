"""`asemec prove`: what holds in every run of a system, and the shortest runs in which it does not."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import time_limit_of
from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    check_outputs,
    colour_option,
    folder_option,
    json_option,
    one_system,
    plural,
    print_diagnostics,
    print_json,
    refuse,
    target_argument,
)
from aseme_dsl.diagnostics import Severity, has_errors

if TYPE_CHECKING:
    from aseme_dsl.project.proving.results import Result
    from aseme_dsl.proofs.explore.search import Limits
    from aseme_dsl.source import Source

_NANOSECOND = 1e-9
_ROBOTS = 2


@click.command(
    short_help="Prove what holds in every run.",
    help="Explore all runs of the team, and of each protocol alone. Each property and clause is proved,"
    " refuted or undecided, with its bounds; what is refuted has a run that shows it. Built-in questions:"
    " deadlock, orphan messages, non-local choice, agreement, dead states, failures. PROPERTY is a question,"
    " the name of a property, or the text of a clause. The name of a protocol, or team, explores that alone."
    f" {TARGET_HELP}",
    epilog="Example: asemec prove team.aseme   ·   asemec prove team.aseme deadlock --robots 3",
)
@target_argument
@click.argument("asked", metavar="[PROPERTY]...", nargs=-1)
@click.option(
    "--robots",
    type=click.IntRange(1, 16),
    default=_ROBOTS,
    show_default=True,
    metavar="K",
    help="Number of agents for each role and participant that has several.",
)
@click.option(
    "--budget",
    default="60s",
    show_default=True,
    callback=time_limit_of,
    metavar="D",
    help="Processor time for the search in each team.",
)
@click.option(
    "--states",
    type=click.IntRange(1),
    default=200_000,
    show_default=True,
    metavar="N",
    help="Number of states, at most, in each team.",
)
@click.option(
    "--save",
    "saved",
    type=FilePath(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Append the counterexamples to FILE, as scenarios.",
)
@folder_option("--stories", text="Directory for a sequence diagram (SVG) of each counterexample.")
@click.option(
    "--horizon",
    callback=time_limit_of,
    metavar="D",
    help="Explore durations only up to this moment of the team's time.  [default: without end]",
)
@json_option
@colour_option
def command(
    target: str,
    asked: tuple[str, ...],
    robots: int,
    budget: int,
    states: int,
    saved: Path | None,
    stories: Path | None,
    horizon: int | None,
    as_json: bool,
    colour: str,
) -> int:
    """Prove; 1 if something is refuted, or the file has errors, 3 if something asked for is undecided."""
    from aseme_dsl.project.playing.operate import OperateError
    from aseme_dsl.project.proving.asking import narrowed
    from aseme_dsl.project.proving.prove import NotThere, prove
    from aseme_dsl.proofs.explore.search import Limits
    from aseme_dsl.runtime.version.loading import LoadError

    compiled = one_system(target)
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, as_json, colour)
    progress = Progress(as_json)
    limits = Limits(states, budget * _NANOSECOND)
    try:
        only, names = narrowed(compiled, asked)
        found = prove(compiled, names, robots, limits, progress.say, horizon, only)
    except NotThere as problem:
        raise click.UsageError(str(problem)) from problem
    except (LoadError, OperateError) as problem:
        raise click.ClickException(str(problem)) from problem
    finally:
        progress.end()
    if as_json:
        print_json({"format": 1, "results": [item.as_json for item in found]})
    else:
        _show(found)
        if hint := _more(found, target, limits, robots, horizon):
            click.echo(hint)
    code = 0 if saved is None else _save(found, saved, compiled.root, as_json, colour)
    if stories is not None:
        code = max(code, _draw(found, stories, colour))
    return code or code_of(found, names)


def _save(found: tuple[Result, ...], path: Path, root: Path | Source, as_json: bool, colour: str) -> int:
    """Append the counterexamples, and say how many; 1 if the file cannot be written."""
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.proving.saving import cases_of
    from aseme_dsl.project.proving.saving import saved as text_of

    if not isinstance(root, Path):
        raise click.UsageError("--save: the system is in no file.")
    if not any(cases_of(found)):
        said = "nothing to save: there is no counterexample"
    else:
        text, new = text_of(found, path, root)
        problems = write_file(path, text.encode("utf-8")).diagnostics
        print_diagnostics(problems, colour)
        if has_errors(problems):
            return 1
        said = f"{plural(new, 'scenario')} added" if new else "it has these scenarios already"
    if not as_json:
        click.echo(f"{path}: {said}", err=True)
    return 0


def _draw(found: tuple[Result, ...], folder: Path, colour: str) -> int:
    """Write the sequence diagram of each counterexample; 1 if one cannot be written."""
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.proving.saving import pictures

    code = 0
    for name, text in pictures(found):
        check_outputs([(folder / name, "talk")])
        problems = write_file(folder / name, text.encode("utf-8")).diagnostics
        print_diagnostics(problems, colour)
        code = max(code, int(has_errors(problems)))
    return code


def code_of(found: tuple[Result, ...], asked: tuple[str, ...]) -> int:
    """0 if nothing is refuted, 1 if something is, 3 if something that was asked for is undecided."""
    from aseme_dsl.project.proving.results import Verdict

    if any(item.verdict is Verdict.REFUTED for item in found):
        return 1
    undecided = (item for item in found if item.verdict is Verdict.UNDECIDED)
    return 3 if any(asked or not item.is_built_in for item in undecided) else 0


def _show(found: tuple[Result, ...]) -> None:
    for item in found:
        click.echo(item.text)
        for number, line in enumerate(item.counterexample, 1):
            click.echo(f"  {number:>3}  {line}")


def _more(found: tuple[Result, ...], target: str, limits: Limits, robots: int, horizon: int | None) -> str:
    """How to ask for the first answer alone for which the search was cut; empty if there is none."""
    from aseme_dsl.project.proving.judging import CUT
    from aseme_dsl.runtime.time.clock import SECOND, at_text

    first = next((item for item in found if CUT in item.reason), None)
    if first is None:
        return ""
    is_time = not first.reason.endswith((" state", " states"))
    more = ["--budget", at_text(round(5 * limits.seconds * SECOND))]
    if not is_time:
        more = ["--states", str(5 * limits.states)]
    several = len({item.of for item in found if item.name == first.name}) > 1
    of = [first.of.removeprefix("protocol ")] if several else []
    words = ["asemec", "prove", target, *of, first.name, *more]
    words += ["--robots", str(robots)] if robots != _ROBOTS else []
    words += ["--horizon", at_text(horizon)] if horizon is not None else []
    return f"hint: to decide it, ask for it alone, with a larger limit: {shlex.join(words)}"


__all__ = ["command"]
