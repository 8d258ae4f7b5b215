"""Records: what is on its way to an agent elsewhere, and what is known of it."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import field

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.message.contract import Contract, Reading
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.stream import Incoming, Outgoing, Samples

QUESTIONS = 8
"""Of so many measurements of another clock the quickest counts."""


@dataclass(frozen=True, slots=True)
class Sent:
    """What a message is about: enough to send it, and to record it if it is lost."""

    way: str
    envelope: Envelope
    payload: bytes
    sender: str
    what: str
    """signal, state, data or agent message."""

    @property
    def identity(self) -> Identity:
        return self.sender, self.envelope.sequence


Got = tuple[Envelope, bytes]
"""What has come, with its payload."""


@dataclass(slots=True)
class Way:
    """Between one of our agents and one elsewhere."""

    out: Outgoing[Sent] = field(default_factory=Outgoing)
    into: Incoming[Got] = field(default_factory=Incoming)
    owed: int = 0
    """How many messages have come since the last acknowledgement."""
    owed_since: int = 0
    """When the first of them came, in ns."""
    sample: int = 0
    """The number of the last sample that was sent."""
    samples: Samples = field(default_factory=Samples)
    """Those that came."""
    pinged: int = 0
    """The time of the newest PING that came, in the sender's clock."""
    asked: deque[int] = field(default_factory=lambda: deque(maxlen=16))
    """The times of our PINGs that have no answer yet."""


@dataclass(slots=True)
class Unread:
    """Messages of a channel that we did not read, and of which we notify their sender."""

    mine: str
    """The agent that they were for."""
    reason: str
    number: int = 0
    """How many of them their sender has not been told of."""
    told_at: int = 0
    """When it was told last, in ns."""


@dataclass(slots=True)
class Other:
    """An agent elsewhere: which incarnation it is, and what came from it."""

    name: str
    alive: bool = False
    life: int | None = None
    present: set[int] = field(default_factory=set)
    """The incarnations that say that they are there; there may be two for a while."""
    ended: set[int] = field(default_factory=set)
    """The incarnations that were unreachable: with a lease, only an answer brings one back."""
    heard_at: int = 0
    """The latest moment of our clock, in ns, at which it heard us, as an answer of it proves."""
    beats: bool = False
    """Whether heartbeats of this incarnation have come."""
    linked_at: int = 0
    """When something came over the link from it, or the link to it was renewed, in ns."""
    renewed_at: int = 0
    """When the link to it was renewed, in ns; 0: never."""
    doubted_at: int = 0
    """When the link said that it is not there any more, in ns; 0: it is not doubted."""
    parted: bool = False
    """Whether this incarnation has said farewell."""
    gone_at: float = -math.inf
    """When it was told last that it is not there any more, in seconds."""
    clock: int | None = None
    measured: deque[tuple[int, int]] = field(default_factory=lambda: deque(maxlen=QUESTIONS))
    """(round trip, difference) of the last measurements of its clock."""
    is_timed: bool = False
    """Whether the trace has the difference of its clock."""
    ask_at: int = 0
    knows_us: bool = True
    """Whether its build has our agents, as far as it has not said that it does not."""
    contracts: dict[int, Contract] = field(default_factory=dict)
    """Its contracts of late by their numbers, the newest last."""
    readings: dict[tuple[int, int], Reading] = field(default_factory=dict)
    """How we read it, by the numbers of our contract and of its."""
    model: str = ""
    """The hash of the models that it follows, as far as it has said that."""
    said: str = ""
    """What was told last of the difference between its build and ours."""
    compare_at: int = 0
    """When that is compared again, in ns; 0: it is not."""
    incompatible: tuple[str, ...] = ()
    """What does not work between its build and ours."""
    unread: dict[str, Unread] = field(default_factory=dict)
    """What of it was not read, by channel."""
    counts: dict[str, int] = field(default_factory=dict)
    told: set[tuple[str, str]] = field(default_factory=set)


@dataclass(slots=True)
class Losses:
    """The signals of a channel that were lost for one reason since it was told last."""

    latest: Sent
    told: int
    """When that was, in ns."""
    number: int = 0


@dataclass(frozen=True, slots=True)
class Kept:
    """A state or a sample that is kept for those who come later."""

    sent: Sent
    to: tuple[str, ...]
    replaces: tuple[str, ...] | None
