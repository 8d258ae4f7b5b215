"""Paths: what a dotted name means: a variable, a let, an enum constant, a message or a member of one.

A name is looked for in this order: variables, lets, enums, topics. In `host.topic.state.Message.member` the
first segment is a host if and only if the second is not a communication class.
"""

from __future__ import annotations

import re
from dataclasses import replace

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Index, Member, Named, ParameterValue, Value, VariableValue
from aseme_dsl.amola.messages import Channel, Comm, EnumType, Kind, Message, Topic, Type, list_of
from aseme_dsl.compiler.names.checker import Checker, a
from aseme_dsl.compiler.names.scope import Taken, TypedLet
from aseme_dsl.compiler.read.builtins import COMM_TYPES, PERFORMATIVES
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import listed, unknown
from aseme_dsl.diagnostics import Related, closest, surely
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

NOTHING = ("NULL", "null", "None", "nil", "undefined")
"""How other languages write that something is not there."""

INDEX = "index"
"""The word for the number of the instance or agent, where nothing else is called so."""


def value_of_path(checker: Checker, path: tree.Path) -> Value | None:
    """What a dotted name stands for; None, reported, when it is nothing."""
    scope = checker.scope
    first = path.segments[0]
    if scope.taken is not None and scope.taken.name == first.text:
        return _of_taken(checker, path, scope.taken)
    if first.text in scope.parameters:
        return _parameter(checker, path)
    if first.text in scope.variables:
        return _variable(checker, path)
    if first.text in scope.lets:
        return _let(checker, path, scope.lets[first.text])
    enum = scope.symbols.enum(first.text)
    if enum is not None:
        return _constant(checker, path, enum)
    if len(path.segments) == 1:
        if first.text == INDEX:
            return Index(path.span)
        _unknown_word(checker, first)
        return None
    if scope.symbols.topic(first.text) is None:
        if first.text in PERFORMATIVES:
            return _by_performative(checker, path)
        if scope.taken is not None and _is_meant_for(checker, first, scope.taken):
            return None
    return member_of(checker, path)


def _parameter(checker: Checker, path: tree.Path) -> Value | None:
    name = path.segments[0].text
    kind = checker.scope.parameters[name]
    if kind is None:
        return None
    if len(path.segments) == 1:
        return ParameterValue(name, kind, path.span)
    checker.report("E501", f"the parameter `{name}` is used as a whole", path.segments[1].span)
    return None


def _is_meant_for(checker: Checker, first: tree.Name, taken: Taken) -> bool:
    """Whether a participant or a type is written where what the transition takes is meant; told if so."""
    if first.text not in checker.scope.parties and (first.text != taken.message or not taken.message):
        return False
    what = "a participant" if first.text in checker.scope.parties else "a type"
    called = taken.name or f"{taken.performative}.{taken.message}"
    checker.report("E502", f"`{first}` is {what}", first.span, f"the message that is taken is `{called}`")
    return True


def _of_taken(checker: Checker, path: tree.Path, taken: Taken) -> Value | None:
    """What the transition takes, or a member of it."""
    if not taken.lost:
        return _bound(checker, path, taken.name, taken.message, path.segments[1:])
    if len(path.segments) > 1:
        problem = f"`{taken.name}` is an agent: it has no members"
        checker.report("E501", problem, path.segments[1].span)
        return None
    return amola.Sender(taken.name, path.span, lost=True)


def _bound(
    checker: Checker, path: tree.Path, name: str, message: str, members: tuple[tree.Name, ...]
) -> Value | None:
    if checker.scope.symbols.message(message) is None:
        return None  # said where it is waited for
    found = member_path(checker, Type(Kind.MESSAGE, message), (), members)
    return None if found is None else amola.Bound(name, message, *found, path.span)


