"""Given: an agent message that a script or a test gives an agent, as if another agent had sent it."""

from __future__ import annotations

from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.chart.plan import BranchInfo
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery
from aseme_dsl.runtime.conversation.participation import Participation
from aseme_dsl.runtime.message.acl import AclMessage, name_of
from aseme_dsl.runtime.ports import Receiver


class Giving:
    """Gives such messages. Called with the lock of the conversations."""

    def __init__(self, members: Members, told: ConversationTrace, delivery: Delivery) -> None:
        self._members = members
        self._told = told
        self._delivery = delivery

    def give(
        self,
        agent: Receiver,
        performative: str,
        message: str,
        content: object,
        sender: str,
        identity: Identity,
    ) -> str:
        """Give an agent a message of `sender`; why no participant that it plays receives such a message.

        It belongs to the newest open conversation in which the agent receives it, first one in which the
        sender takes part; where there is none, to a new one. A message that can begin a conversation begins
        one, unless the sender takes part in an open one.
        """
        kind = performative, message
        infos = [info for info in agent.plan.branches if kind in info.receives]
        if not infos:
            return f"{agent.name} plays no participant that receives {performative} {message}"
        place = self._newest(agent, sender, kind)
        info = infos[0] if place is None else place.info
        part = self._part_of(agent, info, kind)
        conversation = place.conversation if place is not None else None
        if conversation is None:
            conversation = self._members.begin(info.protocol, sender, "")
        members = self._members.conversations[conversation].members.setdefault(part, [])
        if sender not in members:
            members.append(sender)
        acl = AclMessage(
            performative,
            sender,
            (agent.name,),
            message,
            content,
            info.protocol,
            conversation,
            part,
            info.participant,
            identity,
            info.version,
            agent.plan.system,
            name_of(identity),
            sent=self._members.directory.clock.now(),
        )
        if sender in self._members.agents:
            self._told.sent(acl, ())
        else:
            self._told.received(agent.name, acl)
        self._delivery.deliver(agent, acl)
        self._delivery.close(conversation)
        return ""

    def _newest(self, agent: Receiver, sender: str, kind: tuple[str, str]) -> Participation | None:
        """Where the agent receives such a message, in the newest of its open conversations."""
        order = list(self._members.conversations)

        def takes_part(place: Participation) -> bool:
            members = self._members.conversations[place.conversation or ""].members
            return any(sender in names for names in members.values())

        places = [
            place
            for place in self._members.desks[agent.name].branches.values()
            if place.conversation is not None and kind in place.info.receives
            if kind not in place.info.opens or takes_part(place)
        ]
        return max(
            places,
            key=lambda place: (takes_part(place), order.index(place.conversation or "")),
            default=None,
        )

    def _part_of(self, agent: Receiver, info: BranchInfo, kind: tuple[str, str]) -> str:
        """The participant that sends such a message: that from which a transition expects it, if any."""
        for item in agent.plan.transitions:
            for event in item.events:
                if event[:3] == ("received", *kind) and info.knows(str(event[3])):
                    return str(event[3])
        others = [name for name, _, _ in info.participants if name != info.participant]
        senders = [
            branch.participant
            for plan in self._members.plans.values()
            for branch in plan.branches
            if branch.protocol == info.protocol and kind in branch.sends
        ]
        return next((name for name in (*senders, *others) if name != info.participant), info.participant)


__all__ = ["Giving"]
