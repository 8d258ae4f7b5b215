"""`asemec status`: the running agents and their active states."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import key_option, not_done, reached
from aseme_dsl.cli.shared import json_option, print_json, running_option


@click.command(
    short_help="Show running agents and their active states.",
    help="Show the agents that run in real time from an output directory: the role, the model hash and the"
    " current activities of each.",
    epilog="Example: asemec status   ·   asemec status -o out --json",
)
@running_option
@key_option
@json_option
def command(output: Path, key: Path | None, as_json: bool) -> int:
    """Print what the processes say; 1 if there is none, or one does not answer."""
    from aseme_dsl.project.playing.operate import OperateError, look

    try:
        with reached(key, output) as robots:
            found, silent = look(output, robots)
    except OperateError as problem:
        raise not_done(problem.args, output) from problem
    if as_json:
        processes = [{"socket": str(node.socket), **node.status} for node in found]
        print_json({"processes": processes, "silent": list(silent)})
        return 1 if silent else 0
    for node in found:
        status = node.status
        click.echo(f"{status['system']}  model {status['model']}  {status['time'] / 1e9:.1f} s")
        for agent in status["agents"]:
            doing = ", ".join(agent["activities"]) or "no activity"
            if agent["over"]:
                doing = f"failed: {agent['failure']}" if agent["failure"] else "completed"
            click.echo(f"  {agent['name']:<12} {agent['role']:<12} model {agent['model']}  {doing}")
        for name, clock in status.get("clocks", {}).items():
            if clock["difference"]:  # that of another machine
                off, wrong = clock["difference"] / 1e6, (clock["uncertainty"] or 0) / 1e6
                click.echo(f"  {name:<12} clock differs by {off:.3f} ms, known to {wrong:.3f} ms")
    if silent:
        not_done(silent, output).show()
    return 1 if silent else 0
