"""Inputs of agents as a trace tells of them: found by their identities, which the lines of steps name."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterable, Mapping
from types import GenericAlias
from typing import TypeAlias

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
from aseme_dsl.runtime.trace.trace_reading import Line

Earlier: TypeAlias = Callable[[int, Collection[str]], Iterable[Line]]
"""The lines before a line that hold one of some texts, the newest first (`TraceReader.before`)."""
Messages = Mapping[str, type[object]]
"""The classes of messages and enums by name."""


class RecordedInputs:
    """What the lines of a trace say of inputs; it is shown them one after the other.

    After the header lines may be left out. Then `earlier` looks for one of those when it is needed.
    """

    def __init__(
        self, agents: Collection[str], reads: Collection[str], earlier: Earlier | None = None
    ) -> None:
        """Of these agents, as far as these channels matter. Both may grow."""
        self._agents = agents
        self._reads = reads
        self._said: dict[Identity, tuple[int, Record]] = {}
        """The lines of what was said, by the identity of the input that it is."""
        self._brought: dict[tuple[str, Identity], tuple[int, Record]] = {}
        """The same for what the transport has brought to an agent."""
        self._made: dict[int, tuple[Messages, object]] = {}
        """The message in a line, which all who get it have in common, and the classes that it was made of."""
        self._branches: dict[tuple[str, str, str], str] = {}
        """Where an agent takes part in a conversation, by its part."""
        self.number = 0
        """The number of the present line."""
        self._earlier = earlier
        self._begin = 0
        """The number of the first line behind those that were left out; 0 if none were."""
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

    def line(self, record: Record, number: int | None = None) -> bool:
        """The next line of the trace, or the one of a number; whether some before it were left out."""
        expected = self.number = self.number + 1
        known = self._kinds.get(record["kind"])
        if number is None or number == expected:
            if known is not None:
                known(record)
            return False
        self.number = self._begin = number
        if known is not None:
            known(record)
        return True

    def part(self, agent: str, conversation: str, participant: str, branch: str) -> None:
        """An agent takes part in a conversation as this participant."""
        self._branches[agent, conversation, participant] = branch

    def _say(self, record: Record) -> None:
        self._said[record["agent"], record["sequence"]] = self.number, record

    def _published(self, record: Record) -> None:
        if record["channel"] in self._reads or any(name in self._agents for name in record.get("to", ())):
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
        found = self._find(agent, identity)
        return 0 if found is None else found[0]

    def _find(self, agent: str, identity: Identity) -> tuple[int, Record] | None:
        """The line that tells of an input of an agent, with its number."""
        found = self._brought.get((agent, identity)) or self._said.get(identity)
        if found is not None or not self._begin or self._earlier is None:
            return found
        texts = f'"sequence":{identity[1]}', f'"input":[{json.dumps(identity[0], ensure_ascii=False)}'
        for line in self._earlier(self._begin, texts):
            record = line.record
            if record["kind"] in ("arrived", "received"):
                if record["agent"] == agent and identity_of(record["input"]) == identity:
                    found = self._brought[agent, identity] = line.number, record
                    return found
            elif record.get("agent") == identity[0] and record.get("sequence") == identity[1]:
                found = self._said[identity] = line.number, record
                return found
        return None

    def _branch(self, agent: str, conversation: str, participant: str) -> str:
        """Where an agent takes part in a conversation. Raises KeyError where the trace does not say."""
        found = self._branches.get((agent, conversation, participant))
        if found is not None or not self._begin or self._earlier is None:
            return self._branches[agent, conversation, participant]
        text = f'"conversation":{json.dumps(conversation, ensure_ascii=False)}'
        for line in self._earlier(self._begin, (text,)):
            record = line.record
            if (
                (record["kind"], record.get("agent")) == ("conversation", agent)
                and record["what"] in ("open", "join")
                and (record["conversation"], record["participant"]) == (conversation, participant)
            ):
                self.part(agent, conversation, participant, record["branch"])
                return record["branch"]
        raise KeyError(conversation)

    def forget(self, identity: Identity) -> None:
        """An input that only one agent got has been taken."""
        self._said.pop(identity, None)

    def input(self, chart: Chart, messages: Messages, identity: Identity) -> Input | None:
        """What an input of the agent of a chart was; None if the trace does not say.

        Raises:
            LookupError, TypeError, ValueError: the line is not one of this model.
        """
        agent = chart.agent
        found = self._find(agent, identity)
        if found is None:
            return None
        number, record = found
        if record["kind"] == "agent_message" and record["agent"] == agent and agent not in record["to"]:
            branch = self._branch(agent, record["conversation"], record["participant"])
            return Addressed(branch, record["receiver"], tuple(record["to"]), name_of(identity))
        match record["kind"]:
            case "activity" if record["what"] == "end":
                return Completed(record["label"], record["token"], record.get("outcome"))
            case "message" | "radio_received" | "arrived":
                return self._message(agent, messages, identity, number, record)
            case "agent_message" | "received":
                return self._mail(agent, messages, identity, number, record)
            case "event":
                return Happened(record["event"])
            case "variable":
                value = record["value"]
                name = record["variable"]
                said = {item.name: item.type for item in chart.PLAN.variables}[name]
                return Written(name, value if value is None else from_json(_type(said, messages), value))
            case "activity":
                return Crashed(record["label"], record["token"], record.get("reason", ""))
            case _ if record["what"] == "settled":
                reply = record.get("in_reply_to", "")
                return Settled(record["branch"], record["played"], record["peer"], reply)
            case _:
                part = record["played"]
                reason = record.get("reason", "left")
                return AgentMessage(record["branch"], LOST, "", reason, part, record["peer"], identity)

    def _content(self, messages: Messages, name: str, number: int, data: object) -> object:
        """The message in a line. Raises LookupError, ValueError."""
        made = self._made.get(number)
        if made is None or made[0] is not messages:
            made = self._made[number] = messages, from_json(messages[name], data)
        return made[1]

    def _message(
        self, agent: str, messages: Messages, identity: Identity, number: int, record: Record
    ) -> Sample:
        channel = record["channel"]
        content = self._content(messages, channel.rpartition(".")[2], number, record["message"])
        if record["kind"] == "arrived":
            return Sample(channel, content, identity[0], record["measured"], identity)
        own = record.get("region") if record["agent"] == agent else None
        sender = record.get("sender") or record["agent"]
        moment = record["measured"] if "measured" in record else record["time"]
        return Sample(channel, content, sender, moment, identity, own)

    def _mail(
        self, agent: str, messages: Messages, identity: Identity, number: int, record: Record
    ) -> AgentMessage:
        name = str(record["message"])
        content = self._content(messages, name, number, record["content"]) if name in messages else None
        branch = self._branch(agent, record["conversation"], record["receiver"])
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


def _type(said: str, messages: Messages) -> object:
    """The Python type of what a variable of a type holds. Raises LookupError if there is none."""
    element = said.removeprefix("list of ")
    if element != said:
        return GenericAlias(tuple, (_type(element, messages), ...))
    if said == "agent":
        return str
    return messages.get(said) or TYPES[said][-1]


def identity_of(value: InputName) -> Identity:
    """An identity as a chart has it."""
    name, number = value
    return str(name), int(number)


__all__ = ["Earlier", "Messages", "RecordedInputs", "identity_of"]
