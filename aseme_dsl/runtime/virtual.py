"""Virtual time: everything that a team does, one thing at a time and always in the same order.

Nothing runs at once. At an instant the agents that are due step in the team's order (a *wave*); then the code
of the activities that they started runs, in that order; what came of both is taken by the next wave of the
instant. When nothing is left, time jumps to the next moment at which something is due.

An activity that waits must let the others go on, and Python can suspend code only with a thread. So the
thread that runs the loop is not always the same: if activity code waits, its thread (with the code on its
stack) sleeps, and another one leads the loop on; when the wait is over, the leader wakes the sleeper and
hands the lead over to it. Still only one thread runs at any time, and code that never waits costs no switch.
Nothing of the loop's state is on its stack while code runs; that is what makes this possible.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.clock import VirtualClock, shown
from aseme_dsl.runtime.context import Cancelled
from aseme_dsl.runtime.snapshot import run_snapshot
from aseme_dsl.runtime.timers import Timer, Timers

if TYPE_CHECKING:
    import asyncio

    from aseme_dsl.runtime.agent import Agent
    from aseme_dsl.runtime.execution import Execution
    from aseme_dsl.runtime.virtual_loop import VirtualLoop

STEPS = 1000
"""After so many steps at one instant an agent is taken to go round in circles."""

_FREE = nullcontext()


class _Seat:
    """A thread's place: it leads, or it sleeps here until it is handed the lead."""

    __slots__ = ("go", "queued", "steps_aside")

    def __init__(self) -> None:
        self.go = threading.Lock()
        self.go.acquire()
        self.steps_aside = False
        """Whether its thread has handed the lead over and is about to sleep here. It must, whoever leads by
        then: each release of `go` is for one sleep."""
        self.queued = False
        """Whether it is on the list of those that are handed the lead."""


