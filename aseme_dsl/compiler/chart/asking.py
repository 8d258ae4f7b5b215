"""Asking: what a cycle asks of others and starts for itself, and the conditions that wait for it.

After a `send` no agent has answered yet; a timer that is started has not expired.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from aseme_dsl.amola.expression import (
    COMPARE,
    Compare,
    Expired,
    Literal,
    Logic,
    Named,
    Not,
    RoundValue,
    Send,
    StartTimer,
    Value,
)
from aseme_dsl.amola.statechart import Statechart, Transition
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Asked:
    """Participants that have just been sent to, each in a branch, and timers of regions that have started."""

    participants: frozenset[tuple[str | None, str]] = frozenset()
    timers: frozenset[tuple[str, str]] = frozenset()

    def __bool__(self) -> bool:
        return bool(self.participants or self.timers)


NOTHING_ASKED = Asked()


def asked_in(chart: Statechart, own: Collection[Transition], states: Iterable[str]) -> Asked:
    """What these transitions send and start, and those that lead through these states without an event."""
    inside = tuple(f"{label}." for label in states)
    participants: set[tuple[str | None, str]] = set()
    timers: set[tuple[str, str]] = set()
    for transition in chart.transitions:
        is_passed = transition.changes_state and not transition.expression.events
        if transition not in own and not (is_passed and transition.source.startswith(inside)):
            continue
        for action in transition.expression.actions:
            if isinstance(action, Send) and action.participant:
                participants.add((chart.conversation_of(transition), action.participant))
            elif isinstance(action, StartTimer) and _number(action.duration) != 0:
                timers.add((chart.acts_in(transition), action.timer))
    return Asked(frozenset(participants), frozenset(timers))


def waits_for(chart: Statechart, transition: Transition, asked: Asked) -> bool:
    """Whether the condition of a transition is false while no agent has answered and no time has passed."""
    condition = transition.expression.condition
    if condition is None or not asked:
        return False
    return _Moment(chart, transition, asked).truth(condition) is False


@dataclass(frozen=True, slots=True)
class _Moment:
    """The moment after the sending, as a transition sees it."""

    chart: Statechart
    transition: Transition
    asked: Asked

    def truth(self, value: Value) -> bool | None:
        """Whether a condition holds; None where that depends on something else."""
        match value:
            case Literal(value=bool(known)):
                return known
            case Named(expression=expression):
                return self.truth(expression)
            case Not(operand=operand):
                found = self.truth(operand)
                return None if found is None else not found
            case RoundValue(question="all_answered") if self._is_asked(value):
                return False
            case Expired(timer=timer):
                region = self.chart.region_of(self.transition.source)
                return False if (region, timer) in self.asked.timers else None
            case Logic(operator="&&", operands=operands):
                parts = [self.truth(item) for item in operands]
                return False if False in parts else None if None in parts else True
            case Logic(operands=operands):
                parts = [self.truth(item) for item in operands]
                return True if True in parts else None if None in parts else False
            case Compare(operator=sign, left=left, right=right):
                one, other = self._count(left), self._count(right)
                return None if one is None or other is None else COMPARE[sign](one, other)
            case _:
                return None

    def _count(self, value: Value) -> float | None:
        """A number, or how many have answered; at least one is asked."""
        if isinstance(value, RoundValue) and self._is_asked(value):
            return 0 if value.question == "answered" else 1
        return _number(value)

    def _is_asked(self, value: RoundValue) -> bool:
        return (self.chart.conversation_of(self.transition), value.participant) in self.asked.participants


def _number(value: Value) -> float | None:
    if isinstance(value, Literal) and isinstance(value.value, int | float):
        return value.value
    return None


__all__ = ["NOTHING_ASKED", "Asked", "asked_in", "waits_for"]
