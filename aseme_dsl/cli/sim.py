"""`asemec sim`: step through a run in virtual time, forwards and backwards, and change it on the way."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import (
    TARGET_HELP,
    activities_option,
    colour_option,
    one_system,
    plural,
    refuse,
    target_argument,
)
from aseme_dsl.cli.stepping import WrongCommand, news, obey
from aseme_dsl.diagnostics import Severity, closest, has_errors

if TYPE_CHECKING:
    from aseme_dsl.play.scenario import Scenario
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.stepping.stepper import Stepper


LONGEST = 100_000
"""So long may a command be."""


@click.command(
    short_help="Step through a run.",
    help="Step through a run in virtual time, forwards and backwards, and give it inputs on the way."
    " Activities are simulated, unless the scenario says otherwise. On a terminal, a full screen shows"
    f" statecharts, values and source. Otherwise, commands are read from standard input. {TARGET_HELP}",
    epilog="Example: asemec sim team.aseme   ·   asemec sim -k ball --plain",
)
@target_argument
@click.option("-k", "name", metavar="NAME", help="Begin with the scenario whose name contains NAME.")
@click.option("--seed", type=int, metavar="N", help="Seed.  [default: the project's, else 1]")
@click.option("--plain", is_flag=True, help="Read commands and print lines, also on a terminal.")
@activities_option
@colour_option
def command(
    target: str, name: str | None, seed: int | None, plain: bool, activities: Path | None, colour: str
) -> int:
    """Step; 1 if the file has errors, or a command of a script was wrong."""
    from aseme_dsl.project.testing.playing import scenarios_in

    compiled = one_system(target, activities)
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, False, colour)
    scenario = _named(scenarios_in(compiled), name) if name is not None else None
    with stepper_for(compiled, scenario, seed, activities) as stepper:
        if plain or not (sys.stdin.isatty() and sys.stdout.isatty()):
            return _plain(stepper)
        return _on_screen(stepper)


@contextmanager
def stepper_for(
    compiled: Compiled,
    scenario: Scenario | None,
    seed: int | None,
    activities: Path | None,
    statements: tuple[str, ...] = (),
) -> Iterator[Stepper]:
    """A run of a system without errors that is stepped through, of a scenario or of these statements."""
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.operate import generate_version, loaded_for
    from aseme_dsl.project.settings.configuration import OUTPUT
    from aseme_dsl.project.stepping.running import NotPlayable, Stage
    from aseme_dsl.project.stepping.session import NotUnderstood, opened
    from aseme_dsl.project.stepping.stepper import Stepper

    assert compiled.system is not None
    configuration = compiled.configuration
    chosen = configuration.seed if seed is None else seed
    choice = choose(configuration, activities=activities)
    folder_of_code = activities_folder(configuration.output or Path(OUTPUT), choice)
    with TemporaryDirectory(prefix="asemec-sim-") as folder:
        package, _ = generate_version(compiled.system, Path(folder), choice)
        loaded = loaded_for(package, configuration.folder.resolve())
        stage = Stage(loaded, configuration, folder_of_code, configuration.length)
        if scenario is not None and len(scenario.scripts) > 1:
            rest = plural(len(scenario.scripts) - 1, "further row")
            click.echo(f"note: this is the first row of its table; `asemec test` plays {rest}, too", err=True)
        session = opened(compiled, scenario, chosen)
        session = replace(session, statements=(*session.statements, *statements))
        try:
            stepper = Stepper(compiled, stage, session)
        except (NotPlayable, NotUnderstood) as problem:
            raise click.ClickException(f"{problem}.") from problem
        try:
            yield stepper
        finally:
            stepper.close()


def _named(scenarios: tuple[Scenario, ...], name: str) -> Scenario:
    """The scenario whose name contains `name`; none, or several, are wrong use."""
    found = [item for item in scenarios if name in item.name]
    if len(found) == 1:
        return found[0]
    names = [item.name for item in found or scenarios]
    near = closest(name, names)
    hint = f"Did you mean {near!r}?" if near and not found else f"Scenarios: {', '.join(names) or 'none'}."
    number = "No scenario has" if not found else f"{len(found)} scenarios have"
    raise click.UsageError(f"{number} {name!r} in the name. {hint}")


def _on_screen(stepper: Stepper) -> int:
    try:
        from aseme_dsl.cli.sim_screen import Screen
    except ImportError as missing:
        raise click.ClickException(
            "the screen needs Textual: pip install 'aseme-dsl[sim]', or use --plain."
        ) from missing
    Screen(stepper).run()
    return 0


def _plain(stepper: Stepper) -> int:
    """Read commands up to the end of input, or `quit`."""
    shows = sys.stdin.isatty()
    code = 0
    for line in news(stepper):
        click.echo(line)
    while True:
        if shows:
            click.echo("> ", nl=False)
        line = sys.stdin.readline(LONGEST)
        if not line or line.strip() == "quit":
            return code
        if not line.strip():
            line = "step"
        if not shows:
            click.echo(f"> {line.strip()}")
        try:
            for said in obey(stepper, line):
                click.echo(said)
        except WrongCommand as problem:
            click.echo(str(problem))
            code = 0 if shows else 1


__all__ = ["command", "stepper_for"]
