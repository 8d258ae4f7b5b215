"""Several targets of one transition of a `statechart`: each in a region of its own of one AND."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from aseme_dsl.amola.statechart import State, StateType, label_key, lowest_around
from aseme_dsl.compiler.control.control import LabelledLine
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.statecharts import (
    TargetInTarget,
    TargetIsChoice,
    TargetIsRegion,
    TargetsTogether,
    TargetTwice,
    TransitionIntoStart,
    TransitionOfRoot,
)
from aseme_dsl.grammar.text import tree


def around_all(targets: Sequence[tree.Name]) -> str:
    """The label of the state that is entered: the target, or the lowest state around several."""
    return lowest_around([item.text for item in targets])


def into_of(line: LabelledLine) -> tuple[str, ...]:
    """The labels of several targets in document order; nothing for a single one."""
    if not line.others:
        return ()
    return tuple(sorted((item.text for item in (line.target, *line.others)), key=label_key))


def targets_problem(nodes: Mapping[str, State], targets: Sequence[tree.Name]) -> Diagnostic | None:
    """What forbids that the targets, which all exist, are entered together: E613, E409, E603."""
    for item in targets:
        problem = _alone(nodes, item)
        if problem is not None:
            return problem
    for first, second in combinations(targets, 2):
        problem = _together(nodes, first, second)
        if problem is not None:
            return problem
    return None


def _alone(nodes: Mapping[str, State], target: tree.Name) -> Diagnostic | None:
    state = nodes[target.text]
    if state.parent is None:
        return Diagnostic(TransitionOfRoot(), target.span)
    if state.type is StateType.START:
        return Diagnostic(TransitionIntoStart(state.label, state.parent), target.span)
    if state.type is StateType.CONDITION:
        return Diagnostic(TargetIsChoice(state.label, state.parent), target.span)
    around = nodes.get(state.parent)
    if around is not None and around.type is StateType.AND:
        related = (Related(around.span, f"{around.label} is AND"),)
        return Diagnostic(TargetIsRegion(state.label, around.label), target.span, related)
    return None


def _together(nodes: Mapping[str, State], one: tree.Name, other: tree.Name) -> Diagnostic | None:
    place = one.span.to(other.span)
    if one.text == other.text:
        return Diagnostic(TargetTwice(one.text), other.span, (Related(one.span, "the first one"),))
    around = lowest_around((one.text, other.text))
    if around in (one.text, other.text):
        inner = other if around == one.text else one
        return Diagnostic(TargetInTarget(inner.text, around), place)
    state = nodes.get(around)
    if state is None or state.type is StateType.AND:
        return None  # that a state is missing is said (E410)
    parent = nodes.get(state.parent or "")
    parallel = parent.label if parent is not None and parent.type is StateType.AND else None
    related = (Related(state.span, state.label),)
    return Diagnostic(TargetsTogether(one.text, other.text, around, parallel), place, related)


__all__ = ["around_all", "into_of", "targets_problem"]
