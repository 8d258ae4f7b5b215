"""Swapping: the agents of a running team continue under another version of their plans, all of them or none.

A swap is prepared, then done or rolled back. Preparing waits for a moment at which no agent is inside a
conversation of a protocol that the two versions play differently. There it holds the agents between two
steps, and works out where each of them continues. Nothing has changed until it is done: rolling back is
letting the agents go.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityError, ActivityFinder, has_code, kind_of
from aseme_dsl.runtime.activity.modules import code_of
from aseme_dsl.runtime.agent.behaviours import agent_class
from aseme_dsl.runtime.agent.state_transfer import CannotCarry, Carried, carry, same_states
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.functions import function_errors
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.message.contract import Contract, contract_of, reading
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.message.wire import Schema
from aseme_dsl.runtime.time.clock import SECOND, shown
from aseme_dsl.runtime.trace.packed import packed
from aseme_dsl.runtime.version.loading import (
    PURE,
    Loaded,
    Modules,
    RoleBackends,
    importing,
    put_in_place,
    standing_in,
)
from aseme_dsl.runtime.version.versions import VersionFiles

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution
    from aseme_dsl.runtime.agent.agent import Agent
    from aseme_dsl.runtime.conversation.conversation import Conversations
    from aseme_dsl.runtime.ports import Driver
    from aseme_dsl.runtime.trace.trace import Trace

WITHIN = 10 * SECOND
"""How long a swap waits for conversations to end, if nothing else is said."""
_LOOK_SECONDS = 0.002
"""How often it looks in real time whether they have."""


@dataclass(frozen=True, slots=True)
class Version:
    """A version of a system that agents can run: its plans' charts by name, its messages, its code."""

    system: str
    charts: Mapping[str, type[Chart]]
    find: ActivityFinder
    messages: Messages = field(default_factory=dict)
    schema: Schema | None = None
    model: str = ""
    """The hash of all its models."""
    path: tuple[Path, ...] = ()
    modules: Modules = field(default_factory=dict)
    team: tuple[tuple[str, str], ...] = ()
    """The agents of the system's own team with their roles."""
    folder: Path | None = None
    """Where its package is."""
    mixture: RoleBackends = PURE
    code: VersionFiles | None = None
    """What it was loaded from, where that is a version rather than the build itself."""
    sources: Mapping[str, str] = field(default_factory=dict)
    """The texts that it was generated from, by their paths beside the first."""


def version_of(loaded: Loaded, find: ActivityFinder) -> Version:
    """A generated system with the code of its activities."""
    return Version(
        loaded.name,
        loaded.charts,
        find,
        loaded.messages,
        loaded.schema,
        loaded.model,
        loaded.path,
        loaded.modules,
        loaded.team,
        loaded.folder,
        loaded.mixture,
        loaded.code,
        loaded.sources,
    )


class Swappable(Protocol):
    """A team as a swap sees it."""

    @property
    def agents(self) -> tuple[Agent, ...]: ...
    @property
    def driver(self) -> Driver[Execution]: ...
    @property
    def trace(self) -> Trace: ...
    @property
    def conversations(self) -> Conversations: ...
    @property
    def version(self) -> Version: ...
    def agent(self, name: str) -> Agent: ...
    def bind_message_types(self) -> None: ...
    def renew(self, agent: Agent, version: Version) -> None: ...
    def speak(self, version: Version) -> None: ...
    def set_version(self, version: Version) -> None: ...


