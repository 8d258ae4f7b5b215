"""A warehouse: shelves with pallets, a gate, eight carriers with batteries, and orders that come in."""

from __future__ import annotations

import math
import random
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

STEP = 50_000_000
"""A step of the simulation, in ns."""
SECOND = 1_000_000_000
SPEED = 1.5
"""Of a carrier, in m/s."""
DRAIN, CHARGE = 0.7, 4.0
"""Per cent a second: what driving costs, and what the dock gives."""
ORDERS = 24
"""So many orders come in one shift."""
SLIPS = 0.15
"""How often the fork does not get hold of a pallet."""
BURNS = ("carrier5", 30 * SECOND)
"""Whose motor burns, and when."""

Point = tuple[float, float]

GATE: Point = (30.0, 9.0)


def shelf(name: str) -> Point:
    """Where a shelf stands: `C4` is the fourth of the third row."""
    return 5.0 + 3.0 * int(name[1:]), 3.0 * (ord(name[0]) - ord("A") + 1)


def dock(name: str) -> Point:
    """Where a carrier stands and is charged: along the wall."""
    return 1.0, 2.0 * int(name.removeprefix("carrier"))


@dataclass(frozen=True)
class Order:
    """A pallet that is to be brought to the gate."""

    id: str
    shelf: str


# ---- what is done: the commands ------------------------------------------------------------------------


@dataclass(frozen=True)
class Take:
    """The desk: this clerk takes an order. A carrier: it takes on a job, or none (`""`)."""

    id: str
    clerk: str = ""


@dataclass(frozen=True)
class Close:
    """The desk: the order of this clerk is at the gate, or waits again, and why."""

    clerk: str
    done: bool
    why: str


@dataclass(frozen=True)
class Drive:
    """A carrier: it drives to a place, or stands."""

    target: Point | None


@dataclass(frozen=True)
class Lift:
    """A carrier: it lifts what is in front of it."""


@dataclass(frozen=True)
class Plug:
    """A carrier: it takes the plug, or lets it go."""

    charging: bool


# ---- what is sensed, and the bodies --------------------------------------------------------------------


@dataclass(frozen=True)
class Office:
    """What the desk sees: the orders that wait, the longest first, and which clerk has which."""

    waiting: tuple[Order, ...]
    taken: Mapping[str, Order]


@dataclass(frozen=True)
class Percept:
    """What a carrier senses: its place, battery (per cent), job and fork, and whether its motor turns."""

    place: Point
    battery: float
    job: str
    loaded: bool
    charging: bool
    turns: bool


@dataclass
class Desk:
    """Where the orders come in. Its clerks talk about one order each."""

    name: str
    hall: Hall
    payload_limit: int = 0

    def sense(self) -> Office:
        with self.hall.lock:
            return Office(tuple(self.hall.waiting), dict(self.hall.taken))

    def act(self, command: Take | Close) -> None:
        with self.hall.lock:
            match command:
                case Take(number, clerk):
                    self.hall.take(number, clerk)
                case Close(clerk, done, why):
                    self.hall.close(clerk, done, why)

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []


@dataclass
class Carrier:
    """A robot with a fork."""

    name: str
    hall: Hall
    place: Point
    battery: float
    chance: random.Random
    target: Point | None = None
    job: str = ""
    loaded: bool = False
    charging: bool = False
    payload_limit: int = 0

    def sense(self) -> Percept:
        burnt = self.name == BURNS[0] and self.hall.now_ns >= BURNS[1]
        return Percept(self.place, self.battery, self.job, self.loaded, self.charging, not burnt)

    def act(self, command: Take | Drive | Lift | Plug) -> None:
        with self.hall.lock:
            match command:
                case Take(job) if not job or not (self.job or self.charging):
                    self.job, self.loaded = job, False
                case Drive(target):
                    self.target = target
                case Lift():
                    self.loaded = self.chance.random() >= SLIPS
                case Plug(charging):
                    self.charging = charging and not self.job

    def say(self, payload: bytes) -> bool:
        return False

    def hear(self) -> list[object]:
        return []

    def move(self) -> None:
        seconds = STEP / SECOND
        if self.charging and self.place == dock(self.name):
            self.battery = min(100.0, self.battery + CHARGE * seconds)
        if self.target is None or self.battery <= 0 or not self.sense().turns:
            return
        way = math.dist(self.place, self.target)
        self.battery -= DRAIN * seconds
        if way <= SPEED * seconds:
            self.place = self.target
            return
        share = SPEED * seconds / way
        (x, y), (to_x, to_y) = self.place, self.target
        self.place = x + share * (to_x - x), y + share * (to_y - y)


@dataclass
class Hall:
    """The hall with its desk and its carriers, and what is told of them."""

    seed: int
    now_ns: int = 0
    step_ns: int = STEP
    taken: dict[str, Order] = field(default_factory=dict)
    waiting: list[Order] = field(default_factory=list)
    delivered: int = 0
    again: dict[str, int] = field(default_factory=dict)
    lines: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.lock = threading.RLock()
        self.chance = random.Random(self.seed)
        self.carriers = {}
        for number in range(1, 9):
            name = f"carrier{number}"
            chance = random.Random(self.chance.random())
            self.carriers[name] = Carrier(name, self, dock(name), 36.0 + 8 * number, chance)
        self.bodies: dict[str, Desk | Carrier] = {"desk": Desk("desk", self), **self.carriers}
        self.came = 0
        self.next_ns = SECOND

    def advance(self, until_ns: int) -> None:
        while self.now_ns + STEP <= until_ns:
            self.now_ns += STEP
            with self.lock:
                if self.came < ORDERS and self.now_ns >= self.next_ns:
                    self.come()
                for carrier in self.carriers.values():
                    carrier.move()

    def come(self) -> None:
        """An order comes in."""
        self.came += 1
        order = Order(str(self.came), f"{self.chance.choice('ABCDE')}{self.chance.randint(1, 7)}")
        self.waiting.append(order)
        self.tell(f"order {order.id} ({order.shelf})")
        self.next_ns = self.now_ns + self.chance.randint(2, 8) * SECOND

    def take(self, number: str, clerk: str) -> None:
        """A clerk takes an order, if it still waits."""
        order = next((item for item in self.waiting if item.id == number), None)
        if order is not None and clerk not in self.taken:
            self.waiting.remove(order)
            self.taken[clerk] = order

    def close(self, clerk: str, done: bool, why: str) -> None:
        """The order of a clerk is at the gate, or waits again."""
        order = self.taken.pop(clerk)
        if done:
            self.delivered += 1
            self.tell(f"order {order.id} ({order.shelf}) is at the gate: {why}")
        else:
            self.waiting.append(order)
            self.again[why] = self.again.get(why, 0) + 1
            self.tell(f"order {order.id} ({order.shelf}) again: {why}")

    def tell(self, text: str) -> None:
        self.lines.append(f"{self.now_ns / SECOND:5.1f} s  {text}")


def make(seed: int) -> Hall:
    """A shift in the warehouse. One seed, one shift."""
    return Hall(seed)


def progress(hall: Hall, doing: Mapping[str, Sequence[Sequence[str]]]) -> list[str]:
    """What has happened."""
    return hall.lines


def summary(hall: Hall) -> str:
    again = ", ".join(f"{why} {times}" for why, times in sorted(hall.again.items())) or "none"
    return f"at the gate: {hall.delivered} of {hall.came} pallets; announced again: {again}"
