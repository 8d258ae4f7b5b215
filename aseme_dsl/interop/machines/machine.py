"""Machine: what SCXML and XState have in common, with the place of each part in its file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from enum import Enum

from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

LARGEST = 3_000
"""How many states, transitions, actions and variables a machine may have together."""


class Shape(Enum):
    """What a state of a machine is."""

    STATE = "state"
    PARALLEL = "parallel"
    FINAL = "final"
    HISTORY = "history"


@dataclass(frozen=True, slots=True)
class Assigning:
    """`variable` becomes the value of an expression in ECMAScript."""

    variable: str
    value: str
    place: Span


@dataclass(frozen=True, slots=True)
class Raising:
    """An event for the machine itself. One that was sent comes after those that were raised."""

    event: str
    place: Span
    is_sent: bool = False


@dataclass(frozen=True, slots=True)
class Delaying:
    """An event for the machine itself after `delay` ns, which may be cancelled by its `id`."""

    event: str
    delay: int
    place: Span
    id: str = ""


@dataclass(frozen=True, slots=True)
class Cancelling:
    """The delayed event of this id does not come."""

    id: str
    place: Span


@dataclass(frozen=True, slots=True)
class Noting:
    """What only says something, as a log does."""

    text: str
    place: Span


@dataclass(frozen=True, slots=True)
class Other:
    """What the language does not have: `text` is what stands there, `why` the reason."""

    text: str
    why: str
    place: Span


Doing = Assigning | Raising | Delaying | Cancelling | Noting | Other


@dataclass(slots=True)
class Move:
    """A transition. `events` are descriptors as they stand, none for one that needs no event.

    `after` ns since its source was entered take the place of an event. `guard` is an expression, "" if there
    is none, or None if there is one that is only named: `named`. Without targets the source stays active.
    """

    events: tuple[str, ...]
    targets: tuple[str, ...]
    place: Span
    guard: str | None = ""
    named: str = ""
    does: tuple[Doing, ...] = ()
    is_internal: bool = False
    after: int | None = None


@dataclass(slots=True)
class Node:
    """A state, by its id. `initial` are the ids of where it begins; "" for an invoked `activity` if none."""

    id: str
    shape: Shape
    place: Span
    parent: Node | None = None
    children: list[Node] = field(default_factory=list)
    initial: tuple[str, ...] = ()
    initial_does: tuple[Doing, ...] = ()
    entry: tuple[Doing, ...] = ()
    exit: tuple[Doing, ...] = ()
    moves: list[Move] = field(default_factory=list)
    activity: str = ""
    is_named: bool = True
    """Whether its id stands in the file."""


@dataclass(frozen=True, slots=True)
class Datum:
    """A variable with its first value as an expression, "" if there is none."""

    name: str
    value: str
    place: Span


@dataclass(frozen=True, slots=True)
class Lost:
    """An element that says something the language has no words for."""

    element: str
    why: str
    place: Span
    is_harmless: bool = False
    """Whether the machine does the same without it."""


@dataclass(slots=True)
class Machine:
    """A machine. What is around its outermost states is `root`, which is not a state in SCXML."""

    name: str
    format: str
    root: Node
    data: tuple[Datum, ...] = ()
    lost: list[Lost] = field(default_factory=list)

    def nodes(self) -> Iterator[Node]:
        """All states in document order, the root first."""
        waiting = [self.root]
        while waiting:
            node = waiting.pop()
            yield node
            waiting += reversed(node.children)


def beyond(machine: Machine) -> Span | None:
    """The place at which a machine becomes too large, if it does."""
    left = LARGEST - len(machine.data)
    for node in machine.nodes():
        left -= 1 + len(node.entry) + len(node.exit) + len(node.initial_does)
        left -= sum(1 + len(move.does) + len(move.events) + len(move.targets) for move in node.moves)
        if left < 0:
            return node.place
    return None


def matches(descriptor: str, event: str) -> bool:
    """Whether an event descriptor of SCXML is for an event: it is a prefix of its words."""
    plain = descriptor.removesuffix("*").removesuffix(".")
    return not plain or event == plain or event.startswith(f"{plain}.")


def around(node: Node) -> Iterator[Node]:
    """The states around one, the innermost first."""
    while node.parent is not None:
        node = node.parent
        yield node


__all__ = [
    "LARGEST",
    "Assigning",
    "Cancelling",
    "Datum",
    "Delaying",
    "Doing",
    "Lost",
    "Machine",
    "Move",
    "Node",
    "Noting",
    "Other",
    "Raising",
    "Shape",
    "around",
    "beyond",
    "matches",
]