class Swap:
    """One swap of a team. `state` is waiting, prepared, done, refused or rolled back.

    `reasons` says why it was refused or rolled back, or, while it waits, what for. A swap is for one thread:
    the one that prepares it also ends it.
    """

    def __init__(self, team: Swappable, version: Version, agents: Iterable[str] | None = None) -> None:
        """For these agents, or for the whole team. Raises LookupError for an agent that there is not."""
        self.team = team
        self.version = version
        self.agents: tuple[Agent, ...] = (
            team.agents if agents is None else tuple(team.agent(name) for name in dict.fromkeys(agents))
        )
        self.state = "waiting"
        self.reasons: tuple[str, ...] = ()
        self.notes: tuple[str, ...] = ()
        """What the operator should know."""
        self._held = ExitStack()
        self._carried: list[tuple[Agent, Carried]] = []
        self._same: dict[str, dict[str, str]] = {}
        self._differ: Mapping[str, str] | None = None
        """Why protocols cannot be played with the version before; None: only their hashes are known."""

    # ---- preparing ---------------------------------------------------------------------------

    def prepare(self, within: int = WITHIN) -> bool:
        """Wait in real time, `within` ns at most, until every agent can change, and hold them there."""
        if not self.check():
            return False
        clock = self.team.driver.clock
        deadline = clock.now() + within
        while not self.hold():
            if self.state != "waiting":
                return False
            if clock.now() >= deadline:
                self.refuse(f"{reason} after {shown(within)}" for reason in self.reasons)
                return False
            time.sleep(_LOOK_SECONDS)
        return True

    def check(self) -> bool:
        """Whether the version has all that these agents need, as far as that can be known beforehand."""
        version = self.version
        reasons: list[str] = []
        charts: dict[str, type[Chart]] = {}
        for agent in self.agents:
            if agent.role in version.charts:
                charts[agent.role] = version.charts[agent.role]
            else:
                known = ", ".join(version.charts) or "no plan"
                reasons.append(f"the new model has no {agent.role}, which {agent.name} plays; it has {known}")
        with importing(version.path), standing_in(version.modules):
            reasons += activity_errors(charts.values(), version.find)
        if reasons:
            self.refuse(reasons)
            return False
        self._same = {agent.role: same_states(agent.plan, charts[agent.role].PLAN) for agent in self.agents}
        roles = dict(version.team)
        self.notes = (
            *(
                f"{agent.name} is {roles[agent.name]} in the new team; it continues as {agent.role}"
                for agent in self.agents
                if roles.get(agent.name, agent.role) != agent.role
            ),
            *self._compare(),
        )
        return True

    def _compare(self) -> Iterable[str]:
        """Compare what the two versions say to others, and give what agents of one do not read of the other.

        It is judged as between robots of two builds.
        """
        before, after = _contract(self.team.version), _contract(self.version)
        if before is None or after is None:
            return
        here, there = reading(after, before), reading(before, after)
        self._differ = here.protocols
        for name, reason in here.channels.items():
            if name in after.channels:  # else there is nothing to be read
                yield f"the new version does not read {name} of the version before: {reason}"
        for name, reason in there.channels.items():
            if name in before.channels:
                yield f"the version before does not read {name} of the new one: {reason}"

    def _obstacle(self, info: BranchInfo) -> str:
        """Why a protocol that an agent plays now cannot be played with the new version; empty if it can."""
        branches = [b for chart in self.version.charts.values() for b in chart.PLAN.branches]
        known = {(b.protocol, b.participant): b.version for b in branches}
        if known.get((info.protocol, info.participant)) == info.version:
            return ""
        if self._differ is None:
            return "its hash differs"
        if info.protocol not in {protocol for protocol, _ in known}:
            return "there is no such protocol"
        return self._differ.get(info.protocol, "")

    def hold(self) -> bool:
        """Hold the agents where they are, if they can change there; the state says what came of it."""
        for agent in self.agents:
            self._held.enter_context(agent.driver.hold(agent))
        self.reasons = self.busy()
        if self.reasons:
            self._held.close()
            return False
        reasons: list[str] = []
        now = self.team.driver.clock.now()
        for agent in self.agents:
            if agent.over:
                continue
            try:
                kind = self.version.charts[agent.role]
                before = agent.messages or self.team.version.messages
                carried = carry(agent.chart, kind, before, self.version.messages, now, self._same[agent.role])
                self._carried.append((agent, carried))
            except CannotCarry as problem:
                reasons += [f"{agent.name} {reason}" for reason in problem.reasons]
        if reasons:
            self._carried.clear()
            self._held.close()
            self.refuse(reasons)
            return False
        self.state = "prepared"
        return True

    def busy(self) -> tuple[str, ...]:
        """Which agents are inside a protocol run that the new version would play differently, if any."""
        return tuple(self._conversations())

    def _conversations(self) -> Iterable[str]:
        for agent in self.agents:
            branches = self.version.charts[agent.role].PLAN.branches
            parts = {(b.protocol, b.participant) for b in branches}
            kept = self._same[agent.role]
            for info, conversation in self.team.conversations.inside(agent):
                is_kept = all(
                    label in kept
                    for label in agent.chart.configuration()
                    if f"{label}.".startswith(f"{info.label}.")
                )
                obstacle = self._obstacle(info)
                if (info.protocol, info.participant) not in parts:
                    obstacle = obstacle or f"{agent.role} does not play {info.participant}"
                elif not is_kept:
                    obstacle = obstacle or "an active state is not in it"
                if obstacle:
                    yield (
                        f"{agent.name} is still {info.participant} in the conversation {conversation} of "
                        f"{info.protocol}, which the new model plays differently: {obstacle};"
                    )

    # ---- ending ------------------------------------------------------------------------------

    def refuse(self, reasons: Iterable[str]) -> None:
        """It cannot be."""
        self.state = "refused"
        self.reasons = tuple(dict.fromkeys(reasons))
        self._tell("refused")

    def roll_back(self, reason: str) -> None:
        """Let the agents continue as they were."""
        self._carried.clear()
        self._held.close()
        self.state = "rolled back"
        self.reasons = (reason,)
        self._tell("rolled back")

    def finish(self) -> None:
        """Let the agents continue under the new version."""
        version, team = self.version, self.team
        put_in_place(version.modules)
        try:
            lines = [(agent, agent.plan, carried) for agent, carried in self._carried]
            team.bind_message_types()
            team.conversations.play_alike(self._alike())
            is_whole = len(self.agents) == len(team.agents)
            if is_whole:
                team.speak(version)  # before the first activity of the new version does
            for agent, carried in self._carried:
                model = carried.chart.PLAN.model
                agent.go_on(carried, version.find, version.messages, changed=model != agent.plan.model)
                team.renew(agent, version)
            if is_whole:
                team.set_version(version)
            sources = packed(version.sources) if team.trace.active else None
            for agent, before, carried in lines:
                self._tell_done(agent, before, carried, sources)
        finally:
            self._held.close()
        self.state = "done"
        self.reasons = ()

    def _alike(self) -> Iterable[tuple[str, str]]:
        """The versions, before and now, of protocols whose messages have changed compatibly."""
        now = {b.protocol: b.version for chart in self.version.charts.values() for b in chart.PLAN.branches}
        for chart in self.team.version.charts.values():
            for info in chart.PLAN.branches:
                if now.get(info.protocol, info.version) != info.version and not self._obstacle(info):
                    yield info.version, now[info.protocol]

    # ---- the trace ---------------------------------------------------------------------------

    def _tell(self, what: str) -> None:
        self.team.trace.write(
            "swap",
            self.team.driver.clock.now(),
            what=what,
            agents=[agent.name for agent in self.agents],
            model=self.version.model or None,
            reasons=list(self.reasons),
        )

    def _tell_done(self, agent: Agent, before: Plan, carried: Carried, sources: str | None) -> None:
        plan = carried.chart.PLAN
        self.team.trace.write(
            "swap",
            self.team.driver.clock.now(),
            what="done",
            agent=agent.name,
            role=plan.name,
            before=before.model,
            model=plan.model,
            source=plan.source,
            configuration=list(carried.chart.configuration()) if carried.chart.started else [],
            entered=list(carried.entered) or None,
            restarted=list(carried.restarted) or None,
            lost=list(carried.lost) or None,
            plan=plan_record(plan) if plan.model != before.model else None,
            sources=sources,
        )


