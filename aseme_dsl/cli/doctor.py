"""`asemec doctor`: check the installed extras and tools, and the sockets of a run."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    colour_option,
    json_option,
    print_json,
    refuse,
    wants_colour,
)


@click.command(
    short_help="Check installed extras and tools.",
    help="List the libraries and tools that asemec uses, with their versions and how to install missing ones,"
    " and the sockets that a run of the project opens. The exit code is 1 if a required one is missing."
    f" {TARGET_HELP}",
    epilog="Example: asemec doctor",
)
@click.argument("target", required=False, type=FilePath())
@json_option
@colour_option
def command(target: str | None, as_json: bool, colour: str) -> int:
    """Print a line a tool, and what a run opens; 1 if a needed one is missing."""
    from aseme_dsl import __version__
    from aseme_dsl.project.settings.openings import openings
    from aseme_dsl.project.settings.target import configuration_of, project_here
    from aseme_dsl.project.settings.tools import tools

    configuration, problems = configuration_of(Path(target or project_here()))
    if problems and target is not None:  # without a project, too, there are tools
        return refuse(problems, as_json, colour)
    found = tools()
    opened = list(openings(configuration))
    broken = any(tool.needed and tool.found is None for tool in found)
    if as_json:
        print_json(
            {
                "version": __version__,
                "tools": [dataclasses.asdict(tool) for tool in found],
                "opens": [dataclasses.asdict(opening) for opening in opened],
            }
        )
        return int(broken)
    painted = wants_colour(colour, sys.stdout)
    click.echo(f"asemec {__version__}")
    width = max(len(tool.name) for tool in found)
    for tool in found:
        if tool.found is not None:
            mark, said = click.style("ok     ", fg="green"), tool.found
        elif tool.needed:
            mark, said = click.style("missing", fg="red"), f"required: {tool.advice}"
        else:
            mark, said = click.style("absent ", fg="yellow"), tool.advice
        line = f"  {mark}  {tool.name:<{width}}  {tool.purpose}\n           {'':<{width}}  {said}"
        click.echo(line, color=painted)
    click.echo("sockets of a run, by transport")
    width = max(len(opening.platform) for opening in opened)
    for opening in opened:
        click.echo(f"  {opening.platform:<{width}}  {opening.opens}\n  {'':<{width}}  {opening.reach}")
    return int(broken)
