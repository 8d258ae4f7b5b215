"""Messages from agents outside the team: understood and handed on like any other, or refused."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import replace

from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.conversation import fipa_translation
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.exchange.external_outbox import ExternalOutbox
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery
from aseme_dsl.runtime.conversation.participation import Conversation
from aseme_dsl.runtime.message.acl import (
    NOT_UNDERSTOOD,
    AclMessage,
    FipaMessage,
    name_of,
    performative_of,
)
from aseme_dsl.runtime.ports import Receiver
from aseme_dsl.runtime.time.clock import Clock


class ExternalInbox:
    """What is received from agents that are not of the team. Called with the lock of the conversations."""

    def __init__(
        self,
        members: Members,
        told: ConversationTrace,
        counting: Counting,
        delivery: Delivery,
        outside: ExternalOutbox,
        clock: Clock,
        behind: int,
    ) -> None:
        """What is heard is numbered from `behind` on."""
        self._members = members
        self._told = told
        self._counting = counting
        self._delivery = delivery
        self._outside = outside
        self._clock = clock
        self._numbers = itertools.count(behind + 1)

    def receive(self, to: str, message: FipaMessage) -> None:
        """An agent that is not of the team has sent a message to one of ours. May be called from any thread.

        It is handed on like any other if it is understood. Else the trace records why not, and it is answered
        `not_understood`.
        """
        agent = self._members.agents.get(to)
        sender = message.sender.name if message.sender is not None else ""
        identity = sender, next(self._numbers)
        if agent is None:
            self._not_understood(to, message, identity, f"there is no agent {to} here")
        elif not sender:
            self._not_understood(to, message, identity, "it does not say who has sent it")
        elif sender in self._members.plans:
            reason = f"an agent of the team is called {sender}, and this is none of its messages"
            self._not_understood(to, message, identity, reason)
        elif message.reply_with and self._members.desks[to].was_heard((sender, *_said_outside(message))):
            self._not_understood(to, message, identity, "it was received before", answered=False)
        else:
            self._hear(agent, message, sender, identity)

    def _hear(self, agent: Receiver, message: FipaMessage, sender: str, identity: Identity) -> None:
        """Hand on a message of an external agent, if it is understood."""
        if self._delivery.free.is_known(message) and self._hear_free(agent, message, identity, ""):
            return
        name = ""
        try:
            name = message.conversation or self._conversation_of(agent, message, sender)
            name = name or f"{sender}-{identity[1]}"
            conversation = self._members.conversations.get(name)
            found = self._understood(agent, message, sender, name, conversation)
        except fipa_translation.NotUnderstood as problem:
            is_free = name not in self._members.conversations
            if not (is_free and self._hear_free(agent, message, identity, str(problem))):
                self._not_understood(agent.name, message, identity, str(problem))
            return
        by = self._deadline(agent, message, sender)
        info = found.infos[0]
        acl = AclMessage(
            found.performative,
            sender,
            (agent.name,),
            found.message,
            found.content,
            info.protocol,
            name,
            found.participant,
            info.participant,
            identity,
            info.version,
            message.ontology,
            message.reply_with,
            message.in_reply_to,
            by,
        )
        self._told.received(agent.name, acl)
        conversation = self._members.known(name, info.protocol)
        self._delivery.spend(agent, name)
        members = conversation.members.setdefault(found.participant, [])
        _, most = info.size_of(found.participant)
        if message.sender is not None:
            conversation.outsiders[sender] = message.reply_to or (message.sender,)
        if sender not in members and most is not None and len(members) >= most:
            self._delivery.unexpected(
                agent, acl, f"{', '.join(members)} takes part as {found.participant} already"
            )
        elif sender not in members and found.participant in conversation.chosen:
            self._delivery.unexpected(agent, acl, f"{sender} does not take part as {found.participant}")
        elif reason := self._answers_nothing(message, sender, conversation):
            self._delivery.unexpected(agent, acl, reason)
        else:
            if sender not in members:
                members.append(sender)
            self._delivery.deliver(agent, acl)
        self._delivery.close(name)

    def _hear_free(self, agent: Receiver, message: FipaMessage, identity: Identity, problem: str) -> bool:
        """Give a message that no participant understands to the agent's behaviours, if they may have it."""
        return self._delivery.free.hear(
            agent,
            message,
            identity,
            self._deadline(agent, message, identity[0]),
            lambda reason: self._not_understood(agent.name, message, identity, problem or reason),
        )

    def _conversation_of(self, agent: Receiver, message: FipaMessage, sender: str) -> str:
        """The conversation of a message that names none; empty: it begins one.

        It is that of the message it answers. If it names none either, and it can begin none, it is the only
        one in which its sender takes part and the agent receives such a message.

        Raises:
            NotUnderstood: it may be one of several.
        """
        if message.in_reply_to:
            return self._outside.asked(message.in_reply_to)
        performative = performative_of(message.performative)
        named = fipa_translation.parameter(message, fipa_translation.MESSAGE)

        def has(kinds: Iterable[tuple[str, str]]) -> bool:
            return any(act == performative and named in ("", kind) for act, kind in kinds)

        infos = fipa_translation.played_as(message.protocol, agent.plan.branches)
        if any(has(info.opens) for info in infos):
            return ""
        found = [
            name
            for name, conversation in self._members.conversations.items()
            if any(sender in names for names in conversation.members.values())
            and any(
                who == agent.name and place.info in infos and has(place.info.receives)
                for (who, _), place in conversation.places.items()
            )
        ]
        if len(found) > 1:
            raise fipa_translation.NotUnderstood(
                f"it may belong to {' or '.join(found[:10])}: conversation-id or in-reply-to says to which"
            )
        return found[0] if found else ""

    def _understood(
        self,
        agent: Receiver,
        message: FipaMessage,
        sender: str,
        name: str,
        conversation: Conversation | None,
    ) -> fipa_translation.Understood:
        """What a message of an external agent means in a conversation. Raises NotUnderstood."""
        branches = agent.plan.branches
        if conversation is None:
            protocol = message.protocol
            infos = fipa_translation.played_as(protocol, branches)
            performative = performative_of(message.performative)
            first = tuple(info for info in infos if any(act == performative for act, _ in info.opens))
            # A type that does not begin one is understood only where none does.
            groups = tuple(replace(info, receives=info.opens) for info in first), tuple(infos)
            context = fipa_translation.Context(groups)
        else:
            protocol = conversation.protocol
            if not fipa_translation.plays(protocol, message.protocol or protocol):
                raise fipa_translation.NotUnderstood(f"the conversation is one of {protocol}")
            infos = [info for info in branches if info.protocol == protocol]
            inside = tuple(place.info for (who, _), place in conversation.places.items() if who == agent.name)
            rest = tuple(info for info in infos if info not in inside)
            parts = [part for part, names in conversation.members.items() if sender in names]
            said = conversation.said_outside
            answered = said.get(message.in_reply_to)
            context = fipa_translation.Context(
                (inside, rest),
                parts[0] if len(parts) == 1 else "",
                None if answered is None else (answered.performative, answered.message),
                tuple(
                    (item.performative, item.message) for item in said.values() if sender in item.receivers
                ),
            )
        if not infos:
            raise fipa_translation.NotUnderstood(
                f"{agent.name} plays no part in {protocol[:100] or 'a protocol'}"
            )
        return fipa_translation.understood(message, agent.plan, context, agent.kinds)

    def _answers_nothing(self, message: FipaMessage, sender: str, conversation: Conversation) -> str:
        """Why the message that an external agent claims to answer was not sent to it; empty if it was."""
        answered = message.in_reply_to
        if not answered or conversation.forgotten:
            return ""
        said = conversation.said_outside.get(answered)
        if said is not None and sender in said.receivers:
            return ""
        speaker = answered.rpartition("-")[0]
        if said is None and speaker in self._members.plans and speaker not in self._members.agents:
            return ""  # only the agent's own process knows
        return f"{sender} was sent no {answered[:100]} in this conversation, which it answers"

    def _deadline(self, agent: Receiver, message: FipaMessage, sender: str) -> int | None:
        """Until when an external agent wants an answer; None, and recorded, if that cannot be read."""
        try:
            return fipa_translation.deadline(message, self._clock)
        except ValueError as problem:
            what = f"{message.performative} of {sender} is taken without its deadline"
            self._told.fault(agent.name, f"{what}: {problem} (reply-by)")
            return None

    def _not_understood(
        self, to: str, message: FipaMessage, identity: Identity, reason: str, *, answered: bool = True
    ) -> None:
        """Record a message of an external agent that has no receiver, and answer it."""
        self._told.meaningless(to, message, identity, reason)
        conversation = self._members.conversations.get(
            message.conversation or self._outside.asked(message.in_reply_to)
        )
        forged = identity[0] in self._members.plans  # whose name it bears has not answered
        if answered and conversation is not None and to in self._members.agents and not forged:
            self._counting.meaningless(
                self._members.agents[to], conversation, identity[0], message.in_reply_to
            )
        if (
            answered
            and message.sender is not None
            and performative_of(message.performative) != NOT_UNDERSTOOD
        ):
            agent = self._members.agents.get(to)
            if agent is not None and self._delivery.spend(agent, message.conversation):
                return
            own = agent.identity() if agent is not None else (to, next(self._numbers))
            answer = fipa_translation.answer(message, to, NOT_UNDERSTOOD, reason, name_of(own))
            self._told.answered_outside(answer, own, identity)
            if conversation is not None:
                conversation.note(answer.reply_with, NOT_UNDERSTOOD, "", identity[0])
            self._outside.carry(to, answer, answer.receivers)


def _said_outside(message: FipaMessage) -> tuple[object, ...]:
    """What tells one message of an external agent from the next."""
    return message.reply_with, message.conversation, message.performative.lower(), message.content


__all__ = ["ExternalInbox"]
