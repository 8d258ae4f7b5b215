"""Blackboards: what one region of a chart knows (P1, section 4.4): states, signals, data, timers, drafts."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, TypeAlias

from aseme_dsl.runtime.chart import history
from aseme_dsl.runtime.chart.history import History
from aseme_dsl.runtime.chart.inputs import Identity, Sample

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

NEVER = sys.maxsize
"""A moment that does not come."""


QUEUE = 10_000
"""So many signals of a queued channel wait in a region at the most, if nothing else is said."""


Messages: TypeAlias = tuple[
    tuple[tuple[str, tuple[tuple[str, Sample], ...]], ...],
    tuple[tuple[str, tuple[Sample, ...], tuple[Sample, ...]], ...],
    tuple[tuple[str, tuple[Sample, ...]], ...],
]
"""The messages on a board: states by sender, data (before the window, and in it) and signals, by channel."""

SavedDrafts: TypeAlias = tuple[tuple[tuple[str, str | None], tuple[tuple[tuple[str, ...], object], ...]], ...]


class Known:
    """The messages on a board, as a value.

    Nothing in it is ever changed: the board has it in common with what is saved, and makes copies before it
    changes.
    """

    __slots__ = ("_messages", "data", "shown", "signals", "states")

    def __init__(
        self,
        states: dict[str, dict[str, Sample]],
        data: dict[str, History],
        signals: dict[str, list[Sample]],
        shown: tuple[object, ...] | None = None,
    ) -> None:
        """`shown` are the values of the slots of the board, where they are known."""
        self.states = states
        self.data = data
        self.signals = signals
        self.shown = shown
        self._messages: Messages | None = None

    @classmethod
    def of(cls, messages: Messages) -> Known:
        """Those that `messages` gives."""
        states, data, signals = messages
        return cls(
            {channel: dict(senders) for channel, senders in states},
            {channel: History(window, before) for channel, before, window in data},
            {channel: list(items) for channel, items in signals},
        )

    def messages(self) -> Messages:
        """The messages in tuples; the order is that of the names where none matters."""
        if self._messages is None:
            states = [(channel, tuple(items.items())) for channel, items in sorted(self.states.items())]
            data = [(channel, *history.save()) for channel, history in sorted(self.data.items())]
            signals = [(channel, tuple(items)) for channel, items in sorted(self.signals.items()) if items]
            self._messages = tuple(states), tuple(data), tuple(signals)
        return self._messages

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Known) and self.messages() == other.messages())

    def __hash__(self) -> int:
        return hash(self.messages())


Whole: TypeAlias = tuple[Known, frozenset[Identity], tuple[tuple[str, int], ...], SavedDrafts]
"""All that a board holds between two steps: messages, those read ahead, timers, drafts."""

SavedBoard: TypeAlias = Known | Whole
"""The same; just the messages where there is nothing else, as at most times."""

_NOBODY: frozenset[Identity] = frozenset()


def whole(saved: SavedBoard) -> Whole:
    """What a board holds, with what is not there."""
    return (saved, _NOBODY, (), ()) if isinstance(saved, Known) else saved


def saved_board(held: Whole) -> SavedBoard:
    """What a board holds, as it is saved."""
    return held if any(held[1:]) else held[0]


_EMPTY = Known({}, {}, {}, ())
"""What a board has that has no channels."""


class Board:
    """The blackboard of a region.

    Generated subclasses have a typed slot for each message that the region's expressions read; it holds
    the message that an expression sees now, or None. `SLOTS` gives the slots of a channel as
    (slot, sender or None), `TIMED` the slots that have a companion `…_time` with the time of measurement.
    """

    __slots__ = (
        "_data",
        "_known",
        "_seen",
        "_signals",
        "_states",
        "ahead",
        "asked",
        "drafts",
        "timers",
    )

    CHANNELS: ClassVar[frozenset[str]] = frozenset()
    QUEUED: ClassVar[frozenset[str]] = frozenset()
    EXPIRES: ClassVar[Mapping[str, int]] = {}
    """The age in ns at which the untaken signals of a channel are dropped."""
    RETENTION: ClassVar[Mapping[str, int]] = {}
    SLOTS: ClassVar[Mapping[str, tuple[tuple[str, str | None], ...]]] = {}
    TIMED: ClassVar[frozenset[str]] = frozenset()

    def __init__(self) -> None:
        self._states: dict[str, dict[str, Sample]] = {} if self.CHANNELS else _EMPTY.states
        self._data: dict[str, History] = {} if self.CHANNELS else _EMPTY.data
        self._signals: dict[str, list[Sample]] = {} if self.CHANNELS else _EMPTY.signals
        self._known: Known | None = None if self.CHANNELS else _EMPTY
        """The messages as a value that is saved; None since they have changed."""
        self._seen: dict[tuple[str, str | None], Sample] = {}
        self.ahead: set[Identity] = set()
        """What `read_messages` has put here before it comes as an input."""
        self.asked: list[Sample] = []
        self.timers: dict[str, int] = {}
        self.drafts: dict[tuple[str, str | None], dict[tuple[str, ...], object]] = {}
        for slots in self.SLOTS.values():
            for slot, _ in slots:
                setattr(self, slot, None)
                if slot in self.TIMED:
                    setattr(self, slot + "_time", 0)

    def inherit(self, outer: Board) -> None:
        """Start with the states and histories of the surrounding region, without signals and timers."""
        if self._known is not None and self.CHANNELS:
            self.part()
        for channel in self.CHANNELS:
            if channel in outer._states:
                self._states[channel] = dict(outer._states[channel])
            elif channel in outer._data:
                self._data[channel] = outer._data[channel].copy()
            else:
                continue
            self._refresh(channel)

    # ---- writing ---------------------------------------------------------------------------

    def put(self, item: Sample, now: int) -> None:
        """Take in a message of one of the board's channels."""
        channel = item.channel
        if self._known is not None:
            self.part()
        comm = channel.split(".", 2)[1]
        if comm == "state":
            senders = self._states.setdefault(channel, {})
            senders.pop(item.sender, None)  # the newest sender is the last one
            senders[item.sender] = item
        elif comm == "signal":
            waiting = self._signals.setdefault(channel, [])
            if channel not in self.QUEUED:
                for index, other in enumerate(waiting):
                    if other.sender == item.sender:
                        waiting[index] = item
                        break
                else:
                    waiting.append(item)
            else:
                waiting.append(item)
        else:
            if channel not in self._data:
                self._data[channel] = History()
            self._data[channel].add(item, now - self.RETENTION.get(channel, 0))
        self._refresh(channel)

    def _refresh(self, channel: str) -> None:
        for slot, host in self.SLOTS.get(channel, ()):
            item = self.newest(channel, host)
            setattr(self, slot, None if item is None else item.message)
            if slot in self.TIMED:
                setattr(self, slot + "_time", 0 if item is None else item.time)

    # ---- reading ---------------------------------------------------------------------------

    def newest(self, channel: str, host: str | None = None) -> Sample | None:
        """What an expression sees: a state's latest, a signal's oldest waiting, the newest data."""
        if channel in self._signals:
            return next((i for i in self._signals[channel] if host in (None, i.sender)), None)
        if channel in self._states:
            senders = self._states[channel]
            if host is not None:
                return senders.get(host)
            return next(reversed(senders.values()), None)
        data = self._data.get(channel)
        return None if data is None else data.newest(host)

    def history(self, channel: str, host: str | None = None) -> tuple[Sample, ...]:
        """The data messages that are kept, oldest first."""
        data = self._data.get(channel)
        return () if data is None else data.of(host)

    def at(self, channel: str, host: str | None, moment: int) -> object:
        """The message as it was at `moment`: the newest measured by then, or None."""
        items = self._data.get(channel, ()) if host is None else self.history(channel, host)
        found = history.at(items, moment)
        return None if found is None else found.message

    def mean(self, channel: str, host: str | None, since: int, member: str) -> float | None:
        """The mean of a member (`pose.x`) over what was measured since then, or None.

        A message in which the member is absent does not count.
        """
        return history.mean(self.history(channel, host), since, member)

    def expired(self, timer: str, now: int) -> bool:
        """Whether a timer was started and has run out."""
        return self.timers.get(timer, NEVER) <= now

    def waits(self, channel: str) -> int:
        """How many signals of a channel wait."""
        return len(self._signals.get(channel, ()))

    def waiting(self) -> int:
        """How many signals wait, of all channels."""
        return sum(map(len, self._signals.values()))

    # ---- signals ---------------------------------------------------------------------------

    def ask(self, channel: str, host: str | None = None) -> None:
        """Note that a condition or action has looked at a signal."""
        item = self.newest(channel, host)
        if item is None:
            self._seen.pop((channel, host), None)
        else:
            self._seen[channel, host] = item
            self.asked.append(item)

    def spend(self, channel: str, host: str | None, *around: Board) -> None:
        """Consume the signal that was looked at last, here and on the boards of the regions around."""
        item = self._seen.pop((channel, host), None)
        if item is None:
            return
        self._drop(item)
        for board in around:
            if not board._drop(item) and item.identity in self.ahead:
                board.ahead.add(item.identity)

    def take(self, channel: str, host: str | None = None) -> Sample | None:
        """Read a signal as an activity does: it is consumed."""
        item = self.newest(channel, host)
        if item is not None and channel in self._signals:
            self._drop(item)
        return item

    def consume(self, identity: Identity) -> bool:
        """Consume the signal with this identity, as an activity has done; whether it waits."""
        return any(
            self._drop(item)
            for waiting in self._signals.values()
            for item in waiting
            if item.identity == identity
        )

    def _drop(self, item: Sample) -> bool:
        for index, other in enumerate(self._signals.get(item.channel, ())):
            if other is item:
                if self._known is not None:
                    self.part()
                del self._signals[item.channel][index]
                self._refresh(item.channel)
                return True
        return False

    def expire(self, now: int) -> list[Sample]:
        """Drop the signals that are too old; the result is these."""
        return self.drop_older(now, self.EXPIRES)

    def drop_older(self, now: int, ages: Mapping[str, int]) -> list[Sample]:
        """Drop the signals of these channels that have these ages; the result is these."""
        dropped: list[Sample] = []
        for channel, longest in ages.items():
            waiting = self._signals.get(channel)
            if waiting and any(now - item.time >= longest for item in waiting):
                if self._known is not None:
                    self.part()
                dropped += [item for item in waiting if now - item.time >= longest]
                self._signals[channel] = [item for item in waiting if now - item.time < longest]
                self._refresh(channel)
        return dropped

    def end_step(self) -> tuple[str, ...]:
        """Drop the signals that were looked at; the channels of those that were still there."""
        dropped = tuple(item.channel for item in self.asked if self._drop(item))
        self.asked.clear()
        self._seen.clear()
        return dropped

    def part(self) -> None:
        """Have messages of its own, which what was saved does not share."""
        self._known = None
        self._states = {channel: senders.copy() for channel, senders in self._states.items()}
        self._data = {channel: data.copy() for channel, data in self._data.items()}
        self._signals = {channel: waiting.copy() for channel, waiting in self._signals.items()}

    # ---- saving: what generated classes do with their slots ----------------------------------

    def shown(self) -> tuple[object, ...]:
        """What the slots hold."""
        return ()

    def show(self, values: tuple[object, ...]) -> None:
        """Give the slots what they have held."""

    # ---- drafts ----------------------------------------------------------------------------

    def fill(self, channel: str, host: str | None, path: tuple[str, ...], value: object) -> None:
        """Set a member of the message that the next publication of the channel sends; without a path all."""
        members = self.drafts.setdefault((channel, host), {})
        if not path:
            members.clear()
        members[path] = value

    def take_drafts(self, channel: str, kind: type[DataclassInstance]) -> list[tuple[str | None, object]]:
        """The drafts of a channel as (receiver, message); one of defaults for all where there is none."""
        hosts = [host for other, host in self.drafts if other == channel]
        if not hosts:
            return [(None, kind())]
        return [(host, built(kind, self.drafts.pop((channel, host)), {})) for host in hosts]


