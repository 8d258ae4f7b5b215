"""`asemec lsp`: the language server that editors start."""

from __future__ import annotations

import gc
import os
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.compiler import Options
    from aseme_dsl.compiler.read.memory import Memory
    from aseme_dsl.diagnostics import Diagnostic, Suppressed
    from aseme_dsl.editor.answers.navigation import PythonFolders
    from aseme_dsl.editor.files.workspace import Project

LOOPBACK = "127.0.0.1"

_BOOT = "import sys; sys.path[:] = {path!r}; from aseme_dsl.project.proving.process import main; main()"
PROVER = (sys.executable, "-P", "-c", _BOOT.format(path=sys.path))
"""What starts a process that proves, with the modules that this one has."""

INSTALL = 'pip install ".[editor]" (in a clone), or "aseme-dsl[editor]"'


@click.command(
    short_help="Start the language server.",
    help="Start the language server (LSP) on standard input and output. Editors start it themselves. It"
    " requires the extra `editor`.",
    epilog=f"Example: {INSTALL}   ·   asemec lsp --tcp 2087",
)
@click.option(
    "--tcp",
    "port",
    type=click.IntRange(1, 65535),
    metavar="PORT",
    help="For debugging: accept one editor at this port of 127.0.0.1.",
)
@click.option("--stdio", is_flag=True, hidden=True, help="What editors may say; it is the default.")
def command(port: int | None, stdio: bool) -> int:
    """Serve until the editor leaves."""
    if find_spec("pygls") is None:
        raise click.ClickException(f"the language server requires pygls, which is not installed: {INSTALL}")
    from aseme_dsl import __version__
    from aseme_dsl.editor.server import make_server

    gc.disable()  # the server collects when no request waits
    server = make_server(__version__, project(), _python_folders, prover=PROVER)
    server.tidying.tidies = True
    if port is None:
        # The protocol has standard output to itself; what else is printed goes where people may read it.
        output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
        os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
        server.tell = lambda text: click.echo(f"asemec lsp: {text}", err=True)
        server.start_io(stdout=output)
    else:
        server.start_tcp(LOOPBACK, port)
    return 0


def project() -> Project:
    """What projects on disk say, for an editor; of their Python, only what has changed is read again."""
    from aseme_dsl.compiler.read.memory import Memory
    from aseme_dsl.editor.files.workspace import Project

    known: dict[Path, Memory] = {}
    return Project(
        _options,
        lambda root, system: _code(root, system, known.setdefault(root, Memory())),
        lambda root, system, found: _without_read(root, system, found, known.setdefault(root, Memory())),
    )


def _options(root: Path) -> tuple[Options, tuple[Diagnostic, ...]]:
    """How the project of a root wants to be compiled, and what is wrong with its configuration."""
    from aseme_dsl.project.building.project import configuration_for, options_of

    configuration, problems = configuration_for(root)
    return options_of(configuration), problems


def _code(
    root: Path, system: System, memory: Memory
) -> tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]:
    """What the code of the activities gets wrong."""
    from aseme_dsl.project.building.project import code_problems, configuration_for

    return code_problems(system, configuration_for(root)[0], None, memory)


def _without_read(
    root: Path, system: System, found: tuple[Diagnostic, ...], memory: Memory
) -> tuple[Diagnostic, ...]:
    """Without what the code of the activities makes untrue."""
    from aseme_dsl.project.building.project import configuration_for, without_read

    return without_read(found, system, configuration_for(root)[0], None, memory)


def _python_folders(root: Path) -> PythonFolders:
    """Where the Python of a root is: its activities, and what functions name, from the project's folder."""
    from aseme_dsl.editor.answers.navigation import PythonFolders
    from aseme_dsl.project.building.build import activities_folder, choose
    from aseme_dsl.project.building.project import configuration_for
    from aseme_dsl.project.settings.configuration import OUTPUT

    configuration, _ = configuration_for(root)
    output = configuration.output or configuration.folder / OUTPUT
    choice = choose(configuration)
    activities = activities_folder(output, choice)
    return PythonFolders(activities, (configuration.folder, root.parent), choice.templates)


__all__ = ["command", "project"]
