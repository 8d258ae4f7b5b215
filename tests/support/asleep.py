"""Whether an agent that goes to sleep has overlooked something: no transition may be enabled then."""

from __future__ import annotations

import copy
from collections.abc import Iterable
from typing import Any

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Input, Outcome

unchecked_step = Chart.step


def step(self: Chart, now: int, inputs: Iterable[Input]) -> Outcome:
    """A step of a chart after which, unless another one follows, nothing is enabled."""
    outcome = unchecked_step(self, now, inputs)
    if not (outcome.again or outcome.finished or outcome.failure is not None or _draws(self)):
        _check(self)
    return outcome


def _draws(chart: Chart) -> bool:
    """Whether a condition draws numbers: it may hold when it is looked at again."""
    return any("('random',)" in repr(way.condition) for way in chart.PLAN.transitions)


def _check(chart: Chart) -> None:
    """One more round takes nothing; what it has asked for is put back."""
    boards: list[Any] = [board for board in chart.boards() if board is not None]
    asked = [(copy.copy(board.asked), dict(board._seen)) for board in boards]
    effects, faults, marks = len(chart.effects), set(chart._faults), _marks(chart)
    before = len(chart.taken)
    moved = chart.round()
    assert not moved, f"{chart.PLAN.name} sleeps although it may take {chart.taken[before:]}"
    del chart.effects[effects:]
    chart._faults.clear()
    chart._faults.update(faults)
    for board, (signals, seen) in zip(boards, asked, strict=True):
        board.asked[:] = signals
        board._seen.clear()
        board._seen.update(seen)
    for slot, mark in marks.items():
        setattr(chart, slot, mark)


def _marks(chart: Chart) -> dict[str, Any]:
    return {slot: getattr(chart, slot) for slots in chart.MARKS.values() for slot in slots if slot}
