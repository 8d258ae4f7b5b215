"""Requests: what the activities of an agent ask of it, checked and done."""

from __future__ import annotations

from collections.abc import Callable

from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.agent.prepared import Prepared
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.inputs import AgentMessage, Happened, Identity, Sending, Written
from aseme_dsl.runtime.conversation import directory as d
from aseme_dsl.runtime.conversation.moves import MoveError, check_move, check_once, made_before
from aseme_dsl.runtime.message.acl import AgentIdentifier
from aseme_dsl.runtime.message.as_json import to_json


class Requests:
    """What activities publish, set, raise, prepare, send and register, and the agent messages they take."""

    def __init__(self, agent: Host, bus: Bus) -> None:
        self._agent = agent
        self._bus = bus
        self.prepared = Prepared()
        """What was prepared as the content of messages."""

    def content_of(self, effect: Sending) -> object:
        """The content of what a transition sends: what it fills in, or what was prepared for it.

        None if nothing was. Activities without code prepare defaults, which the trace tells.
        """
        content = effect.content if effect.filled else self._prepared_for(effect)
        if content is not None:
            self.prepared.sent(effect.branch, effect.message, content)
        return content

    def _prepared_for(self, effect: Sending) -> object:
        agent, prepared = self._agent, self.prepared
        plan, branch, message = agent.plan, effect.branch, effect.message
        source = plan.transitions[effect.way[0]].source if effect.way else branch
        content = prepared.take(plan, branch, message, source)
        if content is None:
            content = prepared.repeated(branch, message)
        if content is None:  # an answer says what it answers
            received = agent.conversations.taken_by(agent, branch)
            content = next((item.content for item in reversed(received) if item.message == message), None)
        opens = agent.conversations.place(agent, branch)[0] is None
        if content is None and opens:
            content = prepared.take_around(plan, branch, message, source)
        if content is None and (
            prepared.has_codeless(plan, branch, opens)
            or not agent.code.has_code_in(branch, or_stand_in=False)
        ):
            agent.trace.write(
                "default_content",
                agent.driver.clock.now(),
                agent=agent.name,
                branch=branch,
                performative=effect.performative,
                message=message,
            )
            content = effect.content
        return content

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
                said = performative, message
                execution.sent = check_once(execution.sent, info, activity, said, receivers)
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
                kind = type(message).__name__
                self.prepared.add(execution.branch, execution.label, kind, message)
            case c.Send(performative, message, to, within):
                branch, name = execution.branch, type(message).__name__
                assert branch is not None  # checked before
                by = None if within is None else now + within
                said = performative, name
                before = made_before(execution.earlier, agent.branch_info(branch), said)
                if not before:
                    self.prepared.sent(branch, name, message)
                receivers = agent.conversations.send(
                    agent, branch, performative, name, message, to, reply_by=by, before=before
                )
                execution.made = execution.made.union([(*said, receiver) for receiver in receivers])
            case d.Offer() | d.Withdraw():
                self.register(doing)
            case c.Log(text):
                agent.trace.write(
                    "log", now, agent=agent.name, activity=activity, label=execution.label, text=text
                )

    def register(self, doing: d.Offer | d.Withdraw) -> None:
        """Change what the agent has registered in the directory."""
        directory = self._agent.conversations.directory
        if isinstance(doing, d.Withdraw):
            self._settle(lambda: directory.deregister(self._agent.name))
            return
        entry = d.Entry(AgentIdentifier(self._agent.name), doing.services)
        change = directory.modify if doing.anew else directory.register
        self._settle(lambda: change(entry, doing.lease))

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
                agent.take_note(branch, item)
                if agent.branch_info(branch).counts:
                    agent.begin()  # a condition may wait for just this
                return item
        return None
