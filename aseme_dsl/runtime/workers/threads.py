"""Threads: the resident threads in which activities of kind `thread` run.

An activity may begin while the thread of the one before it has not ended yet, and takes another one.
How often that coincides is random, so the threads that may be needed are made beforehand. When all of them
are in use, one that is about to be free is preferred to a new one. So their number does not grow in a
long run.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from queue import SimpleQueue
from typing import TYPE_CHECKING

from aseme_dsl.runtime.activity.context import Cancelled
from aseme_dsl.runtime.activity.stacks import place_of
from aseme_dsl.runtime.ports import Complain
from aseme_dsl.runtime.time.clock import SECOND

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution


BEFOREHAND = 256
"""So many threads are made beforehand at the most: many small agents do not need them all at once."""


class _Worker:
    """A resident thread that runs activities, one after the other."""

    def __init__(self, pool: Threads, number: int) -> None:
        self.pool = pool
        self.queue: SimpleQueue[Execution | None] = SimpleQueue()
        self.execution: Execution | None = None
        """What it runs, from when it is given to it."""
        self.thread = threading.Thread(target=self._work, name=f"aseme activity {number}", daemon=True)
        self.thread.start()

    def _work(self) -> None:
        execution = self.queue.get()
        while execution is not None:
            execution.run()
            self.pool.ended(execution)
            execution = self.pool.next_for(self)

    @property
    def is_leaving(self) -> bool:
        """Whether its activity has returned."""
        return self.execution is None or self.execution.has_returned


class Threads:
    """As many threads as are wanted beforehand, or as activities have run in them at once if that is more, up
    to a maximum. For use from any thread."""

    def __init__(self, maximum: int, ended: Callable[[Execution], None], complain: Complain) -> None:
        self.ended = ended
        self._maximum = maximum
        self._complain = complain
        self._lock = threading.Lock()
        self._workers: set[_Worker] = set()
        self._idle: list[_Worker] = []
        self._given_up: set[_Worker] = set()
        self._waiting: deque[Execution] = deque()
        self._made = 0
        self._was_full = False
        self._looked: Execution | None = None

    def have(self, count: int) -> None:
        """Have so many threads, if there are fewer, or as many as the system and the maximum permit."""
        with self._lock, suppress(RuntimeError):  # told when one is missing
            while len(self._workers) < min(count, BEFOREHAND, self._maximum):
                self._idle.insert(0, self._another())

    def _another(self) -> _Worker:
        """One thread more. Raises RuntimeError if the system gives none."""
        worker = _Worker(self, self._made + 1)
        self._made += 1
        self._workers.add(worker)
        return worker

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity in a thread that is free, or in a new one."""
        execution.handle = threading.Event()
        self._place(execution)

    def _place(self, execution: Execution) -> None:
        problem = ""
        with self._lock:
            worker = self._idle.pop() if self._idle else None
            if worker is None and self._soon():
                self._waiting.append(execution)
                return
            if worker is None and len(self._workers) < self._maximum:
                try:
                    worker = self._another()
                except RuntimeError as error:  # the system gives no more
                    problem = f" ({error})"
            if worker is not None:
                worker.execution = execution
                worker.queue.put(execution)
                return
            self._waiting.append(execution)
            tell, self._was_full = not self._was_full, True
        if tell:
            self._complain(
                f"all {len(self._workers)} threads for activities are busy{problem}: {execution.activity} "
                "and others wait until one is free",
                execution.agent,
                execution.activity,
            )

    def _soon(self) -> bool:
        """Whether a thread is about to be free that nothing waits for yet."""
        leaving = sum(worker.is_leaving for worker in self._workers)
        return leaving > len(self._waiting)

    def look(self) -> None:
        """Called now and then: what has waited since the last time, in vain, gets a thread of its own."""
        with self._lock:
            first = self._waiting[0] if self._waiting else None
            late = first is not None and first is self._looked
            self._looked = first
            if not late or len(self._workers) >= self._maximum:
                return
            with suppress(RuntimeError):
                worker = self._another()
                worker.execution = self._waiting.popleft()
                worker.queue.put(worker.execution)

    def next_for(self, worker: _Worker) -> Execution | None:
        """What a worker whose activity has returned runs next; None if it is not wanted any more."""
        with self._lock:
            if worker in self._given_up:
                self._given_up.discard(worker)
                worker.execution = None
                return None
            if self._waiting:
                worker.execution = self._waiting.popleft()
                return worker.execution
            worker.execution = None
            self._idle.append(worker)
        return worker.queue.get()

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left."""
        _event(execution).set()
        with self._lock:
            if execution not in self._waiting:
                return
            self._waiting.remove(execution)
        execution.returned(Cancelled())
        self.ended(execution)

    def give_up(self, execution: Execution) -> str:
        """Count no more on the thread of an activity that does not return; where it is in its code."""
        with self._lock:
            worker = next((item for item in self._workers if item.execution is execution), None)
            if worker is None:
                return ""
            self._workers.discard(worker)
            self._given_up.add(worker)
            following = self._waiting.popleft() if self._waiting else None
        if following is not None:
            self._place(following)
        return place_of(worker.thread.ident)

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the activity's own thread. Raises Cancelled."""
        if execution.cancelled or _event(execution).wait(duration / SECOND):
            raise Cancelled

    def close(self) -> None:
        """Let the threads end that are idle."""
        with self._lock:
            idle, self._idle = self._idle, []
            self._given_up |= self._workers - set(idle)
        for worker in idle:
            worker.queue.put(None)

    def join(self, seconds: Callable[[], float]) -> None:
        """Wait for the threads that are about to end, so many seconds at the most."""
        for worker in tuple(self._workers):
            if worker.execution is None:
                worker.thread.join(seconds())


def _event(execution: Execution) -> threading.Event:
    """What tells the thread of an activity that its state was left."""
    assert isinstance(execution.handle, threading.Event)
    return execution.handle