def _by_performative(checker: Checker, path: tree.Path) -> Value | None:
    """`propose.Bid.cost`: the one agent message that the transition takes (E533)."""
    taken = checker.scope.taken
    first, message = path.segments[:2]
    said = f"{first} {message}"
    if (
        taken is not None
        and not taken.lost
        and (taken.performative, taken.message)
        == (
            first.text,
            message.text,
        )
    ):
        if not taken.name:
            return _bound(checker, path, f"{first}.{message}", message.text, path.segments[2:])
        members = "".join(f".{item}" for item in path.segments[2:])
        hint = f"write `{taken.name}{members}`"
        checker.report("E533", f"the message is called `{taken.name}` here", path.span, hint)
        return None
    if taken is not None and any(
        taken.span.start <= item.span.start < taken.span.end for item in checker.diagnostics if item.span
    ):
        return None  # what is wrong with the event is said there
    hint = f"only the line that takes it knows it, `{said} from …`: keep what is needed in a variable there"
    if taken is None and not checker.scope.parties:
        hint = "agent messages are known in the `control` of a participant of an `aip`"
    checker.report("E533", f"no `{said}` is taken here", path.span, hint)
    return None


def _variable(checker: Checker, path: tree.Path) -> Value | None:
    name = path.segments[0].text
    key, kind = checker.scope.variables[name]
    if len(path.segments) == 1:
        return VariableValue(key, kind, path.span)
    hint = None
    if checker.scope.symbols.topic(name) is not None:
        hint = f"the variable hides the topic `{name}`: call it something else"
    checker.report(
        "E501", f"the variable `{name}` is {a(kind)}: it has no members", path.segments[1].span, hint
    )
    return None


def _let(checker: Checker, path: tree.Path, let: TypedLet) -> Value | None:
    if let.value is None:
        return None
    if len(path.segments) == 1:
        return Named(let.name, let.value, let.value.type, path.span)
    message = unnamed(let.value)
    if isinstance(message, Member) and message.type.kind is Kind.MESSAGE:
        return _members(checker, message, path.segments[1:], path.span)
    if isinstance(message, amola.Element) and message.type.kind is Kind.MESSAGE:
        found = member_path(checker, message.type, message.path, path.segments[1:])
        return None if found is None else replace(message, path=found[0], type=found[1], span=path.span)
    checker.report(
        "E501",
        f"the let `{let.name}` is {a(let.value.type)}: it has no members",
        path.segments[1].span,
        related=(Related(let.span, "declared here"),),
    )
    return None


def unnamed(value: Value) -> Value:
    """What the names of lets stand for."""
    while isinstance(value, Named):
        value = value.expression
    return value


def _constant(checker: Checker, path: tree.Path, enum: EnumType) -> Value | None:
    names = [name for name, _ in enum.constants]
    if len(path.segments) == 1:
        hint = f"write `{enum.name}.{names[0]}`, say" if names else None
        checker.report("E508", f"`{enum.name}` is an enum, not one of its constants", path.span, hint)
        return None
    constant = path.segments[1]
    number = enum.number(constant.text)
    if number is None:
        symbols = checker.scope.symbols
        if enum.name not in symbols.wrong:
            owners = [
                f"{item.name}.{constant}" for item in symbols.enums if item.number(constant.text) is not None
            ]
            certain = f"it is one of another enum: {listed(owners, 'or')}" if owners else None
            checker.diagnostics.append(
                unknown("E508", f"`{enum.name}` has no constant", constant, names, certain=certain)
            )
        return None
    if len(path.segments) > 2:
        checker.report("E501", "a constant has no members", path.segments[2].span)
        return None
    return amola.EnumConstant(constant.text, number, Type(Kind.ENUM, enum.name), path.span)


