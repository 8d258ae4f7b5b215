"""`asemec team swap`: hot-swap a running team to a new model version."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import key_option, not_done, reached, within_option
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    colour_option,
    diagnostics_json,
    folder_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    target_argument,
)
from aseme_dsl.diagnostics import has_errors


@click.command(
    short_help="Hot-swap a running team to a new model version.",
    help="Compile TARGET and switch the agents that run from the output directory to the new model. Each"
    " agent keeps its active states and its data. The swap happens between two steps, for all agents or for"
    f" none. It is refused if an agent is in a state that TARGET does not have. {TARGET_HELP}",
    epilog="Example: asemec team swap team.aseme   ·   asemec team swap half_time.aseme -o out --within 5s",
)
@target_argument
@folder_option(
    "-o", "--output", text="Output directory that the team runs from.  [default: the project's, else out]"
)
@key_option
@within_option("10s", "Time to wait for conversations of changed protocols.")
@click.option("--agent", "agents", multiple=True, metavar="NAME", help="Only this agent. Repeatable.")
@folder_option(
    "--activities", text="Directory of the new version's activities.  [default: that of the running team]"
)
@json_option
@colour_option
def command(
    target: str,
    output: Path | None,
    key: Path | None,
    within: float,
    agents: tuple[str, ...],
    activities: Path | None,
    as_json: bool,
    colour: str,
) -> int:
    """Swap; 1 if the file has errors or the swap is refused."""
    from aseme_dsl.diagnostics import Severity
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.playing.operate import (
        OperateError,
        PartlyDone,
        activities_of,
        nodes,
        swap,
        write_version,
    )
    from aseme_dsl.project.settings.configuration import OUTPUT

    compiled = one_system(target, activities)
    found = tuple(item for item in compiled.diagnostics if item.severity is not Severity.NOTE)
    if not as_json:
        print_diagnostics(found, colour)
    if compiled.system is None or has_errors(found):
        if as_json:
            print_json({"ok": False, "reasons": ["the file has errors"], **diagnostics_json(found)})
        return 1
    output = output or compiled.configuration.output or Path(OUTPUT)
    try:
        with reached(key, output, compiled.system.name) as robots:
            there = nodes(output, robots)  # before anything is written
            choice = choose(compiled.configuration)
            far = robots is not None  # their folders are not of this machine
            code = activities or (activities_folder(output, choice) if far else activities_of(there))
            name, model = write_version(compiled.system, output, choice, code)
            replies = swap(output, name, within=within, agents=agents or None, robots=robots)
    except OperateError as problem:
        if as_json:
            print_json({"ok": False, "reasons": list(problem.args), **diagnostics_json(found)})
            return 1
        partly = isinstance(problem, PartlyDone)
        what = "not all robots have changed:" if partly else "nothing has changed:"
        raise not_done(problem.args, output, what) from problem
    notes = [note for reply in replies for note in reply["notes"]]
    if as_json:
        print_json({"ok": True, "model": model, "notes": notes, **diagnostics_json(found)})
        return 0
    for note in notes:
        click.echo(f"note: {note}", err=True)
    click.echo(f"{compiled.system.name} swapped to model {model}")
    return 0
