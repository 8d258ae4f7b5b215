"""Envelope: the header of each message that travels between agent processes, in Protocol Buffers.

The envelope is the attachment of a zenoh sample. Its payload is the message itself, encoded as the system's
`.proto` says. The sample's key names sender, receiver and channel. The definition for other languages:

    syntax = "proto3";
    package aseme.transport;

    enum Kind {
      MESSAGE = 0; MAIL = 1; ACKNOWLEDGE = 2; PING = 3; PONG = 4; LOSS = 5; CONTRACT = 6; REFUSED = 7;
    }

    message Envelope {
      uint32 format = 1;                // 1
      Kind kind = 2;
      reserved 3;
      fixed64 incarnation = 4;          // which incarnation of the sender
      fixed64 addressee = 5;            // which incarnation of the receiver it is for
      uint64 place = 6;                 // in the stream from sender to receiver, from 1; 0: not in the stream
      uint64 sample = 7;                // counts what is not in the stream, from 1
      uint64 sequence = 8;              // of the sender's identity for it
      sfixed64 time = 9;                // ns of the sender's clock: when it was measured
      fixed64 clock = 10;               // which clock; robots with the same share it
      string channel = 11;
      string host = 12;                 // the one agent it is addressed to, if any
      fixed32 check = 13;               // CRC-32 of the payload
      string performative = 14;         // of an agent message, this and what follows up to 19
      string message = 15;
      string protocol = 16;
      string conversation = 17;
      string participant = 18;          // the sender's part
      string to = 19;                   // the receiver's part
      repeated Part parts = 20;         // who takes part as what, as far as the sender knows
      repeated string receivers = 21;
      uint64 upto = 22;                 // ACKNOWLEDGE: all up to this place have come;
                                        // of an answer to a question: how many pieces it has, with this one
      repeated uint64 missing = 23;     // and of those after it, these have not
      sfixed64 asked = 24;              // PONG: the time of the PING
      sfixed64 heard = 25;              // PONG: when that came
      string in_reply_to = 26;          // of an agent message, this and what follows: as in FIPA SC00061
      string reply_with = 27;           // empty: what follows from sender and sequence
      sfixed64 reply_by = 28;           // in the sender's clock; 0: not said
      repeated string reply_to = 29;    // empty: the sender
      string language = 30;             // of the content, where it goes as text; empty: json
      string encoding = 31;
      string ontology = 32;             // empty: the system of the model
      fixed64 contract = 34;            // the sender's contract (`message.contract`)
      string reason = 35;               // REFUSED: why
      bytes proof = 33;                 // last; HMAC-SHA-256 of the rest with the team's secret (`proven`)
    }
    message Part { string participant = 1; repeated string agents = 2; }
"""

from __future__ import annotations

import hashlib
import hmac
import zlib
from functools import cache, lru_cache
from operator import attrgetter
from typing import Any, NamedTuple

FORMAT = 1

MOST_MISSING = 256
"""An acknowledgement says of at most so many places that they are missing."""

KINDS = ("MESSAGE", "MAIL", "ACKNOWLEDGE", "PING", "PONG", "LOSS", "CONTRACT", "REFUSED")
MESSAGE, MAIL, ACKNOWLEDGE, PING, PONG, LOSS, CONTRACT, REFUSED = range(8)


class EnvelopeError(ValueError):
    """The bytes are not an envelope, or not the envelope of their payload; the text says why."""


class Envelope(NamedTuple):
    """The members are those of the module's docstring."""

    kind: int
    contract: int = 0
    incarnation: int = 0
    addressee: int = 0
    place: int = 0
    sample: int = 0
    sequence: int = 0
    time: int = 0
    clock: int = 0
    channel: str = ""
    host: str = ""
    performative: str = ""
    message: str = ""
    protocol: str = ""
    conversation: str = ""
    participant: str = ""
    to: str = ""
    upto: int = 0
    asked: int = 0
    heard: int = 0
    in_reply_to: str = ""
    reply_with: str = ""
    reply_by: int = 0
    language: str = ""
    encoding: str = ""
    ontology: str = ""
    reason: str = ""
    parts: tuple[tuple[str, tuple[str, ...]], ...] = ()
    receivers: tuple[str, ...] = ()
    missing: tuple[int, ...] = ()
    reply_to: tuple[str, ...] = ()


def written(
    envelope: Envelope, payload: bytes, *, addressee: int = 0, place: int = 0, sample: int = 0
) -> bytes:
    """The envelope of a payload as bytes, for the way that it goes."""
    proto = _proto()(
        format=FORMAT, check=zlib.crc32(payload), addressee=addressee, place=place, sample=sample
    )
    for name, value, default in zip(_SIMPLE, envelope, _DEFAULTS, strict=False):  # the lists are last
        if value != default:
            setattr(proto, name, value)
    if envelope.parts:
        for participant, agents in envelope.parts:
            proto.parts.add(participant=participant, agents=agents)
    if envelope.receivers:
        proto.receivers.extend(envelope.receivers)
    if envelope.missing:
        proto.missing.extend(envelope.missing)
    if envelope.reply_to:
        proto.reply_to.extend(envelope.reply_to)
    data: bytes = proto.SerializeToString()
    return data


