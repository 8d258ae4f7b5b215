"""A team's radio: short messages that come late, get lost, and must not be too many."""

from __future__ import annotations

import random
import threading
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, field
from heapq import heappop, heappush

from aseme_dsl.runtime.world.body import RadioMessage

MILLISECOND = 1_000_000


@dataclass(frozen=True, slots=True)
class RadioSettings:
    """How good a radio is. Raises ValueError for settings that mean nothing."""

    payload_limit: int = 10
    """bytes."""
    loss: float = 0.1
    """The probability that one team mate misses one message; each of them for itself."""
    shortest_delay_ns: int = 10 * MILLISECOND
    longest_delay_ns: int = 60 * MILLISECOND
    """The delay is drawn between these for every receiver: messages may overtake each other."""
    interval_ns: int = 100 * MILLISECOND
    """In the long run a robot may say one message in this time …"""
    burst: int = 5
    """… but this many at once, after it has been silent."""

    def __post_init__(self) -> None:
        if not 0.0 <= self.loss <= 1.0:
            raise ValueError(f"loss is a probability, not {self.loss}")
        if not 0 <= self.shortest_delay_ns <= self.longest_delay_ns:
            raise ValueError("the delays are not in order, or negative")
        if self.payload_limit < 1 or self.interval_ns < 0 or self.burst < 1:
            raise ValueError("payload_limit and burst are at least 1, interval_ns at least 0")


@dataclass(frozen=True, slots=True)
class RadioCount:
    """What a team's radio has done so far: messages said and refused, and receipts delivered and lost."""

    said: int
    refused: int
    delivered: int
    lost: int


@dataclass(slots=True)
class _Station:
    """One robot's end of the radio."""

    credit_ns: int
    counted_ns: int = 0
    inbox: deque[RadioMessage] = field(default_factory=deque)


class Radio:
    """The radio of one team.

    ``say`` and ``hear`` may be called from any thread. Nothing is drawn in them. :meth:`carry` sends the
    messages on their way, in the order of the team, so that the moment within a step does not matter.
    """

    def __init__(self, robots: Iterable[str], settings: RadioSettings) -> None:
        self.settings = settings
        self._stations = {name: _Station(settings.interval_ns * settings.burst) for name in robots}
        self._said: dict[str, list[bytes]] = {name: [] for name in self._stations}
        self._under_way: list[tuple[int, int, str, RadioMessage]] = []
        self._sent = 0
        self._counts = [0, 0, 0, 0]
        self._lock = threading.Lock()

    @property
    def count(self) -> RadioCount:
        """What the radio has done so far."""
        return RadioCount(*self._counts)

    def say(self, sender: str, payload: bytes, now_ns: int) -> bool:
        """Send a message to the others; False if the sender has said too much lately.

        Raises ValueError for a payload that is too long.
        """
        if len(payload) > self.settings.payload_limit:
            raise ValueError(
                f"{sender} wants to say {len(payload)} bytes; the radio takes {self.settings.payload_limit}"
            )
        with self._lock:
            station = self._stations[sender]
            most = self.settings.interval_ns * self.settings.burst
            station.credit_ns = min(most, station.credit_ns + now_ns - station.counted_ns)
            station.counted_ns = now_ns
            if station.credit_ns < self.settings.interval_ns:
                self._counts[1] += 1
                return False
            station.credit_ns -= self.settings.interval_ns
            self._counts[0] += 1
            self._said[sender].append(bytes(payload))
            return True

    def hear(self, name: str) -> list[RadioMessage]:
        """What has arrived for a robot since the last call, oldest first."""
        inbox = self._stations[name].inbox
        arrived: list[RadioMessage] = []
        while True:
            try:
                arrived.append(inbox.popleft())
            except IndexError:
                return arrived

    def carry(self, now_ns: int, step_ns: int, chance: random.Random) -> None:
        """Send what was said in the step that ends at ``now_ns``, and deliver what is due by then."""
        if any(self._said.values()):
            with self._lock:
                said, self._said = self._said, {name: [] for name in self._stations}
            for sender, payloads in said.items():
                for payload in payloads:
                    self._send(RadioMessage(sender, payload), now_ns - step_ns, chance)
        while self._under_way and self._under_way[0][0] <= now_ns:
            _, _, receiver, heard = heappop(self._under_way)
            self._stations[receiver].inbox.append(heard)
            self._counts[2] += 1

    def _send(self, heard: RadioMessage, said_ns: int, chance: random.Random) -> None:
        settings = self.settings
        for receiver in self._stations:
            if receiver == heard.sender:
                continue
            if chance.random() < settings.loss:
                self._counts[3] += 1
                continue
            span = settings.longest_delay_ns - settings.shortest_delay_ns
            delay = settings.shortest_delay_ns + int(chance.random() * span)
            self._sent += 1
            heappush(self._under_way, (said_ns + delay, self._sent, receiver, heard))
