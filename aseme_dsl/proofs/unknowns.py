"""Unknowns: what a snapshot gives values to, as far as conditions can tell."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import cast

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import BOOL, Bounds, ChannelKind, EnumType, Function, Kind, Message, Type
from aseme_dsl.records import dataclass

Key = tuple[object, ...]
"""Which unknown it is: two places that read the same in one snapshot have the same key."""

HAS, SET, VALUE, VARIABLE, EXPIRED, AGE = "has", "set", "value", "variable", "expired", "age"
OUTCOME, STATE, INDEX = "outcome", "state", "index"
TAKEN, SENDER, REASON = "taken", "sender", "reason"
LIST, ELEMENT, SIZE, CONTAINS, FIND = "list", "element", "size", "contains", "find"
NEW, SAME, CHANGED = "new", "same", "changed"
AT, MEAN, CALL, RAISES, THERE = "at", "mean", "call", "raises", "there"
PRESENCES = (HAS, SET, THERE)


@dataclass(frozen=True, slots=True)
class Unknown:
    """Something with a value of `type`; `text` is how it is written.

    Keys begin with a word. It names the element that has the value, or is one of:

    - `has`: a message is there;
    - `set`: an optional member is there, or an agent in its variable;
    - `there`: a history has a value;
    - `raises`: a function raises an exception;
    - `same`: two messages are equal.
    """

    key: Key
    text: str
    type: Type
    needs: tuple[Key, ...] = ()
    """The presences without which it has no value."""
    bounds: Bounds | None = None
    """Between which numbers it is, of a variable that says so."""


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The enums and messages of a system, by name."""

    enums: Mapping[str, EnumType] = field(default_factory=dict)
    messages: Mapping[str, Message] = field(default_factory=dict)
    outcomes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """How each activity may end."""


def signature(function: Function) -> str:
    """Which overload it is."""
    return f"{function.name}({', '.join(str(kind) for _, kind in function.parameters)})"


def is_unknown_function(value: e.Value) -> bool:
    """Whether it calls a function of which only the type is known."""
    return isinstance(value, e.Call) and value.function.is_of_document


def identity(value: e.Value) -> Key:
    """The value without its places and the names of lets: equal for equal expressions."""
    match value:
        case e.Named(expression=inner):
            return identity(inner)
        case e.Literal(value=constant, type=kind):
            return ("literal", str(kind), type(constant).__name__, constant)
        case e.EnumConstant(type=kind, number=number):
            return ("enum", kind.name, number)
        case e.VariableValue(name=name, path=path):
            return (VARIABLE, name, path) if path else (VARIABLE, name)
        case e.ParameterValue(name=name):
            raise AssertionError(f"{name} is replaced where its formula is expanded")
        case e.Expired(timer=timer):
            return (EXPIRED, timer)
        case e.Outcome(activity=activity):
            return (OUTCOME, activity)
        case e.Index():
            return (INDEX,)
        case e.Random():
            raise AssertionError("no condition is random")
        case e.StateValue(question=question, state=state):
            return (STATE, question, state)
        case e.RoundValue(question=question, participant=participant):
            return (STATE, question, participant)
        case e.Member(host=host, channel=channel, path=path):
            return (VALUE, host, channel, path)
        case e.Bound(message=message, path=path):
            return (TAKEN, None, message, path)
        case e.Sender(lost=lost):
            return (SENDER, lost)
        case e.LossReason():
            return (REASON,)
        case e.Has(message=message):
            return (HAS, identity(message))
        case e.Age(message=message):
            if isinstance(message, e.Bound):
                return (AGE, identity(message))
            return (AGE, message.host, message.channel)
        case e.At(message=message, offset=extent):
            return (AT, message.host, message.channel, message.path, nanoseconds(extent))
        case e.Mean(message=message, window=extent):
            return (MEAN, message.host, message.channel, message.path, nanoseconds(extent))
        case e.Call(function=function, arguments=arguments):
            return (CALL, signature(function), *(identity(argument) for argument in arguments))
        case e.ListValue(elements=elements):
            return (LIST, *(identity(element) for element in elements))
        case e.Element(list=whole, index=index, path=path):
            return (ELEMENT, identity(whole), identity(index), path)
        case e.Size(list=whole):
            return (SIZE, identity(whole))
        case e.Contains(list=whole, value=wanted, path=path):
            return (CONTAINS, identity(whole), identity(wanted), path)
        case e.Find(list=whole, value=wanted, path=path):
            return (FIND, identity(whole), identity(wanted), path)
        case e.NewMessage(message=message, fills=fills, rest=rest):
            filled = tuple((item.path, identity(item.value)) for item in fills)
            return (NEW, message, filled, None if rest is None else identity(rest))
        case e.Changed(change=change, list=whole):
            return (CHANGED, change.value, identity(whole), *(identity(part) for part in value.given))
        case e.Logic(operator=operator, operands=operands):
            return (operator, *(identity(operand) for operand in operands))
        case e.Compare(left=left, right=right) if is_of_messages(value):
            return (SAME, *sorted((identity(left), identity(right)), key=repr))
        case e.Compare(operator=operator, left=left, right=right):
            return (operator, identity(left), identity(right))
        case e.Arithmetic(operator=operator, left=left, right=right):
            return (operator, identity(left), identity(right))
        case e.Conditional(condition=condition, yes=yes, no=no):
            return ("?", identity(condition), identity(yes), identity(no))
        case e.Not(operand=operand):
            return ("!", identity(operand))
        case e.Holds(operand=operand):
            return ("holds", identity(operand))
        case e.Negate(operand=operand):
            return ("neg", identity(operand))


