"""`asemec team logs`: the recent records of a running team."""

from __future__ import annotations

import json
import time
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.reaching import key_option, not_done, reached
from aseme_dsl.cli.shared import running_option
from aseme_dsl.cli.terminal import harmless

if TYPE_CHECKING:
    from aseme_dsl.project.operating.logs import Line, Lines

PAUSE = 0.5
"""Seconds between two questions of `--follow`."""


@click.command(
    short_help="Show the recent records of a running team.",
    help="Show what each agent of a running team has recorded lately: faults, failures, lost and refused"
    " messages, connections, swaps and switches. A process keeps its last 1000 such records; the trace has"
    " all. The records are in the order of their times by each machine's clock.",
    epilog="Example: asemec team logs   ·   asemec team logs --key operator.toml --follow",
)
@running_option
@key_option
@click.option("-f", "--follow", is_flag=True, help="Show new records as they come, until Ctrl-C.")
@click.option(
    "-n",
    "--last",
    type=click.IntRange(1, 200),
    default=50,
    show_default=True,
    help="Number of records of each process.",
)
@click.option("--agent", "agents", multiple=True, metavar="NAME", help="Only this agent. Repeatable.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object a line.")
def command(
    output: Path, key: Path | None, follow: bool, last: int, agents: tuple[str, ...], as_json: bool
) -> int:
    """Print them; 1 if nothing runs, or a member does not answer."""
    from aseme_dsl.project.operating.logs import Logs
    from aseme_dsl.project.playing.operate import OperateError

    silent: tuple[str, ...] = ()
    try:
        with reached(key, output) as robots:
            logs = Logs(output, robots, last)
            while True:
                found = logs.new()
                _print(found, agents, as_json)
                now = tuple(item.reason for item in found.silent)
                if now and now != silent:
                    not_done(map(harmless, now), output).show()
                silent = now
                if not follow:
                    return int(bool(silent))
                time.sleep(PAUSE)
    except OperateError as problem:
        raise not_done(problem.args, output) from problem


def _print(found: Lines, agents: tuple[str, ...], as_json: bool) -> None:
    from aseme_dsl.project.operating.logs import as_data

    for name, number in found.missed.items():
        click.echo(f"note: {number} records of {name} are only in its trace", err=True)
    for line in found.lines:
        if agents and not _is_about(line, agents):
            continue
        click.echo(json.dumps(as_data(line), ensure_ascii=False) if as_json else _text(line))


def _is_about(line: Line, agents: tuple[str, ...]) -> bool:
    named = line.record.get("agents")
    about = {line.record.get("agent"), *(named if isinstance(named, list) else ())}
    return line.process in agents or not about.isdisjoint(agents)


def _text(line: Line) -> str:
    from aseme_dsl.project.operating.telling import record_agent, record_text

    at = datetime.fromtimestamp(line.at).strftime("%H:%M:%S.%f")[:-3]
    who = record_agent(line.record) or line.process
    return harmless(f"{at}  {who:<12} {line.record.get('kind', '')}: {record_text(line.record)}")
