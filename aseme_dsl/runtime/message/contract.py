"""Contract: what a build says of its messages and protocols, and where two builds misunderstand each other.

Robots of two builds exchange their contracts when they meet. A contract has the fields of each message by
name, number and type, the constants of enums, and the message of each channel. For each protocol it has a
hash of what the participants say, in which order. Names of roles, activities and states are not in it, and
durations are not either.

As in Protocol Buffers, a robot ignores fields that it does not know. A field that the sender does not know
is absent: None where the reader declares it `optional`, and empty where it is `repeated`. Any other one
cannot be absent, so such a message is refused.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from google.protobuf.descriptor_pb2 import FieldDescriptorProto

    from aseme_dsl.runtime.chart.plan import Plan
    from aseme_dsl.runtime.message.wire import Schema

OPTIONAL, REPEATED = "optional", "repeated"
_ENUM, _MESSAGE = "enum ", "message "
_compact = json.JSONEncoder(separators=(",", ":"), sort_keys=True).encode


class ContractError(ValueError):
    """The bytes are not a contract; the text says why."""


@dataclass(frozen=True, slots=True)
class Field:
    """A field of a message. `type` is a scalar of Protocol Buffers, `duration`, `enum E` or `message M`."""

    number: int
    label: str
    """`optional`, `repeated` or nothing."""
    type: str


@dataclass(frozen=True, slots=True)
class Exchange:
    """What a protocol is for others: the hash of its participants' automata, and its messages."""

    automata: str
    messages: tuple[str, ...]


@dataclass(frozen=True)
class Contract:
    """What a build says of its messages and protocols, all by name."""

    messages: Mapping[str, Mapping[str, Field]]
    enums: Mapping[str, Mapping[str, int]]
    """Each enum's constants with their numbers."""
    channels: Mapping[str, tuple[str, bool]]
    """The message of each channel, and whether its signals queue."""
    protocols: Mapping[str, Exchange]
    model: str = ""
    """The hash of all models. It does not count: what others cannot notice may differ."""

    @cached_property
    def number(self) -> int:
        """What tells contracts apart: 64 bits of the SHA-256 of all but the model. Never 0."""
        text = _compact({**self._content, "model": ""}).encode()
        return int.from_bytes(hashlib.sha256(text).digest()[:8], "big") or 1

    def dumps(self) -> bytes:
        """The contract as JSON."""
        return _compact(self._content).encode()

    @property
    def _content(self) -> dict[str, object]:
        return {
            "messages": {
                name: {key: [item.number, item.label, item.type] for key, item in fields.items()}
                for name, fields in self.messages.items()
            },
            "enums": {name: dict(constants) for name, constants in self.enums.items()},
            "channels": {name: list(about) for name, about in self.channels.items()},
            "protocols": {
                name: [item.automata, list(item.messages)] for name, item in self.protocols.items()
            },
            "model": self.model,
        }


def loads(data: bytes) -> Contract:
    """The contract that `dumps` has written.

    Raises:
        ContractError: it is none.
    """
    try:
        found = outside.loads(data)
        assert isinstance(found, dict)
        messages = {
            _text(name): {_text(key): _field(*item) for key, item in fields.items()}
            for name, fields in found["messages"].items()
        }
        enums = {
            _text(name): {_text(key): _whole(number) for key, number in constants.items()}
            for name, constants in found["enums"].items()
        }
        channels = {
            _text(name): (_text(message), bool(queued))
            for name, (message, queued) in found["channels"].items()
        }
        protocols = {
            _text(name): Exchange(_text(automata), tuple(map(_text, items)))
            for name, (automata, items) in found["protocols"].items()
        }
        return Contract(messages, enums, channels, protocols, _text(found["model"]))
    except (AssertionError, AttributeError, KeyError, TypeError, ValueError) as problem:
        raise ContractError(f"{len(data)} bytes are not a contract: {problem}") from None


def _field(number: object, label: object, kind: object) -> Field:
    return Field(_whole(number), _text(label), _text(kind))


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError("a text is wanted")
    return value


