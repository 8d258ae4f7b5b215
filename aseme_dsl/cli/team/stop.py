"""`asemec team stop`: end the agents of a running team."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.reaching import cannot, key_option, not_done, reached, within_option
from aseme_dsl.cli.shared import json_option, print_json, running_option
from aseme_dsl.cli.terminal import harmless


@click.command(
    short_help="End the agents of a running team.",
    help="End the agents that run in real time from an output directory, one after the other: AGENTs in this"
    " order, or all in alphabetical order. The activities of each are cancelled, and its trace is closed.",
    epilog="Example: asemec team stop   ·   asemec team stop robot2 --key operator.toml",
)
@click.argument("agents", metavar="[AGENT]...", nargs=-1)
@running_option
@key_option
@within_option("10s", "Time for each process to end.")
@json_option
def command(agents: tuple[str, ...], output: Path, key: Path | None, within: float, as_json: bool) -> int:
    """Stop them; 1 if one did not answer or did not end."""
    from aseme_dsl.project.operating.stopping import stop
    from aseme_dsl.project.playing.operate import OperateError

    def tell(name: str) -> None:
        if not as_json:
            click.echo(f"{name} stopped")

    try:
        with reached(key, output) as robots:
            done = stop(output, robots, agents, within=within, tell=tell)
    except OperateError as problem:
        return cannot(problem, output, as_json, stopped=[])
    if as_json:
        print_json({"ok": not done.problems, "stopped": list(done.ended), "reasons": list(done.problems)})
    elif done.problems:
        raise not_done(map(harmless, done.problems), output)
    return int(bool(done.problems))
