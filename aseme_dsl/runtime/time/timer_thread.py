"""Timekeeper: the thread of the real clock that makes calls at the moments at which they are due.

It sleeps on a lock with a deadline, not in an event loop: `epoll` rounds up to whole milliseconds. What is
due is called in this thread, so that a step which time alone causes waits for no hand-over.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable

from aseme_dsl.runtime.time.clock import SECOND, Clock
from aseme_dsl.runtime.time.timers import Timer, Timers

_AWAKE = -1


class Timekeeper:
    """The timers of a run in real time, and their thread. May be used from any thread."""

    def __init__(self, clock: Clock, failed: Callable[[BaseException], None]) -> None:
        """`failed` gets the exception of a call; no call is made after that."""
        self._clock = clock
        self._failed = failed
        self._timers = Timers()
        self._lock = threading.Lock()
        self._bell = threading.Lock()
        self._bell.acquire()
        self._sleeps_until: int | None = _AWAKE
        """The moment to which the thread sleeps, None for ever, or _AWAKE."""
        self._until: int | None = None
        self._over = False
        self._thread: threading.Thread | None = None

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment; at once, if that has passed."""
        with self._lock:
            timer = self._timers.add(moment, call, background)
            if self._sleeps_until is None or moment < self._sleeps_until:
                self._ring()
        return timer

    def start(
        self, until: int | None, priority: int | None = None, refused: Callable[[str], None] | None = None
    ) -> None:
        """Begin; nothing is called after `until`. `refused` gets the reason if `priority` cannot be set."""
        self._until = until
        work = self._work

        def begin() -> None:
            problem = _raise_priority(priority) if priority is not None else None
            if problem is not None and refused is not None:
                refused(problem)
            work()

        self._thread = threading.Thread(target=begin, name="aseme timekeeper", daemon=True)
        self._thread.start()

    def stop(self, timeout: float) -> bool:
        """Call nothing more; whether the thread has ended within so many seconds."""
        with self._lock:
            self._over = True
            self._ring()
        thread = self._thread
        if thread is None or thread is threading.current_thread():
            return True
        thread.join(timeout)
        return not thread.is_alive()

    def _ring(self) -> None:
        """Wake the thread. Called with the lock held, so that no other thread rings."""
        self._sleeps_until = _AWAKE
        if self._bell.locked():
            self._bell.release()

    def _work(self) -> None:
        timers, clock, bell, until = self._timers, self._clock, self._bell, self._until
        try:
            while not self._over:
                now = clock.now()
                with self._lock:
                    timer = timers.take(now if until is None or now < until else until)
                    if timer is None:
                        moment = timers.next()
                        if until is not None and moment is not None and moment > until:
                            moment = None
                        self._sleeps_until = moment
                if timer is not None:
                    timer.ring()
                elif moment is None:
                    bell.acquire()
                else:
                    bell.acquire(timeout=max(0.0, (moment - clock.now()) / SECOND))
        except BaseException as error:  # of the runtime itself: it ends the run
            self._failed(error)


def _raise_priority(priority: int) -> str | None:
    """Give this thread a real-time priority; why that is not possible, or None. Not to its children."""
    if not hasattr(os, "SCHED_FIFO"):
        return "this system has no real-time scheduling (SCHED_FIFO)"
    try:
        policy = os.SCHED_FIFO | getattr(os, "SCHED_RESET_ON_FORK", 0)
        os.sched_setscheduler(0, policy, os.sched_param(priority))
    except OSError as error:
        lowest, highest = os.sched_get_priority_min(os.SCHED_FIFO), os.sched_get_priority_max(os.SCHED_FIFO)
        if not lowest <= priority <= highest:
            return f"real-time priorities go from {lowest} to {highest}, not {priority}"
        return (
            f"a real-time priority is not permitted here ({error.strerror}): it needs "
            f"`ulimit -r {priority}` or CAP_SYS_NICE"
        )
    return None


def may_raise_priority() -> str | None:
    """Why no thread of this process may have a real-time priority, or None. Tried in a thread of its own."""
    answers: list[str | None] = []
    trial = threading.Thread(target=lambda: answers.append(_raise_priority(1)))
    trial.start()
    trial.join()
    return answers[0]
