"""Comparison: whether a compiled statechart is the one that a foreign file has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from aseme_dsl.amola.original_names import labels_as_original
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.interop.emf.charts import ForeignChart


def differences(ours: Statechart, theirs: ForeignChart) -> Iterator[str]:
    """What differs in labels, types and transitions: a line each. Nothing for the same chart."""
    types = {state.label: state.type for state in ours.states}
    wanted = {state.label: state.type for state in theirs.states}
    for label in sorted(types.keys() | wanted.keys()):
        if types.get(label) is not wanted.get(label):
            yield f"state {label}: {wanted.get(label, 'none')}, here {types.get(label, 'none')}"
    edges = Counter((item.source, item.target) for item in ours.transitions if item.changes_state)
    expected = Counter((item.source, item.target) for item in theirs.transitions)
    for edge in sorted(edges.keys() | expected.keys()):
        if edges[edge] != expected[edge]:
            yield f"transition {edge[0]} -> {edge[1]}: {expected[edge]}, here {edges[edge]}"


def other_names(ours: Statechart, theirs: ForeignChart) -> Iterator[str]:
    """The labels of states that have another name here, spelled as the originals did."""
    names = {state.label: state.name for state in labels_as_original(ours).states}
    for state in theirs.states:
        points = (StateType.START, StateType.END, StateType.CONDITION)
        if state.type not in points and state.name and names.get(state.label) != state.name:
            yield state.label


__all__ = ["differences", "other_names"]
