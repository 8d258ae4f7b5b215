"""`asemec key`: create an operator's key."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import FilePath, Refused
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.writing import KeyNotWritten


@click.command(
    short_help="Create an operator's key.",
    help="Create an operator's key and write it to FILE, which only you can read. To let operators control"
    " agents over the network, name a copy of FILE as `control` in [tool.asemec.deploy] of the"
    " pyproject.toml. An existing file is never overwritten.",
    epilog="Example: asemec key operator.toml",
)
@click.argument("file", type=FilePath(path_type=Path))
def command(file: Path) -> int:
    """Write it; 1 if it cannot be written."""
    from aseme_dsl.runtime.control.operator_key import KeyFileError, write_key

    try:
        key = write_key(file)
    except KeyFileError as problem:
        raise Refused([Diagnostic(KeyNotWritten(str(problem)), None, path=str(file))]) from problem
    click.echo(f"key {key.name} written to {click.format_filename(file)}")
    return 0
