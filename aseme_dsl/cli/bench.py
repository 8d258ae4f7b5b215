"""`asemec bench`: what a step of the statecharts of a file costs."""

from __future__ import annotations

from pathlib import Path

import click

from aseme_dsl.cli.shared import (
    FilePath,
    colour_option,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
)
from aseme_dsl.diagnostics import closest, has_errors


@click.command(
    short_help="Measure what a step of each role costs.",
    help="Generate the code of a system, play inputs that its roles can take to it, and say what a step"
    " costs: as agents run it, and as a plain statechart where a role is one. Inputs are drawn by a seed.",
    epilog="Example: asemec bench team.aseme   ·   asemec bench team.aseme --role player --steps 9000 --json",
)
@click.argument("file", metavar="FILE", type=FilePath())
@click.option("--role", "roles", multiple=True, metavar="ROLE", help="Only this role. May be repeated.")
@click.option("--steps", type=click.IntRange(1), default=2000, show_default=True, help="How many inputs.")
@click.option(
    "--rounds", type=click.IntRange(1), default=7, show_default=True, help="How often to time each."
)
@click.option("--seed", type=int, default=1, show_default=True, help="What the inputs are drawn from.")
@json_option
@colour_option
def command(
    file: str, roles: tuple[str, ...], steps: int, rounds: int, seed: int, as_json: bool, colour: str
) -> int:
    """Print the report in Markdown; 1 if the file has errors, or two ways to run a role do not agree."""
    from dataclasses import asdict
    from tempfile import TemporaryDirectory

    compiled = one_system(file)
    if compiled.system is None or has_errors(compiled.diagnostics):
        print_diagnostics(compiled.diagnostics, colour)
        return 1
    known = [chart.name for chart in compiled.system.iacs]
    for role in roles:
        if role not in known:
            near = closest(role, known)
            hint = f"Did you mean {near!r}?" if near else f"There are {', '.join(known)}."
            raise click.UsageError(f"{compiled.system.name} has no role {role!r}. {hint}")
    from aseme_dsl.build.bench import Different, bench, markdown

    path = [compiled.configuration.folder, Path(file).parent]
    with TemporaryDirectory(prefix="asemec-bench-") as folder:
        try:
            found = bench(
                compiled.system, Path(folder), path, roles=roles, steps=steps, rounds=rounds, seed=seed
            )
        except Different as problem:
            click.echo(f"nothing was timed, for the ways to run a role do not agree: {problem}", err=True)
            return 1
    if as_json:
        print_json(asdict(found))
    else:
        click.echo(markdown(found), nl=False)
    return 0
