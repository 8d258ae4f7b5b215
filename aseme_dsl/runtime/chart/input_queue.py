"""Intake: what has come in for an agent and waits for its next step, in order; bounded when it is too much.

All that waits is taken together, into one snapshot. So of several states of one sender on one channel only
the newest can be seen, and of signals that do not queue as well. As long as little waits, everything is taken
all the same, and is in the trace. When more waits than `CROWD`, a newer message takes the place of the one of
the same sender and channel that waits. An event or the value of a variable takes the place of the one that
the same activity has raised or written. So however fast messages come, the queue holds at most `CROWD` of
them, plus one of each sender and channel. All are taken together. Of data this leaves out samples. Of signals
that queue, so many wait besides as the run permits; what comes then is left out, and reported. Agent messages
are bounded where they are delivered, and what activities say of themselves by their number.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.inputs import Happened, Identity, Input, Sample, Written, made_often

CROWD = 1000
"""When so many inputs wait, of those that replace one another only the newest are kept."""

Errand = Callable[[], None]
_Key = tuple[object, str, object]
"""What a newer input replaces: what is said, about what, and by whom."""


class Writer(Protocol):
    """The start of an activity that an input comes from."""

    dropped: int
    """How many of its inputs did not count."""

    @property
    def cancelled(self) -> bool: ...


@made_often
class Posted:
    """An input for a step, with its identity.

    What an activity wrote is dropped if the `execution` was cancelled meanwhile, an agent message if the
    branch is not in its `conversation` any more.
    """

    identity: Identity
    input: Input
    execution: Writer | None = None
    conversation: str | None = None


class Intake:
    """What waits. `append` may be called from any thread, `take` by who steps the agent."""

    __slots__ = (
        "_bounded",
        "_items",
        "_lock",
        "_newest",
        "_queue",
        "_signals",
        "left_out",
        "most",
        "queued",
        "refused",
    )

    def __init__(self, queued: frozenset[str], bounded: bool, queue: int = QUEUE) -> None:
        """`queued` are the channels whose signals queue; in virtual time nothing is `bounded`."""
        self._items: deque[Posted | Errand] = deque()
        self._newest: dict[_Key, Posted] = {}
        self._queue = queue
        self._signals = 0
        """How many signals that queue have come since much waits."""
        self.refused: dict[str, int] = {}
        """How many of those were left out, by channel, since it was last emptied."""
        self.queued = queued
        self._bounded = bounded
        self._lock = threading.Lock()
        self.left_out = 0
        """How many messages newer ones have replaced, since it was last set to 0."""
        self.most = 0
        """The most that were taken together, since it was last set to 0."""

    def append(self, item: Posted | Errand) -> None:
        """Have something wait."""
        if self._bounded and (self._newest or len(self._items) >= CROWD) and self._crowded(item):
            return
        self._items.append(item)

    def put_back(self, items: Sequence[Posted | Errand]) -> None:
        """Have what was taken wait again, before all that has come meanwhile."""
        self._items.extendleft(reversed(items))

    def _crowded(self, item: Posted | Errand) -> bool:
        """Put an input in the place of the one that it replaces, if it is of that sort, or leave it out."""
        if not isinstance(item, Posted):
            return False
        key: _Key
        match item.input:
            case Sample(channel) if channel in self.queued:
                return self._is_too_much(channel)
            case Sample(channel, sender=sender, written_by=region):
                key = channel, sender, region
            case Happened(name) | Written(name):
                key = type(item.input), name, item.execution
            case _:
                return False
        with self._lock:
            if self._newest.pop(key, None) is not None:
                self.left_out += 1
            self._newest[key] = item  # the newest of all is the last one
        return True

    def _is_too_much(self, channel: str) -> bool:
        """Whether a signal that queues is left out: so many wait already."""
        with self._lock:
            if self._signals >= self._queue:
                self.refused[channel] = self.refused.get(channel, 0) + 1
                return True
            self._signals += 1
            return False

    def take(self) -> list[Posted | Errand]:
        """Everything that waits."""
        items = self._items
        taken = [items.popleft() for _ in range(len(items))]
        self._signals = 0
        if self._newest:
            with self._lock:
                taken += self._newest.values()
                self._newest.clear()
            self.most = max(self.most, len(taken))
        return taken

    def arrived(self) -> list[Sample]:
        """The messages that wait."""
        with self._lock:
            waiting = [*self._items, *self._newest.values()]
        return [item.input for item in waiting if isinstance(item, Posted) and isinstance(item.input, Sample)]

    def __bool__(self) -> bool:
        return bool(self._items or self._newest)

    def __len__(self) -> int:
        return len(self._items) + len(self._newest)
