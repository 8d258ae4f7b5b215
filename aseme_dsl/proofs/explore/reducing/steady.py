"""Steady: activities that are begun anew for ever, and whose ends change nothing.

When such a one ends, its agent steps, and what may have come by then is there. But that may be there at any
moment: a move of its own lets the agent step with it. So the end has one outcome more than that move. It
leads back, as nothing new is there. If it is found, the others need no moves.

That is so for an activity that is alone in a region, without conditions around it, if nothing asks where the
region is, or how the activity has ended. It writes no variable, and sends nothing. What it publishes comes to
its agent alone, at any moment while the activity is active. How long it takes, and whether it may fail, makes
no difference: these are moves of their own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import cast

from aseme_dsl.proofs.explore.coming import Coming
from aseme_dsl.proofs.explore.deciding.acting import Acting
from aseme_dsl.proofs.explore.needed import is_steady
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.plan import Plan, is_in, terms_of


class Steady:
    """Knows which ends change nothing."""

    def __init__(self, plans: Sequence[Plan], coming: Coming, acting: Acting, is_timed: bool) -> None:
        self._coming = coming
        self._acting = acting
        self._labels = {
            plan.name: frozenset[str]() if is_timed else frozenset(_steady(plan)) for plan in plans
        }

    def is_idle(self, execution: Execution) -> bool:
        """Whether the end of an activity leads back, or does what another move does."""
        agent = cast("Agent", execution.owner.agent)
        info = execution.info
        return (
            execution.label in self._labels[agent.role]
            and self._coming.has_more(agent.name)
            and not execution.branch
            and not self._acting.written(agent, execution, is_end=True)
            and all(
                not self._acting.matters(channel) or self._coming.is_new(agent, channel)
                for channel in info.writes
            )
        )


def _steady(plan: Plan) -> Iterator[str]:
    """The states of activities that are alone in their regions and begun anew for ever."""
    asked = {
        str(term[1]) for term in terms_of(plan) if term[:1] in (("in",), ("done",), ("count",), ("outcome",))
    }
    for region in plan.regions:
        if is_steady(plan, region.label):
            inside = [state for state in plan.states if is_in(state.label, region.label)]
            if asked.isdisjoint(
                name for state in inside for name in (state.name, state.label, state.activity)
            ):
                yield from (state.label for state in inside if state.type == "BASIC")


__all__ = ["Steady"]
