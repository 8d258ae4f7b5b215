"""What a robot of the field senses: its own body, what it sees, and what the referee signals.

Places are those of the robot's own team: x towards the opponents' goal. Directions are degrees, left
positive.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from aseme_dsl.worlds.field.command import Walk
from aseme_dsl.worlds.field.geometry import Pose, length


class PlayerState(IntEnum):
    """The state of the game, as it concerns one player."""

    INITIAL = 0
    """Before a half: no player moves from the spot."""
    READY = 1
    """The players walk to their places for the kick-off."""
    SET = 2
    """They stand there and wait for the whistle."""
    PLAYING = 3
    FINISHED = 4
    PENALISED = 5
    """This player is taken out for a while; only players have this state, the game never."""


class SetPlay(IntEnum):
    """How the ball comes back into play: until it is touched, the other team keeps its distance."""

    NONE = 0
    KICK_OFF = 1
    KICK_IN = 2
    GOAL_KICK = 3
    CORNER_KICK = 4


class Posture(IntEnum):
    """How a robot holds itself."""

    STANDING = 0
    SITTING = 1
    FALLEN = 2


@dataclass(frozen=True, slots=True)
class BallSeen:
    """The ball in the picture, measured with an error that grows with the distance.

    ``distance`` is from the middle of the robot to the middle of the ball, in cm. The velocity is over
    ground, in cm/s, along and across the direction in which the robot stands.
    """

    distance: float
    bearing: float
    velocity_forward: float = 0.0
    velocity_left: float = 0.0

    @property
    def speed(self) -> float:
        """cm/s."""
        return length(self.velocity_forward, self.velocity_left)


@dataclass(frozen=True, slots=True)
class RobotSeen:
    """Another robot in the picture: one of the own team or not, and its jersey number."""

    own_team: bool
    jersey: int
    distance: float
    bearing: float


@dataclass(frozen=True, slots=True)
class PostSeen:
    """A goal post in the picture: of the opponents' goal or the own, on the left of the field or not."""

    opponents: bool
    left: bool
    distance: float
    bearing: float


@dataclass(frozen=True, slots=True)
class GameSeen:
    """What the referee signals to one player.

    ``state`` is the player's (PENALISED if it is), ``game_state`` the game's. ``seconds_remaining`` counts
    the playing time of this half down. ``own_kick_off`` says whose kick-off the last one was, or the coming
    one is; ``own_set_play`` whose the ball is while ``set_play`` is not NONE.
    """

    state: PlayerState
    game_state: PlayerState
    half: int
    seconds_remaining: int
    own_score: int
    other_score: int
    own_kick_off: bool
    set_play: SetPlay
    own_set_play: bool


@dataclass(frozen=True, slots=True)
class Percept:
    """Everything a robot of the field senses at one moment."""

    time_ns: int
    """When: the end of the step at which the picture was taken."""
    name: str
    team: int
    """The team's number."""
    jersey: int
    goalie: bool
    pose: Pose
    """Where the robot believes to stand: within some cm and degrees, an error that wanders slowly."""
    walk: Walk
    """How it walks at the moment: cm/s, degrees/s."""
    head: float
    """Where the head points, in degrees from straight ahead."""
    posture: Posture
    busy: bool
    """A kick, a dive, sitting down or getting up is going on; the next motion begins when it has ended."""
    ball: BallSeen | None
    """None: it is not in the picture."""
    ball_at_feet: bool
    """The feet feel the ball where a kick would hit it."""
    robots: tuple[RobotSeen, ...]
    posts: tuple[PostSeen, ...]
    game: GameSeen
    kick_off_place: Pose
    """Where the referee wants this robot at the next kick-off; who is not in a legal place is put there."""
