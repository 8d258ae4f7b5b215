"""`asemec select`: have a running agent follow another plan."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import key_option, not_done, reached
from aseme_dsl.cli.shared import json_option, print_json, running_option


@click.command(
    short_help="Have a running agent follow another plan.",
    help="Have AGENT, which runs in real time, leave its plan and enter PLAN: ROLE, or SYSTEM.ROLE, of any"
    " system whose package is in the output folder. Its activities are cancelled and its conversations left;"
    " role variables that both plans have, and the states that the agent knows, stay.",
    epilog="Example: asemec select robot2 goalie   ·   asemec select keeper Kouretes.player -o out",
)
@click.argument("agent")
@click.argument("plan")
@running_option
@key_option
@json_option
def command(agent: str, plan: str, output: Path, key: Path | None, as_json: bool) -> int:
    """Change it; 1 if it cannot be."""
    from aseme_dsl.project.playing.operate import OperateError, select

    try:
        with reached(key, output) as robots:
            reply = select(output, agent, plan, robots)
    except OperateError as problem:
        if as_json:
            print_json({"ok": False, "reasons": list(problem.args)})
            return 1
        raise not_done(problem.args, output) from problem
    if as_json:
        print_json(reply)
    else:
        click.echo(f"{agent} follows {reply['plan']} (model {reply['model']})")
    return 0
