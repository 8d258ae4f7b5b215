"""Outside: which agents that nothing pending can wake only wait for an input from outside of the team.

Such an agent waits for an event, for a message on a channel on which the team does not publish, or for
another agent that does so. All others wait for each other.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Transition

_COUNTS = ("invited", "answered", "all_answered")


@dataclass(frozen=True, slots=True)
class Need:
    """What a state needs: a message of its conversation, an event, or a message on one of the channels."""

    conversation: str | None
    message: bool
    events: frozenset[str]
    channels: frozenset[str]


def need_of(plan: Plan, label: str, conversation: str | None, *, complete: bool) -> Need:
    """What a state needs, or the innermost one around it that waits for anything."""
    message = False
    events: set[str] = set()
    channels: set[str] = set()
    around: str | None = label
    while around is not None and not (message or events or channels):
        for way in _ways(plan, around, complete=complete):
            kinds = {item[0] for item in way.events}
            asked = tuple(_asked(way.condition))
            message = message or not kinds.isdisjoint(("received", "lost")) or None in asked
            events.update(str(item[1]) for item in way.events if item[0] == "raised")
            channels.update(channel for channel in asked if channel is not None)
        around, complete = plan.by_label[around].parent, False
    return Need(conversation, message, frozenset(events), frozenset(channels))


def _ways(plan: Plan, label: str, *, complete: bool) -> Iterator[Transition]:
    """The transitions of a state, and of the choices to which they lead; not those that ignore a signal."""
    seen = {label}
    waiting = [
        way
        for _, way in plan.outgoing(label)
        if way.kind == "external" or (way.kind == "on" and (way.actions or way.events))
        if complete or way.events or way.when
    ]
    while waiting:
        way = waiting.pop()
        yield way
        if plan.by_label[way.target].type == "CONDITION" and way.target not in seen:
            seen.add(way.target)
            waiting += (item for _, item in plan.outgoing(way.target) if item.kind == "external")


def _asked(condition: object) -> Iterator[str | None]:
    """The channels that a condition reads, and None where it counts answers."""
    waiting = [condition]
    while waiting:
        term = waiting.pop()
        if isinstance(term, tuple):
            if term[:1] == ("member",):
                yield str(term[2])
            elif term and term[0] in _COUNTS:
                yield None
            waiting += term


def wait_for_input(
    needs: Mapping[str, Collection[Need]], writers: Mapping[str, Collection[str]]
) -> frozenset[str]:
    """The agents of which an input from outside may meet every need, directly or through other agents.

    `writers` are the agents that may publish on a channel; none where an input may come, too.
    """
    places = [(agent, number, need) for agent, own in needs.items() for number, need in enumerate(own)]
    met: set[tuple[str, int]] = set()
    by: list[tuple[str, Need]] = []
    before = -1
    while len(met) != before:
        before = len(met)
        for agent, number, need in places:
            if (agent, number) not in met and _is_met(agent, need, by, writers):
                met.add((agent, number))
                by.append((agent, need))
    return frozenset(
        agent
        for agent, own in needs.items()
        if own and all((agent, place) in met for place in range(len(own)))
    )


def _is_met(
    agent: str, need: Need, by: Collection[tuple[str, Need]], writers: Mapping[str, Collection[str]]
) -> bool:
    """Whether an input from outside meets a need, or one of those whose needs it meets can."""
    if need.events or any(not writers.get(channel) for channel in need.channels):
        return True
    if any(other in writers[channel] for channel in need.channels for other, _ in by):
        return True
    if need.message:
        return any(other != agent and met.conversation == need.conversation is not None for other, met in by)
    return not need.channels and any(other == agent for other, _ in by)


__all__ = ["Need", "need_of", "wait_for_input"]
