"""`asemec key`: create an operator's key."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import FilePath, Refused
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.writing import KeyNotWritten


@click.command(
    short_help="Create an operator's key.",
    help="Create an operator's key and write it to FILE, which only you can read. To be controlled over the"
    " network, each agent needs a file made with --of and --for; `asemec deploy` makes it. Name the file as"
    " `control` in [tool.asemec.deploy] of the pyproject.toml. An existing file is never overwritten.",
    epilog="Example: asemec key operator.toml   ·   asemec key robot1.toml --of operator.toml --for robot1",
)
@click.argument("file", type=FilePath(path_type=Path))
@click.option(
    "--of",
    "source",
    type=FilePath(path_type=Path),
    metavar="KEYS",
    help="Write what an agent needs of the keys in this file. With it, the agent cannot control others.",
)
@click.option("--for", "agents", multiple=True, metavar="AGENT", help="The agent, for --of. Repeatable.")
def command(file: Path, source: Path | None, agents: tuple[str, ...]) -> int:
    """Write it; 1 if it cannot be written."""
    from aseme_dsl.runtime.control.operator_key import KeyFileError, write_key, write_keys_for

    if (source is None) != (not agents):
        raise click.UsageError("--of and --for belong together.")
    try:
        if source is not None:
            write_keys_for(file, source, agents)
            click.echo(f"keys for {', '.join(agents)} written to {click.format_filename(file)}")
            return 0
        key = write_key(file)
    except KeyFileError as problem:
        raise Refused([Diagnostic(KeyNotWritten(str(problem)), None, path=str(file))]) from problem
    click.echo(f"key {key.name} written to {click.format_filename(file)}")
    return 0
