"""Figures that are not about a step of one behaviour."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from benchmarks.behaviours.description import Behaviour
from benchmarks.peers.measuring import Results


def single_figures(folder: Path, behaviours: Iterable[Behaviour], results: Results) -> None:
    """What a larger chart costs, and what it costs to load one."""
