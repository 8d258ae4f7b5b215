"""The team sheet: who plays, and where they stand at a kick-off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from aseme_dsl.worlds.field.geometry import Pose

MOST_FIELD_PLAYERS = 6


@dataclass(frozen=True, slots=True)
class Player:
    """A robot on the team sheet."""

    name: str
    jersey: int
    goalie: bool = False


@dataclass(frozen=True, slots=True)
class TeamSheet:
    """A team: its number and name, its players, and whether the field plays it itself.

    Raises ValueError for two players of one name or jersey number, for more than one goalie, and for more
    than six field players.
    """

    number: int
    name: str
    players: tuple[Player, ...]
    scripted: bool = False
    """True: no program drives these robots through a body; they play the simple game of ``opponent``."""

    def __post_init__(self) -> None:
        if len({player.name for player in self.players}) < len(self.players):
            raise ValueError(f"two players of {self.name} have the same name")
        if len({player.jersey for player in self.players}) < len(self.players):
            raise ValueError(f"two players of {self.name} have the same jersey number")
        goalies = sum(player.goalie for player in self.players)
        if goalies > 1:
            raise ValueError(f"{self.name} has {goalies} goalies")
        if len(self.players) - goalies > MOST_FIELD_PLAYERS:
            raise ValueError(f"{self.name} has more than {MOST_FIELD_PLAYERS} field players")


def team_sheet(
    number: int, name: str, field_players: Sequence[str], goalie: str | None = None, scripted: bool = False
) -> TeamSheet:
    """A team sheet with jersey numbers in the order given: the field players from 1 on, then the goalie."""
    players = [Player(player, jersey) for jersey, player in enumerate(field_players, start=1)]
    if goalie is not None:
        players.append(Player(goalie, len(players) + 1, goalie=True))
    return TeamSheet(number, name, tuple(players), scripted)


def kick_off_places(sheet: TeamSheet, own_kick_off: bool) -> dict[str, Pose]:
    """Where each player of a team stands at a kick-off, by name; legal by the rules of the kick-off."""
    free = iter(_ATTACKING if own_kick_off else _WAITING)
    return {player.name: _KEEPING if player.goalie else next(free) for player in sheet.players}


_KEEPING = Pose(-435.0, 0.0)
_ATTACKING = (
    Pose(-30.0, 0.0),
    Pose(-60.0, 150.0),
    Pose(-200.0, -60.0),
    Pose(-60.0, -150.0),
    Pose(-250.0, 110.0),
    Pose(-300.0, -110.0),
)
_WAITING = (
    Pose(-110.0, 0.0),
    Pose(-150.0, 130.0),
    Pose(-150.0, -130.0),
    Pose(-260.0, 60.0),
    Pose(-260.0, -60.0),
    Pose(-320.0, 0.0),
)
