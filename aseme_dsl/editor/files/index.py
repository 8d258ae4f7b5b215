"""Index: what each name in the files of a program means, and where everything that has a name stands.

What a name in a node of the tree means is said in one line of `NAMES`; dotted names are taken apart here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, fields, is_dataclass, replace
from enum import StrEnum

from aseme_dsl.amola.liveness import Argument, Formula, names
from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.names.usecases import folded
from aseme_dsl.compiler.read.builtins import COMM_TYPES, PERFORMATIVES, ROUND_QUESTIONS
from aseme_dsl.compiler.types.given import supplied_names
from aseme_dsl.grammar.formulas.statement import read_statements
from aseme_dsl.grammar.text import statements as nodes
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


class Kind(StrEnum):
    """What can have a name."""

    SYSTEM = "system"
    LIBRARY = "library"
    ENUM = "enum"
    CONSTANT = "constant"
    MESSAGE = "message"
    FIELD = "field"
    TOPIC = "topic"
    COMM = "channel kind"
    TYPE = "type"
    FUNCTION = "function"
    PARAMETER = "parameter"
    LET = "let"
    VARIABLE = "variable"
    TIMER = "timer"
    EVENT = "event"
    PERFORMATIVE = "performative"
    USE_CASE = "use case"
    ROLE = "role"
    PROTOCOL = "protocol"
    PARTICIPANT = "participant"
    ALIAS = "played participant"
    FORMULA = "formula"
    ACTIVITY = "activity"
    OUTCOME = "outcome"
    FUNCTIONALITY = "functionality"
    CAPABILITY = "capability"
    STATE = "state"
    TEAM = "team"
    AGENT = "agent"


@dataclass(frozen=True, slots=True)
class Symbol:
    """Something with a name. `owner` is where it belongs: a field's message, a formula's role, and so on.

    Of participants, `owner` is the protocol; of what belongs to a participant, `protocol.participant`.
    """

    kind: Kind
    name: str
    owner: str = ""


class Use(StrEnum):
    """What a name is doing where it stands. Activities and timers may be declared by use alone."""

    DECLARATION = "declaration"
    READ = "read"
    WRITE = "write"


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A name where it stands, what it means there, and the node of the tree that it is in."""

    span: Span
    symbol: Symbol
    use: Use
    node: object = field(compare=False)


@dataclass(frozen=True)
class World:
    """What the names at the top of all files mean."""

    symbols: Symbols
    roles: frozenset[str] = frozenset()
    realised: Mapping[str, Symbol] = field(default_factory=dict)
    """What use cases are in other models: protocols, formulas, capabilities, by their folded names."""
    included: Mapping[str, tuple[tree.Srm, ...]] = field(default_factory=dict)
    """What each role takes over, directly or not."""
    supplied: frozenset[tuple[str, str]] = frozenset()
    """The inputs and results of participants: `protocol.participant`, and the name."""
    participants: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """The protocols that have a participant of a name."""


def world_of(symbols: Symbols, files: Iterable[tree.File]) -> World:
    """The world of all declarations."""
    declarations = [item for file in files for item in file.declarations]
    protocols = [item for item in declarations if isinstance(item, tree.Aip)]
    roles = [item for item in declarations if isinstance(item, (tree.Srm, tree.Statechart))]
    realised: dict[str, Symbol] = {}
    for protocol in protocols:
        realised.setdefault(folded(protocol.name.text), Symbol(Kind.PROTOCOL, protocol.name.text))
    for owner, item in formula_owners(roles, protocols):
        realised.setdefault(folded(item.name.text), Symbol(Kind.FORMULA, item.name.text, owner))
    for role in roles:
        for capability in role.capabilities if isinstance(role, tree.Srm) else ():
            name = capability.name.text
            realised.setdefault(folded(name), Symbol(Kind.CAPABILITY, name, role.name.text))
    included = _included([role for role in roles if isinstance(role, tree.Srm)])
    supplied = frozenset(
        (f"{protocol.name}.{party.name}", item.text)
        for protocol in protocols
        for party in protocol.participants
        for item in supplied_names(party)
    )
    participants: dict[str, tuple[str, ...]] = {}
    for protocol in protocols:
        for party in protocol.participants:
            owners = participants.get(party.name.text, ())
            participants[party.name.text] = (*owners, protocol.name.text)
    names_of_roles = frozenset(role.name.text for role in roles)
    return World(symbols, names_of_roles, realised, included, supplied, participants)


def _included(roles: Iterable[tree.Srm]) -> dict[str, tuple[tree.Srm, ...]]:
    by_name = {role.name.text: role for role in reversed(list(roles))}
    found: dict[str, tuple[tree.Srm, ...]] = {}
    for name, role in by_name.items():
        parts: dict[str, tree.Srm] = {}
        waiting = [item.text for item in reversed(role.includes)]
        while waiting:
            other = waiting.pop()
            if other in by_name and other not in parts and other != name:
                parts[other] = by_name[other]
                waiting += [item.text for item in reversed(by_name[other].includes)]
        if parts:
            found[name] = tuple(parts.values())
    return found


def formula_owners(
    roles: Iterable[tree.Srm | tree.Statechart], protocols: Iterable[tree.Aip]
) -> Iterator[tuple[str, tree.NamedFormula]]:
    """Every formula with the role or participant that it belongs to."""
    for role in roles:
        if isinstance(role, tree.Srm):
            yield from ((role.name.text, item) for item in role.formulas)
    for protocol in protocols:
        for party in protocol.participants:
            yield from ((f"{protocol.name}.{party.name}", item) for item in party.formulas)


