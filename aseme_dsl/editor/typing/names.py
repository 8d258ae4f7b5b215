"""Names: what may be named at each place of the grammar that wants a name.

Every place at which the grammar wants a name, a path, a label or a text is in `PLACES`, with what is offered
there. Where the author makes up a new name, the place is among `NEW`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.messages import AGENT, BYTES
from aseme_dsl.compiler.chart.aip_to_eac import PROCESS
from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.editor.files.known import Known, bindable, used_names
from aseme_dsl.editor.typing.ask import Ask
from aseme_dsl.editor.typing.items import Item, ItemKind
from aseme_dsl.editor.typing.values import members, topics
from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES, RESERVED
from aseme_dsl.grammar.text import tree
from aseme_dsl.standard_library import standard_library

Provider = Callable[[Ask], Iterable[Item]]


# ---- files and types -----------------------------------------------------------------------------


def _libraries(ask: Ask) -> Iterator[Item]:
    for path in sorted(standard_library().glob("*.aseme")):
        yield Item(path.stem, ItemKind.FILE, "standard library", _head_of(path), rank=2)


def _head_of(path: Path) -> str:
    """The comment at the top of a file."""
    lines = []
    for line in outside.read_text(path).split("\n"):
        if not line.startswith("//"):
            break
        lines.append(line.removeprefix("//").strip())
    return "\n".join(lines)


def _files(ask: Ask) -> Iterator[Item]:
    """The files beside this one, and in the folders below and above that the path has begun to name."""
    here = Path(ask.path).parent
    typed = ask.place.half.rpartition("/")[0]
    folder = here / typed if typed else here
    prefix = f"{typed}/" if typed else ""
    try:
        entries = sorted(folder.iterdir())
    except (OSError, ValueError):
        return
    for entry in entries:
        if entry.name.startswith("."):
            continue
        if entry.is_dir():
            if ask.place.inside == "text":
                yield Item(f"{prefix}{entry.name}/", ItemKind.FILE, "folder", rank=4, goes_on=True)
        elif entry.suffix in (".aseme", ".proto") and entry.resolve() != Path(ask.path).resolve():
            name = f"{prefix}{entry.name}"
            quoted = name if ask.place.inside == "text" else f'"{name}"'
            yield Item(quoted, ItemKind.FILE, "file", rank=2)


def _types(ask: Ask) -> Iterator[Item]:
    return _type_items(ask.known, lambda name: True)


def _variable_types(ask: Ask) -> Iterator[Item]:
    symbols = ask.known.symbols

    def fits(name: str) -> bool:
        kind = symbols.type_named(name)
        return kind is not None and kind != BYTES

    yield from _type_items(ask.known, fits)
    yield Item(str(AGENT), ItemKind.TYPE, "built in", rank=2)


def _type_items(known: Known, fits: Callable[[str], bool]) -> Iterator[Item]:
    symbols = known.symbols
    for name in filter(fits, symbols.type_names):
        message, enum = symbols.message(name), symbols.enum(name)
        if message is not None:
            yield _message(known, name, rank=3)
        elif enum is not None:
            constants = " ".join(constant for constant, _ in enum.constants)
            yield Item(name, ItemKind.ENUM, constants, known.documentation(enum.span), rank=3)
        else:
            yield Item(name, ItemKind.TYPE, "built in", rank=2)


def _message(known: Known, name: str, rank: int, detail: str = "") -> Item:
    message = known.symbols.message(name)
    assert message is not None
    fields = ", ".join(f"{field.type} {field.name}" for field in message.fields)
    return Item(
        name, ItemKind.MESSAGE, detail or f"{{ {fields} }}", known.documentation(message.span), rank=rank
    )


# ---- messages and topics -------------------------------------------------------------------------


def _messages(ask: Ask) -> Iterator[Item]:
    """Messages for a topic; those that it carries in this class already come last."""
    topic = ask.known.symbols.topic(ask.name("Topic") or "")
    carried = {(rules.channel.comm, rules.channel.message) for rules in topic.channels} if topic else set()
    said = [str(item) for item in ask.tokens("TopicMessages")]
    for message in ask.known.symbols.messages:
        there = message.name in said or (said[:1] and (said[0], message.name) in carried)
        yield _message(ask.known, message.name, rank=7 if there else 2)


def _upper_topics(ask: Ask) -> Iterator[Item]:
    own = ask.name("Topic")
    return (item for item in topics(ask.known.top, ask.known, 2) if item.label != own)


def _sources(ask: Ask) -> Iterator[Item]:
    yield from _agents(ask)
    yield from activities(ask)
    yield from _roles(ask)


def _channels(ask: Ask) -> Iterator[Item]:
    """`vision.state.Ball`, segment by segment."""
    if ask.place.path:
        scope = ask.known.top
        if len(ask.place.path) < 3:
            yield from (
                item for item in members(scope, ask.known, ask.place.path) if item.kind is not ItemKind.MEMBER
            )
        return
    yield from topics(ask.known.top, ask.known, 2)
    for name, (_, kind) in ask.scope.variables.items():
        yield Item(name, ItemKind.VARIABLE, str(kind), rank=2)


# ---- requirements --------------------------------------------------------------------------------


def _actors(ask: Ask) -> Iterator[Item]:
    for actor in ask.known.actors:
        goals = ", ".join(goal.name.text for goal in actor.goals)
        yield Item(actor.name.text, ItemKind.ACTOR, goals, ask.known.documentation(actor.name.span), rank=2)


def _all_roles(ask: Ask) -> Iterator[Item]:
    return (Item(name, ItemKind.ROLE, _what_role(ask.known, name), rank=2) for name in ask.known.role_names)


def _what_role(known: Known, name: str) -> str:
    for aip in known.blocks.aips:
        if any(part.name.text == name for part in aip.participants):
            return f"participant of {aip.name}"
    return "role" if any(item.name.text == name for item in known.blocks.roles) else "actor"


def _use_cases(ask: Ask) -> Iterator[Item]:
    known = ask.known
    for name in known.use_cases:
        yield Item(name, ItemKind.USE_CASE, _requirement(known, name), rank=2)


def _requirement(known: Known, name: str) -> str:
    goals = (goal for actor in known.actors for goal in actor.goals if goal.name.text == name)
    texts = [goal.requirements.text for goal in goals if goal.requirements is not None]
    return texts[0] if texts else ""


def _realised(ask: Ask) -> Iterator[Item]:
    """What a use case may be realised by: protocols, formulas, activities, capabilities."""
    known = ask.known
    for aip in known.blocks.aips:
        yield Item(aip.name.text, ItemKind.PROTOCOL, "protocol", rank=2)
    for role in known.blocks.srms:
        for formula in role.formulas:
            yield Item(formula.name.text, ItemKind.FORMULA, f"formula of {role.name}", rank=3)
        for item in role.capabilities:
            yield Item(item.name.text, ItemKind.NAME, f"capability of {role.name}", rank=3)
    yield from activities(ask)


def _roles_to_write(ask: Ask) -> Iterator[Item]:
    """Roles that are spoken of and have no model of their own yet."""
    written = {item.name.text for item in ask.known.blocks.roles}
    parts = {part.name.text for aip in ask.known.blocks.aips for part in aip.participants}
    for name in ask.known.role_names:
        if name not in written and name not in parts:
            yield Item(name, ItemKind.ROLE, "not written yet", rank=2)


def _protocols_to_write(ask: Ask) -> Iterator[Item]:
    """Use cases of several roles that have no protocol yet."""
    for suc in ask.known.blocks.sucs:
        for case in suc.usecases:
            if len(case.by) > 1 and case.includes and case.name.text not in ask.known.protocols:
                who = ", ".join(item.text for item in case.by)
                yield Item(case.name.text, ItemKind.USE_CASE, f"use case by {who}", rank=2)


def _participants_to_write(ask: Ask) -> Iterator[Item]:
    """The roles of the use case that the protocol is about."""
    aip = ask.name("Aip")
    there = {part.name.text for part in _participants(ask)}
    for suc in ask.known.blocks.sucs:
        for case in suc.usecases:
            if case.name.text == aip:
                for name in case.by:
                    if name.text not in there:
                        yield Item(name.text, ItemKind.ROLE, f"takes part in {aip}", rank=2)


# ---- protocols -----------------------------------------------------------------------------------


def _participants(ask: Ask) -> tuple[tree.Participant, ...]:
    declaration = ask.around.declaration
    return declaration.participants if isinstance(declaration, tree.Aip) else ()


def _performatives(ask: Ask) -> Iterator[Item]:
    return performatives(frozenset())


def performatives(usual: Iterable[str]) -> Iterator[Item]:
    """The 22 communicative acts of FIPA, those in `usual` first."""
    first = set(usual)
    for name in PERFORMATIVES:
        yield Item(name, ItemKind.PERFORMATIVE, "FIPA", rank=1 if name in first else 6)


def _any_messages(ask: Ask) -> Iterator[Item]:
    return (_message(ask.known, item.name, 2) for item in ask.known.symbols.messages)


def _places(ask: Ask) -> Iterator[Item]:
    """Participants, and what each does as `PassBall@center`."""
    for part in _participants(ask):
        yield Item(part.name.text, ItemKind.PARTICIPANT, "participant", rank=3)
        for name in dict.fromkeys([*used_names(part.formulas), *_helpers(part)]):
            yield Item(f"{name}@{part.name}", ItemKind.ACTIVITY, f"of {part.name}", rank=2)


def _place_owners(ask: Ask) -> Iterator[Item]:
    tokens = ask.said
    for part in _participants(ask):
        does = {node.name for item in part.formulas for node in names(item.formula)} | set(_helpers(part))
        rank = 2 if tokens and tokens[0] in does else 6
        yield Item(part.name.text, ItemKind.PARTICIPANT, "participant", rank=rank)


def _helpers(part: tree.Participant) -> list[str]:
    return [item.name.text for item in part.formulas if item.name.text != PROCESS]


def _process_names(ask: Ask) -> Iterator[Item]:
    part = ask.around.participant(ask.name("Participant") or "")
    formulas = part.formulas if part is not None else ()
    if not any(item.name.text == PROCESS for item in formulas):
        yield Item(PROCESS, ItemKind.WORD, "what it does", "", f"{PROCESS} = ", rank=2)
    yield from _formulas_to_write(ask, formulas)


# ---- roles ---------------------------------------------------------------------------------------


def _protocols(ask: Ask) -> Iterator[Item]:
    for aip in ask.known.blocks.aips:
        parts = ", ".join(part.name.text for part in aip.participants)
        yield Item(
            aip.name.text,
            ItemKind.PROTOCOL,
            parts,
            ask.known.documentation(aip.name.span),
            insert=f"{aip.name}.",
            rank=2,
            goes_on=True,
        )


def _played_participants(ask: Ask) -> Iterator[Item]:
    tokens = ask.said
    protocol = ask.known.protocols.get(str(tokens[0])) if tokens else None
    for part in protocol.participants if protocol is not None else ():
        engage = " ".join(text.text for text in part.engage)
        yield Item(part.name.text, ItemKind.PARTICIPANT, engage, rank=2)


def _abstract_activities(ask: Ask) -> Iterator[Item]:
    """The activities of the participant that is played, which who plays it may do otherwise."""
    tokens = [str(item) for item in ask.tokens("Part")]
    protocol = ask.known.protocols.get(tokens[0]) if tokens else None
    parts = protocol.participants if protocol is not None else ()
    part = next((item for item in parts if item.name.text in tokens[2:3]), None)
    if part is not None:
        for name in bindable(part):
            rank = 7 if name in tokens else 2
            yield Item(name, ItemKind.ACTIVITY, f"of {part.name}", "", f"{name} = ", rank=rank)
        supplied = [(item.name.text, f"given {item.type}") for item in part.inputs]
        supplied += [(item.name.text, f"result {item.type}") for item in part.results]
        for name, detail in supplied:
            rank = 7 if name in tokens else 1
            yield Item(name, ItemKind.VARIABLE, detail, "", f"{name} = ", rank=rank)


def _activities_that_send(ask: Ask) -> Iterator[Item]:
    """The activities of the participant, which may send a message that it lists."""
    name = ask.scope.participant
    part = ask.around.participant(name) if name is not None else None
    for activity in used_names(part.formulas) if part is not None else ():
        yield Item(activity, ItemKind.ACTIVITY, f"of {name}", rank=2)


def activities(ask: Ask) -> Iterator[Item]:
    """The activities of all roles and protocols."""
    for name, described in ask.known.activities.items():
        said = ask.known.documentation(described.span) if described is not None else ""
        yield Item(name, ItemKind.ACTIVITY, "activity", said, rank=3)


def _capable(ask: Ask) -> Iterator[Item]:
    yield from formula_names(ask)


def formula_names(ask: Ask) -> Iterator[Item]:
    """What a formula of this role or participant may name; what none uses yet comes first."""
    declaration = ask.around.declaration
    formulas: tuple[tree.NamedFormula, ...] = ()
    if isinstance(declaration, tree.Srm):
        formulas = declaration.formulas
    else:
        part = ask.around.participant(ask.name("Participant") or "")
        formulas = part.formulas if part is not None else ()
    used = {node.name for item in formulas for node in names(item.formula)}
    own = ask.said[0] if ask.expected.place[1] == "tokens" and ask.said else ""
    player = None if isinstance(declaration, tree.Srm) else ask.name("Participant") or ""
    for name, played in ask.around.played(player).items():
        engage = " ".join(text.text for text in played.engage) if played is not None else ""
        yield Item(name, ItemKind.PARTICIPANT, engage, rank=3 if name in used else 1)
    written = {item.name.text for item in formulas}
    root = _root(ask)
    for formula in formulas:
        if formula is not root and formula.name.text not in (own, PROCESS):
            name = formula.name.text
            text = " ".join(formula.formula.span.text.split())
            yield Item(name, ItemKind.FORMULA, text, rank=3 if name in used else 1)
    for item in activities(ask):
        if item.label not in written and item.label != own:
            yield replace(item, rank=2) if item.label in used else item


def _root(ask: Ask) -> tree.NamedFormula | None:
    """The formula that the others refine: the first of a role, unless it is the one that is being typed."""
    role = ask.around.written
    if not isinstance(role, tree.Srm) or not role.formulas:
        return None
    typed = ask.place.entry
    before = typed is not None and typed < ask.place.first + role.formulas[0].span.start
    return None if before else role.formulas[0]


def _formulas_to_write(ask: Ask, formulas: tuple[tree.NamedFormula, ...]) -> Iterator[Item]:
    """What formulas name: each is an activity, or gets a formula of its own."""
    begun = ask.place.tokens_from(ask.place.entry) if ask.place.entry is not None else []
    used = [str(item) for item in begun[2:] if item.isidentifier()] if begun[1:2] == ["="] else []
    for name in dict.fromkeys([*used_names(formulas), *used]):
        if [name] == begun[:1] or name in RESERVED or name in BUILT_IN_TYPES:
            continue
        yield Item(name, ItemKind.NAME, "used in a formula", "", f"{name} = ", rank=4)


def _formula_names(ask: Ask) -> Iterator[Item]:
    declaration = ask.around.declaration
    if isinstance(declaration, tree.Srm):
        written = ask.around.written
        if isinstance(written, tree.Srm) and not written.formulas and ask.place.entry is None:
            name = declaration.name.text
            yield Item(name, ItemKind.FORMULA, "the role's own", "", f"{name} = ", rank=2)
        described = {item.name.text for item in declaration.activities}
        for item in _formulas_to_write(ask, declaration.formulas):
            if item.label not in described and item.label not in ask.around.played():
                yield item


def _activities_to_describe(ask: Ask) -> Iterator[Item]:
    """The activities that the role's formulas use and its blocks do not describe."""
    declaration = ask.around.declaration
    if not isinstance(declaration, tree.Srm):
        return
    described = {
        item.name.text for item in (*declaration.activities, *(m.activity for m in declaration.modules))
    }
    used = used_names(declaration.formulas)
    used += [item.own.text for play in declaration.plays for item in play.bindings if item.own is not None]
    used += ask.around.performed()
    for name in dict.fromkeys(used):
        if name not in described and name not in ask.around.played():
            yield Item(name, ItemKind.ACTIVITY, "not described yet", rank=2)


