"""ACL headers: envelopes and external agents' messages as headers and a text that FIPA agents can read.

The headers are FIPA's parameters of an agent message, named as in FIPA's text form: `performative`,
`conversation-id`, `protocol`, `reply-with` and others. The text is the content, a JSON object. One further
header, `aseme`, has the remaining fields of an envelope as JSON.
"""

from __future__ import annotations

import json
import re
import time
import zlib
from collections.abc import Mapping
from contextlib import suppress
from datetime import UTC, datetime, timedelta

from aseme_dsl import outside
from aseme_dsl.runtime.message.acl import (
    JSON,
    AgentIdentifier,
    FipaMessage,
    Span,
    fipa_name,
    performative_of,
    protocol_of,
    registered_name,
)
from aseme_dsl.runtime.message.acl_text import AclTextError, moment_text, read_moment
from aseme_dsl.runtime.message.by_name import made
from aseme_dsl.runtime.platform.platform import Headers
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.link import Stamp

OURS = "aseme"
"""The header for the fields of an envelope that FIPA has no parameter for."""
PROTOCOL = "aseme"
"""The `protocol` header of envelopes that are not agent messages: external agents ignore these."""
MESSAGE, PARTICIPANT = "X-message", "X-participant"

_READABLE = {
    "protocol": "protocol",
    "conversation": "conversation-id",
    "in_reply_to": "in-reply-to",
    "encoding": "encoding",
    "message": MESSAGE,
    "participant": PARTICIPANT,
}
"""Which fields of an envelope are headers of their own."""
_NOT_OURS = {*_READABLE, "performative", "ontology", "language"}
_REST: tuple[tuple[str, object], ...] = tuple(
    (name, Envelope._field_defaults.get(name))
    for name in Envelope._fields
    if name not in _NOT_OURS and name not in Stamp._fields
)
_TYPES: dict[str, type] = {name: type(default) for name, default in _REST if default is not None}
_TYPES |= {"kind": int, "check": int, **dict.fromkeys(Stamp._fields, int)}
_PAIRS = "parts"
_compact = json.JSONEncoder(separators=(",", ":")).encode


def letter(envelope: Envelope, stamp: Stamp, payload: bytes, sender: str, system: str) -> dict[str, str]:
    """The headers of an envelope; the text is its payload."""
    rest: dict[str, object] = {"check": zlib.crc32(payload)}
    for name, default in _REST:
        value = getattr(envelope, name)
        if value != default:
            rest[name] = value
    for name, number in zip(Stamp._fields, stamp, strict=True):
        if number:
            rest[name] = number
    if envelope.kind != envelopes.MAIL:
        headers = {"performative": "inform", "protocol": PROTOCOL}
        if payload:
            headers |= {"ontology": system, "language": JSON}
        headers[OURS] = _compact(rest)
        return headers
    headers = {
        "performative": fipa_name(envelope.performative),
        "conversation-id": envelope.conversation,
        "protocol": registered_name(envelope.protocol),
        "ontology": envelope.ontology or system,
        "language": envelope.language or JSON,
        "reply-with": envelope.reply_with or f"{sender}-{envelope.sequence}",
        MESSAGE: envelope.message,
        PARTICIPANT: envelope.participant,
    }
    if envelope.in_reply_to:
        headers["in-reply-to"] = envelope.in_reply_to
    if envelope.encoding:
        headers["encoding"] = envelope.encoding
    if envelope.reply_by:
        headers["reply-by"] = _on_the_wall(envelope.reply_by)
    headers[OURS] = _compact(rest)
    return headers


def _on_the_wall(moment: int) -> str:
    """A moment of the machine's clock (ns) as a date, for those who have another clock."""
    left = (moment - time.monotonic_ns()) // 1000
    try:
        return (datetime.now(UTC) + timedelta(microseconds=left)).isoformat()
    except OverflowError:
        return (datetime.max if left > 0 else datetime.min).replace(tzinfo=UTC).isoformat()


def ours(headers: Headers) -> dict[str, object]:
    """What the header `aseme` says. Raises EnvelopeError if it is not a JSON object."""
    try:
        found = outside.loads(headers[OURS])
    except (ValueError, RecursionError) as problem:
        raise EnvelopeError(f"its header {OURS} is not JSON: {problem}") from None
    if not isinstance(found, dict):
        raise EnvelopeError(f"its header {OURS} is not a JSON object")
    return found