Block = tree.Enum | tree.Message | tree.Function | tree.Aip | tree.Srm | tree.Statechart
"""What has names of its own inside."""


@dataclass(frozen=True)
class Around:
    """What a name stands in: the names that are visible there, by kind, and the blocks around it.

    `owner` is the role or participant, `terms` what a name in a formula means if it is not an activity.
    """

    world: World
    block: Block | None = None
    owner: str = ""
    values: Mapping[str, Symbol] = field(default_factory=dict)
    terms: Mapping[str, Symbol] = field(default_factory=dict)
    parties: Mapping[str, Symbol] = field(default_factory=dict)
    lets: Mapping[Symbol, tree.Expression] = field(default_factory=dict)
    held: Mapping[Symbol, str] = field(default_factory=dict)
    """The types of variables, or of the elements of those that are lists."""
    formula: str = ""
    activity: str = ""
    role: str = ""
    played: str = ""
    """The participant that a role plays, and gives something here."""
    node: object = None
    taken: Mapping[str, str] = field(default_factory=dict)
    """The types of the agent messages that have names here."""
    filled: str = ""
    """The message whose members are filled in braces here."""

    def term(self, name: str) -> Symbol:
        return self.terms.get(name) or Symbol(Kind.ACTIVITY, name)


# ---- what the names in a node mean ---------------------------------------------------------------

_Meaning = Callable[[Around, tree.Name], Symbol | None]


def _is(kind: Kind, owner: Callable[[Around], str] = lambda around: "") -> _Meaning:
    return lambda around, name: Symbol(kind, name.text, owner(around))


def _block(around: Around) -> str:
    return str(around.block.name) if around.block is not None else ""


def _owner(around: Around) -> str:
    return around.owner


def _of_role(around: Around, name: tree.Name) -> Symbol | None:
    """A variable of the role that agents have; one that the role takes over is the other role's."""
    for part in reversed(around.world.included.get(around.role, ())):
        if any(item.name.text == name.text for item in part.variables):
            return Symbol(Kind.VARIABLE, name.text, part.name.text)
    return Symbol(Kind.VARIABLE, name.text, around.role)


def _formula(around: Around) -> str:
    return f"{around.owner}.{around.formula}"


def _activity(around: Around) -> str:
    return around.activity


def _type(around: Around, name: tree.Name) -> Symbol | None:
    if name.text in BUILT_IN:
        return Symbol(Kind.TYPE, name.text)
    if around.world.symbols.enum(name.text) is not None:
        return Symbol(Kind.ENUM, name.text)
    return Symbol(Kind.MESSAGE, name.text)


def _of_element(around: Around, name: tree.Name) -> Symbol | None:
    """A member behind the brackets of an element."""
    node = around.node
    assert isinstance(node, tree.Element)
    message = _held(around, node.list)
    for member in node.members:
        if message is None:
            return None
        if member is name:
            return Symbol(Kind.FIELD, name.text, message)
        message = _held_by(around, message, member.text)
    return None


def _party(around: Around, name: tree.Name) -> Symbol | None:
    return around.parties.get(name.text)


def _receiver(around: Around, name: tree.Name) -> Symbol | None:
    return around.parties.get(name.text) or around.values.get(name.text)


def _value_named(around: Around, name: tree.Name) -> Symbol | None:
    return around.values.get(name.text)


def _term(around: Around, name: tree.Name) -> Symbol | None:
    return around.term(name.text)


def _publisher(around: Around, name: tree.Name) -> Symbol | None:
    if name.text in around.world.symbols.agents:
        return Symbol(Kind.AGENT, name.text)
    return Symbol(Kind.ROLE if name.text in around.world.roles else Kind.ACTIVITY, name.text)


def _place(around: Around, name: tree.Name) -> Symbol | None:
    """`PassBall@center`, or the participant alone."""
    place = around.node
    assert isinstance(place, tree.Place) and isinstance(around.block, tree.Aip)
    if place.at is None:
        return around.parties.get(name.text) or Symbol(Kind.ACTIVITY, name.text)
    owner = f"{_block(around)}.{place.at}"
    party = next((p for p in around.block.participants if p.name.text == place.at.text), None)
    helpers = [item.name.text for item in party.formulas] if party is not None else []
    return (
        Symbol(Kind.FORMULA, name.text, owner) if name.text in helpers else Symbol(Kind.ACTIVITY, name.text)
    )


def _realised(around: Around, name: tree.Name) -> Symbol | None:
    return around.world.realised.get(folded(name.text)) or Symbol(Kind.ACTIVITY, name.text)


def _event(around: Around, name: tree.Name) -> Symbol | None:
    return Symbol(Kind.EVENT, name.text) if name.text != "error" else None


def _agent(around: Around, name: tree.Name) -> Symbol | None:
    return Symbol(Kind.AGENT, name.text)


def _participant_played(around: Around, name: tree.Name) -> Symbol | None:
    assert isinstance(around.node, tree.Plays)
    return Symbol(Kind.PARTICIPANT, name.text, around.node.protocol.text)


def _abstract(around: Around, name: tree.Name) -> Symbol | None:
    """An activity of a participant, or one of its inputs and results."""
    if (around.played, name.text) in around.world.supplied:
        return Symbol(Kind.VARIABLE, name.text, around.played)
    return Symbol(Kind.ACTIVITY, name.text)


