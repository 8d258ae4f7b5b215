"""Saving: the whole state of a chart between two steps as a plain immutable value, and back.

What a chart is given from outside does not belong to it: its agent's name, the seed, and how many signals
may wait.
"""

from __future__ import annotations

from collections import deque
from itertools import repeat
from random import Random
from typing import NamedTuple, TypeAlias

from aseme_dsl.runtime.chart.board import SavedBoard, load_all, save_all
from aseme_dsl.runtime.chart.inputs import AgentMessage
from aseme_dsl.runtime.chart.rounds import SavedRound
from aseme_dsl.runtime.chart.state import ChartState

Chance: TypeAlias = tuple[object, ...]
"""Where a generator of random numbers stands."""


class Seldom(NamedTuple):
    """What most charts do not have at most times; the members are those of `ChartState`."""

    failed: tuple[tuple[str, str], ...]
    outcomes: tuple[tuple[str, str | None], ...]
    mail: tuple[tuple[str, tuple[AgentMessage, ...]], ...]
    rounds: tuple[SavedRound, ...]
    held: frozenset[str]
    suspended: tuple[tuple[str, int, tuple[tuple[str, int], ...]], ...]
    writes: tuple[tuple[int, str, object], ...]
    kept: tuple[tuple[str, tuple[tuple[int, int], ...]], ...]
    chance: Chance | None


class Saved(NamedTuple):
    """The state of a chart. Two charts that will do the same have equal ones."""

    model: str
    """The hash of the plan."""
    values: tuple[object, ...]
    """The values of `ChartState.places`, in their order."""
    boards: tuple[SavedBoard | None, ...]
    """The blackboards of the regions, None where nothing will look at it again."""
    seldom: Seldom


NOTHING = Seldom((), (), (), (), frozenset(), (), (), (), None)


class OtherModel(ValueError):
    """A state is one of another model."""


def save(chart: ChartState) -> Saved:
    """The state of a chart, which is between two steps."""
    # The timers of a suspended part stand still on boards that nothing reads meanwhile.
    boards = type(chart).all_boards(chart) if chart.suspended else chart.boards()
    return Saved(
        chart.PLAN.model,
        type(chart).values(chart),
        save_all(boards),
        _seldom(chart),
    )


def _seldom(chart: ChartState) -> Seldom:
    kept = (
        [(slot, value) for slot in chart.KEPT.values() if (value := getattr(chart, slot)) is not None]
        if chart.KEPT
        else ()
    )
    mail = [item for item in chart.mail.items() if item[1]] if chart.mail else ()
    if not (
        chart.failed
        or chart.outcomes
        or mail
        or kept
        or chart.held
        or chart.suspended
        or chart.writes
        or chart.chance is not None
        or chart.rounds
    ):
        return NOTHING
    return Seldom(
        tuple(chart.failed.items()),
        tuple(chart.outcomes.items()),
        tuple((branch, tuple(items)) for branch, items in mail),
        chart.rounds.save(),
        frozenset(chart.held),
        tuple((branch, left, tuple(timers.items())) for branch, (left, timers) in chart.suspended.items()),
        tuple(chart.writes),
        tuple((slot, tuple(value.items())) for slot, value in kept),
        None if chart.chance is None else chart.chance.getstate(),
    )


def load(chart: ChartState, saved: Saved) -> None:
    """Give a chart of the same model a state that was saved; it is between two steps.

    Raises:
        OtherModel: the state is one of another model.
    """
    model, values, boards, seldom = saved
    if model != chart.PLAN.model:
        raise OtherModel(f"the state is one of the model {model}, not of {chart.PLAN.model}")
    deque(map(setattr, repeat(chart), chart.places, values), maxlen=0)  # a third faster than a loop
    load_all(type(chart).all_boards(chart), boards)
    if seldom is not NOTHING or _seldom(chart) is not NOTHING:
        _load_seldom(chart, seldom)


def _load_seldom(chart: ChartState, seldom: Seldom) -> None:
    chart.failed = dict(seldom.failed)
    chart.outcomes = dict(seldom.outcomes)
    chart.mail = {branch: [] for branch in chart.mail}
    chart.mail.update({branch: list(items) for branch, items in seldom.mail})
    chart.rounds.load(seldom.rounds)
    chart.held = set(seldom.held)
    chart.suspended = {branch: (left, dict(timers)) for branch, left, timers in seldom.suspended}
    chart.writes = list(seldom.writes)
    kept = dict(seldom.kept)
    for slot in chart.KEPT.values():
        setattr(chart, slot, dict(kept[slot]) if slot in kept else None)
    chart.chance = None
    if seldom.chance is not None:
        chart.chance = Random()
        chart.chance.setstate(seldom.chance)
