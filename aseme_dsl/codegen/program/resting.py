"""Finds the states that can be active between two rounds: only these need a number.

A START whose first transition is always enabled is exited in the next round. So is an END if this holds for
the state around it. The class for programs without agents takes such a transition together with the one
before it. This is not observable unless an expression asks for the state of another region; in such a
statechart no state is passed.
"""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.expression import NEVER, Failed, Outcome, StateValue, TransitionExpression
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Resting:
    """Facts about a statechart that determine its numbering.

    `asked`: an expression asks for the state of other regions. `passed` has, for each START and END that is
    exited at once, the transition taken. `reached` are the leaves that may become active. `completing` are
    the BASIC states of which the program must know whether their activity has returned.
    """

    asked: bool
    passed: dict[str, Transition]
    reached: frozenset[str]
    completing: frozenset[str]

    def width(self, leaf: State) -> int:
        """How many numbers a leaf needs."""
        if leaf.label in self.passed or leaf.label not in self.reached:
            return 0
        return 2 if leaf.label in self.completing else 1


def resting(chart: Statechart, *, watched: bool) -> Resting:
    """The facts about a chart; `watched`: the program calls a method of each activity that it cancels."""
    asked = any(isinstance(value, StateValue | Outcome) for _, value in chart.values())
    failing = any(isinstance(e, Failed) for item in chart.transitions for e in item.expression.events)
    passed = {} if asked else _passed(chart)
    reached = _reached(chart)
    completing = {
        node.label
        for node in chart.states
        if node.type is StateType.BASIC
        and (
            watched or asked or failing or any(_needs_completion(item) for item in chart.outgoing(node.label))
        )
    }
    return Resting(asked, passed, reached, frozenset(completing))


def is_open(expression: TransitionExpression) -> bool:
    """Whether nothing but completion is needed."""
    return not expression.events and expression.guard is None and expression.every is None


def _needs_completion(transition: Transition) -> bool:
    return not transition.expression.events and not transition.expression.when


def _passed(chart: Statechart) -> dict[str, Transition]:
    found: dict[str, Transition] = {}
    for node in chart.states:
        if node.type is StateType.START:
            source = node.label
            around = list(chart.ancestors(node.label))
        elif node.type is StateType.END and node.parent is not None and not chart.is_region(node.parent):
            source = node.parent
            around = list(chart.ancestors(node.label))
            if len(chart.outgoing(source)) != 1:
                continue
        else:
            continue
        if any(item.first for state in around for item in chart.outgoing(state.label)):
            continue
        first = next(iter(chart.outgoing(source)), None)
        if (
            first is not None
            and first.kind is TransitionKind.EXTERNAL
            and is_open(first.expression)
            and chart.node(first.target).type is not StateType.CONDITION
        ):
            found[node.label] = first
    return {label: way for label, way in found.items() if not _comes_back(chart, found, label)}


def _comes_back(chart: Statechart, passed: dict[str, Transition], label: str) -> bool:
    """Whether passing from one to the next leads to where it began, without a rest."""
    seen: set[str] = set()
    stack = [label]
    while stack:
        for entered in _entered(chart, passed[stack.pop()].target):
            if entered == label:
                return True
            if entered in passed and entered not in seen:
                seen.add(entered)
                stack.append(entered)
    return False


def _entered(chart: Statechart, target: str) -> Iterable[str]:
    """The leaves that become active as a state is entered."""
    stack = [target]
    while stack:
        label = stack.pop()
        node = chart.node(label)
        if node.type is StateType.OR:
            start = chart.start_of(label)
            if start is not None:
                yield start.label
        elif node.type is StateType.AND:
            stack += [inner.label for inner in chart.children(label)]
            yield label
        else:
            yield label


def _reached(chart: Statechart) -> frozenset[str]:
    """The leaves that become active if every condition may hold, every event come, every activity return."""
    reached: set[str] = set()
    stack = list(_entered(chart, chart.root.label))
    waiting: set[str] = set()
    """ANDs whose completion must be looked at again."""
    while True:
        while stack:
            label = stack.pop()
            if label in reached:
                continue
            reached.add(label)
            waiting.update(s.label for s in chart.ancestors(label) if s.type is StateType.AND)
            for source in (label, *(state.label for state in chart.ancestors(label))):
                for transition in _ways(chart, source, reached):
                    stack += _targets(chart, transition)
        for label in sorted(waiting):
            for transition in _ways(chart, label, reached):
                stack += [target for target in _targets(chart, transition) if target not in reached]
        if not any(label not in reached for label in stack):
            return frozenset(reached)


def _ways(chart: Statechart, source: str, reached: set[str]) -> Iterable[Transition]:
    """The transitions of a source that may be taken."""
    for transition in chart.outgoing_edges(source):
        if transition.expression is NEVER:
            continue
        if not _needs_completion(transition) or _may_complete(chart, source, reached):
            yield transition


def _may_complete(chart: Statechart, label: str, reached: set[str]) -> bool:
    node = chart.node(label)
    if node.type is StateType.OR:
        end = chart.end_of(label)
        return end is not None and end.label in reached
    if node.type is StateType.AND:
        ends = [chart.end_of(region.label) for region in chart.children(label)]
        return all(end is not None and end.label in reached for end in ends)
    return True  # what waits for a state that never completes is numbered, too


def _targets(chart: Statechart, transition: Transition) -> list[str]:
    """The leaves that a transition, with the choices that it leads to, may make active."""
    found: list[str] = []
    stack = [transition.target]
    seen: set[str] = set()
    while stack:
        label = stack.pop()
        if chart.node(label).type is not StateType.CONDITION:
            found += _entered(chart, label)
        elif label not in seen:
            seen.add(label)
            stack += [branch.target for branch in chart.outgoing_edges(label)]
    return found


__all__ = ["Resting", "is_open", "resting"]