def _bound(around: Around, name: tree.Name) -> Symbol | None:
    """What stands for it in the role, or in the participant around."""
    assert isinstance(around.node, tree.Binding)
    if (around.played, around.node.abstract.text) in around.world.supplied:
        return around.values.get(name.text)
    return around.term(name.text)


def _formula_named(around: Around, name: tree.Name) -> Symbol | None:
    return Symbol(Kind.FORMULA, name.text, around.owner)


def _controlled(around: Around, name: tree.Name) -> Symbol | None:
    """A formula of the role; in a protocol a participant, or one of its helper formulas."""
    if name.text in around.parties:
        return around.parties[name.text]
    return around.terms.get(name.text) or Symbol(Kind.FORMULA, name.text, around.owner)


NAMES: dict[tuple[type, str], tuple[Use, _Meaning]] = {
    (tree.System, "name"): (Use.DECLARATION, _is(Kind.SYSTEM)),
    (tree.Import, "target"): (Use.READ, _is(Kind.LIBRARY)),
    (tree.Enum, "name"): (Use.DECLARATION, _is(Kind.ENUM)),
    (tree.EnumConstant, "name"): (Use.DECLARATION, _is(Kind.CONSTANT, _block)),
    (tree.Message, "name"): (Use.DECLARATION, _is(Kind.MESSAGE)),
    (tree.Field, "type"): (Use.READ, _type),
    (tree.Field, "name"): (Use.DECLARATION, _is(Kind.FIELD, _block)),
    (tree.Topic, "name"): (Use.DECLARATION, _is(Kind.TOPIC)),
    (tree.Topic, "under"): (Use.READ, _is(Kind.TOPIC)),
    (tree.TopicEntry, "comm"): (Use.READ, _is(Kind.COMM)),
    (tree.TopicEntry, "messages"): (Use.READ, _is(Kind.MESSAGE)),
    (tree.TopicEntry, "sources"): (Use.READ, _publisher),
    (tree.Function, "name"): (Use.DECLARATION, _is(Kind.FUNCTION)),
    (tree.Function, "result"): (Use.READ, _type),
    (tree.Parameter, "type"): (Use.READ, _type),
    (tree.Parameter, "name"): (Use.DECLARATION, _is(Kind.PARAMETER, _block)),
    (tree.Let, "name"): (Use.DECLARATION, _is(Kind.LET, _owner)),
    (tree.Var, "name"): (Use.DECLARATION, _is(Kind.VARIABLE, _owner)),
    (tree.Var, "type"): (Use.READ, _type),
    (tree.Actor, "name"): (Use.DECLARATION, _is(Kind.ROLE)),
    (tree.Goal, "name"): (Use.DECLARATION, _is(Kind.USE_CASE)),
    (tree.Goal, "depends"): (Use.READ, _is(Kind.ROLE)),
    (tree.Roles, "names"): (Use.DECLARATION, _is(Kind.ROLE)),
    (tree.UseCase, "name"): (Use.DECLARATION, _is(Kind.USE_CASE)),
    (tree.UseCase, "by"): (Use.READ, _is(Kind.ROLE)),
    (tree.UseCase, "includes"): (Use.READ, _is(Kind.USE_CASE)),
    (tree.UseCase, "realises"): (Use.READ, _realised),
    (tree.Aip, "name"): (Use.DECLARATION, _is(Kind.PROTOCOL)),
    (tree.Participant, "name"): (Use.DECLARATION, _is(Kind.PARTICIPANT, _block)),
    (tree.AgentMessage, "performative"): (Use.READ, _is(Kind.PERFORMATIVE)),
    (tree.AgentMessage, "message"): (Use.READ, _is(Kind.MESSAGE)),
    (tree.NamedFormula, "name"): (Use.DECLARATION, _formula_named),
    (tree.FormulaParameter, "name"): (Use.DECLARATION, _is(Kind.PARAMETER, _formula)),
    (tree.FormulaParameter, "type"): (Use.READ, _type),
    (tree.Place, "name"): (Use.READ, _place),
    (tree.Place, "at"): (Use.READ, _party),
    (tree.Control, "name"): (Use.READ, _controlled),
    (tree.LabelledWay, "source"): (Use.READ, _is(Kind.STATE, _owner)),
    (tree.LabelledWay, "targets"): (Use.READ, _is(Kind.STATE, _owner)),
    (tree.StandingWay, "state"): (Use.READ, _is(Kind.STATE, _owner)),
    (tree.Received, "performative"): (Use.READ, _is(Kind.PERFORMATIVE)),
    (tree.Received, "message"): (Use.READ, _is(Kind.MESSAGE)),
    (tree.Received, "participant"): (Use.READ, _receiver),
    (tree.Received, "name"): (Use.DECLARATION, _value_named),
    (tree.Lost, "participant"): (Use.READ, _party),
    (tree.Lost, "name"): (Use.DECLARATION, _value_named),
    (tree.Raised, "name"): (Use.READ, _event),
    (tree.Raise, "name"): (Use.WRITE, _event),
    (tree.Send, "performative"): (Use.READ, _is(Kind.PERFORMATIVE)),
    (tree.Send, "message"): (Use.READ, _is(Kind.MESSAGE)),
    (tree.NewMessage, "message"): (Use.READ, _is(Kind.MESSAGE)),
    (tree.Send, "participant"): (Use.READ, _receiver),
    (tree.Srm, "name"): (Use.DECLARATION, _is(Kind.ROLE)),
    (tree.Srm, "includes"): (Use.READ, _is(Kind.ROLE)),
    (tree.Plays, "protocol"): (Use.READ, _is(Kind.PROTOCOL)),
    (tree.Plays, "participant"): (Use.READ, _participant_played),
    (tree.Plays, "alias"): (Use.DECLARATION, _is(Kind.ALIAS, _owner)),
    (tree.AgentMessage, "by"): (Use.READ, _is(Kind.ACTIVITY)),
    (tree.Binding, "abstract"): (Use.READ, _abstract),
    (tree.Binding, "own"): (Use.READ, _bound),
    (tree.Given, "name"): (Use.DECLARATION, _is(Kind.VARIABLE, _owner)),
    (tree.Given, "type"): (Use.READ, _type),
    (tree.Capability, "name"): (Use.DECLARATION, _is(Kind.CAPABILITY, _owner)),
    (tree.Capability, "activities"): (Use.READ, _term),
    (tree.Activity, "name"): (Use.DECLARATION, _is(Kind.ACTIVITY)),
    (tree.ActivityParameter, "name"): (Use.DECLARATION, _is(Kind.PARAMETER, _activity)),
    (tree.ActivityParameter, "type"): (Use.READ, _type),
    (tree.Activity, "ends"): (Use.DECLARATION, _is(Kind.OUTCOME, _activity)),
    (tree.Activity, "uses"): (Use.READ, _is(Kind.FUNCTIONALITY)),
    (tree.Functionality, "name"): (Use.DECLARATION, _is(Kind.FUNCTIONALITY)),
    (tree.Statechart, "name"): (Use.DECLARATION, _is(Kind.ROLE)),
    (tree.ChartNode, "label"): (Use.DECLARATION, _is(Kind.STATE, _owner)),
    (tree.ChartNode, "name"): (Use.READ, _is(Kind.ACTIVITY)),
    (tree.ChartNode, "activity"): (Use.READ, _is(Kind.ACTIVITY)),
    (tree.Team, "name"): (Use.DECLARATION, _is(Kind.TEAM)),
    (tree.TeamAgents, "names"): (Use.DECLARATION, _agent),
    (tree.TeamAgents, "role"): (Use.READ, _is(Kind.ROLE)),
    (tree.Setting, "name"): (Use.WRITE, _of_role),
    (tree.Element, "members"): (Use.READ, _of_element),
}
"""What a name in a field of a node does there, and what it means."""

