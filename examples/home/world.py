"""A house: somebody who walks from room to room, lamps, heaters, a fire on the stove, and a button."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

STEP = 100_000_000
"""A step of the simulation, in ns."""
SECOND = 1_000_000_000
ROOMS = ("hall", "kitchen", "bath", "bedroom")
FIRE = (200 * SECOND, 215 * SECOND)
"""When the stove burns; at the end somebody presses the button."""
OUTSIDE = 8.0
"""Degrees Celsius."""


@dataclass(frozen=True)
class Percept:
    """What a room senses."""

    motion: bool
    temperature: float
    lux: float
    fire: bool
    away: bool
    pressed: bool


@dataclass
class Room:
    """A room. Its command is ("lamp", on) or ("heater", on)."""

    name: str
    house: House
    temperature: float = 19.0
    lamp: bool = False
    heater: bool = False
    pressed: bool = False
    payload_limit: int = 0

    def sense(self) -> Percept:
        now = self.house.now_ns
        lux = 120.0 if self.lamp else 8.0
        here = self.house.person == self.name
        fire = FIRE[0] <= now < FIRE[1]
        return Percept(here, self.temperature, lux, fire, self.house.person == "", self.pressed)

    def act(self, command: tuple[str, bool]) -> None:
        what, on = command
        if getattr(self, what) != on:
            setattr(self, what, on)
            self.house.tell(f"{self.name}: {what} {'on' if on else 'off'}")

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []

    def live(self) -> None:
        seconds = STEP / SECOND
        self.temperature += seconds * (0.1 * self.heater - 0.002 * (self.temperature - OUTSIDE))


@dataclass
class House:
    """The house, and what is told of it."""

    seed: int
    now_ns: int = 0
    step_ns: int = STEP
    person: str = "hall"
    """Where the one who lives here is; "" when out."""
    lines: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.chance = random.Random(self.seed)
        self.bodies = {name: Room(name, self, 17.0 + number) for number, name in enumerate(ROOMS)}
        self.next_ns = 20 * SECOND

    def advance(self, until_ns: int) -> None:
        while self.now_ns + STEP <= until_ns:
            self.now_ns += STEP
            if self.now_ns >= self.next_ns:
                self.walk()
            for room in self.bodies.values():
                room.pressed = self.now_ns == FIRE[1]
                room.live()

    def walk(self) -> None:
        self.person = self.chance.choice([place for place in (*ROOMS, "") if place != self.person])
        self.next_ns = self.now_ns + self.chance.randint(15, 60) * SECOND
        self.tell(f"somebody is in the {self.person}" if self.person else "nobody is at home")

    def tell(self, text: str) -> None:
        self.lines.append(f"{self.now_ns / SECOND:6.1f} s  {text}")


def make(seed: int) -> House:
    """An evening in the house. One seed, one evening."""
    return House(seed)


def progress(house: House, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """What was switched, and where somebody is."""
    return house.lines


def summary(house: House) -> str:
    return ", ".join(f"{room.name} {room.temperature:.1f} °C" for room in house.bodies.values())
