"""Usage: what this process takes of its machine."""

from __future__ import annotations

import os
import socket
import sys
import threading
import time
from pathlib import Path
from typing import TypedDict

from aseme_dsl.runtime.time.synchronised import synchronised

_BEGUN = time.monotonic()
_NAME = socket.gethostname()[:64]


class Usage(TypedDict):
    """What a process takes: see `usage`."""

    pid: int
    host: str
    uptime: float
    """Seconds since it has begun."""
    cpu: float
    """Seconds of processor time, with that of its ended children."""
    memory: int | None
    """Bytes in main memory now; None where the system does not say."""
    threads: int
    synchronised: bool | None
    """Whether the machine's clock is synchronised; None where the system does not say."""


def usage() -> Usage:
    """What this process takes now."""
    spent = os.times()
    return {
        "pid": os.getpid(),
        "host": _NAME,
        "uptime": round(time.monotonic() - _BEGUN, 3),
        "cpu": round(spent.user + spent.system + spent.children_user + spent.children_system, 3),
        "memory": memory(),
        "threads": threading.active_count(),
        "synchronised": synchronised(),
    }


def memory() -> int | None:
    """Bytes of this process in main memory now; its peak where the system only says that."""
    if sys.platform == "win32":
        return None
    try:
        pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError):
        pass
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024