UNNAMED: frozenset[tuple[type, str]] = frozenset(
    {
        (tree.Way, "verb"),  # a word of the language
        (tree.Assign, "operator"),
        (tree.Assign, "members"),  # E507: an element is set as a whole
        (tree.Import, "alias"),  # what stands behind it has its own occurrences
        (tree.Roles, "type"),
        (tree.Activity, "kind"),
        (tree.StandingWay, "verb"),
        (tree.ChartNode, "type"),
        (tree.Scenario, "statements"),  # tokens, taken apart in `_tokens`
        (tree.Property, "tokens"),
        (tree.Sent, "called"),  # known in its guarantee only
    }
)
"""Where the tree has names that mean nothing by themselves."""


def _held_by(around: Around, message: str, member: str) -> str | None:
    owner = around.world.symbols.message(message)
    found = owner.field(member) if owner is not None else None
    return found.type.name or None if found is not None else None


def _held(around: Around, written: tree.Expression | None) -> str | None:
    """The message (or enum) that a member, or an element of a list that is one, is of."""
    members: list[str] = []
    seen: set[Symbol] = set()
    while True:
        while isinstance(written, tree.Parenthesised):
            written = written.inner
        if isinstance(written, tree.Element):
            members[:0] = [item.text for item in written.members]
            written = written.list
            continue
        if not isinstance(written, tree.Path):
            return None
        named = around.values.get(written.text)
        if named is None or named in seen or named not in around.lets:
            break
        seen.add(named)
        written = around.lets[named]
    last = next(reversed(list(_value(around, written))), None)
    if last is None or last.symbol.kind not in (Kind.FIELD, Kind.VARIABLE):
        return None
    message = around.held.get(last.symbol)
    if last.symbol.kind is Kind.FIELD:
        message = _held_by(around, last.symbol.owner, last.symbol.name)
    for member in members:
        message = None if message is None else _held_by(around, message, member)
    return message


# ---- dotted names --------------------------------------------------------------------------------


def _value(around: Around, path: tree.Path, use: Use = Use.READ) -> Iterator[Occurrence]:
    """A variable, a let, an enum's constant, or a message on a topic with its members."""
    first = path.segments[0]
    symbols = around.world.symbols
    node = around.node
    if first.text in around.values:
        symbol = around.values[first.text]
        yield Occurrence(first.span, symbol, use, node)
        message = around.taken.get(first.text) or around.held.get(symbol) or _message_of_let(around, symbol)
        yield from _members(around, message, path.segments[1:], use)
        return
    if first.text in PERFORMATIVES and symbols.topic(first.text) is None and len(path.segments) > 1:
        message = path.segments[1].text
        yield Occurrence(first.span, Symbol(Kind.PERFORMATIVE, first.text), use, node)
        yield Occurrence(path.segments[1].span, Symbol(Kind.MESSAGE, message), use, node)
        yield from _members(around, message, path.segments[2:], use)
        return
    enum = symbols.enum(first.text)
    if enum is not None:
        yield Occurrence(first.span, Symbol(Kind.ENUM, enum.name), Use.READ, node)
        for name in path.segments[1:2]:
            yield Occurrence(name.span, Symbol(Kind.CONSTANT, name.text, enum.name), Use.READ, node)
        return
    yield from _channel(around, path, use)