def _functionalities(ask: Ask) -> Iterator[Item]:
    for name, where in ask.known.functionalities.items():
        yield Item(name, ItemKind.FUNCTIONALITY, "", ask.known.documentation(where.span), rank=2)


def _functionalities_to_describe(ask: Ask) -> Iterator[Item]:
    described = {item.name.text for role in ask.known.blocks.srms for item in role.functionalities}
    for item in _functionalities(ask):
        if item.label not in described:
            yield item


# ---- control and statecharts ---------------------------------------------------------------------


def _controls(ask: Ask) -> Iterator[Item]:
    """The formulas that control can be said of; those that have none yet come first."""
    declaration = ask.around.declaration
    if isinstance(declaration, tree.Srm):
        found = [(item.name.text, item) for item in declaration.formulas]
    elif isinstance(declaration, tree.Aip):
        found = []
        for part in declaration.participants:
            for item in part.formulas:
                name = part.name.text if item.name.text == PROCESS else item.name.text
                found.append((name, item))
    else:
        return
    there = {item.name.text for item in declaration.controls}
    for name, item in found:
        text = " ".join(item.formula.span.text.split())
        yield Item(name, ItemKind.FORMULA, text, rank=6 if name in there else 2)


def _labels(ask: Ask) -> Iterator[Item]:
    """The states of a statechart by their labels."""
    declaration = ask.around.declaration
    nodes = declaration.nodes if isinstance(declaration, tree.Statechart) else ()
    for node in nodes:
        yield Item(node.label.text, ItemKind.STATE, f"{node.type} {node.name or ''}".strip(), rank=2)


