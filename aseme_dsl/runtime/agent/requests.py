"""Requests: what the activities of an agent ask of it, checked and done."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.inputs import AgentMessage, Happened, Identity, Sending, Written
from aseme_dsl.runtime.conversation import directory as d
from aseme_dsl.runtime.conversation.moves import MoveError, check_move, check_once
from aseme_dsl.runtime.message.acl import AgentIdentifier
from aseme_dsl.runtime.message.as_json import to_json


class Requests:
    """What activities publish, set, raise, prepare, send and register, and the agent messages they take."""

    def __init__(self, agent: Host, bus: Bus) -> None:
        self._agent = agent
        self._bus = bus
        self.prepared: dict[tuple[str | None, str], Any] = {}
        """What was prepared as the content of a message, by the branch (None for all) and the message."""

    def content_of(self, effect: Sending) -> Any:
        """The content of what a transition sends: what it fills in, or what was prepared for it."""
        for key in ((effect.branch, effect.message), (None, effect.message)):
            if not effect.filled and key in self.prepared:
                return self.prepared.pop(key)
        return effect.content

    def renew(self, labels: Mapping[str, str], understood: Callable[[Any], Any]) -> None:
        """Let what was prepared fit another version of the model, with other labels and messages."""
        self.prepared = {
            (branch if branch is None else labels.get(branch, ""), name): understood(content)
            for (branch, name), content in self.prepared.items()
        }

    def check_registered(self, wanted: bool) -> None:
        """Raises DirectoryError if the agent has registered what it offers, or (`wanted`) if it has not."""
        agent = self._agent
        if agent.conversations.directory.has_registered(agent.name) != wanted:
            raise (d.not_registered if wanted else d.already_registered)(agent.name)

    def check_send(self, execution: Execution, performative: str, message: str, to: str) -> None:
        """Raises LookupError if an activity cannot send such a message to `to`: nothing has left then."""
        agent = self._agent
        branch, activity = execution.branch, execution.activity
        if branch is None:
            raise LookupError("only an activity of a protocol's participant sends agent messages")
        info = agent.branch_info(branch)
        try:
            label = execution.label
            repeatedly = check_move(agent.plan, info, activity, label, performative, message)
            receivers = agent.conversations.check_receiver(agent, branch, to)
            if not repeatedly:
                check_once(execution.sent, info, activity, (performative, message), receivers)
        except MoveError as error:
            agent.trace.fault(agent.driver.clock.now(), agent.name, str(error), activity=activity)
            raise

    def perform(self, execution: Execution, doing: c.Doing) -> None:
        """Do what an activity asks for. Called from the activity's thread."""
        agent = self._agent
        now = agent.driver.clock.now()
        activity = execution.activity
        match doing:
            case c.Publish(channel, message, host):
                self._bus.publish(agent, channel, message, host, activity=activity)
            case c.SetVariable(name, value):
                key = agent.plan.variable_of(name, execution.label).name
                identity = agent.identity()
                agent.trace.write(
                    "variable",
                    now,
                    agent=agent.name,
                    sequence=identity[1],
                    variable=key,
                    value=to_json(value),
                    activity=activity,
                    label=execution.label,
                )
                agent.post(identity, Written(key, value), execution)
            case c.RaiseEvent(name):
                identity = agent.identity()
                agent.trace.write(
                    "event",
                    now,
                    agent=agent.name,
                    sequence=identity[1],
                    event=name,
                    activity=activity,
                    label=execution.label,
                )
                agent.post(identity, Happened(name), execution)
            case c.Prepare(message):
                self.prepared[execution.branch, type(message).__name__] = message
            case c.Send(performative, message, to, within):
                branch, name = execution.branch, type(message).__name__
                assert branch is not None  # checked before
                by = None if within is None else now + within
                agent.conversations.send(agent, branch, performative, name, message, to, reply_by=by)
            case d.Offer(services, lease, anew):
                entry = d.Entry(AgentIdentifier(agent.name), services)
                directory = agent.conversations.directory
                self._settle(lambda: (directory.modify if anew else directory.register)(entry, lease))
            case d.Withdraw():
                self._settle(lambda: agent.conversations.directory.deregister(agent.name))
            case c.Log(text):
                agent.trace.write(
                    "log", now, agent=agent.name, activity=activity, label=execution.label, text=text
                )

    def _settle(self, change: Callable[[], object]) -> None:
        """Change what is registered; tell if that cannot be any more."""
        agent = self._agent
        try:
            change()
        except d.DirectoryError as problem:
            agent.trace.fault(agent.driver.clock.now(), agent.name, f"the directory: {problem}")

    def take_mail(
        self,
        execution: Execution,
        performative: str | None,
        message: str | None,
        sender: str | None,
        identity: Identity | None = None,
    ) -> AgentMessage | None:
        """The oldest agent message that waits in the activity's branch. Called while the agent is guarded."""
        agent = self._agent
        branch = execution.branch
        if branch is None or execution.cancelled:
            return None
        waiting = agent.chart.mail[branch]
        for item in waiting:
            if c.matches(item, performative, message, sender) and identity in (None, item.identity):
                agent.chart.give_mail(item)
                agent.trace.write(
                    "consumed",
                    agent.driver.clock.now(),
                    agent=agent.name,
                    input=list(item.identity),
                    label=execution.label,
                    activity=execution.activity,
                    token=execution.start.token,
                )
                agent.conversations.taken(agent, branch, item.identity)
                if agent.branch_info(branch).counts:
                    agent.begin()  # a condition may wait for just this
                return item
        return None