def _channel(around: Around, path: tree.Path, use: Use = Use.READ) -> Iterator[Occurrence]:
    """`topic.state.Message.member`, with a sender before it or not; or a topic alone."""
    segments = path.segments
    start = 1 if len(segments) > 2 and segments[1].text not in COMM_TYPES else 0
    if start == 1 and segments[2].text not in COMM_TYPES:
        return
    node = around.node
    if start == 1:
        yield Occurrence(segments[0].span, Symbol(Kind.AGENT, segments[0].text), Use.READ, node)
    if len(segments) == 1 and around.world.symbols.topic(segments[0].text) is None:
        return
    kinds = (Kind.TOPIC, Kind.COMM, Kind.MESSAGE)
    for kind, name in zip(kinds, segments[start:], strict=False):
        written = use if kind is Kind.MESSAGE else Use.READ
        yield Occurrence(name.span, Symbol(kind, name.text), written, node)
    if len(segments) > start + 3:
        yield from _members(around, segments[start + 2].text, segments[start + 3 :], use)


def _members(
    around: Around, message: str | None, members: Iterable[tree.Name], use: Use
) -> Iterator[Occurrence]:
    for name in members:
        found = around.world.symbols.message(message) if message is not None else None
        if found is None or message is None:
            return
        yield Occurrence(name.span, Symbol(Kind.FIELD, name.text, message), use, around.node)
        member = found.field(name.text)
        message = member.type.name if member is not None and member.type.name else None


def _message_of_let(around: Around, symbol: Symbol) -> str | None:
    """The message that a let stands for, where it is one."""
    seen: set[Symbol] = set()
    while symbol not in seen:
        seen.add(symbol)
        value = around.lets.get(symbol)
        while isinstance(value, tree.Parenthesised):
            value = value.inner
        if not isinstance(value, tree.Path):
            return None
        classes = [index for index, name in enumerate(value.segments) if name.text in COMM_TYPES]
        if classes:
            return value.segments[-1].text if len(value.segments) == classes[0] + 2 else None
        symbol = around.values.get(value.text, symbol)
    return None


def _called(around: Around, path: tree.Path) -> Iterator[Occurrence]:
    name = path.segments[0]
    if len(path.segments) == 1:
        yield Occurrence(name.span, Symbol(Kind.FUNCTION, name.text), Use.READ, around.node)


TIMER_FORMS = ("start_timer", "expired")
TERM_FORMS = ("in", "done", "count", "outcome")
"""Forms that are asked of a formula, an activity or a participant."""


def name_of(leaf: Formula) -> Span:
    """The name in a formula's node, without what it is given."""
    return Span(leaf.span.source, leaf.span.start, leaf.span.start + len(leaf.name))


# ---- a whole declaration --------------------------------------------------------------------------


def occurrences(declaration: tree.Declaration, world: World) -> tuple[Occurrence, ...]:
    """Every name in a declaration that means something, in the order of the text."""
    found: list[Occurrence] = []
    lets = world.symbols.lets
    top = Around(world, values=_lets(lets, ""), lets=_meanings(lets, ""))
    todo: list[tuple[object, Around]] = [(declaration, top)]
    while todo:
        node, around = todo.pop()
        around = replace(_inside(node, around), node=node)
        if isinstance(node, (tree.Scenario, tree.Property)):
            found += _tokens(node, around)
            continue
        for name, value in _parts(node):
            use, meaning = NAMES.get((type(node), name), (Use.READ, None))
            for item in value if isinstance(value, tuple) else (value,):
                if isinstance(item, tree.Path):
                    found += _path(node, name, item, around)
                elif isinstance(item, Formula):
                    for leaf in names(item):
                        found.append(Occurrence(name_of(leaf), around.term(leaf.name), Use.READ, node))
                        todo += ((argument, around) for argument in leaf.arguments)
                elif isinstance(item, Argument):
                    todo.append((item, around))
                elif meaning is not None:
                    for written in _names_in(item):
                        symbol = meaning(around, written)
                        if symbol is not None:
                            found.append(Occurrence(written.span, symbol, use, node))
                elif is_dataclass(item):
                    todo.append((item, around))
    return tuple(sorted(found, key=lambda item: (item.span.start, item.span.end)))


def _tokens(node: tree.Scenario | tree.Property, around: Around) -> Iterator[Occurrence]:
    """What the words of a scenario or property mean, as far as they name what is declared."""
    found: dict[int, Occurrence] = {}
    statements = read_statements(node.span.source, node.words, isinstance(node, tree.Property))[0]
    for item in _stated(statements, around):
        found.setdefault(item.span.start, item)
    for word in node.words:
        if word.span.start not in found:
            yield from _word(word, node, around)
    yield from found.values()


