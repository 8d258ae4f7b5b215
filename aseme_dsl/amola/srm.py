"""SRM, System Roles Model (P1, section 4.2 and Figure 4): protocols, formulas and activities of a role."""

from __future__ import annotations

from aseme_dsl.amola.aip import DeclaredVariable, NamedFormula, Plays
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import Channel, Parameter
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Subscription:
    """What an activity reads: a channel kept for `history` ns, or (channel None) a whole `topic`.

    `reach` is "on", "above", "below" or "around": which topics of the tree are meant.
    """

    channel: Channel | None
    topic: str
    reach: str
    history: int
    host: str | None
    span: Span


@dataclass(frozen=True, slots=True)
class Sent:
    """A message of this type that an activity publishes on one of the channels. Conditions call it `called`.

    The condition knows messages as parameters (`ParameterValue`); None is always true.
    """

    message: str
    channels: tuple[Channel, ...]
    called: str
    condition: Value | None
    span: Span


@dataclass(frozen=True, slots=True)
class Guarantee:
    """What an activity guarantees: that it never publishes `said`.

    With `earlier`, that it does not within so many ns after that; both conditions know both messages.
    """

    said: Sent
    within: int | None
    earlier: Sent | None
    span: Span


@dataclass(frozen=True, slots=True)
class Activity:
    """An activity of the system. All times are in ns.

    - `every`: the period. `takes`: the expected duration.
    - `kind`: the execution mode: thread, async, process or step.
    - `within`: the deadline, counted from the entry of its state.
    - `ends`: the names of its outcomes. `parameters`: the values that each start gets.
    - `reads_variables`, `writes_variables`: variables of the roles that perform it.
    - `simulated`: it has no code, and completes after `takes`.
    - `waits`: it has no code, and never completes by itself.
    """

    name: str
    uses: tuple[str, ...]
    every: int | None
    takes: int | None
    kind: str
    reads: tuple[Subscription, ...]
    writes: tuple[Channel, ...]
    writes_variables: tuple[str, ...]
    span: Span
    within: int | None = None
    ends: tuple[str, ...] = ()
    parameters: tuple[Parameter, ...] = ()
    reads_variables: tuple[str, ...] = ()
    simulated: bool = False
    waits: bool = False
    guarantees: tuple[Guarantee, ...] = ()

    @property
    def has_code(self) -> bool:
        """Whether there is, or is to be, code for it."""
        return not self.simulated and not self.waits


@dataclass(frozen=True, slots=True)
class Module:
    """What runs at its own frequency beside the statechart (P2, section 2: a Monas module).

    `statement` says of it what is said of activities; its `every` is never None. `target` is `module:Class`,
    or "" where the code is found by the name, as that of activities.
    """

    statement: Activity
    target: str

    @property
    def name(self) -> str:
        return self.statement.name


@dataclass(frozen=True, slots=True)
class Functionality:
    name: str
    technology: str
    permissions: str
    environment: str
    algorithm: str
    span: Span


@dataclass(frozen=True, slots=True)
class Capability:
    """A use case with includes that the role is able to: the activities it needs."""

    name: str
    activities: tuple[str, ...]
    description: str
    span: Span


@dataclass(frozen=True, slots=True)
class Srm(Displayed):
    """A role. `formulas[0]` is the root; `activities` are the names of those the formulas use, in order."""

    name: str
    plays: tuple[Plays, ...]
    variables: tuple[DeclaredVariable, ...]
    formulas: tuple[NamedFormula, ...]
    activities: tuple[str, ...]
    functionalities: tuple[Functionality, ...]
    capabilities: tuple[Capability, ...]
    span: Span
    modules: tuple[Module, ...] = ()
    includes: tuple[str, ...] = ()
    """The roles that it takes over: what they say is in its formulas, variables and so on already."""
