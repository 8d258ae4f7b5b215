"""Conversations: one run of a protocol between its participants, and the agent messages that belong to it.

A conversation is opened by the first message that a participant sends after it was entered. A message goes to
all agents that take part as the addressed participant or, without one, to all other agents that play it. At
the receiver it goes to the branch that takes part in that conversation. If none does, it is offered to a free
branch of the participant, or waits until one is entered or free, with at most `WAITING` others. A branch that
is left takes part no more. A message is unexpected if the participant does not list it as received, if too
many wait already, or if the participation is over. It is recorded in the trace and answered `not_understood`.

External agents may take part, too. `exchange.external_inbox` hands on a message that is understood like any
other. A message that was received before is recorded only.
"""

from __future__ import annotations

import threading
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace

from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Identity, Reason
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan
from aseme_dsl.runtime.conversation.conversation_trace import ConversationTrace
from aseme_dsl.runtime.conversation.counting import Counting
from aseme_dsl.runtime.conversation.directory import Directory
from aseme_dsl.runtime.conversation.exchange.external_inbox import ExternalInbox
from aseme_dsl.runtime.conversation.exchange.external_outbox import ExternalOutbox, Hears
from aseme_dsl.runtime.conversation.exchange.given import Giving
from aseme_dsl.runtime.conversation.exchange.members import Members
from aseme_dsl.runtime.conversation.exchange.participant_delivery import Delivery
from aseme_dsl.runtime.conversation.exchange.parts import Parts
from aseme_dsl.runtime.conversation.exchange.sending import Sending
from aseme_dsl.runtime.conversation.free_messages import Mailbox
from aseme_dsl.runtime.conversation.losses import reason_of
from aseme_dsl.runtime.conversation.management import Management
from aseme_dsl.runtime.conversation.participation import MESSAGES, Desk
from aseme_dsl.runtime.message.acl import AclMessage, AgentIdentifier, FipaMessage
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.message.free import ACLMessage
from aseme_dsl.runtime.ports import Links, Receiver
from aseme_dsl.runtime.time.timers import Scheduler
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.transport.port import LOCAL, Transport


