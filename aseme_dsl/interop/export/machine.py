"""A statechart as other engines can run it: SCXML's states, transitions without events, and plain data.

What an `.aseme` chart waits for is data here: a flag for each completed activity, event, timer and `after`.
So nothing that was there is lost, and the transitions of all engines mean the same. A flag of an event is set
when it comes, and taken back by the internal event `SETTLED`, which engines look at when nothing else is
enabled.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from enum import StrEnum
from typing import assert_never

from aseme_dsl.amola.expression import Value
from aseme_dsl.records import dataclass

SETTLED = "asemec.settled"
"""The internal event with which a step ends."""

INPUT = "input"
"""The event that gives values to any of the inputs, all at once."""

# ---- terms and conditions ----------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Const:
    value: bool | int | float | str | None


@dataclass(frozen=True, slots=True)
class Ref:
    """A datum, or (`path`) a member of it."""

    name: str
    path: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Given:
    """What the event that is handled says for `name`."""

    name: str


class Sign(StrEnum):
    """What is computed. `%` is Python's, `WHOLE` cuts to an integer, `FLOOR` divides down to one."""

    EQUAL = "=="
    UNEQUAL = "!="
    LESS = "<"
    MOST = "<="
    MORE = ">"
    LEAST = ">="
    PLUS = "+"
    MINUS = "-"
    TIMES = "*"
    OVER = "/"
    REST = "%"
    FLOOR = "//"
    WHOLE = "int"
    NEGATIVE = "neg"
    ABSOLUTE = "abs"
    SMALLEST = "min"
    LARGEST = "max"


@dataclass(frozen=True, slots=True)
class Op:
    sign: Sign
    operands: tuple[Term, ...]


@dataclass(frozen=True, slots=True)
class Pick:
    """`yes` if the condition holds, else `no`; the other one is not looked at."""

    condition: Cond
    yes: Term
    no: Term


@dataclass(frozen=True, slots=True)
class Test:
    """Whether a condition holds, as a value."""

    condition: Cond


Term = Const | Ref | Given | Op | Pick | Test


@dataclass(frozen=True, slots=True)
class Truth:
    """Whether a value is true."""

    term: Term


@dataclass(frozen=True, slots=True)
class Present:
    """Whether a datum and each member on the path is there."""

    what: Ref | Given


@dataclass(frozen=True, slots=True)
class In:
    """Whether a state, by its id, is active."""

    state: str


@dataclass(frozen=True, slots=True)
class All:
    parts: tuple[Cond, ...] = ()


@dataclass(frozen=True, slots=True)
class Some:
    parts: tuple[Cond, ...] = ()


@dataclass(frozen=True, slots=True)
class Inverse:
    part: Cond


Cond = Truth | Present | In | All | Some | Inverse

ALWAYS = All()
NEVER = Some()


def both(*parts: Cond) -> Cond:
    """All of the conditions, without what goes without saying."""
    flat: dict[Cond, None] = {}
    for part in parts:
        for item in part.parts if isinstance(part, All) else (part,):
            if item == NEVER:
                return NEVER
            flat.setdefault(item)
    return next(iter(flat)) if len(flat) == 1 else All(tuple(flat))


def either(*parts: Cond) -> Cond:
    """One of the conditions at least."""
    flat: dict[Cond, None] = {}
    for part in parts:
        for item in part.parts if isinstance(part, Some) else (part,):
            if item == ALWAYS:
                return ALWAYS
            flat.setdefault(item)
    return next(iter(flat)) if len(flat) == 1 else Some(tuple(flat))


def opposite(part: Cond) -> Cond:
    """Whether a condition does not hold."""
    if part == ALWAYS:
        return NEVER
    if part == NEVER:
        return ALWAYS
    return part.part if isinstance(part, Inverse) else Inverse(part)


def asks_for_states(cond: Cond) -> bool:
    """Whether a condition asks which states are active, other than inside a value."""
    match cond:
        case In():
            return True
        case All(parts=parts) | Some(parts=parts):
            return any(asks_for_states(part) for part in parts)
        case Inverse(part=part):
            return asks_for_states(part)
        case Truth() | Present():
            return False
    assert_never(cond)


# ---- what is done ------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Set:
    name: str
    value: Term


@dataclass(frozen=True, slots=True)
class If:
    condition: Cond
    then: tuple[Act, ...]
    otherwise: tuple[Act, ...] = ()


@dataclass(frozen=True, slots=True)
class Schedule:
    """Send `event` to the chart itself after so many ns; an earlier one of that name is no longer sent."""

    event: str
    delay: Term


@dataclass(frozen=True, slots=True)
class Unschedule:
    event: str


@dataclass(frozen=True, slots=True)
class Raise:
    """An internal event."""

    event: str


@dataclass(frozen=True, slots=True)
class Emit:
    """An event for the surroundings."""

    event: str
    parameters: tuple[tuple[str, Term], ...]


Act = Set | If | Schedule | Unschedule | Raise | Emit

# ---- the chart ---------------------------------------------------------------------------------


class Shape(StrEnum):
    COMPOUND = "compound"
    PARALLEL = "parallel"
    ATOMIC = "atomic"
    FINAL = "final"


@dataclass(frozen=True, slots=True)
class Move:
    """A transition without an event; `targets` are ids, without any the state stays. `text`: as written."""

    condition: Cond
    targets: tuple[str, ...]
    acts: tuple[Act, ...]
    text: str
    place: str


@dataclass(frozen=True, slots=True)
class Vertex:
    """A state. The first of its `children` is where a COMPOUND begins."""

    id: str
    label: str
    title: str
    shape: Shape
    activity: str | None = None
    entry: tuple[Act, ...] = ()
    exit: tuple[Act, ...] = ()
    moves: tuple[Move, ...] = ()
    children: tuple[Vertex, ...] = ()

    def inside(self) -> Iterator[Vertex]:
        """The state and all in it, in document order."""
        stack = [self]
        while stack:
            item = stack.pop()
            yield item
            stack.extend(reversed(item.children))


@dataclass(frozen=True, slots=True)
class Datum:
    """A value that the chart has; an `is_input` is given from outside. `text` says what it is."""

    name: str
    initial: bool | int | float | str | None
    text: str
    is_input: bool = False
    kind: str = ""
    """The type, in the words of the language."""
    given: Value | None = None
    """Of an input that the surroundings work out: from what."""


@dataclass(frozen=True, slots=True)
class Handler:
    """What an event does in every state."""

    event: str
    acts: tuple[Act, ...]
    text: str


@dataclass(frozen=True, slots=True)
class Machine:
    """A chart: `ended` is the condition under which the agent has finished."""

    name: str
    system: str
    source: str
    root: Vertex
    ended: Cond
    data: tuple[Datum, ...]
    handlers: tuple[Handler, ...]
    emitted: tuple[str, ...] = field(default=())