class VirtualDriver:
    """Drives a team in virtual time."""

    def __init__(self) -> None:
        self.clock = VirtualClock()
        self.agents: Sequence[Agent] = ()
        self.until: int | None = None
        """The moment after which nothing is done any more."""
        self.advance: Callable[[int], None] = _nothing
        """Called each time that the clock has jumped, before anything that is due then."""
        self.settled: Callable[[], str | None] = _no_reason
        """Called when nothing is left to do at an instant; a reason ends the run."""
        self.complain: Callable[[str], None] = _nothing
        """Called for an error in a callback of the activities' event loop."""
        self.reason = ""
        """Why the run has ended: what `settled` or `stop` said, "time", or "idle"."""
        self._timers = Timers()
        self._jobs: deque[Callable[[], None]] = deque()
        self._wave: deque[tuple[Agent, list[Any]]] = deque()
        self._steps: dict[str, int] = {}
        self._woken = False
        self._interrupt: str | None = None
        self._closing = False
        self._done = False
        self._error: BaseException | None = None
        self._leader = _Seat()
        self._spares: list[_Seat] = []
        self._sleepers: list[_Seat] = []
        self._threads: list[threading.Thread] = []
        self._loop: VirtualLoop | None = None

    # ---- the driver's interface --------------------------------------------------------------

    def bring(self, agents: Sequence[Agent]) -> None:
        """Take these agents, in the team's order."""
        self.agents = agents

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment; at once, if that has passed."""
        return self._timers.add(max(moment, self.clock.now()), call, background)

    def owns(self, agent: Agent) -> bool:
        """Always: only one thread runs."""
        return True

    def wake(self, agent: Agent) -> None:
        """The agent's intake is not empty: it is part of the next wave."""
        self._woken = True

    def holding(self) -> AbstractContextManager[object]:
        """Nothing to hold: woken agents step only when the loop comes to them."""
        return _FREE

    def guard(self, agent: Agent) -> AbstractContextManager[object]:
        """Nothing to guard: only one thread runs."""
        return _FREE

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity when the wave is over."""
        if execution.kind == "async":
            self._jobs.append(lambda: self._launch_async(execution))
        elif execution.kind == "process":
            self._jobs.append(lambda: run_snapshot(execution))
        else:
            self._jobs.append(execution.run)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that waits; one that has not begun to run finds out by itself."""
        handle = execution.handle
        if isinstance(handle, _Seat):
            self._queue(handle)
        elif handle is not None:
            handle.cancel()

    def wait(self, execution: Execution, duration: int) -> None:
        """Let virtual time pass in the code of an activity, which runs in the thread that leads."""
        if execution.cancelled or self._done:
            raise Cancelled
        seat = execution.handle = self._leader
        seat.queued = False
        timer = self.at(self.clock.now() + duration, lambda: self._queue(seat))
        self._sleepers.append(seat)
        self._call_spare()
        seat.go.acquire()
        self._sleepers.remove(seat)
        execution.handle = None
        timer.cancel()
        if execution.cancelled or self._done:
            raise Cancelled

    # ---- who leads ---------------------------------------------------------------------------

    def _queue(self, seat: _Seat) -> None:
        """Hand the lead to a sleeping thread in its turn."""
        if not seat.queued:
            seat.queued = True
            self._jobs.append(lambda: self._resume(seat))

    def _resume(self, seat: _Seat) -> None:
        self._leader.steps_aside = True
        self._spares.append(self._leader)
        self._leader = seat
        seat.go.release()

    def _call_spare(self) -> None:
        """Let another thread lead while this one sleeps."""
        if self._spares:
            self._leader = spare = self._spares.pop()
            spare.go.release()
            return
        self._leader = spare = _Seat()
        thread = threading.Thread(target=self._lead, args=(spare,), name="aseme leader", daemon=True)
        self._threads.append(thread)
        thread.start()

    def _lead(self, seat: _Seat) -> None:
        """Lead the loop; when somebody else does, sleep until the lead comes back."""
        try:
            while not self._done:
                self._one_thing()
                if seat.steps_aside:
                    seat.steps_aside = False
                    seat.go.acquire()
        except BaseException as error:
            self._error = error
            self._finish()

    def _finish(self) -> None:
        """End the loop: every thread comes back from where it sleeps."""
        self._done = True
        for seat in (*self._spares, *self._sleepers):
            seat.go.release()
        self._spares.clear()

    # ---- the loop ----------------------------------------------------------------------------

    def run(self) -> None:
        """Run until nothing is left to do, `until` is reached, `settled` gives a reason or `stop` is called.

        Then the agents are stopped and their activities cancelled. Raises what the loop itself raises, never
        what activities raise.
        """
        self._lead(self._leader)
        for thread in self._threads:
            thread.join(timeout=1.0)
        if self._loop is not None:
            self._loop.shut()
        if self._error is not None:
            raise self._error

    def stop(self, reason: str) -> None:
        """End the run before the next thing is done. May be called from a signal handler."""
        self._interrupt = reason

    def _one_thing(self) -> None:
        """Do the next thing. While code of an activity runs in here, nothing of the loop is on the stack."""
        if self._interrupt is not None and not self._closing:
            self._close(self._interrupt)
        elif self._wave:
            agent, items = self._wave.popleft()
            agent.process(items)
        elif self._jobs:
            self._jobs.popleft()()
        elif self._woken:
            self._woken = False
            self._wave.extend((agent, agent.take()) for agent in self.agents if agent.intake)
            self._bound()
        elif self._closing:
            self._finish()
        else:
            reason = self.settled()
            if reason is not None:
                self._close(reason)
            else:
                self._jump()

    def _bound(self) -> None:
        """Stop the agents that step for ever at one instant."""
        for agent, _ in self._wave:
            steps = self._steps[agent.name] = self._steps.get(agent.name, 0) + 1
            if steps == STEPS and not agent.over:
                agent.fail(
                    f"{STEPS} steps at {shown(self.clock.now())} and no end: {agent.cycle()}; let something "
                    "in it take time (`takes`, `every`, a timer, an activity that waits)"
                )

    def _jump(self) -> None:
        """Go on to the next moment at which something is due."""
        moment = self._timers.next()
        if self.until is None:
            if moment is None or self._timers.only_background():
                self._close("idle")
                return
        elif moment is None or moment > self.until:
            self.clock.jump(self.until)
            self.advance(self.until)
            self._close("time")
            return
        if moment > self.clock.now():
            self._steps.clear()
            self.clock.jump(moment)
            self.advance(moment)
        while (timer := self._timers.take(moment)) is not None:
            timer.ring()

    def _close(self, reason: str) -> None:
        """Stop everything; what is told that it is cancelled still comes to its end."""
        self.reason = reason
        self._closing = True
        for agent in self.agents:
            agent.stop()

    # ---- async activities --------------------------------------------------------------------

    def _launch_async(self, execution: Execution) -> None:
        if execution.cancelled:
            execution.returned(Cancelled())
            return
        from aseme_dsl.runtime.virtual_loop import VirtualLoop, run_async

        if self._loop is None:
            self._loop = VirtualLoop(self)
        task = execution.handle = self._loop.create_task(run_async(execution))
        task.add_done_callback(lambda done: _end_task(execution, done))

    def soon(self, call: Callable[[], None]) -> None:
        """Make a call in its turn at this instant."""
        self._jobs.append(call)


def _end_task(execution: Execution, task: asyncio.Task[None]) -> None:
    if task.cancelled():  # before it began: nothing of it has run that could say so
        execution.returned(Cancelled())


def _nothing(value: object) -> None:
    pass


def _no_reason() -> None:
    return None
