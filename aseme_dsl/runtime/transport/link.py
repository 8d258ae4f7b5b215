"""Link: what moves envelopes between processes. It may lose, double and reorder them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Protocol

from aseme_dsl.runtime.message.acl import FipaMessage
from aseme_dsl.runtime.transport.envelope import Envelope

NOBODY = "?"
"""Stands for a sender that is not said."""

Answer = tuple[Envelope, bytes]
"""A piece of the answer to a question, with its payload."""


class Stamp(NamedTuple):
    """What an envelope is marked with for its way: see the fields of these names in `envelope`."""

    addressee: int = 0
    place: int = 0
    sample: int = 0


class Hears(Protocol):
    """The receiving side of a link. Any thread may call it, but for each receiver only one at a time."""

    def arrived(self, to: str, sender: str, envelope: Envelope, payload: bytes) -> None:
        """Something has come for one of our agents."""
        ...

    def unreadable(self, to: str, sender: str, reason: str) -> None:
        """A message for one of our agents has no valid envelope, or one that does not fit it."""
        ...

    def outside(self, to: str, message: FipaMessage) -> None:
        """An external agent has sent a message to one of our agents."""
        ...

    def appeared(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is there now."""
        ...

    def vanished(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is not there any more."""
        ...

    def asked(self, to: str, what: str, question: bytes) -> Iterable[Answer]:
        """A question to one of our agents; the answers."""
        ...

    def returned(self, agent: str, to: str, name: str, reason: str) -> None:
        """What one of our agents sent to an external agent was not delivered; `name` is its `reply-with`."""
        ...

    def disconnected(self, agent: str, reason: str) -> None:
        """One of our agents has lost its connection, which is made again."""
        ...

    def connected(self, agent: str, reason: str) -> None:
        """It has a connection again; the reason says with what."""
        ...

    def fault(self, agent: str, reason: str) -> None:
        """Something could not be done for one of our agents; it continues."""
        ...


class Link(Protocol):
    """A connection to the processes in which the rest of the team runs."""

    @property
    def readable(self) -> bool:
        """Whether payloads are JSON, for others to read, rather than Protocol Buffers."""
        ...

    @property
    def patience(self) -> int:
        """After how many ns without an acknowledgement something is sent again.

        Acknowledgements take up to a third of that, so that one may do for many.
        """
        ...

    @property
    def largest(self) -> int | None:
        """So many bytes a payload may have; None: as many as it likes."""
        ...

    @property
    def lease(self) -> int | None:
        """An agent that answers nothing for so many ns is unreachable; None: the link itself asks.

        With a lease, what `appeared` says may be a copy of something old: it counts when that incarnation
        says something to this one of ours.
        """
        ...

    @property
    def datagrams(self) -> Sequence[tuple[str, int]]:
        """The addresses and UDP ports at which heartbeats can be received; none: there are none."""
        ...

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        """Connect and say that these agents are here. Raises TransportError if that cannot be."""
        ...

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        """Send something; `way` says what for people and access rules (`vision/state/Ball`, `mail`).

        What is `sure` is sent before other things. Waits a millisecond at most; what cannot be sent is lost.
        """
        ...

    def renew(self, name: str, again: bool = False) -> None:
        """Make the connection to an agent again: it brings nothing, although the agent is there.

        `again`: this did not help before.
        """
        ...

    def say(self, to: str, sender: str, message: FipaMessage) -> bool:
        """Send a message to the external agent at the address `to`; False if this link cannot reach it."""
        ...

    def ask(
        self, to: str, what: str, question: bytes, timeout: float, life: int | None = None
    ) -> list[Answer]:
        """Put a question and wait for the answers, `timeout` seconds at most.

        With a `life` only that of the asked agent may answer.
        """
        ...

    def close(self) -> None:
        """Disconnect: our agents receive nothing after this."""
        ...
