"""Archive: the states and the data of our agents that are kept for those who come later, or ask for them."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import field

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.transport.delivery.records import Kept

SAMPLES = 4096
"""How much data of each channel is kept for those who ask for it."""


@dataclass(slots=True)
class Archive:
    """Called with the lock of the delivery."""

    states: dict[tuple[str, str, str], Kept] = field(default_factory=dict)
    """The latest state of each sender and channel, for all or for one agent."""
    samples: dict[tuple[str, str], deque[Kept]] = field(default_factory=dict)
    """The data of each sender and channel."""
    retention: dict[str, int] = field(default_factory=dict)
    """How long the data of a channel is asked for, in ns."""

    def learn(self, plans: Iterable[Plan]) -> None:
        """Learn from all plans of the team how long data is asked for."""
        for plan in plans:
            for info in plan.channels:
                self.retention[info.name] = max(info.retention, self.retention.get(info.name, 0))

    def keep_sample(self, sender: str, channel: str, kept: Kept) -> None:
        """Keep data for those who ask for it."""
        samples = self.samples.setdefault((sender, channel), deque(maxlen=SAMPLES))
        samples.append(kept)

    def news_for(self, mine: str, name: str) -> Iterator[Kept]:
        """What agent `name` gets from our agent `mine` when it appears: retained data, then states."""
        now = time.monotonic_ns()
        for (sender, channel), samples in self.samples.items():
            oldest = now - self.retention.get(channel, 0)
            recent = [kept for kept in samples if kept.sent.envelope.time >= oldest] or list(samples)[-1:]
            yield from (kept for kept in recent if sender == mine and name in kept.to)
        yield from (
            kept for (sender, _, _), kept in self.states.items() if sender == mine and name in kept.to
        )
