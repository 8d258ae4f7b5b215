"""Real time: agents step where their inputs come in, activities run beside them.

A step has no thread of its own. Who posts an input appends it to the agent's intake and steps the agent,
unless another thread does. That thread then takes the new input, too, before it lets go. So there is one
order of inputs and no hand-over to another thread, which would wait for the interpreter's lock. A thread of
its own keeps the timers; the one that calls `run` looks after what is stuck, and after what can wait.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING

from aseme_dsl.runtime.driver.real_activities import RealActivities
from aseme_dsl.runtime.driver.real_steps import Steps
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.driver.run_state import PAUSE, RunState
from aseme_dsl.runtime.ports import Complain, Stepping
from aseme_dsl.runtime.time.clock import SECOND, RealClock, shown
from aseme_dsl.runtime.time.timer_thread import Timekeeper
from aseme_dsl.runtime.time.timers import Timer
from aseme_dsl.runtime.workers.process_wide import switching

if TYPE_CHECKING:
    from pathlib import Path

    from aseme_dsl.runtime.activity.execution import Execution
    from aseme_dsl.runtime.version.versions import VersionFiles

GRACE = 1.0
"""How long, in seconds, activities that were cancelled at the end of a run may take to return."""
LEAVE = 0.3
"""How long, in seconds, threads and processes may take to end after that."""
LOOK = 0.25
"""Seconds between two checks for what is stuck, and for what can wait."""


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
        """`path` are the folders where worker processes find what they import, and `names` are other names of
        packages there (`runtime.loading.other_names`). `code` is the version that runs, if it is not the
        build itself; `origin` is the clock's."""
        self.clock = RealClock(origin)
        self.options = options or RealTime()
        self.agents: Sequence[Stepping] = ()
        self.until: int | None = None
        """The moment after which nothing is done any more."""
        self.advance: Callable[[int], None] = lambda moment: None
        """Called now and then, for what can wait."""
        self.settled: Callable[[], str | None] = lambda: None
        """Called when an agent has ended or, with `watch`, stepped; a reason ends the run."""
        self.ending: Callable[[], None] = lambda: None
        """Called once, when the run is to end and nothing has been stopped yet."""
        self.idle_since: int | None = None
        """Always None: in real time an input may come from outside at any moment."""
        self.complain: Complain = lambda text, agent="", activity=None: None
        """Told what is stuck or cannot be had, and errors in callbacks of the event loop."""
        self.reason = ""
        self.left: tuple[str, ...] = ()
        """Activities, agents and threads of activities that had not ended when the run was over."""
        self._state = state = RunState()
        self._others = {*threading.enumerate(), threading.main_thread()}
        self._timekeeper = Timekeeper(self.clock, state.fail)
        self._steps = steps = Steps(state, self._complain)
        self.activities = RealActivities(
            self.options, path, names or {}, code, state, self._after, self._complain
        )
        # Not methods that ask `steps`: each message would pay for a further call.
        self.owns: Callable[[Stepping], bool] = steps.owns
        self.wake: Callable[[Stepping], None] = steps.wake
        self.guard: Callable[[Stepping], AbstractContextManager[None]] = steps.guard
        self.hold: Callable[[Stepping], AbstractContextManager[None]] = steps.hold
        self.is_held: Callable[[Stepping], bool] = steps.is_held
        self.holding: Callable[[], AbstractContextManager[None]] = steps.holding

    @property
    def watch(self) -> bool:
        """Whether `settled` is called after each step."""
        return self._state.watch

    @watch.setter
    def watch(self, watch: bool) -> None:
        self._state.watch = watch

    # ---- the driver's interface --------------------------------------------------------------

    def bring(self, agents: Sequence[Stepping]) -> None:
        """Take these agents, in the team's order."""
        self.agents = agents
        self._steps.bring(agents)

    def know_threads(self) -> None:
        """The threads that there are now are not those of activities."""
        self._others.update(threading.enumerate())

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment, in the thread of the timers; at once, if that has passed."""
        return self._timekeeper.at(moment, call, background)

    def _after(self, duration: int, call: Callable[[], None]) -> Timer:
        return self.at(self.clock.now() + duration, call)

    def look(self, agent: Stepping, call: Callable[[], None], seconds: float = PAUSE) -> bool:
        """Make a call between two steps of the agent; False if it is in a step for so many seconds."""
        return self._steps.look(agent, call, seconds)

    def renew(self, path: Sequence[Path], names: Mapping[str, str], code: VersionFiles | None) -> None:
        """Activities of another version begin now: their processes import what they need from here."""
        self.activities.renew(path, names, code)

    def have_threads(self) -> None:
        """Have the threads that the agents' plans can need: none is made in the midst of the run."""
        self.activities.have_threads(2 * sum(agent.in_threads() for agent in self.agents))

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity where its kind belongs."""
        self.activities.launch(execution)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left, and see to it that it does not stay for ever."""
        self.activities.cancel(execution)

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the activity's own thread."""
        self.activities.wait(execution, duration)

    def _complain(self, text: str, agent: str = "", activity: str | None = None) -> None:
        self.complain(text, agent, activity)

    # ---- the loop ----------------------------------------------------------------------------

    def run(self) -> None:
        """Continue until `until` is reached, `settled` gives a reason or `stop` is called.

        Then the agents are stopped and their activities cancelled; what has not returned after a while is
        complained about. Raises what the runtime itself raises, never what activities raise.
        """
        with switching(self.options.switch_interval / SECOND):
            self._timekeeper.start(self.until, self.options.priority, self._complain)
            self._look_after()
            self._close()
        if self._state.error is not None:
            raise self._state.error

    def stop(self, reason: str) -> None:
        """End the run. May be called from any thread and from a signal handler."""
        self._state.stop(reason)

    def _look_after(self) -> None:
        """Ask whether the run is over when there are news, and look after everything now and then."""
        next_look = time.monotonic() + LOOK
        state = self._state
        while state.ends is None:
            state.forget()
            now = self.clock.now()
            reason = "time" if self.until is not None and now >= self.until else self.settled()
            if reason is not None:
                self.stop(reason)
                break
            if time.monotonic() >= next_look:
                next_look = time.monotonic() + LOOK
                self.advance(now)
                self._look_for_stuck()
            rest = min(next_look - time.monotonic(), 5 * PAUSE if self.watch else LOOK)
            if self.until is not None:
                rest = min(rest, (self.until - self.clock.now()) / SECOND)
            state.wait_for_news(rest)
        self.reason = state.ends or ""

    def _look_for_stuck(self) -> None:
        """Report, once, a step or an event loop in which nothing has moved since long."""
        patience = max(2, round(self.options.cancel_within / SECOND / LOOK))
        self.activities.look_for_stuck(patience)
        self._steps.look_for_stuck(self.agents, patience, shown(self.options.cancel_within))

    def _close(self) -> None:
        begun = time.monotonic()

        def rest(seconds: float) -> float:
            return max(0.0, begun + seconds - time.monotonic())

        self._timekeeper.stop(0.2)
        self.ending()
        stuck = [agent.name for agent in self.agents if not self._stop_agent(agent, rest)]
        self._state.wait_while(self.activities.unfinished, lambda: rest(GRACE))
        left = self.activities.unfinished()
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
        self.activities.close(lambda: rest(GRACE + LEAVE))

    def _stop_agent(self, agent: Stepping, rest: Callable[[float], float]) -> bool:
        """Stop an agent, unless it is stuck in a step."""
        if not self.look(agent, agent.stop, rest(GRACE / 2)):
            return False
        self.wake(agent)
        return True