def _word(word: tree.Name, node: object, around: Around) -> Iterator[Occurrence]:
    """What a word means by itself, wherever it stands."""
    symbols = around.world.symbols
    if "." in word.text:
        dotted = _dotted(word)
        is_enum = symbols.enum(dotted.segments[0].text) is not None
        yield from _value(around, dotted) if is_enum else _channel(around, dotted)
    elif word.text in symbols.agents:
        yield Occurrence(word.span, Symbol(Kind.AGENT, word.text), Use.READ, node)
    elif word.text in around.world.roles:
        yield Occurrence(word.span, Symbol(Kind.ROLE, word.text), Use.READ, node)
    elif word.text in symbols.activities:
        yield Occurrence(word.span, Symbol(Kind.ACTIVITY, word.text), Use.READ, node)
    else:
        found = around.world.realised.get(folded(word.text))
        if found is not None and found.name == word.text:
            yield Occurrence(word.span, found, Use.READ, node)


def _stated(statements: Iterable[nodes.Statement], around: Around) -> Iterator[Occurrence]:
    """What names mean because of the statement that they stand in."""
    todo: list[object] = list(statements)
    columns = {name.text for item in todo if isinstance(item, nodes.Table) for name in item.columns}
    while todo:
        item = todo.pop()
        match item:
            case tuple():
                todo += item
                continue
            case nodes.Filled():
                inside = replace(around, filled=item.what.segments[-1].text)
                for fill in item.fills:
                    yield from _filled(fill, fill.target, inside)
                yield from _message(item.what, around)
            case nodes.Heard():
                yield from _message(item.what, around)
            case nodes.Raises():
                yield Occurrence(item.event.span, Symbol(Kind.EVENT, item.event.text), Use.READ, around.node)
            case nodes.Simulated():
                for end in item.ends:
                    symbol = Symbol(Kind.OUTCOME, end.text, item.activity.text)
                    yield Occurrence(end.span, symbol, Use.READ, around.node)
            case tree.Place() if item.name.text not in columns:
                yield from _of_place(item, around)
            case nodes.Table():
                for cells, _ in item.rows:
                    for cell in cells:
                        if isinstance(cell, tree.Path) and len(cell.segments) == 1:
                            name = cell.segments[0]
                            yield from [*_word(name, around.node, around)] or _of_participant(name, around)
        if type(item).__module__ == nodes.__name__:
            todo += [getattr(item, name) for name, _ in _parts(item)]


def _of_place(place: tree.Place, around: Around) -> Iterator[Occurrence]:
    """A state, which is an activity if it is nothing else, and the participant behind its `@`."""
    found = [*_word(place.name, around.node, around)]
    if not found and place.name.text not in around.world.participants:
        found.append(
            Occurrence(place.name.span, Symbol(Kind.ACTIVITY, place.name.text), Use.READ, around.node)
        )
    yield from found or _of_participant(place.name, around)
    if place.at is not None:
        yield from _of_participant(place.at, around)


def _of_participant(name: tree.Name, around: Around) -> Iterator[Occurrence]:
    """A participant, where only one protocol has one of this name."""
    owners = around.world.participants.get(name.text, ())
    if len(owners) == 1:
        symbol = Symbol(Kind.PARTICIPANT, name.text, owners[0])
        yield Occurrence(name.span, symbol, Use.READ, around.node)


def _message(what: tree.Path, around: Around) -> Iterator[Occurrence]:
    """A type of message that stands alone, as in `sent Pass`."""
    if len(what.segments) == 1 and around.world.symbols.message(what.text) is not None:
        yield Occurrence(what.span, Symbol(Kind.MESSAGE, what.text), Use.READ, around.node)


def _dotted(word: tree.Name) -> tree.Path:
    segments: list[tree.Name] = []
    start = word.span.start
    for text in word.text.split("."):
        segments.append(tree.Name(text, Span(word.span.source, start, start + len(text))))
        start += len(text) + 1
    return tree.Path(tuple(segments), word.span)


def _path(node: object, name: str, path: tree.Path, around: Around) -> Iterator[Occurrence]:
    match node:
        case tree.Call() if name == "function":
            return _called(around, path)
        case tree.Call() if node.function.text in TERM_FORMS and len(path.segments) == 1:
            return iter((Occurrence(path.segments[0].span, around.term(path.text), Use.READ, node),))
        case tree.Call() if node.function.text in ROUND_QUESTIONS and path.text in around.parties:
            return iter((Occurrence(path.segments[0].span, around.parties[path.text], Use.READ, node),))
        case tree.Call() if node.function.text in TIMER_FORMS and path is node.arguments[0]:
            timer = Symbol(Kind.TIMER, path.text, around.owner)
            use = Use.WRITE if node.function.text == "start_timer" else Use.READ
            return iter((Occurrence(path.segments[0].span, timer, use, node),))
        case tree.Binary() if (ended := _ended(node, name, path, around)) is not None:
            return iter((Occurrence(path.segments[0].span, ended, Use.READ, node),))
        case tree.Fill() if name == "target":
            return _filled(node, path, around)
        case tree.Assign() if name == "target":
            return _value(around, path, Use.WRITE)
        case tree.Activity() if path.text in around.values:
            return _value(around, path, Use.WRITE)
        case tree.Sent() if len(path.segments) == 1:
            return _message(path, around)
        case tree.Publish() | tree.Activity() | tree.Sent():
            return _channel(around, path, Use.WRITE)
        case tree.ActivityRead() if path.text not in around.values:
            return _channel(around, path)
    return _value(around, path)


