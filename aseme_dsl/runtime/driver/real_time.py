"""Real time: what a run with the real clock may ask of the machine."""

from __future__ import annotations

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.conversation.participation import MESSAGES
from aseme_dsl.runtime.time.clock import MILLISECOND, SECOND


@dataclass(frozen=True, slots=True)
class RealTime:
    """Options of a run with the real clock. Durations are in ns."""

    cancel_within: int = 2 * SECOND
    """How long a cancelled activity may take to return. Then its process is killed; a thread, which cannot
    be, is reported and given up: another one takes its place."""
    threads: int = 1024
    """How many threads there may be for `thread` activities; further ones wait for one that is free."""
    processes: int = 32
    """How many worker processes there may be for `process` activities; further ones wait."""
    process_memory: int | None = None
    """The address space, in bytes, that a worker process may use; beyond it an activity gets MemoryError."""
    queue: int = QUEUE
    """How many signals of a queued channel may wait in a region, how many for an agent's next step, and how
    many agent messages for a participant. What comes then is left out, and told; also in virtual time."""
    conversation_limit: int = MESSAGES
    """How many messages one conversation may have; then it is over for all. Also in virtual time."""
    switch_interval: int = MILLISECOND // 10
    """How long a thread that computes may keep the interpreter from another one that wants it. During the
    run, that holds for the whole process; it is put back with the end of the last run."""
    priority: int | None = None
    """The real-time priority (SCHED_FIFO, from 1 on) of the thread that keeps the timers, where the system
    permits it."""
