"""Free messages: agent messages outside of every protocol of the system, and templates that match them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import is_dataclass, replace
from typing import Any, NoReturn

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import performative_of

_TEXTS = ("protocol", "conversation_id", "ontology", "language", "reply_with", "in_reply_to", "sender")


@dataclass(frozen=True, slots=True)
class Text:
    """The content of a free message that is plain text."""

    text: str


@dataclass(frozen=True, slots=True)
class ACLMessage:
    """An agent message that a behaviour sends or has received; it cannot be changed.

    `content` is a text, or a message that the system declares. Who sends it is filled in when it is sent; so
    is `reply_with`, and `ontology` with the name of the system, where they are empty.
    """

    performative: str
    """As in the language (`accept_proposal`) or in FIPA's spelling (`accept-proposal`), in any case."""
    content: Any = ""
    receivers: tuple[str, ...] = ()
    protocol: str = ""
    conversation_id: str = ""
    ontology: str = ""
    language: str = ""
    reply_with: str = ""
    in_reply_to: str = ""
    reply_by: int | None = None
    """Until when an answer is wanted, in ns of the run."""
    reply_to: tuple[str, ...] = ()
    """Who is to get the answers, if not the sender."""
    sender: str = ""

    def __post_init__(self) -> None:
        """Raises TypeError or ValueError if the members do not make a message."""
        found = performative_of(self.performative) if isinstance(self.performative, str) else None
        if found is None:
            raise ValueError(f"FIPA has no performative {self.performative!r}")
        object.__setattr__(self, "performative", found)
        for name in ("receivers", "reply_to"):
            value = getattr(self, name)
            if isinstance(value, str) or not all(isinstance(item, str) and item for item in value):
                raise TypeError(f"{name} is a tuple of names like ('bob',), not {value!r}")
            object.__setattr__(self, name, tuple(value))
        for name in _TEXTS:
            if not isinstance(getattr(self, name), str):
                raise TypeError(f"{name} is a text, not {getattr(self, name)!r}")
        texts = [self.content, *self.receivers, *(getattr(self, name) for name in _TEXTS)]
        for text in texts:
            if isinstance(text, str):
                text.encode()  # half a character is not a text
        is_message = is_dataclass(self.content) and not isinstance(self.content, type)
        if not (isinstance(self.content, str) or is_message):
            raise TypeError(
                f"the content is a text or a message that the system declares, not {self.content!r}"
            )

    def create_reply(self, performative: str, content: object = "") -> ACLMessage:
        """The answer to this message: to its sender, in the same conversation."""
        return ACLMessage(
            performative,
            content,
            self.reply_to or ((self.sender,) if self.sender else ()),
            self.protocol,
            self.conversation_id,
            self.ontology,
            in_reply_to=self.reply_with,
        )

    def to(self, *receivers: str) -> ACLMessage:
        """The same message to these agents."""
        return replace(self, receivers=receivers)


@dataclass(frozen=True, slots=True)
class MessageTemplate:
    """Which messages a behaviour receives. Templates are combined by `&`, `|` and `~`.

    `match_performative("inform") & ~match_sender("bob")`. The functions `all_of`, `any_of` and `not_` do the
    same.
    """

    matches: Callable[[ACLMessage], bool]
    text: str = "a template"
    protocols: frozenset[str] | None = None
    """The protocols that it is limited to; None: it takes messages of any protocol and of none."""

    @staticmethod
    def match_all() -> MessageTemplate:
        """Every message."""
        return MessageTemplate(lambda message: True, "all")

    @staticmethod
    def match_performative(performative: str) -> MessageTemplate:
        """Messages of a performative. Raises ValueError if FIPA has no such."""
        wanted = performative_of(performative)
        if wanted is None:
            raise ValueError(f"FIPA has no performative {performative!r}")
        return MessageTemplate(lambda message: message.performative == wanted, f"performative {wanted}")

    @staticmethod
    def match_sender(name: str) -> MessageTemplate:
        """Messages of an agent."""
        return _equal("sender", name)

    @staticmethod
    def match_protocol(name: str) -> MessageTemplate:
        """Messages with this protocol, which no agent of the team plays."""
        found = _equal("protocol", name)
        return replace(found, protocols=frozenset((name,)))

    @staticmethod
    def match_conversation_id(name: str) -> MessageTemplate:
        """Messages of a conversation."""
        return _equal("conversation_id", name)

    @staticmethod
    def match_ontology(name: str) -> MessageTemplate:
        """Messages with an ontology."""
        return _equal("ontology", name)

    @staticmethod
    def match_language(name: str) -> MessageTemplate:
        """Messages with a content language."""
        return _equal("language", name)

    @staticmethod
    def match_in_reply_to(name: str) -> MessageTemplate:
        """Answers to the message that is called so by its `reply_with`."""
        return _equal("in_reply_to", name)

    @staticmethod
    def match_reply_with(name: str) -> MessageTemplate:
        """The message that answers call so."""
        return _equal("reply_with", name)

    @staticmethod
    def match_content(content: object) -> MessageTemplate:
        """Messages with exactly this content."""
        return MessageTemplate(lambda message: bool(message.content == content), f"content {content!r}")

    @staticmethod
    def match_message(kind: type[object]) -> MessageTemplate:
        """Messages whose content is of this class, by its name: a message of the system, or `str`."""
        name = kind.__name__
        return MessageTemplate(lambda message: type(message.content).__name__ == name, f"message {name}")

    @staticmethod
    def match(test: Callable[[ACLMessage], bool]) -> MessageTemplate:
        """Messages for which a function says so."""
        return MessageTemplate(test, f"match {getattr(test, '__name__', 'a function')}")

    def __and__(self, other: MessageTemplate) -> MessageTemplate:
        """Messages that both match."""
        protocols = (
            self.protocols
            if other.protocols is None
            else other.protocols
            if self.protocols is None
            else self.protocols & other.protocols
        )
        return MessageTemplate(
            lambda message: self.matches(message) and other.matches(message),
            f"({self.text} & {other.text})",
            protocols,
        )

    def __or__(self, other: MessageTemplate) -> MessageTemplate:
        """Messages that one of both matches."""
        free = self.protocols is None or other.protocols is None
        return MessageTemplate(
            lambda message: self.matches(message) or other.matches(message),
            f"({self.text} | {other.text})",
            None if free else (self.protocols or frozenset()) | (other.protocols or frozenset()),
        )

    def __invert__(self) -> MessageTemplate:
        """All other messages."""
        return MessageTemplate(lambda message: not self.matches(message), f"~{self.text}")

    def __bool__(self) -> NoReturn:
        """Raises TypeError: `and`, `or` and `not` of Python would lose one of the templates."""
        raise TypeError("templates are combined by `&`, `|` and `~`, not by `and`, `or` and `not`")


def all_of(*templates: MessageTemplate) -> MessageTemplate:
    """What all match."""
    found = MessageTemplate.match_all()
    for item in templates:
        found = found & item
    return found


def any_of(first: MessageTemplate, *others: MessageTemplate) -> MessageTemplate:
    """What one matches at least."""
    for item in others:
        first = first | item
    return first


def not_(template: MessageTemplate) -> MessageTemplate:
    """What it does not match."""
    return ~template


def _equal(field: str, value: str) -> MessageTemplate:
    """Messages of which a parameter has this value."""
    if not isinstance(value, str):
        raise TypeError(f"{field} is a text, not {value!r}")
    return MessageTemplate(lambda message: getattr(message, field) == value, f"{field} {value}")


__all__ = ["ACLMessage", "MessageTemplate", "Text", "all_of", "any_of", "not_"]
