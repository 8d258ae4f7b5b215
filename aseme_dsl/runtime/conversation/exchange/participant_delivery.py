"""Delivery of a message to the participant instance of its conversation; else it is unexpected."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from aseme_dsl.runtime.chart.inputs import AgentMessage
from aseme_dsl.runtime.chart.plan import BranchInfo
from aseme_dsl.runtime.conversation import fipa_translation
from aseme_dsl.runtime.conversation.conversation_trace import Cause, ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.exchange.busy import answer_of, is_busy
from aseme_dsl.runtime.conversation.exchange.external_outbox import ExternalOutbox
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.free_messages import FreeMessages
from aseme_dsl.runtime.conversation.losses import Losses
from aseme_dsl.runtime.conversation.participation import Conversation, Participation, remember
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage, AgentIdentifier, name_of
from aseme_dsl.runtime.ports import Links, Receiver
from aseme_dsl.runtime.time.clock import Clock
from aseme_dsl.runtime.transport.port import Transport

WAITING = 1000
"""So many messages wait at the most, at one agent, for a participant to be entered."""


class Delivery:
    """What brings messages to branches. Called with the lock of the conversations."""

    def __init__(
        self,
        members: Members,
        told: ConversationTrace,
        counting: Counting,
        outside: ExternalOutbox,
        transport: Transport,
        links: Callable[[], Links | None],
        queue: int,
        clock: Clock,
    ) -> None:
        """So many messages, `queue`, may wait for a participant; `links` are the simulated ones, if any."""
        self._members = members
        self._told = told
        self._counting = counting
        self._outside = outside
        self._transport = transport
        self._links = links
        self._queue = queue
        self._clock = clock
        self.losses = Losses(
            told, counting, members.agents, members.desks, members.plans, transport, links, self.bring
        )
        self.free = FreeMessages(told, clock, members, self.bring, outside.carry, self.unexpected)

    def bring(self, name: str, acl: AclMessage) -> None:
        """Deliver a message to an agent here, or have it carried to one elsewhere."""
        if name in self._members.agents:
            agent = self._members.agents[name]
            links = self._links()
            if links is None or name == acl.sender:
                self.deliver(agent, acl)
            else:
                links.carry(
                    acl.sender,
                    name,
                    "mail",
                    acl.conversation,
                    acl.identity,
                    partial(self.deliver, agent, acl),
                )
            return
        conversation = self._members.conversations.get(acl.conversation)
        if name in self._members.plans:
            self._transport.carry(acl, name, conversation.members if conversation is not None else {})
        else:
            known = conversation.outsiders if conversation is not None else {}
            to = known.get(name, (AgentIdentifier(name),))
            if conversation is not None:
                conversation.note(acl.reply_with, acl.performative, acl.message, name)
            by = fipa_translation.fipa_moment(acl.reply_by, self._clock)
            self._outside.carry(acl.sender, fipa_translation.written(acl, to, reply_by=by), to)

    def take_part(self, agent: Receiver, place: Participation, name: str, what: str) -> None:
        """A branch takes part in a conversation from now on; `what` it did: `open` or `join`."""
        place.conversation = name
        part = place.part
        self._members.desks[agent.name].free.get(part, {}).pop(place.info.label, None)
        conversation = self._members.conversations[name]
        conversation.places[agent.name, part[1]] = place
        members = conversation.members.setdefault(part[1], [])
        if agent.name not in members:
            members.append(agent.name)
        self._told.takes_part(what, agent.name, place, name)
        self.losses.joined(agent, place, name, conversation)
        desk = self._members.desks[agent.name]
        if place.info.busy is not None and desk.invitations.size and is_busy(agent, desk, place.info):
            while waiting := desk.invitations.take(part):
                for acl in waiting:
                    self._members.conversations[acl.conversation].invitations -= 1
                    self._turn_away(agent, place.info, acl)
                self.close(waiting[0].conversation)

    def deliver(self, agent: Receiver, acl: AclMessage) -> None:
        """Give a message to the branch that takes part; else to a free one, or let it wait for one."""
        if self.free.is_free(acl):
            self.free.deliver(agent, acl)
            return
        conversation = self._members.conversations.get(acl.conversation)
        place = conversation.places.get((agent.name, acl.to)) if conversation is not None else None
        if conversation is not None and conversation.is_exhausted:
            self.unexpected(agent, acl, self._limit_text())
            return
        if place is not None:
            if not receives(place.info, acl):
                self.unexpected(agent, acl, f"{acl.to} does not receive it")
            elif len(place.waiting) >= self._queue:
                self._refuse(agent, place, acl)
            else:
                self.post(agent, place, acl)
            return
        if conversation is None:
            self.unexpected(agent, acl, "the conversation is closed")
            return
        if (agent.name, acl.to) in conversation.past:
            self.unexpected(agent, acl, "its part in the conversation is over")
            return
        played = [
            info
            for info in agent.plan.branches
            if (info.protocol, info.participant) == (acl.protocol, acl.to)
        ]
        if played and not self._members.plays_alike(played[0].version, acl.version):
            reason = f"{acl.sender} plays another version of {acl.protocol}"
            self._turn_away_incompatible(agent, acl, conversation, reason)
            return
        if self._members.held and not self._members.desks[agent.name].invitations.has(
            (acl.protocol, acl.to), acl.conversation
        ):
            self._turn_away_incompatible(agent, acl, conversation, self._members.held)
            return
        info = next((info for info in played if receives(info, acl)), None)
        if info is None or agent.over:
            reason = f"{agent.name} has ended" if agent.over else f"{agent.role} does not receive it"
            self.unexpected(agent, acl, reason)
            return
        desk = self._members.desks[agent.name]
        invitations = desk.invitations
        if invitations.size >= WAITING:
            self.unexpected(agent, acl, f"{WAITING} messages wait already for a participant to be entered")
            return
        part = acl.protocol, acl.to
        is_invited = invitations.has(part, acl.conversation)
        if not is_invited and (acl.performative, acl.message) not in info.opens:
            if acl.sender not in self._members.plans:
                self.unexpected(agent, acl, f"{acl.to} does not begin with it")
                return
            # What opens the conversation may be on its way from another agent.
            invitations.add_early(part, acl)
            conversation.invitations += 1
            return
        place = desk.first_free(part)
        if place is not None and not is_invited:
            self.take_part(agent, place, acl.conversation, "join")
            self.post(agent, place, acl)
            for early in invitations.take_early(acl.conversation, part):
                conversation.invitations -= 1
                self.post(agent, place, early)
            return
        if not is_invited and is_busy(agent, desk, info):
            if info.busy is not None:
                self._turn_away(agent, info, acl)
                return
            waits = Participation(info, acl.conversation)
            self._told.takes_part("queue", agent.name, waits, acl.conversation, peer=acl.sender)
        invitations.add(part, acl)
        conversation.invitations += 1

    def _turn_away(self, agent: Receiver, info: BranchInfo, acl: AclMessage) -> None:
        """Answer an invitation that comes while all instances are in use: that part is over at once.

        What else has waited in its conversation is unexpected.
        """
        conversation = self._members.conversations[acl.conversation]
        reason = f"{agent.name} is in use as {acl.to} already"
        place = Participation(info, acl.conversation)
        is_first = (agent.name, acl.to) not in conversation.past
        answer = answer_of(agent, info, acl)
        if is_first:
            self._told.takes_part("busy", agent.name, place, acl.conversation, peer=acl.sender)
        if answer is None or not is_first or (acl.performative, acl.message) not in info.opens:
            self.unexpected(agent, acl, reason)
        elif not self.spend(agent, acl.conversation):
            self._answer(agent, acl, *answer, cause="busy")
        if is_first and not conversation.is_exhausted:
            self.losses.ended(agent, place, acl.conversation, conversation, "completed")

    def _turn_away_incompatible(
        self, agent: Receiver, acl: AclMessage, conversation: Conversation, reason: str
    ) -> None:
        """A message of another version of the protocol, or for an agent that is held.

        Who would learn of a loss loses the agent, others hear `not_understood`.
        """
        place = conversation.places.get((acl.sender, acl.participant))
        if place is None or acl.to not in (*place.info.loses, *place.info.counts):
            self.unexpected(agent, acl, reason)
            return
        self._told.unexpected(agent.name, acl, reason)
        self.losses.over(conversation, acl.conversation, agent.name, acl.to, "incompatible")

    def refused(self, agent: Receiver, answer: AclMessage, reason: str) -> None:
        """A message was refused by the build of its receiver; `answer` is `not_understood` of that agent."""
        if self.free.is_free(answer):
            self.free.deliver(agent, answer)
            return
        conversation = self._members.conversations.get(answer.conversation)
        place = conversation.places.get((agent.name, answer.to)) if conversation is not None else None
        if conversation is None or place is None:
            self._told.unexpected(agent.name, answer, reason)
        elif answer.participant in (*place.info.loses, *place.info.counts):
            name, part = answer.sender, answer.participant
            if (name, part) not in conversation.past:
                self.losses.over(conversation, answer.conversation, name, part, "incompatible")
        elif receives(place.info, answer):
            self.spend(agent, answer.conversation)
            self.post(agent, place, answer)
        else:
            self._told.unexpected(agent.name, answer, reason)

    def spend(self, agent: Receiver, name: str) -> str:
        """Count a message of a conversation; why it may not have it, empty if it may.

        With the first that it may not have, the conversation is over for all.
        """
        conversation = self._members.conversations.get(name)
        if conversation is None:
            return ""
        if conversation.left == 0:
            self._told.fault(agent.name, f"conversation {name} is over: {self._limit_text()}")
            self.exhaust(name, conversation)
        elif conversation.left > 0:
            conversation.left -= 1
            return ""
        return self._limit_text()

    def exhaust(self, name: str, conversation: Conversation) -> None:
        """A conversation has had all its messages: all parts in it are over."""
        if not conversation.is_exhausted:
            conversation.left = -1
            self.losses.exhausted(name, conversation)

    def _limit_text(self) -> str:
        return f"the conversation has had {self._members.limit} messages, its limit"

    def post(self, agent: Receiver, place: Participation, acl: AclMessage) -> None:
        """Let a message wait for its branch, and be an input of the agent."""
        mail = AgentMessage(
            place.info.label,
            acl.performative,
            acl.message,
            agent.understood(acl.content),
            acl.participant,
            acl.sender,
            acl.identity,
            acl.reply_with,
            acl.reply_by,
            acl.in_reply_to,
            acl.sent,
        )
        place.waiting[acl.identity] = mail
        agent.post(acl.identity, mail, conversation=acl.conversation)

    def _refuse(self, agent: Receiver, place: Participation, acl: AclMessage) -> None:
        """Too many messages wait already that the participant does not take."""
        if not place.was_full:
            place.was_full = True
            text = f"{self._queue} messages wait for {acl.to} of {agent.name} and are not taken"
            self._told.fault(agent.name, f"{text}: what comes now is refused")
        self.unexpected(agent, acl, f"{self._queue} messages wait already for {acl.to}")

    def unexpected(self, agent: Receiver, acl: AclMessage, reason: str) -> None:
        """Record an unexpected message and answer it, but never an answer to that."""
        self._told.unexpected(agent.name, acl, reason)
        self._counting.unexpected(agent, self._members.conversations.get(acl.conversation), acl)
        if acl.performative != NOT_UNDERSTOOD and not self.spend(agent, acl.conversation):
            self._answer(agent, acl, NOT_UNDERSTOOD, acl.message, acl.content, reason, cause="unexpected")

    def _answer(
        self,
        agent: Receiver,
        acl: AclMessage,
        performative: str,
        message: str,
        content: object,
        reason: str = "",
        *,
        cause: Cause,
    ) -> None:
        """Answer a message that no branch takes; an external agent learns the reason, if there is one."""
        identity = agent.identity()
        answer = AclMessage(
            performative,
            agent.name,
            (acl.sender,),
            message,
            content,
            acl.protocol,
            acl.conversation,
            acl.to,
            acl.participant,
            identity,
            acl.version,
            acl.ontology,
            name_of(identity),
            acl.reply_with,
            sent=self._members.directory.clock.now(),
        )
        self._told.sent(answer, [acl.identity], cause)
        if acl.sender in self._members.plans:
            self.bring(acl.sender, answer)
            return
        conversation = self._members.conversations.get(acl.conversation)
        known = conversation.outsiders if conversation is not None else {}
        to = known.get(acl.sender, (AgentIdentifier(acl.sender),))
        if conversation is not None:
            conversation.note(answer.reply_with, performative, message, acl.sender)
        self._outside.carry(agent.name, fipa_translation.written(answer, to, reason), to)

    def finds(self, agent: Receiver, mail: AgentMessage, conversation: str | None) -> bool:
        """Whether an agent message still finds its participant."""
        place = self._members.desks[agent.name].branches.get(mail.branch)
        return conversation is None or (place is not None and place.conversation == conversation)

    def was_returned(self, agent: Receiver, mail: AgentMessage) -> bool:
        """Whether a message was answered when the part ended in which it waited."""
        return mail.identity in self._members.desks[agent.name].returned

    def give_back(self, agent: Receiver, mail: AgentMessage, conversation: str, reason: str) -> None:
        """A message that has reached a branch will not be taken: it is unexpected."""
        info = agent.branch_info(mail.branch)
        acl = AclMessage(
            mail.performative,
            mail.sender,
            (agent.name,),
            mail.message,
            mail.content,
            info.protocol,
            conversation,
            mail.participant,
            info.participant,
            mail.identity,
            info.version,
            agent.plan.system,
            mail.reply_with,
        )
        self.unexpected(agent, acl, reason)

    def close(self, name: str) -> None:
        """Forget a conversation in which no agent takes part or may still do so."""
        conversation = self._members.conversations.get(name)
        if conversation is None or conversation.places:
            return
        if conversation.invitations and not self._transport.networked:
            self._refuse_early(name, conversation)
        if conversation.invitations or name not in self._members.conversations:
            return
        del self._members.conversations[name]
        if self._transport.networked or conversation.outsiders:
            remember(self._members.over, name, conversation.past)

    def _refuse_early(self, name: str, conversation: Conversation) -> None:
        """No agent can send what opens a conversation any more: answer what waits for that."""
        for agent, desk in self._members.desks.items():
            for acl in desk.invitations.take_early(name):
                conversation.invitations -= 1
                self.unexpected(self._members.agents[agent], acl, f"{acl.to} does not begin with it")


def receives(info: BranchInfo, acl: AclMessage) -> bool:
    """Whether a branch lists a message as received."""
    return (acl.performative, acl.message) in info.receives


__all__ = ["Delivery", "receives"]
