"""Real time: agents step where their inputs come in, activities run beside them.

A step has no thread of its own. Who posts an input appends it to the agent's intake and, if nobody else is
stepping the agent, steps it; else whoever does takes the new input too before it lets go. So there is one
order of inputs and no hand-over to another thread, which would wait for the interpreter's lock. A thread of
its own keeps the timers; the one that calls `run` looks after what is stuck, and after what can wait.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

from aseme_dsl.runtime.activity.stacks import place_of
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.ports import Stepping
from aseme_dsl.runtime.time.clock import SECOND, RealClock, shown
from aseme_dsl.runtime.time.timer_thread import Timekeeper
from aseme_dsl.runtime.time.timers import Timer
from aseme_dsl.runtime.workers.process_wide import switching
from aseme_dsl.runtime.workers.threads import Threads

if TYPE_CHECKING:
    from pathlib import Path

    from aseme_dsl.runtime.activity.execution import Execution
    from aseme_dsl.runtime.driver.real_loop import RealLoop
    from aseme_dsl.runtime.version.versions import VersionFiles
    from aseme_dsl.runtime.workers.processes import Processes

GRACE = 1.0
"""How long, in seconds, activities that were cancelled at the end of a run may take to return."""
LEAVE = 0.3
"""How long, in seconds, threads and processes may take to end after that."""
LOOK = 0.25
"""How often, in seconds, somebody looks for what is stuck, and for what can wait."""
RESTLESS = 1000
"""After so many steps that follow each other in one thread, another thread goes on with them."""
BRIEF = 20
"""After so many steps, a thread that only steps looks whether the run is over, and gives way to others."""
PAUSE = 0.01
"""How long, in seconds, at least passes between two questions whether the run is over."""


class _Depth(threading.local):
    """Of each thread: how many locks it holds or agents it steps, and whom it has woken meanwhile."""

    def __init__(self) -> None:
        self.depth = 0
        self.woken: list[Stepping] = []
        self.has_time = False
        """Whether the thread does nothing but step."""


class RealDriver:
    """Drives a team in real time."""

    def __init__(
        self,
        path: Sequence[Path] = (),
        options: RealTime | None = None,
        origin: int | None = None,
        names: Mapping[str, str] | None = None,
        code: VersionFiles | None = None,
    ) -> None:
        """`path` are the folders where worker processes find what they import, `names` are other names of
        packages there (`runtime.loading.other_names`), and `code` is the version that is played, if it is not
        the build itself; `origin` is the clock's."""
        self.clock = RealClock(origin)
        self.options = options or RealTime()
        self.agents: Sequence[Stepping] = ()
        self.until: int | None = None
        """The moment after which nothing is done any more."""
        self.advance: Callable[[int], None] = lambda moment: None
        """Called now and then, for what can wait."""
        self.settled: Callable[[], str | None] = lambda: None
        """Called when an agent has ended or, with `watch`, stepped; a reason ends the run."""
        self.watch = False
        self.ending: Callable[[], None] = lambda: None
        """Called once, when the run is to end and nothing has been stopped yet."""
        self.idle_since: int | None = None
        """Always None: in real time an input may come from outside at any moment."""
        self.complain: Callable[..., None] = lambda text, agent="", activity=None: None
        """Told what is stuck or cannot be had, and errors in callbacks of the event loop."""
        self.reason = ""
        self.left: tuple[str, ...] = ()
        """Activities, agents and threads of activities that had not ended when the run was over."""
        self._path = tuple(path)
        self._names = dict(names or {})
        self._code = code
        self._live: dict[Execution, Timer | None] = {}
        self._timekeeper = Timekeeper(self.clock, self._fail)
        self._condition = threading.Condition()
        self._stop: str | None = None
        self._news = False
        self._urgent = False
        self._error: BaseException | None = None
        self._locks: dict[str, threading.Lock] = {}
        self._owners: dict[str, int] = {}
        self._long: dict[str, tuple[int, int, int]] = {}
        self._restless: set[str] = set()
        self._others = {*threading.enumerate(), threading.main_thread()}
        self._depth = _Depth()
        self._making = threading.Lock()
        self._threads = Threads(self.options.threads, self.ended, self._complain)
        self._loop: RealLoop | None = None
        self._processes: Processes | None = None

    # ---- the driver's interface --------------------------------------------------------------

    def bring(self, agents: Sequence[Stepping]) -> None:
        """Take these agents, in the team's order."""
        self.agents = agents
        self._locks = {agent.name: threading.Lock() for agent in agents}

    def know_threads(self) -> None:
        """The threads that there are now are not those of activities."""
        self._others.update(threading.enumerate())

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment, in the thread of the timers; at once, if that has passed."""
        return self._timekeeper.at(moment, call, background)

    def owns(self, agent: Stepping) -> bool:
        """Whether this thread is the one that steps the agent just now."""
        return self._owners.get(agent.name) == threading.get_ident()

    def wake(self, agent: Stepping) -> None:
        """Step the agent, unless another thread does; then that one takes what has come in."""
        mine = self._depth
        if not mine.depth:  # as `holding` does, without its price: this is what each message goes through
            mine.depth = 1
            try:
                self._step(agent)
                if mine.woken:
                    self._rest(mine)
            finally:
                mine.depth = 0
        elif agent not in mine.woken:
            mine.woken.append(agent)

    @contextmanager
    def holding(self) -> Iterator[None]:
        """Agents that are woken inside step when the outermost one of this thread ends."""
        mine = self._depth
        mine.depth += 1
        try:
            yield
            if mine.depth == 1 and mine.woken:
                self._rest(mine)
        finally:
            mine.depth -= 1

    def _rest(self, mine: _Depth) -> None:
        """Step whom this thread has woken. If that does not end soon, because they wake each other or more
        comes than they can take, another thread goes on: this one may have to look at the time."""
        steps = 0
        while mine.woken and (self._stop is None or not mine.has_time):
            if steps >= RESTLESS and not mine.has_time:
                woken, mine.woken = mine.woken, []
                threading.Thread(target=self._go_on, args=(woken,), name="aseme steps", daemon=True).start()
                return
            steps += self._step(mine.woken.pop(0), BRIEF if mine.has_time else RESTLESS)

    def _go_on(self, woken: list[Stepping]) -> None:
        """Step these agents, and whom they wake, until they come to rest or the run is over."""
        mine = self._depth
        mine.depth, mine.woken, mine.has_time = 1, woken, True
        for agent in woken:
            self._tell_of_restlessness(agent)
        self._rest(mine)

    def _tell_of_restlessness(self, agent: Stepping) -> None:
        """Tell once that an agent does not come to rest."""
        if agent.name in self._restless:
            return
        self._restless.add(agent.name)
        with self.guard(agent):
            text = f"{agent.name} has not come to rest for {RESTLESS} steps: {agent.cycle()}"
        more = "let something in it take time, unless more comes than it can take"
        self._complain(f"{text}; {more}", agent.name)

    def _step(self, agent: Stepping, most: int = RESTLESS) -> int:
        """Let an agent take what has come in; one that has not come to rest after `most` is woken once more.

        Gives the number of steps but those in which a queue became shorter: it comes to its end.
        """
        lock = self._locks[agent.name]
        steps = 0
        while agent.intake and lock.acquire(blocking=False):
            self._owners[agent.name] = threading.get_ident()
            try:
                while agent.intake and steps < most:
                    agent.process(agent.take())
                    steps += not agent.chart.drains
            except BaseException as error:  # of the runtime itself: nobody above may swallow it
                self._fail(error)
            finally:
                del self._owners[agent.name]
                lock.release()
            if agent.over:
                self._tell()
            elif self.watch and not self._news:
                self._news = True
                with self._condition:
                    self._condition.notify()
            if steps >= most:
                if agent.intake and agent not in self._depth.woken:
                    self._depth.woken.append(agent)
                break
        return steps

    @contextmanager
    def guard(self, agent: Stepping) -> Iterator[None]:
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

    def renew(self, path: Sequence[Path], names: Mapping[str, str], code: VersionFiles | None) -> None:
        """Activities of another version begin now: their processes import what they need from here."""
        with self._making:
            self._path = tuple(path)
            self._names = dict(names)
            self._code = code
            if self._processes is not None:
                self._processes.renew(self._path, self._names, code)

    def have_threads(self) -> None:
        """Have the threads that the agents' plans can need: none is made in the midst of the run."""
        self._threads.have(2 * sum(agent.in_threads() for agent in self.agents))

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity where its kind belongs."""
        with self._making:
            self._live[execution] = None
        if execution.kind == "async":
            self._async().launch(execution)
        elif execution.kind == "process":
            self._elsewhere().launch(execution)
        else:
            self._threads.launch(execution)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left, and see to it that it does not stay for ever."""
        self._tell_of_cancellation(execution)
        self._give_time(execution)

    def _give_time(self, execution: Execution) -> None:
        timer = self.at(self.clock.now() + self.options.cancel_within, lambda: self._overdue(execution))
        with self._making:
            if execution in self._live:
                self._live[execution] = timer
            else:
                timer.cancel()

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the activity's own thread."""
        self._threads.wait(execution, duration)

    def ended(self, execution: Execution) -> None:
        """The code of an activity has come to its end, and its agent knows."""
        with self._making:
            timer = self._live.pop(execution, None)
        if timer is not None:
            timer.cancel()
        if self._stop is not None:
            self._tell()

    # ---- where activities run ----------------------------------------------------------------

    def _async(self) -> RealLoop:
        from aseme_dsl.runtime.driver.real_loop import RealLoop

        with self._making:
            if self._loop is None:
                self._loop = RealLoop(self.ended, self._complain)
            return self._loop

    def _elsewhere(self) -> Processes:
        from aseme_dsl.runtime.workers.processes import Processes

        with self._making:
            if self._processes is None:
                options = self.options
                self._processes = Processes(
                    self._path,
                    options.processes,
                    options.process_memory,
                    self.ended,
                    self._complain,
                    self._names,
                    self._code,
                )
            return self._processes

    def _tell_of_cancellation(self, execution: Execution) -> None:
        if execution.kind == "async":
            self._async().cancel(execution)
        elif execution.kind == "process":
            self._elsewhere().cancel(execution)
        else:
            self._threads.cancel(execution)

    def _overdue(self, execution: Execution) -> None:
        """A cancelled activity has not returned in time: report it, and get rid of it where that can be."""
        with self._making:
            if execution not in self._live:
                return
        text = f"has not ended {shown(self.options.cancel_within)} after it was cancelled"
        if execution.kind == "process":
            if self._elsewhere().kill(execution, f"it {text}, and was killed"):
                self._report(execution, f"{text}: its process is killed")
            else:
                self._give_time(execution)
            return
        place = ""
        if execution.kind == "async":
            self._tell_of_cancellation(execution)
        else:
            place = self._threads.give_up(execution)
        self._report(execution, f"{text}{place}")

    def _report(self, execution: Execution, text: str) -> None:
        name = execution.activity
        self._complain(f"activity {name} {text}", execution.agent, name)

    def _complain(self, text: str, agent: str = "", activity: str | None = None) -> None:
        self.complain(text, agent, activity)

    # ---- the loop ----------------------------------------------------------------------------

    def run(self) -> None:
        """Go on until `until` is reached, `settled` gives a reason or `stop` is called.

        Then the agents are stopped and their activities cancelled; what has not returned after a while is
        complained about. Raises what the runtime itself raises, never what activities raise.
        """
        with switching(self.options.switch_interval / SECOND):
            self._timekeeper.start(self.until, self.options.priority, self._complain)
            self._look_after()
            self._close()
        if self._error is not None:
            raise self._error

    def stop(self, reason: str) -> None:
        """End the run. May be called from any thread and from a signal handler."""
        if self._stop is None:
            self._stop = reason
        self._tell()

    def _fail(self, error: BaseException) -> None:
        self._error = error
        self.stop("error")

    def _tell(self) -> None:
        """There is news for the thread that runs, which cannot wait."""
        with self._condition:
            self._news = self._urgent = True
            self._condition.notify()

    def _look_after(self) -> None:
        """Ask whether the run is over when there are news, and look after everything now and then."""
        next_look = time.monotonic() + LOOK
        while self._stop is None:
            self._news = self._urgent = False
            now = self.clock.now()
            reason = "time" if self.until is not None and now >= self.until else self.settled()
            if reason is not None:
                self.stop(reason)
                break
            if time.monotonic() >= next_look:
                next_look = time.monotonic() + LOOK
                self.advance(now)
                self._look_for_the_stuck()
            rest = min(next_look - time.monotonic(), 5 * PAUSE if self.watch else LOOK)
            if self.until is not None:
                rest = min(rest, (self.until - self.clock.now()) / SECOND)
            with self._condition:
                if not self._news:
                    self._condition.wait(max(0.0, rest))
                if self.watch and not self._urgent:
                    # Who steps does not ring meanwhile.
                    self._condition.wait_for(lambda: self._urgent, min(PAUSE, max(0.0, rest)))
        self.reason = self._stop or ""

    def _look_for_the_stuck(self) -> None:
        """Report, once, a step or an event loop in which nothing has moved since long."""
        patience = max(2, round(self.options.cancel_within / SECOND / LOOK))
        if self._loop is not None:
            self._loop.look(patience)
        self._threads.look()
        if self._processes is not None:
            self._processes.look()
        found: dict[str, tuple[int, int, int]] = {}
        for agent in self.agents if self._owners else ():
            thread = self._owners.get(agent.name)
            if thread is None:
                continue
            known, steps, looks = self._long.get(agent.name, (thread, agent.steps, 0))
            if (known, steps) == (thread, agent.steps):
                found[agent.name] = thread, agent.steps, looks + 1
                if looks == patience:
                    since = shown(self.options.cancel_within)
                    self._complain(
                        f"{agent.name} has been in one step for {since}{place_of(thread)}: a `step` activity "
                        "or a function must not block",
                        agent.name,
                    )
        self._long = found

    def _close(self) -> None:
        begun = time.monotonic()

        def rest(seconds: float) -> float:
            return max(0.0, begun + seconds - time.monotonic())

        self._timekeeper.stop(0.2)
        self.ending()
        stuck = [agent.name for agent in self.agents if not self._stop_agent(agent, rest)]
        with self._condition:
            while self._live and (seconds := rest(GRACE)) > 0:
                self._condition.wait(min(seconds, 0.05))
        with self._making:
            left = sorted(self._live, key=lambda execution: (execution.agent, execution.label))
        for execution in left:
            self._complain(
                f"activity {execution.activity} of {execution.agent} has not ended {GRACE:g} s after it was "
                "cancelled",
                execution.agent,
                execution.activity,
            )
        started = [
            thread for thread in threading.enumerate() if not thread.daemon and thread not in self._others
        ]
        for thread in started:  # Python would wait for them before it ends
            thread.join(rest(GRACE))
        started = [thread for thread in started if thread.is_alive()]
        for thread in started:
            self._complain(f"the thread {thread.name}, which an activity has started, still runs")
        for name in stuck:
            self._complain(f"{name} could not be stopped: it is still in a step", name)
        activities = [f"{item.agent}: {item.activity}" for item in left]
        self.left = (*activities, *stuck, *(thread.name for thread in started))
        pools = [pool for pool in (self._threads, self._processes, self._loop) if pool is not None]
        for pool in pools:
            pool.close()
        for pool in pools:
            pool.join(lambda: rest(GRACE + LEAVE))

    def _stop_agent(self, agent: Stepping, rest: Callable[[float], float]) -> bool:
        """Stop an agent, unless it is stuck in a step."""
        if not self.look(agent, agent.stop, rest(GRACE / 2)):
            return False
        self.wake(agent)
        return True

    def look(self, agent: Stepping, call: Callable[[], None], seconds: float = PAUSE) -> bool:
        """Make a call while nobody steps the agent; False if it is in a step for so many seconds."""
        lock = self._locks[agent.name]
        if not lock.acquire(timeout=max(0.001, seconds)):
            return False
        self._owners[agent.name] = threading.get_ident()
        try:
            call()
        finally:
            del self._owners[agent.name]
            lock.release()
        return True
