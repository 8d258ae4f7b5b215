"""Paths: what a dotted name means: a variable, a let, an enum constant, a message or a member of one.

A name is looked for in this order: variables, lets, enums, topics. In `sender.topic.state.Message.field` the
first segment is a sender if and only if the second is not a channel kind.
"""

from __future__ import annotations

import re
from dataclasses import replace

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Index, Member, Named, ParameterValue, Value, VariableValue
from aseme_dsl.amola.messages import Channel, ChannelKind, EnumType, Kind, Message, Topic, Type, list_of
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.scope import Scope, Taken, TypedLet
from aseme_dsl.compiler.read.builtins import COMM_TYPES, PERFORMATIVES
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import NoCommunicationClass
from aseme_dsl.diagnostics.problems.expressions import paths as problems
from aseme_dsl.diagnostics.problems.expressions.absences import (
    Meant,
    MemberlessKind,
    NoAgent,
    NoBeginning,
    NoConstant,
    NoHost,
    NoMember,
    NoMembers,
    NoMessageOfTopic,
    NotAValue,
    NotCarried,
    NoTopicOfPath,
    NoVariableOrLet,
)
from aseme_dsl.diagnostics.problems.talk import MessageHasAName, NotTaken
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

NOTHING = ("NULL", "null", "None", "none", "nil", "nothing", "undefined")
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
    if name in checker.scope.inputs and kind.kind is Kind.MESSAGE:
        found = member_path(checker, kind, (), path.segments[1:])
        return None if found is None else ParameterValue(name, found[1], path.span, found[0])
    checker.report(problems.WholeParameter(name), path.segments[1].span)
    return None


def _is_meant_for(checker: Checker, first: tree.Name, taken: Taken) -> bool:
    """Whether a participant or a type is written where what the transition takes is meant; told if so."""
    if first.text not in checker.scope.parties and (first.text != taken.message or not taken.message):
        return False
    called = taken.name or f"{taken.performative}.{taken.message}"
    is_participant = first.text in checker.scope.parties
    checker.report(problems.NotTheMessage(first.text, is_participant, called), first.span)
    return True


def _of_taken(checker: Checker, path: tree.Path, taken: Taken) -> Value | None:
    """What the transition takes, or a member of it."""
    if not taken.lost:
        return _bound(checker, path, taken.name, taken.message, path.segments[1:])
    if len(path.segments) > 1:
        _no_members(checker, path.segments[1], "", taken.name, "agent")
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
        members = tuple(item.text for item in path.segments[2:])
        checker.report(MessageHasAName(taken.name, members), path.span)
        return None
    if taken is not None and any(
        taken.span.start <= item.span.start < taken.span.end for item in checker.diagnostics if item.span
    ):
        return None  # what is wrong with the event is said there
    in_protocol = taken is not None or bool(checker.scope.parties)
    checker.report(NotTaken(first.text, message.text, in_protocol), path.span)
    return None


def _variable(checker: Checker, path: tree.Path) -> Value | None:
    name = path.segments[0].text
    key, kind = checker.scope.variables[name]
    if len(path.segments) == 1:
        return VariableValue(key, kind, path.span, checker.scope.bounds.get(name))
    if kind.kind is Kind.MESSAGE:
        found = member_path(checker, kind, (), path.segments[1:])
        if found is None:
            return None
        return VariableValue(key, found[1], path.span, path=found[0], message=kind.name)
    hides = checker.scope.symbols.topic(name) is not None
    _no_members(checker, path.segments[1], "variable", name, str(kind), hides)
    return None


def _let(checker: Checker, path: tree.Path, let: TypedLet) -> Value | None:
    if let.value is None:
        return None
    if len(path.segments) == 1:
        return Named(let.name, let.value, let.value.type, path.span)
    message = unnamed(let.value)
    if isinstance(message, Member) and message.type.kind is Kind.MESSAGE:
        return _members(checker, message, path.segments[1:], path.span)
    if isinstance(message, amola.Element | VariableValue) and message.type.kind is Kind.MESSAGE:
        found = member_path(checker, message.type, message.path, path.segments[1:])
        if found is None:
            return None
        if isinstance(message, VariableValue):
            message = replace(message, message=message.message or message.type.name)
        return replace(message, path=found[0], type=found[1], span=path.span)
    member = path.segments[1]
    problem = NoMembers(member.text, None, (), "let", let.name, str(let.value.type))
    checker.report(problem, member.span, (Related(let.span, "declared here"),))
    return None


def unnamed(value: Value) -> Value:
    """What the names of lets stand for."""
    while isinstance(value, Named):
        value = value.expression
    return value


