"""Faults: what may go wrong between the agents of a simulated team, by a seed, so that it can be repeated.

What each kind of message promises over a bad link, here as over a real one:

* signals and agent messages arrive once each and in order per sender; what is lost on the link is sent again,
  so that it comes late;
* of a state the newest arrives in the end; one that comes after a newer one is dropped;
* data is a sample: what is lost is lost, and what comes late has its own time.

An agent that crashes loses what it knew and what comes for it until it starts again; each such message is
told in the trace, and so is each sample that is lost.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from aseme_dsl.runtime.clock import MILLISECOND
from aseme_dsl.runtime.inputs import Identity

if TYPE_CHECKING:
    from aseme_dsl.runtime.driver import Driver
    from aseme_dsl.runtime.trace import Trace


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
    """What goes wrong. `loss` is the chance of each transmission to be lost; one takes up to `delay` ns, by
    chance, which also puts messages out of order; a lost one is repeated after `repeat` ns.
    """

    seed: int = 1
    loss: float = 0.0
    delay: int = 0
    repeat: int = 50 * MILLISECOND
    crashes: tuple[Crash, ...] = ()
    partitions: tuple[Partition, ...] = ()


class Links:
    """The links between the agents of a team in virtual time."""

    def __init__(self, faults: Faults, driver: Driver, trace: Trace) -> None:
        self.faults = faults
        self._driver = driver
        self._trace = trace
        self._chance = random.Random(f"links/{faults.seed}")
        self._last: dict[tuple[str, str], int] = {}
        self._newest: dict[tuple[str, str, str], int] = {}
        self._sent = 0

    def carry(
        self, sender: str, receiver: str, kind: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        """Carry a message of a kind (signal, state, data, mail); `give` gives it to its receiver."""
        now = self._driver.clock.now()
        self._sent += 1
        if kind == "data":
            self._sample(now, sender, receiver, what, identity, give)
            return
        moment = self._arrival(now, sender, receiver)
        if kind == "state":
            number, key = self._sent, (sender, receiver, what)

            def newest() -> None:
                if self._newest.get(key, 0) < number:
                    self._newest[key] = number
                    give()

            self._driver.at(moment, newest)
            return
        # What overtakes on the link waits for what it has overtaken.
        moment = self._last[sender, receiver] = max(moment, self._last.get((sender, receiver), 0))
        self._driver.at(moment, give)

    def _sample(
        self, now: int, sender: str, receiver: str, what: str, identity: Identity, give: Callable[[], None]
    ) -> None:
        moment = now + self._takes()
        if self._chance.random() < self.faults.loss or self._is_cut(now, sender, receiver) is not None:
            text = f"a sample of {what} from {sender} is lost on the link"
            self._trace.fault(now, receiver, text, input=list(identity))
            return
        self._driver.at(moment, give)

    def _arrival(self, now: int, sender: str, receiver: str) -> int:
        """When a transmission has succeeded that is repeated until it does."""
        moment = now
        while True:
            end = self._is_cut(moment, sender, receiver)
            if end is not None:
                moment = end
            elif self._chance.random() < self.faults.loss:
                moment += self.faults.repeat
            else:
                return moment + self._takes()

    def _takes(self) -> int:
        return self._chance.randint(0, self.faults.delay) if self.faults.delay else 0

    def _is_cut(self, moment: int, one: str, other: str) -> int | None:
        """The end of the partition that is between two agents at a moment, if one is."""
        for cut in self.faults.partitions:
            if cut.at <= moment < cut.at + cut.lasts and (one in cut.agents) != (other in cut.agents):
                return cut.at + cut.lasts
        return None
