"""The port between a team and its transport; as it is, that of a team that is all in one process."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Identity, Reason
from aseme_dsl.runtime.time.clock import Clock
from aseme_dsl.runtime.time.timers import Scheduler

if TYPE_CHECKING:
    from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan
    from aseme_dsl.runtime.message.acl import AclMessage, AgentIdentifier, FipaMessage
    from aseme_dsl.runtime.message.wire import Schema
    from aseme_dsl.runtime.ports import Receiver
    from aseme_dsl.runtime.trace.trace import Trace

Answer = Callable[[str, bytes], Mapping[str, object]]
"""What answers a control request to an agent, as it came; the answer is a JSON object. May be called from any
thread, and never raises."""


class TransportError(Exception):
    """The transport cannot be used as it is asked to; the text says why."""


@dataclass(frozen=True, slots=True)
class Peer:
    """What this process knows of an agent in another process, and counts of messages from it."""

    name: str
    alive: bool
    incarnation: int | None
    """Differs for each start of the agent; None if the agent has not been seen yet."""
    taken: int = 0
    duplicated: int = 0
    reordered: int = 0
    refused: int = 0
    """Messages that its build means in another way, or for an agent that is not in this process."""
    rejected: int = 0
    """Messages to the agent that it has refused, since its build means them in another way."""
    unreadable: int = 0
    """Packets that are not a message."""
    late: int = 0
    """Messages of an incarnation that has ended."""
    dropped: int = 0
    """`data` samples that the network dropped."""
    lost: int = 0
    """Messages to the agent that could not be delivered."""
    unacknowledged: int = 0
    """Messages to the agent that are on their way, or wait for it."""
    uncertainty: int | None = 0
    """Largest error of its times here, in ns; 0 on one machine, None until its clock has been measured."""
    model: str = ""
    """The hash of the models that it follows; empty until it has said that."""
    incompatible: tuple[str, ...] = ()
    """What does not work between its build and ours, for people."""
    difference: int | None = 0
    """Added to the times of its clock, in ns; 0 on one machine, None until its clock has been measured."""


class MailPort(Protocol):
    """The conversations of a team, as its transport sees them."""

    def arrived(self, agent: Receiver, acl: AclMessage, members: Mapping[str, Sequence[str]]) -> None: ...
    def receive_external(self, to: str, message: FipaMessage) -> None: ...
    def refused(self, agent: Receiver, answer: AclMessage, reason: str) -> None: ...
    def appeared(self, name: str, life: int | None = ...) -> None: ...
    def vanished(self, name: str, reason: Reason = ...) -> None: ...


class BusPort(Protocol):
    """The bus of a team, as its transport sees it."""

    def arrived(
        self,
        agent: Receiver,
        channel: str,
        message: object,
        sender: str,
        identity: Identity,
        moment: int,
        host: str | None = None,
    ) -> str | None: ...
    def concerns(self, sender: str, channel: str, receiver: str) -> bool: ...


class DriverPort(Scheduler, Protocol):
    """The driver of a team, as its transport sees it."""

    def stop(self, reason: str) -> None: ...


class Connected(Protocol):
    """A team as its transport sees it: those of its agents that are here, and those that are elsewhere."""

    @property
    def agents(self) -> Sequence[Receiver]: ...
    @property
    def elsewhere(self) -> Mapping[str, Plan]: ...
    @property
    def system(self) -> str: ...
    @property
    def driver(self) -> DriverPort: ...
    @property
    def trace(self) -> Trace: ...
    @property
    def bus(self) -> BusPort: ...
    @property
    def conversations(self) -> MailPort: ...


class Transport:
    """What the bus, the conversations and the team need; this one, of a team that is all in one process.

    All may be called from any thread.
    """

    networked = False
    """Whether some of the team run elsewhere."""
    life = ""
    """What tells this process's conversations from those of an earlier incarnation; empty without others."""
    behind = 0
    """Identities of agents are above this number: those of an earlier incarnation are not used again."""

    def machine(self, clock: Clock) -> dict[str, int] | None:
        """Which clock the machine has, and its time when the run began, if other traces need that."""
        return None

    def begin(self, team: Connected) -> None:
        """Connect. What comes waits for `go`. Raises TransportError if that cannot be."""

    def go(self) -> None:
        """Hand on what comes: the agents have everything that is there from the beginning."""

    def close(self) -> None:
        """Let what is on its way arrive, as far as that is quick, and disconnect."""

    def publish(
        self,
        identity: Identity,
        rules: ChannelInfo | None,
        channel: str,
        message: object,
        to: Sequence[str],
        moment: int,
        host: str | None,
    ) -> None:
        """Carry a message to agents elsewhere; it was measured at `moment` of the run. Does not wait."""

    def carry(self, message: AclMessage, to: str, members: Mapping[str, Sequence[str]]) -> None:
        """Carry an agent message to an agent elsewhere, with what is known of who takes part.

        Does not wait.
        """

    def carry_outside(self, message: FipaMessage, to: AgentIdentifier) -> bool:
        """Carry a message to an external agent; False if there is no route to it. Does not wait.

        What such agents say is handed to `Conversations.receive_external`.
        """
        return False

    def peers(self) -> dict[str, Peer]:
        """The agents of the team that run in other processes, by name."""
        return {}

    def is_there(self, name: str) -> bool:
        """Whether an agent that runs elsewhere is there just now."""
        return False

    def history(
        self, sender: str, channel: str, since: int, until: int, timeout: float = 1.0
    ) -> list[tuple[int, object]]:
        """The data that an agent elsewhere has published in a span of the run's time, as (time, message).

        Waits for the answer. Raises TransportError if none comes.
        """
        raise TransportError(f"{sender} does not run in another process")

    def ask(self, name: str, request: dict[str, object], timeout: float = 1.0) -> dict[str, object]:
        """Put a control request to an agent elsewhere. Raises TransportError if no answer comes."""
        raise TransportError(f"{name} does not run in another process")

    def ask_epoch(self, name: str, timeout: float = 1.0) -> object:
        """What an agent elsewhere says of its epoch, as JSON; None: nothing. Raises TransportError."""
        return None

    def tell_epoch(self, tell: Callable[[], Mapping[str, object]]) -> None:
        """Have agents elsewhere that ask be answered with this."""

    def renew(self, schema: Schema, model: str, plans: Sequence[Plan]) -> None:
        """The agents of this process continue with another version of the model."""

    def answer(self, answer: Answer) -> None:
        """Have control requests from elsewhere answered by this."""


LOCAL = Transport()
