"""Link: what moves envelopes between processes. It may lose, double and reorder them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol


class Hears(Protocol):
    """Who is told what a link brings. May be called from any thread, for one receiver from one at a time."""

    def arrived(self, to: str, sender: str, envelope: bytes, payload: bytes) -> None:
        """Something has come for one of our agents."""
        ...

    def appeared(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is there now."""
        ...

    def vanished(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is not there any more."""
        ...

    def asked(self, to: str, what: str, question: bytes) -> Iterable[tuple[bytes, bytes]]:
        """A question to one of our agents; the answers, as envelopes and payloads."""
        ...


class Link(Protocol):
    """A connection to the processes in which the rest of the team runs."""

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        """Connect and say that these agents are here. Raises TransportError if that cannot be."""
        ...

    def send(self, to: str, sender: str, way: str, envelope: bytes, payload: bytes, sure: bool) -> None:
        """Send something; `way` says what for people and access rules (`vision/state/Ball`, `mail`).

        What is `sure` is sent before other things. Waits a millisecond at most; what cannot be sent is lost.
        """
        ...

    def ask(self, to: str, what: str, question: bytes, timeout: float) -> list[tuple[bytes, bytes]]:
        """Put a question and wait for the answers, `timeout` seconds at most."""
        ...

    def close(self) -> None:
        """Disconnect: nobody hears anything after this."""
        ...
