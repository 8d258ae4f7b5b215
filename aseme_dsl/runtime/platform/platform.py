"""Platform: carries notes (headers with a text) between agents that have addresses. It may lose notes.

The agents of a team share the platform with external agents. `over_platform` makes a link of a platform.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

Headers = Mapping[str, str]
"""What is said of a text: FIPA's parameters of agent messages under their names there, and further ones."""


class Refused(Exception):
    """A connection that was not made, and that no further attempt would make; the text says why."""


class Receives(Protocol):
    """The receiving side of a platform. Any thread may call it, but for each agent only one at a time."""

    def came(self, to: str, origin: str, headers: Headers, body: str) -> None:
        """A note for one of our agents has come from the address `origin`. Raises nothing."""
        ...

    def unreachable(self, address: str) -> None:
        """The agents at this address are no longer reachable."""
        ...

    def returned(self, agent: str, address: str, name: str, reason: str) -> None:
        """What one of our agents said to an address was not delivered; `name` is its `reply-with`."""
        ...

    def disconnected(self, agent: str, reason: str) -> None:
        """One of our agents has lost its connection, which is made again."""
        ...

    def connected(self, agent: str, reason: str) -> None:
        """It can be reached again, perhaps at another address than before; the reason says with what."""
        ...


class Platform(Protocol):
    """A platform, as the agents of one process use it."""

    @property
    def name(self) -> str:
        """As people call it."""
        ...

    @property
    def largest(self) -> int:
        """So many bytes a text may have."""
        ...

    def start(self, agents: Sequence[str], receives: Receives) -> None:
        """Connect these agents. Raises TransportError if that cannot be."""
        ...

    def address_of(self, agent: str) -> str:
        """Where an agent of the team can be asked for, whichever incarnation it is."""
        ...

    def agent_at(self, address: str) -> str | None:
        """Which agent of the team an address belongs to; None: to an external agent."""
        ...

    def is_address(self, text: str) -> bool:
        """Whether the text has the form of an address on this platform."""
        ...

    def name_at(self, address: str) -> str:
        """The name of an external agent with this address: what remains when it connects again."""
        ...

    def here(self) -> dict[str, str]:
        """Where each of our agents that is connected can be reached just now."""
        ...

    def send(self, sender: str, address: str, headers: Headers, body: str, *, kept: bool) -> None:
        """Send a note. One that is `kept` waits while there is no connection; others are lost then."""
        ...

    def meet(self, address: str) -> None:
        """Let the agent at this address learn, if the platform can tell it, when we are unreachable."""
        ...

    def close(self) -> None:
        """Disconnect: our agents receive nothing after this."""
        ...
