"""Untakable messages: what no later state of a participant takes does not wait for it, and is answered."""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Identity
from aseme_dsl.runtime.chart.plan import Kind


class Untakable:
    """Looks after each step whether the agent messages that wait can still be taken."""

    def __init__(self, refuse: Callable[[str, Identity], None]) -> None:
        """`refuse` is called with a branch and a message in it that nothing takes."""
        self._refuse = refuse
        self._seen: dict[str, tuple[frozenset[Kind], Identity]] = {}
        """What each branch could take when it was looked at last, and the newest message that was seen."""

    def forget(self) -> None:
        """The agent has another chart now."""
        self._seen.clear()

    def look(self, chart: Chart) -> None:
        """Remove what nothing takes any more. After a step, when its effects are done."""
        for branch, waiting in chart.mail.items():
            if waiting:
                self._look_at(chart, branch, waiting)

    def _look_at(self, chart: Chart, branch: str, waiting: tuple[AgentMessage, ...]) -> None:
        within = f"{branch}."
        leaves = [leaf for leaf in chart.configuration() if leaf.startswith(within)]
        if not leaves:
            return  # it is suspended: what waits is for when it is resumed
        taken = frozenset[Kind]().union(*(chart.PLAN.taken_from(branch, leaf) for leaf in leaves))
        known, newest = self._seen.get(branch, (None, None))
        self._seen[branch] = taken, waiting[-1].identity
        if known is not None and known <= taken:
            new = tuple(takewhile(lambda item: item.identity != newest, reversed(waiting)))[::-1]
        else:
            new = waiting
        refused = [item for item in new if item.performative != LOST and not _is_taken(item, taken)]
        if refused:
            chart.mail[branch] = tuple([item for item in waiting if item not in refused])
            for item in refused:
                self._refuse(branch, item.identity)


def _is_taken(item: AgentMessage, taken: frozenset[Kind]) -> bool:
    kind = item.performative, item.message
    return (*kind, item.participant) in taken or (*kind, "") in taken


__all__ = ["Untakable"]
