"""Saving: the whole state of a chart between two steps as a plain immutable value, and back.

What a chart is given from outside does not belong to it: its agent's name, the seed, and how many signals
may wait.
"""

from __future__ import annotations

from random import Random
from typing import NamedTuple, TypeAlias

from aseme_dsl.runtime.chart.board import SavedBoard, load_all, save_all
from aseme_dsl.runtime.chart.inputs import AgentMessage
from aseme_dsl.runtime.chart.rounds import Round
from aseme_dsl.runtime.chart.state import ChartState

Chance: TypeAlias = tuple[object, ...]
"""Where a generator of random numbers stands."""


class Seldom(NamedTuple):
    """What most charts do not have at most times; the members are those of `ChartState`."""

    failed: tuple[tuple[str, str], ...]
    outcomes: tuple[tuple[str, str | None], ...]
    mail: tuple[tuple[str, tuple[AgentMessage, ...]], ...]
    rounds: tuple[Round, ...]
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


_made = tuple.__new__
"""Makes a named tuple in half the time."""


def save(chart: ChartState) -> Saved:
    """The state of a chart, which is between two steps."""
    # The timers of a suspended part stand still on boards that nothing reads meanwhile.
    boards = save_all(chart.all_boards() if chart.suspended else chart.boards())
    seldom = _seldom(chart) if _has_seldom(chart) else NOTHING
    return _made(Saved, (chart.PLAN.model, chart.values(), boards, seldom))


def _has_seldom(chart: ChartState) -> bool:
    """Whether it has anything of what most charts do not have."""
    return bool(
        chart.failed
        or chart.outcomes
        or chart.held
        or chart.suspended
        or chart.writes
        or chart.rounds
        or chart.chance is not None
        or (chart.mail and any(chart.mail.values()))
        or (chart.KEPT and any(getattr(chart, slot) is not None for slot in chart.KEPT.values()))
    )


def _seldom(chart: ChartState) -> Seldom:
    kept = [(slot, value) for slot in chart.KEPT.values() if (value := getattr(chart, slot)) is not None]
    mail = [item for item in chart.mail.items() if item[1]]
    suspended = [(branch, left, tuple(timers.items())) for branch, (left, timers) in chart.suspended.items()]
    return _made(
        Seldom,
        (
            tuple(chart.failed.items()),
            tuple(chart.outcomes.items()),
            tuple(mail),
            chart.rounds.save() if chart.rounds else (),
            frozenset(chart.held),
            tuple(suspended),
            tuple(chart.writes),
            tuple([(slot, tuple(value.items())) for slot, value in kept]),
            None if chart.chance is None else chart.chance.getstate(),
        ),
    )


def load(chart: ChartState, saved: Saved) -> None:
    """Give a chart of the same model a state that was saved; it is between two steps.

    Raises:
        OtherModel: the state is one of another model.
    """
    model, values, boards, seldom = saved
    if model != chart.PLAN.model:
        raise OtherModel(f"the state is one of the model {model}, not of {chart.PLAN.model}")
    chart.set_values(values)
    load_all(chart.all_boards(), boards)
    if seldom is not NOTHING or _has_seldom(chart):
        _load_seldom(chart, seldom)


def _load_seldom(chart: ChartState, seldom: Seldom) -> None:
    failed, outcomes, mail, rounds, held, suspended, writes, kept, chance = seldom
    if failed or chart.failed:
        chart.failed = dict(failed)
    if outcomes or chart.outcomes:
        chart.outcomes = dict(outcomes)
    if mail or (chart.mail and any(chart.mail.values())):
        chart.mail = dict.fromkeys(chart.mail, ())
        chart.mail.update(mail)
    if rounds or chart.rounds:
        chart.rounds.load(rounds)
    if held or chart.held:
        chart.held = set(held)
    if suspended or chart.suspended:
        chart.suspended = {branch: (left, dict(timers)) for branch, left, timers in suspended}
    if writes or chart.writes:
        chart.writes = list(writes)
    if chart.KEPT:
        remembered = dict(kept)
        for slot in chart.KEPT.values():
            setattr(chart, slot, dict(remembered[slot]) if slot in remembered else None)
    chart.chance = None
    if chance is not None:
        chart.chance = Random()
        chart.chance.setstate(chance)