# ---- teams ---------------------------------------------------------------------------------------


def _agents(ask: Ask) -> Iterator[Item]:
    for team in ask.known.symbols.teams:
        for agent in team.agents:
            yield Item(agent.name, ItemKind.AGENT, f"agent: {agent.role}", rank=4)


def _roles(ask: Ask) -> Iterator[Item]:
    for item in ask.known.blocks.roles:
        said = ask.known.documentation(item.name.span)
        yield Item(item.name.text, ItemKind.ROLE, "role", said, rank=2)


def _settings(ask: Ask) -> Iterator[Item]:
    """The variables of the role that the agents have; those that are set already come last."""
    said = [str(item) for item in ask.tokens("Agents")]
    name = said[said.index(":") + 1] if ":" in said[:-1] else ""
    role = next((item for item in ask.known.blocks.roles if item.name.text == name), None)
    for item in role.variables if role is not None else ():
        rank = 7 if item.name.text in said else 2
        yield Item(item.name.text, ItemKind.VARIABLE, item.type.text, "", f"{item.name} = ", rank=rank)


PLACES: Mapping[tuple[str, str], Provider] = {
    ("Import", "library"): _libraries,
    ("Import", "path"): _files,
    ("Field", "type"): _types,
    ("Parameter", "type"): _types,
    ("Function", "result"): _types,
    ("ActivityParameter", "type"): _types,
    ("FormulaParameter", "type"): _types,
    ("Var", "type"): _variable_types,
    ("Var", "element"): _variable_types,
    ("Given", "type"): _variable_types,
    ("Result", "type"): _variable_types,
    ("Topic", "under"): _upper_topics,
    ("TopicMessages", "messages"): _messages,
    ("TopicFrom", "sources"): _sources,
    ("Depends", "actors"): _actors,
    ("By", "roles"): _all_roles,
    ("Inclusion", "roles"): _roles,
    ("Includes", "usecases"): _use_cases,
    ("Realises", "names"): _realised,
    ("Aip", "name"): _protocols_to_write,
    ("Srm", "name"): _roles_to_write,
    ("Statechart", "name"): _roles_to_write,
    ("Participant", "name"): _participants_to_write,
    ("AgentMessage", "performative"): _performatives,
    ("AgentMessage", "message"): _any_messages,
    ("SentMessage", "performative"): _performatives,
    ("SentMessage", "message"): _any_messages,
    ("SentMessage", "by"): _activities_that_send,
    ("Process", "name"): _process_names,
    ("Place", "name"): _places,
    ("Place", "at"): _place_owners,
    ("Part", "protocol"): _protocols,
    ("Part", "participant"): _played_participants,
    ("Binding", "abstract"): _abstract_activities,
    ("Capability", "activities"): _capable,
    ("Formula", "name"): _formula_names,
    ("Activity", "name"): _activities_to_describe,
    ("Module", "name"): _activities_to_describe,
    ("Uses", "functionalities"): _functionalities,
    ("Read", "path"): _channels,
    ("Writes", "paths"): _channels,
    ("Functionality", "name"): _functionalities_to_describe,
    ("Control", "name"): _controls,
    ("LabelledWay", "source"): _labels,
    ("LabelledWay", "target"): _labels,
    ("LabelledWay", "targets"): _labels,
    ("StandingWay", "state"): _labels,
    ("ChartNode", "name"): activities,
    ("ChartNode", "activity"): activities,
    ("Agents", "role"): _roles,
    ("Setting", "name"): _settings,
}
"""What is offered, by the rule of the grammar and its attribute."""

NEW = frozenset(
    (
        ("System", "name"),
        ("Enum", "name"),
        ("EnumConstant", "name"),
        ("Message", "name"),
        ("Field", "name"),
        ("Topic", "name"),
        ("Function", "name"),
        ("Function", "target"),
        ("Parameter", "name"),
        ("Let", "name"),
        ("Var", "name"),
        ("Given", "name"),
        ("Result", "name"),
        ("Actor", "name"),
        ("Goal", "name"),
        ("Requirements", "text"),
        ("Roles", "names"),
        ("UseCase", "name"),
        ("Outcome", "text"),
        ("Engage", "text"),
        ("Part", "alias"),
        ("Import", "alias"),
        ("Capability", "name"),
        ("Capability", "description"),
        ("ModuleCode", "target"),
        ("FunctionalityText", "text"),
        ("Ends", "outcomes"),
        ("ActivityParameter", "name"),
        ("FormulaParameter", "name"),
        ("ChartNode", "label"),
        ("Team", "name"),
        ("AgentName", "name"),
        ("Scenario", "title"),
        ("Property", "title"),
    )
)
"""Where the author makes up a name or a text."""

__all__ = ["NEW", "PLACES", "activities", "formula_names", "performatives"]
