"""Agent messages with the parameters of FIPA's Agent Communication Language (SC00061).

Between the agents of a team goes an `AclMessage`, whose content is a message of the document and whose sender
and receivers have parts in a protocol. An agent that is not of the team knows nothing of that: to and from it
goes a `FipaMessage`, which has the same parameters as FIPA has them.
"""

from __future__ import annotations

from datetime import datetime

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Identity, made_often
from aseme_dsl.runtime.message.performatives import NOT_UNDERSTOOD as NOT_UNDERSTOOD
from aseme_dsl.runtime.message.performatives import PERFORMATIVES as PERFORMATIVES

JSON = "json"
"""The language of a content, where it goes as text: a JSON object with a member for each of the message's."""


def fipa_name(performative: str) -> str:
    """A performative as FIPA spells it: `accept-proposal`."""
    return performative.replace("_", "-")


def performative_of(name: str) -> str | None:
    """A performative as a document writes it, from FIPA's spelling in any case; None if FIPA has no such."""
    found = name.lower().replace("-", "_")
    return found if found in PERFORMATIVES else None


REGISTERED = {
    "request": "fipa-request",  # SC00026
    "query": "fipa-query",  # SC00027
    "request_when": "fipa-request-when",  # SC00028
    "contract_net": "fipa-contract-net",  # SC00029
    "iterated_contract_net": "fipa-iterated-contract-net",  # SC00030
    "auction": "fipa-auction-english",  # XC00031
    "dutch_auction": "fipa-auction-dutch",  # XC00032
    "brokering": "fipa-brokering",  # SC00033
    "recruiting": "fipa-recruiting",  # SC00034
    "subscribe": "fipa-subscribe",  # SC00035
    "propose": "fipa-propose",  # SC00036
}
"""FIPA's protocols: what each is called in the library, and in the parameter `protocol` of a message."""
_OF_REGISTERED = {name: protocol for protocol, name in REGISTERED.items()}


def registered_name(protocol: str) -> str:
    """What a protocol is called on the wire; one that FIPA does not have keeps its name."""
    return REGISTERED.get(protocol, protocol)


def protocol_of(name: str) -> str:
    """What a protocol is called in a document, from its name on the wire: the inverse of `registered_name`.

    An identifier has no `-`, so no other protocol can have a registered name.
    """
    return _OF_REGISTERED.get(name.lower(), name)


def name_of(identity: Identity) -> str:
    """What a message is called by an answer to it: its `reply-with`, where its sender gives it no other."""
    return f"{identity[0]}-{identity[1]}"


@made_often
class AclMessage:
    """An agent message between agents that run the same document.

    `message` is the type of the content; `participant` and `to` are the sender's and the receivers' parts in
    the protocol. `receivers` are all who are sent it; what one of them gets may answer something of its own.
    """

    performative: str
    sender: str
    receivers: tuple[str, ...]
    message: str
    content: object
    protocol: str
    conversation: str
    participant: str
    to: str
    identity: Identity
    version: str = ""
    """The version of the protocol that the sender plays (`BranchInfo.version`)."""
    ontology: str = ""
    """The system, in whose document it is said what the content's names mean."""
    reply_with: str = ""
    """What an answer calls this message."""
    in_reply_to: str = ""
    """What the message is called that this one answers; empty: it answers none."""
    reply_by: int | None = None
    """Until when an answer is wanted, in ns of the run; None: that is not said."""
    reply_to: tuple[str, ...] = ()
    """Who is to get the answers, if not the sender."""
    language: str = JSON
    encoding: str = ""
    sent: int | None = None
    """When it was sent, in ns of the run of who has it; None: that is not known."""


@dataclass(frozen=True, slots=True)
class AgentIdentifier:
    """What an agent is known by: its name, where it can be reached, and who knows more (FIPA SC00023)."""

    name: str
    addresses: tuple[str, ...] = ()
    resolvers: tuple[AgentIdentifier, ...] = ()
    parameters: tuple[tuple[str, object], ...] = ()
    """Others, by name (`X-age`); values as in `FipaMessage.parameters`."""


@dataclass(frozen=True, slots=True)
class Span:
    """A time relative to now, as FIPA writes it; `sign` is 1 or -1."""

    years: int = 0
    months: int = 0
    days: int = 0
    milliseconds: int = 0
    sign: int = 1


class Word(str):
    """An expression that is a word, and stands without quotes."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class FipaMessage:
    """An agent message as any FIPA agent knows it. Parameters that are not given are empty.

    The performative is spelled as FIPA does (`accept-proposal`), and may be one that FIPA does not have.
    Content is bytes only where it is not UTF-8.
    """

    performative: str
    sender: AgentIdentifier | None = None
    receivers: tuple[AgentIdentifier, ...] = ()
    content: str | bytes | None = None
    reply_to: tuple[AgentIdentifier, ...] = ()
    language: str = ""
    encoding: str = ""
    ontology: str = ""
    protocol: str = ""
    conversation: str = ""
    reply_with: str = ""
    in_reply_to: str = ""
    reply_by: datetime | Span | None = None
    """A moment without a time zone is in local time."""
    parameters: tuple[tuple[str, object], ...] = ()
    """Others, by name (`X-message`): text, a `Word`, bytes, a number, a moment or a tuple of such."""
