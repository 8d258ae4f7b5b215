"""Faults: what may go wrong between the agents of a simulated team, by a seed, so that it can be repeated.

The simulated links lose, double, delay and reorder what is sent and what acknowledges it; above them is the
same bookkeeping as above real ones (`transport.stream`), with its promises:

* signals, states and agent messages arrive once each and in order per sender; what is lost is sent again, and
  what comes after it waits for it;
* data is a sample, sent once: what is lost is lost, what is doubled counts once, and what comes late has its
  own time. The same holds for topics that go by radio.

The content of messages is not encoded, and agents do not learn that another one is lost. An agent that
crashes loses what it knew and what comes for it until it starts again; the trace records each such message
and sample.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import field
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.time.clock import MILLISECOND
from aseme_dsl.runtime.time.timers import Scheduler
from aseme_dsl.runtime.transport.stream import PATIENCE, Incoming, Letter, Outgoing, Samples

if TYPE_CHECKING:
    from aseme_dsl.runtime.trace.trace import Trace

_BEAT = 20 * MILLISECOND
"""How often acknowledgements are sent and what is overdue is looked for, as by the real transport."""


@dataclass(frozen=True, slots=True)
class Crash:
    """An agent stops dead at `at` (ns) and starts afresh after `down` ns."""

    agent: str
    at: int
    down: int


@dataclass(frozen=True, slots=True)
class Partition:
    """From `at` (ns), for `lasts` ns, nothing passes between these agents and the others."""

    agents: frozenset[str]
    at: int
    lasts: int


@dataclass(frozen=True, slots=True)
class Faults:
    """What goes wrong. `loss` and `duplication` are the probabilities of each transmission to be lost, and to
    be made twice; each takes a random time from `least_delay` to `delay` ns. With `reorder`, it may overtake
    an earlier one from the same agent to the same.
    """

    seed: int = 1
    loss: float = 0.0
    duplication: float = 0.0
    delay: int = 0
    crashes: tuple[Crash, ...] = ()
    partitions: tuple[Partition, ...] = ()
    least_delay: int = 0
    reorder: bool = True


@dataclass(frozen=True, slots=True)
class _Letter:
    kind: str
    what: str
    identity: Identity
    give: Callable[[], None]


@dataclass(slots=True)
class _Way:
    """From one agent to another."""

    sender: str
    receiver: str
    out: Outgoing[_Letter]
    into: Incoming[_Letter] = field(default_factory=Incoming)
    sample: int = 0
    """The number of the last sample that was sent."""
    samples: Samples = field(default_factory=Samples)
    owes: bool = False
    """Whether something has come since the last acknowledgement."""
    beats: bool = False
    """Whether a release is to come."""


class Links:
    """The links between the agents of a team in virtual time."""

    def __init__(self, faults: Faults, driver: Scheduler, trace: Trace) -> None:
        self.faults = faults
        self._driver = driver
        self._trace = trace
        self._chance = random.Random(f"links/{faults.seed}")
        self._ways: dict[tuple[str, str], _Way] = {}
        self._last: dict[tuple[str, str], int] = {}
        """When the last transmission from one agent to another arrives, where none overtakes another."""
        self._patience = max(PATIENCE, 2 * faults.delay + 2 * _BEAT)
        """For so long nothing is sent again: it may just be slow."""

    def carry(
        self, sender: str, receiver: str, kind: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        """Carry a message of a kind; `give` gives it to its receiver.

        The kind is signal, state, data, radio or agent message, `what` its channel or the conversation.
        """
        way = self._ways.get((sender, receiver))
        if way is None:
            way = self._ways[sender, receiver] = _Way(sender, receiver, Outgoing(self._patience))
        letter = _Letter(kind, what, identity, give)
        if kind in ("data", "radio"):
            self._send_sample(way, letter)
            return
        for lost in way.out.put(Letter(letter, 0, what if kind == "state" else None)):
            if lost.replaces is None:
                self._tell_lost(way, lost.item, "too many wait")
        self._pump(way)

    def _tell_lost(self, way: _Way, letter: _Letter, reason: str) -> None:
        self._trace.write(
            "lost",
            self._driver.clock.now(),
            agent=way.sender,
            input=list(letter.identity),
            peer=way.receiver,
            channel=letter.what if letter.kind != "mail" else None,
            conversation=letter.what if letter.kind == "mail" else None,
            reason=reason,
        )

    # ---- samples -----------------------------------------------------------------------------

    def _send_sample(self, way: _Way, letter: _Letter) -> None:
        number = way.sample = way.sample + 1

        def arrive() -> None:
            if way.samples.take(number) is not None:
                letter.give()

        if not self._transmit(way.sender, way.receiver, arrive):
            self._tell_lost(way, letter, "lost on the simulated link")

    # ---- the stream --------------------------------------------------------------------------

    def _pump(self, way: _Way) -> None:
        """Send what may be sent."""
        for place, letter in way.out.ready(self._driver.clock.now()):
            self._send(way, place, letter)
        self._go_on(way)

    def _send(self, way: _Way, place: int, letter: Letter[_Letter]) -> None:
        self._transmit(way.sender, way.receiver, lambda: self._arrive(way, place, letter.item))

    def _arrive(self, way: _Way, place: int, letter: _Letter) -> None:
        """A message has come to its receiver."""
        had_gap = way.into.has_gap
        for item in way.into.take(place, letter) or ():
            item.give()
        way.owes = True
        if way.into.has_gap and not had_gap:
            self._acknowledge(way)
        self._go_on(way)

    def _acknowledge(self, way: _Way) -> None:
        way.owes = False
        upto, missing = way.into.upto, way.into.missing()

        def arrive() -> None:
            for place, letter in way.out.acknowledge(upto, missing, self._driver.clock.now()):
                self._send(way, place, letter)
            self._pump(way)

        self._transmit(way.receiver, way.sender, arrive)

    def _go_on(self, way: _Way) -> None:
        """Look after the stream again, as long as there is something on its way."""
        if not way.beats and (way.owes or way.out.flying):
            way.beats = True
            self._driver.at(self._driver.clock.now() + _BEAT, lambda: self._beat(way))

    def _beat(self, way: _Way) -> None:
        way.beats = False
        if way.owes:
            self._acknowledge(way)
        for place, letter in way.out.overdue(self._driver.clock.now()):
            self._send(way, place, letter)
        self._pump(way)

    # ---- the link ----------------------------------------------------------------------------

    def _transmit(self, sender: str, receiver: str, arrive: Callable[[], None]) -> bool:
        """Try to bring something over; whether it will arrive, once or twice."""
        now, faults, chance = self._driver.clock.now(), self.faults, self._chance
        if self._is_cut(now, sender, receiver):
            return False
        came = False
        for _ in range(2 if chance.random() < faults.duplication else 1):
            if chance.random() >= faults.loss:
                came = True
                self._driver.at(self._due(now, sender, receiver), arrive)
        return came

    def _due(self, now: int, sender: str, receiver: str) -> int:
        """When a transmission arrives."""
        faults = self.faults
        due = now + (self._chance.randint(faults.least_delay, faults.delay) if faults.delay else 0)
        if not faults.reorder:
            due = self._last[sender, receiver] = max(due, self._last.get((sender, receiver), 0))
        return due

    def _is_cut(self, moment: int, one: str, other: str) -> bool:
        """Whether a partition is between two agents at a moment."""
        return any(
            cut.at <= moment < cut.at + cut.lasts and (one in cut.agents) != (other in cut.agents)
            for cut in self.faults.partitions
        )
