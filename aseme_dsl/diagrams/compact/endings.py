"""Endings: which states can be complete, and which transitions can therefore never be taken."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.statechart import Statechart, StateType


class Endings:
    """What the transitions of a chart allow if any condition may hold."""

    def __init__(self, chart: Statechart) -> None:
        self._chart = chart
        self._complete: dict[str, bool] = {}
        self._entered: dict[str, list[str]] = {}
        """Of each OR state: the states in it at which transitions from outside begin."""
        for item in chart.transitions:
            scope = f"{chart.scope_of(item)}."
            for label in item.targets if item.changes_state else ():
                around = chart.node(label).parent
                while around is not None and around.startswith(scope):
                    self._entered.setdefault(around, []).append(label)
                    label, around = around, chart.node(around).parent
        for state in reversed(chart.states):  # what is inside comes first
            self._complete[state.label] = self._completes(state.label)
        self.never = frozenset(
            place
            for place, item in enumerate(chart.transitions)
            if item.changes_state and not item.reactive and not self._open(place)
        )

    def completes(self, label: str) -> bool:
        """Whether a state can be complete."""
        return self._complete[label]

    def _completes(self, label: str) -> bool:
        chart = self._chart
        state = chart.node(label)
        inside = chart.children(label)
        match state.type:
            case StateType.BASIC:
                return not state.waits
            case StateType.AND:
                return all(self._complete[item.label] for item in inside)
            case StateType.OR:
                return any(chart.node(item).type is StateType.END for item in self._reached(label))
            case _:
                return True

    def _reached(self, label: str) -> Iterator[str]:
        start = self._chart.start_of(label)
        waiting = [start.label] if start is not None else []
        waiting += self._entered.get(label, ())
        seen = set(waiting)
        while waiting:
            source = waiting.pop()
            yield source
            for item in self._chart.outgoing_edges(source):
                waits = not item.expression.events and not item.expression.when
                inside = self._chart.node(item.target).parent == label
                if inside and item.target not in seen and (self._complete[source] or not waits):
                    seen.add(item.target)
                    waiting.append(item.target)

    def _open(self, place: int) -> bool:
        item = self._chart.transitions[place]
        return bool(item.expression.events) or item.expression.when or self._complete[item.source]


__all__ = ["Endings"]
