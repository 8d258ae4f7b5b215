"""Wire: messages as bytes: Protocol Buffers between processes, and the compact form of a small radio.

A generated module `messages` has a `SCHEMA` of its own, whose descriptors are in a private pool: two systems
with messages of one name do not disturb each other. The first message imports protobuf.
"""

from __future__ import annotations

import base64
import json
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import is_dataclass
from enum import IntEnum
from functools import cache, cached_property
from types import NoneType
from typing import TYPE_CHECKING, Protocol, TypeVar, cast, get_args

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.as_json import from_json, member_types, only_known, to_json
from aseme_dsl.runtime.message.by_name import made
from aseme_dsl.runtime.message.checked import check as check  # for generated modules

if TYPE_CHECKING:
    from google.protobuf.descriptor import FieldDescriptor
    from google.protobuf.message import Message as ProtoMessage

M = TypeVar("M")
Zeros = frozenset[tuple[str, str]]
"""Fields, as (message, field)."""
_compact = json.JSONEncoder(separators=(",", ":")).encode


class _Entry(Protocol):
    """An entry of a map."""

    key: object
    value: object


class WireError(ValueError):
    """A message that cannot become bytes, or bytes that are not a message; it says which member and why."""


@dataclass(frozen=True, slots=True)
class _Member:
    """A member of a message's class and the field that it is on the wire."""

    name: str
    field: str
    kind: type
    optional: bool
    repeated: bool
    entries: bool
    """A map: repeated entries with `key` and `value`."""


