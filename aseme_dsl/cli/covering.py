"""The options about coverage, of all commands that have them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import FilePath, check_outputs, print_diagnostics
from aseme_dsl.diagnostics import has_errors

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.play.coverage.measure import Coverage, Kind

Wanted = tuple[tuple["Kind", float], ...]


def _wanted(context: click.Context, parameter: click.Parameter, values: Iterable[str]) -> Wanted:
    from aseme_dsl.diagnostics import closest
    from aseme_dsl.play.coverage.measure import Kind
    from aseme_dsl.project.testing.coverage_report import kind_of

    found: list[tuple[Kind, float]] = []
    for value in values:
        word, sign, number = value.rpartition("=")
        kind = kind_of(word) if sign else Kind.STATES
        if kind is None:
            words = [kind.replace(" ", "-") for kind in Kind]
            near = closest(word, words)
            hint = f"Did you mean {near!r}?" if near else f"Kinds: {', '.join(words)}."
            raise click.BadParameter(f"nothing called {word!r} is counted. {hint}")
        try:
            percent = float(number)
        except ValueError:
            percent = -1
        if not 0 <= percent <= 100:
            raise click.BadParameter(f"{number!r} is not a number from 0 to 100, as in 90 or transitions=80")
        found.append((kind, percent))
    return tuple(found)


fail_under_option = click.option(
    "--fail-under",
    "wanted",
    multiple=True,
    metavar="[KIND=]PERCENT",
    callback=_wanted,
    help="Exit with 1 if less is covered: 90 (of the states), transitions=80.",
)


def too_little(coverage: Coverage, wanted: Wanted) -> int:
    """Say what is covered too little; 1 if something is."""
    from aseme_dsl.project.testing.coverage_report import below

    said = list(below(coverage, wanted))
    for line in said:
        click.echo(line, err=True)
    return int(bool(said))


html_option = click.option(
    "--html",
    type=FilePath(path_type=Path),
    metavar="FILE",
    help="Output file of a page (.html) with the coverage and the statecharts in colours.",
)


def check_page(page: Path | None, inputs: Iterable[Path | str]) -> None:
    """Refuse a page that has the name of something else, or would be written over a file of the user."""
    if page is not None:
        if page.suffix not in (".html", ".htm"):
            raise click.UsageError("--html: the name of the file must end in .html.")
        check_outputs([(page, "coverage")], inputs)


def write_page(page: Path | None, system: System, coverage: Coverage, colour: str) -> int:
    """Write the page, if one is wanted; 1 if it cannot be written."""
    if page is None:
        return 0
    from aseme_dsl.project.files.write import write_file
    from aseme_dsl.project.testing.coverage_page import page as made

    found = write_file(page, made(system, coverage).encode()).diagnostics
    print_diagnostics(found, colour)
    return int(has_errors(found))


__all__ = ["Wanted", "check_page", "fail_under_option", "html_option", "too_little", "write_page"]
