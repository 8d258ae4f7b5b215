"""Graphviz takes longer than the rest of most builds, and many tests have it draw the same texts."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from aseme_dsl.diagrams.rendering import layout


def remember_drawings() -> None:
    """Have what a program of this path wrote for a text remembered; it is asked again if it has failed."""
    run = lru_cache(maxsize=1000)(layout._run)

    def remembered(command: Sequence[str], text: str, time_limit: float) -> bytes:
        return run(tuple(command), text, time_limit)

    layout._run = remembered
