"""Whether the clock of this machine is synchronised. Dates in traces and logs depend on that."""

from __future__ import annotations

import ctypes
import sys

_ERROR = 5
"""TIME_ERROR, which `adjtimex` of Linux returns for a clock that is not synchronised."""


def synchronised() -> bool | None:
    """Whether the clock of this machine is synchronised (by NTP, say); None where the system does not say."""
    if not sys.platform.startswith("linux"):
        return None
    try:
        state: int = ctypes.CDLL(None).adjtimex(ctypes.create_string_buffer(512))  # without a mode: it reads
    except (OSError, AttributeError):
        return None
    return None if state < 0 else state != _ERROR


__all__ = ["synchronised"]