def nanoseconds(extent: e.Value) -> int:
    """The second argument of `at` or `mean`: the compiler has made it a constant."""
    assert isinstance(extent, e.Literal)
    return int(extent.value)


Read = e.Member | e.Bound | e.VariableValue
"""What may be there or not: as a whole, or in a part."""


def presences(read: Read, vocabulary: Vocabulary) -> tuple[Key, ...]:
    """What must be there for it to have a value: its message, and each optional member on the path."""
    found: list[Key] = []
    if isinstance(read, e.VariableValue):
        if not read.may_be_unset:
            return ()
        where: Key = (VARIABLE, read.name)
        owner = vocabulary.messages.get(read.message)
        found.append((SET, *where))
    elif isinstance(read, e.Bound):
        where = (None, read.message)
        owner = vocabulary.messages.get(read.message)
    else:
        where = (read.host, read.channel)
        owner = vocabulary.messages.get(read.channel.message)
        found.append((HAS, *where))
    for place, name in enumerate(read.path, 1):
        item = owner.field(name) if owner is not None else None
        if item is None:
            break
        if item.label == "optional":
            found.append((SET, *where, read.path[:place]))
        owner = vocabulary.messages.get(item.type.name)
    return tuple(found)


def unknowns_of(value: e.Value, vocabulary: Vocabulary) -> Iterator[Unknown]:
    """Every unknown of a value in the order in which it is read, presences before what needs them."""
    for part in e.walk(value):
        match part:
            case e.Member() | e.Bound():
                yield from _presence_unknowns(part, vocabulary)
                if part.type.kind not in WHOLE:
                    yield Unknown(identity(part), e.value_text(part), part.type, presences(part, vocabulary))
            case e.Has(message=message):
                yield from _presence_unknowns(message, vocabulary)
            case e.Age(message=message):
                yield from _presence_unknowns(message, vocabulary)
                needs = presences(message, vocabulary)[:1]
                yield Unknown(identity(part), e.value_text(part), part.type, needs)
            case e.At() | e.Mean():
                yield from _presence_unknowns(part.message, vocabulary)
                there = (THERE, *identity(part))
                yield Unknown(there, e.value_text(part), BOOL)
                if part.type.kind not in WHOLE:
                    yield Unknown(identity(part), e.value_text(part), part.type, (there,))
            case e.Compare() if is_of_messages(part):
                read = list(_needs(part, vocabulary))
                yield from read
                text = e.value_text(replace(part, operator="=="))
                yield Unknown(identity(part), text, BOOL, tuple(dict.fromkeys(item.key for item in read)))
            case e.Size() | e.Contains() | e.Find() | e.Element():
                read = list(_needs(part, vocabulary))
                yield from read
                needs = tuple(dict.fromkeys(item.key for item in read))
                if part.type.kind not in WHOLE:
                    yield Unknown(identity(part), e.value_text(part), part.type, needs)
            case e.VariableValue():
                yield from _presence_unknowns(part, vocabulary)
                needs = presences(part, vocabulary)
                if part.type.kind not in WHOLE:
                    yield Unknown(identity(part), e.value_text(part), part.type, needs, part.bounds)
            case (
                e.Expired()
                | e.Outcome()
                | e.StateValue()
                | e.RoundValue()
                | e.Index()
                | e.Sender()
                | e.LossReason()
            ):
                yield Unknown(identity(part), e.value_text(part), part.type)
            case e.Call() if is_unknown_function(part):
                read = list(_needs(part, vocabulary))
                yield from read
                needs = tuple(dict.fromkeys(item.key for item in read))
                key = identity(part)
                yield Unknown((RAISES, *key), e.value_text(part), BOOL, needs)
                yield Unknown(key, e.value_text(part), part.type, needs)


