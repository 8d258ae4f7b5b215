"""What the trace tells of conversations: who takes part, what is said, and what is unexpected."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Literal, TypeAlias

from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.chart.plan import BranchInfo
from aseme_dsl.runtime.conversation.participation import Participation
from aseme_dsl.runtime.message.acl import AclMessage, FipaMessage, performative_of
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.message.free import ACLMessage
from aseme_dsl.runtime.time.timers import Scheduler
from aseme_dsl.runtime.trace.trace import Trace

Cause: TypeAlias = Literal["busy", "ended", "unexpected"]
"""Why the runtime says something for an agent: no instance is free, its part has ended, it cannot take it."""

LONGEST = 2000
"""The most characters of a content without a meaning that are recorded."""


class ConversationTrace:
    """Writes the lines of conversations; all with the time of the run."""

    def __init__(self, driver: Scheduler, trace: Trace) -> None:
        self._driver = driver
        self._trace = trace

    def fault(self, agent: str, reason: str) -> None:
        """Something cannot be done as it is asked for."""
        self._trace.fault(self._driver.clock.now(), agent, reason)

    def sent(self, acl: AclMessage, answered: Iterable[Identity], cause: Cause | None = None) -> None:
        """A message is sent, and answers these; with a `cause` the runtime has sent it by itself."""
        if self._trace.active:
            self._trace.write(
                "agent_message",
                self._driver.clock.now(),
                agent=acl.sender,
                sequence=acl.identity[1],
                **_said(acl),
                reply_by=acl.reply_by,
                to=list(acl.receivers),
                answers=[list(identity) for identity in answered] or None,
                cause=cause,
            )

    def unsent(
        self, agent: str, performative: str, message: str, content: object, info: BranchInfo, reason: str
    ) -> None:
        """A message could not be sent."""
        if self._trace.active:
            self._trace.write(
                "unsent",
                self._driver.clock.now(),
                agent=agent,
                performative=performative,
                message=message,
                content=to_json(content),
                protocol=info.protocol,
                participant=info.participant,
                reason=reason,
            )

    def received(self, agent: str, acl: AclMessage) -> None:
        """The transport, or an agent that is not of the team, has brought an agent a message."""
        if self._trace.active:
            self._trace.write(
                "received",
                self._driver.clock.now(),
                agent=agent,
                input=list(acl.identity),
                **_said(acl),
                in_reply_to=acl.in_reply_to or None,
                reply_by=acl.reply_by,
                sent=acl.sent,
            )

    def unexpected(self, agent: str, acl: AclMessage, reason: str) -> None:
        """An unexpected message has come."""
        self._trace.write(
            "unexpected",
            self._driver.clock.now(),
            agent=agent,
            input=list(acl.identity),
            performative=acl.performative,
            message=acl.message or "text",
            sender=acl.sender,
            conversation=acl.conversation or None,
            reason=reason,
        )

    def unread(self, agent: str, identity: Identity, message: ACLMessage, reason: str) -> None:
        """A message outside of every protocol was not received by any behaviour."""
        content = message.content
        self._trace.write(
            "unexpected",
            self._driver.clock.now(),
            agent=agent,
            input=list(identity),
            performative=message.performative,
            message="text" if isinstance(content, str) else type(content).__name__,
            sender=message.sender,
            conversation=message.conversation_id or None,
            reason=reason,
        )

    def meaningless(self, agent: str, message: FipaMessage, identity: Identity, reason: str) -> None:
        """An agent that is not of the team has said something that means nothing."""
        content = message.content if isinstance(message.content, str) else None
        self._trace.write(
            "unexpected",
            self._driver.clock.now(),
            agent=agent,
            input=list(identity),
            performative=performative_of(message.performative) or message.performative,
            sender=identity[0],
            conversation=message.conversation or None,
            content=None if content is None else content[:LONGEST],
            reason=reason,
        )

    def answered_outside(self, answer: FipaMessage, identity: Identity, to: Identity) -> None:
        """An external agent is answered that its message means nothing."""
        if self._trace.active:
            self._trace.write(
                "agent_message",
                self._driver.clock.now(),
                agent=identity[0],
                sequence=identity[1],
                performative=performative_of(answer.performative),
                message="",
                content=json.loads(str(answer.content)),
                protocol=answer.protocol,
                conversation=answer.conversation,
                participant="",
                receiver="",
                to=[receiver.name for receiver in answer.receivers],
                answers=[list(to)],
                cause="unexpected",
            )

    def takes_part(
        self,
        what: str,
        agent: str,
        place: Participation,
        name: str,
        untaken: Iterable[Identity] = (),
        peer: str | None = None,
        played: str | None = None,
        identity: Identity | None = None,
        in_reply_to: str = "",
        reason: str | None = None,
    ) -> None:
        """An agent opens, joins or leaves a conversation, or hears that another one is lost or `settled`."""
        info = place.info
        self._trace.write(
            "conversation",
            self._driver.clock.now(),
            agent=agent,
            sequence=None if identity is None else identity[1],
            what=what,
            conversation=name,
            protocol=None if name.startswith(f"{info.protocol}-") else info.protocol,
            participant=info.participant,
            branch=info.label,
            untaken=[list(item) for item in untaken] or None,
            peer=peer,
            played=played,
            in_reply_to=in_reply_to or None,
            reason=reason,
        )


def _said(acl: AclMessage) -> dict[str, object]:
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
