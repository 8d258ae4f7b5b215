"""Streams: messages from one agent to another arrive exactly once and in order, even if the link breaks.

Every message has a place in the stream from one incarnation of its sender to one incarnation of its receiver.
The receiver hands messages on in order and drops duplicates. Its acknowledgements say up to which place all
have come, and which are missing after that. The sender keeps a message until it is acknowledged, and repeats
it if it is missing or overdue. It limits what is on its way at once, so a receiver that does not read delays
no other one. A newer state replaces an older one that still waits.

This file is only the bookkeeping: no clock, no link, no lock.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable, Iterable, Iterator
from typing import Generic, TypeVar

from aseme_dsl.records import dataclass

T = TypeVar("T")

WINDOW = 256
"""How many messages may be on their way at once."""
WINDOW_BYTES = 128 * 1024
"""How many bytes may be on their way at once, if it is more than one message."""
WAITING = 20_000
"""How many messages may wait; then the oldest is given up."""
PATIENCE = 100_000_000
"""After how many ns without an acknowledgement a message is sent again."""
AGAIN = 15_000_000
"""What is missing is not sent again within so many ns: several acknowledgements may miss the same message."""
LONGEST = 5 * PATIENCE
"""At most so many ns lie between two attempts; with another patience, in proportion."""
EARLY = 4 * WINDOW
"""How far ahead of what is due a message may be."""
EARLY_BYTES = 4 * WINDOW_BYTES
"""So many bytes are kept of what is ahead, if it is more than one message; the rest is asked for again."""
RECENT = 1024
"""So many samples back it is remembered which have come."""


@dataclass(frozen=True, slots=True)
class Letter(Generic[T]):
    """Something to be sent, and how many bytes it is; one of the same `replaces` takes its place."""

    item: T
    size: int
    replaces: Hashable = None


class Outgoing(Generic[T]):
    """The sender's end."""

    __slots__ = (
        "_flying",
        "_last",
        "_newest",
        "_next",
        "_patience",
        "_put",
        "_sent",
        "_shortest",
        "_size",
        "_waiting",
    )

    def __init__(self, patience: int = PATIENCE) -> None:
        """`patience`: after how many ns without an acknowledgement a message is sent again, at first."""
        self._shortest = patience
        self._waiting: OrderedDict[int, Letter[T]] = OrderedDict()
        """What waits, by numbers that grow."""
        self._newest: dict[Hashable, int] = {}
        """The number of what waits and may be replaced."""
        self._put = 0
        self._flying: dict[int, Letter[T]] = {}
        self._sent: dict[int, int] = {}
        """When each of them was sent last."""
        self._size = 0
        self._next = 1
        self._last = 0
        self._patience = patience

    def __len__(self) -> int:
        return len(self._waiting) + len(self._flying)

    @property
    def flying(self) -> int:
        """How many messages are on their way."""
        return len(self._flying)

    def put(self, letter: Letter[T]) -> list[Letter[T]]:
        """Add a message; those that are given up for it, replaced or because too many wait."""
        gone: list[Letter[T]] = []
        if letter.replaces is not None and letter.replaces in self._newest:
            gone.append(self._waiting.pop(self._newest.pop(letter.replaces)))
        if len(self._waiting) >= WAITING:
            gone.append(self._first())
        self._put += 1
        self._waiting[self._put] = letter
        if letter.replaces is not None:
            self._newest[letter.replaces] = self._put
        return gone

    def _first(self) -> Letter[T]:
        """Take out what has waited longest."""
        _, letter = self._waiting.popitem(last=False)
        if letter.replaces is not None:
            del self._newest[letter.replaces]
        return letter

    def ready(self, now: int) -> Iterator[tuple[int, Letter[T]]]:
        """What may be sent now, with its places; it counts as sent."""
        waiting, flying = self._waiting, self._flying
        while waiting and len(flying) < WINDOW:
            if flying and self._size + next(iter(waiting.values())).size > WINDOW_BYTES:
                return
            letter = self._first()
            place, self._next = self._next, self._next + 1
            if not flying:
                self._last = now
            flying[place] = letter
            self._sent[place] = now
            self._size += letter.size
            yield place, letter

    def acknowledge(self, upto: int, missing: Iterable[int], now: int) -> list[tuple[int, Letter[T]]]:
        """The receiver has all up to a place, and then not the missing; what to send again at once."""
        flying = self._flying
        has_arrived = False
        while flying and (place := self._next - len(flying)) <= upto:  # they are in order, without gaps
            self._size -= flying.pop(place).size
            del self._sent[place]
            has_arrived = True
        if has_arrived:
            self._last, self._patience = now, self._shortest
        again: list[tuple[int, Letter[T]]] = []
        for place in missing:
            if place in flying and now - self._sent[place] >= AGAIN:
                self._sent[place] = now
                again.append((place, flying[place]))
        return again

    def overdue(self, now: int) -> list[tuple[int, Letter[T]]]:
        """What has been on its way for too long: it is to be sent again."""
        if not self._flying or now - self._last < self._patience:
            return []
        self._last, self._patience = now, min(2 * self._patience, LONGEST // PATIENCE * self._shortest)
        again = list(self._flying.items())[: WINDOW // 4]
        self._sent.update((place, now) for place, _ in again)
        return again

    def hurry(self) -> None:
        """What is on its way is overdue: the link was broken."""
        self._last, self._patience = -LONGEST // PATIENCE * self._shortest, self._shortest

    def restart(self) -> tuple[list[Letter[T]], list[Letter[T]]]:
        """The receiver begins a new incarnation: what was sent to the old one, what waits for the new."""
        flying, waiting = list(self._flying.values()), list(self._waiting.values())
        self._flying.clear()
        self._sent.clear()
        self._waiting.clear()
        self._newest.clear()
        self._size, self._next, self._patience = 0, 1, self._shortest
        return flying, waiting


class Incoming(Generic[T]):
    """The receiver's end."""

    __slots__ = ("_bytes", "_early", "_upto")

    def __init__(self) -> None:
        self._upto = 0
        self._early: dict[int, tuple[T, int]] = {}
        """What is ahead, with its size."""
        self._bytes = 0

    @property
    def upto(self) -> int:
        """All up to this place have come."""
        return self._upto

    def take(self, place: int, item: T, size: int = 0) -> list[T] | None:
        """What can be handed on now; None: this one has come before, or is far too early.

        `size`: how many bytes it is.
        """
        if place <= self._upto or place in self._early or place > self._upto + EARLY:
            return None
        if place > self._upto + 1 and self._early and self._bytes + size > EARLY_BYTES:
            return None
        self._early[place] = item, size
        self._bytes += size
        found: list[T] = []
        while self._upto + 1 in self._early:
            self._upto += 1
            item, size = self._early.pop(self._upto)
            self._bytes -= size
            found.append(item)
        return found

    @property
    def has_gap(self) -> bool:
        """Whether something has come whose predecessor has not."""
        return bool(self._early)

    def missing(self) -> tuple[int, ...]:
        """The places that have not come although later ones have, the first few."""
        if not self._early:
            return ()
        last = max(self._early)
        gaps = (place for place in range(self._upto + 1, last) if place not in self._early)
        return tuple(place for place, _ in zip(gaps, range(WINDOW // 4), strict=False))


class Samples:
    """What has come of that which is sent once, or not at all, with numbers from 1."""

    __slots__ = ("_come", "_newest")

    def __init__(self) -> None:
        self._newest = 0
        self._come = 0
        """A bit for each of the last `RECENT`, the lowest for the newest: whether it has come."""

    def take(self, number: int) -> int | None:
        """How many before it have not come (-1: it is one of those itself); None: it has come before."""
        passed = number - self._newest
        if passed > 0:
            kept = self._come << passed if passed < RECENT else 0
            self._come = (kept | 1) & _RECENTLY
            self._newest = number
            return passed - 1
        if passed <= -RECENT or self._come >> -passed & 1:
            return None
        self._come |= 1 << -passed
        return -1


_RECENTLY = (1 << RECENT) - 1
