"""Clocks: the times of other machines, in the time of our run."""

from __future__ import annotations

import os
import time
import zlib
from functools import cache
from pathlib import Path

from aseme_dsl.runtime.transport.delivery.records import Other
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.envelope import Envelope


def moment_of(state: Delivery, other: Other, envelope: Envelope) -> int:
    """When something was measured, in the time of our run: never later than now."""
    now = state.now()
    if envelope.clock == state.clock:
        return min(now, envelope.time - state.origin)
    difference = difference_to(state, other)
    return now if difference is None else min(now, envelope.time + difference - state.origin)


def sent_at(state: Delivery, other: Other, envelope: Envelope) -> int | None:
    """When an agent message was sent, in our run's time; None while the clocks cannot be compared."""
    if not envelope.time:
        return None
    known = envelope.clock == state.clock or difference_to(state, other) is not None
    return moment_of(state, other, envelope) if known else None


def deadline_of(state: Delivery, other: Other, envelope: Envelope) -> int | None:
    """Until when an answer is wanted, in our run's time; None while the clocks cannot be compared."""
    if not envelope.reply_by:
        return None
    difference = 0 if envelope.clock == state.clock else difference_to(state, other)
    return None if difference is None else envelope.reply_by + difference - state.origin


def difference_to(state: Delivery, other: Other) -> int | None:
    """What is to be added to another machine's time; None while that is not known."""
    if other.clock in (None, state.clock):
        return 0
    return min(other.measured)[1] if other.measured else None


def clock_record(state: Delivery, other: Other) -> dict[str, int]:
    """What the trace says of another machine's clock; nothing if it is ours, or not known."""
    if other.clock in (None, state.clock) or not other.measured:
        return {}
    trip, difference = min(other.measured)
    return {"difference": difference, "uncertainty": trip // 2}


@cache
def clock_identity() -> int:
    """A number that all processes have in common that share the monotonic clock, and no others."""
    try:
        boot = Path("/proc/sys/kernel/random/boot_id").read_text("ascii")
        namespace = str(Path("/proc/self/ns/time").readlink()) if Path("/proc/self/ns/time").exists() else ""
    except OSError:  # not Linux: each process has a clock of its own, whose difference is measured
        boot, namespace = f"{os.getpid()} {time.time_ns()}", ""
    return zlib.crc32(f"{boot} {namespace}".encode()) + 1
