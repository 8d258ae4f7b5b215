"""History: the composites that are resumed, and the states with something to do when they are exited."""

from __future__ import annotations

from functools import cached_property

from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.program.flat import FlatChart, FlatRegion


class History:
    """What a statechart keeps of composites that are exited, so that they can be resumed (deep history)."""

    def __init__(self, flat: FlatChart) -> None:
        self._flat = flat
        self._chart = flat.chart

    @cached_property
    def leaving(self) -> tuple[State, ...]:
        """The composites with code for their exit: participant subcharts, and states with an `exit` line."""
        return tuple(
            node
            for node in self._chart.states
            if node.type is StateType.OR and (self._chart.is_branch(node) or self._chart.exits_of(node.label))
        )

    @cached_property
    def resumed(self) -> tuple[State, ...]:
        """The composites that some transition resumes."""
        labels = {transition.target for transition in self._chart.transitions if transition.resume}
        return tuple(
            node for node in self._chart.states if node.label in labels and node.type is StateType.OR
        )

    @cached_property
    def suspended(self) -> tuple[State, ...]:
        """The participant subcharts that are resumed, or are inside a composite that is resumed."""
        return tuple(
            branch
            for branch in self._flat.branches
            if any(f"{branch.label}.".startswith(f"{node.label}.") for node in self.resumed)
        )

    def suspends(self, node: State) -> bool:
        """Whether a composite is resumed, and is or contains a participant subchart."""
        return node in self.resumed and any(
            f"{branch.label}.".startswith(f"{node.label}.") for branch in self.suspended
        )

    @cached_property
    def entered_again(self) -> tuple[FlatRegion, ...]:
        """The regions inside resumed composites, except those in participant subcharts inside these."""
        return tuple(
            region
            for region in self._flat.regions
            if any(
                region.label.startswith(f"{node.label}.")
                and self._chart.branch_of(region.label) == self._chart.branch_of(node.label)
                for node in self.resumed
            )
        )


__all__ = ["History"]
