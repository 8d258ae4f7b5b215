"""Stepping: how a step takes its inputs, and how it ends; the same for all charts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar, cast

from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.inputs import (
    Addressed,
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Happened,
    Input,
    LeftOut,
    Outcome,
    Sample,
    Settled,
    SignalExpired,
    Written,
)
from aseme_dsl.runtime.chart.plan import Plan, is_in
from aseme_dsl.runtime.chart.state import ChartState
from aseme_dsl.runtime.time.clock import shown

LONGEST_CIRCLE = 50
"""A circle of so many transitions at the most is found."""
_InputT = TypeVar("_InputT", bound=Input)


def _arrived(chart: ChartState, item: Sample) -> None:
    boards = chart.boards()
    for region in chart.READERS.get(item.channel, ()):
        board = boards[region]
        if board is None or item.written_by == chart.REGIONS[region]:
            continue
        if item.identity in board.ahead:
            board.ahead.discard(item.identity)
        else:
            put(chart, region, board, item)


def _completed(chart: ChartState, item: Completed) -> None:
    leaf, owner, number = chart.RUNNING[item.label]
    runs = getattr(chart, leaf) == number and item.label not in chart.failed
    if runs and item.label not in chart.WAITING and getattr(chart, owner) == item.token:
        setattr(chart, leaf, number + 1)
        if item.outcome is not None:
            set_outcome(chart, item.label, item.outcome)


def _crashed(chart: ChartState, item: Crashed) -> None:
    leaf, owner, number = chart.RUNNING[item.label]
    if getattr(chart, leaf) == number and getattr(chart, owner) == item.token:
        chart.failed[item.label] = item.reason


def _happened(chart: ChartState, item: Happened) -> None:
    chart.events.add(item.name)


def _written(chart: ChartState, item: Written) -> None:
    for slot in chart.VARIABLES[item.variable]:
        setattr(chart, slot, item.value)


def _mailed(chart: ChartState, item: AgentMessage) -> None:
    if item.sent is None:
        item = replace(item, came=chart.now)
    chart.mail[item.branch] += (item,)


def put(chart: ChartState, region: int, board: Board, item: Sample) -> None:
    """Put a message on a region's board, unless too many wait there that no transition takes."""
    if item.channel in board.QUEUED and board.waits(item.channel) >= chart.queue:
        chart.effects.append(LeftOut(chart.REGIONS[region], item.channel))
    else:
        board.put(item, chart.now)


def expired_signals(chart: ChartState, now: int) -> list[SignalExpired]:
    """Drop the signals that are too old for their topics."""
    return [
        SignalExpired(region, item.channel, item.identity)
        for region, board in zip(chart.REGIONS, chart.boards(), strict=True)
        if board is not None and board.EXPIRES
        for item in board.expire(now)
    ]


def fail_late_activities(chart: ChartState) -> None:
    """Cancel the activities whose deadline has passed: their states have failed."""
    for label, within in chart.WITHIN.items():
        leaf, owner, number = chart.RUNNING[label]
        if getattr(chart, leaf) != number or label in chart.failed:
            continue
        if chart.now - getattr(chart, chart.TIMES[label]) >= within:
            reason = chart.failed[label] = f"not done within {shown(within)}"
            activity = chart.PLAN.by_label[label].activity or ""
            chart.effects.append(Cancel(label, activity, getattr(chart, owner), reason))


def fail_for_breach(chart: ChartState) -> bool:
    """Fail the first activity that runs in the state that a breach of bounds has entered, else the chart.

    The result is whether another round follows.
    """
    assert chart.breach is not None
    (target, reason), chart.breach = chart.breach, None
    for label, (leaf, owner, number) in chart.RUNNING.items():
        if is_in(label, target) and getattr(chart, leaf) == number and label not in chart.failed:
            chart.failed[label] = reason
            activity = chart.PLAN.by_label[label].activity or ""
            chart.effects.append(Cancel(label, activity, getattr(chart, owner), reason))
            return True
    stop(chart, reason)
    return False


def set_outcome(chart: ChartState, label: str, outcome: str | None) -> None:
    """The activity of a state has ended so; the newest comes last."""
    chart.outcomes.pop(label, None)
    chart.outcomes[label] = outcome


