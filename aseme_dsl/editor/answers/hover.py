"""Hover: what there is to know of the name at a place, as Markdown."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.messages import ChannelKind
from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.compiler.formula.staying import ABANDON
from aseme_dsl.compiler.read.blocks import with_exchange
from aseme_dsl.compiler.read.builtins import FORMS
from aseme_dsl.diagnostics import CODES
from aseme_dsl.editor.answers.constructs import meanings
from aseme_dsl.editor.files.aliases import alias_at, comments_near
from aseme_dsl.editor.files.comments import documentation
from aseme_dsl.editor.files.index import Kind, Occurrence, Symbol, Use, name_of
from aseme_dsl.editor.files.known import nodes
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import Tokens, clean
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_MOST = 8
"""How many of a kind are listed."""

_CODE = re.compile(r"\b[EWN]\d{3}\b")

_COMMS = {
    ChannelKind.SIGNAL: "a signal: the first reader consumes it",
    ChannelKind.STATE: "a state: the latest value counts",
    ChannelKind.DATA: "data: values with the time of their measurement, and a history",
}

_TYPES = {
    "bool": "`true` or `false`",
    "int": "a whole number",
    "double": "a number with a decimal point",
    "string": 'a text in double quotes: `"text"`',
    "bytes": "bytes; conditions cannot look inside",
    "duration": "a time: `200ms`, `1.5s`, `2min`",
    "agent": "an agent of the team; absent at first",
}


@dataclass(frozen=True, slots=True)
class Hover:
    """Markdown about what stands at `span`, a whole one."""

    span: Span
    text: str


def hover(view: View, offset: int) -> Hover | None:
    """What there is to know of the name, or of the code of a diagnostic, at `offset`."""
    code = _code_at(view, offset)
    if code is not None:
        return code
    found = view.occurrence_at(offset)
    if found is None and (alias := _alias_at(view, offset)) is not None:
        return alias
    if (
        found is None or _is_abandon(view, found) or view.whole(found.span).end == offset
    ):  # a sign behind a name is pointed at itself
        construct = _construct_at(view, offset)
        if construct is not None or found is None:
            return construct
    parts = [*_about(view.program, found)]
    return Hover(view.whole(found.span), "\n\n".join(part for part in parts if part)) if parts else None


def _alias_at(view: View, offset: int) -> Hover | None:
    """What the name of an import stands for, at `alice` of `alice.attacker`."""
    alias = alias_at(view, offset)
    if alias is None:
        return None
    means = f"What the file declares stands behind `{alias.span.text}.`"
    return Hover(alias.span, f"{_fence(alias.said)}\n\n{means}")


def _is_abandon(view: View, found: Occurrence) -> bool:
    """Whether a name is that of `on abandon`, which is not a term."""
    span = view.whole(found.span)
    line = view.source.text[: span.start].rpartition("\n")[2]
    return span.text == ABANDON and line.split()[-1:] == ["on"]


def _construct_at(view: View, offset: int) -> Hover | None:
    """A word or sign of the language; nothing in comments and texts."""
    if any(span.start <= offset < span.end for span in comments_near(view, offset)):
        return None
    begin = view.source.text.rfind("\n", 0, offset) + 1
    line = clean(Source(view.path, view.source.text[begin:].partition("\n")[0])).text
    tokens = Tokens(line)
    for start, end in zip(tokens.starts, tokens.ends, strict=True):
        is_last = offset - begin == end and not line[end : end + 1].strip()
        if start <= offset - begin < end or is_last:
            found = meanings(line[start:end], _sections(view, offset, line[:start], line[start:end]))
            text = "\n\n".join(item.text for item in found)
            return Hover(Span(view.source, begin + start, begin + end), text) if found else None
    return None


_CONDITIONS = ("Values", "When", "Actions", "Control")
_MODELS = "Goals, roles, protocols, teams"


def _sections(view: View, offset: int, before: str, token: str) -> tuple[str, ...]:
    """The sections of the table of constructs that a token may be about, the likeliest first.

    `before` is what stands before it on its line.
    """
    part, inside = view.at(offset)
    declaration = view.declaration_at(offset)
    if isinstance(declaration, (tree.Message, tree.Enum, tree.Topic, tree.Function)):
        return "Messages", "Values"
    if isinstance(declaration, tree.Let):
        return _CONDITIONS
    around = set()
    for node in nodes(declaration):
        if isinstance(node, (tree.NamedFormula, tree.TransitionExpression, tree.Control)):
            span = node.formula.span if isinstance(node, tree.NamedFormula) else node.span
            if span.source is part and span.start <= inside <= span.end:
                around.add(type(node))
    if tree.NamedFormula in around:
        return ("Formulas",)
    if tree.TransitionExpression in around:
        if before.count("[") > before.count("]"):
            return _CONDITIONS
        begins_actions = token == ";" or (token == "/" and "/" not in before.rpartition(":")[2])
        is_word = token[0].isalpha() or token[0] == "_"
        return ("When", "Actions") if is_word else ("Control",) if begins_actions else _CONDITIONS
    if tree.Control in around:
        return "Control", "When", "Actions", "Values"
    return _MODELS, "Files", "Messages"


def explained(code: str) -> str:
    """What a code means: its title and the explanation of its page."""
    from aseme_dsl.diagnostics.pages import page

    try:
        text = page(code).text
    except (KeyError, ValueError):
        text = ""
    return f"**{code}** {CODES[code].title}\n\n{text}".strip()


def _code_at(view: View, offset: int) -> Hover | None:
    """A code in a comment to asemec."""
    for span in comments_near(view, offset):
        if span.start <= offset <= span.end and "asemec" in span.text:
            for found in _CODE.finditer(span.text):
                start, end = span.start + found.start(), span.start + found.end()
                if start <= offset <= end and found.group() in CODES:
                    return Hover(Span(span.source, start, end), explained(found.group()))
    return None


def _about(program: Program, found: Occurrence) -> Iterator[str]:
    symbol = found.symbol
    describe = _DESCRIBE.get(symbol.kind)
    if describe is not None:
        yield from describe(program, symbol)
    declared = program.index.declarations(symbol)
    for item in declared:
        span = program.whole(item.span)
        for file in program.inspection.loaded.files:
            if file.source is span.source:
                yield documentation(file, span)
    labels = _labels(program, found)
    if labels:
        yield "State " + _listed(f"`{label}` of {chart}" for chart, label in labels)


def _fence(text: str) -> str:
    return f"```aseme\n{text}\n```"


def _listed(items: Iterable[str]) -> str:
    found = list(dict.fromkeys(items))
    shown = ", ".join(found[:_MOST])
    return shown if len(found) <= _MOST else f"{shown} and {len(found) - _MOST} more"


def _nodes(program: Program, symbol: Symbol) -> Iterator[object]:
    return (item.node for item in program.index.declarations(symbol))


def _text(program: Program, span: Span) -> str:
    """What is written there, in one line."""
    return " ".join(span.text.split())


# ---- what each kind of thing is ----------------------------------------------------------------


def _comm(program: Program, symbol: Symbol) -> Iterator[str]:
    if symbol.name in _COMMS:  # while it is being typed, it may be anything
        yield f"`{symbol.name}`: {_COMMS[ChannelKind(symbol.name)]}"


def _message(program: Program, symbol: Symbol) -> Iterator[str]:
    found = program.inspection.symbols.message(symbol.name)
    if found is None:
        return
    fields = "\n".join(
        f"  {item.label + ' ' if item.label else ''}{item.type} {item.name}" for item in found.fields
    )
    yield _fence(f"message {found.name} {{\n{fields}\n}}")
    if found.imported:
        yield f"From `{found.imported}`"
    channels = program.inspection.symbols.channels_of(found.name)
    if channels:
        yield "On " + _listed(f"`{channel}`" for channel in channels)


def _field(program: Program, symbol: Symbol) -> Iterator[str]:
    message = program.inspection.symbols.message(symbol.owner)
    member = message.field(symbol.name) if message is not None else None
    if member is not None:
        label = f"{member.label} " if member.label else ""
        yield _fence(f"{label}{member.type} {member.name} = {member.number}")
        yield f"Member of `{symbol.owner}`"


def _enum(program: Program, symbol: Symbol) -> Iterator[str]:
    found = program.inspection.symbols.enum(symbol.name)
    if found is not None:
        yield _fence(f"enum {found.name} {{ {' '.join(name for name, _ in found.constants)} }}")


def _constant(program: Program, symbol: Symbol) -> Iterator[str]:
    found = program.inspection.symbols.enum(symbol.owner)
    number = found.number(symbol.name) if found is not None else None
    if number is not None:
        yield _fence(f"{symbol.owner}.{symbol.name} = {number}")


def _topic(program: Program, symbol: Symbol) -> Iterator[str]:
    found = program.inspection.symbols.topic(symbol.name)
    if found is None:
        return
    under = f" under {found.under}" if found.under else ""
    lines = "\n".join(f"  {item.channel.comm} {item.channel.message}" for item in found.channels)
    radio = f" radio {found.radio}" if found.radio is not None else ""
    delay = f" delay {duration_text(found.delay)}" if found.delay is not None else ""
    yield _fence(f"topic {found.name}{under}{radio}{delay} {{\n{lines}\n}}")
    readers, writers = _readers_and_writers(program, symbol.name)
    if readers:
        yield "Read by " + _listed(readers)
    if writers:
        yield "Written by " + _listed(writers)


def _readers_and_writers(program: Program, topic: str) -> tuple[list[str], list[str]]:
    """Who reads a topic, and who writes it: activities, and control blocks of roles and participants."""
    readers: dict[str, None] = {}
    writers: dict[str, None] = {}
    for block in program.inspection.blocks.roles:
        for activity in (*block.activities, *(module.activity for module in block.modules)):
            if any(_is_on(item.path, topic) for item in activity.reads):
                readers[f"`{activity.name}`"] = None
            if any(_is_on(path, topic) for path in activity.writes):
                writers[f"`{activity.name}`"] = None
    for item in program.index.of(Symbol(Kind.TOPIC, topic)):
        if isinstance(item.node, (tree.ActivityRead, tree.Activity, tree.Topic)):
            continue
        where = _where(program, item.span)
        written = isinstance(item.node, (tree.Publish, tree.Assign)) and item.span.start == _first(item.node)
        (writers if written else readers)[where] = None
    return list(readers), list(writers)


def _where(program: Program, span: Span) -> str:
    """The control block, or the declaration, that a place is in."""
    found = program.control_at(span)
    if found is not None:
        block, control = found
        return f"`control {control.name}` of {block.name}"
    block_at = program.block_at(span)
    name = getattr(block_at, "name", None)
    return f"`{name}`" if name is not None else "a declaration"


def _first(node: tree.Publish | tree.Assign) -> int:
    path = node.path if isinstance(node, tree.Publish) else node.target
    classes = [index for index, name in enumerate(path.segments) if name.text in tuple(ChannelKind)]
    return path.segments[classes[0] - 1].span.start if classes else -1


def _is_on(path: tree.Path, topic: str) -> bool:
    return path.segments[0].text == topic or (len(path.segments) > 3 and path.segments[1].text == topic)


def _function(program: Program, symbol: Symbol) -> Iterator[str]:
    for function in program.inspection.symbols.overloads(symbol.name):
        parameters = ", ".join(f"{kind} {name}" for name, kind in function.parameters)
        yield _fence(f"function {function.name}({parameters}) : {function.result}")
        if function.is_of_document:
            yield f"Python: `{function.target}`"
    if symbol.name in FORMS:
        yield _fence(FORMS[symbol.name])


def _let(program: Program, symbol: Symbol) -> Iterator[str]:
    kind = type_of(program, symbol)
    for node in _nodes(program, symbol):
        if isinstance(node, tree.Let):
            yield _fence(
                f"let {node.name}{f' : {kind}' if kind else ''} = {_text(program, node.expression.span)}"
            )


def _variable(program: Program, symbol: Symbol) -> Iterator[str]:
    for node in _nodes(program, symbol):
        if isinstance(node, tree.Var):
            initial = f" = {_text(program, node.initial.span)}" if node.initial is not None else ""
            bounds = f" {_text(program, node.bounds.span)}" if node.bounds is not None else ""
            length = f"[{node.length.value}]" if node.length is not None else ""
            many = f"list{length} of " if node.is_list else ""
            yield _fence(f"var {node.name} : {many}{node.type}{bounds}{initial}")
        elif isinstance(node, tree.Given):
            yield _fence(f"given {node.name} : {node.type}")
    yield f"Variable of `{symbol.owner}`"


def type_of(program: Program, symbol: Symbol) -> str | None:
    """The type of a variable or let, where it is known."""
    known = program.inspection
    protocol, _, participant = symbol.owner.partition(".")
    if participant or protocol in known.participants:
        parties = known.participants.get(protocol, {})
        typed = parties.get(participant) if participant else next(iter(parties.values()), None)
        scope = typed.scope if typed is not None else known.top
    else:
        role = known.scopes.get(symbol.owner)
        scope = role.scope if role is not None else known.top
    if symbol.kind is Kind.VARIABLE:
        found = scope.variables.get(symbol.name)
        kind = found[1] if found is not None else scope.parameters.get(symbol.name)
        return str(kind) if kind is not None else None
    let = scope.lets.get(symbol.name)
    return str(let.value.type) if let is not None and let.value is not None else None


def _parameter(program: Program, symbol: Symbol) -> Iterator[str]:
    for node in _nodes(program, symbol):
        match node:
            case tree.Parameter():
                yield _fence(f"{node.type} {node.name}")
            case tree.FormulaParameter() | tree.ActivityParameter():
                yield _fence(f"{node.name} : {node.type}" if node.type is not None else str(node.name))


def _formula(program: Program, symbol: Symbol) -> Iterator[str]:
    for node in _nodes(program, symbol):
        if isinstance(node, tree.NamedFormula):
            yield _fence(f"{node.name} = {_text(program, node.formula.span)}")
    yield f"Formula of `{symbol.owner}`"


def _activity(program: Program, symbol: Symbol) -> Iterator[str]:
    nodes = [node for node in _nodes(program, symbol) if isinstance(node, tree.Activity)]
    for node in nodes:
        yield _fence(_text(program, node.span))
    if not nodes:
        yield f"Activity `{symbol.name}`, of which nothing is said yet"


def _participant(program: Program, symbol: Symbol) -> Iterator[str]:
    exchanging = {
        item.span: item
        for file in program.inspection.loaded.files
        for aip in file.declarations
        if isinstance(aip, tree.Aip)
        for item in with_exchange(aip).participants
    }
    for node in _nodes(program, symbol):
        if not isinstance(node, tree.Participant):
            continue
        node = exchanging.get(node.span, node)
        many = f" {node.multiplicity.span.text}" if node.multiplicity is not None else ""
        yield _fence(f"participant {node.name}{many}")
        yield f"Participant of the protocol `{symbol.owner}`"
        for text in node.engage:
            yield f"Engages: {text.text}"
        for word, messages in (("Sends", node.sends), ("Receives", node.receives)):
            if messages:
                yield f"{word} " + _listed(f"`{_agent_message(item)}`" for item in messages)


def _agent_message(item: tree.AgentMessage) -> str:
    by = f" by {' or '.join(name.text for name in item.by)}" if item.by else ""
    return f"{item.performative} {item.message}{by}{' repeatedly' if item.repeatedly else ''}"


def _alias(program: Program, symbol: Symbol) -> Iterator[str]:
    for node in _nodes(program, symbol):
        if isinstance(node, tree.Plays):
            yield _fence(f"plays {_text(program, node.span)}")


def _protocol(program: Program, symbol: Symbol) -> Iterator[str]:
    for node in _nodes(program, symbol):
        if isinstance(node, tree.Aip):
            yield _fence(
                f"aip {node.name} {{ {' '.join(f'participant {p.name}' for p in node.participants)} }}"
            )
            yield from (f"Outcome: {item.text.text}" for item in node.outcomes)


def _role(program: Program, symbol: Symbol) -> Iterator[str]:
    node = next((n for n in _nodes(program, symbol) if isinstance(n, (tree.Srm, tree.Statechart))), None)
    if isinstance(node, tree.Srm) and node.formulas:
        yield _fence(
            f"srm {node.name}\n{node.formulas[0].name} = {_text(program, node.formulas[0].formula.span)}"
        )
    else:
        yield _fence(f"role {symbol.name}")
    agents = [
        a.name for team in program.inspection.symbols.teams for a in team.agents if a.role == symbol.name
    ]
    if agents:
        yield "Role of " + _listed(f"`{name}`" for name in agents)


def _use_case(program: Program, symbol: Symbol) -> Iterator[str]:
    case = next((item for item in program.inspection.suc.usecases if item.name == symbol.name), None)
    yield f"Use case `{symbol.name}`"
    if case is not None:
        if case.requirements:
            yield case.requirements
        if case.participants:
            yield "By " + _listed(f"`{name}`" for name in case.participants)
        if case.includes:
            yield "Includes " + _listed(f"`{name}`" for name in case.includes)
        if case.realises:
            yield "Realises " + _listed(f"`{name}`" for name in case.realises)


def _agent(program: Program, symbol: Symbol) -> Iterator[str]:
    for team in program.inspection.symbols.teams:
        for agent in team.agents:
            if agent.name == symbol.name:
                yield _fence(f"{agent.name} : {agent.role}")
                yield f"Agent of the team `{team.name}`"


def _functionality(program: Program, symbol: Symbol) -> Iterator[str]:
    yield f"Functionality `{symbol.name}`"
    for node in _nodes(program, symbol):
        if isinstance(node, tree.Functionality):
            for name in ("technology", "permissions", "environment", "algorithm"):
                text = getattr(node, name)
                if text is not None:
                    yield f"{name.capitalize()}: {text.text}"
    users = [
        f"`{item.node.name}`" for item in program.index.of(symbol) if isinstance(item.node, tree.Activity)
    ]
    if users:
        yield "Used by " + _listed(users)


def _timer(program: Program, symbol: Symbol) -> Iterator[str]:
    yield f"Timer `{symbol.name}` of `{symbol.owner}`"
    written = [item.node for item in program.index.of(symbol) if item.use is Use.WRITE]
    starts = [node for node in written if isinstance(node, tree.Call)]
    times = [_text(program, node.arguments[1].span) for node in starts if len(node.arguments) > 1]
    if times:
        yield "Started for " + _listed(f"`{time}`" for time in times)


def _state(program: Program, symbol: Symbol) -> Iterator[str]:
    name, _, participant = symbol.owner.partition(".")
    chart = program.inspection.eacs.get(name) if participant else program.inspection.iacs.get(name)
    node = chart.by_label.get(symbol.name) if chart is not None else None
    if node is not None:
        yield f"State `{node.label}`: {node.type} `{node.name}`"
        yield f"From the {node.origin}"


_Describe = Callable[[Program, Symbol], Iterator[str]]


def _simple(what: str) -> _Describe:
    return lambda program, symbol: iter((f"{what} `{symbol.name}`",))


_DESCRIBE: dict[Kind, _Describe] = {
    Kind.MESSAGE: _message,
    Kind.FIELD: _field,
    Kind.ENUM: _enum,
    Kind.CONSTANT: _constant,
    Kind.TOPIC: _topic,
    Kind.FUNCTION: _function,
    Kind.LET: _let,
    Kind.VARIABLE: _variable,
    Kind.PARAMETER: _parameter,
    Kind.FORMULA: _formula,
    Kind.ACTIVITY: _activity,
    Kind.OUTCOME: lambda program, symbol: iter((f"`{symbol.name}`: an outcome of `{symbol.owner}`",)),
    Kind.PARTICIPANT: _participant,
    Kind.ALIAS: _alias,
    Kind.PROTOCOL: _protocol,
    Kind.ROLE: _role,
    Kind.USE_CASE: _use_case,
    Kind.AGENT: _agent,
    Kind.FUNCTIONALITY: _functionality,
    Kind.TIMER: _timer,
    Kind.STATE: _state,
    Kind.SYSTEM: _simple("System"),
    Kind.TEAM: _simple("Team"),
    Kind.LIBRARY: _simple("Standard library"),
    Kind.EVENT: _simple("Event, raised by an activity:"),
    Kind.CAPABILITY: _simple("Capability"),
    Kind.PERFORMATIVE: _simple("FIPA communicative act"),
    Kind.COMM: _comm,
    Kind.TYPE: lambda program, symbol: iter((f"`{symbol.name}`: {_TYPES[symbol.name]}",)),
}


# ---- states ---------------------------------------------------------------------------------------


def _labels(program: Program, found: Occurrence) -> list[tuple[str, str]]:
    """The states that come from a name in a formula, or from the term of that name in a control line."""
    node = found.node
    if isinstance(node, tree.NamedFormula):
        leaves = {leaf.span for leaf in names(node.formula) if name_of(leaf) == found.span}
        spans = leaves if found.use is Use.READ else {node.formula.span}
    elif isinstance(node, tree.Term):
        around = program.control_at(found.span)
        formula = program.controlled(*around) if around is not None else None
        if formula is None:
            return []
        spans = {leaf.span for leaf in names(formula.formula) if leaf.name == found.symbol.name}
    else:
        return []
    return [(chart, state.label) for chart, state in states_at(program, spans)]


def states_at(program: Program, spans: Collection[Span]) -> Iterator[tuple[str, State]]:
    """The states that stand for what a formula has at any of these places, with the names of their charts."""
    known = program.inspection
    for charts in (known.iacs, known.eacs):
        for chart in charts.values():
            for state in chart.states if chart is not None else ():
                if state.type in _NAMED and state.span in spans:
                    yield chart.name if chart is not None else "", state


_NAMED = (StateType.OR, StateType.AND, StateType.BASIC)
