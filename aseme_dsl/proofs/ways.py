"""Ways: how a state can be left, through the choices behind it, and what else may take it away."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.statechart import Statechart, StateType, Transition
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Path:
    """One compound transition: its segments, from a state to a state."""

    segments: tuple[Transition, ...]

    @property
    def conditions(self) -> tuple[e.Value, ...]:
        """All of them must hold; `else` counts as none, since it comes last."""
        found = (segment.expression.condition for segment in self.segments)
        return tuple(condition for condition in found if condition is not None)

    @property
    def events(self) -> frozenset[str]:
        """The events that it waits for, as they are written."""
        return frozenset(_event(event) for item in self.segments for event in item.expression.events)

    @property
    def interrupts(self) -> bool:
        """Whether it waits for nothing but its conditions, not even for completion."""
        return not self.events and any(segment.expression.when for segment in self.segments)


@dataclass(frozen=True, slots=True)
class Fork:
    """Transitions with one source and one trigger, in the order in which they are tried.

    `before` are the conditions on the way to the source; `trigger` is what they wait for: nothing (the
    completion of what is before), "when", or the events.
    """

    state: str
    """The state in which is waited."""
    source: str
    """The state or the choice."""
    before: tuple[e.Value, ...]
    trigger: frozenset[str]
    branches: tuple[Transition, ...]


WHEN = frozenset({"when"})
COMPLETION: frozenset[str] = frozenset()

MOST = 200
"""How many compound transitions of one state are looked at: choices behind choices multiply."""


def paths(chart: Statechart, source: str) -> tuple[Path, ...]:
    """The compound transitions out of a state, in the order in which they are tried: the first MOST."""
    found: list[Path] = []
    stack: list[tuple[Transition, ...]] = [
        (item,) for item in reversed(chart.outgoing_edges(source)) if not item.reactive
    ]
    while stack and len(found) < MOST:
        segments = stack.pop()
        target = segments[-1].target
        if chart.node(target).type is not StateType.CONDITION:
            found.append(Path(segments))
        elif target not in [segment.source for segment in segments]:
            stack += [(*segments, following) for following in reversed(chart.outgoing_edges(target))]
    return tuple(found)


def trigger_of(transition: Transition, at_once: bool) -> frozenset[str]:
    """What a transition waits for; `at_once`: its source is always complete, so that `when` says nothing."""
    events = frozenset(_event(event) for event in transition.expression.events)
    if events:
        return events
    return WHEN if transition.expression.when and not at_once else COMPLETION


def forks(chart: Statechart) -> Iterator[Fork]:
    """Every place where transitions wait for the same, from every state in which is waited."""
    for node in chart.states:
        if node.type in (StateType.CONDITION, StateType.END):
            continue
        stack: list[tuple[str, tuple[e.Value, ...], frozenset[str]]] = [(node.label, (), frozenset())]
        number = 0
        while stack and number < MOST:
            label, before, passed = stack.pop()
            at_once = node.type is StateType.START or label != node.label
            groups: dict[frozenset[str], list[Transition]] = {}
            for transition in chart.outgoing(label):
                if transition.expression is e.NEVER or transition.reactive:
                    continue
                if not transition.changes_state:  # it takes nothing from the others, nor they from it
                    number += 1
                    yield Fork(node.label, label, before, trigger_of(transition, at_once), (transition,))
                    continue
                groups.setdefault(trigger_of(transition, at_once), []).append(transition)
                if chart.node(transition.target).type is StateType.CONDITION:
                    condition = transition.expression.condition
                    after = before if condition is None else (*before, condition)
                    if transition.target not in passed:
                        stack.append((transition.target, after, passed | {transition.target}))
            for trigger, branches in groups.items():
                number += 1
                yield Fork(node.label, label, before, trigger, tuple(branches))


def interruptions(chart: Statechart, state: str) -> tuple[Path, ...]:
    """The ways by which the states around `state` may be left while it waits."""
    return tuple(
        path
        for around in chart.ancestors(state)
        for path in paths(chart, around.label)
        if path.events or path.interrupts
    )


def _event(event: e.Event) -> str:
    """An event as it is written, without the name that the line gives to the message it takes."""
    return e.event_text(replace(event, name="") if isinstance(event, e.Received | e.Lost) else event)


__all__ = ["COMPLETION", "MOST", "WHEN", "Fork", "Path", "forks", "interruptions", "paths", "trigger_of"]
