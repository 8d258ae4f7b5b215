"""Statements: what scenarios and properties say, as nodes over the tree's names and expressions."""

from __future__ import annotations

from dataclasses import dataclass

from aseme_dsl.grammar.text.tree import Duration, Expression, Fill, Name, Path, Place, Text
from aseme_dsl.source import Span

# ---- conditions -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class InState:
    """`robot1 in ScanForBall`, or a state alone (`agent` None)."""

    agent: Name | None
    places: tuple[Place, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Holds:
    """An expression: a condition that is true; of an agent with `robot1 has [c]`."""

    agent: Name | None
    expression: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Heard:
    """`sent Pass p by robot1 [p.to == 2]`; `what` is a type of message or a channel."""

    verb: Name
    performative: Name | None
    what: Path
    called: Name | None
    agent: Name | None
    condition: Expression | None
    span: Span


@dataclass(frozen=True, slots=True)
class Ended:
    """`outcome "…"`: a protocol has ended so."""

    text: Text
    span: Span


@dataclass(frozen=True, slots=True)
class Fault:
    """`fault`: a record of a fault."""

    span: Span


@dataclass(frozen=True, slots=True)
class Joined:
    """Conditions between `and`, `or` or behind `not`."""

    operator: str
    parts: tuple[Condition, ...]
    span: Span


Condition = InState | Holds | Heard | Ended | Fault | Joined

# ---- statements -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class TakesPart:
    """`robot1, robot2 : player`; a range is (least, most)."""

    agents: tuple[tuple[Name, tuple[int, int] | None], ...]
    role: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Filled:
    """`vision.state.Ball { visible = true }`, or `propose Bid { cost = 3 }`."""

    performative: Name | None
    what: Path
    fills: tuple[Fill, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Simulated:
    """`activity Grasp takes 1s ends held`: what an activity does instead of its code.

    `sets` are the variables with their values, `times` all durations.
    """

    activity: Name
    ends: tuple[Name, ...]
    writes: tuple[Filled, ...]
    sends: tuple[Filled, ...]
    sets: tuple[tuple[Name, Expression], ...]
    times: tuple[tuple[Duration, Duration], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Input:
    """`given n in 0..300`"""

    name: Name
    least: Expression
    most: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Table:
    """`table (d, expected) { (50, KickBall) (200, WalkTowardsBall) }`"""

    columns: tuple[Name, ...]
    rows: tuple[tuple[tuple[Expression, ...], Span], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Setup:
    """`network …`, `world …`, `for 10s`, `points 3`, `assume fair`: what names nothing of the system."""

    word: str
    span: Span


@dataclass(frozen=True, slots=True)
class Receives:
    """`robot1 receives vision.state.Ball { … } from robot2`"""

    agent: Name
    message: Filled
    sender: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class Raises:
    """`robot1 raises Whistle`"""

    agent: Name
    event: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Hit:
    """`crash robot1 at 6s`, `robot1 loses radio`, `partition { a } | { b }`."""

    word: str
    agents: tuple[Name, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Reached:
    """Expectations that no verb begins: what `at`, `by`, `after` and `within` wait for."""

    condition: Condition
    span: Span


Event = Receives | Raises | Hit | Reached


@dataclass(frozen=True, slots=True)
class Timed:
    """`at 2s …`, `by 3s …`, `from 3s for 2s …`, and relative to what happens: `after`, `within … of`."""

    word: str
    times: tuple[Duration, ...]
    of: Condition | None
    event: Event
    share: Share | None
    span: Span


@dataclass(frozen=True, slots=True)
class Rule:
    """`always C`, `never C`, `X before Y`, `every X leads to Y within 1s`, `in order X, Y`, …"""

    word: str
    conditions: tuple[Condition, ...]
    within: Duration | None
    share: Share | None
    span: Span


@dataclass(frozen=True, slots=True)
class Several:
    """`never two of player in center`, `at most one center`, `assume at most 1 of player crash`."""

    count: int
    role: Name | None
    places: tuple[Place, ...]
    share: Share | None
    span: Span


@dataclass(frozen=True, slots=True)
class Fails:
    """`robot1 fails by 5s`"""

    agent: Name
    by: Duration
    span: Span


@dataclass(frozen=True, slots=True)
class Assumed:
    """`assume Vision writes vision.state.Ball every 33ms..100ms`, `assume Grasp may fail`."""

    activity: Name
    writes: Path | None
    times: tuple[tuple[Duration, Duration], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Share:
    """`in 95% of 200 seeds`"""

    percent: Expression
    seeds: Expression
    span: Span


Statement = TakesPart | Simulated | Input | Table | Setup | Hit | Timed | Rule | Several | Fails | Assumed

__all__ = [
    "Assumed",
    "Condition",
    "Ended",
    "Event",
    "Fails",
    "Fault",
    "Filled",
    "Heard",
    "Hit",
    "Holds",
    "InState",
    "Input",
    "Joined",
    "Raises",
    "Reached",
    "Receives",
    "Rule",
    "Setup",
    "Several",
    "Share",
    "Simulated",
    "Statement",
    "Table",
    "TakesPart",
    "Timed",
]
