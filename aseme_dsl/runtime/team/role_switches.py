"""Role switches: an agent leaves its plan and enters another, of its team's system or of another one."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from aseme_dsl.runtime.agent.state_transfer import knowledge_of, variables_of
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.team.swap import Swappable, Version, activity_errors, plan_record
from aseme_dsl.runtime.trace.packed import packed
from aseme_dsl.runtime.version.loading import importing, put_in_place, standing_in

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent.agent import Agent


class Switchable(Swappable, Protocol):
    """A team as a role switch sees it."""

    @property
    def elsewhere(self) -> Mapping[str, Plan]: ...


class RoleSwitches:
    """The role switches of one team."""

    def __init__(self, team: Switchable, carried: Callable[[], Sequence[Version]]) -> None:
        """`carried` gives the other systems that the robots carry."""
        self._team = team
        self._carried = carried

    def choose(self, agent: Agent, plan: str, by: str, *, own: bool = False) -> str | None:
        """Let an agent leave its plan and enter another: one of the team's system, or of another that the
        robot carries (`player`, `Kouretes.player`). Called while the agent is guarded, between two steps.

        `own` keeps it to the team's system: nothing is loaded. Gives the reason if it was refused. An agent
        that follows the plan already continues.
        """
        found = self._carried_plan(plan, own)
        if isinstance(found, str):
            return self._refuse(agent, plan, by, found)
        version, kind = found
        if agent.over:
            return self._refuse(agent, plan, by, f"{agent.name} has ended")
        if kind.PLAN.model == agent.plan.model:
            return None
        with importing(version.path), standing_in(version.modules):
            errors = activity_errors((kind,), version.find)
        if errors:
            return self._refuse(agent, plan, by, "; ".join(errors))
        if version is not self._team.version:
            put_in_place(version.modules)
            self._team.bind_message_types()
        chart = kind(agent.name)
        messages = version.messages if agent.messages else {}
        variables_of(agent.chart, chart, version.messages)
        knowledge_of(agent.chart, chart, version.messages)
        before = agent.plan
        now = self._team.driver.clock.now()
        is_other = version is not self._team.version
        self._team.trace.write(
            "select",
            now,
            agent=agent.name,
            plan=f"{kind.PLAN.system}.{kind.PLAN.name}",
            by=by,
            before=before.model,
            model=kind.PLAN.model,
            source=kind.PLAN.source,
            states=plan_record(kind.PLAN),
            sources=packed(version.sources) if is_other and self._team.trace.active else None,
        )
        agent.begin_as(chart, version.find, messages)
        self._team.renew(agent, version)
        return None

    def follow(self, agent: Agent, plan: str, by: str) -> None:
        """A message says which plan an agent is to run: it does so before its next step.

        To load what the robot carries besides is control, which other robots do not have.
        """
        others = {*self._team.elsewhere, *(item.name for item in self._team.agents)} - {agent.name}

        def choose() -> None:
            self.choose(agent, plan, by, own=by in others)

        agent.errand(choose)

    def _carried_plan(self, plan: str, own: bool) -> tuple[Version, type[Chart]] | str:
        """The chart of a plan's name, or why there is none."""
        try:
            versions = [self._team.version]
            if not own and plan not in self._team.version.charts:
                versions += [item for item in self._carried() if item.system != self._team.version.system]
        except Exception as error:  # another package in the folder, of any origin
            return f"what the robot carries cannot be loaded: {error}"
        found = [
            (item, chart)
            for item in versions
            for name, chart in item.charts.items()
            if plan in (name, f"{item.system}.{name}")
        ]
        known = ", ".join(f"{item.system}.{name}" for item in versions for name in item.charts)
        if len(found) > 1:
            return f"several plans are called {plan}; there are {known}"
        return found[0] if found else f"there is no plan {plan}; there are {known}"

    def _refuse(self, agent: Agent, plan: str, by: str, reason: str) -> str:
        now = self._team.driver.clock.now()
        self._team.trace.write("select", now, agent=agent.name, plan=plan, by=by, reason=reason)
        return reason


__all__ = ["RoleSwitches"]
