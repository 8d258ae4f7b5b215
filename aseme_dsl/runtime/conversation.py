"""Conversations: one run of a protocol between its participants, and the agent messages that belong to it.

A conversation is opened by the first message that a participant sends after it was entered. A message goes to
everybody who takes part as the addressed participant or, while nobody does, to all other agents that play
it. At the receiver it goes to the branch that takes part in that conversation; if none does, it is offered to
a free branch of the participant, or waits until one is entered or free, with `WAITING` others at the most. A
branch that is left takes part no more. What a participant does not list as received, what comes when too many
wait already, and what comes for a participation that is over, is unexpected: it is told in the trace and
answered `not_understood`.
"""

from __future__ import annotations

import threading
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.acl import NOT_UNDERSTOOD, AclMessage, name_of
from aseme_dsl.runtime.as_json import to_json
from aseme_dsl.runtime.board import QUEUE
from aseme_dsl.runtime.convert import Messages, mailed
from aseme_dsl.runtime.inputs import LOST, Identity, Mail
from aseme_dsl.runtime.plan import BranchInfo, Plan
from aseme_dsl.runtime.trace import Trace
from aseme_dsl.runtime.transport.port import LOCAL, Transport

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent import Agent
    from aseme_dsl.runtime.driver import Driver
    from aseme_dsl.runtime.faults import Links

WAITING = 1000
"""So many messages wait at the most, at one agent, for a participant to be entered."""
REMEMBERED = 4096
"""Of so many conversations that are over here is known who has left them, while others may not know it."""


@dataclass(slots=True)
class _Branch:
    """A protocol branch that is entered: in which conversation it takes part, and what it has not taken."""

    info: BranchInfo
    conversation: str | None = None
    waiting: list[Mail] = field(default_factory=list)
    taken: dict[tuple[str, str, str], Mail] = field(default_factory=dict)
    """The last one taken of each kind and sender, the newest at the end."""
    answered: dict[str, Mail] = field(default_factory=dict)
    """The last one taken of each sender: what is sent to it next is an answer to that."""
    was_full: bool = False


@dataclass(slots=True)
class _Conversation:
    """Who takes part, by participant; who is invited, and who has left."""

    protocol: str
    members: dict[str, list[str]] = field(default_factory=dict)
    past: set[tuple[str, str]] = field(default_factory=set)


