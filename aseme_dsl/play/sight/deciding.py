"""Deciding: which expectations the events of one agent decide, for a process that sees no others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import assert_never

from aseme_dsl.play.scenario import (
    AllOf,
    AnyOf,
    Breached,
    Condition,
    Expectation,
    Failed,
    Faulty,
    Holds,
    InPlaces,
    NotSo,
    Says,
    Script,
    Untaken,
    parts_of,
)
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import Always, Never, conditions_of, renumbered


@dataclass(frozen=True, slots=True)
class Decided:
    """What one agent decides of a script.

    A rule that says of each agent of a team what may never be is decided `partly`: the share of this agent.
    """

    script: Script
    partly: tuple[Expectation, ...]
    elsewhere: tuple[Expectation, ...]
    """What only the events of several agents decide."""


def decided_by(script: Script, agent: str) -> Decided:
    """What the events of one agent decide."""
    conditions = list(script.conditions)
    mine: list[Expectation] = []
    partly: list[Expectation] = []
    elsewhere: list[Expectation] = []
    for item in script.expectations:
        if _are_own(script.conditions, conditions_of(item.rule), agent):
            mine.append(_witnessed(item, conditions, agent))
        elif item.protocol is None and (share := _share(item, conditions, agent)) is not None:
            mine.append(share)
            partly.append(share)
        else:
            elsewhere.append(item)
    team = tuple(member for member in script.team if member[0] == agent)
    small = reduced(replace(script, conditions=tuple(conditions), team=team), mine)
    return Decided(small, tuple(partly), tuple(elsewhere))


def reduced(script: Script, expectations: Sequence[Expectation]) -> Script:
    """The script with these of its expectations, and the conditions that they need."""
    kept, numbers = _needed(list(script.conditions), expectations)
    found = tuple(
        replace(
            item,
            rule=renumbered(item.rule, numbers),
            witnesses=tuple(numbers[number] for number in item.witnesses),
        )
        for item in expectations
    )
    return replace(script, conditions=kept, expectations=found)


def _about(conditions: Sequence[Condition], number: int) -> frozenset[str] | None:
    """The agents that a condition is about; None: any agent."""
    condition = conditions[number]
    match condition:
        case InPlaces(places=places):
            return frozenset(places)
        case Says(agents=agents) | Untaken(agents=agents) | Failed(agents=agents) | Breached(agents=agents):
            return agents
        case Holds(agent=agent):
            return frozenset((agent,))
        case Faulty():
            return None
        case AllOf(parts=parts) | AnyOf(parts=parts):
            return agents_about(conditions, parts)
        case NotSo(part=part):
            return _about(conditions, part)
        case _:
            assert_never(condition)


def agents_about(conditions: Sequence[Condition], numbers: Iterable[int]) -> frozenset[str] | None:
    """The agents that some conditions are about; None: any agent."""
    found = [_about(conditions, number) for number in numbers]
    return None if None in found else frozenset().union(*(item for item in found if item is not None))


def _are_own(conditions: Sequence[Condition], numbers: Iterable[int], agent: str) -> bool:
    about = agents_about(conditions, numbers)
    return about is not None and about <= {agent}


def _share(item: Expectation, conditions: list[Condition], agent: str) -> Expectation | None:
    """The share of an agent in a rule that speaks of each agent by itself; None if there is none.

    `never some player in X` is broken as soon as it is for one agent; so is `always every player in X`.
    """
    match item.rule:
        case Never(condition=condition):
            number = _own_part(conditions, condition, agent, AnyOf)
        case Always(condition=condition):
            number = _own_part(conditions, condition, agent, AllOf)
        case _:
            return None
    if number is None:
        return None
    return _witnessed(replace(item, rule=replace(item.rule, condition=number)), conditions, agent)


def _witnessed(item: Expectation, conditions: Sequence[Condition], agent: str) -> Expectation:
    """An expectation with those of its witnesses that the agent sees."""
    return replace(item, witnesses=tuple(it for it in item.witnesses if _are_own(conditions, (it,), agent)))


def _own_part(
    conditions: list[Condition], number: int, agent: str, kind: type[AnyOf] | type[AllOf]
) -> int | None:
    """The number of the part of a condition that is about an agent, if each part is about one agent."""
    condition = conditions[number]
    own: Condition | None
    match condition:
        case InPlaces(places=places, least=1) if kind is AnyOf:
            own = InPlaces({agent: places[agent]}) if agent in places else None
        case Says(agents=agents) if kind is AnyOf:
            is_mine = agents is None or agent in agents
            own = replace(condition, agents=frozenset((agent,))) if is_mine else None
        case Untaken(agents=agents) if kind is AnyOf:
            is_mine = agents is None or agent in agents
            own = replace(condition, agents=frozenset((agent,))) if is_mine else None
        case Breached(agents=agents) if kind is AnyOf:
            own = replace(condition, agents=frozenset((agent,))) if agent in agents else None
        case Failed(agents=agents) if kind is AnyOf:
            own = Failed(frozenset((agent,))) if agent in agents else None
        case Faulty() if kind is AnyOf:
            return number
        case NotSo(part=part):
            inner = _own_part(conditions, part, agent, AllOf if kind is AnyOf else AnyOf)
            own = None if inner is None else NotSo(inner)
        case AllOf(parts=parts) | AnyOf(parts=parts) if isinstance(condition, kind):
            if any(_is_mixed(conditions, part, kind) for part in parts):
                return None
            found = [_own_part(conditions, part, agent, kind) for part in parts]
            mine = tuple(item for item in found if item is not None)
            own = kind(mine) if mine else None
        case _:
            about = _about(conditions, number)
            return number if about is not None and about == {agent} else None
    if own is None:
        return None
    conditions.append(own)
    return len(conditions) - 1


def _is_mixed(conditions: list[Condition], number: int, kind: type[AnyOf] | type[AllOf]) -> bool:
    """Whether a condition cannot be divided into parts that are about one agent each."""
    condition = conditions[number]
    match condition:
        case Says() | Untaken() | Breached() | Failed() | Faulty() | InPlaces(least=1) if kind is AnyOf:
            return False
        case NotSo(part=part):
            return _is_mixed(conditions, part, AllOf if kind is AnyOf else AnyOf)
        case AllOf(parts=parts) | AnyOf(parts=parts) if isinstance(condition, kind):
            return any(_is_mixed(conditions, part, kind) for part in parts)
    about = _about(conditions, number)
    return about is None or len(about) != 1


def _needed(
    conditions: list[Condition], expectations: Iterable[Expectation]
) -> tuple[tuple[Condition, ...], Mapping[int, int]]:
    """The conditions that expectations need, and their new numbers."""
    wanted: set[int] = set()

    def want(number: int) -> None:
        if number not in wanted:
            wanted.add(number)
            for part in parts_of(conditions[number]):
                want(part)

    for item in expectations:
        for number in (*conditions_of(item.rule), *item.witnesses):
            want(number)
    numbers: dict[int, int] = {}
    kept: list[Condition] = []
    for number in sorted(wanted):  # each stands behind its parts
        numbers[number] = len(kept)
        kept.append(_with_parts(conditions[number], lambda part: numbers[part]))
    return tuple(kept), numbers


def _with_parts(condition: Condition, new: Callable[[int], int]) -> Condition:
    match condition:
        case AllOf(parts=parts) | AnyOf(parts=parts):
            return replace(condition, parts=tuple(new(part) for part in parts))
        case NotSo(part=part):
            return NotSo(new(part))
        case _:
            return condition


__all__ = ["Decided", "agents_about", "decided_by", "reduced"]
