"""Difference: two texts of a file as a unified diff."""

from __future__ import annotations

import difflib


def unified(path: str, before: str, after: str) -> str:
    """What changes from `before` to `after`, with the file's path; empty if nothing does."""
    old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
    lines = difflib.unified_diff(old, new, path, path)
    return "".join(
        line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines
    )
