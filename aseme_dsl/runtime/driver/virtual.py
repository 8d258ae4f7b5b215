"""Virtual time: everything that a team does, one thing at a time and always in the same order.

Nothing runs at once. At an instant the agents that are due step in the team's order (a *wave*). Then the code
of the activities that they started runs, in that order. The next wave of the instant takes what came of both.
When nothing is left, time jumps to the next moment at which something is due.

The thread that runs the loop is not always the same (see `leading`). Nothing of the loop's state is on its
stack while activity code runs; that is what makes this possible.

The thread that asks for the run leads nothing: it waits for its end. It reports code that does not return,
and leaves it behind, with its thread, when the run ends.
"""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, cast

from aseme_dsl.runtime.activity.context import Cancelled
from aseme_dsl.runtime.activity.snapshot import run_snapshot
from aseme_dsl.runtime.activity.stacks import activity_of, place_of
from aseme_dsl.runtime.chart.input_queue import Errand, Posted
from aseme_dsl.runtime.driver.leading import Seat, Threads
from aseme_dsl.runtime.ports import Complain, Stepping
from aseme_dsl.runtime.time.clock import VirtualClock, shown
from aseme_dsl.runtime.time.timers import Timer, Timers

if TYPE_CHECKING:
    import asyncio

    from aseme_dsl.runtime.activity.execution import Execution
    from aseme_dsl.runtime.driver.virtual_loop import VirtualLoop

STEPS = 1000
"""After so many steps at one instant an agent is taken to go round in circles."""

LOOK = 0.25
"""How often the thread that waits for the end looks whether anything moves, in s of real time."""
GRACE = 4
"""Once the run is to end, code is left behind that has not returned at so many looks."""
PATIENCE = 20
"""It reports code that has not returned, or has let no time pass, at so many looks."""

_FREE = nullcontext()


