"""What happened in a match, and when: the referee's notes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class EventKind(StrEnum):
    """What can happen in a match."""

    STATE = "state"
    """The state of the game changed; ``detail`` is the new one."""
    KICK_OFF = "kick-off"
    """``team`` brings the ball into play."""
    KICK = "kick"
    """``robot`` kicked the ball."""
    MISSED_KICK = "missed kick"
    """``robot`` kicked where no ball was."""
    GOAL = "goal"
    """``team`` scored; ``robot`` touched the ball last, or ``detail`` says ``own goal``."""
    NO_GOAL = "no goal"
    """The ball was in the goal, straight from the kick-off: that does not count."""
    OUT = "out"
    """The ball left the field; ``team`` and ``robot`` touched it last, if a robot did."""
    SET_PLAY = "set play"
    """``team`` brings the ball back into play; ``detail`` is how."""
    DROPPED_BALL = "dropped ball"
    """No robot could move the ball; it is put into the middle."""
    FALL = "fall"
    PENALTY = "penalty"
    """``robot`` is taken out; ``detail`` is why."""
    RETURN = "return"
    """A penalised ``robot`` is back."""
    PLACED = "placed"
    """``robot`` did not stand in a legal place for the kick-off and was put into one."""
    HALF_TIME = "half-time"
    FULL_TIME = "full time"


@dataclass(frozen=True, slots=True)
class Event:
    """One note of the referee.

    ``x`` and ``y`` are where the ball (for a robot's events: the robot) was, in cm as the home team sees the
    field; ``score`` is the score after the event.
    """

    time_ns: int
    kind: EventKind
    team: str = ""
    robot: str = ""
    detail: str = ""
    x: float = 0.0
    y: float = 0.0
    score: tuple[int, int] = (0, 0)

    def __str__(self) -> str:
        words = [f"{clock(self.time_ns)}", str(self.kind)]
        if self.team:
            words.append(f"for {self.team}" if self.kind is EventKind.GOAL else self.team)
        if self.robot:
            words.append(f"by {self.robot}" if self.kind is EventKind.GOAL else self.robot)
        if self.detail:
            words.append(f"({self.detail})")
        if self.kind in (EventKind.GOAL, EventKind.HALF_TIME, EventKind.FULL_TIME):
            words.append(f"{self.score[0]}:{self.score[1]}")
        return " ".join(words)


def clock(time_ns: int) -> str:
    """A time as minutes, seconds and tenths: ``1:05.3``."""
    tenths = time_ns // 100_000_000
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"
