"""Leading: which thread runs the loop of virtual time.

An activity that waits must let the others continue, and Python can suspend code only with a thread. So the
thread that runs the loop is not always the same. If activity code waits, its thread (with the code on its
stack) sleeps, and another one leads the loop. When the wait is over, the leader wakes the sleeper and hands
the lead over to it. Still only one thread runs at any time, and code that never waits costs no switch.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextvars import copy_context


class Seat:
    """A thread's place: it leads, or it sleeps here until it is handed the lead."""

    __slots__ = ("go", "queued", "steps_aside", "thread")

    def __init__(self) -> None:
        self.thread: int | None = None
        self.go = threading.Lock()
        self.go.acquire()
        self.steps_aside = False
        """Whether its thread has handed the lead over and is about to sleep here. It must, under any leader:
        each release of `go` is for one sleep."""
        self.queued = False
        """Whether it is on the list of those that are handed the lead."""


class Threads:
    """The threads of a loop: one of them leads, the others sleep in code that waits, or are spare."""

    def __init__(self, one_thing: Callable[[], None]) -> None:
        """The leader calls `one_thing` again and again, until `finish` is called."""
        self.leader = Seat()
        self.done = False
        self.error: BaseException | None = None
        """What `one_thing` has raised, which ends the loop."""
        self._one_thing = one_thing
        self._context = copy_context()
        self._ending = threading.Lock()
        """Held from the moment at which a thread ends the loop: it is ended once."""
        self._over = threading.Lock()
        """Held until it has ended."""
        self._over.acquire()
        self._spares: list[Seat] = []
        self._sleepers: list[Seat] = []
        self._threads: list[threading.Thread] = []

    def start(self) -> None:
        """Run the loop in other threads, with the context variables of this one."""
        self._context = copy_context()
        self._new_thread(self.leader)

    def lead(self) -> None:
        """Run the loop, led by this thread first; returns when it has ended."""
        self._context = copy_context()
        self._lead(self.leader)

    def is_over(self, timeout: float) -> bool:
        """Wait for the end of the loop, `timeout` seconds at most; whether it has ended."""
        return self._over.acquire(timeout=timeout)

    def join(self, *, but_leader: bool) -> None:
        """Wait for all threads, a second each; `but_leader`: except the leader, which does not return."""
        for thread in self._threads:
            if not but_leader or thread.ident != self.leader.thread:
                thread.join(timeout=1.0)

    def sleep(self, seat: Seat) -> None:
        """Let another thread lead; return when this one, which has the seat, is handed the lead again."""
        self._sleepers.append(seat)
        self._call_spare()
        seat.go.acquire()
        self._sleepers.remove(seat)

    def hand_over(self, seat: Seat) -> None:
        """Give the lead to a sleeping thread; this one then steps aside as a spare."""
        self.leader.steps_aside = True
        self._spares.append(self.leader)
        self.leader = seat
        seat.go.release()

    def finish(self) -> bool:
        """End the loop, unless it has ended: every thread comes back from where it sleeps."""
        if not self._ending.acquire(blocking=False):
            return False
        self.done = True
        for seat in (*self._spares, *self._sleepers):
            seat.go.release()
        self._spares.clear()
        self._over.release()
        return True

    def _call_spare(self) -> None:
        """Let another thread lead while this one sleeps."""
        if self._spares:
            self.leader = spare = self._spares.pop()
            spare.go.release()
            return
        self.leader = spare = Seat()
        self._new_thread(spare)

    def _new_thread(self, seat: Seat) -> None:
        context = self._context.copy()  # the context variables of the thread that asks for the run
        run = context.run
        thread = threading.Thread(target=run, args=(self._lead, seat), name="aseme leader", daemon=True)
        self._threads.append(thread)
        thread.start()

    def _lead(self, seat: Seat) -> None:
        """Lead the loop; when another thread does, sleep until the lead comes back."""
        seat.thread = threading.get_ident()
        try:
            while not self.done:
                self._one_thing()
                if seat.steps_aside:
                    seat.steps_aside = False
                    seat.go.acquire()
        except BaseException as error:
            self.error = error
            self.finish()


__all__ = ["Seat", "Threads"]
