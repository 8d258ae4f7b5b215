"""Two cells on a bench: arms that may jam, grippers that slip, parts, and an operator's button."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

STEP = 10_000_000
"""A step of the simulation, in ns."""
SECOND = 1_000_000_000
PLACES = {"BIN_A": 0.0, "BIN_B": 0.6, "TRAY": 1.5, "HOME": 1.0}
"""Where each place is along the bench, in metres."""
SPEED = 0.5
"""Of an arm, in m/s."""
SLIPS = 0.35
"""How often a part slips when it is grasped."""
JAM = (20 * SECOND, 27 * SECOND)
"""From when to when the left arm is jammed."""
STOP = (33 * SECOND, 36 * SECOND)
"""When the operator stops all, and when the button is released again."""


@dataclass(frozen=True)
class Percept:
    """What a cell senses."""

    position: float
    holds: bool
    part: str
    stop: bool
    released: bool


@dataclass
class Cell:
    """One arm with its gripper. Its command is where to go, in metres, or None to stand still."""

    name: str
    bench: Bench
    position: float = PLACES["HOME"]
    target: float | None = None
    holds: bool = False
    parts: int = 1
    payload_limit: int = 0

    def sense(self) -> Percept:
        now = self.bench.now_ns
        stop = STOP[0] <= now < STOP[1]
        return Percept(self.position, self.holds, f"{self.name}-{self.parts}", stop, now >= STOP[1])

    def act(self, command: float | None) -> None:
        self.target = command

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []

    def close_gripper(self) -> bool:
        """Whether the part is held."""
        self.holds = self.bench.chance.random() >= SLIPS
        return self.holds

    def open_gripper(self, into_tray: bool) -> None:
        if self.holds:
            self.holds = False
            where = "in the tray" if into_tray else "put back"
            self.bench.lines.append(f"{self.bench.clock()}  {self.name}: part {self.parts} {where}")
            self.bench.placed[self.name] += into_tray
            self.parts += 1

    def move(self) -> None:
        jammed = self.name == "left" and JAM[0] <= self.bench.now_ns < JAM[1]
        if self.target is None or jammed:
            return
        way = self.target - self.position
        step = SPEED * STEP / SECOND
        self.position = self.target if abs(way) <= step else self.position + (step if way > 0 else -step)


@dataclass
class Bench:
    """Both cells, and what is told of them."""

    seed: int
    now_ns: int = 0
    step_ns: int = STEP
    lines: list[str] = field(default_factory=list)
    placed: dict[str, int] = field(default_factory=lambda: {"left": 0, "right": 0})

    def __post_init__(self) -> None:
        self.chance = random.Random(self.seed)
        self.bodies = {name: Cell(name, self) for name in ("left", "right")}
        self._told = ""

    def clock(self) -> str:
        return f"{self.now_ns / SECOND:5.1f} s"

    def advance(self, until_ns: int) -> None:
        while self.now_ns + STEP <= until_ns:
            self.now_ns += STEP
            for cell in self.bodies.values():
                cell.move()


def make(seed: int) -> Bench:
    """A bench with two cells. One seed, one day of work."""
    return Bench(seed)


def progress(bench: Bench, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """What the cells do, told when it changes."""
    text = "  ".join(f"{name} {doing[name][-1][-1] if doing.get(name) else '-'}" for name in bench.bodies)
    if text != bench._told:
        bench._told = text
        bench.lines.append(f"{bench.clock()}  {text}")
    return bench.lines


def summary(bench: Bench) -> str:
    return "parts in the tray: " + ", ".join(f"{name} {count}" for name, count in bench.placed.items())
