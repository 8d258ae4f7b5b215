"""Question: what is asked of an agent, and what that means in its statechart."""

from __future__ import annotations

from collections.abc import Collection
from difflib import get_close_matches

from aseme_dsl.play.asking.names import named
from aseme_dsl.play.asking.sending import places, published, sent_of
from aseme_dsl.play.asking.ways import Goal
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, State

DEPTH = 4
"""So many agents are asked one for the other why they have not sent something, if nothing else is said."""


@dataclass(frozen=True, slots=True)
class Question:
    """Why an agent has done something by a time (ns), or why not.

    `what` is a state, a transition, an agent message or a channel. Where a message of another agent has not
    come, that agent is asked why, and so on, `depth` times.
    """

    agent: str
    what: str
    at: int
    is_why: bool
    depth: int = DEPTH


class NotAsked(Exception):
    """The statechart has nothing of that name; the text says what it has."""


def goal_of(plan: Plan, asked: str) -> Goal:
    """What a text asks for: `State`, `State -> State`, `inform Done`, or a channel `team.signal.Pass`.

    Raises:
        NotAsked: there is no such state, transition or message.
    """
    text = " ".join(asked.split())
    if "->" in text:
        return _transition(plan, *(part.strip() for part in text.split("->", 1)))
    states = _called(plan, text)
    if states:
        return Goal(frozenset(state.label for state in states))
    return _message(plan, text)


def _called(plan: Plan, name: str) -> list[State]:
    """The states of a name: their own, that of their activity, their label, or one behind that of a part."""
    found = [item for item in plan.states if name in (item.name, item.activity, item.label)]
    if not found and any(mark in name for mark in ("[", " (", " in ")):
        found = [item for item in plan.states if named(plan, item.label) == name]
    if found or not 0 < name.count(".") <= len(plan.states):
        return found
    around, _, inner = name.rpartition(".")
    outer = _called(plan, around)
    return [
        item for item in _called(plan, inner) if any(item.label.startswith(f"{one.label}.") for one in outer)
    ]


def _transition(plan: Plan, source: str, target: str) -> Goal:
    sources, targets = (
        {item.label for item in _called(plan, name) or _pointed(plan, name)} for name in (source, target)
    )
    for name, found in ((source, sources), (target, targets)):
        if not found:
            raise NotAsked(_unknown(plan, name))
    numbers = {
        number
        for number, item in enumerate(plan.transitions)
        if item.kind == "external"
        and item.source in sources
        and not targets.isdisjoint((item.target, *item.into))
    }
    if not numbers:
        text = f"no transition of {plan.name} leads from {source} to {target} at once: ask for {target}"
        raise NotAsked(text)
    return Goal(transitions=frozenset(numbers))


def _pointed(plan: Plan, name: str) -> list[State]:
    """The states that people call so: `start of Play`."""
    return [item for item in plan.states if plan.called(item) == name]


def _message(plan: Plan, text: str) -> Goal:
    """What sends an agent message, or publishes on a channel: transitions, states of activities, modules."""
    sent = sent_of(text)
    found = tuple(places(plan, sent))
    if not found:
        raise NotAsked(_unknown(plan, text))
    states = frozenset(item.label for item in found if item.transition is None and not item.is_module)
    numbers = frozenset(item.transition for item in found if item.transition is not None)
    modules = tuple(item.called for item in found if item.is_module)
    channel = "" if sent[0] else sent[1]
    return Goal(states, numbers, by_code=bool(states or modules), modules=modules, channel=channel)


def _unknown(plan: Plan, name: str) -> str:
    names = sorted({item.name for item in plan.states if item.name.isidentifier()})
    if " " in name or name.count(".") > 1:
        sent = {" ".join(kind) for info in plan.branches for kind in info.sends}
        return _listed(plan, name, "it sends", sent | set(published(plan)))
    return _listed(plan, name, "its states are", names)


def _listed(plan: Plan, name: str, told: str, names: Collection[str]) -> str:
    near = get_close_matches(name, names, 1)
    listed = f"{told} {', '.join(sorted(names)) or 'none'}"
    hint = f"did you mean {near[0]}?" if near else listed
    return f"{plan.name} has no state, transition or message {name}: {hint}"


__all__ = ["DEPTH", "NotAsked", "Question", "goal_of"]
