"""The options about coverage, of all commands that have them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
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


__all__ = ["Wanted", "fail_under_option", "too_little"]