def _unknown_word(checker: Checker, name: tree.Name) -> None:
    """A single word that is neither a variable nor a let: say what it may be meant to be."""
    scope, symbols = checker.scope, checker.scope.symbols
    if symbols.is_excused(name.text):
        return
    hint = fix = None
    owners = [enum.name for enum in symbols.enums if enum.number(name.text) is not None]
    if owners:
        fix = f"{owners[0]}.{name}" if len(owners) == 1 else None
        hint = "a constant is written with its enum: " + listed((f"{item}.{name}" for item in owners), "or")
    elif any(name.text in party.variables for party in scope.parties.values()):
        theirs = [party.name for party in scope.parties.values() if name.text in party.variables]
        hint = f"it is a variable of {listed(theirs)}: each participant sees its own"
    elif name.text in scope.parties:
        hint = "it is a participant; one agent of it is the `sender(…)` of a message that it has sent"
    elif name.text in NOTHING:
        hint = "write `!has(topic.state.Message)` to ask whether a message is not there"
    elif symbols.topic(name.text) is not None:
        hint = f"it is a topic: `{name}.state.Message.member` reads from it"
    elif symbols.message(name.text) is not None:
        hint = _where(symbols.channels_of(name.text))
    elif symbols.overloads(name.text):
        hint = f"it is a function: `{name}(…)` calls it"
    if hint is not None:
        checker.report("E200", f"there is no variable or let `{name}`", name.span, hint, fix=fix)
        return
    pool = (*scope.parameters, *scope.variables, *scope.lets, *(enum.name for enum in symbols.enums), INDEX)
    checker.diagnostics.append(
        unknown(
            "E200",
            "there is no variable or let",
            name,
            pool,
            "declare it",
            certain=providers(name.text, "let", "enum"),
        )
    )


def _where(channels: tuple[Channel, ...]) -> str:
    if not channels:
        return "no topic carries this message"
    return "the message is on " + listed((str(channel) for channel in channels), "and")


# ---- messages on topics ------------------------------------------------------------------------


def member_of(checker: Checker, path: tree.Path) -> Member | None:
    """`host.topic.comm.Message.member…`; the message itself where no member follows."""
    found = channel_of(checker, path)
    if found is None:
        return None
    host, channel, used = found
    message = Member(host, channel, (), Type(Kind.MESSAGE, channel.message), path.span)
    return _members(checker, message, path.segments[used:], path.span)


def channel_of(checker: Checker, path: tree.Path) -> tuple[str | None, Channel, int] | None:
    """The host and channel that a path begins with, and how many segments say so."""
    segments = path.segments
    if len(segments) > 1 and segments[1].text in COMM_TYPES:
        host, used = None, 0
    elif len(segments) > 2 and segments[2].text in COMM_TYPES:
        host, used = segments[0], 1
        if not _is_host(checker, host):
            return None
    else:
        _no_class(checker, path)
        return None
    topic = _topic(checker, segments[used], segments[used + 2] if len(segments) > used + 2 else None)
    if topic is None:
        return None
    comm = segments[used + 1]
    if len(segments) == used + 2:
        carried = [str(item.channel) for item in topic.channels if item.channel.comm == comm.text]
        _no_message(checker, path, topic, carried)
        return None
    message = segments[used + 2]
    channel = Channel(topic.name, Comm(comm.text), message.text)
    if checker.scope.symbols.channel(channel) is None:
        _no_channel(checker, topic, comm, message)
        return None
    return (None if host is None else host.text), channel, used + 3


def _is_host(checker: Checker, host: tree.Name) -> bool:
    agents = checker.scope.symbols.agents
    if not agents or host.text in agents:
        return True
    if not checker.scope.symbols.is_excused(host.text):
        hint = "a variable is `host.topic.class.Message.member`, and hosts are the agents of the team"
        if host.text in checker.scope.parties:
            hint = "it is a participant; hosts are the agents of the team"
        checker.diagnostics.append(unknown("E513", "there is no agent", host, agents, hint))
    return False


def _topic(checker: Checker, name: tree.Name, message: tree.Name | None = None) -> Topic | None:
    symbols = checker.scope.symbols
    topic = symbols.topic(name.text)
    if topic is None and not symbols.is_excused(name.text):
        pool = [item.name for item in symbols.topics]
        certain = providers(name.text, "topic", carrying=message.text if message is not None else None)
        checker.diagnostics.append(
            unknown("E502", "there is no topic", name, pool, "declare it", certain=certain)
        )
    return topic


