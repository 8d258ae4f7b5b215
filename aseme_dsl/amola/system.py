"""System: a whole multi-agent system, every model of it and what they share."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.expression import Literal
from aseme_dsl.amola.messages import EnumType, Function, Message, ProtoFile, Topic
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.suc import Suc
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Agent:
    """An agent of the team: its name (`carrier3`), its role and its number in a range (3).

    `settings` are the initial values of variables of its role, as it has them.
    """

    name: str
    role: str
    span: Span
    index: int = 1
    settings: tuple[tuple[str, Literal], ...] = ()


@dataclass(frozen=True, slots=True)
class Team:
    name: str
    agents: tuple[Agent, ...]
    span: Span


def agent_names(teams: Iterable[Team], roles: Iterable[str]) -> frozenset[str]:
    """The names of all agents; without a team, one agent plays one of the roles, and is called as it."""
    return frozenset(agent.name for team in teams for agent in team.agents) or frozenset(roles)


@dataclass(frozen=True, slots=True)
class System(Displayed):
    """All models of one system. Sequences are in document order; names are unique within each."""

    name: str
    enums: tuple[EnumType, ...] = ()
    messages: tuple[Message, ...] = ()
    topics: tuple[Topic, ...] = ()
    functions: tuple[Function, ...] = ()
    activities: tuple[Activity, ...] = ()
    sag: Sag = field(default_factory=Sag)
    suc: Suc = field(default_factory=Suc)
    aips: tuple[Aip, ...] = ()
    srms: tuple[Srm, ...] = ()
    eacs: tuple[Statechart, ...] = ()
    iacs: tuple[Statechart, ...] = ()
    teams: tuple[Team, ...] = ()
    protos: tuple[ProtoFile, ...] = ()  # imported .proto files, each after those that it imports
    sources: tuple[Source, ...] = ()
    span: Span | None = None

    @property
    def statecharts(self) -> tuple[Statechart, ...]:
        """Every statechart: protocols first, then roles."""
        return self.eacs + self.iacs

    @property
    def agents(self) -> dict[str, str]:
        """The roles of the agents of all teams, by name; without a team, of one agent for each role, which is
        called as it."""
        agents = {agent.name: agent.role for team in self.teams for agent in team.agents}
        return agents or {chart.name: chart.name for chart in self.iacs}

    def iac(self, role: str) -> Statechart | None:
        return next((chart for chart in self.iacs if chart.name == role), None)

    def eac(self, protocol: str) -> Statechart | None:
        return next((chart for chart in self.eacs if chart.name == protocol), None)

    def chart(self, name: str) -> Statechart | None:
        """The statechart that is called `eac.<protocol>` or `iac.<role>`, as its file and its drawing are."""
        kind, _, owner = name.partition(".")
        return self.eac(owner) if kind == "eac" else self.iac(owner) if kind == "iac" else None

    def activity(self, name: str) -> Activity | None:
        return next((item for item in self.activities if item.name == name), None)

    def message(self, name: str) -> Message | None:
        return next((item for item in self.messages if item.name == name), None)

    def enum(self, name: str) -> EnumType | None:
        return next((item for item in self.enums if item.name == name), None)
