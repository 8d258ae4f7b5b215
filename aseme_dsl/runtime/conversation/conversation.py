"""Conversations: one run of a protocol between its participants, and the agent messages that belong to it.

A conversation is opened by the first message that a participant sends after it was entered. A message goes to
everybody who takes part as the addressed participant or, while nobody does, to all other agents that play
it. At the receiver it goes to the branch that takes part in that conversation; if none does, it is offered to
a free branch of the participant, or waits until one is entered or free, with `WAITING` others at the most. A
branch that is left takes part no more. What a participant does not list as received, what comes when too many
wait already, and what comes for a participation that is over, is unexpected: it is told in the trace and
answered `not_understood`.

Agents that are not of the team may take part, too: what they say is understood or not (`outsiders`), and then
handed on like any other message. A message that was received before is told, and no more.
"""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import Any

from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Identity, Reason
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.conversation import external_agents
from aseme_dsl.runtime.conversation.choosing import Choosing
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.directory import Directory
from aseme_dsl.runtime.conversation.invitations import Part
from aseme_dsl.runtime.conversation.losses import Losses, reason_of
from aseme_dsl.runtime.conversation.management import Management
from aseme_dsl.runtime.conversation.participation import REMEMBERED, Conversation, Desk, Participation
from aseme_dsl.runtime.message.acl import (
    NOT_UNDERSTOOD,
    AclMessage,
    AgentIdentifier,
    FipaMessage,
    name_of,
    performative_of,
)
from aseme_dsl.runtime.message.convert import Messages, mailed
from aseme_dsl.runtime.ports import Links, Receiver
from aseme_dsl.runtime.time.timers import Scheduler
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.transport.port import LOCAL, Transport

WAITING = 1000
"""So many messages wait at the most, at one agent, for a participant to be entered."""

Hears = Callable[[FipaMessage], None]
"""What an agent in this process that is not of the team is told messages by."""