def _no_class(checker: Checker, path: tree.Path) -> None:
    """A path without a communication class where one belongs: say which segment is to blame."""
    symbols, segments = checker.scope.symbols, path.segments
    first = segments[0]
    if len(segments) == 1:
        topic = _topic(checker, first)
        if topic is not None:
            _no_message(checker, path, topic, [str(item.channel) for item in topic.channels])
        return
    if symbols.topic(first.text) is not None:
        _wrong_class(checker, first, segments[1])
        return
    on_host = len(segments) > 1 and symbols.topic(segments[1].text) is not None
    if on_host and (first.text in symbols.agents or not symbols.agents):
        topic = symbols.topic(segments[1].text)
        if len(segments) == 2 and topic is not None:
            _no_message(checker, path, topic, [f"{first}.{item.channel}" for item in topic.channels])
        else:
            _wrong_class(checker, segments[1], segments[2])
        return
    if symbols.is_excused(first.text) or symbols.is_excused(segments[1].text):
        return
    if symbols.message(first.text) is not None:
        owners = [
            f"{enum.name}.{segments[1]}"
            for enum in symbols.enums
            if enum.number(segments[1].text) is not None
        ]
        if len(segments) == 2 and owners:
            hint = f"did you mean {listed(owners, 'or')}?"
            checker.report("E502", f"`{first}` is a message, not an enum", first.span, hint)
            return
        channels = symbols.channels_of(first.text)
        fix = f"{channels[0]}" if len(channels) == 1 else None
        checker.report(
            "E502",
            f"`{first}` is a message: a topic and a class come before it",
            first.span,
            _where(channels),
            (),
            fix,
        )
        return
    pool = [*checker.scope.variables, *checker.scope.lets]
    pool += [enum.name for enum in symbols.enums] + [topic.name for topic in symbols.topics]
    if on_host:
        checker.diagnostics.append(unknown("E513", "there is no agent", first, symbols.agents))
        return
    checker.diagnostics.append(
        unknown(
            "E502",
            "there is no topic, variable, let or enum",
            first,
            pool,
            "a message is read as `topic.state.Message.member`",
            certain=_taken_elsewhere(checker, first) or providers(first.text, "topic", "let", "enum"),
        )
    )


def _taken_elsewhere(checker: Checker, name: tree.Name) -> str | None:
    """What to do about `q.n` where another line has `propose Bid q from contractor`."""
    text = name.span.source.text
    if not checker.scope.parties or not re.search(rf"\w\s+\w+\s+{name}\s+from\s+\w", text):
        return None
    return f"`{name}` is known only in the line that takes the message: keep what is needed in a variable"


def _no_message(checker: Checker, path: tree.Path, topic: Topic, carried: list[str]) -> None:
    """A path that ends before its message."""
    hint = f"`{topic.name}` carries nothing of the kind"
    if carried:
        hint = ("there is " if len(carried) == 1 else "there are ") + listed(carried)
    checker.report("E502", f"`{path.text}` names no message", path.span, hint)


def _wrong_class(checker: Checker, topic: tree.Name, comm: tree.Name) -> None:
    """`vision.stat.Ball`, or `vision.Ball` without a class at all."""
    found = checker.scope.symbols.topic(topic.text)
    assert found is not None
    if checker.scope.symbols.is_excused(comm.text):
        return
    channels = [item.channel for item in found.channels]
    fits = [channel for channel in channels if channel.message == comm.text]
    if fits:
        hint = "write " + listed((str(channel) for channel in fits), "or")
        fix = f"{fits[0].comm}.{comm}" if len(fits) == 1 else None
        checker.report("E503", "the communication class is missing", comm.span, hint, fix=fix)
        return
    paths = [
        f"{channel}.{comm}"
        for channel in channels
        if (message := checker.scope.symbols.message(channel.message)) is not None
        and any(member.name == comm.text for member in message.fields)
    ]
    if len(paths) == 1:
        problem = "the communication class and the message are missing"
        fix = paths[0].partition(".")[2]
        checker.report("E503", problem, comm.span, f"write `{paths[0]}`", fix=fix)
        return
    near = closest(comm.text, COMM_TYPES)
    hint = f"did you mean `{near}`?" if near else "there are `signal`, `state` and `data`"
    checker.report(
        "E503",
        f"there is no communication class `{comm}`",
        comm.span,
        hint,
        fix=surely(comm.text, COMM_TYPES),
    )


