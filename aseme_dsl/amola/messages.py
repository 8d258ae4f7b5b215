"""Messages: the types, messages, topics and functions that conditions and actions read and write."""

from __future__ import annotations

from enum import StrEnum

from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class Kind(StrEnum):
    """The kinds of value an expression can have."""

    BOOL = "bool"
    INT = "int"
    DOUBLE = "double"
    STRING = "string"
    BYTES = "bytes"
    DURATION = "duration"
    ENUM = "enum"
    MESSAGE = "message"
    OUTCOME = "outcome"
    """How the activity that names the type has ended; only conditions have such values."""
    AGENT = "agent"
    LIST = "list"
    """What a repeated member holds, and `[a, b]`: some values of one type, in their order."""


@dataclass(frozen=True, slots=True)
class Type:
    """A kind, with the name of the enum or message where it is one, or the type of a list's elements."""

    kind: Kind
    name: str = ""
    element: Type | None = None
    """Of a list; None for `[]`, which has no elements to tell."""

    @property
    def begins_unset(self) -> bool:
        """Whether a variable of this type holds nothing at first."""
        return self.kind in (Kind.AGENT, Kind.MESSAGE)

    def __str__(self) -> str:
        if self.element is not None:
            return f"list of {self.element}"
        return self.name or self.kind.value


BOOL = Type(Kind.BOOL)
INT = Type(Kind.INT)
DOUBLE = Type(Kind.DOUBLE)
STRING = Type(Kind.STRING)
BYTES = Type(Kind.BYTES)
DURATION = Type(Kind.DURATION)
AGENT = Type(Kind.AGENT)
"""An agent of the team: what a variable may hold, and no member of a message."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """`0..10`: the least and the greatest number that a variable may hold."""

    least: int | float
    most: int | float

    def __str__(self) -> str:
        return f"{self.least}..{self.most}"

    def hold(self, value: object) -> bool:
        """Whether a constant is between them."""
        return isinstance(value, int | float) and self.least <= value <= self.most


def list_of(element: Type | None) -> Type:
    """The type of a list of such elements."""
    return Type(Kind.LIST, element=element)


BUILT_IN = {str(t): t for t in (BOOL, INT, DOUBLE, STRING, BYTES, DURATION)}


class ChannelKind(StrEnum):
    """The papers' channel kind (`commType`): how long a message counts and for whom."""

    SIGNAL = "signal"
    STATE = "state"
    DATA = "data"


@dataclass(frozen=True, slots=True)
class EnumType:
    """An enumeration: constants with their numbers, in order. `imported` and `full_name` as for messages."""

    name: str
    constants: tuple[tuple[str, int], ...]
    span: Span
    imported: str | None = None
    full_name: str = ""

    def number(self, constant: str) -> int | None:
        return dict(self.constants).get(constant)


@dataclass(frozen=True, slots=True)
class Field:
    """A member of a message. `label` is "", "optional" or "repeated", as in Protocol Buffers."""

    name: str
    type: Type
    number: int
    label: str
    span: Span


@dataclass(frozen=True, slots=True)
class Message:
    """A Protocol Buffers message. `imported` is the .proto file it came from, if any.

    `full_name` is its name in that file (package and outer messages), else the name itself.
    """

    name: str
    fields: tuple[Field, ...]
    span: Span
    imported: str | None = None
    full_name: str = ""

    def field(self, name: str) -> Field | None:
        return next((item for item in self.fields if item.name == name), None)


@dataclass(frozen=True, slots=True)
class ProtoFile:
    """A .proto file that the system imports, or that such a file imports: what is needed on the wire.

    `name` is what imports call it; `descriptor` is its serialized FileDescriptorProto, `text` its source.
    """

    name: str
    descriptor: bytes
    text: str


@dataclass(frozen=True, slots=True, order=True)
class Channel:
    """What a message is published on: topic, channel kind and message type."""

    topic: str
    comm: ChannelKind
    message: str

    def __str__(self) -> str:
        return f"{self.topic}.{self.comm.value}.{self.message}"


@dataclass(frozen=True, slots=True)
class ChannelRules:
    """The settings of one channel in a topic (P2: the mechanism that controls updates).

    - `sources`: the roles, agents or activities that may publish; empty for no restriction.
    - `every`: the least time between two publications, in ns.
    - `queued`: a new signal does not replace an unread one.
    - `persist`: a state survives a restart.
    - `expires`: the age at which an untaken signal is dropped, in ns.
    """

    channel: Channel
    sources: tuple[str, ...]
    every: int | None
    queued: bool
    persist: bool
    span: Span
    expires: int | None = None


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic with its channels, the topic it is `under`, and the bytes a `radio` message of it may have.

    `delay` is how long such a message is on its way, in ns; None: that is not said.
    """

    name: str
    under: str | None
    radio: int | None
    channels: tuple[ChannelRules, ...]
    span: Span
    delay: int | None = None


@dataclass(frozen=True, slots=True)
class Parameter:
    """`goal : Place`: what an activity or a formula is given."""

    name: str
    type: Type
    span: Span

    def __str__(self) -> str:
        return f"{self.name} : {self.type}"


PROBE = "probe:"
"""The target of the function around a part of a condition whose value is to be told: play/coverage/."""


@dataclass(frozen=True, slots=True)
class Function:
    """A pure Python function for conditions; several of one name differ in their parameters' types."""

    name: str
    parameters: tuple[tuple[str, Type], ...]
    result: Type
    target: str  # "module:name"
    span: Span

    @property
    def is_of_document(self) -> bool:
        """Whether a document declares it: it may raise. What is built in, and a probe, never does."""
        return not self.target.startswith(("builtin:", PROBE))
