"""Guide: how far a team is from a state that breaks an expectation, for a search that looks there first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from heapq import heappop, heappush

from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in

FAR = 1000
"""What stands for never."""


class Guide:
    """Says how many activities have to end, at the least, before so many agents are in their places.

    It does not ask whether conditions may be true: it is a guess, and says only where to look first.
    """

    def __init__(self, places: Mapping[str, frozenset[str]], least: int, plans: Mapping[str, Plan]) -> None:
        self._least = least
        self._ways = {agent: distances(plans[agent], labels) for agent, labels in places.items() if labels}

    def far(self, agents: Sequence[Agent]) -> int:
        """The guess for what all agents are in now."""
        found = sorted(self._of(agent) for agent in agents if agent.name in self._ways)
        return sum(found[: self._least])

    def _of(self, agent: Agent) -> int:
        if agent.over or agent.down:
            return FAR
        ways = self._ways[agent.name]
        return min((ways.get(leaf, FAR) for leaf in agent.chart.configuration()), default=FAR)


def distances(plan: Plan, labels: frozenset[str]) -> dict[str, int]:
    """For each START, END, CONDITION and activity, how many activities have to end from there on until one of
    these states is active."""
    ways: dict[str, list[tuple[str, int]]] = {}
    """Whence a state is entered at once, with what that takes."""
    for state in plan.states:
        if state.type in ("AND", "OR"):
            continue
        for item in plan.transitions:
            cost = _cost(plan, state.label, item)
            for target in item.targets if cost is not None else ():
                for leaf in _entered(plan, target):
                    ways.setdefault(leaf, []).append((state.label, cost or 0))
    found = {state.label: 0 for state in plan.states if any(is_in(state.label, label) for label in labels)}
    todo = [(0, label) for label in found]
    while todo:
        far, label = heappop(todo)
        if far > found[label]:
            continue
        for before, cost in ways.get(label, ()):
            more = far + cost + (far == 0)  # to get there takes a move in any case
            if more < found.get(before, FAR):
                found[before] = more
                heappush(todo, (more, before))
    return found


def _cost(plan: Plan, leaf: str, item: Transition) -> int | None:
    """How many activities end before a transition is taken while a leaf is active; None: it is not."""
    if not is_in(leaf, item.source) or item.kind != "external":
        return None
    if item.source == leaf:
        return int(plan.by_label[leaf].type == "BASIC" and not item.when and not item.events)
    if item.when or item.events:
        return 0
    state = plan.by_label[leaf]
    while state.label != item.source:  # what is around is complete with its END
        if state.type not in ("END", "OR") or state.parent is None:
            return 1 if plan.by_label[item.source].type == "AND" else None
        if state.type == "OR" and plan.by_label[state.parent].type == "OR":
            return None  # the way on begins at a transition of this state
        state = plan.by_label[state.parent]
    return 0


def _entered(plan: Plan, label: str) -> list[str]:
    """The leaves that are active after a state has been entered."""
    state = plan.by_label[label]
    if state.type not in ("AND", "OR"):
        return [label]
    inside = [child for child in plan.children(label) if state.type == "AND" or child.type == "START"]
    return [leaf for child in inside for leaf in _entered(plan, child.label)]


__all__ = ["Guide"]