def _no_channel(checker: Checker, topic: Topic, comm: tree.Name, message: tree.Name) -> None:
    """The topic does not carry this message in this class."""
    symbols = checker.scope.symbols
    others = [item for item in topic.channels if item.channel.message == message.text]
    if others:
        classes = listed((item.channel.comm for item in others), "and")
        checker.report(
            "E503",
            f"`{message}` is on `{topic.name}` as {classes}, not as `{comm}`",
            comm.span,
            f"write {listed((str(item.channel) for item in others), 'or')}",
            tuple(Related(item.span, "declared here") for item in others),
            str(others[0].channel.comm) if len(others) == 1 else None,
        )
        return
    if symbols.is_excused(message.text):
        return
    if symbols.message(message.text) is not None:
        channels = symbols.channels_of(message.text)
        related = (Related(topic.span, "the topic"),)
        problem = f"the topic `{topic.name}` does not carry `{message}`"
        checker.report("E502", problem, message.span, _where(channels), related)
        return
    pool = [item.channel.message for item in topic.channels if item.channel.comm == comm.text]
    pool = pool or [item.channel.message for item in topic.channels]
    checker.diagnostics.append(
        unknown(
            "E502",
            f"the topic `{topic.name}` carries no message",
            message,
            pool,
            certain=providers(message.text, "message"),
        )
    )


def _members(checker: Checker, start: Member, names: tuple[tree.Name, ...], span: Span) -> Member | None:
    """From a message (or a member that is one) along the names of members."""
    found = member_path(checker, start.type, start.path, names)
    return None if found is None else Member(start.host, start.channel, *found, span)


def member_path(
    checker: Checker, kind: Type, start: tuple[str, ...], names: tuple[tree.Name, ...]
) -> tuple[tuple[str, ...], Type] | None:
    """The path along the names of members from a message (at `start` in another), and the type at its end."""
    symbols = checker.scope.symbols
    path = list(start)
    for name in names:
        owner = symbols.message(kind.name) if kind.kind is Kind.MESSAGE else None
        if kind.kind is Kind.LIST:
            one = f"{path[-1]}[0].{name}" if path else f"[0].{name}"
            hint = f"take one of its elements: `{one}` for the first"
            checker.report("E501", f"`{'.'.join(path)}` is a list: it has no members", name.span, hint)
            return None
        if owner is None:
            if kind.name not in symbols.wrong:
                where = ".".join(path)
                checker.report("E501", f"`{where}` is {a(kind)}: it has no members", name.span)
            return None
        field = owner.field(name.text)
        if field is None:
            _no_member(checker, owner, name)
            return None
        kind = list_of(field.type) if field.label == "repeated" else field.type
        path.append(name.text)
    return tuple(path), kind


def _no_member(checker: Checker, owner: Message, name: tree.Name) -> None:
    symbols = checker.scope.symbols
    if owner.name in symbols.wrong:
        return
    checker.diagnostics.append(
        unknown("E501", f"`{owner.name}` has no member", name, [field.name for field in owner.fields])
    )


def through_optional(checker: Checker, message: str, path: tuple[str, ...]) -> str | None:
    """The first optional message on the way to a member, which a draft does not have."""
    symbols = checker.scope.symbols
    owner = symbols.message(message)
    for name in path[:-1]:
        field = owner.field(name) if owner is not None else None
        if field is None:
            return None
        if field.label == "optional":
            return name
        owner = symbols.message(field.type.name)
    return None


def is_optional(checker: Checker, message: str, path: tuple[str, ...]) -> bool:
    """Whether the member at the end of a path is declared optional."""
    symbols = checker.scope.symbols
    owner, label = symbols.message(message), ""
    for name in path:
        field = owner.field(name) if owner is not None else None
        if field is None:
            return False
        owner, label = symbols.message(field.type.name), field.label
    return label == "optional"
