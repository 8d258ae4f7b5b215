"""The tree of a `.aseme` file: what was written, unresolved, every name with its span.

The compiler checks types, names and topics, and makes AMOLA models of the tree. A part of a file that could
not be read is missing here and has a diagnostic.
"""

from __future__ import annotations

from aseme_dsl.amola.liveness import Formula
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Name:
    """An identifier where it stands."""

    text: str
    span: Span

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Text:
    """A string in double quotes; `text` has its escapes resolved."""

    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Comment:
    """A `//` or `/* */` comment with its marks."""

    text: str
    span: Span


# ---- expressions -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Number:
    """An unsigned number as written; `value` is an int unless it has a decimal point."""

    value: int | float
    span: Span


@dataclass(frozen=True, slots=True)
class Duration:
    """`200ms`, `1.5s`, `2min`, in ns."""

    nanoseconds: int
    span: Span


@dataclass(frozen=True, slots=True)
class Truth:
    value: bool
    span: Span


@dataclass(frozen=True, slots=True)
class Path:
    """A dotted name: a variable, an enum constant, a message or a member of one."""

    segments: tuple[Name, ...]
    span: Span

    @property
    def text(self) -> str:
        return ".".join(segment.text for segment in self.segments)


@dataclass(frozen=True, slots=True)
class Call:
    function: Path
    arguments: tuple[Expression, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Unary:
    """`!` or `-` or `+`."""

    operator: str
    operand: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Binary:
    """Comparison or arithmetic."""

    operator: str
    left: Expression
    right: Expression
    operator_span: Span
    span: Span


@dataclass(frozen=True, slots=True)
class Logic:
    """`&&` or `||` over two or more operands; one chain of one operator is one node."""

    operator: str
    operands: tuple[Expression, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Conditional:
    """`condition ? yes : no`"""

    condition: Expression
    yes: Expression
    no: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Parenthesised:
    inner: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class List:
    """`[a, b]`"""

    elements: tuple[Expression, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Element:
    """`list[index]`, and (`members`) what follows it: `.name.length`."""

    list: Expression
    index: Expression
    members: tuple[Name, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class NewMessage:
    """`Order { id = 7, ..now }`; `braces` are the places of both."""

    message: Name
    fills: tuple[Fill, ...]
    rest: Rest | None
    braces: tuple[Span, Span]
    span: Span


@dataclass(frozen=True, slots=True)
class Hole:
    """The `?` of `[?]`: a condition that is still to be written. It occurs only there."""

    span: Span


Expression = (
    Number
    | Duration
    | Truth
    | Text
    | Path
    | Call
    | Unary
    | Binary
    | Logic
    | Parenthesised
    | Conditional
    | List
    | Element
    | NewMessage
    | Hole
)

# ---- transition expressions --------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class After:
    duration: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Received:
    """`propose Bid b from contractor`; `name` is what the message is called, if anything."""

    performative: Name
    message: Name
    participant: Name
    span: Span
    name: Name | None = None


@dataclass(frozen=True, slots=True)
class Lost:
    """`lost contractor c`"""

    participant: Name
    name: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class Raised:
    """A bare name; `error` is one too."""

    name: Name
    span: Span


Event = After | Received | Lost | Raised


@dataclass(frozen=True, slots=True)
class Assign:
    """`target = value`, or `target += value` with the operator before its `=`; `target[index] = value`."""

    target: Path
    value: Expression
    span: Span
    operator: Name | None = None
    index: Expression | None = None
    members: tuple[Name, ...] = ()
    """What is written behind the index."""


@dataclass(frozen=True, slots=True)
class Fill:
    """`g.h = v` in the braces behind a message."""

    target: Path
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Rest:
    """`..` or `..m` at the end of the braces: the other members have their defaults, or are those of `m`."""

    message: Expression | None
    span: Span


@dataclass(frozen=True, slots=True)
class Publish:
    """`write_messages.topic.kind.Message { f = v, ..m }`; `path` is what follows `write_messages.`.

    `fills` is None without braces.
    """

    path: Path
    span: Span
    fills: tuple[Fill, ...] | None = None
    rest: Rest | None = None


@dataclass(frozen=True, slots=True)
class ReadMessages:
    span: Span


@dataclass(frozen=True, slots=True)
class Send:
    """`send accept_proposal Award { task = job } to best`, `… to contractor except best`.

    `fills` is None without braces; `braces` are the places of both. `participant` is the name behind `to`,
    which may be a variable's; None where an expression stands there (`receiver`). `one` stands before the
    participant if only one agent gets it.
    """

    performative: Name
    message: Name
    participant: Name | None
    span: Span
    fills: tuple[Fill, ...] | None = None
    receiver: Expression | None = None
    excepts: tuple[Expression, ...] = ()
    rest: Rest | None = None
    braces: tuple[Span, Span] | None = None
    reply_by: Expression | None = None
    one: Span | None = None


@dataclass(frozen=True, slots=True)
class Evaluate:
    """An expression as an action (also `start_timer(name, 200ms)`, which is a Call here)."""

    expression: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Raise:
    """`raise name`"""

    name: Name
    span: Span


Action = Assign | Publish | ReadMessages | Send | Raise | Evaluate


@dataclass(frozen=True, slots=True)
class Weight:
    """`weight 3`"""

    value: int
    span: Span


@dataclass(frozen=True, slots=True)
class TransitionExpression:
    """`event [condition] / action; action`. `otherwise` is `else`, `when` the word before a condition.

    `every` is the pace of `repeat T every 200ms : …`. With `ignores`, the place of this word, the condition
    asks whether the signals behind it are there.
    """

    events: tuple[Event, ...]
    when: bool
    otherwise: bool
    condition: Expression | None
    actions: tuple[Action, ...]
    span: Span
    every: Duration | None = None
    weight: Weight | None = None
    ignores: Span | None = None


# ---- control -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Term:
    """A term as written in a formula; `occurrence` is the n of `T#n`, from 1, or None."""

    formula: Formula
    occurrence: int | None
    span: Span


@dataclass(frozen=True, slots=True)
class Way:
    """`enter T : …` and its like; `verb` is enter, skip, repeat, leave, start, finish, on, exit or resume."""

    verb: Name
    term: Term
    expression: TransitionExpression
    span: Span


@dataclass(frozen=True, slots=True)
class LabelledWay:
    """`0.2.3 -> 0.2.4 : …`, or `0.1 -> (0.2.1.2, 0.2.2.3) : …` with a target in each of several regions."""

    source: Name
    targets: tuple[Name, ...]
    expression: TransitionExpression
    span: Span

    @property
    def ends(self) -> Span:
        """The place of the labels, from the source to the last target."""
        return self.source.span.to(self.targets[-1].span)


@dataclass(frozen=True, slots=True)
class StandingWay:
    """`on 0.2 : … / …` and `exit 0.2 : / …` of a `statechart`."""

    verb: Name
    state: Name
    expression: TransitionExpression
    span: Span


@dataclass(frozen=True, slots=True)
class Control:
    """`control NAME { … }`: of a formula, or (in an aip) of a participant or one of its helper formulas.

    `reactive` is the word behind the name, where it stands. With `first` the order of its lines decides.
    """

    name: Name
    entries: tuple[Way | LabelledWay, ...]
    span: Span
    reactive: Span | None = None
    first: bool = False


# ---- declarations ------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class System:
    name: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Import:
    """`import soccer` (a Name: the standard library) or `import "path" as alias` (a Text)."""

    target: Name | Text
    span: Span
    alias: Name | None = None


@dataclass(frozen=True, slots=True)
class EnumConstant:
    name: Name
    number: int | None
    span: Span


@dataclass(frozen=True, slots=True)
class Enum:
    name: Name
    constants: tuple[EnumConstant, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Field:
    """`repeated double values = 3`: label "", "optional" or "repeated"; a number only if written."""

    label: str
    type: Name
    name: Name
    number: int | None
    span: Span


@dataclass(frozen=True, slots=True)
class Message:
    name: Name
    fields: tuple[Field, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class TopicEntry:
    """`state Ball, Pose from vision every 33ms queued persist`, or `signal Select expires 2s`."""

    comm: Name
    messages: tuple[Name, ...]
    sources: tuple[Name, ...]
    every: Duration | None
    queued: bool
    persist: bool
    expires: Duration | None
    span: Span


@dataclass(frozen=True, slots=True)
class Topic:
    """`topic team under world radio 10 delay 200ms { … }`"""

    name: Name
    under: Name | None
    radio: Number | None
    delay: Duration | None
    entries: tuple[TopicEntry, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Parameter:
    type: Name
    name: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Function:
    name: Name
    parameters: tuple[Parameter, ...]
    result: Name
    target: Text
    span: Span


@dataclass(frozen=True, slots=True)
class Let:
    name: Name
    expression: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Goal:
    name: Name
    depends: tuple[Name, ...]
    requirements: Text | None
    span: Span


@dataclass(frozen=True, slots=True)
class Actor:
    name: Name
    goals: tuple[Goal, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Sag:
    actors: tuple[Actor, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Roles:
    """`role center, center_for : abstract`; `type` None means system."""

    names: tuple[Name, ...]
    type: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class UseCase:
    name: Name
    by: tuple[Name, ...]
    includes: tuple[Name, ...]
    realises: tuple[Name, ...]
    requirements: Text | None
    span: Span


@dataclass(frozen=True, slots=True)
class Suc:
    roles: tuple[Roles, ...]
    usecases: tuple[UseCase, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Var:
    """`var bids : int 0..10 = 0`"""

    name: Name
    type: Name
    initial: Expression | None
    span: Span
    bounds: VarBounds | None = None
    is_list: bool = False
    length: Number | None = None
    """How many elements a list has at most."""


@dataclass(frozen=True, slots=True)
class VarBounds:
    """`0..10`"""

    least: int | float
    most: int | float
    span: Span


@dataclass(frozen=True, slots=True)
class FormulaParameter:
    """`to` or `to : Place`: what a formula is given wherever it is used."""

    name: Name
    type: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class NamedFormula:
    """`decision = A . B`; the process of a participant is called `process`."""

    name: Name
    formula: Formula
    span: Span
    parameters: tuple[FormulaParameter, ...] = ()


@dataclass(frozen=True, slots=True)
class AgentMessage:
    """`span` is that of performative and message; `by` are the activities that send it."""

    performative: Name
    message: Name
    span: Span
    by: tuple[Name, ...] = ()
    repeatedly: bool = False


@dataclass(frozen=True, slots=True)
class Multiplicity:
    """`[1..*]` has most None; `[3]` least and most 3."""

    least: int
    most: int | None
    span: Span


@dataclass(frozen=True, slots=True)
class Given:
    """`given low : bool`: an input of a participant."""

    name: Name
    type: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Participant:
    """`formulas` holds `process` and the helper formulas in the order in which they are written."""

    name: Name
    multiplicity: Multiplicity | None
    engage: tuple[Text, ...]
    variables: tuple[Var, ...]
    lets: tuple[Let, ...]
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]
    formulas: tuple[NamedFormula, ...]
    span: Span
    inputs: tuple[Given, ...] = ()
    results: tuple[Var, ...] = ()
    plays: tuple[Plays, ...] = ()


@dataclass(frozen=True, slots=True)
class Place:
    """`PassBall@center`, or the participant alone (`at` None)."""

    name: Name
    at: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class Clause:
    """`clause at most one X`, `clause X before Y`, `clause every X leads to (Y or Z) within 10s`."""

    kind: str  # "at most", "before", "leads to"
    first: tuple[Place, ...]
    second: tuple[Place, ...]
    count: int
    within: Duration | None
    span: Span


@dataclass(frozen=True, slots=True)
class Outcome:
    """`outcome "The center_for shoots to goal." when KickBall@center_for`."""

    text: Text
    when: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Aip:
    name: Name
    participants: tuple[Participant, ...]
    outcomes: tuple[Outcome, ...]
    lets: tuple[Let, ...]
    clauses: tuple[Clause, ...]
    controls: tuple[Control, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Binding:
    """`WalkTowardsGoal = WalkTowardsOpponentGoal`; what is more than a name is in `value`."""

    abstract: Name
    own: Name | None
    value: Expression | None
    span: Span

    @property
    def expression(self) -> Expression:
        """What stands behind the `=`."""
        if self.value is not None:
            return self.value
        assert self.own is not None
        return Path((self.own,), self.own.span)


@dataclass(frozen=True, slots=True)
class Busy:
    """`when busy queue`, `when busy refuse`, `when busy refuse Job { reason = "later" }`.

    `word` is the first one, `answer` the message where one is named.
    """

    word: str
    answer: Send | None
    span: Span


@dataclass(frozen=True, slots=True)
class Plays:
    protocol: Name
    participant: Name
    alias: Name | None
    bindings: tuple[Binding, ...]
    span: Span
    busy: Busy | None = None


@dataclass(frozen=True, slots=True)
class ActivityRead:
    """`reads vision.state.Ball for 2s` (reach "on") or `reads below vision` (a whole topic)."""

    reach: str
    path: Path
    history: Duration | None
    span: Span


@dataclass(frozen=True, slots=True)
class ActivityParameter:
    """`goal : Place`."""

    name: Name
    type: Name
    span: Span


@dataclass(frozen=True, slots=True)
class Sent:
    """`sent Assignment b [b.center != a.center]`: a message, of this type or on this channel."""

    message: Path
    called: Name
    condition: Expression | None
    span: Span


@dataclass(frozen=True, slots=True)
class Guarantee:
    """`guarantees never sent …`, or `guarantees no sent … within 1400ms after sent …` (`earlier`)."""

    said: Sent
    within: Duration | None
    earlier: Sent | None
    span: Span


@dataclass(frozen=True, slots=True)
class Activity:
    """`Vision every 33ms takes 5ms as process uses camera reads … writes …`; clauses in any order.

    `within` is its deadline, `ends` are the names of its outcomes, `simulated` and `waits` are the places of
    those words.
    """

    name: Name
    uses: tuple[Name, ...]
    every: Duration | None
    takes: Duration | None
    kind: Name | None
    reads: tuple[ActivityRead, ...]
    writes: tuple[Path, ...]
    span: Span
    within: Duration | None = None
    ends: tuple[Name, ...] = ()
    parameters: tuple[ActivityParameter, ...] = ()
    simulated: Span | None = None
    waits: Span | None = None
    guarantees: tuple[Guarantee, ...] = ()


@dataclass(frozen=True, slots=True)
class Module:
    """An entry of `modules`: what is said of it as of an activity, and where its code is, if not by name."""

    activity: Activity
    target: Text | None
    span: Span

    @property
    def name(self) -> Name:
        return self.activity.name


@dataclass(frozen=True, slots=True)
class Functionality:
    """`functionality camera { technology "…" permissions "…" environment "…" algorithm "…" }`"""

    name: Name
    technology: Text | None
    permissions: Text | None
    environment: Text | None
    algorithm: Text | None
    span: Span


@dataclass(frozen=True, slots=True)
class Capability:
    """`capability score "…" = KickBall, Attack`"""

    name: Name
    description: Text | None
    activities: tuple[Name, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Srm:
    """`includes` are the roles that it takes over; an `abstract` one is only there to be included."""

    name: Name
    plays: tuple[Plays, ...]
    capabilities: tuple[Capability, ...]
    variables: tuple[Var, ...]
    lets: tuple[Let, ...]
    formulas: tuple[NamedFormula, ...]
    activities: tuple[Activity, ...]
    modules: tuple[Module, ...]
    functionalities: tuple[Functionality, ...]
    controls: tuple[Control, ...]
    span: Span
    includes: tuple[Name, ...] = ()
    abstract: bool = False


@dataclass(frozen=True, slots=True)
class ChartNode:
    """`state 0.2 OR "Play"` in a statechart; `activity` where it is not the name."""

    label: Name
    type: Name
    name: Name | Text | None
    activity: Name | None
    span: Span


@dataclass(frozen=True, slots=True)
class Statechart:
    """`statechart NAME { state 0 OR  state 0.1 START … 0.1 -> 0.2 : … }`"""

    name: Name
    variables: tuple[Var, ...]
    lets: tuple[Let, ...]
    nodes: tuple[ChartNode, ...]
    transitions: tuple[LabelledWay | StandingWay, ...]
    activities: tuple[Activity, ...]
    modules: tuple[Module, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Setting:
    """`limit = 80`: what a variable of the role holds at first in these agents."""

    name: Name
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class TeamAgents:
    """`robot1, robot2 : player` or `carrier[1..8] : robot with limit = 80`; a range is (least, most)."""

    names: tuple[tuple[Name, tuple[int, int] | None], ...]
    role: Name
    span: Span
    settings: tuple[Setting, ...] = ()


@dataclass(frozen=True, slots=True)
class Team:
    name: Name
    agents: tuple[TeamAgents, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Scenario:
    """A scenario with its statements as token texts: executed by the room `scenarios/`."""

    title: Text
    statements: tuple[tuple[Name, ...], ...]
    span: Span

    @property
    def words(self) -> tuple[Name, ...]:
        """All its words, in their order."""
        return tuple(word for line in self.statements for word in line)


@dataclass(frozen=True, slots=True)
class Property:
    title: Text
    tokens: tuple[Name, ...]
    span: Span

    @property
    def words(self) -> tuple[Name, ...]:
        """All its words, in their order."""
        return self.tokens


Declaration = (
    System
    | Import
    | Enum
    | Message
    | Topic
    | Function
    | Let
    | Sag
    | Suc
    | Aip
    | Srm
    | Statechart
    | Team
    | Scenario
    | Property
)


@dataclass(frozen=True, slots=True)
class File:
    """A parsed file. `language` is the number after `language`, None where the file does not say."""

    source: Source
    language: Number | None
    declarations: tuple[Declaration, ...]
    comments: tuple[Comment, ...]

    @property
    def must_hold(self) -> tuple[Scenario | Property, ...]:
        """Its scenarios and properties."""
        return tuple(item for item in self.declarations if isinstance(item, Scenario | Property))
