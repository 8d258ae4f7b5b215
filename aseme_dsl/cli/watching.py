"""Watching: a command that is done again whenever what it depends on changes, until Ctrl-C (`--watch`)."""

from __future__ import annotations

import gc
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import plural, print_diagnostics
from aseme_dsl.diagnostics import Diagnostic, Severity
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.project.building.watch import Changes
    from aseme_dsl.project.building.workshop import Workshop

_NAMED = 6
"""How many files are named; of more, it is said how many they are."""


@dataclass(frozen=True, slots=True)
class Done:
    """What came of doing a command once: all that there is to say, in a line or more, and what it wrote."""

    diagnostics: tuple[Diagnostic, ...]
    compiled: tuple[Compiled, ...]
    said: str
    written: tuple[Path, ...] = ()


def refuse_to_watch(files: Sequence[str], form: str, report: Path | None) -> None:
    """Say what does not go together with `--watch`."""
    if "-" in files:
        raise click.UsageError("--watch waits for file changes: not with standard input.")
    if form != "text" or report is not None:
        raise click.UsageError("--watch prints text: not with --format, --json or a report file.")


def watch(
    do: Callable[[Workshop], Done],
    files: Sequence[str],
    activities: Path | None,
    templates: Path | None,
    colour: str,
) -> int:
    """Do it once, and again after each change; 0 after Ctrl-C."""
    from aseme_dsl.project.building.watch import Watch, watched
    from aseme_dsl.project.building.workshop import Workshop

    workshop, watcher = Workshop(), Watch()
    before: tuple[Diagnostic, ...] = ()
    begun, news = time.perf_counter(), ""
    # What is known is large and stays: looking for cycles in it would take longer than what is done.
    gc.disable()
    try:
        while True:
            workshop.stamps = watcher.begin()
            try:
                done = do(workshop)
            except click.UsageError as error:  # of the configuration, which may be fixed
                if not news:
                    raise
                click.echo(f"{_clock()}  {news}: {error.format_message()}", err=True)
            else:
                _tell(done, before, news, time.perf_counter() - begun, colour)
                sys.stdout.flush()
                before = done.diagnostics
                paths, code = watched(files, done.compiled, activities, templates, workshop)
                watcher.depend(paths, done.written, code)
                if not news:
                    number = sum(Path(path).is_file() for path in paths)
                    click.echo(f"watching {plural(number, 'file')}; Ctrl-C to stop")
                    gc.freeze()
            sys.stdout.flush()
            gc.collect(0)
            changes = watcher.wait()
            assert changes is not None
            begun, news = time.perf_counter(), _news(changes)
    except KeyboardInterrupt:
        click.echo("\nasemec: stopped watching", err=True)
        return 0
    finally:
        gc.unfreeze()
        gc.enable()


def _tell(done: Done, before: Iterable[Diagnostic], news: str, seconds: float, colour: str) -> None:
    """What has changed, what there is to say that was not said before, and what came of it."""
    known = {_kind(item) for item in before if item.severity is not Severity.ERROR}
    new = [item for item in done.diagnostics if _kind(item) not in known]
    if news:
        click.echo(f"{_clock()}  {news}")
    sys.stdout.flush()
    print_diagnostics(new, colour)
    sys.stderr.flush()
    same = len(done.diagnostics) - len(new)
    again = f"; {plural(same, 'message')} unchanged" if same else ""
    click.echo(f"{_clock()}  {done.said}{again} ({seconds:.2f} s)")


def _kind(item: Diagnostic) -> tuple[object, ...]:
    """What a message is, wherever its line has moved: of another severity, it is another one."""
    place = (item.span.source.path, item.span.text) if item.span is not None else (item.path, "")
    return item.code, item.severity, item.message, *place


def _news(changes: Changes) -> str:
    said = []
    for paths, what in (
        (changes.changed, "changed"),
        (changes.created, "is new"),
        (changes.deleted, "was deleted"),
    ):
        if paths:
            what = (
                {"is new": "are new", "was deleted": "were deleted"}.get(what, what)
                if len(paths) > 1
                else what
            )
            said.append(f"{named(paths)} {what}")
    return ", ".join(said)


def named(paths: Sequence[str | Path]) -> str:
    """`a, b and 3 more`."""
    if len(paths) <= _NAMED:
        return ", ".join(map(str, paths))
    return f"{', '.join(map(str, paths[: _NAMED - 1]))} and {len(paths) - _NAMED + 1} more"


def _clock() -> str:
    return time.strftime("%H:%M:%S")


__all__ = ["Done", "named", "refuse_to_watch", "watch"]
