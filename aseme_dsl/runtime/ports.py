"""Ports: what the rooms of the runtime know of each other, so that none needs the inside of another.

A receiver is an agent as the bus, the conversations and the transport see it; what steps is one as a driver
sees it. What only one room asks of another is said in that room.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sized
from contextlib import AbstractContextManager
from typing import Protocol, TypeVar

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.input_queue import Errand, Posted, Writer
from aseme_dsl.runtime.chart.inputs import Identity, Input
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.message.free import ACLMessage
from aseme_dsl.runtime.time.timers import Scheduler

RunningT = TypeVar("RunningT", contravariant=True)


class Complain(Protocol):
    """Reports to the user what is wrong, with the agent and the activity as far as they are known."""

    def __call__(self, text: str, agent: str = "", activity: str | None = None) -> None: ...


class Receiver(Protocol):
    """An agent that inputs are given to."""

    @property
    def name(self) -> str: ...
    @property
    def role(self) -> str: ...
    @property
    def plan(self) -> Plan: ...
    @property
    def over(self) -> bool: ...
    @property
    def kinds(self) -> Messages: ...
    @property
    def steps(self) -> int: ...
    def identity(self) -> Identity: ...
    def post(
        self,
        identity: Identity,
        item: Input,
        execution: Writer | None = None,
        conversation: str | None = None,
    ) -> None: ...
    def understood(self, content: object) -> object: ...
    @property
    def listens(self) -> bool:
        """Whether it has behaviours that may receive messages outside of every protocol."""
        ...

    def hear(self, identity: Identity, message: ACLMessage, refuse: Callable[[str], None]) -> None:
        """A message outside of every protocol has come; `refuse` gives the reason why it is not wanted."""
        ...

    def branch_info(self, label: str) -> BranchInfo: ...


class Stepping(Receiver, Protocol):
    """An agent that a driver steps."""

    @property
    def chart(self) -> Chart: ...
    @property
    def intake(self) -> Sized: ...
    def take(self) -> list[Posted | Errand]: ...
    def process(self, items: Iterable[Posted | Errand]) -> None: ...
    def in_threads(self) -> int: ...
    def cycle(self) -> str: ...
    def fail(self, reason: str) -> None: ...
    def stop(self) -> None: ...


class Driver(Scheduler, Protocol[RunningT]):
    """What makes agents step and activities run; one for virtual and one for real time."""

    def owns(self, agent: Stepping) -> bool:
        """Whether this thread is the one that processes the agent just now."""
        ...

    def wake(self, agent: Stepping) -> None:
        """The agent's intake is not empty: let it step."""
        ...

    def guard(self, agent: Stepping) -> AbstractContextManager[object]:
        """Only this thread touches the agent's chart meanwhile."""
        ...

    def hold(self, agent: Stepping) -> AbstractContextManager[object]:
        """As `guard`, for a swap: that it takes long is not a fault of the agent."""
        ...

    def launch(self, execution: RunningT) -> None:
        """Run the code of an activity; `execution.returned` is called at its end."""
        ...

    def cancel(self, execution: RunningT) -> None:
        """Tell an activity whose code runs that it is cancelled."""
        ...

    def wait(self, execution: RunningT, duration: int) -> None:
        """Let time pass in the code of an activity. Raises Cancelled when it is cancelled."""
        ...


class Links(Protocol):
    """Simulated links between the agents of a team."""

    def carry(
        self, sender: str, receiver: str, kind: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        """Carry a message of a kind; `give` gives it to its receiver.

        The kind is signal, state, data, radio or agent message, `what` its channel or the conversation.
        """
        ...


class Speaker(Protocol):
    """A robot's end of the radio, as who publishes sees it."""

    def send(self, channel: str, message: object, host: str | None, identity: Identity) -> None:
        """Say a message, now or as soon as the radio takes it."""
        ...
