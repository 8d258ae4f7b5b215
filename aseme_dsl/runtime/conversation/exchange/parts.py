"""Parts: a branch is entered and takes part, takes messages, and is left."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace

from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Identity, Reason
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery, receives
from aseme_dsl.runtime.conversation.participation import Participation, remember
from aseme_dsl.runtime.message.convert import Messages, mailed
from aseme_dsl.runtime.ports import Receiver


class Parts:
    """The parts of agents in conversations, from entry to end. Called with the lock of the conversations."""

    def __init__(self, members: Members, told: ConversationTrace, delivery: Delivery) -> None:
        self._members = members
        self._told = told
        self._delivery = delivery

    def joined(self, agent: Receiver, branch: str) -> None:
        """A branch was entered: it is free, and takes the conversation that waits longest."""
        place = Participation(agent.branch_info(branch))
        desk = self._members.desks[agent.name]
        desk.branches[branch] = place
        self._offer(agent, place)

    def _offer(self, agent: Receiver, place: Participation) -> None:
        """A branch is free, and takes the conversation that waits longest."""
        desk = self._members.desks[agent.name]
        waiting = desk.invitations.take(place.part)
        if not waiting:
            desk.free.setdefault(place.part, {})[place.info.label] = place
            return
        name = waiting[0].conversation
        self._members.conversations[name].invitations -= len(waiting)
        self._delivery.take_part(agent, place, name, "join")
        for acl in waiting:
            if receives(place.info, acl):
                self._delivery.post(agent, place, acl)
            else:
                self._delivery.unexpected(agent, acl, f"{acl.to} does not receive it")

    def suspended(self, agent: Receiver, branch: str) -> None:
        """A branch was left that may be resumed: its conversation stays open, with its messages."""
        desk = self._members.desks[agent.name]
        place = desk.branches[branch]
        place.suspended = True
        if place.conversation is None:
            desk.free[place.part].pop(branch)
        else:
            self._told.takes_part("suspend", agent.name, place, place.conversation)

    def resumed(self, agent: Receiver, branch: str) -> None:
        """A branch that was suspended continues."""
        place = self._members.desks[agent.name].branches[branch]
        place.suspended = False
        if place.conversation is None:
            self._offer(agent, place)
        else:
            self._told.takes_part("resume", agent.name, place, place.conversation)

    def left(self, agent: Receiver, branch: str, completed: bool = False) -> None:
        """A branch was left: its part in the conversation is over, and what it did not take is given up."""
        desk = self._members.desks[agent.name]
        place = desk.branches.pop(branch, None)
        if place is None:
            return
        if place.conversation is None:
            desk.free.get(place.part, {}).pop(branch, None)  # one that is suspended is not free
            return
        name = place.conversation
        conversation = self._members.conversations[name]
        conversation.places.pop((agent.name, place.info.participant), None)
        reason: Reason | None = "completed" if completed else desk.leaving
        losses = self._delivery.losses
        answered = {} if reason is None else losses.unanswered(agent, place, conversation, reason)
        self._told.takes_part(
            "leave",
            agent.name,
            place,
            name,
            untaken=tuple(identity for identity in place.waiting if identity not in answered),
            reason=None if completed else reason,
        )
        for identity, mail in answered.items():
            remember(desk.returned, identity, None)
            self._delivery.give_back(agent, mail, name, "its part in the conversation is over")
        if reason is None:
            conversation.past[agent.name, place.info.participant] = "left"
        elif not conversation.is_exhausted:  # then all have been told
            self._delivery.losses.ended(agent, place, name, conversation, reason)
        self._delivery.close(name)

    def gone(self, agent: Receiver, reason: str = "") -> None:
        """An agent has ended or left its plan: it takes part in nothing, and what waited is answered.

        Why its parts are over was said before, with `leaving`.
        """
        desk = self._members.desks[agent.name]
        if desk.leaving is not None:
            self._delivery.free.clear(agent, reason)
        for branch in list(desk.branches):
            self.left(agent, branch)
        if desk.leaving not in (None, "left"):  # those who have asked it, and it has not joined
            self.tell_gone(agent.name, desk.leaving, elsewhere=False)
        desk.leaving = "left"
        for acl in desk.invitations.clear():
            self._delivery.unexpected(agent, acl, reason or f"{agent.name} has ended")
            self._members.conversations[acl.conversation].invitations -= 1
            self._delivery.close(acl.conversation)
        if agent.over:
            self._members.directory.disappeared(agent.name)

    def returned(self, name: str, *, same: bool) -> None:
        """An agent elsewhere is there again: as the same incarnation, it takes part as before, or in another.

        Reports of its loss remain; it now learns what ended here meanwhile.
        """
        for known, conversation in list(self._members.conversations.items()):
            parts = [(who, part) for who, part in sorted(conversation.absent) if who == name]
            conversation.absent -= frozenset(parts)
            for key in parts if same else ():
                conversation.past.pop(key, None)
                for (to, _), place in conversation.places.items():
                    self._told.takes_part("back", to, place, known, peer=name, played=key[1])
        self._delivery.losses.returned(name, same=same)

    def tell_gone(self, name: str, reason: Reason, *, elsewhere: bool) -> None:
        """Record a lost agent in the conversations that count on it.

        A participant with a transition for it gets it as an agent message, once for each participant that the
        agent was.
        """
        for known, conversation in list(self._members.conversations.items()):
            parts = [
                part
                for part, who in conversation.members.items()
                if name in who and (name, part) not in conversation.past
            ]
            places = [(to, place) for (to, _), place in conversation.places.items() if to != name]
            for part in parts:
                self._delivery.losses.over(conversation, known, name, part, reason)
                if elsewhere and name in self._members.plans:
                    conversation.absent |= {(name, part)}
            for to, place in places if elsewhere and parts else ():
                if not any(part in place.info.loses for part in parts):
                    self._told.takes_part("gone", to, place, known, peer=name, reason=reason)
            self._delivery.close(known)

    def taken(
        self, agent: Receiver, branch: str, identity: Identity
    ) -> tuple[Participation | None, AgentMessage | None]:
        """A transition or an activity took a message of this participation: the message, if it waited."""
        place = self._members.desks[agent.name].branches.get(branch)
        if place is None:
            return None, None
        mail = place.waiting.pop(identity, None)
        if mail is not None:
            kind = (mail.performative, mail.message, mail.sender)
            place.taken.pop(kind, None)
            place.taken[kind] = mail
            place.answered[mail.sender] = mail
        return place, mail

    def refuse(self, agent: Receiver, branch: str, identity: Identity) -> None:
        """No later state of a branch takes a message that waits in it."""
        place = self._members.desks[agent.name].branches.get(branch)
        mail = place.waiting.pop(identity, None) if place is not None else None
        if place is not None and mail is not None:
            reason = f"no later state of {place.info.participant} takes it"
            self._delivery.give_back(agent, mail, place.conversation or "", reason)
            self._delivery.losses.consumed(agent, place)

    def taken_by(self, agent: Receiver, branch: str) -> tuple[AgentMessage, ...]:
        """What a participation has taken: the last of each kind and sender, the newest at the end."""
        place = self._members.desks[agent.name].branches.get(branch)
        taken = () if place is None else place.taken.values()
        return tuple(mail for mail in taken if mail.performative != LOST)

    def carry(self, agent: Receiver, labels: Mapping[str, str], messages: Messages) -> None:
        """The agent continues under its new plan, in which the states have these labels.

        What it was invited to and now plays in another way is answered `not_understood`.
        """
        self._members.renew({agent.name: agent.plan})
        infos = {info.label: info for info in agent.plan.branches}
        desk = self._members.desks[agent.name]
        places = desk.branches
        desk.leaving = "replaced"
        for branch in [item for item in places if labels.get(item) not in infos]:
            self.left(agent, branch)
        desk.leaving = "left"
        carried: dict[str, Participation] = {}
        for branch, place in places.items():
            label = labels[branch]
            place.info = infos[label]
            waiting = _mails(place.waiting.values(), label, messages)
            place.waiting = {mail.identity: mail for mail in waiting}
            place.taken = {
                (mail.performative, mail.message, mail.sender): mail
                for mail in _mails(place.taken.values(), label, messages)
            }
            carried[label] = place
        desk.branches = carried
        desk.free.clear()
        for label, place in carried.items():
            if place.conversation is None and not place.suspended:
                desk.free.setdefault(place.part, {})[label] = place
        for acl in desk.invitations.clear():
            self._members.conversations[acl.conversation].invitations -= 1
            self._delivery.deliver(agent, replace(acl, content=agent.understood(acl.content)))
            self._delivery.close(acl.conversation)


def _mails(items: Iterable[AgentMessage], branch: str, messages: Messages) -> list[AgentMessage]:
    """AgentMessage for the branch as it is called now; what there is no message for any more is left out."""
    found: list[AgentMessage] = []
    for item in items:
        with suppress(LookupError):
            found.append(mailed(item if item.branch == branch else replace(item, branch=branch), messages))
    return found


__all__ = ["Parts"]
