"""Follows: which transitions of a chart follow each other with no state between, from the chart alone."""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.endings import Endings


class Follows:
    """What can follow each transition at once inside `top`; read from the chart, not from a drawing of it."""

    def __init__(self, chart: Statechart, top: str = "") -> None:
        self._chart = chart
        self._top = top
        places = {id(item): place for place, item in enumerate(chart.transitions)}
        self._out: dict[str, tuple[int, ...]] = {
            state.label: tuple(
                places[id(item)] for item in chart.outgoing_edges(state.label) if not item.reactive
            )
            for state in chart.states
        }
        never = Endings(chart).never
        self.after = tuple(frozenset(self._of(place)) - never for place in range(len(chart.transitions)))
        self.never = never

    def _of(self, place: int) -> tuple[int, ...]:
        chart = self._chart
        target = chart.node(chart.transitions[place].target)
        if chart.transitions[place].reactive or not chart.transitions[place].changes_state:
            return ()
        match target.type:
            case StateType.OR:
                start = chart.start_of(target.label)
                return () if start is None else self._out[start.label]
            case StateType.CONDITION | StateType.START:
                return self._out[target.label]
            case StateType.END:
                parent = target.parent
                if parent is None or parent == self._top or chart.is_region(parent):
                    return ()
                return tuple(item for item in self._out[parent] if not self.is_event(item))
            case StateType.BASIC | StateType.AND:
                return ()

    def is_event(self, place: int) -> bool:
        """Whether a transition leaves a group from its border: it does not wait until that is complete."""
        expression = self._chart.transitions[place].expression
        return bool(expression.events) or expression.when