class Conversations:
    """All conversations of a team, as a thin face: each method takes the lock and calls a part of `exchange`.

    May be used from any thread.
    """

    def __init__(
        self,
        driver: Scheduler,
        trace: Trace,
        transport: Transport = LOCAL,
        queue: int = QUEUE,
        system: str = "",
        limit: int = MESSAGES,
    ) -> None:
        """So many messages, `queue`, may wait for a participant to take them; each has `limit` at most."""
        self.directory = Directory(driver, trace)
        self.links: Links | None = None
        """The simulated links between the agents, if they are not perfect."""
        self._driver = driver
        self._lock = threading.RLock()
        self._told = told = ConversationTrace(driver, trace)
        self._members = members = Members(self.directory, limit)
        self._lives: dict[str, int | None] = {}
        """Which incarnation each agent elsewhere was when it was there last."""
        counting = Counting(told, self.directory.is_gone)
        self._outside = outside = ExternalOutbox(told, transport)
        self._management = Management(self.directory, system, self._tell_outside, members.plans)
        self._delivery = delivery = Delivery(
            members, told, counting, outside, transport, lambda: self.links, queue, driver.clock
        )
        self._sending = Sending(members, told, counting, delivery, transport.life)
        self._inbox = ExternalInbox(
            members, told, counting, delivery, outside, driver.clock, transport.behind
        )
        self._parts = Parts(members, told, delivery)
        self._giving = Giving(members, told, delivery)

    def join(self, agent: Receiver) -> None:
        """An agent can be talked to; the order in which they come is the team's."""
        self._members.agents[agent.name] = agent
        self._members.desks[agent.name] = Desk()
        self._members.join_elsewhere(agent.name, agent.plan)
        self.directory.appeared(agent.name, agent.plan)

    def join_elsewhere(self, name: str, plan: Plan) -> None:
        """An agent of the team runs in another process, with this plan; it counts in the team's order."""
        self._members.join_elsewhere(name, plan)

    def add_external_agent(self, name: str, hears: Hears) -> None:
        """An agent that is not of the team runs in this process; it speaks by `receive_external`.

        It is called with messages while others wait: it only takes note of them, and answers later.

        Raises:
            ValueError: an agent of the team has that name.
        """
        if name in self._members.plans:
            raise ValueError(f"an agent of the team is called {name}")
        self._outside.add(name, hears)

    # ---- sending -----------------------------------------------------------------------------

    def check_receiver(self, agent: Receiver, branch: str, to: str) -> Collection[str]:
        """The agents that `to` means now.

        Raises:
            LookupError: it is neither a participant of the branch's protocol nor an agent.
        """
        return self._sending.check_receiver(agent, branch, to)

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
        with self._driver.holding(), self._lock:
            return self._sending.send(
                agent, branch, performative, message, content, to, excepts, reply_by, one=one, before=before
            )

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
        with self._driver.holding(), self._lock:
            self._sending.send_to_agent(agent, branch, performative, message, content, to, reply_by)

    def send_free(self, agent: Receiver, message: ACLMessage) -> ACLMessage:
        """Send a message outside of every protocol; what was sent. Raises MoveError and ValueError."""
        with self._driver.holding(), self._lock:
            return self._delivery.free.send(agent, message)

    # ---- receiving ---------------------------------------------------------------------------

    def arrived(self, agent: Receiver, acl: AclMessage, members: Mapping[str, Sequence[str]]) -> None:
        """The transport has brought a message for an agent, with what its sender knows of who takes part."""
        with self._driver.holding(), self._lock:
            if self._members.desks[agent.name].was_heard(acl.identity):
                self._told.unexpected(agent.name, acl, "it was received before")
                return
            if acl.performative != LOST:  # that reaches the agents that wait for it
                self._told.received(agent.name, acl)
            if self._delivery.free.is_free(acl):
                self._delivery.free.deliver(agent, acl)
                return
            played = (info.version for info in agent.plan.branches if info.protocol == acl.protocol)
            acl = replace(acl, version=next(played, ""))  # the transport brings only what is of our model
            conversation = self._members.known(acl.conversation, acl.protocol)
            for part, names in members.items():
                known = conversation.members.setdefault(part, [])
                known.extend(name for name in names if name not in known)
            if acl.performative == LOST and reason_of(acl) == "exhausted":
                self._delivery.exhaust(acl.conversation, conversation)
            elif acl.performative == LOST:
                key = acl.sender, acl.participant
                if key in conversation.absent:  # its loss was told, and has been one
                    conversation.absent -= {key}
                    conversation.past[key] = reason_of(acl)
                elif key not in conversation.past:
                    self._delivery.losses.over(
                        conversation, acl.conversation, acl.sender, acl.participant, reason_of(acl)
                    )
            else:
                self._delivery.spend(agent, acl.conversation)
                self._delivery.deliver(agent, acl)
            if acl.conversation in self._members.conversations:
                self._delivery.close(acl.conversation)

    def refused(self, agent: Receiver, answer: AclMessage, reason: str) -> None:
        """An agent elsewhere does not read what one of ours has sent: its build means it in another way.

        `answer` is what it would say. Who waits to hear that an agent is lost loses it instead.
        """
        with self._driver.holding(), self._lock:
            self._told.received(agent.name, answer)
            self._delivery.refused(agent, answer, reason)
            if answer.conversation in self._members.conversations:
                self._delivery.close(answer.conversation)

    def give(
        self,
        agent: Receiver,
        performative: str,
        message: str,
        content: object,
        sender: str,
        identity: Identity,
    ) -> str:
        """Give an agent a message as if `sender` had sent it now (a script, a test); why it cannot be.

        A sender that is not of the team is to be known (`add_external_agent`): it hears the answers.
        """
        with self._driver.holding(), self._lock:
            return self._giving.give(agent, performative, message, content, sender, identity)

    def receive_external(self, to: str, message: FipaMessage) -> None:
        """An agent that is not of the team has sent a message to one of ours. May be called from any thread.

        It is handed on like any other if it is understood. Else the trace records why not, and it is answered
        `not_understood`.
        """
        with self._driver.holding(), self._lock:
            if self._management.is_meant(to, message):
                self._management.hear(to, message)
            else:
                self._inbox.receive(to, message)

    def appeared(self, name: str, life: int | None = None) -> None:
        """An agent of the team that runs elsewhere is there; `life` tells its incarnations apart."""
        with self._driver.holding(), self._lock:
            self.directory.appeared(name, self._members.plans[name])
            before, self._lives[name] = self._lives.get(name), life
            self._parts.returned(name, same=life is not None and before == life)

    def vanished(self, name: str, reason: Reason = "crashed") -> None:
        """An agent elsewhere is lost: record it in each conversation here that counts on it."""
        with self._driver.holding(), self._lock:
            self.directory.disappeared(name)
            self._management.disappeared(name)
            self._parts.tell_gone(name, reason, elsewhere=True)

    def _tell_outside(self, sender: str, message: FipaMessage, to: Iterable[AgentIdentifier]) -> None:
        with self._driver.holding(), self._lock:
            self._outside.carry(sender, message, to)

    # ---- what the charts do ------------------------------------------------------------------

    def joined(self, agent: Receiver, branch: str) -> None:
        """A branch was entered: it is free, and takes the conversation that waits longest."""
        with self._driver.holding(), self._lock:
            self._parts.joined(agent, branch)

    def suspended(self, agent: Receiver, branch: str) -> None:
        """A branch was left that may be resumed: its conversation stays open, with its messages."""
        with self._driver.holding(), self._lock:
            self._parts.suspended(agent, branch)

    def resumed(self, agent: Receiver, branch: str) -> None:
        """A branch that was suspended continues."""
        with self._driver.holding(), self._lock:
            self._parts.resumed(agent, branch)

    def took_leave(self, agent: Receiver, branch: str, of: Iterable[str]) -> None:
        """A branch has told these agents that it ends early: they need no other word."""
        with self._lock:
            place = self._members.desks[agent.name].branches.get(branch)
            if place is not None:
                place.farewell = place.farewell.union(of)

    def leaving(self, agent: Receiver, reason: Reason | None) -> None:
        """Parts of an agent that end from now on before their END do so for this reason; None: in silence."""
        self._members.desks[agent.name].leaving = reason

    def left(self, agent: Receiver, branch: str, completed: bool = False) -> None:
        """A branch was left: its part in the conversation is over, and what it did not take is given up."""
        with self._driver.holding(), self._lock:
            self._parts.left(agent, branch, completed)

    def taken(self, agent: Receiver, branch: str, identity: Identity) -> AgentMessage | None:
        """A transition or an activity took a message: the message, if it waited."""
        with self._lock:
            place, mail = self._parts.taken(agent, branch, identity)
        if place is not None and place.completed:
            with self._driver.holding(), self._lock:
                self._delivery.losses.consumed(agent, place)
        return mail

    def refuse(self, agent: Receiver, branch: str, identity: Identity) -> None:
        """No later state of a branch takes a message that waits in it."""
        with self._driver.holding(), self._lock:
            self._parts.refuse(agent, branch, identity)

    def taken_by(self, agent: Receiver, branch: str) -> tuple[AgentMessage, ...]:
        """What a participation has taken: the last of each kind and sender, the newest at the end."""
        with self._lock:
            return self._parts.taken_by(agent, branch)

    def arrives(self, agent: Receiver, mail: AgentMessage, conversation: str | None) -> bool:
        """Whether an agent message still finds its participant; records and answers if it does not."""
        with self._lock:
            if self._delivery.finds(agent, mail, conversation):
                return True
        if conversation is not None and mail.performative != LOST:
            with self._driver.holding(), self._lock:
                if not self._delivery.was_returned(agent, mail):
                    reason = "its part in the conversation is over"
                    self._delivery.give_back(agent, mail, conversation, reason)
        return False

    def gone(self, agent: Receiver, reason: str = "") -> None:
        """An agent has ended or left its plan: it takes part in nothing, and what waited is answered.

        Why its parts are over was said before, with `leaving`.
        """
        with self._driver.holding(), self._lock:
            self._parts.gone(agent, reason)

    # ---- another plan ------------------------------------------------------------------------

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now."""
        with self._lock:
            self._members.renew(plans)

    @contextmanager
    def still(self) -> Iterator[None]:
        """Inside, no other thread sends, joins or leaves; agents that are woken step afterwards."""
        with self._driver.holding(), self._lock:
            yield

    def carry(self, agent: Receiver, labels: Mapping[str, str], messages: Messages) -> None:
        """The agent continues under its new plan, in which the states have these labels.

        What it was invited to and now plays in another way is answered `not_understood`.
        """
        with self._driver.holding(), self._lock:
            self._parts.carry(agent, labels, messages)

    # ---- who takes part, and what waits ------------------------------------------------------

    def inside(self, agent: Receiver) -> list[tuple[BranchInfo, str]]:
        """The conversations that an agent takes part in, each with the branch that does."""
        with self._lock:
            places = self._members.desks[agent.name].branches.values()
            return [(place.info, place.conversation) for place in places if place.conversation is not None]

    def place(self, agent: Receiver, branch: str) -> tuple[str | None, bool]:
        """The conversation of an entered branch, if it is in one; and whether the branch is entered."""
        with self._lock:
            place = self._members.desks[agent.name].branches.get(branch)
            return (None, False) if place is None else (place.conversation, True)

    def open(self) -> list[tuple[str, str, list[tuple[str, str, str | None, bool]]]]:
        """The open conversations: name, protocol, and the agents that are still in it.

        Each as (agent, participant, branch, whether it is suspended). The branch is None where the agent runs
        elsewhere, or was invited and has not joined yet.
        """
        with self._lock:
            found = []
            for name, conversation in self._members.conversations.items():
                here = {
                    (agent, participant): (place.info.label, place.suspended)
                    for (agent, participant), place in conversation.places.items()
                }
                members = dict.fromkeys(
                    (agent, participant)
                    for participant, agents in conversation.members.items()
                    for agent in agents
                    if (agent, participant) not in conversation.past
                )
                members.update(dict.fromkeys(here))
                found.append(
                    (name, conversation.protocol, [(*who, *here.get(who, (None, False))) for who in members])
                )
            return found

    def play_alike(self, pairs: Iterable[tuple[str, str]]) -> None:
        """From now on, agents that play these versions of a protocol can converse."""
        with self._lock:
            self._members.alike.update(map(frozenset, pairs))

    def hold(self, reason: str) -> None:
        """From now on the agents here begin no conversation and join none, for a reason; empty: they may.

        Those in which they take part continue.
        """
        with self._lock:
            self._members.held = reason

    def mailbox(self, name: str) -> Mailbox:
        """The messages outside of every protocol that wait for an agent here."""
        return self._delivery.free.box(name)

    def protocol_of(self, protocol: str) -> str | None:
        """The protocol that some agent of the team plays and that a message means by this name, if any."""
        return self._delivery.free.protocol_of(protocol)

    def unread(self) -> list[tuple[str, str, str, str, str, str]]:
        """The agent messages that wait here: receiver, participant, conversation, performative, message and
        sender."""
        with self._lock:
            found = []
            for agent, desk in self._members.desks.items():
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
            return found + self._delivery.free.unread()