def save_all(boards: Iterable[Board | None]) -> tuple[SavedBoard | None, ...]:
    """All that each of these holds, between two steps; None for one that is not there."""
    found: list[SavedBoard | None] = []
    for board in boards:  # in a loop: a call for each board would take half as long again
        if board is None:
            found.append(None)
            continue
        known = board._known
        if known is None:
            known = board._known = Known(board._states, board._data, board._signals, board.shown())
        if board.timers or board.ahead or board.drafts:
            drafts = tuple((key, tuple(members.items())) for key, members in board.drafts.items())
            found.append((known, frozenset(board.ahead), tuple(sorted(board.timers.items())), drafts))
        else:
            found.append(known)
    return tuple(found)


def load_all(boards: Iterable[Board], saved: Iterable[SavedBoard | None]) -> None:
    """Have each of these hold what was saved, and nothing else; None leaves a board as it is."""
    for board, held in zip(boards, saved, strict=True):
        if held is None:
            continue
        if type(held) is Known:
            known = held
            if board.timers or board.ahead or board.drafts:
                board.timers, board.ahead, board.drafts = {}, set(), {}
        else:
            known, ahead, timers, drafts = whole(held)
            board.timers, board.ahead = dict(timers), set(ahead)
            board.drafts = {key: dict(members) for key, members in drafts}
        if known is not board._known:
            board._known = known
            board._states, board._data, board._signals = known.states, known.data, known.signals
            if known.shown:
                board.show(known.shown)
            elif known.shown is None:
                for channel in board.SLOTS:
                    board._refresh(channel)
        if board.asked:
            board.asked = []
            board._seen = {}


def built(
    kind: type[DataclassInstance], members: Mapping[tuple[str, ...], object], given: Mapping[str, object]
) -> DataclassInstance:
    """A new message with the members at these paths; the others are those `given`, or have their defaults."""
    whole = dict(given)
    for path, value in members.items():
        if len(path) != 1:
            break
        whole[path[0]] = value
    else:  # the usual case: it is made, and its fields are checked, once
        return kind(**whole)
    message = kind(**given)
    for path, value in members.items():
        message = _with(message, path, value)
    return message


def _with(message: DataclassInstance, path: tuple[str, ...], value: object) -> DataclassInstance:
    if not path:
        assert isinstance(value, type(message))
        return value
    if len(path) > 1:
        value = _with(getattr(message, path[0]), path[1:], value)
    return replace(message, **{path[0]: value})