@dataclass(frozen=True, eq=False)
class Schema:
    """How the messages of a generated module become bytes and back.

    `descriptors` is a FileDescriptorSet in base64, `classes` gives each message's class its full name there,
    `channels` each channel's text (`team.state.Assignment`) its class. `radio` has the channels that travel
    by radio, in the order of their numbers. Letters stand for the members: `?` bool, `e` enum, `i` int,
    `f` double, `m` duration. An `o` stands before the letter of an optional member. `durations` are the
    fields (`Ball.lasting`) whose whole numbers are durations.
    """

    descriptors: str
    classes: Mapping[type[object], str]
    channels: Mapping[str, type[object]]
    radio: Mapping[str, str]
    durations: tuple[str, ...] = ()

    # ---- Protocol Buffers ----------------------------------------------------------------------

    def encode(self, message: object) -> bytes:
        """The message in the wire format of Protocol Buffers; the same message gives the same bytes.

        Raises:
            WireError: A member has a value that its type does not allow, or two members of a oneof are set.
        """
        return self._to_proto(message).SerializeToString(deterministic=True)

    def decode(self, kind: type[M], data: bytes, zeros: Zeros = frozenset()) -> M:
        """The message of class `kind` that these bytes are. Fields that it does not know are dropped.

        An optional field that was not sent is None, but for `zeros`: it is zero there. An optional enum with
        a number that has no constant is None.

        Raises:
            WireError: They are none, or an enum has a number without a constant.
        """
        from google.protobuf.message import DecodeError

        try:
            proto = self._protos[kind].FromString(data)
        except DecodeError as problem:
            raise WireError(f"{len(data)} bytes cannot be read as {kind.__name__}: {problem}") from None
        return self._from_proto(kind, proto, zeros)

    # ---- JSON ----------------------------------------------------------------------------------

    def encode_json(self, message: object) -> bytes:
        """The message as a JSON object in ASCII, with a member for each of its.

        Raises:
            WireError: as `encode`.
        """
        self._to_proto(message)  # holds it to the same rules
        return _compact(to_json(message)).encode()

    def decode_json(self, kind: type[M], data: bytes, *, known: bool = True) -> M:
        """The message of class `kind` that this JSON object is; members that it lacks have their defaults.

        Members that the class does not have are dropped, if they need not be `known`.

        Raises:
            WireError: It is none.
        """
        try:
            read = outside.loads(data)
            found = from_json(kind, read if known else only_known(kind, read))
        except (ValueError, RecursionError) as problem:
            raise WireError(f"{len(data)} bytes cannot be read as {kind.__name__}: {problem}") from None
        return found

    @cached_property
    def _protos(self) -> dict[type[object], type[ProtoMessage]]:
        """The protobuf class of each class."""
        from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

        pool = descriptor_pool.DescriptorPool()
        files = descriptor_pb2.FileDescriptorSet.FromString(base64.b64decode(self.descriptors))
        for file in files.file:
            pool.Add(file)
        return {
            kind: message_factory.GetMessageClass(pool.FindMessageTypeByName(name))
            for kind, name in self.classes.items()
        }

    @cached_property
    def _members(self) -> dict[type[object], tuple[_Member, ...]]:
        return {kind: tuple(_members_of(kind, proto)) for kind, proto in self._protos.items()}

    def _to_proto(self, message: object) -> ProtoMessage:
        kind = type(message)
        if kind not in self._protos:
            raise WireError(f"{kind.__name__} is not a message of this system")
        proto: ProtoMessage = self._protos[kind]()
        chosen: set[str] = set()
        for member in self._members[kind]:
            value = getattr(message, member.name)
            if value is None:
                continue
            oneof = proto.DESCRIPTOR.fields_by_name[member.field].containing_oneof
            if oneof is not None and oneof.name in chosen:
                raise WireError(f"{kind.__name__} has more than one member of `{oneof.name}`")
            if oneof is not None:
                chosen.add(oneof.name)
            try:
                self._set(proto, member, value)
            except WireError:
                raise
            except (TypeError, ValueError, OverflowError, UnicodeError) as problem:
                raise WireError(f"{kind.__name__}.{member.name} = {value!r}: {problem}") from None
        return proto

    def _set(self, proto: ProtoMessage, member: _Member, value: object) -> None:
        nested = member.kind in self._protos
        if member.entries:
            target = getattr(proto, member.field)
            for item in cast("Iterable[_Entry]", value):
                if is_dataclass(item.value):
                    target[item.key].CopyFrom(self._to_proto(item.value))
                else:
                    target[item.key] = item.value
        elif member.repeated:
            items = cast("Iterable[object]", value)
            getattr(proto, member.field).extend(self._to_proto(item) if nested else item for item in items)
        elif nested:
            getattr(proto, member.field).CopyFrom(self._to_proto(value))
        else:
            setattr(proto, member.field, value)

    def _from_proto(self, kind: type[M], proto: ProtoMessage, zeros: Zeros) -> M:
        make: Callable[..., M] = kind
        return make(**{member.name: self._get(kind, proto, member, zeros) for member in self._members[kind]})

    def _get(self, owner: type[object], proto: ProtoMessage, member: _Member, zeros: Zeros) -> object:
        def one(value: object) -> object:
            if member.kind in self._protos:
                return self._from_proto(member.kind, cast("ProtoMessage", value), zeros)
            return _constant(member.kind, value, f"{owner.__name__}.{member.name}")

        if member.entries:
            found = getattr(proto, member.field)
            entry = {part.name: part for part in self._members[member.kind]}
            return tuple(self._entry(member.kind, entry, key, found[key], zeros) for key in sorted(found))
        if member.repeated:
            return tuple(one(item) for item in getattr(proto, member.field))
        value = getattr(proto, member.field)
        if member.optional:
            if not proto.HasField(member.field) and (owner.__name__, member.field) not in zeros:
                return None
            if issubclass(member.kind, IntEnum) and value not in _numbers(member.kind):
                return None
        return one(value)

    def _entry(
        self, kind: type[object], parts: Mapping[str, _Member], key: object, value: object, zeros: Zeros
    ) -> object:
        part = parts["value"]
        if part.kind in self._protos:
            value = self._from_proto(part.kind, cast("ProtoMessage", value), zeros)
        return made(kind, key=key, value=_constant(part.kind, value, f"{kind.__name__}.value"))

    # ---- radio ---------------------------------------------------------------------------------

    def pack(self, channel: str, message: object) -> bytes:
        """A message of a radio channel in as few bytes as it has: its number, then its members.

        Numbers are big-endian; a double is sent in single precision, a duration in whole milliseconds.

        Raises:
            WireError: The channel does not travel by radio, or a member is out of the range that is sent.
        """
        if channel not in self.radio:
            raise WireError(f"{channel} does not travel by radio")
        if type(message) is not self.channels[channel]:
            raise WireError(
                f"{channel} carries {self.channels[channel].__name__}, not {type(message).__name__}"
            )
        letters = iter(self.radio[channel])
        number = list(self.radio).index(channel)
        return bytes([number]) + b"".join(_packed(message, letters, type(message).__name__))

    def unpack(self, data: bytes) -> tuple[str, object]:
        """The channel and the message that `pack` made these bytes of.

        Raises:
            WireError: They are none: no such channel, no such constant, too few or too many bytes.
        """
        if not data or data[0] >= len(self.radio):
            raise WireError(f"no radio message begins with {data[:1].hex() or 'nothing'}")
        channel = list(self.radio)[data[0]]
        reader = _Reader(data, 1)
        message = _unpacked(self.channels[channel], iter(self.radio[channel]), reader)
        if reader.position != len(data):
            raise WireError(f"{channel}: {len(data) - reader.position} bytes too many")
        return channel, message


