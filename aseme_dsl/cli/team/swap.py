"""`asemec team swap`: hot-swap a running team to a new model version."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import cannot, key_option, not_done, reached, within_option
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
from aseme_dsl.cli.terminal import harmless
from aseme_dsl.diagnostics import has_errors

SOME = 3
"""The exit code if some agents have changed, or may have, and others have not."""


@click.command(
    short_help="Hot-swap a running team to a new model version.",
    help="Compile TARGET and switch the agents that run from the output directory to the new model. Each"
    " agent keeps its active states and its data. The swap happens between two steps, for all agents of the"
    " team or for none; with --quorum, for at least so many. It is refused if an agent is in a state that"
    f" TARGET does not have. The exit code is 3 if only some agents have changed, or may have. {TARGET_HELP}",
    epilog="Example: asemec team swap team.aseme   ·   asemec team swap half_time.aseme -o out --within 5s",
)
@target_argument
@folder_option(
    "-o", "--output", text="Output directory that the team runs from.  [default: the project's, else out]"
)
@key_option
@within_option("10s", "Time to wait for conversations of changed protocols.")
@click.option(
    "--quorum",
    metavar="all|N",
    default="all",
    show_default=True,
    help="Number of agents that have to change, at least a majority of the team.",
)
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
    quorum: str,
    agents: tuple[str, ...],
    activities: Path | None,
    as_json: bool,
    colour: str,
) -> int:
    """Swap; 1 if the file has errors or no agent has changed, 3 if only some have, or may have."""
    from aseme_dsl.diagnostics import Severity
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.operating.swapping import swap
    from aseme_dsl.project.operating.whole_team import whole_team
    from aseme_dsl.project.playing.operate import OperateError, activities_of, write_version
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
            team = whole_team(output, robots)
            if not team.nodes:  # then nothing is written
                raise OperateError(*team.reasons())
            choice = choose(compiled.configuration)
            far = robots is not None  # their folders are not of this machine
            code = activities or (activities_folder(output, choice) if far else activities_of(team.nodes))
            name, model = write_version(compiled.system, output, choice, code)
            done = swap(team, name, within=within, agents=agents or None, quorum=quorum)
    except OperateError as problem:
        return cannot(problem, output, as_json, "nothing has changed:", **diagnostics_json(found))
    status = 0 if done.is_whole else SOME if done.changed or done.unknown else 1
    if as_json:
        told: dict[str, object] = {"changed": list(done.changed), "unchanged": dict(done.unchanged)}
        told["unknown"] = list(done.unknown)
        told |= {"epoch": done.epoch, "hash": name, "notes": list(done.notes)}
        print_json({"ok": status == 0, "model": model, **told, **diagnostics_json(found)})
        return status
    for note in done.notes:
        click.echo(f"note: {note}", err=True)
    if done.changed:
        whom = compiled.system.name if status == 0 else ", ".join(done.changed)
        click.echo(f"{whom} swapped to model {model}")
    if status:
        first = "not all agents have changed:" if status == SOME else "nothing has changed:"
        reasons = [harmless(f"{agent}: {why}") for agent, why in sorted(done.unchanged.items())]
        not_done(reasons, output, first).show()
    return status
