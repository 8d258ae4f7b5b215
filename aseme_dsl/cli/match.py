"""`asemec match`: two teams play against each other."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import duration_option, function_of
from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.shared import (
    Refused,
    colour_option,
    diagnostics_json,
    folder_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
)
from aseme_dsl.diagnostics import Diagnostic, Severity, has_errors
from aseme_dsl.diagnostics.problems.running import TeamOfMatch

if TYPE_CHECKING:
    from aseme_dsl.project.playing.match import Contestant, Played, SideEnd

_FORM = "the .aseme file or project directory of a team"


@click.command(
    short_help="Play two teams against each other.",
    help="Run two teams in one simulated world, in virtual time, and count the points. HOME and AWAY are each"
    f" {_FORM}. Each team is a process of its own; names, topics, radio and messages of the teams are apart.",
    epilog="Example: asemec match alice/ bob/   ·   asemec match alice.aseme bob.aseme --seeds 10 --json",
)
@click.argument("home", metavar="HOME")
@click.argument("away", metavar="AWAY")
@click.option(
    "--world",
    metavar="MODULE:FUNCTION",
    callback=function_of,
    help="Factory function of the simulated world, looked for here.  [default: the football field]",
)
@click.option("--seeds", type=click.IntRange(1), default=1, show_default=True, help="Number of matches.")
@click.option("--seed", type=int, default=1, show_default=True, help="Seed of the first match.")
@click.option(
    "-j", "--jobs", type=click.IntRange(1), help="Parallel matches.  [default: half the number of cores]"
)
@duration_option(
    "Time limit of a match, such as 30s.  [default: none on the football field, else 1min]", may_be_zero=False
)
@folder_option(
    "-o",
    "--output",
    text="Directory of the traces of both teams and a picture (SVG) of each match.  [default: none]",
)
@click.option("-q", "--quiet", is_flag=True, help="Suppress progress output.")
@json_option
@colour_option
def command(
    home: str,
    away: str,
    world: str | None,
    seeds: int,
    seed: int,
    jobs: int | None,
    duration: int | None,
    output: Path | None,
    quiet: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Play and print the scores; 1 if a file has errors, or a team or one of its agents fails."""
    from aseme_dsl.project.playing.match import FIELD, Plan, play_matches
    from aseme_dsl.project.playing.play import PlayError
    from aseme_dsl.runtime.version.loading import importing

    chosen = range(seed, seed + seeds)
    parallel = min(jobs or max(1, (os.cpu_count() or 1) // 2), seeds)
    with TemporaryDirectory(prefix="asemec-match-", ignore_cleanup_errors=True) as folder:
        teams = [
            _contestant(target, Path(folder) / side, as_json, colour)
            for target, side in ((home, "home"), (away, "away"))
        ]
        if any(item is None for item in teams):
            return 1
        first, second = (item for item in teams if item is not None)
        plan = Plan(first, second, world or FIELD, duration, None if output is None else output.absolute())
        progress = Progress(quiet or as_json)
        done = 0

        def told() -> None:
            nonlocal done
            done += 1
            progress.say(f"{done} of {seeds} matches")

        try:
            with importing([Path.cwd()]):
                found = play_matches(plan, chosen, parallel, told)
        except PlayError as problem:
            raise Refused(problem.problems(world or FIELD), colour) from problem
        finally:
            progress.end()
    names = (first.lineup.name, second.lineup.name)
    if as_json:
        print_json({"result": _data(names, found), **diagnostics_json(())})
    else:
        _tell(names, found)
    wrong = _pictures(output, found) if output is not None else ()
    print_diagnostics(wrong, colour)
    return int(has_errors(wrong) or any(item.failed for item in found))


def _contestant(target: str, folder: Path, as_json: bool, colour: str) -> Contestant | None:
    """A team, generated into a folder; None if its file has errors, which are printed."""
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.match import Contestant
    from aseme_dsl.project.playing.operate import OperateError, generate_version
    from aseme_dsl.project.settings.configuration import OUTPUT
    from aseme_dsl.runtime.world.lineup import Lineup

    compiled = one_system(target)
    found = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    system = compiled.system
    if system is not None and not has_errors(found) and not system.teams:
        found.append(Diagnostic(TeamOfMatch(system.name), None, path=target))
    if system is None or has_errors(found):
        if as_json:
            print_json({"result": None, **diagnostics_json(found)})
        else:
            print_diagnostics(found, colour)
        return None
    print_diagnostics(found, colour)
    configuration = compiled.configuration
    choice = choose(configuration)
    try:
        package, _ = generate_version(system, folder, choice)
    except OperateError as problem:
        raise click.ClickException(str(problem)) from problem
    home = (configuration.output or Path(OUTPUT)).absolute()
    beside = Path(target).absolute().parent / "activities"
    is_alone = choice.activities is None and beside.is_dir()
    activities = beside if is_alone else activities_folder(home, choice).absolute()
    return Contestant(Lineup(system.name, system.agents), package, activities, configuration.folder.resolve())


def _tell(names: tuple[str, str], found: Sequence[Played]) -> None:
    """The scores as a table, the sum, and what went wrong."""
    home, away = names if names[0] != names[1] else (f"{names[0]} (home)", f"{names[1]} (away)")
    width, other = max(4, len(home)), max(4, len(away))
    click.echo(f"{'seed':>6}  {home:>{width}}  {away:>{other}}")
    for item in found:
        so_far = "" if item.over else f"  (after {item.time_ns / 1e9:g} s)"
        click.echo(f"{item.seed:>6}  {item.score[0]:>{width}g}  {item.score[1]:>{other}g}{so_far}")
    wins, draws, losses = _counts(found)
    if len(found) > 1:
        points = [sum(item.score[place] for item in found) for place in (0, 1)]
        click.echo(f"{'sum':>6}  {points[0]:>{width}g}  {points[1]:>{other}g}")
        click.echo(f"{home} wins {wins}, {away} wins {losses}, {draws} drawn")
    for item in found:
        for name, end in ((home, item.home), (away, item.away)):
            for line in _wrong(end):
                click.echo(f"{name}, seed {item.seed}: {line}", err=True)


def _counts(found: Sequence[Played]) -> tuple[int, int, int]:
    wins = sum(item.score[0] > item.score[1] for item in found)
    draws = sum(item.score[0] == item.score[1] for item in found)
    return wins, draws, len(found) - wins - draws


def _wrong(end: SideEnd) -> list[str]:
    """What went wrong in a team, a line each."""
    found = [] if end.broken is None else [f"the team is out: {end.broken}"]
    if end.end is not None:
        found += [f"failed: {line}" for line in end.end.failures]
        found += [line for line in end.end.faults if not any(line in other for other in end.end.failures)]
    return found


def _data(names: tuple[str, str], found: Sequence[Played]) -> dict[str, object]:
    """The result for programs."""
    wins, draws, losses = _counts(found)
    return {
        "home": names[0],
        "away": names[1],
        "wins": wins,
        "draws": draws,
        "losses": losses,
        "matches": [
            {
                "seed": item.seed,
                "score": list(item.score),
                "time": item.time_ns,
                "over": item.over,
                "story": list(item.story),
                "home": _side(item.home),
                "away": _side(item.away),
            }
            for item in found
        ],
    }


def _side(end: SideEnd) -> dict[str, object]:
    run = end.end
    return {
        "broken": end.broken,
        "reason": run.reason if run is not None else None,
        "failures": list(run.failures) if run is not None else [],
        "faults": list(run.faults) if run is not None else [],
    }


def _pictures(folder: Path, found: Sequence[Played]) -> tuple[Diagnostic, ...]:
    """Write the pictures; what is wrong with that."""
    from aseme_dsl.project.files.write import write_file

    wrong: list[Diagnostic] = []
    for item in found:
        if item.picture is not None:
            wrong += write_file(folder / f"match-{item.seed}.svg", item.picture.encode()).diagnostics
    return tuple(wrong)