def _whole(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise TypeError("a whole number is wanted")
    return value


# ---- of a build --------------------------------------------------------------------------------


def contract_of(schema: Schema, plans: Iterable[Plan], model: str = "") -> Contract:
    """The contract of a generated package: of its messages, and of the plans of all its roles."""
    plans = tuple(plans)
    messages, enums = types_of(
        base64.b64decode(schema.descriptors),
        {kind.__name__: name for kind, name in schema.classes.items()},
        schema.durations,
    )
    queued = {info.name for plan in plans for info in plan.channels if info.queued}
    channels = {name: (kind.__name__, name in queued) for name, kind in schema.channels.items()}
    spoken: dict[str, str] = {}
    used: dict[str, set[str]] = {}
    for plan in plans:
        for branch in plan.branches:
            spoken[branch.protocol] = branch.automata
            named = {message for _, message in (*branch.sends, *branch.receives)}
            used.setdefault(branch.protocol, set()).update(named & messages.keys())
    protocols = {name: Exchange(spoken[name], tuple(sorted(used[name]))) for name in sorted(spoken)}
    return Contract(messages, enums, channels, protocols, model)


def types_of(
    descriptors: bytes, classes: Mapping[str, str], durations: Iterable[str]
) -> tuple[dict[str, dict[str, Field]], dict[str, dict[str, int]]]:
    """The fields of messages, and the constants of enums, as a FileDescriptorSet has them.

    `classes` gives the full name there of each message; `durations` are fields (`Ball.lasting`) whose whole
    numbers are durations.
    """
    from google.protobuf import descriptor_pb2

    files = descriptor_pb2.FileDescriptorSet.FromString(descriptors)
    described: dict[str, descriptor_pb2.DescriptorProto] = {}
    enums: dict[str, dict[str, int]] = {}

    def collect(around: str, item: descriptor_pb2.DescriptorProto) -> None:
        name = f"{around}.{item.name}".lstrip(".")
        described[name] = item
        for enum in item.enum_type:
            enums[f"{name}.{enum.name}"] = {value.name: value.number for value in enum.value}
        for inner in item.nested_type:
            collect(name, inner)

    for file in files.file:
        for enum in file.enum_type:
            enums[f"{file.package}.{enum.name}".lstrip(".")] = {v.name: v.number for v in enum.value}
        for message in file.message_type:
            collect(file.package, message)
    short = {full: name for name, full in classes.items()}
    known = frozenset(durations)
    messages = {
        name: {
            field.name: _read_field(field, short, f"{name}.{field.name}" in known)
            for field in described[full].field
        }
        for name, full in classes.items()
    }
    used = {
        field.type.removeprefix(_ENUM)
        for fields in messages.values()
        for field in fields.values()
        if field.type.startswith(_ENUM)
    }
    return messages, {name: enums[name] for name in sorted(used)}


def _read_field(field: FieldDescriptorProto, short: Mapping[str, str], is_duration: bool) -> Field:
    label = REPEATED if field.label == field.LABEL_REPEATED else ""
    if field.proto3_optional or (not label and field.HasField("oneof_index")):
        label = OPTIONAL
    full = field.type_name.removeprefix(".")
    if field.type == field.TYPE_ENUM:
        kind = _ENUM + full
    elif field.type == field.TYPE_MESSAGE:
        kind = _MESSAGE + short.get(full, full)
    else:
        name: str = type(field).Type.Name(field.type)
        kind = "duration" if is_duration else name.removeprefix("TYPE_").lower()
    return Field(field.number, label, kind)


# ---- of two builds -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Objection:
    """Why a message is not read: what is wrong, and in which messages, with the field if it is of one."""

    reason: str
    mine: str
    theirs: str
    field: str = ""


@dataclass(frozen=True)
class Reading:
    """How one build reads what another one sends."""

    channels: Mapping[str, str]
    """Why what comes on a channel is not read, by channel; those of either build that are not here are."""
    messages: Mapping[str, str]
    """The same of messages."""
    protocols: Mapping[str, str]
    """Why a conversation of a protocol is not possible; it is the same both ways."""
    zeros: frozenset[tuple[str, str]]
    """Fields, as (message, field), that are `optional` here and not there: not sent is zero, not absent."""
    objections: Mapping[str, Objection]
    """What is wrong with each of `messages`."""


def reading(reader: Contract, sender: Contract) -> Reading:
    """How a build reads what another one sends."""
    there = _Comparison(reader, sender)
    back = _Comparison(sender, reader)
    objections = {name: found for name in sender.messages if (found := there.message(name, name))}
    channels: dict[str, str] = {}
    for name, (message, queued) in sender.channels.items():
        if name not in reader.channels:
            channels[name] = "there is no such channel"
        elif message in objections:
            channels[name] = objections[message].reason
        elif reader.channels[name][1] != queued:
            channels[name] = "its signals queue" if queued else "its signals do not queue"
    protocols: dict[str, str] = {}
    for name, exchange in sender.protocols.items():
        if name not in reader.protocols:
            protocols[name] = "there is no such protocol"
        elif reader.protocols[name].automata != exchange.automata:
            protocols[name] = "its participants say something else, or in another order"
        else:
            wrong = [(item, there.message(item, item)) for item in exchange.messages]
            wrong += [(item, back.message(item, item)) for item in exchange.messages]
            reason = next((f"{item}: {what.reason}" for item, what in wrong if what is not None), "")
            if reason:
                protocols[name] = reason
    zeros = {
        (name, key)
        for name, fields in reader.messages.items()
        for key, field in fields.items()
        if field.label == OPTIONAL
        and (theirs := sender.messages.get(name, {}).get(key)) is not None
        and not theirs.label
    }
    reasons = {name: found.reason for name, found in objections.items()}
    return Reading(channels, reasons, protocols, frozenset(zeros), objections)


class _Comparison:
    """Whether a reader understands the messages of a sender; each pair of messages is compared once."""

    def __init__(self, reader: Contract, sender: Contract) -> None:
        self._reader = reader
        self._sender = sender
        self._known: dict[tuple[str, str], Objection | None] = {}

    def message(self, mine: str, theirs: str) -> Objection | None:
        """Why a message is not read as one of the reader's; None if it is."""
        key = mine, theirs
        if key not in self._known:
            self._known[key] = None  # a message may have a list of its own kind in it
            self._known[key] = next(self._objections(mine, theirs), None)
        return self._known[key]

    def _objections(self, mine: str, theirs: str) -> Iterator[Objection]:
        if mine not in self._reader.messages or theirs not in self._sender.messages:
            yield Objection(f"there is no message {mine}", mine, theirs)
            return
        ours, sent = self._reader.messages[mine], self._sender.messages[theirs]
        numbers = {field.number: name for name, field in sent.items()}
        for name, field in sorted(ours.items(), key=lambda item: item[1].number):
            other = sent.get(name)
            named = numbers.get(field.number)
            if other is not None and other.number == field.number:
                inner = self._inside(name, field, other)
                if inner is not None:
                    yield inner
                    continue
            reason = _missing(name, field, named) if other is None else _differs(name, field, other)
            if not reason and other is not None:
                reason = self._constants(name, field, other)
            if reason:
                yield Objection(reason, mine, theirs, name)

    def _inside(self, name: str, field: Field, other: Field) -> Objection | None:
        """What is wrong in a message that is in a field."""
        if not (field.type.startswith(_MESSAGE) and other.type.startswith(_MESSAGE)):
            return None
        found = self.message(field.type.removeprefix(_MESSAGE), other.type.removeprefix(_MESSAGE))
        if found is None:
            return None
        return Objection(f"in `{name}`: {found.reason}", found.mine, found.theirs, found.field)

    def _constants(self, name: str, field: Field, other: Field) -> str:
        """What is wrong with the constants of an enum, if both fields are of one."""
        ours = self._reader.enums.get(field.type.removeprefix(_ENUM), {})
        sent = self._sender.enums.get(other.type.removeprefix(_ENUM), {})
        of_number = {number: constant for constant, number in sent.items()}
        for constant, number in ours.items():
            there = sent.get(constant, number)
            if there != number:
                return f"`{name}`: {constant} is {number} here and {there} there"
            if constant not in sent and number in of_number:
                return f"`{name}`: {number} is {constant} here and {of_number[number]} there"
        return ""


def _missing(name: str, field: Field, named: str | None) -> str:
    """Why a field that is not sent is missed; `named` is the one that has its number there."""
    if named is not None:
        return f"the field {field.number} is `{name}` here and `{named}` there"
    return "" if field.label else f"`{name}` is not sent, and is not optional here"


def _differs(name: str, field: Field, other: Field) -> str:
    """What of a field is not the same, besides what is in its message or enum."""
    if field.number != other.number:
        return f"`{name}` has the number {field.number} here and {other.number} there"
    if field.label != other.label and (REPEATED in (field.label, other.label) or not field.label):
        here, there = (item.label or "required" for item in (field, other))
        return f"`{name}` is {here} here and {there} there"
    named = any(field.type.startswith(kind) and other.type.startswith(kind) for kind in (_MESSAGE, _ENUM))
    if field.type != other.type and not named:
        return f"`{name}` is {shown(field.type)} here and {shown(other.type)} there"
    return ""


def shown(kind: str) -> str:
    """A type as a document writes it."""
    plain = {"int64": "int"}
    return plain.get(kind, kind.removeprefix(_ENUM).removeprefix(_MESSAGE).rpartition(".")[2])


__all__ = ["Contract", "ContractError", "Exchange", "Field", "Reading", "contract_of", "loads", "reading"]
