"""A warehouse by night: four zones of four points, four robots with batteries, at times an intruder."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

STEP = 20_000_000
"""A step of the simulation, in ns."""
SECOND = 1_000_000_000
SPEED = 1.2
"""Of a robot, in m/s."""
SIGHT = 6.0
"""How far a robot sees, in metres."""
DRAIN, CHARGE = 0.6, 6.0
"""Per cent a second: what driving costs, and what the dock gives."""
STAYS = 12 * SECOND
"""How long an intruder stays."""
SIDE = 10.0
"""A zone is a square of this side, in metres."""

Point = tuple[float, float]


def point_of(zone: int, point: int) -> Point:
    """The corner `point` (from 0) of the zone (from 1); the zones stand in a square."""
    left, low = SIDE * ((zone - 1) % 2), SIDE * ((zone - 1) // 2)
    return left + (1.5 if point in (0, 3) else SIDE - 1.5), low + (1.5 if point < 2 else SIDE - 1.5)


def dock_of(name: str) -> Point:
    """The docks are in the middle."""
    return SIDE - 0.5 + 0.3 * int(name[-1]), SIDE


@dataclass(frozen=True)
class Percept:
    """What a robot senses: where it is, its battery in per cent, and the intruder, if it sees one."""

    place: Point
    battery: float
    intruder: Point | None


@dataclass
class Robot:
    """A robot on wheels. Its command is the point to drive to, or None to stand."""

    name: str
    house: Warehouse
    place: Point
    battery: float
    target: Point | None = None
    payload_limit: int = 0

    def sense(self) -> Percept:
        intruder = self.house.intruder
        seen = intruder if intruder and math.dist(intruder, self.place) < SIGHT else None
        return Percept(self.place, self.battery, seen)

    def act(self, command: Point | None) -> None:
        self.target = command

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []

    def move(self) -> None:
        seconds = STEP / SECOND
        if self.place == dock_of(self.name):
            self.battery = min(100.0, self.battery + CHARGE * seconds)
        if self.target is None or self.battery <= 0:
            return
        way = math.dist(self.place, self.target)
        if way <= SPEED * seconds:
            self.place = self.target
            return
        share = SPEED * seconds / way
        self.place = tuple(a + share * (b - a) for a, b in zip(self.place, self.target, strict=True))  # type: ignore[assignment]
        self.battery -= DRAIN * seconds


@dataclass
class Warehouse:
    """The house with its robots, and what is told of them."""

    seed: int
    now_ns: int = 0
    step_ns: int = STEP
    intruder: Point | None = None
    lines: list[str] = field(default_factory=list)
    reports: int = 0

    def __post_init__(self) -> None:
        self.chance = random.Random(self.seed)
        self.next_ns = 15 * SECOND
        self.bodies = {
            f"guard{number}": Robot(f"guard{number}", self, point_of(number, 0), 40.0 + 15 * number)
            for number in range(1, 5)
        }
        self._told = ""

    def advance(self, until_ns: int) -> None:
        while self.now_ns + STEP <= until_ns:
            self.now_ns += STEP
            if self.now_ns >= self.next_ns:
                self.come_or_go()
            for robot in self.bodies.values():
                robot.move()

    def come_or_go(self) -> None:
        if self.intruder is None:
            x, y = (self.chance.uniform(1, 2 * SIDE - 1) for _ in range(2))
            self.intruder = x, y
            self.lines.append(f"{self.clock()}  somebody is at {x:.0f}, {y:.0f}")
            self.next_ns = self.now_ns + STAYS
        else:
            self.intruder = None
            self.next_ns = self.now_ns + self.chance.randint(20, 40) * SECOND

    def report(self, name: str) -> None:
        self.reports += 1
        self.lines.append(f"{self.clock()}  {name} reports where somebody was")

    def clock(self) -> str:
        return f"{self.now_ns / SECOND:5.1f} s"


def make(seed: int) -> Warehouse:
    """A night in the warehouse. One seed, one night."""
    return Warehouse(seed)


def progress(house: Warehouse, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """What each guard does, with its battery, told when it changes."""
    states = {name: doing[name][-1][-1] if doing.get(name) else "-" for name in house.bodies}
    text = "  ".join(f"{name} {state}" for name, state in states.items())
    if text != house._told:
        house._told = text
        told = (f"{name} {state} {house.bodies[name].battery:.0f} %" for name, state in states.items())
        house.lines.append(f"{house.clock()}  {'  '.join(told)}")
    return house.lines


def summary(house: Warehouse) -> str:
    left = ", ".join(f"{robot.name} {robot.battery:.0f} %" for robot in house.bodies.values())
    return f"reports: {house.reports}; batteries: {left}"
