"""Preparing: messages that are sent without content, and that nothing before can have prepared (W576)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.expression import Received, Send
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.codegen.moves import subchart_of
from aseme_dsl.codegen.opening import openings_of
from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.diagnostics.problems.talk import ContentNotPrepared
from aseme_dsl.source import Span

ACTIVITY = "activity "
"""Stands before the name of an activity, which may prepare any message, among the types of messages."""
_HEAD = re.compile(r"send\s+\w+\s+[\w.]+")
"""A `send` up to the place of its content."""


def check_prepared(aips: Iterable[Aip], eacs: Mapping[str, Statechart | None]) -> Iterator[Diagnostic]:
    """W576 for a `send` without braces before any activity, and before any message of its type.

    Who opens conversations may have prepared a message before its part begins, and is not looked at.
    """
    for aip in aips:
        eac = eacs.get(aip.name)
        if eac is None:
            continue
        for participant in aip.participants:
            subchart = subchart_of(eac, participant.name)
            if subchart is not None and openings_of(eac, participant):
                for way, send, activities in bare_sends(eac, subchart):
                    if not activities:
                        ends = eac.node(way.target).type is StateType.END
                        problem = ContentNotPrepared(send.performative, send.message, ends)
                        yield Diagnostic(problem, send.span, edits=with_defaults(send.span))


def with_defaults(send: Span) -> tuple[Edit, ...]:
    """The change that lets a `send` without content say the defaults."""
    head = _HEAD.match(send.text)
    if head is None:
        return ()
    place = send.start + head.end()
    return (Edit(Span(send.source, place, place), " { .. }"),)


def bare_sends(eac: Statechart, subchart: State) -> Iterator[tuple[Transition, Send, frozenset[str]]]:
    """Each `send` without content that no message of its type comes before, with the activities that may.

    Without anything before it, a `send` is left out: its content may come from outside of the part.
    """
    for way, send, there in all_bare_sends(eac, subchart):
        if there:
            names = {name for name in there if name.startswith(ACTIVITY)}
            yield way, send, frozenset(name.removeprefix(ACTIVITY) for name in names)


def all_bare_sends(eac: Statechart, subchart: State) -> Iterator[tuple[Transition, Send, frozenset[str]]]:
    """Each `send` without content that no message of its type comes before, with all that may come before."""
    within = f"{subchart.label}."
    nodes = [node for node in eac.states if node.label.startswith(within)]
    ways = [item for item in eac.transitions if item.source.startswith(within)]
    if not any(_bare(item) for item in ways):
        return
    inner = {node.label: _inside(node.label, nodes, ways) for node in nodes}
    known: dict[str, set[str]] = {node.label: set() for node in nodes}
    known[subchart.label] = set()
    changed = True
    while changed:
        before = sum(map(len, known.values()))
        for node in nodes:
            around = eac.node(node.parent or subchart.label)
            if around.type is StateType.AND:
                known[node.label] |= known[around.label]
                for other in eac.children(around.label):
                    known[node.label] |= inner[other.label] if other is not node else set()
            elif node.type is StateType.START:
                known[node.label] |= known[around.label]
        for item in ways:
            if item.target in known:
                known[item.target] |= known[item.source] | inner[item.source] | _said(item)
        changed = before != sum(map(len, known.values()))
    for item in ways:
        there = known[item.source] | inner[item.source]
        there |= {event.message for event in item.expression.events if isinstance(event, Received)}
        for action in item.expression.actions:
            if isinstance(action, Send):
                if action.fills is None and action.message not in there:
                    yield item, action, frozenset(there)
                there.add(action.message)


def _bare(transition: Transition) -> bool:
    return any(isinstance(item, Send) and item.fills is None for item in transition.expression.actions)


def _said(transition: Transition) -> set[str]:
    """The types of the messages that a transition takes or sends."""
    expression = transition.expression
    taken = {event.message for event in expression.events if isinstance(event, Received)}
    return taken | {action.message for action in expression.actions if isinstance(action, Send)}


def _inside(label: str, nodes: Iterable[State], ways: Iterable[Transition]) -> set[str]:
    """What may have been said in a state, or been done, when it is left."""
    found: set[str] = set()
    for node in nodes:
        if node.activity and (node.label == label or node.label.startswith(f"{label}.")):
            found.add(f"{ACTIVITY}{node.activity}")
    for item in ways:
        if item.source.startswith(f"{label}."):
            found |= _said(item)
    return found


__all__ = ["ACTIVITY", "all_bare_sends", "bare_sends", "check_prepared", "with_defaults"]
