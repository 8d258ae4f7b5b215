"""Normal: what of a statechart's state can still make a difference, so that equal states are found again.

Moments count from now, and a moment that is over is as good as any other. The numbers of activities and
messages only tell them apart.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping
from enum import Enum

from aseme_dsl.proofs.explore.ages import thresholds_of
from aseme_dsl.runtime.chart.board import NEVER, Board
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.message.as_json import to_json

Key = tuple[Hashable, ...]
PAST = -1


class Gone(Enum):
    """What a variable holds that nothing reads before it is written."""

    GONE = "gone"


_NUMBERS = frozenset(("now", "tokens", "woken", "drains"))


def horizon(charts: Iterable[Chart]) -> int:
    """The longest time, in ns, that a transition or an activity of these waits for."""
    found = [0]
    for chart in charts:
        found += chart.WITHIN.values()
        for item in chart.PLAN.transitions:
            found += [item.every or 0, *(int(str(e[1])) for e in item.events if e[0] == "after")]
    return max(found)


def oldest(charts: Iterable[Chart]) -> Mapping[str, int]:
    """The age, in ns, from which on it makes no difference how old a message of a channel is, by channel."""
    found: dict[str, int] = {}
    for chart in charts:
        for channel, ages in thresholds_of(chart.PLAN)[0].items():
            found[channel] = max(found.get(channel, 0), *ages)
        for info in chart.PLAN.channels:
            if info.expires is not None:
                found[info.name] = max(found.get(info.name, 0), info.expires)
    return found


def normal(chart: Chart, longest: int, ages: Mapping[str, int]) -> Key:
    """The state of a chart between two steps, as a value; nothing waits for more than `longest` ns.

    `ages` are those from which on it makes no difference how old messages are (see `oldest`).
    """
    now = chart.now
    tokens = {token for _, token, _ in chart.RUNNING.values()}
    times = set(chart.TIMES.values())
    marks = {pair[0] for pair in chart.MARKS.values()}
    there = {id(item.message) for board in chart.boards() if board is not None for item in _held(board)}
    values: list[Hashable] = []
    for name in chart.places:
        if name in _NUMBERS or name in tokens:
            continue
        value = getattr(chart, name)
        if name in times:
            value = min(now - value, longest + 1) if value else None
        elif name in marks:
            value = None if value is None else (tuple(id(item) in there for item in value[0]), value[1])
        values.append(_plain(value))
    boards = tuple(None if board is None else _board(board, now, ages) for board in chart.boards())
    mail = tuple(
        (
            branch,
            tuple((i.performative, i.message, i.participant, i.sender, _plain(i.content)) for i in items),
        )
        for branch, items in sorted(chart.mail.items())
        if items
    )
    rounds = tuple((key, agents, taken, settled) for key, agents, _, taken, settled, _ in chart.rounds.save())
    suspended = tuple(
        (branch, tuple(sorted((name, due - left) for name, due in timers.items())))
        for branch, (left, timers) in sorted(chart.suspended.items())
    )
    kept = tuple(
        (slot, tuple(value.items()))
        for slot in chart.KEPT.values()
        if (value := getattr(chart, slot)) is not None
    )
    seldom = (frozenset(chart.failed), tuple(chart.outcomes.items()), frozenset(chart.held), kept)
    return (tuple(values), boards, mail, rounds, suspended, seldom)


def _held(board: Board) -> Iterator[Sample]:
    """The messages on a board, of data the newest."""
    for items in board._signals.values():
        yield from items
    for senders in board._states.values():
        yield from senders.values()
    for history in board._data.values():
        if (item := history.newest(None)) is not None:
            yield item


def _board(board: Board, now: int, ages: Mapping[str, int]) -> Key:
    def sample(item: Sample) -> Hashable:
        age = min(now - item.time, ages[item.channel] + 1) if item.channel in ages else 0
        return (item.sender, item.written_by, age, _plain(item.message))

    timers = tuple(sorted((name, _ahead(due, now)) for name, due in board.timers.items()))
    drafts = tuple(
        (channel, host or "", tuple((path, _plain(value)) for path, value in members.items()))
        for (channel, host), members in board.drafts.items()
    )
    signals = tuple(
        (channel, tuple(map(sample, items))) for channel, items in sorted(board._signals.items()) if items
    )
    states = tuple(
        (channel, tuple(map(sample, items.values()))) for channel, items in sorted(board._states.items())
    )
    data = tuple(
        (channel, tuple(sample(item) for item in (history.newest(None),) if item is not None))
        for channel, history in sorted(board._data.items())
    )
    return (timers, drafts, signals, states, data, len(board.ahead))


def _ahead(due: int, now: int) -> int:
    return due if due == NEVER else PAST if due <= now else due - now


def _plain(value: object) -> Hashable:
    """A value of which two versions of one system have equal ones."""
    if hasattr(type(value), "__dataclass_fields__") and hasattr(type(value), "__post_init__"):
        return type(value).__name__, str(to_json(value))
    if isinstance(value, tuple):
        return tuple(map(_plain, value))
    return value if isinstance(value, Hashable) else str(value)


__all__ = ["Gone", "Key", "horizon", "normal", "oldest"]
