"""Statements: what scenarios and properties say, as nodes over the tree's names and expressions."""

from __future__ import annotations

from aseme_dsl.grammar.text.tree import Duration, Expression, Fill, Name, Path, Place, Text
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.source import Span

# ---- conditions -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class InState:
    """`robot1 in ScanForBall`, or a state alone (`agent` None).

    `which` is the word before a role: `some`, `every` or `any`.
    """

    agent: Name | None
    places: tuple[Place, ...]
    span: Span
    which: str = ""


@dataclass(frozen=True, slots=True)
class Holds:
    """An expression: a condition that is true; of an agent with `robot1 has [c]`."""

    agent: Name | None
    expression: Expression
    span: Span
    which: str = ""


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
    which: str = ""


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
class Lasts:
    """`2s`, `1s..3s`; or `normal(2s, 300ms)`, of which `most` is the deviation."""

    least: Duration
    most: Duration
    is_normal: bool = False


@dataclass(frozen=True, slots=True)
class Simulated:
    """`activity Grasp takes 1s ends held`: what an activity does instead of its code.

    `writes` are messages, each with its pace, `sets` the variables with their values.
    """

    activity: Name
    is_real: bool
    takes: Lasts | None
    ends: tuple[Name, ...]
    fails: Duration | None
    writes: tuple[tuple[Filled, Lasts | None], ...]
    sends: tuple[Filled, ...]
    sets: tuple[tuple[Name, Expression], ...]
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
    """`network …`, `world …`, `for 10s`, `stepwise until 5s`, `points 3`, `assume fair`: it names nothing."""

    word: str
    span: Span
    network: Network | None = None
    duration: Duration | None = None
    points: int | None = None
    world: str = ""
    """The function that makes it, `module:function`, if one is named."""


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
class Does:
    """`robot1 ends Grasp with slipped sets n = 3`, `robot1 does Look writes …`, `robot1 fails Kick`.

    `verb` is the word behind the agent. It `sends` agent messages, each to a participant. It
    `takes` others, each given with its performative, and signals, which have none.
    """

    agent: Name
    activity: Name
    verb: str
    outcome: Name | None
    sets: tuple[tuple[Name, Expression], ...]
    writes: tuple[Filled, ...]
    sends: tuple[tuple[Filled, Name], ...]
    prepares: tuple[Filled, ...]
    takes: tuple[tuple[Name | None, Path], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Gets:
    """`robot2 gets request Tool from robot1`, `robot2 misses vision.data.Ball from robot1`.

    Without `what`, the performative says all: `gets lost from robot1`.
    """

    agent: Name
    performative: Name | None
    what: Path | None
    sender: Name
    is_lost: bool
    span: Span


@dataclass(frozen=True, slots=True)
class Computes:
    """`robot1 computes near = true`: what a function gives from now on."""

    agent: Name
    function: Name
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Hit:
    """`crash robot1 at 6s`, `robot1 loses radio`, `partition { a } | { b }` with its `groups`."""

    word: str
    agents: tuple[Name, ...]
    span: Span
    groups: tuple[tuple[Name, ...], ...] = ()


@dataclass(frozen=True, slots=True)
class Reached:
    """Expectations that no verb begins: what `at`, `by`, `after` and `within` wait for."""

    condition: Condition
    span: Span


Event = Receives | Raises | Does | Gets | Computes | Hit | Reached


@dataclass(frozen=True, slots=True)
class Timed:
    """`at 2s …`, `by 3s …`, `from 3s for 2s …`, and relative to what happens: `after`, `within … of`.

    The times of `from` are the first and the last moment.
    """

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

    word: str
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
    times: tuple[Lasts, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class AssumedSo:
    """`assume robot1 has [my.state.Identity.number == 1]`, `assume every player has [...]`."""

    condition: Holds
    span: Span


@dataclass(frozen=True, slots=True)
class Share:
    """`in 95% of 200 seeds`"""

    percent: Expression
    seeds: Expression
    span: Span


Statement = (
    TakesPart | Simulated | Input | Table | Setup | Hit | Timed | Rule | Several | Fails | Assumed | AssumedSo
)

__all__ = [
    "Assumed",
    "AssumedSo",
    "Computes",
    "Condition",
    "Does",
    "Ended",
    "Event",
    "Fails",
    "Fault",
    "Filled",
    "Gets",
    "Heard",
    "Hit",
    "Holds",
    "InState",
    "Input",
    "Joined",
    "Lasts",
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