def _constant(checker: Checker, path: tree.Path, enum: EnumType) -> Value | None:
    names = [name for name, _ in enum.constants]
    if len(path.segments) == 1:
        checker.report(problems.EnumAsValue(enum.name, names[0] if names else None), path.span)
        return None
    constant = path.segments[1]
    number = enum.number(constant.text)
    if number is None:
        symbols = checker.scope.symbols
        if enum.name not in symbols.wrong:
            namesakes = tuple(
                f"{item.name}.{constant}" for item in symbols.enums if item.number(constant.text) is not None
            )
            checker.diagnostics.append(unknown(NoConstant, constant, names, enum.name, namesakes))
        return None
    if len(path.segments) > 2:
        _no_members(checker, path.segments[2], "constant", f"{enum.name}.{constant}")
        return None
    return amola.EnumConstant(constant.text, number, Type(Kind.ENUM, enum.name), path.span)


def _unknown_word(checker: Checker, name: tree.Name) -> None:
    """A single word that is neither a variable nor a let: say what it may be meant to be."""
    scope, symbols = checker.scope, checker.scope.symbols
    if symbols.is_excused(name.text):
        return
    pool = (*scope.parameters, *scope.variables, *scope.lets, *(enum.name for enum in symbols.enums), INDEX)
    meant, places = _meant(scope, name)
    if meant is None:
        checker.diagnostics.append(
            unknown(NoVariableOrLet, name, pool, libraries=providers(name.text, "let", "enum"))
        )
        return
    problem = NotAValue(name.text, None, pool, meant=meant, places=places)
    fix = places[0] if meant == "constant" and len(places) == 1 else None
    checker.report(problem, name.span, fix=fix)


def _meant(scope: Scope, name: tree.Name) -> tuple[Meant | None, tuple[str, ...]]:
    """What else is called so, and where it is."""
    symbols = scope.symbols
    constants = [f"{item.name}.{name}" for item in symbols.enums if item.number(name.text) is not None]
    if constants:
        return "constant", tuple(constants)
    owners = [party.name for party in scope.parties.values() if name.text in party.variables]
    if owners:
        return "variable", tuple(owners)
    if name.text in scope.parties:
        return "participant", ()
    if name.text in NOTHING:
        return "nothing", ()
    if symbols.topic(name.text) is not None:
        return "topic", ()
    if symbols.message(name.text) is not None:
        return "message", tuple(map(str, symbols.channels_of(name.text)))
    return ("function" if symbols.overloads(name.text) else None), ()


# ---- messages on topics ------------------------------------------------------------------------


def member_of(checker: Checker, path: tree.Path) -> Member | None:
    """`sender.topic.kind.Message.field…`; the message itself where no member follows."""
    found = channel_of(checker, path)
    if found is None:
        return None
    host, channel, used = found
    message = Member(host, channel, (), Type(Kind.MESSAGE, channel.message), path.span)
    return _members(checker, message, path.segments[used:], path.span)


def channel_of(checker: Checker, path: tree.Path) -> tuple[str | None, Channel, int] | None:
    """The sender and channel that a path begins with, and how many segments say so."""
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
    channel = Channel(topic.name, ChannelKind(comm.text), message.text)
    if checker.scope.symbols.channel(channel) is None:
        _no_channel(checker, topic, comm, message)
        return None
    return (None if host is None else host.text), channel, used + 3


def _is_host(checker: Checker, host: tree.Name) -> bool:
    symbols = checker.scope.symbols
    hosts = symbols.hosts
    if hosts is None or host.text in hosts:
        return True
    if not symbols.is_excused(host.text):
        is_participant = host.text in checker.scope.parties
        checker.diagnostics.append(unknown(NoHost, host, hosts, is_participant, bool(symbols.teams)))
    return False


def _topic(checker: Checker, name: tree.Name, message: tree.Name | None = None) -> Topic | None:
    symbols = checker.scope.symbols
    topic = symbols.topic(name.text)
    if topic is None and not symbols.is_excused(name.text):
        pool = [item.name for item in symbols.topics]
        libraries = providers(name.text, "topic", carrying=message.text if message is not None else None)
        checker.diagnostics.append(unknown(NoTopicOfPath, name, pool, libraries=libraries))
    return topic


