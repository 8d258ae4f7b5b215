"""Driver: what makes agents step and activities run; one for virtual and one for real time."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Protocol

from aseme_dsl.runtime.clock import Clock
from aseme_dsl.runtime.timers import Timer

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent import Agent
    from aseme_dsl.runtime.execution import Execution


class Driver(Protocol):
    """Time and concurrency, as the agents see them."""

    @property
    def clock(self) -> Clock:
        """The time of the run."""
        ...

    def at(self, moment: int, call: Callable[[], None], background: bool = False) -> Timer:
        """Make a call at a moment; at once, if that has passed."""
        ...

    def owns(self, agent: Agent) -> bool:
        """Whether this thread is the one that processes the agent just now."""
        ...

    def wake(self, agent: Agent) -> None:
        """The agent's intake is not empty: let it step."""
        ...

    def holding(self) -> AbstractContextManager[object]:
        """Agents that are woken meanwhile step only afterwards: for who holds a lock."""
        ...

    def guard(self, agent: Agent) -> AbstractContextManager[object]:
        """Nobody else touches the agent's chart meanwhile."""
        ...

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity; `execution.returned` is called at its end."""
        ...

    def cancel(self, execution: Execution) -> None:
        """Tell an activity whose code runs that it is cancelled."""
        ...

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the code of an activity. Raises Cancelled when it is cancelled."""
        ...
