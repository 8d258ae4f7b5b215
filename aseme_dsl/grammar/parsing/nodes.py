"""What the parser makes of the rules of the .tx files (`python -m aseme_dsl.grammar.syntax`).

The classes give the types; whether an object is of one of them, `pieces.is_a` says by its rule's name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

from aseme_dsl.grammar.text.token import Token as Leaf


class Node:
    """What was read by a rule, and where."""

    _tx_position: int
    _tx_position_end: int


class File(Node):
    language: Leaf | None
    declarations: list[Declaration]


class System(Node):
    name: Leaf


class Import(Node):
    library: Leaf | None
    path: Leaf | None
    alias: Leaf | None


class Enum(Node):
    name: Leaf
    constants: list[EnumEntry]


class EnumConstant(Node):
    name: Leaf
    number: Leaf | None


class Message(Node):
    name: Leaf
    fields: list[FieldEntry]


class Field(Node):
    label: Leaf | None
    type: Leaf
    name: Leaf
    number: Leaf | None


class Topic(Node):
    name: Leaf
    under: list[Leaf]
    radio: list[Leaf]
    delay: list[Leaf]
    entries: list[TopicEntry]


class TopicMessages(Node):
    comm: Leaf
    messages: list[Leaf]
    clauses: list[TopicClause]


class TopicFrom(Node):
    sources: list[Leaf]


class TopicEvery(Node):
    every: Leaf


class TopicExpires(Node):
    duration: Leaf


class TopicFlag(Node):
    flag: Leaf


class Function(Node):
    name: Leaf
    parameters: list[Parameter]
    result: Leaf
    target: Leaf


class Parameter(Node):
    type: Leaf
    name: Leaf


class Sag(Node):
    actors: list[SagEntry]


class Actor(Node):
    name: Leaf
    goals: list[ActorEntry]


class Goal(Node):
    name: Leaf
    clauses: list[GoalClause]


class Depends(Node):
    actors: list[Leaf]


class Requirements(Node):
    text: Leaf


class Suc(Node):
    entries: list[SucEntry]


class Roles(Node):
    names: list[Leaf]
    type: Leaf | None


class UseCase(Node):
    name: Leaf
    clauses: list[UseCaseClause]


class By(Node):
    roles: list[Leaf]


class Includes(Node):
    usecases: list[Leaf]


class Realises(Node):
    names: list[Leaf]


class Aip(Node):
    name: Leaf
    entries: list[AipEntry]


class Outcome(Node):
    text: Leaf
    when: Places | None


class Participant(Node):
    name: Leaf
    least: Leaf | None
    most: Leaf | None
    entries: list[ParticipantEntry]


class Engage(Node):
    text: Leaf


class Given(Node):
    name: Leaf
    type: Leaf


class Result(Node):
    name: Leaf
    type: Leaf
    least: Leaf | None
    most: Leaf | None
    tokens: list[Leaf]


class Sends(Node):
    messages: list[SentMessage]


class SentMessage(Node):
    performative: Leaf
    message: Leaf
    by: list[Leaf]
    repeatedly: bool


class Receives(Node):
    messages: list[AgentMessage]


class AgentMessage(Node):
    performative: Leaf
    message: Leaf


class Process(Node):
    name: Leaf
    parameters: list[FormulaParameter]
    tokens: list[Leaf]


class Plays(Node):
    parts: list[Part]


class Part(Node):
    protocol: Leaf
    participant: Leaf
    alias: Leaf | None
    bindings: list[Binding]
    busy: Busy | None


class Busy(Node):
    answer: list[Leaf]


class Binding(Node):
    abstract: Leaf
    tokens: list[Leaf]


class Clause(Node):
    rule: ClauseRule


class AtMost(Node):
    count: Leaf
    first: Places


class LeadsTo(Node):
    first: Places
    second: Places
    within: Leaf | None


class Before(Node):
    first: Places
    second: Places


class Places(Node):
    places: list[Place]


class Place(Node):
    name: Leaf
    at: Leaf | None


class Formula(Node):
    name: Leaf
    parameters: list[FormulaParameter]
    tokens: list[Leaf]


class FormulaParameter(Node):
    name: Leaf
    type: Leaf | None


class Control(Node):
    name: Leaf
    reactive: Leaf | None
    first: Leaf | None
    entries: list[ControlEntry]


class Way(Node):
    verb: Leaf
    term: list[Leaf]
    occurrence: Leaf | None
    every: Leaf | None
    tokens: list[Leaf]


class LabelledWay(Node):
    source: Leaf
    target: Leaf | None
    targets: list[Leaf]
    tokens: list[Leaf]


class Let(Node):
    name: Leaf
    tokens: list[Leaf]


class Var(Node):
    name: Leaf
    length: Leaf | None
    element: Leaf | None
    type: Leaf | None
    least: Leaf | None
    most: Leaf | None
    tokens: list[Leaf]


class Srm(Node):
    abstract: bool
    name: Leaf
    entries: list[SrmEntry]


class Inclusion(Node):
    roles: list[Leaf]


class Capability(Node):
    name: Leaf
    description: Leaf | None
    activities: list[Leaf]


class Liveness(Node):
    formulas: list[LivenessEntry]


class Activities(Node):
    activities: list[ActivitiesEntry]


class Activity(Node):
    name: Leaf
    parameters: list[ActivityParameter]
    clauses: list[ActivityClause]


class ActivityParameter(Node):
    name: Leaf
    type: Leaf


class Every(Node):
    duration: Leaf


class Takes(Node):
    duration: Leaf


class Simulated(Node):
    word: Leaf


class Waits(Node):
    word: Leaf


class Within(Node):
    duration: Leaf


class Ends(Node):
    outcomes: list[Leaf]


class As(Node):
    kind: Leaf


class Uses(Node):
    functionalities: list[Leaf]


class Reads(Node):
    reads: list[Read]


class Read(Node):
    reach: Leaf | None
    path: Leaf
    history: Leaf | None


class Writes(Node):
    paths: list[Leaf]


class Guarantees(Node):
    word: Leaf
    said: Sent
    limit: Leaf | None
    earlier: Sent | None


class Sent(Node):
    message: Leaf
    called: Leaf
    tokens: list[Leaf]


class Modules(Node):
    modules: list[ModulesEntry]


class Module(Node):
    name: Leaf
    clauses: list[ActivityClause]
    code: ModuleCode | None


class ModuleCode(Node):
    target: Leaf


class Functionality(Node):
    name: Leaf
    entries: list[FunctionalityEntry]


class FunctionalityText(Node):
    kind: Leaf
    text: Leaf


class Statechart(Node):
    name: Leaf
    entries: list[ChartEntry]


class ChartNode(Node):
    label: Leaf
    type: Leaf
    name: Leaf | None
    activity: Leaf | None


class StandingWay(Node):
    verb: Leaf
    state: Leaf
    tokens: list[Leaf]


class Team(Node):
    name: Leaf
    entries: list[TeamEntry]


class Agents(Node):
    names: list[AgentName]
    role: Leaf
    settings: list[Setting]


class Setting(Node):
    name: Leaf
    tokens: list[Leaf]


class AgentName(Node):
    name: Leaf
    least: Leaf | None
    most: Leaf | None


class Scenario(Node):
    title: Leaf
    tokens: list[Token]


class Property(Node):
    title: Leaf
    tokens: list[Token]


class Braced(Node):
    open: Leaf
    tokens: list[Token2]
    close: Leaf


class Braced2(Node):
    open: Leaf
    tokens: list[Token3]
    close: Leaf


class Braced3(Node):
    open: Leaf
    tokens: list[Leaf]
    close: Leaf


if TYPE_CHECKING:
    Declaration: TypeAlias = (
        System
        | Import
        | Let
        | Enum
        | Message
        | Topic
        | Function
        | Sag
        | Suc
        | Aip
        | Srm
        | Statechart
        | Team
        | Scenario
        | Property
        | Leaf
    )
    EnumEntry: TypeAlias = EnumConstant | Leaf
    FieldEntry: TypeAlias = Field | Leaf
    TopicEntry: TypeAlias = TopicMessages | Leaf
    TopicClause: TypeAlias = TopicFrom | TopicEvery | TopicExpires | TopicFlag
    SagEntry: TypeAlias = Actor | Leaf
    ActorEntry: TypeAlias = Goal | Leaf
    GoalClause: TypeAlias = Depends | Requirements
    SucEntry: TypeAlias = Roles | UseCase | Leaf
    UseCaseClause: TypeAlias = By | Includes | Realises | Requirements
    AipEntry: TypeAlias = Participant | Outcome | Clause | Let | Control | Leaf
    ParticipantEntry: TypeAlias = (
        Engage | Plays | Var | Given | Result | Let | Sends | Receives | Process | Leaf
    )
    ClauseRule: TypeAlias = AtMost | LeadsTo | Before
    ControlEntry: TypeAlias = Way | LabelledWay | Leaf
    SrmEntry: TypeAlias = (
        Inclusion
        | Plays
        | Capability
        | Var
        | Let
        | Liveness
        | Activities
        | Modules
        | Functionality
        | Control
        | Leaf
    )
    LivenessEntry: TypeAlias = Formula | Leaf
    ActivitiesEntry: TypeAlias = Activity | Leaf
    ActivityClause: TypeAlias = (
        Every | Takes | Simulated | Waits | Within | As | Uses | Reads | Writes | Ends | Guarantees
    )
    ModulesEntry: TypeAlias = Module | Leaf
    FunctionalityEntry: TypeAlias = FunctionalityText | Leaf
    ChartEntry: TypeAlias = ChartNode | LabelledWay | StandingWay | Var | Let | Activities | Modules | Leaf
    TeamEntry: TypeAlias = Agents | Leaf
    Token: TypeAlias = Leaf | Braced
    Token2: TypeAlias = Leaf | Braced2
    Token3: TypeAlias = Leaf | Braced3
