"""Frozen regions: what both versions have alike and what touches nothing else need not move.

Such a region runs for ever beside the others, and nothing in it tells them anything. So what is different
elsewhere is so, too, while the activities of this region do not end.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from aseme_dsl.proofs.explore.deciding.staging import writable
from aseme_dsl.runtime.chart.plan import Plan, State, Transition, is_in

Terms = tuple[object, ...]
_LABEL = re.compile(r"(?<![\w.])\d+(?:\.\d+)+(?![\w.])")
_OF_STATES = frozenset(("in", "done", "count", "outcome"))


def frozen(old: Plan, new: Plan) -> tuple[frozenset[str], frozenset[str]]:
    """The labels of the regions in each version that need not move."""
    sides = [
        {state.label: _meaning(plan, state.label) for state in plan.states if _is_alone(plan, state)}
        for plan in (old, new)
    ]
    counts = [Counter(side.values()) for side in sides]
    kept = {text for text in counts[0] if counts[0][text] == counts[1][text]}
    first, second = (frozenset(label for label, text in side.items() if text in kept) for side in sides)
    return first, second


def _meaning(plan: Plan, label: str) -> str:
    """A text that is equal for two regions that do the same, with what their variables hold at first."""
    names = {info.name for info in plan.variables if _names_of(plan, label) & {info.name.partition("@")[0]}}
    variables = [item for item in plan.variables if item.name in names]
    settings = [item for item in plan.settings if item[1] in names]
    return f"{like(plan, label)}{variables!r}{settings!r}"


def _names_of(plan: Plan, label: str) -> set[str]:
    """The variables that something in a region reads or writes."""
    own = _uses(plan, label)[0]
    return own.read | own.written


def like(plan: Plan, label: str) -> str:
    """What is in a state, as a text that is equal for two states that do the same."""

    def inside(name: str) -> str:
        return name[len(label) :] if is_in(name, label) else name

    states = [
        (inside(item.label), item.type, item.activity, item.arguments, item.branch)
        for item in plan.states
        if is_in(item.label, label)
    ]
    ways = [
        (
            *map(inside, (t.source, t.target, *t.into)),
            t.priority,
            t.events,
            t.when,
            t.otherwise,
            t.every,
            _does(t),
        )
        for t in plan.transitions
        if is_in(t.source, label)
    ]
    used = {item.activity for item in plan.states if is_in(item.label, label)}
    infos = sorted(repr(info) for info in plan.activities if info.name in used)
    return repr((states, ways, infos))


def _does(item: Transition) -> Terms:
    return (item.condition, item.weight, item.actions, item.first, item.kind, item.resume)


def whole(plan: Plan) -> str:
    """All that decides what a statechart does, as a text that is equal for two that do the same.

    Labels are replaced by the places of states: who renames labels changes nothing.
    """
    labels = {state.label: f"@{number}" for number, state in enumerate(plan.states)}
    channels = sorted(repr(info) for info in plan.channels)
    functions = sorted((name, target, result) for name, target, result, _ in plan.functions)
    about = (plan.variables, channels, functions, plan.branches, plan.settings, plan.numbers)
    text = f"{like(plan, plan.states[0].label)}{about!r}"
    return _LABEL.sub(lambda found: labels.get(found[0], found[0]), text)


def _is_alone(plan: Plan, region: State) -> bool:
    """Whether a region runs for ever and touches nothing outside of it."""
    label = region.label
    if region.parent is None or plan.by_label[region.parent].type != "AND":
        return False
    if plan.can_end(region.label) or any(is_in(info.label, label) for info in plan.branches):
        return False
    for item in plan.transitions:
        if is_in(item.source, label) and (
            not is_in(item.target, label)
            or item.when
            or item.kind != "external"
            or item.events
            or any(action[0] in ("send", "start_timer", "raise") for action in item.actions)
        ):
            return False
    own, other = _uses(plan, label)
    names = {state.name for state in plan.states if is_in(state.label, label)}
    used = {state.activity for state in plan.states if is_in(state.label, label)}
    if own.has_timers or own.states or names & other.states or used & other.states:
        return False
    return not (
        own.written & other.read
        or other.written & own.read
        or own.published & other.heard
        or other.published & own.heard
        or any(channel.split(".", 2)[1] == "signal" for channel in own.heard & other.heard)
    )


def _uses(plan: Plan, label: str) -> tuple[_Uses, _Uses]:
    """What is used in a region, and what is used elsewhere."""
    own, other = _Uses(), _Uses()
    for term, is_own in _terms(plan, label):
        (own if is_own else other).add(term)
    for state in plan.states:
        if state.activity is not None:
            (own if is_in(state.label, label) else other).written.update(writable(plan, state.label))
    return own, other


class _Uses:
    """What terms read and write."""

    def __init__(self) -> None:
        self.read: set[str] = set()
        self.written: set[str] = set()
        self.heard: set[str] = set()
        self.published: set[str] = set()
        self.states: set[object] = set()
        self.has_timers = False

    def add(self, term: Terms) -> None:
        match term:
            case ("variable", str() as name, *_):
                self.read.add(name.partition("@")[0])
            case ("assign", str() as name, *_):
                self.written.add(name.partition("@")[0])
            case ("member", _, str() as channel, *_):
                self.heard.add(channel)
            case ("publish", str() as channel):
                self.published.add(channel)
            case ("expired", *_):
                self.has_timers = True
            case (str() as word, name, *_) if word in _OF_STATES:
                self.states.add(name)


def _terms(plan: Plan, label: str) -> Iterator[tuple[Terms, bool]]:
    """Every term of a plan, and whether it stands in a state."""
    todo: list[tuple[object, bool]] = []
    for item in plan.transitions:
        todo += [(term, is_in(item.source, label)) for term in (item.condition, *item.actions)]
    for state in plan.states:
        todo += [(term, is_in(state.label, label)) for _, term in state.arguments]
    while todo:
        term, is_own = todo.pop()
        if isinstance(term, tuple):
            yield term, is_own
            todo += [(part, is_own) for part in term]


__all__ = ["frozen", "like", "whole"]
