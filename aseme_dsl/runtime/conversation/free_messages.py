"""Sending and delivering free messages: those that belong to no protocol of the system.

Behaviours that a user adds to an agent send and receive them. A message of a protocol never becomes a free
one, and the other way round: what a participant may send is said in its protocol alone.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import replace

from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.conversation import fipa_translation
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.moves import MoveError
from aseme_dsl.runtime.conversation.participation import remember
from aseme_dsl.runtime.message.acl import (
    JSON,
    AclMessage,
    AgentIdentifier,
    FipaMessage,
    name_of,
    performative_of,
)
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.message.free import ACLMessage, Text
from aseme_dsl.runtime.ports import Receiver
from aseme_dsl.runtime.time.clock import Clock

Mailbox = dict[Identity, ACLMessage]
"""The free messages that wait for an agent, the oldest first."""


class FreeMessages:
    """The free messages of a team. Its methods are called while the conversations are locked."""

    def __init__(
        self,
        told: ConversationTrace,
        clock: Clock,
        members: Members,
        bring: Callable[[str, AclMessage], None],
        outside: Callable[[str, FipaMessage, Iterable[AgentIdentifier]], None],
        refuse: Callable[[Receiver, AclMessage, str], None],
    ) -> None:
        self._told = told
        self._clock = clock
        self._members = members
        self._bring = bring
        self._outside = outside
        self._refuse = refuse
        self._boxes: dict[str, Mailbox] = {}
        self._known: dict[tuple[str, str], None] = {}
        """Conversations with external agents, and what was said in them, the newest last."""

    def box(self, name: str) -> Mailbox:
        """The mailbox of an agent here."""
        return self._boxes.setdefault(name, {})

    def protocol_of(self, protocol: str) -> str | None:
        """The protocol of the system that a message means by this name, if some agent plays it."""
        played = self._members.protocols() if protocol else ()
        return next((name for name in played if fipa_translation.plays(name, protocol)), None)

    def is_free(self, acl: AclMessage) -> bool:
        """Whether a message belongs to no protocol of the system."""
        return not acl.participant and not acl.to and self.protocol_of(acl.protocol) is None

    # ---- sending -----------------------------------------------------------------------------

    def send(self, agent: Receiver, message: ACLMessage) -> ACLMessage:
        """Send a message of a behaviour; what was sent, with its sender and what an answer calls it.

        Raises:
            MoveError: it is a message of a protocol or of its conversation: only a participant sends those.
            ValueError: it has no receiver, or its content is not a message of the system.
        """
        protocol = self.protocol_of(message.protocol)
        said = f"{message.performative} to {', '.join(message.receivers) or 'nobody'}"
        if protocol is not None:
            raise MoveError(
                f"a behaviour may not send {said}: {protocol} is a protocol of this system, whose messages"
                " its participants send"
            )
        if message.conversation_id in self._members.conversations:
            known = self._members.conversations[message.conversation_id].protocol
            raise MoveError(
                f"a behaviour may not send {said}: {message.conversation_id} is a conversation of {known}"
            )
        if not message.receivers:
            raise ValueError(f"{message.performative} has no receiver")
        kind = type(message.content).__name__
        if not isinstance(message.content, str) and agent.kinds and kind not in agent.kinds:
            raise ValueError(f"{kind} is not a message of {agent.plan.system}")
        identity = agent.identity()
        is_text = isinstance(message.content, str)
        acl = AclMessage(
            message.performative,
            agent.name,
            tuple(dict.fromkeys(message.receivers)),
            "" if is_text else kind,
            Text(message.content) if is_text else message.content,
            message.protocol,
            message.conversation_id,
            "",
            "",
            identity,
            "",
            message.ontology or agent.plan.system,
            message.reply_with or name_of(identity),
            message.in_reply_to,
            message.reply_by,
            message.reply_to,
            message.language or ("" if is_text else JSON),
        )
        self._told.sent(acl, ())
        for name in acl.receivers:
            if name in self._members.plans:
                self._bring(name, acl)
            else:
                self.carry_outside(acl, name)
        return replace(
            message,
            sender=agent.name,
            receivers=acl.receivers,
            reply_with=acl.reply_with,
            ontology=acl.ontology,
        )

    def carry_outside(self, acl: AclMessage, name: str, reason: str = "") -> None:
        """Have a message carried to an agent that is not of the team; text goes as it is."""
        content = acl.content
        text = content.text if isinstance(content, Text) else json.dumps(to_json(content), ensure_ascii=False)
        written = fipa_translation.written(
            acl,
            (AgentIdentifier(name),),
            reason,
            fipa_translation.fipa_moment(acl.reply_by, self._clock),
        )
        if not reason:
            written = replace(written, content=text, language=acl.language)
        self._note(("said", acl.reply_with))
        self._note(("in", acl.conversation))
        self._outside(acl.sender, written, (AgentIdentifier(name),))

    def _note(self, key: tuple[str, str]) -> None:
        if key[1]:
            self._known.pop(key, None)
            remember(self._known, key, None)

    # ---- delivering --------------------------------------------------------------------------

    def deliver(self, agent: Receiver, acl: AclMessage) -> None:
        """Give an agent a free message of the team."""
        self._give(agent, acl, lambda reason: self._refuse(agent, acl, reason))

    def _give(self, agent: Receiver, acl: AclMessage, refuse: Callable[[str], None]) -> None:
        content = acl.content
        message = ACLMessage(
            acl.performative,
            content.text if isinstance(content, Text) else agent.understood(content),
            acl.receivers,
            acl.protocol,
            acl.conversation,
            acl.ontology,
            "" if isinstance(content, Text) and acl.language == JSON else acl.language,
            acl.reply_with,
            acl.in_reply_to,
            acl.reply_by,
            acl.reply_to,
            acl.sender,
        )
        agent.hear(acl.identity, message, refuse)

    def is_known(self, message: FipaMessage) -> bool:
        """Whether an external agent answers a free message, or continues one's conversation."""
        if message.conversation in self._members.conversations:
            return False
        return ("said", message.in_reply_to) in self._known or ("in", message.conversation) in self._known

    def hear(
        self,
        agent: Receiver,
        message: FipaMessage,
        identity: Identity,
        by: int | None,
        refuse: Callable[[str], None],
    ) -> bool:
        """Give an agent what an external one says, if it may be a free message; whether it may."""
        performative = performative_of(message.performative)
        if performative is None or self.protocol_of(message.protocol) is not None:
            return False
        if isinstance(message.content, bytes) or not agent.listens:
            return False
        acl = AclMessage(
            performative,
            identity[0],
            (agent.name,),
            "",
            Text(message.content or ""),
            message.protocol,
            message.conversation,
            "",
            "",
            identity,
            "",
            message.ontology,
            message.reply_with,
            message.in_reply_to,
            by,
            tuple(item.name for item in message.reply_to if item.name),
            message.language or JSON,
        )
        self._note(("in", message.conversation))
        self._told.received(agent.name, acl)
        self._give(agent, acl, refuse)
        return True

    def clear(self, agent: Receiver, reason: str) -> None:
        """An agent has ended or left its plan: what waits for its behaviours is unexpected."""
        box = self._boxes.pop(agent.name, {})
        for identity, item in box.items():
            self._told.unread(agent.name, identity, item, reason or f"{agent.name} has ended")

    # ---- what waits --------------------------------------------------------------------------

    def unread(self) -> list[tuple[str, str, str, str, str, str]]:
        """What waits: receiver, "", conversation, performative, message and sender."""
        return [
            (name, "", item.conversation_id, item.performative, _kind(item.content), item.sender)
            for name, box in list(self._boxes.items())
            for item in list(box.values())
        ]


def _kind(content: object) -> str:
    return "text" if isinstance(content, str) else type(content).__name__


__all__ = ["FreeMessages", "Mailbox"]
