"""Ages: what time alone brings in one agent: deadlines that pass, timers that run out, messages that get old.

Time stands still where a team is explored. That a time has passed is a move of its own: what is counted from
is moved back. Each may pass before each other one, as far as none is counted from the same moment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from aseme_dsl.amola.expression import TURNED
from aseme_dsl.proofs.explore.surroundings import NOW
from aseme_dsl.proofs.timed.stamp import standing
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.executions import _Node
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.board import NEVER, Board
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.history import History
from aseme_dsl.runtime.chart.inputs import Identity, Sample
from aseme_dsl.runtime.chart.plan import Plan, terms_in
from aseme_dsl.runtime.message.as_json import StandIn

_FROM = {"<": (0,), ">=": (0,), "<=": (1,), ">": (1,), "==": (0, 1), "!=": (0, 1)}
"""From which ages on a comparison of an age may have another result: so much (ns) after the constant."""


@dataclass(frozen=True, slots=True)
class Passing:
    """A time that may pass in an agent: `state` has been active, `timer` runs, `message` has been there."""

    what: str
    """`state`, `timer`, `message` or `signal`."""
    name: str
    duration: int
    """How long from the moment from which it is counted (ns); 0 where that is not known."""
    pass_: Callable[[], None]
    since: int
    """The moment from which it is counted; of a timer, that at which it runs out."""
    place: tuple[object, ...] = ()
    """Which one it is, of several with this name."""
    identity: Identity | None = None
    """That of the message."""
    renew: Callable[[int], None] | None = None
    """Make a message as old as after `pass_`, counted from another moment."""


def passing(chart: Chart, thresholds: Mapping[str, tuple[int, ...]]) -> Iterator[Passing]:
    """What may pass now. `thresholds` are the ages that conditions ask for, by channel."""
    if not chart.started or chart.finished or chart.failure is not None:
        return
    yield from _states(chart)
    yield from _once(_of_boards(chart, thresholds))


def _of_boards(chart: Chart, thresholds: Mapping[str, tuple[int, ...]]) -> Iterator[Passing]:
    for number, board in enumerate(chart.boards()):
        if board is None:
            continue
        for name, due in board.timers.items():
            if due > NOW:
                yield Passing("timer", name, 0, _expire(chart, number, name, due), due, (number,))
        yield from _messages(chart, number, board, thresholds)


def _once(items: Iterable[Passing]) -> Iterator[Passing]:
    """The same, but a message that stands on several blackboards becomes old on all of them at once."""
    found: dict[tuple[object, ...], list[Passing]] = {}
    for item in items:
        key = item.what, item.name, item.duration, item.identity or item.place
        found.setdefault(key, []).append(item)
    for same in found.values():
        yield same[0] if len(same) == 1 else _together(same)


def _together(same: Sequence[Passing]) -> Passing:
    def pass_() -> None:
        for item in same:
            item.pass_()

    def renew(since: int) -> None:
        for item in same:
            if item.renew is not None:
                item.renew(since)

    return replace(same[0], pass_=pass_, renew=None if same[0].renew is None else renew)


def pauses(agent: Agent) -> Iterator[tuple[str, _Node, int]]:
    """The states of an agent whose activity must not begin again yet, with its period (ns)."""
    for label, node in agent.executions._nodes.items():
        every = node.program.info.every
        if every is not None and node.last_start is not None and NOW - node.last_start < every:
            yield label, node, every


def settle_timers(chart: Chart) -> None:
    """Timers that were started with a time that may be any have run out at once, or run out at any moment."""
    for board in chart.boards():
        timers = {} if board is None else board.timers
        for name, due in timers.items():
            if issubclass(type(due), StandIn):
                timers[name] = NOW + 1 if due > NOW else NOW


def _board(chart: Chart, number: int) -> Board:
    """The blackboard of an active region. A region that is entered again has a new one, so what is to be done
    with a blackboard later finds it by its number."""
    board = chart.boards()[number]
    assert board is not None
    return board


def _expire(chart: Chart, number: int, name: str, due: int) -> Callable[[], None]:
    return lambda: _board(chart, number).timers.__setitem__(name, standing(due, NOW))


def _states(chart: Chart) -> Iterator[Passing]:
    """The next deadline of each active state; found by asking when it is due, with all else far away."""
    slots = {label: (slot, getattr(chart, slot)) for label, slot in chart.TIMES.items()}
    if not slots:
        return
    boards = [board for board in chart.boards() if board is not None]
    kept = [(board, dict(board.timers), _times(board)) for board in boards]
    found: list[tuple[str, str, int, int]] = []
    try:
        for slot, _ in slots.values():
            setattr(chart, slot, NEVER)
        for board, _, times in kept:
            for name in board.timers:
                board.timers[name] = NEVER
            for slot in times:
                setattr(board, slot, NEVER)
        for label, (slot, since) in slots.items():
            setattr(chart, slot, since)
            due = chart.due(NOW)
            setattr(chart, slot, NEVER)
            if due is not None:
                found.append((label, slot, since, due))
    finally:
        for slot, since in slots.values():
            setattr(chart, slot, since)
        for board, timers, times in kept:
            board.timers.update(timers)
            for slot, moment in times.items():
                setattr(board, slot, moment)
    for label, slot, since, due in found:
        pass_ = _age(chart, slot, standing(since, int(since) - (int(due) - NOW)))
        yield Passing("state", label, int(due) - int(since), pass_, since)


def _age(chart: Chart, slot: str, since: int) -> Callable[[], None]:
    return lambda: setattr(chart, slot, since)


def _times(board: Board) -> dict[str, int]:
    return {slot: getattr(board, slot) for slot in [f"{name}_time" for name in sorted(board.TIMED)]}


# ---- messages ---------------------------------------------------------------------------------------


def thresholds_of(plan: Plan) -> tuple[dict[str, tuple[int, ...]], bool]:
    """The ages (ns) from which on conditions about messages may have other results, by channel, and whether
    ages serve for nothing else."""
    found: dict[str, set[int]] = {}
    whole = True
    lines = (part for item in plan.transitions for part in (item.condition, *item.actions))
    for term in terms_in((*lines, *(argument for state in plan.states for argument in state.arguments))):
        match term:
            case (str() as word, ("age", ("member", _, channel, *_)), ("const", int(age))) if word in _FROM:
                found.setdefault(str(channel), set()).update(age + more for more in _FROM[word])
            case (str() as word, ("const", int(age)), ("age", ("member", _, channel, *_))) if word in _FROM:
                turned = _FROM[TURNED.get(word, word)]
                found.setdefault(str(channel), set()).update(age + more for more in turned)
            case (_, *parts) if any(isinstance(part, tuple) and part[:1] == ("age",) for part in parts):
                whole = False
    return {channel: tuple(sorted(ages)) for channel, ages in found.items()}, whole


def asks_for_history(plan: Plan) -> bool:
    """Whether a condition asks what a message was before."""
    for term in terms_in(part for item in plan.transitions for part in (item.condition, *item.actions)):
        match term:
            case ("at" | "mean", ("member", *_), *_):
                return True
            case _:
                pass
    return False


def _messages(
    chart: Chart, number: int, board: Board, thresholds: Mapping[str, tuple[int, ...]]
) -> Iterator[Passing]:
    for channel, ages in thresholds.items():
        for sender, item in _newest(board, channel).items():
            older = next_age(NOW - item.time, ages)
            if older is not None:
                renew = _older(chart, number, channel, sender, item)
                since = standing(item.time, NOW - older)
                place = number, sender
                yield Passing(
                    *("message", channel, older, partial(renew, since), item.time, place, item.identity),
                    renew=renew,
                )
    for channel, longest in board.EXPIRES.items():
        for index, item in enumerate(board._signals.get(channel, ())):
            if NOW - item.time < longest:
                pass_ = _old(chart, number, channel, item, longest)
                yield Passing("signal", channel, longest, pass_, item.time, (number, index), item.identity)


def next_age(age: int, ages: tuple[int, ...]) -> int | None:
    """The next age at which conditions about a message may be otherwise; None if there is none."""
    return next((limit for limit in ages if age < limit), None)


def _newest(board: Board, channel: str) -> dict[str, Sample]:
    """The newest message of each sender of a state, or of data."""
    if channel in board._states:
        return board._states[channel]
    return {item.sender: item for item in board._data.get(channel, ())}


def _older(chart: Chart, number: int, channel: str, sender: str, item: Sample) -> Callable[[int], None]:
    def make(since: int) -> None:
        board = _board(chart, number)
        board.part()
        newest = {**_newest(board, channel), sender: replace(item, time=since)}
        if channel in board._states:
            board._states[channel] = newest
        else:  # of data, the newest is all that is read
            board._data[channel] = History(sorted(newest.values(), key=lambda one: one.time))
        board._refresh(channel)

    return make


def _old(chart: Chart, number: int, channel: str, item: Sample, age: int) -> Callable[[], None]:
    def make() -> None:
        board = _board(chart, number)
        board.part()
        waiting = board._signals[channel]
        waiting[waiting.index(item)] = replace(item, time=standing(item.time, NOW - age))

    return make


__all__ = ["Passing", "asks_for_history", "next_age", "passing", "pauses", "thresholds_of"]