def _no_class(checker: Checker, path: tree.Path) -> None:
    """A path without a channel kind where one belongs: say which segment is to blame."""
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
    if on_host and (symbols.hosts is None or first.text in symbols.hosts):
        topic = symbols.topic(segments[1].text)
        if len(segments) == 2 and topic is not None:
            _no_message(checker, path, topic, [f"{first}.{item.channel}" for item in topic.channels])
        else:
            _wrong_class(checker, segments[1], segments[2])
        return
    if symbols.is_excused(first.text) or symbols.is_excused(segments[1].text):
        return
    if symbols.message(first.text) is not None:
        constants = tuple(
            f"{enum.name}.{segments[1]}"
            for enum in symbols.enums
            if enum.number(segments[1].text) is not None
        )
        if len(segments) == 2 and constants:
            checker.report(problems.MessageAsEnum(first.text, constants), first.span)
            return
        channels = tuple(map(str, symbols.channels_of(first.text)))
        fix = channels[0] if len(channels) == 1 else None
        checker.report(problems.MessageWithoutTopic(first.text, channels), first.span, fix=fix)
        return
    pool = [*checker.scope.variables, *checker.scope.lets]
    pool += [enum.name for enum in symbols.enums] + [topic.name for topic in symbols.topics]
    if on_host:
        checker.diagnostics.append(unknown(NoAgent, first, symbols.hosts or ()))
        return
    libraries = providers(first.text, "topic", "let", "enum")
    checker.diagnostics.append(
        unknown(NoBeginning, first, pool, _is_bound(checker, first), libraries=libraries)
    )


def _is_bound(checker: Checker, name: tree.Name) -> bool:
    """Whether `q` of `q.n` is known to another line, such as `propose Bid q from contractor`."""
    text = name.span.source.text
    return bool(checker.scope.parties) and re.search(rf"\w\s+\w+\s+{name}\s+from\s+\w", text) is not None


def _no_message(checker: Checker, path: tree.Path, topic: Topic, carried: list[str]) -> None:
    """A path that ends before its message."""
    checker.report(problems.PathWithoutMessage(path.text, topic.name, tuple(carried)), path.span)


def _wrong_class(checker: Checker, topic: tree.Name, comm: tree.Name) -> None:
    """`vision.stat.Ball`, or `vision.Ball` without a class at all."""
    found = checker.scope.symbols.topic(topic.text)
    assert found is not None
    if checker.scope.symbols.is_excused(comm.text):
        return
    channels = [item.channel for item in found.channels]
    fits = [channel for channel in channels if channel.message == comm.text]
    if fits:
        fix = f"{fits[0].comm}.{comm}" if len(fits) == 1 else None
        checker.report(problems.ClassMissing(tuple(map(str, fits))), comm.span, fix=fix)
        return
    paths = [
        f"{channel}.{comm}"
        for channel in channels
        if (message := checker.scope.symbols.message(channel.message)) is not None
        and any(member.name == comm.text for member in message.fields)
    ]
    if len(paths) == 1:
        fix = paths[0].partition(".")[2]
        checker.report(problems.ClassAndMessageMissing(paths[0]), comm.span, fix=fix)
        return
    near = closest(comm.text, COMM_TYPES)
    no_class = NoCommunicationClass(comm.text, near, ("signal", "state", "data"))
    checker.report(no_class, comm.span, fix=surely(comm.text, COMM_TYPES))


def _no_channel(checker: Checker, topic: Topic, comm: tree.Name, message: tree.Name) -> None:
    """The topic does not carry this message in this class."""
    symbols = checker.scope.symbols
    others = [item for item in topic.channels if item.channel.message == message.text]
    if others:
        classes = tuple(str(item.channel.comm) for item in others)
        channels = tuple(str(item.channel) for item in others)
        related = tuple(Related(item.span, "declared here") for item in others)
        other_class = problems.OtherClass(message.text, topic.name, comm.text, classes, channels)
        checker.report(other_class, comm.span, related, classes[0] if len(classes) == 1 else None)
        return
    if symbols.is_excused(message.text):
        return
    if symbols.message(message.text) is not None:
        channels = tuple(map(str, symbols.channels_of(message.text)))
        problem = NotCarried(message.text, None, channels, topic.name)
        checker.report(problem, message.span, (Related(topic.span, "the topic"),))
        return
    pool = [item.channel.message for item in topic.channels if item.channel.comm == comm.text]
    pool = pool or [item.channel.message for item in topic.channels]
    libraries = providers(message.text, "message")
    checker.diagnostics.append(unknown(NoMessageOfTopic, message, pool, topic.name, libraries=libraries))


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
            _no_members(checker, name, "list", ".".join(path))
            return None
        if owner is None:
            if kind.name not in symbols.wrong:
                _no_members(checker, name, "", ".".join(path), str(kind))
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
    fields = [field.name for field in owner.fields]
    checker.diagnostics.append(unknown(NoMember, name, fields, owner.name))


def _no_members(
    checker: Checker, member: tree.Name, kind: MemberlessKind, owner: str, type: str = "", hides: bool = False
) -> None:
    checker.report(NoMembers(member.text, None, (), kind, owner, type, hides), member.span)


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
