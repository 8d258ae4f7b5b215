"""Counting answers: tells charts that count them who was addressed, and who will not answer."""

from __future__ import annotations

from collections.abc import Callable

from aseme_dsl.runtime.chart.inputs import Addressed, Settled
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.participation import Conversation, Participation
from aseme_dsl.runtime.message.acl import AclMessage, name_of
from aseme_dsl.runtime.ports import Receiver


class Counting:
    """What conversations do for `invited`, `answered` and `all_answered`."""

    def __init__(self, told: ConversationTrace, is_gone: Callable[[str], bool]) -> None:
        self._told = told
        self._is_gone = is_gone

    def sent(
        self, agent: Receiver, place: Participation, conversation: Conversation, acl: AclMessage
    ) -> None:
        """A branch sends to a participant that it counts; it learns so before an answer can come."""
        item = Addressed(place.info.label, acl.to, acl.receivers, name_of(acl.identity))
        agent.post(acl.identity, item, conversation=acl.conversation)
        for name in acl.receivers:
            if (name, acl.to) in conversation.past or self._is_gone(name):
                self.settled(agent, place, acl.to, name)

    def unexpected(self, agent: Receiver, conversation: Conversation | None, acl: AclMessage) -> None:
        """A message was refused or is unexpected: nothing will be taken of it."""
        place = conversation.places.get((agent.name, acl.to)) if conversation is not None else None
        if place is not None and acl.participant in place.info.counts:
            self.settled(agent, place, acl.participant, acl.sender, acl.in_reply_to)

    def meaningless(self, agent: Receiver, conversation: Conversation, sender: str, in_reply_to: str) -> None:
        """What an external agent has said in a conversation means nothing: nothing will be taken of it."""
        for participant, names in conversation.members.items():
            if sender in names:
                for (name, _), place in conversation.places.items():
                    if name == agent.name and participant in place.info.counts:
                        self.settled(agent, place, participant, sender, in_reply_to)

    def settled(
        self, agent: Receiver, place: Participation, participant: str, name: str, in_reply_to: str = ""
    ) -> None:
        """Nothing can be taken any more of an agent that was addressed."""
        identity = agent.identity()
        conversation = place.conversation or ""
        self._told.takes_part(
            "settled",
            agent.name,
            place,
            conversation,
            peer=name,
            played=participant,
            identity=identity,
            in_reply_to=in_reply_to,
        )
        item = Settled(place.info.label, participant, name, in_reply_to)
        agent.post(identity, item, conversation=conversation)


__all__ = ["Counting"]
