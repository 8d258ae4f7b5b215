"""Health: whether a process is ready, and what is wrong, looked at again and again in a thread of its own."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.driver.real import RealDriver
from aseme_dsl.runtime.time.clock import SECOND

if TYPE_CHECKING:
    from aseme_dsl.runtime.team.team import Team

LOOK = 0.5
"""Seconds between two looks, if the watchdog needs no shorter ones."""
PATIENCE = 2.0
"""After so many seconds without a timer, or in one step, a process is stuck."""
_NEVER = "the run has not begun"


@dataclass(frozen=True, slots=True)
class Health:
    """How a process is. If it runs and nothing is wrong, it is ready. `stuck`: why only a restart helps."""

    begun: bool = False
    problems: tuple[str, ...] = ()
    stuck: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    """What an operator may want to know: which agents a swap holds, and which elsewhere are not connected."""

    @property
    def is_ready(self) -> bool:
        """Whether the agents here run, and nothing is wrong."""
        return self.begun and not self.problems and not self.stuck

    @property
    def is_alive(self) -> bool:
        """Whether no restart is needed."""
        return not self.stuck

    def reasons(self) -> tuple[str, ...]:
        """Why it is not ready."""
        return (*(() if self.begun else (_NEVER,)), *self.stuck, *self.problems)


class Looker:
    """Looks at a team that runs in real time, in a thread, until it is closed."""

    def __init__(self, team: Team, seen: Callable[[Health], None], pause: float = LOOK) -> None:
        """`seen` is given what each look has found."""
        self.health = Health()
        self._team = team
        self._seen = seen
        self._pause = pause
        self._closed = threading.Event()
        self._beat = time.monotonic()
        self._beats = 0
        self._since: dict[str, float] = {}
        self._thread = threading.Thread(target=self._look_on, name="aseme health", daemon=True)

    def begin(self) -> None:
        """Begin to look."""
        self._thread.start()

    def close(self) -> None:
        """Look no more."""
        self._closed.set()
        self._thread.join(1.0)

    def _look_on(self) -> None:
        while not self._closed.wait(self._pause):
            self.health = self._look()
            self._seen(self.health)

    def _look(self) -> Health:
        team, driver = self._team, self._team.driver
        begun = team.trace.begun and all(agent.chart.started for agent in team.agents)
        if not begun:
            return Health()
        now = time.monotonic()
        stuck: list[str] = []
        held: list[str] = []
        if self._beats == 0 or self._beat > now - PATIENCE:
            self._beats += 1
            driver.at(driver.clock.now() + round(self._pause * SECOND / 2), self._mark, True)
            if self._beats == 1:
                self._beat = now
        else:
            stuck.append(f"no timer has run for {now - self._beat:.1f} s")
        for agent in team.agents:
            if isinstance(driver, RealDriver) and driver.look(agent, _nothing, 0.05):
                self._since.pop(agent.name, None)
            elif isinstance(driver, RealDriver) and driver.is_held(agent):
                self._since.pop(agent.name, None)
                held.append(f"a swap holds {agent.name}")
            elif now - self._since.setdefault(agent.name, now) > PATIENCE:
                stuck.append(f"{agent.name} has been in one step for {now - self._since[agent.name]:.1f} s")
        problems = [f"{a.name} failed: {a.chart.failure}" for a in team.agents if a.chart.failure is not None]
        if team.trace.error is not None:
            problems.append(team.trace.error)
        notes = [f"{name} is not connected" for name, peer in team.peers().items() if not peer.alive]
        return Health(True, tuple(problems), tuple(stuck), (*held, *notes))

    def _mark(self) -> None:
        self._beat = time.monotonic()


def _nothing() -> None:
    pass


__all__ = ["LOOK", "PATIENCE", "Health", "Looker"]
