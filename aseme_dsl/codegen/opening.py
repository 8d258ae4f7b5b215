"""Opening: the agent messages that can be the first of a conversation which a participant takes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from aseme_dsl.amola.aip import Participant
from aseme_dsl.amola.expression import Received, Send
from aseme_dsl.amola.statechart import Statechart, StateType, Transition
from aseme_dsl.codegen.moves import subchart_of

NOT_UNDERSTOOD = "not_understood"

Kind = tuple[str, str]
"""Performative and message."""


def openings_of(eac: Statechart, participant: Participant) -> tuple[Kind, ...]:
    """The kinds of message that can open a participant's part: those it can receive first, as in `receives`.

    - All conditions count as true, and all activities return.
    - Timers and other events count only if nothing can be received without them.
    - An interrupt (`[>`) counts only if no state inside can receive anything: a `cancel` cannot open the
      process that it cancels.
    - The same holds for a transition with a condition: the condition is meant for a later moment.
    - A message that no transition receives is for the activities, which may receive it from the beginning.
    """
    subchart = subchart_of(eac, participant.name)
    listed = [
        (item.performative, item.message)
        for item in participant.receives
        if item.performative != NOT_UNDERSTOOD  # which answers something
    ]
    if subchart is None:
        return tuple(listed)
    inside = [item for item in eac.transitions if _is_inside(eac, item, subchart.label)]
    found: set[Kind] = set()
    for with_events in (False, True):
        reached = _reached_in_silence(eac, subchart.label, inside, with_events)
        first = [item for item in inside if item.source in reached]
        found = set(_taken(item for item in first if not item.first and not _is_for_later(item, inside)))
        if any(eac.node(label).type is StateType.BASIC for label in reached):
            found |= set(listed) - set(_taken(inside))
        if found or any(_sends(item) for item in first):
            break
        if with_events:
            found = set(_taken(first))
    return tuple(item for item in listed if item in found)


def _is_inside(eac: Statechart, transition: Transition, subchart: str) -> bool:
    return transition.source != subchart and eac.conversation_of(transition) == subchart


def _sends(transition: Transition) -> bool:
    return any(isinstance(action, Send) for action in transition.expression.actions)


def _taken(transitions: Iterable[Transition]) -> Iterator[Kind]:
    for transition in transitions:
        for event in transition.expression.events:
            if isinstance(event, Received):
                yield event.performative, event.message


def _reached_in_silence(
    eac: Statechart, subchart: str, inside: list[Transition], with_events: bool
) -> set[str]:
    """The states that can be active while the participant has neither taken nor sent a message."""
    reached = _entered(eac, subchart)
    changed = True
    while changed:
        changed = False
        for item in inside:
            if (
                item.changes_state
                and item.source in reached
                and item.target not in reached
                and _is_silent(item, with_events)
                and not _is_for_later(item, inside)
            ) and _is_complete(eac, item, reached):
                reached |= {item.target}.union(*(_entered(eac, label) for label in eac.entries_of(item)))
                changed = True
    return reached


def _is_for_later(transition: Transition, inside: list[Transition]) -> bool:
    """Whether a transition interrupts, under a condition, what can take a message itself."""
    expression = transition.expression
    if expression.guard is None or not (expression.events or expression.when):
        return False
    within = f"{transition.source}."
    return any(item.source.startswith(within) and any(_taken([item])) for item in inside)


def _is_silent(transition: Transition, with_events: bool) -> bool:
    expression = transition.expression
    if _sends(transition):
        return False
    events = expression.events
    is_other = with_events and any(not isinstance(event, Received) for event in events)
    return not events or expression.when or is_other


def _is_complete(eac: Statechart, transition: Transition, reached: set[str]) -> bool:
    """Whether what a transition leaves may be complete, where it waits for that."""
    node, expression = eac.node(transition.source), transition.expression
    if expression.events or expression.when or eac.is_branch(node):
        return True  # a conversation inside may be over
    if node.type is StateType.OR:
        end = eac.end_of(node.label)
        return end is not None and end.label in reached
    if node.type is StateType.AND:
        ends = [eac.end_of(child.label) for child in eac.children(node.label)]
        return all(end is not None and end.label in reached for end in ends)
    return True


def _entered(eac: Statechart, label: str) -> set[str]:
    """A state and all that is entered with it."""
    found: set[str] = set()
    todo = [label]
    while todo:
        node = eac.node(todo.pop())
        found.add(node.label)
        if node.type is StateType.AND:
            todo += [child.label for child in eac.children(node.label)]
        elif node.type is StateType.OR:
            start = eac.start_of(node.label)
            todo += [] if start is None else [start.label]
    return found


__all__ = ["openings_of"]