def end_step(chart: ChartState, outcome: Outcome) -> None:
    """Let all regions see what was written, drop used signals, and note how the chart stands."""
    if chart.writes and _spread_writes(chart):
        chart.woken = outcome.again = True
    if chart.raised:
        chart.woken = outcome.again = True
    if chart.READERS:
        for board in chart.boards():
            if board is not None and board.asked:
                _end_signals(chart, board, outcome)
    if chart.failed and chart.failure is None:
        label, reason = next(iter(chart.failed.items()))
        name = chart.PLAN.by_label[label].name
        stop(chart, f"activity {name} of state {label} failed: {reason}")
    if chart.events:
        chart.events.clear()
        chart.spent.clear()
    chart.finished = outcome.finished = chart.is_finished()
    if chart.finished or chart.failure is not None:
        chart.raised = ()
    outcome.failure = chart.failure


def _end_signals(chart: ChartState, board: Board, outcome: Outcome) -> None:
    """Drop the signals that a region has looked at. Another step follows if others wait behind them, or
    if a transition of an active state there may miss them."""
    for channel in board.end_step():
        if board.waits(channel):
            chart.drains = outcome.again = True
        for region, slot, leaves in chart.MISSED.get(channel, ()):
            if chart.boards()[region] is board and _is_at(getattr(chart, slot), leaves):
                outcome.again = True


def count_waiting(chart: ChartState) -> int:
    """How many signals and agent messages wait."""
    mail = sum(map(len, chart.mail.values())) if chart.mail else 0
    if not chart.READERS:
        return mail
    return mail + sum(board.waiting() for board in chart.boards() if board is not None)


def _spread_writes(chart: ChartState) -> bool:
    """Let all regions see what was written; whether that wakes one of them."""
    found = {name: value for _, name, value in sorted(chart.writes, key=lambda write: write[0])}
    chart.writes.clear()
    wakes = False
    for name, value in found.items():
        wakes = wakes or any(_reads_anew(chart, copy, value) for copy in chart.WAKES.get(name, ()))
        chart.set_variable(name, value)
    return wakes


def _reads_anew(chart: ChartState, copy: tuple[str, str, tuple[tuple[int, int], ...]], value: object) -> bool:
    """Whether a transition of an active state reads a copy of a variable that has another value yet."""
    slot, region, leaves = copy
    return getattr(chart, slot) != value and _is_at(getattr(chart, region), leaves)


def stop(chart: ChartState, reason: str) -> None:
    """The chart has failed: it leaves everything."""
    chart.failure = reason
    chart.stopped_at = len(chart.effects)
    chart.leave()
    _spread_writes(chart)


def livelock(chart: ChartState, rounds: int) -> str:
    """What to say of a step without an end."""
    return f"the step does not settle after {rounds} rounds: {circle(chart.PLAN, chart.taken)}"


def circle(plan: Plan, taken: Sequence[Sequence[int]]) -> str:
    """The transitions that are taken over and over again, in their order; the last ones where none are."""
    last = [tuple(way) for way in taken[-2 * LONGEST_CIRCLE :]]
    lengths = (size for size in range(1, len(last) // 2 + 1) if last[-size:] == last[-2 * size : -size])
    size = next(lengths, 0)
    ways = [plan.way(way) for way in last[-(size or 8) :]]
    return f"{', '.join(dict.fromkeys(ways))}{', and again' if size else ''}"


def _is_at(leaf: int, leaves: Iterable[tuple[int, int]]) -> bool:
    """Whether the number of an active leaf is one of these."""
    return any(first <= leaf <= last for first, last in leaves)


Receive = Callable[[ChartState, Input], None]


def _of(kind: type[_InputT], receive: Callable[[ChartState, _InputT], None]) -> tuple[type[Input], Receive]:
    return cast("tuple[type[Input], Receive]", (kind, receive))  # looked up by the class of the input


RECEIVE: Mapping[type[Input], Receive] = dict(
    (
        _of(Sample, _arrived),
        _of(Completed, _completed),
        _of(Crashed, _crashed),
        _of(Happened, _happened),
        _of(Written, _written),
        _of(AgentMessage, _mailed),
        _of(Addressed, lambda chart, item: chart.rounds.addressed(item)),
        _of(Settled, lambda chart, item: chart.rounds.settled(item)),
    )
)
"""What each kind of input does to a chart."""