def _ended(node: tree.Binary, name: str, path: tree.Path, around: Around) -> Symbol | None:
    """The outcome that a path is, if `outcome(A)`, or a let for that, is what it is compared with."""
    other = node.right if name == "left" else node.left
    seen: set[Symbol] = set()
    while True:
        if isinstance(other, tree.Parenthesised):
            other = other.inner
        elif isinstance(other, tree.Path) and (named := around.values.get(other.text)) in around.lets:
            if named is None or named in seen:
                return None
            seen.add(named)
            other = around.lets[named]
        else:
            break
    if not isinstance(other, tree.Call) or other.function.text != "outcome" or len(other.arguments) != 1:
        return None
    activity = around.world.symbols.activities.get(getattr(other.arguments[0], "text", ""))
    if activity is None or path.text not in activity.ends:
        return None
    return Symbol(Kind.OUTCOME, path.text, activity.name)


def _filled(node: tree.Fill, path: tree.Path, around: Around) -> Iterator[Occurrence]:
    """The members of a message that is filled in braces."""
    message = around.filled
    for segment in path.segments:
        owner = around.world.symbols.message(message)
        member = owner.field(segment.text) if owner is not None else None
        if member is None:
            return
        yield Occurrence(segment.span, Symbol(Kind.FIELD, segment.text, message), Use.WRITE, node)
        message = member.type.name


_FIELDS: dict[type, tuple[str, ...]] = {}


def _parts(node: object) -> Iterator[tuple[str, object]]:
    if isinstance(node, (tree.Name, tree.Text, Source, Span)):
        return
    assert is_dataclass(node) and not isinstance(node, type)
    if type(node) not in _FIELDS:
        _FIELDS[type(node)] = tuple(item.name for item in fields(node) if item.name != "span")
    for name in _FIELDS[type(node)]:
        yield name, getattr(node, name)


def _names_in(value: object) -> Iterator[tree.Name]:
    if isinstance(value, tree.Name):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _names_in(item)


def _inside(node: object, around: Around) -> Around:
    """What is visible inside a node."""
    match node:
        case tree.Enum() | tree.Message() | tree.Function():
            return replace(around, block=node)
        case tree.Aip():
            parties = {
                item.name.text: Symbol(Kind.PARTICIPANT, item.name.text, node.name.text)
                for item in node.participants
            }
            helpers = {
                item.name.text: Symbol(Kind.FORMULA, item.name.text, f"{node.name}.{party.name}")
                for party in reversed(node.participants)
                for item in party.formulas
                if item.name.text != "process"
            }
            name = node.name.text
            return replace(
                around,
                block=node,
                owner=name,
                values={**around.values, **_lets(node.lets, name)},
                lets={**around.lets, **_meanings(node.lets, name)},
                terms=parties | helpers,
                parties=parties,
            )
        case tree.Participant():
            return _in_participant(node, around)
        case tree.NamedFormula():
            return _in_formula(node, around)
        case tree.Plays():
            return replace(around, played=f"{node.protocol}.{node.participant}")
        case tree.TeamAgents():
            return replace(around, role=node.role.text)
        case tree.Activity():
            return replace(around, activity=node.name.text)
        case tree.Control() if isinstance(around.block, tree.Aip):
            for party in around.block.participants:
                formulas = {item.name.text: item for item in party.formulas}
                if node.name.text == party.name.text or node.name.text in formulas:
                    inside = _in_participant(party, around)
                    return _in_formula(formulas.get(node.name.text), inside)
        case tree.Control():
            return _in_formula(_formula_of(around, node.name.text), around)
        case tree.Srm() | tree.Statechart():
            return _in_role(node, around)
        case tree.TransitionExpression(events=events):
            named = [item for item in events if isinstance(item, tree.Received) and item.name is not None]
            taken = {str(item.name): item.message.text for item in named}
            return replace(around, values={**around.values, **_taken(events, around)}, taken=taken)
        case tree.Send(message=message) | tree.NewMessage(message=message):
            return replace(around, filled=message.text)
        case tree.Publish(path=path):
            return replace(around, filled=path.segments[-1].text)
    return around


def _taken(events: Iterable[tree.Event], around: Around) -> dict[str, Symbol]:
    """The names of what a transition takes: each is known on its own line only."""
    found: dict[str, Symbol] = {}
    for item in events:
        if isinstance(item, tree.Received | tree.Lost) and item.name is not None:
            place = f"{around.owner}:{_start(events)}"
            found[item.name.text] = Symbol(Kind.VARIABLE, item.name.text, place)
    return found


def _start(events: Iterable[tree.Event]) -> int:
    """Where the first of them stands."""
    return min(item.span.start for item in events)


def _in_formula(formula: tree.NamedFormula | None, around: Around) -> Around:
    """The parameters of a formula are visible in its text and in its control."""
    if formula is None or not formula.parameters:
        return around if formula is None else replace(around, formula=formula.name.text)
    inside = replace(around, formula=formula.name.text)
    parameters = {
        item.name.text: Symbol(Kind.PARAMETER, item.name.text, _formula(inside))
        for item in formula.parameters
    }
    return replace(inside, values={**around.values, **parameters})


def _formula_of(around: Around, name: str) -> tree.NamedFormula | None:
    """The formula of a role that a control block is about."""
    if not isinstance(around.block, tree.Srm):
        return None
    parts = (around.block, *around.world.included.get(around.block.name.text, ()))
    return next((item for part in parts for item in part.formulas if item.name.text == name), None)


