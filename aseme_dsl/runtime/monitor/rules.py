"""Rules: what has to be so in a run, each a small automaton.

A rule speaks of conditions by their numbers. It sees a run as *views*, one behind another. A view is either a
point (a step, a message, a fault) or the rest until the next point, in which nothing changes. Bounds of time
are included; all times are in ns.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from enum import Enum
from typing import assert_never

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import NEVER


class Verdict(Enum):
    """What is known of a rule so far."""

    OPEN = "open"
    KEPT = "kept"
    BROKEN = "broken"


@dataclass(frozen=True, slots=True)
class View:
    """What holds and what occurs from `first` to `last`.

    A point lasts no time. In a rest nothing occurs, and all is done that was due at its first moment.
    `begun`: every agent has made its first step.
    """

    first: int
    last: int
    holds: frozenset[int]
    occurs: frozenset[int] = frozenset()
    begun: bool = True
    rests: bool = False

    def is_met(self, condition: int) -> bool:
        """Whether the condition holds, or occurs without lasting."""
        return condition in self.holds or condition in self.occurs


@dataclass(frozen=True, slots=True)
class State:
    """How far a rule has come.

    `due` is the end of what it waits for, or of what it forbids; `at` is when it was kept or broken.
    """

    verdict: Verdict = Verdict.OPEN
    stage: int = 0
    due: int | None = None
    at: int = 0


# ---- the rules --------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Sometime:
    """The condition is met at some point from `since` to `until`."""

    condition: int
    since: int
    until: int


@dataclass(frozen=True, slots=True)
class At:
    """The condition holds after the last step at a moment."""

    condition: int
    moment: int


@dataclass(frozen=True, slots=True)
class AfterFirst:
    """`after` ns after the first occurrence of `trigger`, the condition holds."""

    trigger: int
    after: int
    condition: int


@dataclass(frozen=True, slots=True)
class Always:
    """The condition holds at every point."""

    condition: int


@dataclass(frozen=True, slots=True)
class Never:
    """The condition is not met before a moment."""

    condition: int
    before: int = NEVER


@dataclass(frozen=True, slots=True)
class InOrder:
    """The conditions occur one after another, anything between."""

    conditions: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Before:
    """`second` does not occur until `first` has occurred."""

    first: int
    second: int


@dataclass(frozen=True, slots=True)
class Until:
    """`first` holds at every point before `second` is met, which need not be."""

    first: int
    second: int


@dataclass(frozen=True, slots=True)
class LeadsTo:
    """Whenever `first` occurs, `second` is met then or later, within so many ns if that is said."""

    first: int
    second: int
    within: int | None


@dataclass(frozen=True, slots=True)
class NotWithin:
    """After `trigger` has occurred, the condition does not occur within so many ns."""

    condition: int
    trigger: int
    within: int


Rule = Sometime | At | AfterFirst | Always | Never | InOrder | Before | Until | LeadsTo | NotWithin


def conditions_of(rule: Rule) -> tuple[int, ...]:
    """The numbers of the conditions that a rule speaks of."""
    match rule:
        case InOrder(conditions=conditions):
            return conditions
        case Sometime() | At() | Always() | Never():
            return (rule.condition,)
        case AfterFirst() | NotWithin():
            return rule.trigger, rule.condition
        case Before() | Until() | LeadsTo():
            return rule.first, rule.second
        case _:
            assert_never(rule)


def renumbered(rule: Rule, numbers: Mapping[int, int]) -> Rule:
    """The same rule about conditions that have other numbers."""
    match rule:
        case InOrder(conditions=conditions):
            return InOrder(tuple(numbers[number] for number in conditions))
        case Sometime() | At() | Always() | Never():
            return replace(rule, condition=numbers[rule.condition])
        case AfterFirst() | NotWithin():
            return replace(rule, trigger=numbers[rule.trigger], condition=numbers[rule.condition])
        case Before() | Until() | LeadsTo():
            return replace(rule, first=numbers[rule.first], second=numbers[rule.second])
        case _:
            assert_never(rule)


# ---- what becomes of them ---------------------------------------------------------------------------


def _kept(state: State, view: View) -> State:
    return replace(state, verdict=Verdict.KEPT, at=view.first)


def _broken(state: State, moment: int) -> State:
    return replace(state, verdict=Verdict.BROKEN, at=moment)


def seen(rule: Rule, state: State, view: View) -> State:
    """The state of a rule once it has seen one more view."""
    if state.verdict is not Verdict.OPEN:
        return state
    match rule:
        case Sometime():
            return _sometime(rule, state, view)
        case At(condition=condition, moment=moment):
            return _at(condition, moment, state, view)
        case AfterFirst():
            if state.due is None and rule.trigger in view.occurs:
                state = replace(state, due=view.first + rule.after)
            return state if state.due is None else _at(rule.condition, state.due, state, view)
        case Always(condition=condition):
            is_broken = view.begun and condition not in view.holds
            return _broken(state, view.first) if is_broken else state
        case Never(condition=condition, before=before):
            if view.first >= before:
                return _kept(state, view)
            return _broken(state, view.first) if view.is_met(condition) else state
        case InOrder(conditions=conditions):
            if conditions[state.stage] not in view.occurs:
                return state
            state = replace(state, stage=state.stage + 1)
            return _kept(state, view) if state.stage == len(conditions) else state
        case Before(first=first, second=second):
            if first in view.occurs:
                return _kept(state, view)
            return _broken(state, view.first) if second in view.occurs else state
        case Until(first=first, second=second):
            if view.is_met(second):
                return _kept(state, view)
            is_broken = view.begun and first not in view.holds
            return _broken(state, view.first) if is_broken else state
        case LeadsTo():
            return _leads_to(rule, state, view)
        case NotWithin(condition=condition, trigger=trigger, within=within):
            if state.due is not None and view.first <= state.due and condition in view.occurs:
                return _broken(state, view.first)
            return replace(state, due=view.first + within) if trigger in view.occurs else state
        case _:
            assert_never(rule)


def _sometime(rule: Sometime, state: State, view: View) -> State:
    if view.first > rule.until:
        return _broken(state, rule.until)
    is_in_time = view.last >= rule.since
    if is_in_time and view.is_met(rule.condition):
        return _kept(state, view)
    return _broken(state, rule.until) if view.last > rule.until else state


def _at(condition: int, moment: int, state: State, view: View) -> State:
    """The condition is looked at when nothing is left to do at the moment."""
    if not view.rests or view.last < moment:
        return state
    return _kept(state, view) if condition in view.holds else _broken(state, moment)


def _leads_to(rule: LeadsTo, state: State, view: View) -> State:
    if state.due is not None and view.first > state.due:
        return _broken(state, state.due)
    if state.due is None and rule.first in view.occurs:  # of several that wait, the first is due first
        state = replace(state, due=NEVER if rule.within is None else view.first + rule.within)
    if view.is_met(rule.second):
        return replace(state, due=None)
    return _broken(state, state.due) if state.due is not None and view.last > state.due else state


def deadline(rule: Rule, state: State) -> int | None:
    """The last moment at which what a rule awaits may come, if there is one; later it is broken."""
    if state.verdict is not Verdict.OPEN:
        return None
    match rule:
        case Sometime(until=until):
            return until
        case At(moment=moment):
            return moment
        case AfterFirst() | LeadsTo():
            return None if state.due == NEVER else state.due
        case Always() | Never() | InOrder() | Before() | Until() | NotWithin():
            return None
        case _:
            assert_never(rule)


def ended(rule: Rule, state: State, moment: int) -> State:
    """The state of a rule at the end of the run: what is still awaited then has not come."""
    if state.verdict is not Verdict.OPEN:
        return state
    match rule:
        case Sometime() | At() | InOrder():
            return _broken(state, moment)
        case AfterFirst() | LeadsTo():
            verdict = Verdict.KEPT if state.due is None else Verdict.BROKEN
            return replace(state, verdict=verdict, at=moment)
        case Always() | Never() | Before() | Until() | NotWithin():
            return replace(state, verdict=Verdict.KEPT, at=moment)
        case _:
            assert_never(rule)


__all__ = [
    "AfterFirst",
    "Always",
    "At",
    "Before",
    "InOrder",
    "LeadsTo",
    "Never",
    "NotWithin",
    "Rule",
    "Sometime",
    "State",
    "Until",
    "Verdict",
    "View",
    "conditions_of",
    "deadline",
    "ended",
    "renumbered",
    "seen",
]
