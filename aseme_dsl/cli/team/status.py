"""`asemec team status`: the agents of a running team, on all hosts."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.reaching import cannot, key_option, not_done, reached
from aseme_dsl.cli.shared import json_option, print_json, running_option
from aseme_dsl.cli.terminal import harmless

if TYPE_CHECKING:
    from aseme_dsl.project.playing.remote import Robot


@click.command(
    short_help="Show the agents of a running team.",
    help="Show the agents that run in real time from an output directory: role, model hash, activities and"
    " connections of each. Show the CPU and memory of each process, too. The command names members of the"
    " team that do not answer, and its exit code is then 1.",
    epilog="Example: asemec team status   ·   asemec team status --key operator.toml --watch",
)
@running_option
@key_option
@click.option("--watch", is_flag=True, help="Show the team on a screen that is renewed each second.")
@json_option
def command(output: Path, key: Path | None, watch: bool, as_json: bool) -> int:
    """Print what the processes say; 1 if there is none, or a member does not answer."""
    from aseme_dsl.project.operating.telling import status_lines
    from aseme_dsl.project.operating.whole_team import as_data, whole_team
    from aseme_dsl.project.playing.operate import OperateError

    if watch and as_json:
        raise click.UsageError("--watch and --json exclude each other.")
    if watch and not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise click.UsageError("--watch needs a terminal.")
    try:
        with reached(key, output) as robots:
            if watch:
                return _watched(output, robots)
            team = whole_team(output, robots)
    except OperateError as problem:
        return cannot(problem, output, as_json)
    if as_json:
        print_json(as_data(team))
        return int(not team.is_whole)
    for line in status_lines(team):
        click.echo(harmless(line))
    if not team.is_whole:
        not_done(map(harmless, team.reasons()), output).show()
    return int(not team.is_whole)


def _watched(output: Path, robots: Sequence[Robot] | None) -> int:
    try:
        from aseme_dsl.cli.team.screen import Screen
    except ImportError as missing:
        raise click.ClickException("the screen needs Textual: pip install 'aseme-dsl[sim]'.") from missing
    Screen(output, robots).run()
    return 0