def _in_participant(party: tree.Participant, around: Around) -> Around:
    owner = f"{_block(around)}.{party.name}"
    terms = {
        item.name.text: Symbol(Kind.FORMULA, item.name.text, owner)
        for item in party.formulas
        if item.name.text != "process"
    }
    terms = _played_terms(party.plays, owner) | terms
    terms.setdefault(party.name.text, around.parties[party.name.text])
    values = dict(around.values)
    for item in (*(one.name for one in party.variables), *supplied_names(party)):
        values[item.text] = Symbol(Kind.VARIABLE, item.text, owner)
    values |= _lets(party.lets, owner)
    lets = {**around.lets, **_meanings(party.lets, owner)}
    held = _types_of(party.variables, owner)
    return replace(around, owner=owner, values=values, lets=lets, terms=terms, held=held)


def _in_role(role: tree.Srm | tree.Statechart, around: Around) -> Around:
    """What a role says itself goes before what it takes over, and that before what is around it."""
    values, lets = dict(around.values), dict(around.lets)
    terms: dict[str, Symbol] = {}
    held: dict[Symbol, str] = {}
    for part in (*reversed(around.world.included.get(role.name.text, ())), role):
        owner = part.name.text
        values |= {item.name.text: Symbol(Kind.VARIABLE, item.name.text, owner) for item in part.variables}
        values |= _lets(part.lets, owner)
        lets |= _meanings(part.lets, owner)
        held |= _types_of(part.variables, owner)
        if isinstance(part, tree.Srm):
            terms |= _terms(part)
    return replace(around, block=role, owner=role.name.text, values=values, lets=lets, terms=terms, held=held)


def _terms(role: tree.Srm) -> dict[str, Symbol]:
    """What formulas of a role name besides activities."""
    owner = role.name.text
    terms = _played_terms(role.plays, owner)
    for formula in role.formulas:
        terms[formula.name.text] = Symbol(Kind.FORMULA, formula.name.text, owner)
    return terms


def _played_terms(plays: Iterable[tree.Plays], owner: str) -> dict[str, Symbol]:
    """What the formulas of a role or participant call what it plays."""
    terms: dict[str, Symbol] = {}
    for item in plays:
        played = Symbol(Kind.PARTICIPANT, item.participant.text, item.protocol.text)
        terms.setdefault(item.participant.text, played)
    for item in plays:
        if item.alias is not None:
            terms[item.alias.text] = Symbol(Kind.ALIAS, item.alias.text, owner)
    return terms


def _lets(written: Iterable[tree.Let], owner: str) -> dict[str, Symbol]:
    return {item.name.text: Symbol(Kind.LET, item.name.text, owner) for item in written}


def _types_of(variables: Iterable[tree.Var], owner: str) -> dict[Symbol, str]:
    return {Symbol(Kind.VARIABLE, item.name.text, owner): item.type.text for item in variables}


def _meanings(written: Iterable[tree.Let], owner: str) -> dict[Symbol, tree.Expression]:
    return {Symbol(Kind.LET, item.name.text, owner): item.expression for item in written}


# ---- all files ------------------------------------------------------------------------------------


class Index:
    """The occurrences of all files of a program, each part of a file indexed when it is first asked for."""

    def __init__(
        self, world: World, parts: Mapping[Source, Sequence[tree.Declaration]], of: _Indexer
    ) -> None:
        self.world = world
        self._parts = parts
        self._of = of
        self._found: dict[Source, tuple[Occurrence, ...]] = {}

    @property
    def parts(self) -> Iterable[Source]:
        """The parts of all files."""
        return tuple(self._parts)

    def part(self, part: Source) -> tuple[Occurrence, ...]:
        """All of one part of a file, in the order of the text."""
        if part not in self._found:
            self._found[part] = tuple(
                item
                for declaration in self._parts.get(part, ())
                for item in self._of(declaration, self.world)
            )
        return self._found[part]

    def at(self, part: Source, offset: int) -> Occurrence | None:
        """The name at a place; a place just behind a name is at it, too, if no other begins there."""
        behind = None
        for item in self.part(part):
            if item.span.start <= offset < item.span.end:
                return item
            if item.span.end == offset:
                behind = item
        return behind

    def all(self) -> Iterator[Occurrence]:
        """Those of all files, in the order of the files and of their texts."""
        for part in self._parts:
            yield from self.part(part)

    def of(self, *symbols: Symbol) -> tuple[Occurrence, ...]:
        """Everywhere the symbols stand, in the order of the files and of their texts."""
        wanted = set(symbols)
        names = {item.name for item in wanted}
        return tuple(
            item
            for part, declarations in self._parts.items()
            if _may_name(part, declarations, names)
            for item in self.part(part)
            if item.symbol in wanted
        )

    def declarations(self, symbol: Symbol) -> tuple[Occurrence, ...]:
        """Where the symbol is declared; where nothing declares it, nothing."""
        return tuple(item for item in self.of(symbol) if item.use is Use.DECLARATION)


def _may_name(part: Source, declarations: Sequence[tree.Declaration], names: Iterable[str]) -> bool:
    """Whether one of the names may stand there; `realises` may spell one differently. Of a name behind an
    alias, only the end stands in the text."""
    return any(name.rpartition("_")[2] in part.text for name in names) or any(
        isinstance(item, tree.Suc) for item in declarations
    )


_Indexer = Callable[[tree.Declaration, World], tuple[Occurrence, ...]]
"""`occurrences`, from memory if it can be."""

__all__ = [
    "NAMES",
    "UNNAMED",
    "Index",
    "Kind",
    "Occurrence",
    "Symbol",
    "Use",
    "World",
    "occurrences",
    "world_of",
]
