"""`asemec team switch`: have a running agent take another role."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import cannot, key_option, reached
from aseme_dsl.cli.shared import json_option, print_json, running_option


@click.command(
    short_help="Switch a running agent to another role.",
    help="Switch AGENT, which runs in real time, to ROLE (or SYSTEM.ROLE) of any system in the output"
    " directory. The switch cancels the agent's activities and leaves its conversations. Variables that both"
    " roles have, and received state messages, keep their values.",
    epilog="Example: asemec team switch robot2 goalie   ·   asemec team switch keeper Kouretes.player -o out",
)
@click.argument("agent")
@click.argument("role")
@running_option
@key_option
@json_option
def command(agent: str, role: str, output: Path, key: Path | None, as_json: bool) -> int:
    """Switch it; 1 if it is refused."""
    from aseme_dsl.project.playing.operate import OperateError, select

    try:
        with reached(key, output) as robots:
            reply = select(output, agent, role, robots)
    except OperateError as problem:
        return cannot(problem, output, as_json)
    if as_json:
        print_json(reply)
    else:
        click.echo(f"{agent} switched to {reply['plan']} (model {reply['model']})")
    return 0
