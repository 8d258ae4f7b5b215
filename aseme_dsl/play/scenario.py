"""Scenario: what is played, as the compiler has understood it.

Conditions have numbers, their places in `Script.conditions`; each stands behind those that it is made of.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.srm import Guarantee
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import Rule
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.source import Span

# ---- conditions -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class InPlaces:
    """At least so many of the agents are in one of the places, which are labels of their statecharts."""

    places: Mapping[str, frozenset[str]]
    """The labels by agent."""
    least: int = 1


@dataclass(frozen=True, slots=True)
class Says:
    """A message was sent (by one of the `agents`, if they are named) or, with `is_received`, received.

    `what` is a channel, or with `is_kind` a type of message. `condition` is about the message.
    """

    what: str
    is_kind: bool
    is_received: bool
    performative: str | None
    agents: frozenset[str] | None
    condition: Value | None


@dataclass(frozen=True, slots=True)
class Holds:
    """An expression is true for what an agent has received last, and for its variables."""

    agent: str
    value: Value


@dataclass(frozen=True, slots=True)
class Untaken:
    """An agent message has come to one of the `agents` (to any, if None), and nothing takes it.

    `kind` is the type of the message, for any performative if that is None.
    """

    kind: str
    performative: str | None
    agents: frozenset[str] | None


@dataclass(frozen=True, slots=True)
class Breached:
    """An activity publishes what it guarantees not to publish."""

    activity: str
    guarantee: Guarantee
    agents: frozenset[str]
    """Those that perform it."""


@dataclass(frozen=True, slots=True)
class Faulty:
    """A fault was recorded."""


@dataclass(frozen=True, slots=True)
class Failed:
    """One of the agents has failed."""

    agents: frozenset[str]


@dataclass(frozen=True, slots=True)
class AllOf:
    """Each of the conditions."""

    parts: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AnyOf:
    """One of the conditions."""

    parts: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class NotSo:
    """The opposite of a condition."""

    part: int


Condition = InPlaces | Says | Untaken | Holds | Breached | Faulty | Failed | AllOf | AnyOf | NotSo


def parts_of(condition: Condition) -> tuple[int, ...]:
    """The numbers of the conditions of which one is made."""
    match condition:
        case AllOf(parts=parts) | AnyOf(parts=parts):
            return parts
        case NotSo(part=part):
            return (part,)
        case _:
            return ()


def all_parts(conditions: Sequence[Condition], numbers: Iterable[int]) -> Iterator[int]:
    """Conditions, and those that they are made of."""
    waiting = list(numbers)
    while waiting:
        number = waiting.pop(0)
        yield number
        waiting += parts_of(conditions[number])


# ---- what is expected -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Share:
    """In at least so many of the runs with the seeds from 1 on."""

    least: int
    seeds: int


@dataclass(frozen=True, slots=True)
class PaceAssumed:
    """While an activity runs, so long passes between what it writes on a channel."""

    activity: str
    channel: str
    every: Lasts
    span: Span


@dataclass(frozen=True, slots=True)
class DurationAssumed:
    """An activity takes so long."""

    activity: str
    takes: Lasts
    span: Span


@dataclass(frozen=True, slots=True)
class CrashesAssumed:
    """At most so many of the agents crash."""

    most: int
    agents: frozenset[str]
    span: Span


PERFECT = Network()
"""No delay, no loss."""


@dataclass(frozen=True, slots=True)
class NetworkAssumed:
    """The network is as good as this. `broken_at` is when that of the run is worse, if it ever is."""

    broken_at: int | None
    span: Span
    network: Network = PERFECT


@dataclass(frozen=True, slots=True)
class FailuresAssumed:
    """An activity may fail. No run can break that: only proofs ask for it."""

    activity: str
    span: Span


@dataclass(frozen=True, slots=True)
class ValueAssumed:
    """A condition of an agent is never false. What is absent is neither."""

    agent: str
    value: Value
    span: Span


Assumption = PaceAssumed | DurationAssumed | CrashesAssumed | NetworkAssumed | FailuresAssumed | ValueAssumed


GUARANTEE = "guarantee of "
"""How `of` begins in what an activity guarantees."""


@dataclass(frozen=True, slots=True)
class Expectation:
    """A rule, with its place. It is vacuous if one of the `witnesses` was met in no run.

    `of` says of which property, clause or guarantee it is, if it is not of the scenario itself. With a
    `protocol` it is about each conversation of that. `parts` are the places of the conditions of the rule, in
    their order.
    """

    rule: Rule
    span: Span
    witnesses: tuple[int, ...] = ()
    share: Share | None = None
    of: str = ""
    protocol: str | None = None
    parts: tuple[Span, ...] = ()


# ---- what happens -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Content:
    """A message on a channel, with the members that are given.

    With a `performative` it is an agent message, and `channel` is the type of its content.
    """

    channel: str
    members: tuple[tuple[tuple[str, ...], Value], ...]
    span: Span
    performative: str | None = None


@dataclass(frozen=True, slots=True)
class Receives:
    agent: str
    content: Content
    sender: str


@dataclass(frozen=True, slots=True)
class Raises:
    agent: str
    event: str


@dataclass(frozen=True, slots=True)
class Crashes:
    agent: str


@dataclass(frozen=True, slots=True)
class Restarts:
    agent: str


@dataclass(frozen=True, slots=True)
class Does:
    """An activity of an agent acts, and ends if it `is_end`: with the outcome of `acting`, if it has one. Or
    it `fails`.

    Before that, it takes agent messages, each given by its performative and type, and signals, each given by
    its channel alone; and it prepares contents.
    """

    agent: str
    acting: Acting
    is_end: bool
    prepares: tuple[Content, ...]
    takes: tuple[tuple[str | None, str], ...]
    sends: tuple[tuple[Content, str], ...] = ()
    """Agent messages, each to a participant."""
    fails: bool = False


@dataclass(frozen=True, slots=True)
class Gets:
    """What is on its way from `sender` arrives, or `is_lost`: on a channel, or an agent message.

    `what` is the channel, or the type of the message with this performative; "" for any type.
    """

    agent: str
    sender: str
    performative: str | None
    what: str
    is_lost: bool


@dataclass(frozen=True, slots=True)
class Computes:
    """From now on, a function gives this value to an agent, or `random()` draws it."""

    agent: str
    function: str
    value: Value


Act = Receives | Raises | Crashes | Restarts | Does | Gets | Computes


@dataclass(frozen=True, slots=True)
class Stimulus:
    """An act, at `moment`; or, with a `trigger`, so many ns after the first occurrence of that condition."""

    act: Act
    moment: int
    span: Span
    trigger: int | None = None


@dataclass(frozen=True, slots=True)
class Cut:
    """From `first` to `last`, nothing passes between these agents and the others."""

    agents: frozenset[str]
    first: int
    last: int


# ---- the surroundings -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Lasts:
    """How long something lasts: from `least` to `most` ns, or normally distributed (mean, deviation)."""

    least: int
    most: int
    is_normal: bool = False


@dataclass(frozen=True, slots=True)
class Writes:
    """A message that an activity publishes when it ends, or (`every`) again and again."""

    content: Content
    every: Lasts | None


@dataclass(frozen=True, slots=True)
class Acting:
    """What an activity does instead of its code; `real`: its code. When it ends, it publishes what it
    `writes`, and `sends` agent messages."""

    activity: str
    span: Span
    real: bool = False
    lasts: Lasts | None = None
    ends: tuple[str, ...] = ()
    fails_at: int | None = None
    writes: tuple[Writes, ...] = ()
    sets: tuple[tuple[str, Value], ...] = ()
    sends: tuple[Content, ...] = ()


@dataclass(frozen=True, slots=True)
class Given:
    """`given n in 0..300`: a whole number where `is_whole`."""

    name: str
    least: float
    most: float
    is_whole: bool
    span: Span


@dataclass(frozen=True, slots=True)
class Silent:
    """A statement of the property of this name that says nothing of a team: it `is_refused` for every team,
    or no agent that it speaks of takes part."""

    name: str
    span: Span
    reason: str
    is_refused: bool


@dataclass(frozen=True, slots=True)
class Script:
    """One way to play a scenario. `values` are those of a row of its table."""

    team: tuple[tuple[str, str], ...]
    """The agents with their roles."""
    activities: tuple[Acting, ...]
    network: Network | None
    cuts: tuple[Cut, ...]
    stimuli: tuple[Stimulus, ...]
    conditions: tuple[Condition, ...]
    expectations: tuple[Expectation, ...]
    inputs: tuple[Given, ...]
    values: Mapping[str, object]
    cells: Mapping[str, str]
    """What the row gives the columns, as the file has it."""
    until: int
    """The end of the run (ns)."""
    is_open: bool
    """Whether it is that of a run of the project, if that is later."""
    world: str | None = None
    """The function that makes the world in which it is played; "": the project's, if it has one."""
    assumptions: tuple[Assumption, ...] = ()
    stepwise: int | None = None
    """If it is played by hand, the moment until which it is: till then activities end and messages arrive
    only as the stimuli say."""
    silent: tuple[Silent, ...] = ()


@dataclass(frozen=True, slots=True)
class Refused:
    """Why a scenario is not played."""

    span: Span
    reason: str


@dataclass(frozen=True, slots=True)
class Scenario:
    """A scenario with a script for each row of its table (one without a table)."""

    name: str
    span: Span
    scripts: tuple[Script, ...]
    refused: Refused | None = None
    points: int | None = None
    """What a teacher gives for it."""
    block: Span | None = None
    """All of it in the file, if it is played."""


__all__ = [
    "GUARANTEE",
    "Act",
    "Acting",
    "AllOf",
    "AnyOf",
    "Assumption",
    "Breached",
    "Computes",
    "Condition",
    "Content",
    "Crashes",
    "Cut",
    "Does",
    "Expectation",
    "Failed",
    "FailuresAssumed",
    "Faulty",
    "Gets",
    "Given",
    "Holds",
    "InPlaces",
    "Lasts",
    "NotSo",
    "Raises",
    "Receives",
    "Refused",
    "Restarts",
    "Says",
    "Scenario",
    "Script",
    "Share",
    "Silent",
    "Stimulus",
    "Untaken",
    "ValueAssumed",
    "Writes",
    "all_parts",
    "parts_of",
]
