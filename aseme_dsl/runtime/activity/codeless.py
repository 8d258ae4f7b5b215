"""Activities without code: how long they last, and remarks about them in the trace."""

from __future__ import annotations

from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.activity.plan_code import PlanCode
from aseme_dsl.runtime.chart.missing_decisions import listed, undecided
from aseme_dsl.runtime.time.clock import MILLISECOND, shown

WITHOUT_CODE = 100 * MILLISECOND
"""How long an activity lasts that has neither code nor `takes`."""


class Codeless:
    """The activities without code that one agent has begun. Called while the agent is guarded."""

    def __init__(self, agent: Host, code: PlanCode) -> None:
        self._agent = agent
        self._code = code
        self._remarked: set[str] = set()
        """The activities of which the trace says that they have neither code nor `takes`."""
        self._branches: set[str] = set()
        """The participant subcharts in which an activity without code has begun."""

    def begin(self, execution: Execution, now: int) -> int:
        """Note that an activity without code begins; how long it lasts, in ns."""
        info = execution.info
        if info.takes is None and info.name not in self._remarked:
            self._remarked.add(info.name)
            text = f"activity {info.name} has neither code nor `takes`: it lasts {shown(WITHOUT_CODE)}"
            self._agent.trace.remark(now, self._agent.name, text, code="W201", activity=info.name)
        self._agent.requests.prepared.begun_without_code(execution.branch)
        if execution.branch is not None and execution.branch not in self._branches:
            self._branches.add(execution.branch)
            self._remark_undecided(execution.branch, now)
        return WITHOUT_CODE if info.takes is None else info.takes

    def clear(self) -> None:
        """Forget the subcharts: the agent has another plan."""
        self._branches.clear()

    def _remark_undecided(self, branch: str, now: int) -> None:
        """Remark that a participant agrees to nothing, since no activity of it has code."""
        if self._code.has_code_in(branch, or_stand_in=True) or self._code.is_simulated(branch):
            return
        plan = self._agent.plan
        found = undecided(plan, branch)
        if not found.variables:
            return
        info = self._agent.branch_info(branch)
        stay = f"{listed(found.variables, 'and')} {'stays' if len(found.variables) == 1 else 'stay'} false"
        text = f"{plan.name} plays {info.protocol}.{info.participant} without code, so {stay}"
        write = listed(found.activities, "or")
        self._agent.trace.remark(now, self._agent.name, f"{text}: {write} would decide that")


__all__ = ["Codeless"]