def read_letter(said: Mapping[str, object], headers: Headers, payload: bytes, system: str) -> Envelope:
    """The envelope that `ours` has read, if it is that of the payload.

    Raises:
        EnvelopeError: it is not.
    """
    values: dict[str, object] = {}
    for name, value in said.items():
        kind = _TYPES.get(name)
        if kind is None:
            raise EnvelopeError(f"there is no {name[:50]} in an envelope")
        if kind is tuple:
            values[name] = _tuple(name, value)
        elif kind is int and value.__class__ is int and not -(1 << 63) <= value < 1 << 64:
            raise EnvelopeError(f"its {name} is not a number of 64 bits")
        elif value.__class__ is kind:
            values[name] = value
        else:
            raise EnvelopeError(f"its {name} is not of the type {kind.__name__}")
    if values.pop("check", None) != zlib.crc32(payload):
        raise EnvelopeError("it was damaged on its way: its checksum is another")
    if values.get("kind") not in range(len(envelopes.KINDS)):
        raise EnvelopeError(f"there is no kind {values.get('kind')} of envelope")
    if values["kind"] == envelopes.MAIL:
        performative = performative_of(headers.get("performative", ""))
        if performative is None:
            raise EnvelopeError(f"FIPA has no performative {headers.get('performative', '')[:100]}")
        values["performative"] = performative
        for name, header in _READABLE.items():
            values[name] = headers.get(header, "")
        values["protocol"] = protocol_of(str(values["protocol"]))
        ontology, language = headers.get("ontology", ""), headers.get("language", "")
        values["ontology"] = ontology if ontology != system else ""
        values["language"] = language if language != JSON else ""
    return made(Envelope, **values)


def _tuple(name: str, value: object) -> tuple[object, ...]:
    if not isinstance(value, list):
        raise EnvelopeError(f"its {name} is not a list")
    if name == _PAIRS:
        try:
            return tuple((str(part), tuple(map(str, names))) for part, names in value)
        except (TypeError, ValueError):
            raise EnvelopeError(f"its {name} are not participants with agents") from None
    if name == "missing" and len(value) > envelopes.MOST_MISSING:
        raise EnvelopeError(f"it says of {len(value)} places that they are missing")
    wanted = int if name == "missing" else str
    if not all(item.__class__ is wanted for item in value):
        raise EnvelopeError(f"its {name} is not a list of {wanted.__name__}")
    return tuple(value)


# ---- external agents ---------------------------------------------------------------------------

_FIPA = {
    "language": "language",
    "encoding": "encoding",
    "ontology": "ontology",
    "protocol": "protocol",
    "conversation-id": "conversation",
    "reply-with": "reply_with",
    "in-reply-to": "in_reply_to",
}
_FURTHER = {"performative", "reply-to", "reply-by", OURS}


def said(message: FipaMessage) -> tuple[dict[str, str], str]:
    """The headers and the text of a message to an external agent. Bytes are sent as far as they are UTF-8."""
    headers = {"performative": message.performative}
    for header, name in _FIPA.items():
        value = getattr(message, name)
        if value:
            headers[header] = value
    if message.reply_to:
        headers["reply-to"] = " ".join(item.name for item in message.reply_to)
    if isinstance(message.reply_by, datetime):
        headers["reply-by"] = message.reply_by.isoformat()
    elif message.reply_by is not None:
        headers["reply-by"] = moment_text(message.reply_by).decode()
    headers |= {name: value for name, value in message.parameters if isinstance(value, str)}
    content = message.content
    if isinstance(content, bytes):
        content = content.decode("utf-8", "replace")
    return headers, content or ""


def heard(sender: str, to: str, headers: Headers, body: str) -> FipaMessage:
    """The message of an external agent: what it does not say is empty. What FIPA does not know is kept as
    it was, and so is a deadline that is not a moment.
    """
    by = _moment(headers.get("reply-by", ""))
    unread = set(headers) - _FIPA.keys() - _FURTHER
    if "reply-by" in headers and by is None:
        unread.add("reply-by")
    return FipaMessage(
        headers.get("performative", ""),
        AgentIdentifier(sender),
        (AgentIdentifier(to),),
        body,
        tuple(AgentIdentifier(name) for name in headers.get("reply-to", "").split()),
        reply_by=by,
        parameters=tuple((name, value) for name, value in headers.items() if name in unread),
        **{name: headers[header] for header, name in _FIPA.items() if header in headers},
    )


_DURATION = re.compile(
    r"P(?:(\d{1,4})Y)?(?:(\d{1,2})M)?(?:(\d{1,2})D)?"
    r"(?:T(?:(\d{1,4})H)?(?:(\d{1,6})M)?(?:(\d{1,8})(?:[.,](\d{1,3}))?S)?)?",
    re.ASCII,
)


def _moment(text: str) -> datetime | Span | None:
    """A moment or span as FIPA writes it, or a date or duration of ISO 8601; None for anything else."""
    with suppress(AclTextError):
        return read_moment(text)
    with suppress(ValueError):
        return datetime.fromisoformat(text)
    found = _DURATION.fullmatch(text)
    if found is None or not any(found.groups()):
        return None
    years, months, days, hours, minutes, seconds = (int(part or 0) for part in found.groups()[:6])
    milli = int((found[7] or "").ljust(3, "0"))
    return Span(years, months, days, ((hours * 60 + minutes) * 60 + seconds) * 1000 + milli)
