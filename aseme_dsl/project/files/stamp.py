"""Stamp: what changes when a file does, so as to know without reading it."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

Stamp = tuple[int, int, int]
"""The time, the size and the number of a file."""

Look = Callable[[str], Stamp | None]
"""Gives the stamp of a path: `stamp_of`, or a function that uses stamps taken just before."""

CLOCK = 10_000_000
"""By how many ns the times of files may be behind the clock."""


def stamp_of(path: Path | str) -> Stamp | None:
    """The stamp of a file or folder; None where there is none."""
    try:
        found = os.stat(path)  # noqa: PTH116 (a path object costs more than the question)
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


__all__ = ["CLOCK", "Look", "Stamp", "stamp_of"]
