"""Messages to agents outside the team: by a call in this process, or by the transport."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.participation import remember
from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage
from aseme_dsl.runtime.transport.port import Transport

Hears = Callable[[FipaMessage], None]
"""The function that gives messages to an external agent in this process."""


class ExternalOutbox:
    """The ways to agents that are not of the team."""

    def __init__(self, told: ConversationTrace, transport: Transport) -> None:
        self._told = told
        self._transport = transport
        self._here: dict[str, Hears] = {}
        """The agents in this process that are not of the team."""
        self._asked: dict[str, str] = {}
        """The conversations of what was sent, by what an answer calls it, the newest last."""

    def add(self, name: str, hears: Hears) -> None:
        """An agent that is not of the team runs in this process."""
        self._here[name] = hears

    def asked(self, name: str) -> str:
        """The conversation of the message that an answer calls so; empty if none is known."""
        return self._asked.get(name, "")

    def carry(self, sender: str, message: FipaMessage, to: Iterable[AgentIdentifier]) -> None:
        """Have a message carried to an agent that is not of the team; tell if there is no route to it."""
        if message.conversation:
            remember(self._asked, message.reply_with, message.conversation)
        for receiver in to:
            hears = self._here.get(receiver.name)
            if hears is not None:
                hears(message)
            elif not self._transport.carry_outside(message, receiver):
                text = f"{message.performative} cannot be sent: there is no way to {receiver.name}"
                self._told.fault(sender, text)


__all__ = ["ExternalOutbox", "Hears"]
