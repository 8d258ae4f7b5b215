"""A goal, its keeper, and balls that roll towards it from all sides. Lengths in cm, angles in degrees."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

STEP = 20_000_000
"""A step of the simulation, in ns."""
SECOND = 1_000_000_000
HALF_GOAL = 75.0
"""From the middle of the goal to a post."""
SPEED = 30.0
"""Of the walking keeper, in cm/s."""
REACH = 60.0
"""How far to its sides a keeper that dives covers."""
PATIENCE = 4 * SECOND
"""How long a ball lies before the goal until somebody else takes it."""
PENALTY = (40 * SECOND, 50 * SECOND)
"""When the keeper is penalised."""

ENDS = ("saved", "kicked away", "goal", "beside", "left")
"""What may become of a ball."""

Point = tuple[float, float]


@dataclass(frozen=True)
class Percept:
    """What the keeper senses: where it is, and the ball's place and speed."""

    place: Point
    ball: Point
    speed: float
    penalised: bool


@dataclass
class Keeper:
    """The keeper. Its command is ("walk", place), ("dive", side), ("kick",) or None to stand."""

    pitch: Pitch
    name: str = "keeper"
    place: Point = (10.0, 0.0)
    target: Point | None = None
    lies: bool = False
    payload_limit: int = 0

    def sense(self) -> Percept:
        now = self.pitch.now_ns
        return Percept(self.place, self.pitch.ball, self.pitch.speed, PENALTY[0] <= now < PENALTY[1])

    def act(self, command: tuple[object, ...] | None) -> None:
        self.lies = command is not None and command[0] == "dive"
        self.target = command[1] if command is not None and command[0] == "walk" else None  # type: ignore[assignment]
        if command is not None and command[0] == "kick" and math.dist(self.place, self.pitch.ball) < 20:
            self.pitch.tell("kicked away")
            self.pitch.serve()

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []

    def move(self) -> None:
        if self.target is None:
            return
        way, step = math.dist(self.place, self.target), SPEED * STEP / SECOND
        share = min(1.0, step / way) if way else 0.0
        (x, y), (to_x, to_y) = self.place, self.target
        self.place = x + share * (to_x - x), y + share * (to_y - y)


@dataclass
class Pitch:
    """The pitch in front of the goal, which is at x = 0, and what is told of it."""

    seed: int
    now_ns: int = 0
    step_ns: int = STEP
    ball: Point = (0.0, 0.0)
    velocity: Point = (0.0, 0.0)
    score: dict[str, int] = field(default_factory=lambda: dict.fromkeys(ENDS, 0))
    lines: list[str] = field(default_factory=list)
    still_ns: int = 0
    """How long the ball has been lying."""

    def __post_init__(self) -> None:
        self.chance = random.Random(self.seed)
        self.bodies = {"keeper": Keeper(self)}
        self.serve()

    @property
    def speed(self) -> float:
        return math.hypot(*self.velocity)

    def serve(self) -> None:
        """The next ball: some are shot, some roll so slowly that they lie still before the goal."""
        angle = math.radians(self.chance.uniform(-50, 50))
        self.ball = 250 * math.cos(angle), 250 * math.sin(angle)
        aim, speed = self.chance.uniform(-90, 90), self.chance.choice((88.0, 92.0, 95.0, 150.0))
        way = math.dist(self.ball, (0.0, aim))
        self.velocity = -speed * self.ball[0] / way, speed * (aim - self.ball[1]) / way

    def advance(self, until_ns: int) -> None:
        keeper = self.bodies["keeper"]
        while self.now_ns + STEP <= until_ns:
            self.now_ns += STEP
            keeper.move()
            seconds = STEP / SECOND
            slower = max(0.0, 1.0 - 22.0 * seconds / self.speed) if self.speed else 0.0
            self.velocity = self.velocity[0] * slower, self.velocity[1] * slower
            self.ball = self.ball[0] + seconds * self.velocity[0], self.ball[1] + seconds * self.velocity[1]
            self.still_ns = 0 if self.speed else self.still_ns + STEP
            reach = REACH if keeper.lies else 12.0
            ahead, aside = (abs(a - b) for a, b in zip(self.ball, keeper.place, strict=True))
            if self.speed and ahead < 6 and aside < reach:
                self.tell("saved")
                self.serve()
            elif self.still_ns >= PATIENCE:
                self.tell("left")
                self.serve()
            elif self.ball[0] <= 0:
                self.tell("goal" if abs(self.ball[1]) < HALF_GOAL else "beside")
                self.serve()

    def tell(self, what: str) -> None:
        self.score[what] += 1
        self.lines.append(f"{self.now_ns / SECOND:5.1f} s  {what}")


def make(seed: int) -> Pitch:
    """A training session. One seed, one session."""
    return Pitch(seed)


def progress(pitch: Pitch, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """What became of each ball."""
    return pitch.lines


def summary(pitch: Pitch) -> str:
    return ", ".join(f"{what} {count}" for what, count in pitch.score.items())
