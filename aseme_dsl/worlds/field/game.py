"""A game: the match between two teams that both have a program, as `asemec match` plays it.

Robots of both teams may have the same names: in the match, `robot1` of the home team is called `home.robot1`.
The robot's own activities and team mates know it as `robot1`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from aseme_dsl.runtime.world.body import RadioMessage
from aseme_dsl.runtime.world.lineup import AWAY, HOME, Lineup, seat_of
from aseme_dsl.worlds.field import render
from aseme_dsl.worlds.field.command import Command
from aseme_dsl.worlds.field.event import EventKind
from aseme_dsl.worlds.field.match import FieldBody, Match
from aseme_dsl.worlds.field.percept import Percept
from aseme_dsl.worlds.field.team import TeamSheet, team_sheet

GOALIES = ("goalie", "keeper", "goalkeeper")
"""The robot is the goalie whose role is called so; where there is none, the one that is called so itself."""


class GameBody:
    """The body of a robot, which is called as in its own team."""

    __slots__ = ("_body", "_name", "_seen", "_shown")

    def __init__(self, name: str, body: FieldBody) -> None:
        self._name = name
        self._body = body
        self._seen = body.sense()
        self._shown = replace(self._seen, name=name)

    @property
    def name(self) -> str:
        """The robot's name in its team."""
        return self._name

    @property
    def payload_limit(self) -> int:
        """The longest payload in bytes that the radio takes."""
        return self._body.payload_limit

    def sense(self) -> Percept:
        """The newest percept."""
        seen = self._body.sense()
        if seen is not self._seen:
            self._seen, self._shown = seen, replace(seen, name=self._name)
        return self._shown

    def act(self, command: Command) -> None:
        """Put a command in force from the next step on. Raises TypeError if it is not a command."""
        self._body.act(command)

    def say(self, payload: bytes) -> bool:
        """Send a message to the mates; False if too much was said lately, ValueError if it is too long."""
        return self._body.say(payload)

    def hear(self) -> list[RadioMessage]:
        """What arrived from mates since the last call."""
        return [replace(item, sender=item.sender.partition(".")[2]) for item in self._body.hear()]


class Game:
    """A match between two programmed teams: an ``aseme_dsl.runtime.world.body.World[Percept, Command]``."""

    def __init__(self, match: Match, lineups: Mapping[str, Lineup]) -> None:
        self._match = match
        self._bodies = {
            seat_of(side, agent): GameBody(agent, match.bodies[seat_of(side, agent)])
            for side, lineup in lineups.items()
            for agent in lineup.roles
        }

    @property
    def bodies(self) -> Mapping[str, GameBody]:
        """The bodies of all robots: those of the home team as `home.NAME`, the others as `away.NAME`."""
        return MappingProxyType(self._bodies)

    @property
    def step_ns(self) -> int:
        """The length of one step."""
        return self._match.step_ns

    @property
    def now_ns(self) -> int:
        """How far the match has been played."""
        return self._match.now_ns

    @property
    def over(self) -> bool:
        """Whether the final whistle has gone."""
        return self._match.over

    @property
    def score(self) -> tuple[int, int]:
        """The goals of the home team and of the other."""
        return self._match.result().score

    @property
    def story(self) -> tuple[str, ...]:
        """The goals, a line each."""
        return tuple(str(event) for event in self._match.events if event.kind is EventKind.GOAL)

    def advance(self, until_ns: int) -> None:
        """Play every step that ends at or before ``until_ns``. Raises ValueError for a time gone by."""
        self._match.advance(until_ns)

    def picture(self) -> str:
        """The match so far as an SVG document."""
        return render.svg(self._match)


def make(seed: int, home: Lineup, away: Lineup) -> Game:
    """A new match between two teams. All random numbers follow from the seed: one seed, one match.

    Raises ValueError for more than six field players on a side, and for two goalies.
    """
    names = (home.name, away.name)
    if home.name == away.name:
        names = (f"{home.name} ({HOME})", f"{away.name} ({AWAY})")
    sheets = [
        _sheet(number, name, side, lineup)
        for number, (name, side, lineup) in enumerate(
            zip(names, (HOME, AWAY), (home, away), strict=True), start=1
        )
    ]
    return Game(Match(seed, home=sheets[0], away=sheets[1]), {HOME: home, AWAY: away})


def _sheet(number: int, name: str, side: str, lineup: Lineup) -> TeamSheet:
    goalies = [agent for agent, role in lineup.roles.items() if role.lower() in GOALIES]
    goalies = goalies or [agent for agent in lineup.roles if agent.lower() in GOALIES]
    if len(goalies) > 1:
        raise ValueError(f"{name} has {len(goalies)} goalies: {', '.join(goalies)}")
    players = [seat_of(side, agent) for agent in lineup.roles if agent not in goalies]
    return team_sheet(number, name, players, goalie=seat_of(side, goalies[0]) if goalies else None)