class Conversations:
    """All conversations of a team. May be used from any thread."""

    def __init__(
        self,
        driver: Scheduler,
        trace: Trace,
        transport: Transport = LOCAL,
        queue: int = QUEUE,
        system: str = "",
    ) -> None:
        """So many messages, `queue`, may wait for a participant to take them."""
        self.directory = Directory(driver, trace)
        self._driver = driver
        self._told = ConversationTrace(driver, trace)
        self._counting = Counting(self._told, self.directory.is_gone)
        self._choosing = Choosing()
        self._transport = transport
        self._queue = queue
        self._agents: dict[str, Receiver] = {}
        self._plans: dict[str, Plan] = {}
        """Of everybody, also of agents in other processes, in the team's order."""
        self._over: dict[str, dict[tuple[str, str], Reason]] = {}
        """Who has left the conversations that are forgotten here but may go on elsewhere, the newest last."""
        self.links: Links | None = None
        """The simulated links between the agents, if they are not perfect."""
        self._desks: dict[str, Desk] = {}
        self._playing: dict[Part, list[str]] | None = None
        """Who plays a participant, in the team's order, once somebody has asked."""
        self._outside: dict[str, Hears] = {}
        """The agents in this process that are not of the team."""
        self._numbers = itertools.count(transport.behind + 1)
        """Of what outsiders say."""
        self._asked: dict[str, str] = {}
        """The conversations of what was sent to outsiders, by what an answer calls it, the newest last."""
        self._conversations: dict[str, Conversation] = {}
        self._management = Management(self.directory, system, self._tell_outside, self._plans)
        self._opened: dict[tuple[str, str], int] = {}
        self._lock = threading.RLock()
        self._losses = Losses(
            self._told,
            self._counting,
            self._agents,
            self._desks,
            self._plans,
            transport,
            lambda: self.links,
            self._bring,
        )

    def join(self, agent: Receiver) -> None:
        """An agent can be talked to; the order in which they come is the team's."""
        self._agents[agent.name] = agent
        self._desks[agent.name] = Desk()
        self.join_elsewhere(agent.name, agent.plan)
        self.directory.appeared(agent.name, agent.plan)

    def join_elsewhere(self, name: str, plan: Plan) -> None:
        """An agent of the team runs in another process, with this plan; it counts in the team's order."""
        self._plans[name] = plan
        self._playing = None
        self.directory.expect(name, plan)

    def add_external_agent(self, name: str, hears: Hears) -> None:
        """An agent that is not of the team runs in this process; it speaks by `receive_external`.

        It is told messages while others wait: it only takes note of them, and answers later.

        Raises:
            ValueError: an agent of the team has that name.
        """
        if name in self._plans:
            raise ValueError(f"an agent of the team is called {name}")
        self._outside[name] = hears

    # ---- sending -----------------------------------------------------------------------------

    def check_receiver(self, agent: Receiver, branch: str, to: str) -> Collection[str]:
        """The agents that `to` means now.

        Raises:
            LookupError: it is neither a participant of the branch's protocol nor an agent.
        """
        protocol = agent.branch_info(branch).protocol
        place = self._desks[agent.name].branches.get(branch)
        conversation = self._conversations.get(place.conversation or "") if place is not None else None
        members = conversation.members if conversation is not None else {}
        if members.get(to):
            return tuple(members[to])
        if players := self._players(protocol, to):
            return players
        if to not in self._plans and not any(to in names for names in members.values()):
            raise LookupError(f"{to} is neither an agent nor a participant of {protocol} that somebody plays")
        return (to,)

    def send(
        self,
        agent: Receiver,
        branch: str,
        performative: str,
        message: str,
        content: Any,
        to: str,
        excepts: Collection[str] = (),
        reply_by: int | None = None,
        *,
        one: bool = False,
    ) -> None:
        """Send in the conversation of a branch, which it opens if it has none; `to` may be an agent.

        It does not go to the agents in `excepts`, and with `one` to a single agent. An answer is wanted until
        `reply_by`, if that is said.
        """
        with self._driver.holding(), self._lock:
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
                    return
                receivers = tuple(name for name in invited if name not in excepts)
                is_round = place.info.knows(to)
                self._send(
                    agent, place, performative, message, content, receivers, part, reply_by, is_round=is_round
                )

    def send_to_agent(
        self,
        agent: Receiver,
        branch: str,
        performative: str,
        message: str,
        content: Any,
        to: str,
        reply_by: int | None = None,
    ) -> None:
        """Send to one agent, as the participant that it plays and that receives such a message."""
        with self._driver.holding(), self._lock:
            part = self._part_of(agent, branch, performative, message, to)
            if part is None:
                protocol = agent.branch_info(branch).protocol
                text = (
                    f"{performative} {message} is not sent: {to} plays no part of {protocol} that receives it"
                )
                self._told.fault(agent.name, text)
                return
            place = self._place_of(agent, branch, performative, message, content)
            if place is None:
                return
            reason = self._invite(place, to, part)
            if reason:
                text = f"{performative} {message} is not sent: {reason}"
                self._told.fault(agent.name, text)
            else:
                self._send(agent, place, performative, message, content, (to,), part, reply_by)

    def _part_of(self, agent: Receiver, branch: str, performative: str, message: str, to: str) -> str | None:
        """As which participant an agent gets a message: the one that it is in this conversation, if any."""
        protocol = agent.branch_info(branch).protocol
        plan = self._plans.get(to)
        place = self._desks[agent.name].branches.get(branch)
        conversation = self._conversations.get((place.conversation or "") if place is not None else "")
        members = conversation.members if conversation is not None else {}
        if plan is None:
            return next((part for part, names in members.items() if to in names), None)
        parts = plan.receivers.get((protocol, performative, message), ())
        return next((part for part in parts if to in members.get(part, ())), next(iter(parts), None))

    def _place_of(
        self, agent: Receiver, branch: str, performative: str, message: str, content: Any
    ) -> Participation | None:
        """The branch in a conversation, which is opened if there is none; None, told, if it was left."""
        place = self._desks[agent.name].branches.get(branch)
        if place is None:
            info = agent.branch_info(branch)
            reason = "its participant was left"
            self._told.unsent(agent.name, performative, message, content, info, reason)
        elif place.conversation is None:
            self._open(agent, place)
        return place

    def _send(
        self,
        agent: Receiver,
        place: Participation,
        performative: str,
        message: str,
        content: Any,
        receivers: tuple[str, ...],
        part: str,
        reply_by: int | None = None,
        *,
        is_round: bool = False,
    ) -> None:
        assert place.conversation is not None
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
        )
        place.said[message] = content
        self._told.sent(acl, [answered[name].identity for name in receivers if name in answered])
        self._choosing.sent(agent, receivers)
        if is_round:
            self._counting.sent(agent, place, self._conversations[place.conversation], acl)
        for name in receivers:
            heard = answered.get(name)
            answers = acl.in_reply_to if heard is None else heard.reply_with
            self._bring(name, acl if answers == acl.in_reply_to else replace(acl, in_reply_to=answers))

    def _bring(self, name: str, acl: AclMessage) -> None:
        """Deliver a message to an agent here, or have it carried to one elsewhere."""
        if name in self._agents:
            if self.links is None or name == acl.sender:
                self._deliver(self._agents[name], acl)
            else:
                agent = self._agents[name]
                self.links.carry(
                    acl.sender,
                    name,
                    "mail",
                    acl.conversation,
                    acl.identity,
                    lambda: self._deliver(agent, acl),
                )
            return
        conversation = self._conversations.get(acl.conversation)
        if name in self._plans:
            self._transport.carry(acl, name, conversation.members if conversation is not None else {})
        else:
            known = conversation.outsiders if conversation is not None else {}
            to = known.get(name, (AgentIdentifier(name),))
            if conversation is not None:
                conversation.note(acl.reply_with, acl.performative, acl.message, name)
            by = external_agents.fipa_moment(acl.reply_by, self._driver.clock)
            self._carry_outside(acl.sender, external_agents.written(acl, to, reply_by=by), to)

    def _carry_outside(self, sender: str, message: FipaMessage, to: Iterable[AgentIdentifier]) -> None:
        """Have a message carried to an agent that is not of the team; tell if there is no way to it."""
        if message.conversation:
            self._asked[message.reply_with] = message.conversation
            if len(self._asked) > REMEMBERED:
                del self._asked[next(iter(self._asked))]
        for receiver in to:
            hears = self._outside.get(receiver.name)
            if hears is not None:
                hears(message)
            elif not self._transport.carry_outside(message, receiver):
                text = f"{message.performative} cannot be sent: there is no way to {receiver.name}"
                self._told.fault(sender, text)

    def _open(self, agent: Receiver, place: Participation) -> None:
        protocol = place.info.protocol
        while True:
            number = self._opened[protocol, agent.name] = self._opened.get((protocol, agent.name), 0) + 1
            name = f"{protocol}-{agent.name}-{self._transport.life}{number}"
            if name not in self._conversations and name not in self._over:  # an outsider may call its own so
                break
        self._conversations[name] = Conversation(protocol)
        self._take_part(agent, place, name, "open")

    def _take_part(self, agent: Receiver, place: Participation, name: str, what: str) -> None:
        place.conversation = name
        part = place.part
        self._desks[agent.name].free.get(part, {}).pop(place.info.label, None)
        conversation = self._conversations[name]
        conversation.places[agent.name, part[1]] = place
        members = conversation.members.setdefault(part[1], [])
        if agent.name not in members:
            members.append(agent.name)
        self._told.takes_part(what, agent.name, place, name)
        self._losses.joined(agent, place, name, conversation)

    def _receivers(
        self, agent: Receiver, place: Participation, to: str, performative: str, message: str
    ) -> tuple[tuple[str, ...], str, str]:
        """Who is addressed, as which participant and, where it cannot be sent, why."""
        assert place.conversation is not None
        conversation = self._conversations[place.conversation]
        protocol = place.info.protocol
        members = conversation.members.get(to)
        if members is None and not self._players(protocol, to) and not place.info.knows(to):
            part = self._part_of(agent, place.info.label, performative, message, to)
            if part is None:  # it receives no such message, and will say so
                plan = self._plans.get(to)
                branches = plan.branches if plan is not None else ()
                part = next((p for p, names in conversation.members.items() if to in names), None)
                part = part or next((b.participant for b in branches if b.protocol == protocol), "")
            return (to,), part, self._invite(place, to, part)
        if not members:
            players = self._present(agent, protocol, to)
            least, most = place.info.size_of(to)
            if not players or len(players) < least:
                there = ", ".join(players) or "none"
                return (), to, f"{protocol} takes {_at_least(least)} {to}, and there is {there}"
            members = conversation.members[to] = players[:most]
            conversation.chosen.add(to)
        still = tuple(name for name in members if (name, to) not in conversation.past)
        return still or tuple(members), to, ""  # whose part is over needs no word of what all others are told

    def _present(self, agent: Receiver, protocol: str, participant: str) -> list[str]:
        """The other agents that play a participant and are there, in the team's order."""
        players = [
            name
            for name in self._players(protocol, participant)
            if name != agent.name and not self.directory.is_gone(name)
        ]
        outside = self.directory.players(protocol, participant)
        return players + [name for name in outside if name not in self._plans]

    def _one(
        self, agent: Receiver, place: Participation, to: str, excepts: Collection[str]
    ) -> tuple[tuple[str, ...], str, str]:
        """One agent that plays a participant and was not asked in this conversation, or why there is none."""
        conversation = self._conversations[place.conversation or ""]
        players = self._present(agent, place.info.protocol, to)
        asked = conversation.members.get(to, [])
        desk = self._desks[agent.name]
        name = self._choosing.one_of(agent, players, (*asked, *excepts), desk, self._conversations)
        if name is None:
            return (), to, f"there is no {to} that was not asked in this conversation"
        _, most = place.info.size_of(to)
        there = [other for other in asked if (other, to) not in conversation.past]
        if most is not None and len(there) >= most:
            return (), to, f"{', '.join(there)} takes part as {to} already"
        conversation.members.setdefault(to, []).append(name)
        return (name,), to, ""

    def _invite(self, place: Participation, name: str, part: str) -> str:
        """An agent shall take part, if it does not yet; the reason why it cannot."""
        members = self._conversations[place.conversation or ""].members.setdefault(part, [])
        if name in members:
            return ""
        _, most = place.info.size_of(part)
        if most is not None and len(members) >= most:
            return f"{', '.join(members)} takes part as {part} already"
        members.append(name)
        self._conversations[place.conversation or ""].chosen.add(part)
        return ""

    def _players(self, protocol: str, participant: str) -> list[str]:
        playing = self._playing
        if playing is None:
            playing = self._playing = {}
            for name, plan in self._plans.items():
                for part in dict.fromkeys((info.protocol, info.participant) for info in plan.branches):
                    playing.setdefault(part, []).append(name)
        return playing.get((protocol, participant), [])

    # ---- delivering --------------------------------------------------------------------------

    def arrived(self, agent: Receiver, acl: AclMessage, members: Mapping[str, Sequence[str]]) -> None:
        """The transport has brought a message for an agent, with what its sender knows of who takes part."""
        with self._driver.holding(), self._lock:
            if self._desks[agent.name].was_heard(acl.identity):
                self._told.unexpected(agent.name, acl, "it was received before")
                return
            if acl.performative != LOST:  # that is told where somebody waits for it
                self._told.received(agent.name, acl)
            played = (info.version for info in agent.plan.branches if info.protocol == acl.protocol)
            acl = replace(acl, version=next(played, ""))  # the transport brings only what is of our model
            conversation = self._conversations.get(acl.conversation)
            if conversation is None:
                past = self._over.pop(acl.conversation, {})
                conversation = Conversation(acl.protocol, past=past)
                self._conversations[acl.conversation] = conversation
            for part, names in members.items():
                known = conversation.members.setdefault(part, [])
                known.extend(name for name in names if name not in known)
            if acl.performative == LOST:
                if (acl.sender, acl.participant) not in conversation.past:
                    self._losses.over(
                        conversation, acl.conversation, acl.sender, acl.participant, reason_of(acl)
                    )
            else:
                self._deliver(agent, acl)
            if acl.conversation in self._conversations:
                self._close(acl.conversation)

    def receive_external(self, to: str, message: FipaMessage) -> None:
        """An agent that is not of the team has sent a message to one of ours. May be called from any thread.

        It is handed on like any other if it is understood. Else it is told in the trace why it is not, and
        answered `not_understood`.
        """
        with self._driver.holding(), self._lock:
            agent = self._agents.get(to)
            if self._management.is_meant(to, message):
                self._management.hear(to, message)
                return
            sender = message.sender.name if message.sender is not None else ""
            identity = sender, next(self._numbers)
            if agent is None:
                self._not_understood(to, message, identity, f"there is no agent {to} here")
            elif not sender:
                self._not_understood(to, message, identity, "it does not say who has sent it")
            elif sender in self._plans:
                reason = f"an agent of the team is called {sender}, and this is none of its messages"
                self._not_understood(to, message, identity, reason)
            elif message.reply_with and self._desks[to].was_heard((sender, *_said_outside(message))):
                self._not_understood(to, message, identity, "it was received before", answered=False)
            else:
                self._hear(agent, message, sender, identity)

    def _hear(self, agent: Receiver, message: FipaMessage, sender: str, identity: Identity) -> None:
        """Hand on what an outsider says, if it is understood."""
        try:
            name = message.conversation or self._conversation_of(agent, message, sender)
            name = name or f"{sender}-{identity[1]}"
            conversation = self._conversations.get(name)
            found = self._understood(agent, message, sender, name, conversation)
        except external_agents.NotUnderstood as problem:
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
        if conversation is None:
            past = self._over.pop(name, {})
            conversation = self._conversations[name] = Conversation(info.protocol, past=past)
        members = conversation.members.setdefault(found.participant, [])
        _, most = info.size_of(found.participant)
        if message.sender is not None:
            conversation.outsiders[sender] = message.reply_to or (message.sender,)
        if sender not in members and most is not None and len(members) >= most:
            self._unexpected(agent, acl, f"{', '.join(members)} takes part as {found.participant} already")
        elif sender not in members and found.participant in conversation.chosen:
            self._unexpected(agent, acl, f"{sender} does not take part as {found.participant}")
        elif reason := self._answers_nothing(message, sender, conversation):
            self._unexpected(agent, acl, reason)
        else:
            if sender not in members:
                members.append(sender)
            self._deliver(agent, acl)
        self._close(name)

    def _conversation_of(self, agent: Receiver, message: FipaMessage, sender: str) -> str:
        """The conversation of a message that names none; empty: it begins one.

        It is that of the message it answers. If it names none either, and it can begin none, it is the only
        one in which its sender takes part and the agent receives such a message.

        Raises:
            NotUnderstood: it may be one of several.
        """
        if message.in_reply_to:
            return self._asked.get(message.in_reply_to, "")
        performative = performative_of(message.performative)
        named = external_agents.parameter(message, external_agents.MESSAGE)

        def has(kinds: Iterable[tuple[str, str]]) -> bool:
            return any(act == performative and named in ("", kind) for act, kind in kinds)

        infos = external_agents.played_as(message.protocol, agent.plan.branches)
        if any(has(info.opens) for info in infos):
            return ""
        found = [
            name
            for name, conversation in self._conversations.items()
            if any(sender in names for names in conversation.members.values())
            and any(
                who == agent.name and place.info in infos and has(place.info.receives)
                for (who, _), place in conversation.places.items()
            )
        ]
        if len(found) > 1:
            raise external_agents.NotUnderstood(
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
    ) -> external_agents.Understood:
        """What a message of an outsider means in a conversation. Raises NotUnderstood."""
        branches = agent.plan.branches
        if conversation is None:
            protocol = message.protocol
            infos = external_agents.played_as(protocol, branches)
            performative = performative_of(message.performative)
            first = tuple(info for info in infos if any(act == performative for act, _ in info.opens))
            # A type that does not begin one is understood only where none does.
            groups = tuple(replace(info, receives=info.opens) for info in first), tuple(infos)
            context = external_agents.Context(groups)
        else:
            protocol = conversation.protocol
            if not external_agents.plays(protocol, message.protocol or protocol):
                raise external_agents.NotUnderstood(f"the conversation is one of {protocol}")
            infos = [info for info in branches if info.protocol == protocol]
            inside = tuple(place.info for (who, _), place in conversation.places.items() if who == agent.name)
            rest = tuple(info for info in infos if info not in inside)
            parts = [part for part, names in conversation.members.items() if sender in names]
            said = conversation.said_outside
            answered = said.get(message.in_reply_to)
            context = external_agents.Context(
                (inside, rest),
                parts[0] if len(parts) == 1 else "",
                None if answered is None else (answered.performative, answered.message),
                tuple(
                    (item.performative, item.message) for item in said.values() if sender in item.receivers
                ),
            )
        if not infos:
            raise external_agents.NotUnderstood(
                f"{agent.name} plays no part in {protocol[:100] or 'a protocol'}"
            )
        return external_agents.understood(message, agent.plan, context, agent.kinds)

    def _answers_nothing(self, message: FipaMessage, sender: str, conversation: Conversation) -> str:
        """Why the message that an outsider says it answers is none that it was sent; empty if it is."""
        answered = message.in_reply_to
        if not answered or conversation.forgotten:
            return ""
        said = conversation.said_outside.get(answered)
        if said is not None and sender in said.receivers:
            return ""
        speaker = answered.rpartition("-")[0]
        if said is None and speaker in self._plans and speaker not in self._agents:
            return ""  # only the agent's own process knows
        return f"{sender} was sent no {answered[:100]} in this conversation, which it answers"

    def _deadline(self, agent: Receiver, message: FipaMessage, sender: str) -> int | None:
        """Until when an outsider wants an answer; None, and told, if what it says of that cannot be read."""
        try:
            return external_agents.deadline(message, self._driver.clock)
        except ValueError as problem:
            what = f"{message.performative} of {sender} is taken without its deadline"
            self._told.fault(agent.name, f"{what}: {problem} (reply-by)")
            return None

    def _not_understood(
        self, to: str, message: FipaMessage, identity: Identity, reason: str, *, answered: bool = True
    ) -> None:
        """Tell of a message of an outsider that nobody can be given, and answer it."""
        self._told.meaningless(to, message, identity, reason)
        conversation = self._conversations.get(
            message.conversation or self._asked.get(message.in_reply_to, "")
        )
        if answered and conversation is not None and to in self._agents:
            self._counting.meaningless(self._agents[to], conversation, identity[0], message.in_reply_to)
        if (
            answered
            and message.sender is not None
            and performative_of(message.performative) != NOT_UNDERSTOOD
        ):
            agent = self._agents.get(to)
            own = agent.identity() if agent is not None else (to, next(self._numbers))
            answer = external_agents.answer(message, to, NOT_UNDERSTOOD, reason, name_of(own))
            self._told.answered_outside(answer, own, identity)
            if conversation is not None:
                conversation.note(answer.reply_with, NOT_UNDERSTOOD, "", identity[0])
            self._carry_outside(to, answer, answer.receivers)

    def appeared(self, name: str) -> None:
        """An agent of the team that runs elsewhere is there."""
        self.directory.appeared(name, self._plans[name])

    def vanished(self, name: str, reason: Reason = "crashed") -> None:
        """An agent elsewhere is gone: tell it in each conversation here that counts on it."""
        with self._driver.holding(), self._lock:
            self.directory.disappeared(name)
            self._management.disappeared(name)
            self._tell_gone(name, reason, elsewhere=True)

    def _tell_outside(self, sender: str, message: FipaMessage, to: Iterable[AgentIdentifier]) -> None:
        with self._driver.holding(), self._lock:
            self._carry_outside(sender, message, to)

    def _tell_gone(self, name: str, reason: Reason, *, elsewhere: bool) -> None:
        """Tell of an agent that is gone in the middle of the conversations that count on it.

        A branch with a transition for it gets it as mail, once for each participant that the agent was.
        """
        for known, conversation in list(self._conversations.items()):
            parts = [
                part
                for part, who in conversation.members.items()
                if name in who and (name, part) not in conversation.past
            ]
            places = [(to, place) for (to, _), place in conversation.places.items() if to != name]
            for part in parts:
                self._losses.over(conversation, known, name, part, reason)
            for to, place in places if elsewhere and parts else ():
                if not any(part in place.info.loses for part in parts):
                    self._told.takes_part("gone", to, place, known, peer=name, reason=reason)
            self._close(known)

    def _deliver(self, agent: Receiver, acl: AclMessage) -> None:
        conversation = self._conversations.get(acl.conversation)
        place = conversation.places.get((agent.name, acl.to)) if conversation is not None else None
        if place is not None:
            if not self._receives(place.info, acl):
                self._unexpected(agent, acl, f"{acl.to} does not receive it")
            elif len(place.waiting) >= self._queue:
                self._refuse(agent, place, acl)
            else:
                self._post(agent, place, acl)
            return
        if conversation is None:
            self._unexpected(agent, acl, "the conversation is closed")
            return
        if (agent.name, acl.to) in conversation.past:
            self._unexpected(agent, acl, "its part in the conversation is over")
            return
        played = [
            info
            for info in agent.plan.branches
            if (info.protocol, info.participant) == (acl.protocol, acl.to)
        ]
        if played and played[0].version != acl.version:
            self._unexpected(agent, acl, f"{acl.sender} plays another version of {acl.protocol}")
            return
        info = next((info for info in played if self._receives(info, acl)), None)
        if info is None or agent.over:
            reason = f"{agent.name} has ended" if agent.over else f"{agent.role} does not receive it"
            self._unexpected(agent, acl, reason)
            return
        desk = self._desks[agent.name]
        invitations = desk.invitations
        if invitations.size >= WAITING:
            self._unexpected(agent, acl, f"{WAITING} messages wait already for a participant to be entered")
            return
        part = acl.protocol, acl.to
        is_invited = invitations.has(part, acl.conversation)
        if not is_invited and (acl.performative, acl.message) not in info.opens:
            if acl.sender not in self._plans:
                self._unexpected(agent, acl, f"{acl.to} does not begin with it")
                return
            invitations.add_early(
                part, acl
            )  # what opens the conversation may be on its way from another agent
            conversation.invitations += 1
            return
        place = desk.first_free(part)
        if place is not None and not is_invited:
            self._take_part(agent, place, acl.conversation, "join")
            self._post(agent, place, acl)
            for early in invitations.take_early(acl.conversation, part):
                conversation.invitations -= 1
                self._post(agent, place, early)
            return
        invitations.add(part, acl)
        conversation.invitations += 1

    def _receives(self, info: BranchInfo, acl: AclMessage) -> bool:
        return (acl.performative, acl.message) in info.receives

    def _post(self, agent: Receiver, place: Participation, acl: AclMessage) -> None:
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
        )
        place.waiting[acl.identity] = mail
        agent.post(acl.identity, mail, conversation=acl.conversation)

    def _refuse(self, agent: Receiver, place: Participation, acl: AclMessage) -> None:
        """Too many messages wait already that the participant does not take."""
        if not place.was_full:
            place.was_full = True
            text = f"{self._queue} messages wait for {acl.to} of {agent.name} and are not taken"
            self._told.fault(agent.name, f"{text}: what comes now is refused")
        self._unexpected(agent, acl, f"{self._queue} messages wait already for {acl.to}")

    def _unexpected(self, agent: Receiver, acl: AclMessage, reason: str) -> None:
        """Tell of a message that nobody expects, and answer it, but never an answer to that."""
        self._told.unexpected(agent.name, acl, reason)
        self._counting.unexpected(agent, self._conversations.get(acl.conversation), acl)
        if acl.performative != NOT_UNDERSTOOD:
            self._answer(agent, acl, reason)

    def _answer(self, agent: Receiver, acl: AclMessage, reason: str) -> None:
        """Answer a message that nobody expects."""
        identity = agent.identity()
        answer = AclMessage(
            NOT_UNDERSTOOD,
            agent.name,
            (acl.sender,),
            acl.message,
            acl.content,
            acl.protocol,
            acl.conversation,
            acl.to,
            acl.participant,
            identity,
            acl.version,
            acl.ontology,
            name_of(identity),
            acl.reply_with,
        )
        self._told.sent(answer, [acl.identity])
        if acl.sender in self._plans:
            self._bring(acl.sender, answer)
            return
        conversation = self._conversations.get(acl.conversation)
        known = conversation.outsiders if conversation is not None else {}
        to = known.get(acl.sender, (AgentIdentifier(acl.sender),))
        if conversation is not None:
            conversation.note(answer.reply_with, NOT_UNDERSTOOD, answer.message, acl.sender)
        self._carry_outside(agent.name, external_agents.written(answer, to, reason), to)

    # ---- what the charts do ------------------------------------------------------------------

    def joined(self, agent: Receiver, branch: str) -> None:
        """A branch was entered: it is free, and takes the conversation that waits longest."""
        with self._driver.holding(), self._lock:
            place = Participation(agent.branch_info(branch))
            desk = self._desks[agent.name]
            desk.branches[branch] = place
            waiting = desk.invitations.take(place.part)
            if not waiting:
                desk.free.setdefault(place.part, {})[branch] = place
                return
            name = waiting[0].conversation
            self._conversations[name].invitations -= len(waiting)
            self._take_part(agent, place, name, "join")
            for acl in waiting:
                if self._receives(place.info, acl):
                    self._post(agent, place, acl)
                else:
                    self._unexpected(agent, acl, f"{acl.to} does not receive it")

    def leaving(self, agent: Receiver, reason: Reason | None) -> None:
        """Parts of an agent that end from now on before their END do so for this reason; None: in silence."""
        self._desks[agent.name].leaving = reason

    def left(self, agent: Receiver, branch: str, completed: bool = False) -> None:
        """A branch was left: its part in the conversation is over, and what it did not take is given up."""
        with self._driver.holding(), self._lock:
            desk = self._desks[agent.name]
            place = desk.branches.pop(branch, None)
            if place is None:
                return
            if place.conversation is None:
                desk.free[place.part].pop(branch)
                return
            name = place.conversation
            conversation = self._conversations[name]
            conversation.places.pop((agent.name, place.info.participant), None)
            reason: Reason | None = "completed" if completed else desk.leaving
            self._told.takes_part(
                "leave",
                agent.name,
                place,
                name,
                untaken=tuple(place.waiting),
                reason=None if completed else reason,
            )
            if reason is None:
                conversation.past[agent.name, place.info.participant] = "left"
            else:
                self._losses.ended(agent, place, name, conversation, reason)
            self._close(name)

    def _close(self, name: str) -> None:
        """Forget a conversation in which nobody takes part or may still do so."""
        conversation = self._conversations.get(name)
        if conversation is None or conversation.places:
            return
        if conversation.invitations and not self._transport.networked:
            self._refuse_early(name, conversation)
        if conversation.invitations or name not in self._conversations:
            return
        del self._conversations[name]
        if self._transport.networked or conversation.outsiders:
            self._over[name] = conversation.past
            if len(self._over) > REMEMBERED:
                del self._over[next(iter(self._over))]

    def _refuse_early(self, name: str, conversation: Conversation) -> None:
        """Nobody can send what opens a conversation any more: answer what waits for that."""
        for agent, desk in self._desks.items():
            for acl in desk.invitations.take_early(name):
                conversation.invitations -= 1
                self._unexpected(self._agents[agent], acl, f"{acl.to} does not begin with it")

    def taken(self, agent: Receiver, branch: str, identity: Identity) -> None:
        """A transition or an activity took a message."""
        with self._lock:
            place = self._desks[agent.name].branches.get(branch)
            if place is None:
                return
            mail = place.waiting.pop(identity, None)
            if mail is not None:
                kind = (mail.performative, mail.message, mail.sender)
                place.taken.pop(kind, None)
                place.taken[kind] = mail
                place.answered[mail.sender] = mail
        if place.completed:
            with self._driver.holding(), self._lock:
                self._losses.consumed(agent, place)

    def taken_by(self, agent: Receiver, branch: str) -> tuple[AgentMessage, ...]:
        """What a participation has taken: the last of each kind and sender, the newest at the end."""
        with self._lock:
            place = self._desks[agent.name].branches.get(branch)
            taken = () if place is None else place.taken.values()
            return tuple(mail for mail in taken if mail.performative != LOST)

    def arrives(self, agent: Receiver, mail: AgentMessage, conversation: str | None) -> bool:
        """Whether mail that was under way still finds its participant; tells and answers if it does not."""
        with self._driver.holding(), self._lock:
            place = self._desks[agent.name].branches.get(mail.branch)
            if conversation is None or (place is not None and place.conversation == conversation):
                return True
            if mail.performative == LOST:
                return False
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
            self._unexpected(agent, acl, "its part in the conversation is over")
            return False

    def gone(self, agent: Receiver, reason: str = "") -> None:
        """An agent has ended or left its plan: it takes part in nothing, and what waited is answered.

        Why its parts are over was said before, with `leaving`.
        """
        with self._driver.holding(), self._lock:
            desk = self._desks[agent.name]
            for branch in list(desk.branches):
                self.left(agent, branch)
            if desk.leaving not in (None, "left"):  # those who have asked it, and it has not joined
                self._tell_gone(agent.name, desk.leaving, elsewhere=False)
            desk.leaving = "left"
            for acl in desk.invitations.clear():
                self._unexpected(agent, acl, reason or f"{agent.name} has ended")
                self._conversations[acl.conversation].invitations -= 1
                self._close(acl.conversation)
            if agent.over:
                self.directory.disappeared(agent.name)

    # ---- another plan ------------------------------------------------------------------------

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now."""
        with self._lock:
            self._plans.update(plans)
            self._playing = None
            for name, plan in plans.items():
                self.directory.follows(name, plan)

    @contextmanager
    def still(self) -> Iterator[None]:
        """Inside, nobody else sends, joins or leaves; agents that are woken step afterwards."""
        with self._driver.holding(), self._lock:
            yield

    def inside(self, agent: Receiver) -> list[tuple[BranchInfo, str]]:
        """The conversations that an agent takes part in, each with the branch that does."""
        with self._lock:
            places = self._desks[agent.name].branches.values()
            return [(place.info, place.conversation) for place in places if place.conversation is not None]

    def place(self, agent: Receiver, branch: str) -> tuple[str | None, bool]:
        """The conversation of an entered branch, if it is in one; and whether the branch is entered."""
        with self._lock:
            place = self._desks[agent.name].branches.get(branch)
            return (None, False) if place is None else (place.conversation, True)

    def open(self) -> list[tuple[str, str, list[tuple[str, str, str | None]]]]:
        """The open conversations: name, protocol, and who is still in it as (agent, participant, branch).

        The branch is None where the agent runs elsewhere, or was invited and has not joined yet.
        """
        with self._lock:
            found = []
            for name, conversation in self._conversations.items():
                here = {
                    (agent, participant): place.info.label
                    for (agent, participant), place in conversation.places.items()
                }
                members = dict.fromkeys(
                    (agent, participant)
                    for participant, agents in conversation.members.items()
                    for agent in agents
                    if (agent, participant) not in conversation.past
                )
                members.update(dict.fromkeys(here))
                found.append((name, conversation.protocol, [(*who, here.get(who)) for who in members]))
            return found

    def unread(self) -> list[tuple[str, str, str, str, str, str]]:
        """The agent messages that wait here: receiver, participant, conversation, performative, message and
        sender."""
        with self._lock:
            found = []
            for agent, desk in self._desks.items():
                for place in desk.branches.values():
                    found += [
                        (
                            agent,
                            place.info.participant,
                            place.conversation or "",
                            mail.performative,
                            mail.message,
                            mail.sender,
                        )
                        for mail in place.waiting.values()
                        if mail.performative != LOST
                    ]
                found += [
                    (agent, acl.to, acl.conversation, acl.performative, acl.message, acl.sender)
                    for acl in desk.invitations.waiting()
                ]
            return found

    def carry(self, agent: Receiver, labels: Mapping[str, str], messages: Messages) -> None:
        """The agent goes on under its new plan, in which the states have these labels.

        What it was invited to and now plays in another way is answered `not_understood`.
        """
        with self._driver.holding(), self._lock:
            self.renew({agent.name: agent.plan})
            infos = {info.label: info for info in agent.plan.branches}
            desk = self._desks[agent.name]
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
                if place.conversation is None:
                    desk.free.setdefault(place.part, {})[label] = place
            for acl in desk.invitations.clear():
                self._conversations[acl.conversation].invitations -= 1
                self._deliver(agent, replace(acl, content=agent.understood(acl.content)))
                self._close(acl.conversation)


def _at_least(least: int) -> str:
    return "one" if least <= 1 else f"{least} or more"


def _said_outside(message: FipaMessage) -> tuple[Any, ...]:
    """What tells one message of an outsider from the next."""
    return message.reply_with, message.conversation, message.performative.lower(), message.content


def _mails(items: Iterable[AgentMessage], branch: str, messages: Messages) -> list[AgentMessage]:
    """AgentMessage for the branch as it is called now; what there is no message for any more is left out."""
    found: list[AgentMessage] = []
    for item in items:
        with suppress(LookupError):
            found.append(mailed(item if item.branch == branch else replace(item, branch=branch), messages))
    return found
