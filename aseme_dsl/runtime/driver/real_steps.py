"""Real steps: which thread steps an agent in real time, and which agents do not come to rest."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager

from aseme_dsl.runtime.activity.stacks import place_of
from aseme_dsl.runtime.driver.run_state import PAUSE, RunState
from aseme_dsl.runtime.ports import Complain, Stepping

RESTLESS = 1000
"""After so many steps that follow each other in one thread, another thread continues."""
BRIEF = 20
"""After so many steps, a thread that only steps looks whether the run is over, and gives way to others."""
MOST_HELD = 30.0
"""A swap that holds an agent for longer than so many seconds is stuck itself."""


class _Depth(threading.local):
    """Of each thread: how many locks it holds or agents it steps, and whom it has woken meanwhile."""

    def __init__(self) -> None:
        self.depth = 0
        self.woken: list[Stepping] = []
        self.has_time = False
        """Whether the thread does nothing but step."""


class _Hold:
    """What `Steps.holding` gives, the same each time: what is inside of which is counted by the thread.

    Not a generator: each message enters it twice, and a generator is made anew each time.
    """

    __slots__ = ("_depth", "_rest")

    def __init__(self, depth: _Depth, rest: Callable[[_Depth], None]) -> None:
        self._depth = depth
        self._rest = rest

    def __enter__(self) -> None:
        self._depth.depth += 1

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        mine = self._depth
        try:
            if kind is None and mine.depth == 1 and mine.woken:
                self._rest(mine)
        finally:
            mine.depth -= 1


class Steps:
    """The steps of the agents: each is stepped by one thread at a time, the one that wakes it."""

    def __init__(self, state: RunState, complain: Complain) -> None:
        self._state = state
        self._complain = complain
        self._locks: dict[str, threading.Lock] = {}
        self._owners: dict[str, int] = {}
        self._held: dict[str, float] = {}
        """The agents that a swap holds, and since when."""
        self._long: dict[str, tuple[int, int, int]] = {}
        self._restless: set[str] = set()
        self._depth = _Depth()
        self._hold = _Hold(self._depth, self._rest)

    def bring(self, agents: Sequence[Stepping]) -> None:
        """These agents can be stepped from now on."""
        self._locks = {agent.name: threading.Lock() for agent in agents}

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

    def holding(self) -> AbstractContextManager[None]:
        """Agents that are woken inside step when the outermost one of this thread ends."""
        return self._hold

    def _rest(self, mine: _Depth) -> None:
        """Step whom this thread has woken. That may not end soon, if they wake each other or more comes than
        they can take. Then another thread continues: this one may have to look at the time."""
        steps = 0
        while mine.woken and (self._state.ends is None or not mine.has_time):
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
            except BaseException as error:  # of the runtime itself: no caller may swallow it
                self._state.fail(error)
            finally:
                del self._owners[agent.name]
                lock.release()
            if agent.over:
                self._state.tell()
            elif self._state.watch and not self._state.news:
                self._state.notice()
            if steps >= most:
                if agent.intake and agent not in self._depth.woken:
                    self._depth.woken.append(agent)
                break
        return steps

    @contextmanager
    def guard(self, agent: Stepping) -> Iterator[None]:
        """No thread steps the agent inside; what comes in meanwhile is taken at the end."""
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

    @contextmanager
    def hold(self, agent: Stepping) -> Iterator[None]:
        """As `guard`, for a swap: that it takes long is not a fault of the agent."""
        with self.guard(agent):
            self._held[agent.name] = time.monotonic()
            try:
                yield
            finally:
                del self._held[agent.name]

    def is_held(self, agent: Stepping) -> bool:
        """Whether a swap holds the agent, and not for too long."""
        return self._held.get(agent.name, -MOST_HELD) > time.monotonic() - MOST_HELD

    def look(self, agent: Stepping, call: Callable[[], None], seconds: float = PAUSE) -> bool:
        """Make a call between two steps of the agent; False if it is in a step for so many seconds."""
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

    def look_for_stuck(self, agents: Sequence[Stepping], patience: int, since: str) -> None:
        """Report, once, a step in which nothing has moved for `patience` looks, which is `since` in words."""
        found: dict[str, tuple[int, int, int]] = {}
        for agent in agents if self._owners else ():
            thread = self._owners.get(agent.name)
            if thread is None or self.is_held(agent):
                continue
            known, steps, looks = self._long.get(agent.name, (thread, agent.steps, 0))
            if (known, steps) == (thread, agent.steps):
                found[agent.name] = thread, agent.steps, looks + 1
                if looks == patience:
                    self._complain(
                        f"{agent.name} has been in one step for {since}{place_of(thread)}: a `step` activity "
                        "or a function must not block",
                        agent.name,
                    )
        self._long = found
