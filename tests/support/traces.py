"""Traces on disk, plain or compressed."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

from aseme_dsl.runtime.trace.trace_reading import TraceReader

HEADER: dict[str, Any] = {
    "kind": "header",
    "time": 0,
    "format": 2,
    "system": "S",
    "seed": 1,
    "clock": "virtual",
    "agents": [],
}
"""The first line of a trace that is written by hand."""


def records_of(path: Path) -> list[dict[str, Any]]:
    """The records of a trace."""
    return [cast("dict[str, Any]", line.record) for line in TraceReader(path)]


def texts_of(path: Path) -> list[str]:
    """The lines of a trace."""
    return [line.text for line in TraceReader(path)]