class Conversations:
    """All conversations of a team. May be used from any thread."""

    def __init__(
        self, driver: Driver, trace: Trace, transport: Transport = LOCAL, queue: int = QUEUE
    ) -> None:
        """So many messages, `queue`, may wait for a participant to take them."""
        self._driver = driver
        self._trace = trace
        self._transport = transport
        self._queue = queue
        self._agents: dict[str, Agent] = {}
        self._plans: dict[str, Plan] = {}
        """Of everybody, also of agents in other processes, in the team's order."""
        self._over: dict[str, set[tuple[str, str]]] = {}
        """Who has left the conversations that are forgotten here but may go on elsewhere, the newest last."""
        self.links: Links | None = None
        """The simulated links between the agents, if they are not perfect."""
        self._branches: dict[str, dict[str, _Branch]] = {}
        self._queues: dict[str, list[tuple[AclMessage, BranchInfo]]] = {}
        self._conversations: dict[str, _Conversation] = {}
        self._opened: dict[tuple[str, str], int] = {}
        self._lock = threading.RLock()

    def join(self, agent: Agent) -> None:
        """An agent can be talked to; the order in which they come is the team's."""
        self._agents[agent.name] = agent
        self._branches[agent.name] = {}
        self._queues[agent.name] = []
        self.join_elsewhere(agent.name, agent.plan)

    def join_elsewhere(self, name: str, plan: Plan) -> None:
        """An agent of the team runs in another process, with this plan; it counts in the team's order."""
        self._plans[name] = plan

    # ---- sending -----------------------------------------------------------------------------

    def check_receiver(self, agent: Agent, branch: str, to: str) -> None:
        """Raises LookupError if `to` is neither a participant of the branch's protocol nor an agent."""
        protocol = agent.branch_info(branch).protocol
        if to not in self._plans and not self._players(protocol, to):
            raise LookupError(f"{to} is neither an agent nor a participant of {protocol} that somebody plays")

    def send(
        self,
        agent: Agent,
        branch: str,
        performative: str,
        message: str,
        content: Any,
        to: str,
        excepts: Collection[str] = (),
    ) -> None:
        """Send in the conversation of a branch, which it opens if it has none; `to` may be an agent.

        It does not go to the agents in `excepts`.
        """
        with self._driver.holding(), self._lock:
            place = self._place_of(agent, branch, performative, message, content)
            if place is not None:
                invited, part = self._receivers(agent, place, to)
                receivers = tuple(name for name in invited if name not in excepts)
                self._send(agent, place, performative, message, content, receivers, part)
                if not invited:
                    text = f"{performative} {message} reaches nobody: no other agent plays {part}"
                    self._trace.fault(self._driver.clock.now(), agent.name, text)

    def send_to_agent(
        self, agent: Agent, branch: str, performative: str, message: str, content: Any, to: str
    ) -> None:
        """Send to one agent, as the participant that it plays and that receives such a message."""
        with self._driver.holding(), self._lock:
            part = self._part_of(agent, branch, performative, message, to)
            if part is None:
                protocol = agent.branch_info(branch).protocol
                text = (
                    f"{performative} {message} is not sent: {to} plays no part of {protocol} that receives it"
                )
                self._trace.fault(self._driver.clock.now(), agent.name, text)
                return
            place = self._place_of(agent, branch, performative, message, content)
            if place is not None:
                self._send(agent, place, performative, message, content, (to,), part)

    def _part_of(self, agent: Agent, branch: str, performative: str, message: str, to: str) -> str | None:
        """As which participant an agent gets a message: the one that it is in this conversation, if any."""
        protocol = agent.branch_info(branch).protocol
        plan = self._plans.get(to)
        parts = [
            info.participant
            for info in (plan.branches if plan is not None else ())
            if info.protocol == protocol and (performative, message) in info.receives
        ]
        place = self._branches[agent.name].get(branch)
        conversation = self._conversations.get((place.conversation or "") if place is not None else "")
        members = conversation.members if conversation is not None else {}
        return next((part for part in parts if to in members.get(part, ())), next(iter(parts), None))

    def _place_of(
        self, agent: Agent, branch: str, performative: str, message: str, content: Any
    ) -> _Branch | None:
        """The branch in a conversation, which is opened if there is none; None, told, if it was left."""
        place = self._branches[agent.name].get(branch)
        if place is None:
            info = agent.branch_info(branch)
            reason = "its participant was left"
            self._tell("unsent", agent, performative, message, content, info, reason=reason)
        elif place.conversation is None:
            self._open(agent, place)
        return place

    def _send(
        self,
        agent: Agent,
        place: _Branch,
        performative: str,
        message: str,
        content: Any,
        receivers: tuple[str, ...],
        part: str,
    ) -> None:
        assert place.conversation is not None
        identity = agent.identity()
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
        )
        answered = place.answered
        self._tell_sent(acl, [answered[name].identity for name in receivers if name in answered])
        for name in receivers:
            heard = answered.get(name)
            self._bring(name, acl if heard is None else replace(acl, in_reply_to=heard.reply_with))

    def _bring(self, name: str, acl: AclMessage) -> None:
        """Deliver a message to an agent here, or have it carried to one elsewhere."""
        if name in self._agents:
            if self.links is None or name == acl.sender:
                self._deliver(self._agents[name], acl)
            else:
                agent = self._agents[name]
                self.links.carry(
                    acl.sender, name, "mail", acl.message, acl.identity, lambda: self._deliver(agent, acl)
                )
            return
        conversation = self._conversations.get(acl.conversation)
        self._transport.carry(acl, name, conversation.members if conversation is not None else {})

    def _open(self, agent: Agent, place: _Branch) -> None:
        protocol = place.info.protocol
        number = self._opened[protocol, agent.name] = self._opened.get((protocol, agent.name), 0) + 1
        name = f"{protocol}-{agent.name}-{self._transport.life}{number}"
        self._conversations[name] = _Conversation(protocol)
        self._take_part(agent, place, name, "open")

    def _take_part(self, agent: Agent, place: _Branch, name: str, what: str) -> None:
        place.conversation = name
        members = self._conversations[name].members.setdefault(place.info.participant, [])
        if agent.name not in members:
            members.append(agent.name)
        self._told(what, agent, place, name)

    def _receivers(self, agent: Agent, place: _Branch, to: str) -> tuple[tuple[str, ...], str]:
        """Who is addressed, and as which participant."""
        assert place.conversation is not None
        conversation = self._conversations[place.conversation]
        protocol = place.info.protocol
        if to in self._plans and not self._players(protocol, to):
            part = next((p for p, members in conversation.members.items() if to in members), None)
            if part is None:
                part = next((b.participant for b in self._plans[to].branches if b.protocol == protocol), "")
            return (to,), part
        members = conversation.members.get(to)
        if members is None:
            members = conversation.members[to] = [n for n in self._players(protocol, to) if n != agent.name]
        return tuple(members), to

    def _players(self, protocol: str, participant: str) -> list[str]:
        return [
            name
            for name, plan in self._plans.items()
            if any((b.protocol, b.participant) == (protocol, participant) for b in plan.branches)
        ]

    # ---- delivering --------------------------------------------------------------------------

    def arrived(self, agent: Agent, acl: AclMessage, members: Mapping[str, Sequence[str]]) -> None:
        """The transport has brought a message for an agent, with what its sender knows of who takes part."""
        with self._driver.holding(), self._lock:
            self._tell_received(agent, acl)
            played = (info.version for info in agent.plan.branches if info.protocol == acl.protocol)
            acl = replace(acl, version=next(played, ""))  # the transport brings only what is of our model
            conversation = self._conversations.get(acl.conversation)
            if conversation is None:
                past = self._over.pop(acl.conversation, set())
                conversation = _Conversation(acl.protocol, past=past)
                self._conversations[acl.conversation] = conversation
            for part, names in members.items():
                known = conversation.members.setdefault(part, [])
                known.extend(name for name in names if name not in known)
            self._deliver(agent, acl)
            if acl.conversation in self._conversations:
                self._close(acl.conversation)

    def vanished(self, name: str) -> None:
        """An agent elsewhere is gone: tell it in each conversation here that counts on it."""
        with self._driver.holding(), self._lock:
            self._tell_gone(name, elsewhere=True)

    def _tell_gone(self, name: str, *, elsewhere: bool) -> None:
        """Tell of an agent that is gone in the middle of the conversations that count on it.

        A branch with a transition for it gets it as mail, once for each participant that the agent was.
        """
        for agent in self._agents.values():
            for place in self._branches[agent.name].values() if agent.name != name else ():
                conversation = self._conversations.get(place.conversation or "")
                if conversation is None:
                    continue
                parts = [
                    part
                    for part, who in conversation.members.items()
                    if name in who and (name, part) not in conversation.past
                ]
                awaited = [part for part in parts if part in place.info.loses]
                for part in awaited:
                    identity = agent.identity()
                    mail = Mail(place.info.label, LOST, "", None, part, name, identity)
                    self._told("gone", agent, place, place.conversation or "", None, name, part, identity)
                    place.waiting.append(mail)
                    agent.post(identity, mail, conversation=place.conversation)
                if elsewhere and parts and not awaited:
                    self._told("gone", agent, place, place.conversation or "", peer=name)

    def _deliver(self, agent: Agent, acl: AclMessage) -> None:
        place = self._place_in(agent, acl)
        if place is not None:
            if not self._receives(place.info, acl):
                self._unexpected(agent, acl, f"{acl.to} does not receive it")
            elif len(place.waiting) >= self._queue:
                self._refuse(agent, place, acl)
            else:
                self._post(agent, place, acl)
            return
        conversation = self._conversations.get(acl.conversation)
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
        queue = self._queues[agent.name]
        if len(queue) >= WAITING:
            self._unexpected(agent, acl, f"{WAITING} messages wait already for a participant to be entered")
            return
        if not any(other.conversation == acl.conversation for other, _ in queue):
            for place in self._branches[agent.name].values():
                if self._is_free(place, acl):
                    self._take_part(agent, place, acl.conversation, "join")
                    self._post(agent, place, acl)
                    return
        queue.append((acl, info))

    def _place_in(self, agent: Agent, acl: AclMessage) -> _Branch | None:
        return next(
            (
                place
                for place in self._branches[agent.name].values()
                if place.conversation == acl.conversation and place.info.participant == acl.to
            ),
            None,
        )

    def _is_free(self, place: _Branch, acl: AclMessage) -> bool:
        return place.conversation is None and (place.info.protocol, place.info.participant) == (
            acl.protocol,
            acl.to,
        )

    def _receives(self, info: BranchInfo, acl: AclMessage) -> bool:
        return (acl.performative, acl.message) in info.receives

    def _post(self, agent: Agent, place: _Branch, acl: AclMessage) -> None:
        mail = Mail(
            place.info.label,
            acl.performative,
            acl.message,
            agent.understood(acl.content),
            acl.participant,
            acl.sender,
            acl.identity,
            acl.reply_with,
        )
        place.waiting.append(mail)
        agent.post(acl.identity, mail, conversation=acl.conversation)

    def _refuse(self, agent: Agent, place: _Branch, acl: AclMessage) -> None:
        """Too many messages wait already that the participant does not take."""
        if not place.was_full:
            place.was_full = True
            text = f"{self._queue} messages wait for {acl.to} of {agent.name} and are not taken"
            self._trace.fault(self._driver.clock.now(), agent.name, f"{text}: what comes now is refused")
        self._unexpected(agent, acl, f"{self._queue} messages wait already for {acl.to}")

    def _unexpected(self, agent: Agent, acl: AclMessage, reason: str) -> None:
        """Tell of a message that nobody expects, and answer it, but never an answer to that."""
        self._trace.write(
            "unexpected",
            self._driver.clock.now(),
            agent=agent.name,
            input=list(acl.identity),
            performative=acl.performative,
            message=acl.message,
            sender=acl.sender,
            conversation=acl.conversation,
            reason=reason,
        )
        if acl.performative == NOT_UNDERSTOOD or acl.sender not in self._plans:
            return
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
        self._tell_sent(answer, [acl.identity])
        self._bring(acl.sender, answer)

    # ---- what the charts do ------------------------------------------------------------------

    def joined(self, agent: Agent, branch: str) -> None:
        """A branch was entered: it is free, and takes the conversation that waits longest."""
        with self._driver.holding(), self._lock:
            place = _Branch(agent.branch_info(branch))
            self._branches[agent.name][branch] = place
            queue = self._queues[agent.name]
            first = next((acl for acl, _ in queue if self._is_free(place, acl)), None)
            if first is None:
                return
            self._take_part(agent, place, first.conversation, "join")
            mine = [acl for acl, _ in queue if acl.conversation == first.conversation and acl.to == first.to]
            queue[:] = [entry for entry in queue if entry[0] not in mine]
            for acl in mine:
                if self._receives(place.info, acl):
                    self._post(agent, place, acl)
                else:
                    self._unexpected(agent, acl, f"{acl.to} does not receive it")

    def left(self, agent: Agent, branch: str) -> None:
        """A branch was left: its part in the conversation is over, and what it did not take is given up."""
        with self._driver.holding(), self._lock:
            place = self._branches[agent.name].pop(branch, None)
            if place is None or place.conversation is None:
                return
            name = place.conversation
            conversation = self._conversations[name]
            conversation.past.add((agent.name, place.info.participant))
            self._told(
                "leave", agent, place, name, untaken=[list(mail.identity) for mail in place.waiting] or None
            )
            self._close(name)

    def _close(self, name: str) -> None:
        """Forget a conversation in which nobody takes part or may still do so."""
        places = (place for branches in self._branches.values() for place in branches.values())
        invited = (acl for queue in self._queues.values() for acl, _ in queue)
        if not any(place.conversation == name for place in places) and not any(
            acl.conversation == name for acl in invited
        ):
            past = self._conversations.pop(name).past
            if self._transport.networked:
                self._over[name] = past
                if len(self._over) > REMEMBERED:
                    del self._over[next(iter(self._over))]

    def taken(self, agent: Agent, branch: str, identity: Identity) -> None:
        """A transition or an activity took a message."""
        with self._lock:
            place = self._branches[agent.name].get(branch)
            if place is None:
                return
            mail = next((item for item in place.waiting if item.identity == identity), None)
            if mail is not None:
                place.waiting.remove(mail)
                kind = (mail.performative, mail.message, mail.sender)
                place.taken.pop(kind, None)
                place.taken[kind] = mail
                place.answered[mail.sender] = mail

    def taken_by(self, agent: Agent, branch: str) -> tuple[Mail, ...]:
        """What a participation has taken: the last of each kind and sender, the newest at the end."""
        with self._lock:
            place = self._branches[agent.name].get(branch)
            taken = () if place is None else place.taken.values()
            return tuple(mail for mail in taken if mail.performative != LOST)

    def arrives(self, agent: Agent, mail: Mail, conversation: str | None) -> bool:
        """Whether mail that was under way still finds its participant; tells and answers if it does not."""
        with self._driver.holding(), self._lock:
            place = self._branches[agent.name].get(mail.branch)
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

    def lost(self, agent: Agent) -> None:
        """An agent leaves everything though its part is not done: others may wait to hear of it."""
        with self._driver.holding(), self._lock:
            self._tell_gone(agent.name, elsewhere=False)

    def gone(self, agent: Agent, reason: str = "") -> None:
        """An agent has ended or left its plan: it takes part in nothing, and what waited is answered."""
        with self._driver.holding(), self._lock:
            for branch in list(self._branches[agent.name]):
                self.left(agent, branch)
            queue, self._queues[agent.name] = self._queues[agent.name], []
            for acl, _ in queue:
                self._unexpected(agent, acl, reason or f"{agent.name} has ended")

    # ---- another plan ------------------------------------------------------------------------

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now."""
        with self._lock:
            self._plans.update(plans)

    @contextmanager
    def still(self) -> Iterator[None]:
        """Inside, nobody else sends, joins or leaves; agents that are woken step afterwards."""
        with self._driver.holding(), self._lock:
            yield

    def inside(self, agent: Agent) -> list[tuple[BranchInfo, str]]:
        """The conversations that an agent takes part in, each with the branch that does."""
        with self._lock:
            places = self._branches[agent.name].values()
            return [(place.info, place.conversation) for place in places if place.conversation is not None]

    def carry(self, agent: Agent, labels: Mapping[str, str], messages: Messages) -> None:
        """The agent goes on under its new plan, in which the states have these labels.

        What it was invited to and now plays in another way is answered `not_understood`.
        """
        with self._driver.holding(), self._lock:
            self._plans[agent.name] = agent.plan
            infos = {info.label: info for info in agent.plan.branches}
            places = self._branches[agent.name]
            for branch in [item for item in places if labels.get(item) not in infos]:
                self.left(agent, branch)
            carried: dict[str, _Branch] = {}
            for branch, place in places.items():
                label = labels[branch]
                place.info = infos[label]
                place.waiting = _mails(place.waiting, label, messages)
                place.taken = {
                    (mail.performative, mail.message, mail.sender): mail
                    for mail in _mails(place.taken.values(), label, messages)
                }
                carried[label] = place
            self._branches[agent.name] = carried
            queue, self._queues[agent.name] = self._queues[agent.name], []
            for acl, _ in queue:
                self._deliver(agent, replace(acl, content=agent.understood(acl.content)))

    # ---- the trace ---------------------------------------------------------------------------

    def _tell_sent(self, acl: AclMessage, answered: Sequence[Identity]) -> None:
        if self._trace.active:
            self._trace.write(
                "mail",
                self._driver.clock.now(),
                agent=acl.sender,
                sequence=acl.identity[1],
                **_said(acl),
                to=list(acl.receivers),
                answers=[list(identity) for identity in answered] or None,
            )

    def _tell(
        self,
        kind: str,
        agent: Agent,
        performative: str,
        message: str,
        content: Any,
        info: BranchInfo,
        reason: str,
    ) -> None:
        if self._trace.active:
            self._trace.write(
                kind,
                self._driver.clock.now(),
                agent=agent.name,
                performative=performative,
                message=message,
                content=to_json(content),
                protocol=info.protocol,
                participant=info.participant,
                reason=reason,
            )

    def _tell_received(self, agent: Agent, acl: AclMessage) -> None:
        if self._trace.active:
            self._trace.write(
                "received",
                self._driver.clock.now(),
                agent=agent.name,
                input=list(acl.identity),
                **_said(acl),
                in_reply_to=acl.in_reply_to or None,
            )

    def _told(
        self,
        what: str,
        agent: Agent,
        place: _Branch,
        name: str,
        untaken: list[list[Any]] | None = None,
        peer: str | None = None,
        played: str | None = None,
        identity: Identity | None = None,
    ) -> None:
        self._trace.write(
            "conversation",
            self._driver.clock.now(),
            agent=agent.name,
            sequence=None if identity is None else identity[1],
            what=what,
            conversation=name,
            participant=place.info.participant,
            branch=place.info.label,
            untaken=untaken,
            peer=peer,
            played=played,
        )


def _said(acl: AclMessage) -> dict[str, Any]:
    """An agent message as the trace tells it."""
    return {
        "performative": acl.performative,
        "message": acl.message,
        "content": to_json(acl.content),
        "protocol": acl.protocol,
        "conversation": acl.conversation,
        "participant": acl.participant,
        "receiver": acl.to,
    }


def _mails(items: Iterable[Mail], branch: str, messages: Messages) -> list[Mail]:
    """Mail for the branch as it is called now; what there is no message for any more is left out."""
    found: list[Mail] = []
    for item in items:
        with suppress(LookupError):
            found.append(mailed(item if item.branch == branch else replace(item, branch=branch), messages))
    return found