def _contract(version: Version) -> Contract | None:
    """What a version says of its messages and protocols; None where it has no schema."""
    if version.schema is None:
        return None
    return contract_of(version.schema, (chart.PLAN for chart in version.charts.values()), version.model)


class WaitingSwaps:
    """The scheduled swaps of one team in virtual time, until they are done or refused."""

    def __init__(self, team: Swappable) -> None:
        self._team = team
        self._waiting: list[Swap] = []

    def schedule(self, change: Swap, at: int, within: int) -> Swap:
        """Begin a swap at the moment `at`; for `within` ns it waits until no conversation is in the way."""
        driver = self._team.driver
        moment = max(at, driver.clock.now())

        def begin() -> None:
            if change.check() and not change.hold() and change.state == "waiting":
                self._waiting.append(change)
                driver.at(moment + within, lambda: self._too_late(change, within))
            elif change.state == "prepared":
                change.finish()

        driver.at(moment, begin)
        return change

    def try_again(self) -> None:
        """Do what can be done now that nothing is left to do at this instant."""
        for change in list(self._waiting):
            if change.hold():
                change.finish()
            if change.state != "waiting":
                self._waiting.remove(change)

    def _too_late(self, change: Swap, within: int) -> None:
        if change in self._waiting:
            self._waiting.remove(change)
            change.refuse(f"{reason} after {shown(within)}" for reason in change.reasons)


def plan_record(plan: Plan) -> dict[str, object]:
    """A plan for a reader of the trace: what the labels and numbers of later lines mean."""
    return {
        "states": [{"label": state.label, "name": state.name, "type": state.type} for state in plan.states],
        "transitions": [
            {"source": way.source, "target": way.target, "text": way.text}
            | ({"into": list(way.into)} if way.into else {})
            for way in plan.transitions
        ],
    }


def activity_errors(charts: Iterable[type[Chart]], find: ActivityFinder) -> Sequence[str]:
    """Why activities, modules and functions of these charts cannot be loaded, where they cannot."""
    errors: list[str] = []
    for chart in charts:
        kinds = {info.name: info.kind for info in chart.PLAN.activities}
        for state in chart.PLAN.states:
            if state.activity is not None:
                try:
                    found = find(state.activity)
                    if found is not None and has_code(found):
                        kind_of(found, kinds.get(state.activity, "thread"))
                except ActivityError as error:
                    errors.append(str(error))
        try:
            agent_class(chart, find)
        except ActivityError as error:
            errors.append(str(error))
        for module in chart.PLAN.modules:
            try:
                code_of(module, find)
            except ActivityError as error:
                errors.append(str(error))
        errors += function_errors(chart.PLAN.name, chart.PLAN.functions)
    return list(dict.fromkeys(errors))