def read(data: bytes, payload: bytes) -> Envelope:
    """The envelope that these bytes are, if it is that of the payload.

    Raises:
        EnvelopeError: it is not.
    """
    from google.protobuf.message import DecodeError

    try:
        proto = _proto().FromString(data)
    except DecodeError as problem:
        raise EnvelopeError(f"its envelope cannot be read: {problem}") from None
    if proto.format != FORMAT:
        raise EnvelopeError(f"its envelope has the format {proto.format}; this is {FORMAT}")
    if proto.check != zlib.crc32(payload):
        raise EnvelopeError("it was damaged on its way: its checksum is another")
    if proto.kind not in range(len(KINDS)):
        raise EnvelopeError(f"there is no kind {proto.kind} of envelope")
    if len(proto.missing) > MOST_MISSING:
        raise EnvelopeError(f"it says of {len(proto.missing)} places that they are missing")
    envelope = Envelope(*_simple(proto))
    if not (proto.parts or proto.receivers or proto.missing or proto.reply_to):
        return envelope
    return envelope._replace(
        parts=tuple((part.participant, tuple(part.agents)) for part in proto.parts),
        receivers=tuple(proto.receivers),
        missing=tuple(proto.missing),
        reply_to=tuple(proto.reply_to),
    )


def proven(data: bytes, payload: bytes, secret: bytes, way: str) -> bytes:
    """An envelope with the proof that its sender knows a secret; `way` is from whom it goes to whom."""
    return data + _PROOF + _proof(data, payload, secret, way)


def unproven(data: bytes, payload: bytes, secret: bytes, way: str) -> bytes:
    """The envelope without its proof.

    Raises:
        EnvelopeError: it has none, or that of another envelope, payload, way or secret.
    """
    rest, mark, proof = data[:-35], data[-35:-32], data[-32:]
    if mark != _PROOF or not hmac.compare_digest(proof, _proof(rest, payload, secret, way)):
        raise EnvelopeError("it does not prove that its sender is of the team")
    return rest


_PROOF = b"\x8a\x02\x20"
"""How the field `proof` begins: its number, and its 32 bytes."""


def _proof(data: bytes, payload: bytes, secret: bytes, way: str) -> bytes:
    head = way.encode()
    return mac(secret, b"%d %d " % (len(head), len(data)), head, data, payload)


def mac(secret: bytes, *parts: bytes) -> bytes:
    """The HMAC-SHA-256 (RFC 2104) of parts that follow each other; of a secret it is begun only once."""
    inner, outer = (begun.copy() for begun in _begun(secret))
    for part in parts:
        inner.update(part)
    outer.update(inner.digest())
    found: bytes = outer.digest()
    return found


@lru_cache(maxsize=16)
def _begun(secret: bytes) -> tuple[hashlib._Hash, hashlib._Hash]:
    block = secret if len(secret) <= 64 else hashlib.sha256(secret).digest()
    block = block.ljust(64, b"\0")
    return (
        hashlib.sha256(bytes(byte ^ 0x36 for byte in block)),
        hashlib.sha256(bytes(byte ^ 0x5C for byte in block)),
    )


_LISTS = ("parts", "receivers", "missing", "reply_to")
_SIMPLE = Envelope._fields[: -len(_LISTS)]
_DEFAULTS: tuple[object, ...] = (None, *Envelope._field_defaults.values())
_simple = attrgetter(*_SIMPLE)


@cache
def _proto() -> Any:
    """The protobuf class, in a pool of its own."""
    from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

    kinds = descriptor_pb2.FieldDescriptorProto
    file = descriptor_pb2.FileDescriptorProto(
        name="aseme/transport.proto", package="aseme.transport", syntax="proto3"
    )
    kind = file.enum_type.add(name="Kind")
    for number, name in enumerate(KINDS):
        kind.value.add(name=name, number=number)
    part = file.message_type.add(name="Part")
    part.field.add(name="participant", number=1, type=kinds.TYPE_STRING, label=kinds.LABEL_OPTIONAL)
    part.field.add(name="agents", number=2, type=kinds.TYPE_STRING, label=kinds.LABEL_REPEATED)
    envelope = file.message_type.add(name="Envelope")
    text, count, fixed, moment = kinds.TYPE_STRING, kinds.TYPE_UINT64, kinds.TYPE_FIXED64, kinds.TYPE_SFIXED64
    types: dict[str, Any] = {
        "format": kinds.TYPE_UINT32,
        "kind": kinds.TYPE_ENUM,
        "reserved": None,
        "incarnation": fixed,
        "addressee": fixed,
        "place": count,
        "sample": count,
        "sequence": count,
        "time": moment,
        "clock": fixed,
        "channel": text,
        "host": text,
        "check": kinds.TYPE_FIXED32,
        "performative": text,
        "message": text,
        "protocol": text,
        "conversation": text,
        "participant": text,
        "to": text,
        "parts": kinds.TYPE_MESSAGE,
        "receivers": text,
        "upto": count,
        "missing": count,
        "asked": moment,
        "heard": moment,
        "in_reply_to": text,
        "reply_with": text,
        "reply_by": moment,
        "reply_to": text,
        "language": text,
        "encoding": text,
        "ontology": text,
        "proof": None,  # not a field for this class: it stands behind all that is
        "contract": fixed,
        "reason": text,
    }
    for number, (name, type_) in enumerate(types.items(), 1):
        if type_ is None:
            continue
        repeated = name in _LISTS
        field = envelope.field.add(
            name=name,
            number=number,
            type=type_,
            label=kinds.LABEL_REPEATED if repeated else kinds.LABEL_OPTIONAL,
        )
        if name == "kind":
            field.type_name = ".aseme.transport.Kind"
        if name == "parts":
            field.type_name = ".aseme.transport.Part"
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    return message_factory.GetMessageClass(pool.FindMessageTypeByName("aseme.transport.Envelope"))
