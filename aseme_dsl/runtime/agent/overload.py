"""Overload: what an agent leaves out because too much comes or too little is taken, as its trace tells it.

The first of each sort is recorded as a fault; the number, by a `crowd` line a second at the most.
"""

from __future__ import annotations

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.execution import Host
from aseme_dsl.runtime.chart.input_queue import CROWD, Intake
from aseme_dsl.runtime.chart.plan import State
from aseme_dsl.runtime.time.clock import SECOND


@dataclass(slots=True)
class _Sort:
    """What of one sort has been left out since it was told last, and when that was."""

    told: int
    left_out: int = 0
    most: int = 0


class Overload:
    """What one agent leaves out. Called while it is guarded."""

    def __init__(self, agent: Host, queue: int) -> None:
        """`queue` signals of a queued channel may wait."""
        self._agent = agent
        self._queue = queue
        self._sorts: dict[tuple[str, str], _Sort] = {}

    def at_the_door(self, intake: Intake) -> None:
        """More has come than was taken by steps."""
        name = self._agent.name
        if intake.left_out:
            text = f"{name} is sent more than it can take: of states and data only the newest are kept"
            self._note("", "", intake.left_out, intake.most, text)
            intake.left_out = intake.most = 0
        while intake.refused:
            channel, count = intake.refused.popitem()
            text = f"{self._queue} queued signals wait for the next step of {name}"
            text += f": of {channel}, what comes now is left out"
            self._note(channel, "", count, CROWD + self._queue, text)

    def inside(self, region: str, channel: str) -> None:
        """A signal was left out in a region, where nothing takes those that wait."""
        state = self._named(region)
        text = f"{self._queue} {channel} wait in `{state.name}` of {self._agent.name} and are not taken"
        self._note(channel, region, 1, self._queue, f"{text}: what comes now is left out there", state.at)

    def _named(self, region: str) -> State:
        """A region as it is written: one of a formula has no name, but what is in it has."""
        plan = self._agent.plan
        states = (plan.by_label[region], *plan.children(region))
        return next((item for item in states if item.name != item.label), states[0])

    def end(self, intake: Intake) -> None:
        """The agent ends: tell the rest."""
        self.at_the_door(intake)
        for (channel, region), sort in self._sorts.items():
            if sort.left_out:
                self._tell(channel, region, sort)

    def _note(self, channel: str, region: str, left_out: int, most: int, text: str, at: str = "") -> None:
        agent, now = self._agent, self._agent.driver.clock.now()
        sort = self._sorts.get((channel, region))
        if sort is None:
            agent.trace.fault(now, agent.name, text, at)
            sort = self._sorts[channel, region] = _Sort(now - SECOND)
        sort.left_out += left_out
        sort.most = max(sort.most, most)
        if now - sort.told >= SECOND:
            self._tell(channel, region, sort)

    def _tell(self, channel: str, region: str, sort: _Sort) -> None:
        agent = self._agent
        sort.told = agent.driver.clock.now()
        agent.trace.write(
            "overload",
            sort.told,
            agent=agent.name,
            channel=channel or None,
            region=region or None,
            left_out=sort.left_out,
            most=sort.most,
        )
        sort.left_out = sort.most = 0