class VirtualDriver:
    """Drives a team in virtual time."""

    def __init__(self) -> None:
        self.clock = VirtualClock()
        self.agents: Sequence[Stepping] = ()
        self.until: int | None = None
        """The moment after which nothing is done any more."""
        self.advance: Callable[[int], None] = _nothing
        """Called each time that the clock has jumped, before anything that is due then."""
        self.settled: Callable[[], str | None] = _no_reason
        """Called when nothing is left to do at an instant; a reason ends the run."""
        self.ending: Callable[[], None] = _nothing
        """Called once, when the run is to end and nothing has been stopped yet."""
        self.idle_since: int | None = None
        """The moment after which nothing was pending any more, if the run ended so."""
        self._last = 0
        """The last moment at which something was due that is not of the background."""
        self.complain: Complain = _nothing
        """Called with what is wrong, the agent and the activity, as far as that is known."""
        self.reason = ""
        """Why the run has ended: what `settled` or `stop` said, "time", or "idle"."""
        self.is_held = False
        """Whether the run is held between two instants: it does not wait for code then."""
        self.left: tuple[str, ...] = ()
        """What did not return when the run was to end, if something did not."""
        self._timers = Timers()
        self._jobs: deque[Callable[[], None]] = deque()
        self._wave: deque[tuple[Stepping, list[Posted | Errand]]] = deque()
        self._steps: dict[str, int] = {}
        self._drained = 0
        self._woken = False
        self._interrupt: str | None = None
        self._closing = False
        self._things = 0
        self._rings = 0
        """How often timers were due at the present moment once more."""
        self._still: dict[tuple[str, str], tuple[int, Seat]] = {}
        """How often each activity has waited 0 s at the present moment, and its thread."""
        self._told: set[str] = set()
        self._threads = Threads(self._one_thing)
        self._loop: VirtualLoop | None = None

    # ---- the driver's interface --------------------------------------------------------------

    def bring(self, agents: Sequence[Stepping]) -> None:
        """Take these agents, in the team's order."""
        self.agents = agents

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment; at once, if that has passed."""
        return self._timers.add(max(moment, self.clock.now()), call, background)

    def owns(self, agent: Stepping) -> bool:
        """Always: only one thread runs."""
        return True

    def wake(self, agent: Stepping) -> None:
        """The agent's intake is not empty: it is part of the next wave."""
        self._woken = True

    def holding(self) -> AbstractContextManager[object]:
        """Nothing to hold: woken agents step only when the loop comes to them."""
        return _FREE

    def guard(self, agent: Stepping) -> AbstractContextManager[object]:
        """Nothing to guard: only one thread runs."""
        return _FREE

    def hold(self, agent: Stepping) -> AbstractContextManager[object]:
        """Nothing to hold."""
        return _FREE

    def look(self, agent: Stepping, call: Callable[[], None]) -> bool:
        """Make a call between two steps of the agent: at once."""
        call()
        return True

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
        if isinstance(handle, Seat):
            self._queue(handle)
        elif handle is not None:
            cast("asyncio.Task[None]", handle).cancel()  # see `_launch_async`

    def wait(self, execution: Execution, duration: int) -> None:
        """Let virtual time pass in the code of an activity, which runs in the thread that leads."""
        if execution.cancelled or self._threads.done:
            raise Cancelled
        seat = execution.handle = self._threads.leader
        if duration <= 0:
            who = (execution.agent, execution.activity)
            self._still[who] = (self._still[who][0] + 1 if who in self._still else 1, seat)
        seat.queued = False
        timer = self.at(self.clock.now() + duration, lambda: self._queue(seat))
        self._threads.sleep(seat)
        execution.handle = None
        timer.cancel()
        if execution.cancelled or self._threads.done:
            raise Cancelled

    def _queue(self, seat: Seat) -> None:
        """Hand the lead to a sleeping thread in its turn."""
        if not seat.queued:
            seat.queued = True
            self._jobs.append(lambda: self._threads.hand_over(seat))

    # ---- the loop ----------------------------------------------------------------------------

    def run(self) -> None:
        """Run until nothing is left to do, `until` is reached, `settled` gives a reason or `stop` is called.

        Then the agents are stopped and their activities cancelled. Raises what the loop itself raises, never
        what activities raise.
        """
        if sys.gettrace() is None and sys.getprofile() is None:
            self._threads.start()
            self._look_after()
        else:  # a debugger or profiler of this thread has to see the code
            self._threads.lead()
        self._threads.join(but_leader=bool(self.left))
        if self._loop is not None:
            self._loop.shut()
        if self._threads.error is not None:
            raise self._threads.error

    def _look_after(self) -> None:
        """Wait for the end of the loop."""
        seen: tuple[int, str | None] = (-1, None)
        moment = -1
        looks = still = 0
        try:
            while not self._threads.is_over(LOOK):
                if self.is_held and self._interrupt is None:
                    looks = still = 0
                    continue
                before, seen = seen, (self._things, self._interrupt)
                looks = looks + 1 if seen == before else 0
                earlier, moment = moment, self.clock.now()
                still = still + 1 if moment == earlier else 0
                if self._interrupt is not None and looks >= GRACE:
                    self._leave(self._interrupt)
                elif looks == PATIENCE:
                    self._tell()
                elif still >= PATIENCE and self._rings >= STEPS:
                    self._tell_still(moment)
        except BaseException:  # a second signal
            self._threads.finish()
            raise

    def _tell(self) -> None:
        """Say which code does not return; not in the trace, which is the same in each run."""
        import logging

        name, _, place = self._what_runs()
        if name in self._told:
            return
        self._told.add(name)
        waited = f"{LOOK * PATIENCE:g} s"
        logging.getLogger(__name__).warning("%s has not returned for %s%s", name, waited, place)

    def _tell_still(self, moment: int) -> None:
        """Say which code returns, but lets no time pass."""
        import logging

        waits = sorted(list(self._still.items()), key=lambda item: -item[1][0])
        if not waits:
            name = "timers"
            text = f"no time passes at {shown(moment)}: timers are due again and again"
        else:
            ((agent, activity), (count, seat)), *_ = waits
            name = f"activity {activity} of {agent}"
            text = (
                f"{name} lets no time pass: it has waited 0 s {count} times at"
                f" {shown(moment)}{place_of(seat.thread)}"
            )
        if name not in self._told:
            self._told.add(name)
            logging.getLogger(__name__).warning("%s", text)

    def _leave(self, reason: str) -> None:
        """End the run with the code that does not return, and its thread, left behind."""
        name, activity, place = self._what_runs()
        if not self._threads.finish():
            return
        self.left = (name,)
        self.complain(f"{name} has not ended {LOOK * GRACE:g} s after it was to{place}", *activity)
        if not self._closing:
            self._close(reason)

    def _what_runs(self) -> tuple[str, tuple[str, ...], str]:
        """Which code runs, the agent and activity if it is one's, and where in it."""
        thread = self._threads.leader.thread
        activity = activity_of(thread)
        name = f"activity {activity[1]} of {activity[0]}" if activity else "what runs"
        return name, activity, place_of(thread)

    def stop(self, reason: str) -> None:
        """End the run before the next thing is done. May be called from a signal handler."""
        self._interrupt = reason

    def _one_thing(self) -> None:
        """Do the next thing. While code of an activity runs in here, nothing of the loop is on the stack."""
        self._things += 1
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
            self._threads.finish()
        else:
            reason = self.settled()
            if reason is not None:
                self._close(reason)
            else:
                self._jump()

    def _bound(self) -> None:
        """Stop the agents that step for ever at one instant."""
        if any(agent.chart.drains for agent, _ in self._wave):
            # Queues become shorter; they cannot for longer than all of them are long.
            self._drained += 1
            if self._drained <= sum(agent.chart.queue for agent in self.agents):
                return
        for agent, _ in self._wave:
            steps = self._steps[agent.name] = self._steps.get(agent.name, 0) + 1
            if steps == STEPS and not agent.over:
                agent.fail(
                    f"{STEPS} steps at {shown(self.clock.now())} and no end: {agent.cycle()}; pace the loop "
                    "(`repeat … every 100ms`), or let an activity in it wait"
                )

    def _jump(self) -> None:
        """Advance to the next moment at which something is due."""
        moment = self._timers.next()
        if self.until is None:
            if moment is None or self._timers.only_background():
                self.idle_since = self._last
                self._close("idle")
                return
        elif moment is None or moment > self.until:
            if moment is None or self._timers.only_background():
                self.idle_since = self._last
            self.clock.jump(self.until)
            self.advance(self.until)
            self._close("time")
            return
        if moment > self.clock.now():
            self._steps.clear()
            self._still.clear()
            self._drained = self._rings = 0
            self.clock.jump(moment)
            self.advance(moment)
        else:
            self._rings += 1
        while (timer := self._timers.take(moment)) is not None:
            if not timer.background:
                self._last = moment
            timer.ring()

    def _close(self, reason: str) -> None:
        """Stop everything; what is cancelled still comes to its end."""
        self.reason = reason
        self._closing = True
        self.ending()
        for agent in self.agents:
            agent.stop()

    # ---- async activities --------------------------------------------------------------------

    def _launch_async(self, execution: Execution) -> None:
        if execution.cancelled:
            execution.returned(Cancelled())
            return
        from aseme_dsl.runtime.driver.virtual_loop import VirtualLoop, run_async

        if self._loop is None:
            self._loop = VirtualLoop(self, self.soon, lambda text: self.complain(text))
        task = execution.handle = self._loop.create_task(run_async(execution))
        task.add_done_callback(lambda done: _end_task(execution, done))

    def soon(self, call: Callable[[], None]) -> None:
        """Make a call in its turn at this instant."""
        self._jobs.append(call)


def _end_task(execution: Execution, task: asyncio.Task[None]) -> None:
    if task.cancelled():  # before it began: nothing of it has run that could say so
        execution.returned(Cancelled())


def _nothing(*values: object, **named: object) -> None:
    pass


def _no_reason() -> None:
    return None
