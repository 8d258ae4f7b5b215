"""Inputs of agents as a trace tells of them: found by their identities, which the lines of steps name."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from types import GenericAlias

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.functions import TYPES
from aseme_dsl.runtime.chart.inputs import (
    LOST,
    Addressed,
    AgentMessage,
    Completed,
    Crashed,
    Happened,
    Identity,
    Input,
    Sample,
    Settled,
    Written,
)
from aseme_dsl.runtime.message.acl import name_of
from aseme_dsl.runtime.message.as_json import from_json
from aseme_dsl.runtime.trace.records import InputName, Record

Messages = Mapping[str, type[object]]
"""The classes of messages and enums by name."""


class RecordedInputs:
    """What the lines of a trace say of inputs; it is shown them one after the other."""

    def __init__(self, agents: Collection[str], reads: Collection[str]) -> None:
        """Of these agents, as far as these channels matter. Both may grow."""
        self._agents = agents
        self._reads = reads
        self._said: dict[Identity, tuple[int, Record]] = {}
        """The lines of what was said, by the identity of the input that it is."""
        self._brought: dict[tuple[str, Identity], tuple[int, Record]] = {}
        """The same for what the transport has brought to an agent."""
        self._branches: dict[tuple[str, str, str], str] = {}
        """Where an agent takes part in a conversation, by its part."""
        self.number = 0
        """How many lines there were."""
        self._kinds: dict[str, Callable[[Record], None]] = {
            "message": self._published,
            "radio_received": self._published,
            "arrived": self._carried,
            "received": self._carried,
            "agent_message": self._say,
            "event": self._say,
            "variable": self._say,
            "activity": self._activity,
            "conversation": self._conversation,
        }

    def line(self, record: Record) -> None:
        """A line of the trace."""
        self.number += 1
        known = self._kinds.get(record["kind"])
        if known is not None:
            known(record)

    def _say(self, record: Record) -> None:
        self._said[str(record["agent"]), record["sequence"]] = self.number, record

    def _published(self, record: Record) -> None:
        if record["channel"] in self._reads:
            self._say(record)

    def _carried(self, record: Record) -> None:
        if record["agent"] in self._agents:
            self._brought[record["agent"], identity_of(record["input"])] = self.number, record

    def _activity(self, record: Record) -> None:
        if record["what"] in ("end", "crash") and "sequence" in record and record["agent"] in self._agents:
            self._say(record)

    def _conversation(self, record: Record) -> None:
        name = record["agent"]
        if name not in self._agents:
            return
        if "sequence" in record:  # it hears that another agent is lost
            self._say(record)
        elif record["what"] in ("open", "join"):
            self._branches[name, record["conversation"], record["participant"]] = record["branch"]

    # ---- what an input was -------------------------------------------------------------------

    def said_at(self, agent: str, identity: Identity) -> int:
        """Which line tells of an input of an agent, counted from 1; 0 if none does."""
        found = self._brought.get((agent, identity)) or self._said.get(identity)
        return 0 if found is None else found[0]

    def forget(self, identity: Identity) -> None:
        """An input that only one agent got has been taken."""
        self._said.pop(identity, None)

    def input(self, chart: Chart, messages: Messages, identity: Identity) -> Input | None:
        """What an input of the agent of a chart was; None if the trace does not say.

        Raises:
            LookupError, TypeError, ValueError: the line is not one of this model.
        """
        agent = chart.agent
        found = self._brought.get((agent, identity)) or self._said.get(identity)
        if found is None:
            return None
        _, record = found
        if record["kind"] == "agent_message" and record["agent"] == agent and agent not in record["to"]:
            branch = self._branches[agent, record["conversation"], record["participant"]]
            return Addressed(branch, record["receiver"], tuple(record["to"]), name_of(identity))
        match record["kind"]:
            case "message" | "radio_received" | "arrived":
                return _message(agent, messages, identity, record)
            case "agent_message" | "received":
                return self._mail(agent, messages, identity, record)
            case "event":
                return Happened(record["event"])
            case "variable":
                value = record["value"]
                name = record["variable"]
                kind = _type_of(chart, messages, name)
                return Written(name, value if value is None else from_json(kind, value))
            case "activity" if record["what"] == "end":
                return Completed(record["label"], record["token"], record.get("outcome"))
            case "activity":
                return Crashed(record["label"], record["token"], record.get("reason", ""))
            case _ if record["what"] == "settled":
                reply = record.get("in_reply_to", "")
                return Settled(record["branch"], record["played"], record["peer"], reply)
            case _:
                part = record["played"]
                reason = record.get("reason", "left")
                return AgentMessage(record["branch"], LOST, "", reason, part, record["peer"], identity)

    def _mail(self, agent: str, messages: Messages, identity: Identity, record: Record) -> AgentMessage:
        name = str(record["message"])
        content = from_json(messages[name], record["content"]) if name in messages else None
        branch = self._branches[agent, record["conversation"], record["receiver"]]
        part = record["participant"]
        answered = [name_of(identity_of(item)) for item in record.get("answers", ()) if item[0] == agent]
        sent = record["time"] if record["kind"] == "agent_message" else record.get("sent")
        return AgentMessage(
            branch,
            record["performative"],
            name,
            content,
            part,
            identity[0],
            identity,
            in_reply_to=record.get("in_reply_to") or next(iter(answered), ""),
            sent=sent,
        )


def _message(agent: str, messages: Messages, identity: Identity, record: Record) -> Sample:
    channel = record["channel"]
    content = from_json(messages[channel.rpartition(".")[2]], record["message"])
    if record["kind"] == "arrived":
        return Sample(channel, content, identity[0], record["measured"], identity)
    own = record.get("region") if record["agent"] == agent else None
    sender = record.get("sender") or record["agent"]
    moment = record["measured"] if "measured" in record else record["time"]
    return Sample(channel, content, sender, moment, identity, own)


def _type_of(chart: Chart, messages: Messages, name: str) -> object:
    """The Python type of what a variable holds. Raises LookupError or TypeError if there is none."""
    said = {item.name: item.type for item in chart.PLAN.variables}[name]
    element = said.removeprefix("list of ")
    if element != said:
        return GenericAlias(tuple, (messages.get(element) or TYPES[element][-1], ...))
    return messages.get(said) or type(chart.variable(name))


def identity_of(value: InputName) -> Identity:
    """An identity as a chart has it."""
    name, number = value
    return str(name), int(number)


__all__ = ["Messages", "RecordedInputs", "identity_of"]
