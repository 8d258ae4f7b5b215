"""Sending: to whom a message of a branch goes, in the conversation that it opens or is in."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from aseme_dsl.runtime.conversation.choosing import Choosing
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery
from aseme_dsl.runtime.conversation.participation import Participation
from aseme_dsl.runtime.message.acl import AclMessage, name_of
from aseme_dsl.runtime.ports import Receiver


class Sending:
    """What branches send. Called with the lock of the conversations."""

    def __init__(
        self, members: Members, told: ConversationTrace, counting: Counting, delivery: Delivery, life: str
    ) -> None:
        """`life` tells the conversations of one start of a process from those of another."""
        self._members = members
        self._told = told
        self._counting = counting
        self._delivery = delivery
        self._life = life
        self._choosing = Choosing()

    def check_receiver(self, agent: Receiver, branch: str, to: str) -> Collection[str]:
        """The agents that `to` means now.

        Raises:
            LookupError: it is neither a participant of the branch's protocol nor an agent.
        """
        protocol = agent.branch_info(branch).protocol
        place = self._members.desks[agent.name].branches.get(branch)
        conversation = self._members.of(place)
        members = conversation.members if conversation is not None else {}
        if members.get(to):
            return tuple(members[to])
        if players := self._members.players(protocol, to):
            return players
        is_member = any(to in names for names in members.values())
        if to not in self._members.plans and not is_member and self._registered(agent, branch, to) is None:
            raise LookupError(f"{to} is neither an agent nor a participant of {protocol} that an agent plays")
        return (to,)

    def send(
        self,
        agent: Receiver,
        branch: str,
        performative: str,
        message: str,
        content: object,
        to: str,
        excepts: Collection[str] = (),
        reply_by: int | None = None,
        *,
        one: bool = False,
        before: Collection[str] = (),
    ) -> tuple[str, ...]:
        """Send in the conversation of a branch, which it opens if it has none; `to` may be an agent.

        It does not go to the agents in `excepts`, and with `one` to a single agent. An answer is wanted until
        `reply_by`, if that is said. Those in `before` have got it before the branch was suspended. Gives the
        agents that it goes to.
        """
        place = self._place_of(agent, branch, performative, message, content)
        if place is not None:
            invited, part, reason = (
                self._one(agent, place, to, excepts)
                if one
                else self._receivers(agent, place, to, performative, message)
            )
            if reason:
                text = f"{performative} {message} is not sent: {reason}"
                self._told.fault(agent.name, text)
                return ()
            receivers = invited
            if excepts or before:
                receivers = tuple(name for name in invited if name not in (*excepts, *before))
            if before and not receivers:
                reason = "it was sent before the participant was suspended"
                self._told.unsent(agent.name, performative, message, content, place.info, reason)
                return ()
            is_round = to in place.info.counts
            return self._send(
                agent, place, performative, message, content, receivers, part, reply_by, is_round=is_round
            )
        return ()

    def send_to_agent(
        self,
        agent: Receiver,
        branch: str,
        performative: str,
        message: str,
        content: object,
        to: str,
        reply_by: int | None = None,
    ) -> None:
        """Send to one agent, as the participant that it plays and that receives such a message."""
        part = self._part_of(agent, branch, performative, message, to)
        if part is None:
            protocol = agent.branch_info(branch).protocol
            text = f"{performative} {message} is not sent: {to} plays no part of {protocol} that receives it"
            self._told.fault(agent.name, text)
            return
        place = self._place_of(agent, branch, performative, message, content)
        if place is None:
            return
        reason = self._members.invite(place, to, part)
        if reason:
            text = f"{performative} {message} is not sent: {reason}"
            self._told.fault(agent.name, text)
        else:
            self._send(agent, place, performative, message, content, (to,), part, reply_by)

    def _part_of(self, agent: Receiver, branch: str, performative: str, message: str, to: str) -> str | None:
        """As which participant an agent gets a message: the one that it is in this conversation, if any."""
        protocol = agent.branch_info(branch).protocol
        plan = self._members.plans.get(to)
        place = self._members.desks[agent.name].branches.get(branch)
        conversation = self._members.of(place)
        members = conversation.members if conversation is not None else {}
        if plan is None:
            known = next((part for part, names in members.items() if to in names), None)
            return known or self._registered(agent, branch, to)
        parts = plan.receivers.get((protocol, performative, message), ())
        return next((part for part in parts if to in members.get(part, ())), next(iter(parts), None))

    def _registered(self, agent: Receiver, branch: str, name: str) -> str | None:
        """The participant of a branch's protocol that an external agent has registered to play, if any."""
        info = agent.branch_info(branch)
        directory = self._members.directory
        parts = (part for part, _, _ in info.participants if part != info.participant)
        return next((part for part in parts if name in directory.players(info.protocol, part)), None)

    def _place_of(
        self, agent: Receiver, branch: str, performative: str, message: str, content: object
    ) -> Participation | None:
        """The branch in a conversation, which is opened if there is none; None, told, if it cannot be."""
        place = self._members.desks[agent.name].branches.get(branch)
        if place is None:
            info = agent.branch_info(branch)
            reason = "its participant was left"
            self._told.unsent(agent.name, performative, message, content, info, reason)
        elif place.conversation is None and self._members.held:
            reason = self._members.held
            self._told.unsent(agent.name, performative, message, content, place.info, reason)
            self._told.fault(agent.name, f"{performative} {message} is not sent: {reason}")
            return None
        elif place.conversation is None:
            self._open(agent, place)
        return place

    def _send(
        self,
        agent: Receiver,
        place: Participation,
        performative: str,
        message: str,
        content: object,
        receivers: tuple[str, ...],
        part: str,
        reply_by: int | None = None,
        *,
        is_round: bool = False,
    ) -> tuple[str, ...]:
        """The agents that it goes to: none if the conversation may have no more messages."""
        assert place.conversation is not None
        if reason := self._delivery.spend(agent, place.conversation):
            self._told.unsent(agent.name, performative, message, content, place.info, reason)
            return ()
        identity = agent.identity()
        answered = place.answered
        first = answered.get(receivers[0]) if len(receivers) == 1 else None
        acl = AclMessage(
            performative,
            agent.name,
            receivers,
            message,
            content,
            place.info.protocol,
            place.conversation,
            place.info.participant,
            part,
            identity,
            place.info.version,
            agent.plan.system,
            name_of(identity),
            "" if first is None else first.reply_with,
            reply_by,
            sent=self._members.directory.clock.now(),
        )
        place.said[message] = content
        for name in receivers:
            place.told[name] = performative
            place.spoken[name] = agent.steps
        self._told.sent(acl, [answered[name].identity for name in receivers if name in answered])
        self._choosing.sent(agent, receivers)
        if is_round:
            self._counting.sent(agent, place, self._members.conversations[place.conversation], acl)
        for name in receivers:
            heard = answered.get(name)
            answers = acl.in_reply_to if heard is None else heard.reply_with
            self._delivery.bring(
                name, acl if answers == acl.in_reply_to else replace(acl, in_reply_to=answers)
            )
        return receivers

    def _open(self, agent: Receiver, place: Participation) -> None:
        name = self._members.begin(place.info.protocol, agent.name, self._life)
        self._delivery.take_part(agent, place, name, "open")

    def _receivers(
        self, agent: Receiver, place: Participation, to: str, performative: str, message: str
    ) -> tuple[tuple[str, ...], str, str]:
        """Who is addressed, as which participant and, where it cannot be sent, why."""
        assert place.conversation is not None
        conversation = self._members.conversations[place.conversation]
        protocol = place.info.protocol
        members = conversation.members.get(to)
        if members is None and not self._members.players(protocol, to) and not place.info.knows(to):
            part = self._part_of(agent, place.info.label, performative, message, to)
            if part is None:  # it receives no such message, and will say so
                plan = self._members.plans.get(to)
                branches = plan.branches if plan is not None else ()
                part = next((p for p, names in conversation.members.items() if to in names), None)
                part = part or next((b.participant for b in branches if b.protocol == protocol), "")
            return (to,), part, self._members.invite(place, to, part)
        if not members:
            players = self._members.present(agent, protocol, to)
            least, most = place.info.size_of(to)
            if not players or len(players) < least:
                there = ", ".join(players) or "none"
                return (), to, f"{protocol} takes {_at_least(least)} {to}, and there is {there}"
            members = conversation.members[to] = players[:most]
            conversation.chosen.add(to)
        if not conversation.past:
            return tuple(members), to, ""
        still = tuple(name for name in members if (name, to) not in conversation.past)
        return still or tuple(members), to, ""  # an agent whose part is over does not get what all others get

    def _one(
        self, agent: Receiver, place: Participation, to: str, excepts: Collection[str]
    ) -> tuple[tuple[str, ...], str, str]:
        """One agent that plays a participant and was not asked in this conversation, or why there is none."""
        conversation = self._members.conversations[place.conversation or ""]
        players = self._members.present(agent, place.info.protocol, to)
        asked = conversation.members.get(to, [])
        desk = self._members.desks[agent.name]
        name = self._choosing.one_of(agent, players, (*asked, *excepts), desk, self._members.conversations)
        if name is None:
            return (), to, f"there is no {to} that was not asked in this conversation"
        _, most = place.info.size_of(to)
        there = [other for other in asked if (other, to) not in conversation.past]
        if most is not None and len(there) >= most:
            return (), to, f"{', '.join(there)} takes part as {to} already"
        conversation.members.setdefault(to, []).append(name)
        return (name,), to, ""


def _at_least(least: int) -> str:
    return "one" if least <= 1 else f"{least} or more"


__all__ = ["Sending"]
