"""Delivery: what the parts of the reliable delivery share."""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING

from aseme_dsl.runtime.message.by_name import made
from aseme_dsl.runtime.transport.delivery.archive import Archive
from aseme_dsl.runtime.transport.delivery.codec import Codec
from aseme_dsl.runtime.transport.delivery.records import Losses, Other, Way
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.heartbeats.heartbeats import Heartbeats
from aseme_dsl.runtime.transport.link import Link
from aseme_dsl.runtime.transport.port import Connected

if TYPE_CHECKING:
    from aseme_dsl.runtime.ports import Receiver

SOON = 33_000_000
"""An acknowledgement is put off by at least so many ns, or not at all: the upkeep puts it off, too."""


class Delivery:
    """The agents here and elsewhere, the streams between them, and the lock that guards all of it."""

    def __init__(self, link: Link, codec: Codec, incarnation: int, clock: int) -> None:
        self.link = link
        self.codec = codec
        self.incarnation = incarnation
        self.clock = clock
        self.contracts = {codec.number: codec.contract}
        """Those of all builds under which our agents have sent, by their numbers."""
        self.delay = max(0, link.patience // 3 - SOON)
        """How long an acknowledgement waits for others, in ns."""
        self.lease = link.lease
        self.archive = Archive()
        self.team: Connected
        self.here: Mapping[str, Receiver] = {}
        self.others: dict[str, Other] = {}
        self.ways: dict[tuple[str, str], Way] = {}
        self.origin = 0
        self.lock = threading.RLock()
        self.rest = threading.Condition(self.lock)
        self.resting = False
        self.closing = False
        self.gate = threading.Event()
        """Set when what comes may be handed on."""
        self.strangers: dict[str, int] = {}
        """When each of them was answered last, in ns."""
        self.strange = 0
        """How much has come from untrusted senders, and from senders without a name."""
        self.heartbeats: Heartbeats | None = None
        """None: the link has no addresses for them, and PINGs have to do."""
        self.losses: dict[tuple[str, str, str, str], Losses] = {}
        """What was lost, by sender, receiver, channel and reason."""
        self.refused = 0
        """How many refused heartbeats have been told."""
        self.watched_at = 0
        """When it was looked last for agents that have become unreachable, in ns."""
        self.watching = threading.Event()
        """Set when there is something to look at before it is time."""
        self.twins: set[int] = set()
        """Newer incarnations of our own agents of which something says that they are there."""
        self.past_twins: dict[int, int] = {}
        """Those that are there no more, and since when, in ns."""

    @property
    def mine(self) -> str:
        """One of our agents: the trace names it in records that concern the whole process."""
        return next(iter(self.here))

    def now(self) -> int:
        """The time of our run."""
        return self.team.driver.clock.now()

    def envelope(self, kind: int, sequence: int = 0, moment: int = 0, **members: object) -> Envelope:
        """An envelope of this incarnation of ours, of now or of a moment of the machine's clock."""
        return made(
            Envelope,
            kind,
            self.codec.number,
            self.incarnation,
            sequence=sequence,
            time=moment or time.monotonic_ns(),
            clock=self.clock,
            **members,
        )

    def stir(self) -> None:
        """There is something to look after. Called with the lock."""
        if self.resting:
            self.resting = False
            self.rest.notify()