WHOLE = (Kind.MESSAGE, Kind.LIST)
"""What has no value of its own here: it is there or not."""


def is_of_messages(value: e.Compare) -> bool:
    """Whether it compares messages, of which nothing is known but whether they are equal."""
    return value.left.type.kind is Kind.MESSAGE


def written_size(value: e.Size) -> int | None:
    """How many elements a list has that is written out."""
    whole = value.list
    while isinstance(whole, e.Named):
        whole = whole.expression
    return len(whole.elements) if isinstance(whole, e.ListValue) else None


def is_beyond(value: e.Value) -> bool:
    """Whether it looks into a list, of which nothing is known but how long it is."""
    return any(isinstance(part, e.Element | e.Contains | e.Find) for part in e.walk(value))


def _needs(value: e.Value, vocabulary: Vocabulary) -> Iterator[Unknown]:
    """The presences without which a value is surely absent."""
    stack = [value]
    while stack:
        match item := stack.pop():
            case e.Member() | e.Bound() | e.VariableValue():
                yield from _presence_unknowns(item, vocabulary)
            case e.Age(message=message):
                yield from itertools.islice(_presence_unknowns(message, vocabulary), 1)
            case e.At() | e.Mean():
                yield Unknown((THERE, *identity(item)), e.value_text(item), BOOL)
            case e.Element() | e.Find():
                yield Unknown((SET, *identity(item)), e.value_text(item), BOOL)
                stack.extend(reversed(e.operands(item)))
            case e.Has() | e.Holds() | e.Logic() | e.Not():
                pass  # may be there when its operands are not
            case e.Conditional(condition=condition):
                stack.append(condition)
            case _:
                stack.extend(reversed(e.operands(item)))


def _presence_unknowns(read: Read, vocabulary: Vocabulary) -> Iterator[Unknown]:
    whole = e.value_text(replace(read, path=()))
    for key in presences(read, vocabulary):
        text = ".".join((whole, *cast("tuple[str, ...]", key[3]))) if len(key) > 3 else whole
        yield Unknown(key, text, BOOL)


def sources(value: e.Value) -> frozenset[Key]:
    """The messages, variables, timers, outcomes and states that a value depends on."""
    found: set[Key] = set()
    for part in e.walk(value):
        match part:
            case e.Member(host=host, channel=channel):
                found.add((HAS, host, channel))
            case e.VariableValue(name=name):
                found.add((VARIABLE, name))
            case e.Expired() | e.Outcome() | e.StateValue() | e.RoundValue() | e.Index():
                found.add(identity(part))
            case e.Bound(message=message):
                found.add((TAKEN, None, message, ()))
            case e.Sender() | e.LossReason():
                found.add(identity(part))
    return frozenset(found)


def reads_signal(value: e.Value) -> bool:
    """Whether it reads a signal, which comes and goes like an event."""
    return any(
        isinstance(part, e.Member) and part.channel.comm is ChannelKind.SIGNAL for part in e.walk(value)
    )
