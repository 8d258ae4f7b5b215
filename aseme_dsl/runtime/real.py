"""Real time: agents step where their inputs come in, activities run beside them.

A step has no thread of its own. Who posts an input appends it to the agent's intake and, if nobody else is
stepping the agent, steps it; else whoever does takes the new input too before it lets go. So there is one
order of inputs and no hand-over to another thread, which would wait for the interpreter's lock. The thread
that calls `run` keeps the timers.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.clock import SECOND, RealClock
from aseme_dsl.runtime.context import Cancelled
from aseme_dsl.runtime.timers import Timer, Timers

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop
    from pathlib import Path

    from aseme_dsl.runtime.agent import Agent
    from aseme_dsl.runtime.execution import Execution
    from aseme_dsl.runtime.processes import Processes

SWITCH = 1e-4
"""How long, in seconds, a thread that computes may keep the interpreter from one that has an input."""
GRACE = 2.0
"""How long, in seconds, activities that were cancelled at the end of a run may take to return."""


class _Depth(threading.local):
    """Of each thread: how many locks it holds or agents it steps, and whom it has woken meanwhile."""

    def __init__(self) -> None:
        self.depth = 0
        self.woken: list[Agent] = []


class _Worker:
    """A resident thread that runs activities, one after the other."""

    def __init__(self, driver: RealDriver, number: int) -> None:
        self.driver = driver
        self.queue: SimpleQueue[Execution | None] = SimpleQueue()
        self.thread = threading.Thread(target=self._work, name=f"aseme activity {number}", daemon=True)
        self.thread.start()

    def _work(self) -> None:
        while (execution := self.queue.get()) is not None:
            execution.run()
            self.driver.ended(execution)
            self.driver.idle.append(self)


class RealDriver:
    """Drives a team in real time."""

    def __init__(self, path: Sequence[Path] = (), origin: int | None = None) -> None:
        """`path` are the folders where worker processes find what they import; `origin` is the clock's."""
        self.clock = RealClock(origin)
        self.agents: Sequence[Agent] = ()
        self.until: int | None = None
        """The moment after which nothing is done any more."""
        self.advance: Callable[[int], None] = lambda moment: None
        """Called after timers were due."""
        self.settled: Callable[[], str | None] = lambda: None
        """Called when an agent has ended or, with `watch`, stepped; a reason ends the run."""
        self.watch = False
        self.complain: Callable[[str], None] = lambda text: None
        """Called for an activity that does not end, and an error in a callback of the event loop."""
        self.reason = ""
        self.idle: list[_Worker] = []
        self._path = tuple(path)
        self._workers: list[_Worker] = []
        self._live: set[Execution] = set()
        self._timers = Timers()
        self._condition = threading.Condition()
        self._stop: str | None = None
        self._news = False
        self._error: BaseException | None = None
        self._locks: dict[str, threading.Lock] = {}
        self._owners: dict[str, int] = {}
        self._depth = _Depth()
        self._making = threading.Lock()
        self._loop: AbstractEventLoop | None = None
        self._loop_thread: threading.Thread | None = None
        self._processes: Processes | None = None

    # ---- the driver's interface --------------------------------------------------------------

    def bring(self, agents: Sequence[Agent]) -> None:
        """Take these agents, in the team's order."""
        self.agents = agents
        self._locks = {agent.name: threading.Lock() for agent in agents}

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment, in the thread of the timers; at once, if that has passed."""
        with self._condition:
            timer = self._timers.add(moment, call, background)
            if self._timers.next() == moment:
                self._condition.notify()
            return timer

    def owns(self, agent: Agent) -> bool:
        """Whether this thread is the one that steps the agent just now."""
        return self._owners.get(agent.name) == threading.get_ident()

    def wake(self, agent: Agent) -> None:
        """Step the agent, unless another thread does; then that one takes what has come in."""
        mine = self._depth
        if mine.depth:
            if agent not in mine.woken:
                mine.woken.append(agent)
        else:
            with self.holding():
                mine.woken.append(agent)

    @contextmanager
    def holding(self) -> Iterator[None]:
        """Agents that are woken inside step when the outermost one of this thread ends."""
        mine = self._depth
        mine.depth += 1
        try:
            yield
            if mine.depth == 1:
                while mine.woken:
                    self._step(mine.woken.pop(0))
        finally:
            mine.depth -= 1

    def _step(self, agent: Agent) -> None:
        lock = self._locks[agent.name]
        while agent.intake and lock.acquire(blocking=False):
            self._owners[agent.name] = threading.get_ident()
            try:
                while agent.intake:
                    agent.process(agent.take())
            except BaseException as error:  # of the runtime itself: nobody above may swallow it
                self._error = error
                self.stop("error")
            finally:
                del self._owners[agent.name]
                lock.release()
            if agent.over or self.watch:
                self._tell()

    @contextmanager
    def guard(self, agent: Agent) -> Iterator[None]:
        """Nobody steps the agent inside; what comes in meanwhile is taken at the end."""
        if self.owns(agent):
            yield
            return
        with self._locks[agent.name]:
            self._owners[agent.name] = threading.get_ident()
            try:
                yield
            finally:
                del self._owners[agent.name]
        if agent.intake:
            self.wake(agent)

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity where its kind belongs."""
        with self._making:
            self._live.add(execution)
        if execution.kind == "async":
            self._launch_async(execution)
        elif execution.kind == "process":
            self._launch_process(execution)
        else:
            execution.handle = threading.Event()
            try:
                worker = self.idle.pop()
            except IndexError:
                with self._making:
                    worker = _Worker(self, len(self._workers) + 1)
                    self._workers.append(worker)
            worker.queue.put(execution)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left."""
        if execution.kind == "async":
            if self._loop is not None:
                self._loop.call_soon_threadsafe(_cancel_task, execution)
        elif execution.kind == "process":
            if self._processes is not None:
                self._processes.cancel(execution)
        elif execution.handle is not None:
            execution.handle.set()

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the activity's own thread."""
        if execution.cancelled or execution.handle.wait(duration / SECOND):
            raise Cancelled

    def ended(self, execution: Execution) -> None:
        """The code of an activity has come to its end, and its agent knows."""
        with self._condition:
            self._live.discard(execution)
        if self._stop is not None:
            self._tell()

    # ---- where activities run ----------------------------------------------------------------

    def _launch_async(self, execution: Execution) -> None:
        from aseme_dsl.runtime.real_loop import start_loop

        with self._making:
            if self._loop is None:
                self._loop, self._loop_thread = start_loop(self.complain)
        self._loop.call_soon_threadsafe(self._begin_task, execution)

    def _begin_task(self, execution: Execution) -> None:
        from aseme_dsl.runtime.virtual_loop import run_async

        assert self._loop is not None
        task = execution.handle = self._loop.create_task(run_async(execution))
        task.add_done_callback(lambda done: self.ended(execution))

    def _launch_process(self, execution: Execution) -> None:
        from aseme_dsl.runtime.processes import Processes

        with self._making:
            if self._processes is None:
                self._processes = Processes(self._path, self.ended)
        self._processes.launch(execution)

    # ---- the loop ----------------------------------------------------------------------------

    def run(self) -> None:
        """Keep the timers until `until` is reached, `settled` gives a reason or `stop` is called.

        Then the agents are stopped and their activities cancelled; what has not returned after a while is
        complained about. Raises what the runtime itself raises, never what activities raise.
        """
        before = sys.getswitchinterval()
        sys.setswitchinterval(min(SWITCH, before))
        try:
            self._keep_time()
            self._close()
        finally:
            sys.setswitchinterval(before)
        if self._error is not None:
            raise self._error

    def stop(self, reason: str) -> None:
        """End the run. May be called from any thread and from a signal handler."""
        if self._stop is None:
            self._stop = reason
        self._tell()

    def _tell(self) -> None:
        """There is news for the thread that keeps the timers."""
        with self._condition:
            self._news = True
            self._condition.notify()

    def _keep_time(self) -> None:
        while self._stop is None:
            self._news = False
            now = self.clock.now()
            reason = "time" if self.until is not None and now >= self.until else self.settled()
            if reason is not None:
                self.stop(reason)
                break
            with self._condition:
                timer = self._timers.take(now)
            if timer is not None:
                if timer.call is not None:
                    timer.call()
                continue
            self.advance(now)
            with self._condition:
                if not self._news:
                    self._condition.wait(self._rest())
        self.reason = self._stop or ""

    def _rest(self) -> float | None:
        """The seconds until something is due."""
        moments = [m for m in (self._timers.next(), self.until) if m is not None]
        return max(0.0, (min(moments) - self.clock.now()) / SECOND) if moments else None

    def _close(self) -> None:
        for agent in self.agents:
            with self.guard(agent):
                agent.stop()
        deadline = self.clock.now() + int(GRACE * SECOND)
        with self._condition:
            while self._live and (rest := deadline - self.clock.now()) > 0:
                self._condition.wait(min(rest / SECOND, 0.05))
            left = sorted(self._live, key=lambda execution: (execution.agent, execution.label))
        for execution in left:
            self.complain(
                f"activity {execution.activity} of {execution.agent} has not ended {GRACE:g} s after it was "
                "cancelled"
            )
        for worker in self._workers:
            worker.queue.put(None)
        if self._processes is not None:
            self._processes.close()
        if self._loop is not None and self._loop_thread is not None:
            self._loop.call_soon_threadsafe(self._loop.stop)
            self._loop_thread.join(GRACE)
        if not left:
            for worker in self._workers:
                worker.thread.join(GRACE)


def _cancel_task(execution: Execution) -> None:
    task: Any = execution.handle
    if task is not None:
        task.cancel()
