"""Walking a statechart with free choices: which words of completed activities it allows.

Guards, events and priorities are ignored: whatever is complete may go any of its ways.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from aseme_dsl.amola.statechart import Statechart, StateType

Configuration = Any
"""A BASIC state: whether it is complete; an OR: its active child with that one's; an AND: its regions'."""


def words(chart: Statechart, longest: int) -> tuple[set[str], set[str]]:
    """All words up to a length that the chart may begin, and those with which its root may be complete.

    Activities are single letters.
    """
    root = chart.root.label
    begun, ended = set(), set()
    waiting = [("", _at_rest(chart, {_entered(chart, root)}))]
    while waiting:
        word, configurations = waiting.pop()
        begun.add(word)
        if any(_is_complete(chart, root, item) for item in configurations):
            ended.add(word)
        if len(word) == longest:
            continue
        following: dict[str, set[Configuration]] = {}
        for item in configurations:
            for letter, moved in _moves(chart, root, item):
                if letter:
                    following.setdefault(letter, set()).add(moved)
        waiting += [(word + letter, _at_rest(chart, moved)) for letter, moved in following.items()]
    return begun, ended


def _at_rest(chart: Statechart, configurations: set[Configuration]) -> set[Configuration]:
    """All that can be reached without completing an activity."""
    found = set(configurations)
    waiting = list(found)
    while waiting:
        for letter, moved in _moves(chart, chart.root.label, waiting.pop()):
            if not letter and moved not in found:
                found.add(moved)
                waiting.append(moved)
    return found


def _entered(chart: Statechart, label: str) -> Configuration:
    match chart.node(label).type:
        case StateType.OR:
            start = chart.start_of(label)
            assert start is not None
            return (start.label, None)
        case StateType.AND:
            return tuple(_entered(chart, child.label) for child in chart.children(label))
        case StateType.BASIC:
            return False
    return None


def _is_complete(chart: Statechart, label: str, configuration: Configuration) -> bool:
    match chart.node(label).type:
        case StateType.OR:
            return chart.node(configuration[0]).type is StateType.END
        case StateType.AND:
            children = chart.children(label)
            return all(_is_complete(chart, c.label, i) for c, i in zip(children, configuration, strict=True))
        case StateType.BASIC:
            return bool(configuration)
    return True


def _moves(
    chart: Statechart, label: str, configuration: Configuration
) -> Iterator[tuple[str, Configuration]]:
    match chart.node(label).type:
        case StateType.BASIC:
            if not configuration:
                yield chart.node(label).activity or "", True
        case StateType.AND:
            for place, child in enumerate(chart.children(label)):
                for letter, moved in _moves(chart, child.label, configuration[place]):
                    yield letter, (*configuration[:place], moved, *configuration[place + 1 :])
        case StateType.OR:
            active, inner = configuration
            for letter, moved in _moves(chart, active, inner):
                yield letter, (active, moved)
            if _is_complete(chart, active, inner):
                for transition in chart.outgoing(active):
                    yield "", (transition.target, _entered(chart, transition.target))
