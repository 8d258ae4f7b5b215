"""`asemec test`: play the scenarios of a system, and say what they have shown."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl import outside
from aseme_dsl.cli.covering import Wanted, check_page, fail_under_option, html_option, too_little, write_page
from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.report import form_of
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    activities_option,
    check_outputs,
    cluster_option,
    colour_option,
    crew_of,
    folder_option,
    one_system,
    plural,
    print_diagnostics,
    print_json,
    refuse,
    target_argument,
    wants_colour,
)
from aseme_dsl.diagnostics import Severity, closest, has_errors

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Sequence

    from aseme_dsl.amola.system import System
    from aseme_dsl.play.coverage.measure import Coverage
    from aseme_dsl.play.scenario import Scenario
    from aseme_dsl.project.testing.verdicts import ScenarioResult


@click.command(
    short_help="Play the scenarios of a system.",
    help="Play each scenario in virtual time, and say whether what it expects was so. Activities are"
    f" simulated, unless a scenario says otherwise. {TARGET_HELP}",
    epilog="Example: asemec test team.aseme   ·   asemec test -k ball --seeds 50 -j 4",
)
@target_argument
@click.option("-k", "name", metavar="NAME", help="Only the scenarios whose name contains NAME.")
@click.option(
    "--seeds",
    type=click.IntRange(1),
    metavar="N",
    help="Seeds 1 to N.  [default: the project's seed, else 1]",
)
@click.option(
    "-j", "--jobs", type=click.IntRange(1), metavar="N", help="Number of processes.  [default: one a CPU]"
)
@cluster_option
@click.option(
    "--role",
    "bindings",
    metavar="ROLE=AGENT",
    multiple=True,
    help="The agent that `any ROLE` is; may be repeated.",
)
@activities_option
@click.option("--coverage", "measures", is_flag=True, help="Tell what the scenarios reach of the system.")
@click.option(
    "--coverage-file",
    "coverage_file",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Output file (.json) of the coverage, for `asemec coverage`.",
)
@html_option
@fail_under_option
@click.option(
    "--save",
    "saved",
    type=FilePath(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Append the smallest case of each failure to FILE, as a scenario.",
)
@folder_option("--stories", text="Directory for a sequence diagram (SVG) of each failure.")
@folder_option("--traces", text="Directory for a trace of each failure, for `asemec why` and `whynot`.")
@click.option(
    "--format",
    "form",
    type=click.Choice(["text", "json", "junit", "github"]),
    help="Output format; github: workflow commands.  [default: text]",
)
@click.option("--json", "as_json", is_flag=True, help="Short for --format json.")
@colour_option
def command(
    target: str,
    name: str | None,
    seeds: int | None,
    jobs: int | None,
    cluster: str | None,
    bindings: tuple[str, ...],
    activities: Path | None,
    measures: bool,
    coverage_file: Path | None,
    html: Path | None,
    wanted: Wanted,
    saved: Path | None,
    stories: Path | None,
    traces: Path | None,
    form: str | None,
    as_json: bool,
    colour: str,
) -> int:
    """Print the verdicts; 1 if the file has errors, a scenario has not passed, too little is covered."""
    from aseme_dsl.play.coverage.measure import measured
    from aseme_dsl.play.coverage.seen import Seen
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.settings.configuration import OUTPUT
    from aseme_dsl.project.spreading.cluster import ClusterError
    from aseme_dsl.project.testing.coverage import model_of, written
    from aseme_dsl.project.testing.playing import play_scenarios, scenarios_in

    form = form_of(form, as_json, None)
    crew = crew_of(jobs, cluster)
    if coverage_file is not None:
        if coverage_file.suffix != ".json":
            raise click.UsageError("--coverage-file: the name of the file must end in .json.")
        check_outputs([(coverage_file, "coverage")], [target])
    check_page(html, [target])
    compiled = one_system(target, activities)
    wrong = [item for item in compiled.diagnostics if item.severity is not Severity.NOTE]
    if compiled.system is None or has_errors(wrong):
        return refuse(wrong, form == "json", colour)
    bound = _bound(bindings, [chart.name for chart in compiled.system.iacs])
    scenarios = _chosen(scenarios_in(compiled, bound), name)
    configuration = compiled.configuration
    choice = choose(configuration, activities=activities)
    progress = Progress(form != "text")
    seen = Seen() if measures or coverage_file is not None or html is not None or wanted else None
    try:
        tested = play_scenarios(
            compiled.system,
            scenarios,
            range(1, seeds + 1) if seeds is not None else (configuration.seed,),
            configuration,
            choice,
            activities_folder(configuration.output or Path(OUTPUT), choice),
            crew,
            progress.say,
            seen,
            traces,
        )
    except OSError as problem:
        raise click.ClickException(f"--traces: {problem}.") from problem
    except ClusterError as problem:
        raise click.ClickException(f"{problem}.") from problem
    finally:
        progress.end()
    code = int(any(item.verdict != "passed" for item in tested))
    if stories is not None:
        code = max(code, _draw(tested, stories, colour))
    if saved is not None and (cases := "\n".join(item.shrunk for item in tested if item.shrunk)):
        before = outside.read_bytes(saved) + b"\n" if saved.exists() else b""
        found = write_file(saved, before + cases.encode("utf-8")).diagnostics
        print_diagnostics(found, colour)
        code = max(code, int(has_errors(found)))
    coverage = None
    if seen is not None:
        model = model_of(compiled.system, choice)
        coverage = measured(model.system, seen)
        if coverage_file is not None:
            found = write_file(coverage_file, written(model, seen)).diagnostics
            print_diagnostics(found, colour)
            code = max(code, int(has_errors(found)))
        code = max(code, write_page(html, model.system, coverage, colour))
    file = str(compiled.root if isinstance(compiled.root, Path) else target)
    _print(tested, form, file, colour, coverage if measures else None)
    if not tested and form == "text":
        click.echo("\n".join(_first(compiled.system)))
    return code if coverage is None else max(code, too_little(coverage, wanted))


def _draw(tested: Sequence[ScenarioResult], folder: Path, colour: str) -> int:
    """Write the sequence diagram of each failure; 1 if one cannot be written."""
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.testing.story_pictures import pictures

    code = 0
    for name, text in pictures(tested):
        check_outputs([(folder / name, "talk")])
        found = write_file(folder / name, text.encode("utf-8")).diagnostics
        print_diagnostics(found, colour)
        code = max(code, int(has_errors(found)))
    return code


def _bound(bindings: Sequence[str], roles: Collection[str]) -> dict[str, str]:
    """The agents by the roles that they are chosen for. Raises UsageError."""
    found: dict[str, str] = {}
    for text in bindings:
        role, sign, agent = text.partition("=")
        if not (sign and role and agent):
            raise click.UsageError(f"--role is written ROLE=AGENT, as in player=robot1, not {text!r}.")
        if role not in roles:
            near = closest(role, roles)
            hint = f" Did you mean {near!r}?" if near else ""
            raise click.UsageError(f"--role {text}: there is no role {role!r}.{hint}")
        found[role] = agent
    return found


def _chosen(scenarios: Sequence[Scenario], name: str | None) -> list[Scenario]:
    """The scenarios whose name contains `name`; no such scenario is wrong use."""
    found = [item for item in scenarios if name is None or name in item.name]
    if name is not None and not found:
        names = [item.name for item in scenarios]
        near = closest(name, names)
        hint = f"Did you mean {near!r}?" if near else f"Scenarios: {', '.join(names) or 'none'}."
        raise click.UsageError(f"No scenario has {name!r} in its name. {hint}")
    return found


def _print(
    results: Sequence[ScenarioResult], form: str, file: str, colour: str, coverage: Coverage | None
) -> None:
    from aseme_dsl.project.testing.coverage_report import data, lines
    from aseme_dsl.project.testing.reports import github, junit

    match form:
        case "json":
            measured = {} if coverage is None else {"coverage": data(coverage)}
            print_json({"scenarios": [_data(item) for item in results], **measured})
        case "junit":
            click.echo(junit(results, file), nl=False)
        case "github":
            click.echo(github(results), nl=False)
        case _:
            for line in _lines(results, wants_colour(colour, sys.stdout)):
                click.echo(line)
            if coverage is not None:
                click.echo("\n".join(("", *lines(coverage))))


def _first(system: System) -> Iterator[str]:
    """A first scenario that the system could have."""
    from aseme_dsl.amola.statechart import StateType

    agents = [(agent.name, agent.role) for team in system.teams for agent in team.agents]
    charts = {chart.name: chart for chart in system.iacs}
    name, role = next(iter(agents or ((name, name) for name in charts)), ("", ""))
    states = charts[role].states if role in charts else ()
    state = next((item.activity for item in states if item.type is StateType.BASIC and item.activity), None)
    if state is None:
        return
    yield "write one in the file, for example:"
    yield f'  scenario "{name} begins" {{'
    yield f"    {name} : {role}"
    yield f"    by 3s {name} in {state}"
    yield "  }"


def _data(item: ScenarioResult) -> dict[str, object]:
    reason = f"{item.span}: {item.reason}" if item.span is not None else item.reason
    return {
        "name": item.name,
        "verdict": str(item.verdict),
        "seed": item.seed,
        "time_ns": item.time_ns,
        "reason": reason,
        **({} if item.points is None else {"points": item.points}),
    }


def _lines(tested: Sequence[ScenarioResult], is_coloured: bool) -> Iterator[str]:
    """The verdicts for people: the reason of each with its place and what happened last, then the numbers."""
    from aseme_dsl.project.testing.reports import COLOURS, explained
    from aseme_dsl.project.testing.verdicts import never_met
    from aseme_dsl.runtime.time.clock import shown

    width = max((len(item.name) for item in tested), default=0)
    for item in tested:
        verdict = f"{item.verdict:8}"
        if is_coloured:
            verdict = f"\x1b[{COLOURS[item.verdict]}m{verdict}\x1b[0m"
        runs = f"  {item.runs} runs" if item.runs > 1 else ""
        yield f"{verdict} {item.name:{width}}  seed {item.seed}  {shown(item.time_ns)}{runs}"
        yield from explained(item, is_coloured)
    counts = [(sum(item.verdict == verdict for item in tested), verdict) for verdict in COLOURS]
    said = ", ".join(f"{number} {verdict}" for number, verdict in counts if number)
    yield f"{plural(len(tested), 'scenario')}{': ' if said else ''}{said}"
    for of, span in never_met(tested):
        yield f"note: {span}: {of}: what it speaks of has not happened in any run"
    points = [(item.points, item.verdict == "passed") for item in tested if item.points is not None]
    if points:
        got = sum(number for number, has_passed in points if has_passed)
        yield f"{got} of {plural(sum(number for number, _ in points), 'point')}"
