"""AIP, Agent Interaction Protocol (P1, section 4.2 and Table 1): participants, rules, processes, clauses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.expression import Fill, Literal, Value, value_text
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.messages import Bounds, Parameter, Type
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class AgentMessage:
    """`propose Bid`: a FIPA performative and the content's type.

    `by` are the activities of the participant that send it, if they are named; they do so once an entry and
    addressee, unless `repeatedly`.
    """

    performative: str
    message: str
    span: Span
    by: tuple[str, ...] = ()
    repeatedly: bool = False


@dataclass(frozen=True, slots=True)
class DeclaredVariable:
    name: str
    type: Type
    initial: Literal
    span: Span
    bounds: Bounds | None = None
    length: int | None = None
    """How many elements a list has at most."""

    @property
    def text(self) -> str:
        """`bids : int 0..10 = 0`; `best : agent`, which has no initial value, as a message."""
        said = "" if self.type.begins_unset else f" = {value_text(self.initial)}"
        bounds = "" if self.bounds is None else f" {self.bounds}"
        kind = str(self.type) if self.length is None else f"list[{self.length}] of {self.type.element}"
        return f"{self.name} : {kind}{bounds}{said}"


@dataclass(frozen=True, slots=True)
class NamedFormula:
    name: str
    formula: Formula
    span: Span
    parameters: tuple[Parameter, ...] = ()


@dataclass(frozen=True, slots=True)
class Busy:
    """What who plays a participant answers to an invitation while all instances of it are in use.

    Without a performative the invitation waits. Without `fills` the answer says what the invitation says;
    with them, the other members have their defaults.
    """

    performative: str
    message: str
    fills: tuple[Fill, ...] | None
    span: Span

    @property
    def text(self) -> str:
        """`refuse Job { reason = "later" }`."""
        if not self.performative:
            return "queue"
        said = ", ".join(f"{'.'.join(item.path)} = {value_text(item.value)}" for item in self.fills or ())
        braces = "" if self.fills is None else f" {{ {said} }}" if said else " { .. }"
        return " ".join(part for part in (self.performative, self.message) if part) + braces


@dataclass(frozen=True, slots=True)
class Plays:
    """`plays attack.center as striker with WalkTowardsGoal = WalkTowardsOpponentGoal`.

    `name` is how the formulas of the player (a role, or a participant of another protocol) call the
    participant; `bindings` replace the protocol's abstract activities by the player's own. `inputs` are the
    values of what the participant is given, `results` the player's variables that get its results.
    """

    protocol: str
    participant: str
    name: str
    bindings: tuple[tuple[str, str], ...]
    span: Span
    inputs: tuple[tuple[str, Value], ...] = ()
    results: tuple[tuple[str, str], ...] = ()
    busy: Busy | None = None

    @property
    def text(self) -> str:
        """`attack: center_for as striker with WalkTowardsGoal = WalkTowardsOpponentGoal`."""
        alias = f" as {self.name}" if self.name != self.participant else ""
        pairs = (*self.bindings, *((name, value_text(value)) for name, value in self.inputs), *self.results)
        bound = ", ".join(f"{name} = {text}" for name, text in pairs)
        busy = f" when busy {self.busy.text}" if self.busy is not None else ""
        return f"{self.protocol}: {self.participant}{alias}{f' with {bound}' if bound else ''}{busy}"


@dataclass(frozen=True, slots=True)
class Participant:
    """`[1..*]` is least 1, most None. `formulas[0]` is the process, the rest its helpers.

    `inputs` (`given`) are supplied by the role that plays it; `results` are those of its variables which the
    role gets when the part is complete. `plays` are its parts in other protocols: their conversations are
    nested in its own.
    """

    name: str
    least: int
    most: int | None
    engage: tuple[str, ...]
    variables: tuple[DeclaredVariable, ...]
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]
    formulas: tuple[NamedFormula, ...]
    span: Span
    inputs: tuple[DeclaredVariable, ...] = ()
    results: tuple[str, ...] = ()
    plays: tuple[Plays, ...] = ()

    @property
    def process(self) -> Formula:
        return self.formulas[0].formula


@dataclass(frozen=True, slots=True)
class Outcome:
    """How the protocol may end; `when` lists the `X@participant` whose entry says so, if that is said."""

    text: str
    when: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Clause:
    """What holds between participants.

    `kind` is "at most", "before" or "leads to"; each side lists `X@participant`.
    """

    kind: str
    first: tuple[str, ...]
    second: tuple[str, ...]
    count: int
    within: int | None  # ns
    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Aip(Displayed):
    name: str
    participants: tuple[Participant, ...]
    outcomes: tuple[Outcome, ...]
    clauses: tuple[Clause, ...]
    span: Span

    def participant(self, name: str) -> Participant | None:
        return next((item for item in self.participants if item.name == name), None)


def plays_inside(plays: Iterable[Plays], aips: Iterable[Aip]) -> Iterator[Plays]:
    """What is played, each before what is played inside of it."""
    by_name = {aip.name: aip for aip in aips}
    waiting = list(plays)[::-1]
    while waiting:
        item = waiting.pop()
        yield item
        parts = by_name[item.protocol].participants if item.protocol in by_name else ()
        waiting += [other for part in parts if part.name == item.participant for other in part.plays[::-1]]


def answers_when_busy(plays: Iterable[Plays]) -> Mapping[tuple[str, str], frozenset[tuple[str, str]]]:
    """Of each participant, as (protocol, participant): the messages that its players answer while busy."""
    found: dict[tuple[str, str], frozenset[tuple[str, str]]] = {}
    for item in plays:
        if item.busy is not None:
            whole = (item.protocol, item.participant)
            found[whole] = found.get(whole, frozenset()) | {(item.busy.performative, item.busy.message)}
    return found
