"""Losses: the agents of a conversation learn that the part of another is over, and why."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from aseme_dsl.runtime.chart.inputs import LOST, REASONS, AgentMessage, Identity, Reason
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.participation import REMEMBERED, Conversation, Desk, Participation
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage, name_of
from aseme_dsl.runtime.ports import Links, Receiver
from aseme_dsl.runtime.transport.port import Transport

FAREWELLS = ("cancel", "failure", "refuse", "reject_proposal")
"""What an agent is sent when a part ends early: the first of these that the protocol has for it."""
ASKING = frozenset("cfp propose proxy query_if query_ref request request_when subscribe".split())
"""What is to be answered."""


class Losses:
    """What conversations do when an agent's part ends in any way. Called with their lock."""

    def __init__(
        self,
        told: ConversationTrace,
        counting: Counting,
        agents: Mapping[str, Receiver],
        desks: Mapping[str, Desk],
        plans: Mapping[str, Plan],
        transport: Transport,
        links: Callable[[], Links | None],
        send: Callable[[str, AclMessage], None],
    ) -> None:
        """`send` sends one message to an agent that is not here; `links` are the simulated ones, if any."""
        self._told = told
        self._counting = counting
        self._agents = agents
        self._desks = desks
        self._plans = plans
        self._transport = transport
        self._links = links
        self._send = send
        self._owed: dict[str, list[tuple[AclMessage, dict[str, tuple[str, ...]]]]] = {}
        """The ends of parts, for agents elsewhere that come back."""

    def ended(
        self, agent: Receiver, place: Participation, name: str, conversation: Conversation, reason: Reason
    ) -> None:
        """The part of an agent of this process is over; all agents in its conversation learn it."""
        part = place.info.participant
        self.over(conversation, name, agent.name, part, reason)
        for to, theirs in _others(conversation, agent.name):
            if self._needs_word(to, theirs, place, conversation, reason):
                self._bid_farewell(agent, place, name, to, theirs)
            if to not in self._plans or to in self._agents:
                continue
            if reason != "completed" or self._awaits(to, place.info.protocol, theirs, part):
                loss = _message(agent, place, name, to, theirs, LOST, reason, None)
                self._transport.carry(loss, to, conversation.members)
        for to, theirs in sorted(conversation.absent):
            if reason != "completed" or self._awaits(to, place.info.protocol, theirs, part):
                owed = self._owed.setdefault(to, [])
                loss = _message(agent, place, name, to, theirs, LOST, reason, None)
                owed.append((loss, {key: tuple(names) for key, names in conversation.members.items()}))
                del owed[:-REMEMBERED]

    def unanswered(
        self, agent: Receiver, place: Participation, conversation: Conversation, reason: Reason
    ) -> dict[Identity, AgentMessage]:
        """What waits in a part that ends and is answered `not_understood`: its sender learns nothing else.

        Who waits for the end of this part learns of it by `lost`, others by a farewell. The last message of a
        part, sent in the step in which it ends, is an answer, too.
        """
        if reason == "crashed" or conversation.is_exhausted:
            return {}
        part = place.info.participant
        found: dict[Identity, AgentMessage] = {}
        for identity, mail in place.waiting.items():
            who, theirs = mail.sender, mail.participant
            if mail.performative in (LOST, NOT_UNDERSTOOD) or (who, theirs) in conversation.past:
                continue
            if who in place.farewell or place.spoken.get(who) == agent.steps:
                continue
            if who in self._plans and self._awaits(who, place.info.protocol, theirs, part):
                continue
            is_told = self._needs_word(who, theirs, place, conversation, reason)
            if not is_told or self._farewell_to(place, who, theirs) is None:
                found[identity] = mail
        return found

    def exhausted(self, name: str, conversation: Conversation) -> None:
        """A conversation has had all the messages that it may have: all parts are over."""
        for (who, _), place in list(conversation.places.items()):
            for other, theirs in _others(conversation, who):
                if theirs not in place.info.loses:
                    self._told.takes_part("gone", who, place, name, peer=other, reason="exhausted")
        for (who, part), place in list(conversation.places.items()):
            if (who, part) not in conversation.past:
                self.ended(self._agents[who], place, name, conversation, "exhausted")
        for part, agents in list(conversation.members.items()):
            for who in agents:
                if (who, part) not in conversation.past:
                    self.over(conversation, name, who, part, "exhausted")

    def returned(self, name: str, *, same: bool) -> None:
        """An agent elsewhere can be reached again; the same incarnation gets what it has missed."""
        for loss, members in self._owed.pop(name, ()):
            if same:
                self._transport.carry(loss, name, members)

    def over(self, conversation: Conversation, name: str, who: str, part: str, reason: Reason) -> None:
        """An agent's part is over, wherever it runs; the agents of this process learn it."""
        conversation.past[who, part] = reason
        for (to, _), place in list(conversation.places.items()):
            if to != who:
                self.tell(self._agents[to], place, name, who, part, reason)
        if reason != "completed":
            self._withdraw(conversation, name, who, reason)

    def tell(
        self, agent: Receiver, place: Participation, name: str, who: str, part: str, reason: Reason
    ) -> None:
        """A branch learns of a lost agent, if a transition waits for that or a condition counts its
        answers."""
        if part not in place.info.counts and part not in place.info.loses:
            return
        give = partial(self._learn, agent, place, name, who, part, reason)
        links = self._links()
        if links is None or who not in self._agents:
            give()
        else:  # behind what it has sent before
            links.carry(who, agent.name, "mail", LOST, agent.identity(), give)

    def _learn(
        self, agent: Receiver, place: Participation, name: str, who: str, part: str, reason: Reason
    ) -> None:
        """What an agent has sent before has come: now it counts as one that answers no more, and is lost."""
        if part in place.info.counts and place.conversation == name:
            self._counting.settled(agent, place, part, who)
        if part in place.info.loses:
            self._give(agent, place, name, who, part, reason)

    def _give(
        self, agent: Receiver, place: Participation, name: str, who: str, part: str, reason: Reason
    ) -> None:
        if place.conversation != name or self._desks[agent.name].branches.get(place.info.label) is not place:
            return
        if reason == "completed" and _waits_from(place, who):
            place.completed += ((who, part),)
            return
        identity = agent.identity()
        mail = AgentMessage(place.info.label, LOST, "", reason, part, who, identity)
        self._told.takes_part(
            "gone", agent.name, place, name, peer=who, played=part, identity=identity, reason=reason
        )
        place.waiting[identity] = mail
        agent.post(identity, mail, conversation=name)

    def consumed(self, agent: Receiver, place: Participation) -> None:
        """A message was taken: who has completed, and of whom nothing waits any more, is lost now."""
        for item in place.completed:
            if not _waits_from(place, item[0]):
                place.completed = tuple(other for other in place.completed if other != item)
                self._give(agent, place, place.conversation or "", *item, "completed")

    def joined(self, agent: Receiver, place: Participation, name: str, conversation: Conversation) -> None:
        """A branch takes part from now on: it learns whose part is over already."""
        for (who, part), reason in list(conversation.past.items()):
            if part in place.info.loses and who != agent.name:
                self.tell(agent, place, name, who, part, reason)

    def _withdraw(self, conversation: Conversation, name: str, who: str, reason: Reason) -> None:
        """What an agent has sent, and no agent has joined for yet, opens nothing any more."""
        for to, desk in self._desks.items():
            for acl in desk.invitations.withdraw(name, who):
                conversation.invitations -= 1
                self._told.unexpected(to, acl, f"{who} has left the conversation: {reason}")

    def _awaits(self, agent: str, protocol: str, own: str, part: str) -> bool:
        """Whether an agent elsewhere has a transition for that a part has ended."""
        infos = self._infos(agent, protocol, own)
        return any(part in info.loses or part in info.counts for info in infos)

    def _needs_word(
        self, to: str, theirs: str, place: Participation, conversation: Conversation, reason: Reason
    ) -> bool:
        """Whether an agent learns that a part is over only by a message of the protocol."""
        hears = any(act != NOT_UNDERSTOOD for act, _ in place.info.receives)
        is_asked = hears and place.told.get(to) in ASKING and to not in place.answered
        if to in place.farewell or (reason == "completed" and not is_asked):
            return False
        if to not in self._plans:
            return True
        if to not in place.told and to not in place.answered:
            return False
        if reason == "crashed" or conversation.is_exhausted:
            return False
        if to in self._agents and reason != "completed" and (to, theirs) not in conversation.places:
            return False  # what has asked it is withdrawn
        infos = self._infos(to, place.info.protocol, theirs)
        return not any(place.info.participant in info.loses for info in infos)

    def _infos(self, agent: str, protocol: str, participant: str) -> list[BranchInfo]:
        """The branches of a participant in an agent of the team."""
        part = protocol, participant
        return [info for info in self._plans[agent].branches if (info.protocol, info.participant) == part]

    def _farewell_to(self, place: Participation, to: str, theirs: str) -> tuple[str, str] | None:
        """What the protocol has for a part that ends early and an agent receives."""
        moves = [move for act in FAREWELLS for move in place.info.sends if move[0] == act]
        if to in self._plans:
            infos = self._infos(to, place.info.protocol, theirs)
            moves = [move for move in moves if any(move in info.receives for info in infos)]
        return moves[0] if moves else None

    def _bid_farewell(self, agent: Receiver, place: Participation, name: str, to: str, theirs: str) -> None:
        """An agent is sent what its protocol has for a part that ends early, if it receives that."""
        move = self._farewell_to(place, to, theirs)
        if move is None:
            return
        performative, message = move
        content: object = place.said.get(message)
        if content is None:
            kind = agent.kinds.get(message)
            content = kind() if kind is not None else None
        if content is None:
            return
        acl = _message(agent, place, name, to, theirs, performative, message, content)
        self._told.sent(acl, [place.answered[to].identity] if to in place.answered else [], "ended")
        self._send(to, acl)


def _waits_from(place: Participation, who: str) -> bool:
    return any(mail.sender == who and mail.performative != LOST for mail in place.waiting.values())


def _others(conversation: Conversation, name: str) -> list[tuple[str, str]]:
    """Who else takes part or was asked to, each with its participant."""
    return [
        (agent, part)
        for part, agents in conversation.members.items()
        for agent in agents
        if agent != name and (agent, part) not in conversation.past
    ]


def _message(
    agent: Receiver,
    place: Participation,
    name: str,
    to: str,
    theirs: str,
    performative: str,
    message: str,
    content: object,
) -> AclMessage:
    identity = agent.identity()
    heard = place.answered.get(to)
    return AclMessage(
        performative,
        agent.name,
        (to,),
        message,
        content,
        place.info.protocol,
        name,
        place.info.participant,
        theirs,
        identity,
        place.info.version,
        agent.plan.system,
        name_of(identity),
        in_reply_to=heard.reply_with if heard is not None else "",
    )


def reason_of(acl: AclMessage) -> Reason:
    """The reason in a message that tells of a loss; one that is unknown here counts as `left`."""
    return next((reason for reason in REASONS if reason == acl.message), "left")


__all__ = ["Losses", "reason_of"]
