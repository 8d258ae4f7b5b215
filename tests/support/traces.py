"""Traces on disk, plain or compressed."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

from aseme_dsl.runtime.trace.trace_reading import TraceReader


def records_of(path: Path) -> list[dict[str, Any]]:
    """The records of a trace."""
    return [cast("dict[str, Any]", line.record) for line in TraceReader(path)]


def texts_of(path: Path) -> list[str]:
    """The lines of a trace."""
    return [line.text for line in TraceReader(path)]
