"""Durations as people write them on a command line and in a configuration: `200ms`, `1.5s`, `2min`."""

from __future__ import annotations

import re

from aseme_dsl.runtime.time.clock import UNITS

_WRITTEN = re.compile(r"(\d+(?:\.\d+)?)(ms|s|min)", re.ASCII)


def duration(text: str) -> int:
    """The nanoseconds of a duration, rounded to whole ones.

    Raises:
        ValueError: it is not written like that, or is longer than a century.
    """
    written = _WRITTEN.fullmatch(text.strip())
    if written is None:
        raise ValueError(f"{text!r} is not a duration; durations are written 200ms, 1.5s or 2min")
    from decimal import Decimal  # exact

    nanoseconds = int(Decimal(written[1]) * UNITS[written[2]])
    if nanoseconds > 100 * 366 * 24 * 3600 * 10**9:
        raise ValueError(f"{text} is longer than a century")
    return nanoseconds
