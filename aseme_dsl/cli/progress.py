"""Progress: what long work is at, on one line of a terminal that is written over."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import IO

import click


def shows_progress(stream: IO[str]) -> bool:
    """Whether a user watches: a terminal that can write over a line, and not the log of a CI service."""
    return stream.isatty() and os.environ.get("TERM") != "dumb" and not os.environ.get("CI")


class Progress:
    """One line on standard error; nothing where no user watches, or if it is to be `quiet`."""

    def __init__(self, quiet: bool = False) -> None:
        self._quiet = quiet
        self._is_shown = False

    def say(self, text: str) -> None:
        """The line from now on."""
        if not self._quiet and shows_progress(sys.stderr):
            self._is_shown = True
            click.echo(f"\r\x1b[K{text}", nl=False, err=True)

    def end(self) -> None:
        """Take the line away."""
        if self._is_shown:
            self._is_shown = False
            click.echo("\r\x1b[K", nl=False, err=True)


@contextmanager
def progress_of(name: str) -> Iterator[Callable[[str], None]]:
    """Shows the current step of a build while it runs."""
    progress = Progress()
    try:
        yield lambda text: progress.say(f"{name}: {text}")
    finally:
        progress.end()


__all__ = ["Progress", "progress_of", "shows_progress"]