def _hints(kind: object) -> dict[str, object]:
    """The types of the members of a message's class."""
    return member_types(kind)


def _constant(kind: type, value: object, where: str) -> object:
    """An enum's number as its constant; anything else as it is."""
    if not issubclass(kind, IntEnum):
        return value
    try:
        return kind(cast(int, value))
    except ValueError:
        raise WireError(f"{where}: {kind.__name__} has no constant with the number {value}") from None


@cache
def _numbers(kind: type[IntEnum]) -> frozenset[int]:
    return frozenset(item.value for item in kind)


def _members_of(kind: type[object], proto: type[ProtoMessage]) -> Iterator[_Member]:
    """Members and fields stand in the same order."""
    hints = _hints(kind)
    fields = cast("Sequence[FieldDescriptor]", proto.DESCRIPTOR.fields)
    for name, field in zip(hints, fields, strict=True):
        hint = hints[name]
        optional = NoneType in get_args(hint)
        repeated = Ellipsis in get_args(hint)
        if optional or repeated:
            hint = next(part for part in get_args(hint) if part not in (NoneType, Ellipsis))
        entries = repeated and field.message_type is not None and field.message_type.GetOptions().map_entry
        yield _Member(name, field.name, cast(type, hint), optional, repeated, entries)


# ---- the radio's form --------------------------------------------------------------------------

_FORMATS = {"?": struct.Struct(">?"), "e": struct.Struct(">B"), "i": struct.Struct(">i")}
_FORMATS |= {"f": struct.Struct(">f"), "m": struct.Struct(">i")}
_OPTIONAL = "o"
_MILLISECOND = 1_000_000


def _packed(message: object, letters: Iterator[str], where: str) -> Iterator[bytes]:
    for name, hint in _hints(type(message)).items():
        value = getattr(message, name)
        if is_dataclass(hint):
            yield from _packed(value, letters, f"{where}.{name}")
            continue
        letter = next(letters)
        if letter == _OPTIONAL:
            letter = next(letters)
            yield bytes([value is not None])
            if value is None:
                continue
        yield _number(letter, value, f"{where}.{name}")


def _number(letter: str, value: object, where: str) -> bytes:
    if letter == "m":
        value = round(cast(int, value) / _MILLISECOND)
    try:
        return _FORMATS[letter].pack(value)
    except (struct.error, OverflowError, TypeError):
        size = _FORMATS[letter].size
        plural = "" if size == 1 else "s"
        raise WireError(f"{where} = {value!r} does not fit the radio's {size} byte{plural}") from None


@dataclass(slots=True)
class _Reader:
    """Bytes of the radio and how far they have been read."""

    data: bytes
    position: int

    def number(self, letter: str, where: str) -> bool | int | float:
        form = _FORMATS[letter]
        if self.position + form.size > len(self.data):
            raise WireError(f"{where}: the message ends too early")
        value: bool | int | float
        (value,) = form.unpack_from(self.data, self.position)
        self.position += form.size
        return value * _MILLISECOND if letter == "m" else value


def _unpacked(kind: type[object], letters: Iterator[str], reader: _Reader) -> object:
    members: dict[str, object] = {}
    for name, hint in _hints(kind).items():
        where = f"{kind.__name__}.{name}"
        if is_dataclass(hint):
            members[name] = _unpacked(cast(type, hint), letters, reader)
            continue
        letter = next(letters)
        if letter == _OPTIONAL:
            letter = next(letters)
            if not reader.number("?", where):
                members[name] = None
                continue
            hint = next(part for part in get_args(hint) if part is not NoneType)
        members[name] = _constant(cast(type, hint), reader.number(letter, where), where)
    make: Callable[..., object] = kind
    return make(**members)
