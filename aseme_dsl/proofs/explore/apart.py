"""Apart: which agents are looked at apart: those that meet no others, or the first of each role."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.runtime.channel.routes import Routes
from aseme_dsl.runtime.chart.plan import Plan

Team = tuple[tuple[str, str], ...]
"""Agents with their roles."""


def groups_of(team: Team, plans: Mapping[str, Plan]) -> list[Team]:
    """The groups of agents that do not send each other anything.

    Of agents of one role that are alone, and begin alike, there is one, which stands for all.
    """
    routes = Routes()
    for name, role in team:
        routes.add(name, plans[role])
    groups: list[list[tuple[str, str]]] = []
    for agent in team:
        met = [group for group in groups if any(_meet(agent, other, plans, routes) for other in group)]
        groups = [group for group in groups if group not in met]
        groups.append([*(other for group in met for other in group), agent])
    order = {name: place for place, (name, _) in enumerate(team)}
    found = sorted(
        (sorted(group, key=lambda item: order[item[0]]) for group in groups),
        key=lambda group: order[group[0][0]],
    )
    return list(_unlike(found, plans))


def first_of(team: Team) -> Iterator[frozenset[str]]:
    """The names of the first agent of each role, then of the first two, as long as these are not all.

    Nothing obliges the others to move. So a run in which only these do is a run of the team.
    """
    for most in (1, 2):
        places: Counter[str] = Counter()
        found: set[str] = set()
        for name, role in team:
            places[role] += 1
            if places[role] <= most:
                found.add(name)
        if len(found) < len(team):
            yield frozenset(found)


def _unlike(groups: Sequence[Sequence[tuple[str, str]]], plans: Mapping[str, Plan]) -> Iterator[Team]:
    seen: set[object] = set()
    for group in groups:
        name, role = group[0]
        if len(group) == 1:
            begins = role, plans[role].begins(name)
            if begins in seen:
                continue
            seen.add(begins)
        yield tuple(group)


def _meet(one: tuple[str, str], other: tuple[str, str], plans: Mapping[str, Plan], routes: Routes) -> bool:
    first, second = plans[one[1]], plans[other[1]]
    if _protocols(first) & _protocols(second):
        return True
    return any(
        receiver in routes.receivers(sender, channel).names
        for sender, plan, receiver in ((one[0], first, other[0]), (other[0], second, one[0]))
        for channel in _channels(plan)
    )


def _protocols(plan: Plan) -> frozenset[str]:
    """The protocols in which a plan sends or receives agent messages."""
    return frozenset(info.protocol for info in plan.branches if info.sends or info.receives)


def _channels(plan: Plan) -> Iterator[str]:
    """The channels on which something in a plan may publish."""
    for region in plan.regions:
        yield from region.writes
    for info in (*plan.activities, *plan.modules):
        yield from info.writes


__all__ = ["Team", "first_of", "groups_of"]
