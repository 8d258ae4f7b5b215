"""`asemec team`: look at a running team, and change it."""

from __future__ import annotations

import click

from aseme_dsl.cli.groups import LazyGroup

NAMES = ("status", "swap", "switch", "logs", "stop")
"""The commands, in the order of the help."""


class _TeamCommands(LazyGroup):
    """The commands of `asemec team`."""

    package = "aseme_dsl.cli.team"
    names = NAMES


@click.group(
    cls=_TeamCommands,
    short_help="Show, change and stop a running team.",
    help="Show, change and stop a team that runs in real time from an output directory. The commands use the"
    " control sockets of this machine or, with --key, the network of the agents.",
    epilog="Example: asemec team status   ·   asemec team status --key operator.toml --watch",
)
def command() -> None:
    """The group; click runs the command that is named."""
