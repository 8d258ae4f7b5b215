"""Platform: what carries notes, headers with a text, between agents that have addresses. It may lose them.

Agents of a team and others, of anybody, have their addresses on the same platform. `over_platform` makes a
link of one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

Headers = Mapping[str, str]
"""What is said of a text: FIPA's parameters of agent messages under their names there, and further ones."""


class Refused(Exception):
    """A connection that was not made, and that no further attempt would make; the text says why."""


class Receives(Protocol):
    """Who is told what a platform brings. May be called from any thread, for one agent from one at a time."""

    def came(self, to: str, origin: str, headers: Headers, body: str) -> None:
        """A note for one of our agents, from whoever has the address `origin`. Raises nothing."""
        ...

    def unreachable(self, address: str) -> None:
        """Whoever had this address is not there any more."""
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
        """Whether somebody may be at an address that is written so."""
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
        """Disconnect: nobody receives anything after this."""
        ...
