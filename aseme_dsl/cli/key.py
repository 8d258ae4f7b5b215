"""`asemec key`: make an operator's key."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import FilePath, Refused
from aseme_dsl.diagnostics import Diagnostic


@click.command(
    short_help="Make an operator's key.",
    help="Make a key, and write it into FILE, which only you can read. Robots that accept this key can be"
    " controlled with it over their network: name a copy of FILE as `control` in [tool.asemec.deploy] of the"
    " pyproject.toml. No file that is there is overwritten.",
    epilog="Example: asemec key operator.toml",
)
@click.argument("file", type=FilePath(path_type=Path))
def command(file: Path) -> int:
    """Write it; 1 if it cannot be written."""
    from aseme_dsl.runtime.control.operator_key import KeyFileError, write_key

    try:
        key = write_key(file)
    except KeyFileError as problem:
        raise Refused([Diagnostic("E009", str(problem), None, path=str(file))]) from problem
    click.echo(f"{click.format_filename(file)} has the key {key.name}")
    return 0
