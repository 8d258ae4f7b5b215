"""Needed: which regions of a team matter to a question; the others need not move while it is answered.

A region that nothing depends on is left where it is: what it could do changes nothing of what is asked.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

from aseme_dsl.proofs.explore.deciding.staging import published
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in, terms_in

Part = tuple[str, str]
"""A region of a role: the names of the role and of the region."""


@dataclass(frozen=True, slots=True)
class Asked:
    """What a question is about: states by role, with what is inside; channels; variables and timers by their
    names; and regions by role, without what is inside."""

    states: Mapping[str, frozenset[str]]
    channels: frozenset[str] = frozenset()
    names: frozenset[str] = frozenset()
    regions: Mapping[str, frozenset[str]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Needed:
    """What matters, by role: regions, the states in these and in no smaller one, and what these read."""

    regions: Mapping[str, frozenset[str]]
    states: Mapping[str, frozenset[str]]
    reads: Mapping[str, frozenset[str]]


def needed_for(
    plans: Sequence[Plan],
    asked: Asked,
    fails: Collection[str],
    reaches: Callable[[str, str, str], bool],
    own: Mapping[str, Collection[str]],
    *,
    is_alone: bool = False,
) -> Needed | None:
    """The regions that matter to a question, if not all do; None if all do, or if agents send agent messages.

    Of an agent that `is_alone`, or among others that may say anything, regions do not depend on messages of
    each other: each part in a protocol has its own conversation.

    An activity that has a deadline or is in `fails` matters wherever it is. `reaches` says whether what the
    first role publishes on a channel comes to the second one. What is published on the channels in `own`, by
    role, comes to the agent alone, whenever an activity that writes it is active. So one that never ends need
    not move.
    """
    if not is_alone and any(info.sends or info.receives for plan in plans for info in plan.branches):
        return None
    search = _Search({plan.name: plan for plan in plans}, reaches, own)
    for plan in plans:
        search.states(plan, asked.states.get(plan.name, ()))
        for label in asked.regions.get(plan.name, ()):
            search.add(plan, label)
        endangered = {info.name for info in plan.activities if info.within is not None}.union(fails)
        search.states(plan, (state.label for state in plan.states if state.activity in endangered))
    for name in asked.names:
        search.named(name)
    for channel in asked.channels:
        search.channel(channel)
        for plan in plans:
            search.reads[plan.name].add(channel)
    search.run()
    regions = {
        name: frozenset(label for role, label in search.parts if role == name) for name in search.plans
    }
    if all(len(regions[plan.name]) == len(plan.regions) for plan in plans):
        return None
    states = {
        plan.name: frozenset(
            state.label for state in plan.states if region_of(plan, state.label) in regions[plan.name]
        )
        for plan in plans
    }
    reads = {name: frozenset(found) for name, found in search.reads.items()}
    return Needed(regions, states, reads)


def groups_in(plan: Plan, needed: Callable[[Asked], Needed | None]) -> tuple[Needed, ...]:
    """What matters to each region of a role, where that is less than all. What is part of another is not
    there, and of copies of a part there is one. `needed` says what matters to a question."""
    found: dict[frozenset[str], tuple[str, Needed]] = {}
    for region in plan.regions:
        group = needed(Asked({}, regions={plan.name: frozenset((region.label,))}))
        if group is None:
            return ()
        found.setdefault(group.regions[plan.name], (region.label, group))
    kinds: dict[object, Needed] = {}
    for part, (label, group) in found.items():
        if not any(part < other for other in found):
            kinds.setdefault(_meaning(plan, label, part), group)
    return tuple(kinds.values())


def _meaning(plan: Plan, region: str, part: frozenset[str]) -> object:
    """The same for the regions of an AND that are copies, and depend on none beside them: they differ in
    nothing but their labels. `part` is all that matters to a region."""
    if any(not (is_in(label, region) or is_in(region, label)) for label in part):
        return part
    label = re.compile(rf"(?<![0-9.]){re.escape(region)}(?![0-9])")
    outside = [item for item in plan.transitions if not is_in(item.source, region)]
    if any(label.search(repr((item.into, item.condition, item.actions))) for item in outside):
        return part
    inside = (
        [replace(item, at="") for item in plan.states if is_in(item.label, region)],
        [replace(item, at="", text="") for item in plan.transitions if is_in(item.source, region)],
        [item for item in plan.regions if is_in(item.label, region)],
        [item for item in plan.branches if is_in(item.label, region)],
        [item for item in plan.variables if item.scope is not None and is_in(item.scope, region)],
    )
    return label.sub("", repr(inside)), plan.by_label[region].parent


def region_of(plan: Plan, label: str) -> str:
    """The region in which a state is; the root for what is around all regions."""
    labels = {region.label for region in plan.regions}
    while label not in labels:
        parent = plan.by_label[label].parent
        if parent is None:
            return plan.regions[0].label
        label = parent
    return label


@dataclass(slots=True)
class _Search:
    plans: Mapping[str, Plan]
    reaches: Callable[[str, str, str], bool]
    own: Mapping[str, Collection[str]]
    parts: set[Part] = field(default_factory=set)
    reads: dict[str, set[str]] = field(default_factory=dict)
    _todo: list[Part] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.reads = {name: set() for name in self.plans}

    def run(self) -> None:
        while self._todo:
            role, label = self._todo.pop()
            self._part(self.plans[role], label)

    def add(self, plan: Plan, region: str) -> None:
        """A region matters."""
        part = plan.name, region
        if part not in self.parts:
            self.parts.add(part)
            self._todo.append(part)

    # ---- what something asks for ---------------------------------------------------------------

    def states(self, plan: Plan, labels: Iterable[str]) -> None:
        """These states, and what is inside them."""
        for label in labels:
            self.add(plan, region_of(plan, label))
            for region in plan.regions:
                if is_in(region.label, label):
                    self.add(plan, region.label)

    def named(self, name: str, *, is_whole: bool = False) -> None:
        """A variable or timer of any role: those of all copies of a part, unless the name `is_whole`."""

        def is_it(other: object) -> bool:
            return other == name if is_whole else str(other).partition("@")[0] == name

        plain = name.partition("@")[0]
        for plan in self.plans.values():
            for item in plan.transitions:
                if any(
                    action[0] in ("assign", "start_timer") and is_it(action[1]) for action in item.actions
                ):
                    self.add(plan, region_of(plan, item.source))
            scopes = [item.scope for item in plan.variables if is_it(item.name)]
            writers = {info.name for info in plan.activities if plain in info.variables}
            for state in plan.states:
                if state.activity is not None and (
                    (state.activity in writers and (not is_whole or None in scopes))
                    or any(scope is not None and is_in(state.label, scope) for scope in scopes)
                ):
                    self.add(plan, region_of(plan, state.label))

    def channel(self, channel: str, reader: str | None = None) -> None:
        """What is published on a channel, as far as it comes to the reader, a role."""
        for plan in self.plans.values():
            if reader is not None and not self.reaches(plan.name, reader, channel):
                continue
            writers = {info.name for info in plan.activities if channel in info.writes}
            is_own = channel in self.own[plan.name]
            for state in plan.states:
                if state.activity in writers:
                    region = region_of(plan, state.label)
                    around = plan.by_label[region].parent
                    if is_own and around is not None and is_steady(plan, region):
                        region = region_of(plan, around)
                    self.add(plan, region)
            for item in plan.transitions:
                if any(published(action) == channel for action in item.actions):
                    self.add(plan, region_of(plan, item.source))

    # ---- what a region depends on --------------------------------------------------------------

    def _part(self, plan: Plan, region: str) -> None:
        around = plan.by_label[region].parent
        if around is not None:
            self.add(plan, region_of(plan, around))
        for item in plan.transitions:
            if region_of(plan, item.source) == region:
                self._terms(plan, (item.condition, *item.actions))
                self._events(plan, item)
                if plan.by_label[item.source].type == "AND" and not item.first:
                    self._completion(plan, item.source)
            elif region in (region_of(plan, target) for target in item.targets):
                self.add(plan, region_of(plan, item.source))
        for info in plan.branches:  # what is said in a conversation matters to all of the part in it
            if is_in(region, info.label) or region == region_of(plan, info.label):
                self.states(plan, (info.label,))
        for state in plan.states:
            if state.arguments and region_of(plan, state.label) == region:
                self._terms(plan, [term for _, term in state.arguments])

    def _events(self, plan: Plan, item: Transition) -> None:
        """The regions that raise an event of a transition, and those inside that may take it, or a signal,
        before the transition does."""
        names = {event[1] for event in item.events if event[0] == "raised"}
        signals = set(_signals(item.condition))
        for other in plan.transitions:
            is_inside = other.source != item.source and is_in(other.source, item.source)
            if any(action[0] == "raise" and action[1] in names for action in other.actions) or (
                is_inside
                and (
                    any(event[0] == "raised" and event[1] in names for event in other.events)
                    or not signals.isdisjoint(_signals(other.condition))
                )
            ):
                self.add(plan, region_of(plan, other.source))

    def _completion(self, plan: Plan, label: str) -> None:
        """The regions of an AND that can come to their end: it is complete when all have."""
        inside = plan.children(label)
        if all(plan.can_end(child.label) for child in inside):
            for child in inside:
                self.add(plan, child.label)

    def _terms(self, plan: Plan, terms: Iterable[object]) -> None:
        for term in terms_in(terms):
            match term:
                case ("variable", str() as name, *_):
                    self.named(name, is_whole=True)
                case ("member", _, str() as channel, *_):
                    self.reads[plan.name].add(channel)
                    self.channel(channel, plan.name)
                case ("in" | "done" | "count", str() as name):
                    self.states(plan, _called(plan, name))
                case ("outcome", str() as name):
                    self.states(plan, _called(plan, name))
                case _:
                    pass  # a timer belongs to the region that asks for it


def _signals(condition: object) -> Iterator[str]:
    """The channels with signals that a condition asks for."""
    for term in terms_in([condition]):
        if term[:1] == ("member",) and str(term[2]).split(".", 2)[1] == "signal":
            yield str(term[2])


def _called(plan: Plan, name: str) -> Iterator[str]:
    return (state.label for state in plan.states if name in (state.name, state.activity, state.label))


def is_steady(plan: Plan, region: str) -> bool:
    """Whether a region is one activity that is begun anew for ever."""
    inside = [state for state in plan.states if is_in(state.label, region)]
    is_free = all(
        item.condition is None and not item.events and not item.actions
        for item in plan.transitions
        if is_in(item.source, region)
    )
    return is_free and sum(state.type == "BASIC" for state in inside) == 1 and not plan.can_end(region)


__all__ = ["Asked", "Needed", "groups_in", "is_steady", "needed_for", "region_of"]
