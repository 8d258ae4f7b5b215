"""Recorded: the courses that agents of some roles went in a run, read from its trace.

The inputs of a step stand in the trace by their identities; the line of the step names those that it took. A
chart of the present model is led along while the trace is read, to make sure that it takes the same steps.
Where it does not, or where the trace does not say enough, the course ends, and says why.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import GenericAlias

from aseme_dsl.project.studying.course import Course, Given, Recorder, begun
from aseme_dsl.runtime.chart.board import QUEUE
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
from aseme_dsl.runtime.trace.records import InputName, Record, agents_of
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.trace.trace_reading import TraceReader


class NotPlayable(Exception):
    """A trace is not one of these roles as they are; the text says why."""


class NobodyThere(NotPlayable):
    """It has no agents of these roles: another trace of the same run may have them."""


@dataclass(frozen=True, slots=True)
class Recording:
    """What a trace gave: the courses by role, and what has to be said of the file."""

    path: Path
    seed: int
    courses: Mapping[str, tuple[Course, ...]]
    problem: str | None = None


def recorded(
    path: Path,
    system: str,
    kinds: Mapping[str, type[Chart]],
    messages: Mapping[str, type[object]],
    most: int | None = None,
) -> Recording:
    """The courses of all agents of these roles, each of `most` steps after its first one at the most.

    `messages` are the classes of the messages and enums that the charts read.

    Raises:
        NotPlayable: it is not a trace, is one of another system or of other models, or (`NobodyThere`) has no
            such agents.
    """
    try:
        reader = TraceReader(path)
        reading = _Reading(path, system, kinds, messages, most)
        for line in reader:
            try:
                reading.line(line.record)
            except NotPlayable:
                raise
            except (LookupError, TypeError, ValueError, AttributeError, OverflowError) as problem:
                text = f"{type(problem).__name__}: {problem}"
                raise NotPlayable(
                    f"{path}:{line.number}: this line is not as a run of {system} writes it ({text})"
                ) from problem
    except TraceError as problem:
        raise NotPlayable(str(problem)) from problem
    if not reading.agents and reader.problem is not None:  # not even the header is whole
        raise NotPlayable(reader.problem)
    return Recording(reader.path, reading.seed, reading.courses(), reader.problem)


@dataclass(slots=True)
class _Agent:
    """An agent whose steps are read."""

    role: str
    recorder: Recorder
    where: tuple[str, ...] = ()
    """Its configuration as the trace has it."""
    steps: int = 0
    gone: list[tuple[str, Sample | AgentMessage]] = field(default_factory=list)
    until: str | None = None


class _Reading:
    """Goes through the lines of a trace once."""

    def __init__(
        self,
        path: Path,
        system: str,
        kinds: Mapping[str, type[Chart]],
        messages: Mapping[str, type[object]],
        most: int | None,
    ) -> None:
        self.path = path
        self.system = system
        self.kinds = kinds
        self.messages = messages
        self.most = most
        self.seed = 1
        self.agents: dict[str, _Agent] = {}
        self.said: dict[Identity, Record] = {}
        """The lines of what was said, by the identity of the input that it is."""
        self.brought: dict[tuple[str, Identity], Record] = {}
        """The same for what the transport has brought to an agent."""
        self.branches: dict[tuple[str, str, str], str] = {}
        """Where an agent takes part in a conversation, by its part."""
        self.reads = {channel for kind in kinds.values() for channel in kind.READERS}
        self.kinds_of_lines: dict[str, Callable[[Record], None]] = {
            "header": self.header,
            "message": self.published,
            "radio_received": self.published,
            "arrived": self.carried,
            "received": self.carried,
            "agent_message": self.say,
            "event": self.say,
            "variable": self.say,
            "activity": self.activity,
            "conversation": self.conversation,
            "consumed": self.taken,
            "swap": self.changed,
            "select": self.changed,
            "step": self.step,
        }

    def line(self, record: Record) -> None:
        """A line; those of other kinds say nothing of what agents got."""
        known = self.kinds_of_lines.get(record["kind"])
        if known is not None:
            known(record)

    def courses(self) -> dict[str, tuple[Course, ...]]:
        """What each role's agents got; one whose agents are not in the trace has nothing."""
        found: dict[str, tuple[Course, ...]] = {role: () for role in self.kinds}
        for item in self.agents.values():
            found[item.role] = (*found[item.role], item.recorder.course(item.until or ""))
        courses = [course for items in found.values() for course in items]
        if not any(len(course.steps) > 1 for course in courses):
            reasons = [f"{course.agent}: {course.until}" for course in courses if course.until]
            why = "; ".join(reasons) or "there is no step after the first"
            raise NotPlayable(f"{self.path}: nothing of it can be played: {why}")
        return found

    # ---- the first line ----------------------------------------------------------------------

    def header(self, record: Record) -> None:
        if self.agents:
            raise ValueError("a second header")
        if record["system"] != self.system:
            raise NotPlayable(
                f"{self.path} is the trace of a run of {record['system']}, not of {self.system}"
            )
        others: dict[str, str] = {}
        self.seed = int(record["seed"])
        for item in agents_of(record):
            name, role, model = str(item["name"]), item["role"], item["model"]
            kind = self.kinds.get(role)
            if kind is None:
                continue
            if model != kind.PLAN.model:
                others[role] = f"the model of {role} was {model} then, and is {kind.PLAN.model} now"
            chart = begun(kind, name, self.seed, record.get("queue", QUEUE))
            self.agents[name] = _Agent(role, Recorder(chart, name, self.seed, chart.queue))
        if others:
            raise NotPlayable(
                f"{self.path} is the trace of another version of {self.system}: {'; '.join(others.values())}."
                " Record a new one: asemec run"
            )
        if not self.agents:
            played = dict.fromkeys(str(item["role"]) for item in agents_of(record))
            raise NobodyThere(
                f"{self.path} has no agent of {' or '.join(self.kinds)}, only of {', '.join(played)}"
            )

    # ---- how inputs came to be ---------------------------------------------------------------

    def say(self, record: Record) -> None:
        self.said[str(record["agent"]), record["sequence"]] = record

    def published(self, record: Record) -> None:
        if record["channel"] in self.reads:
            self.say(record)

    def carried(self, record: Record) -> None:
        if record["agent"] in self.agents:
            self.brought[record["agent"], _identity(record["input"])] = record

    def activity(self, record: Record) -> None:
        if record["what"] in ("end", "crash") and "sequence" in record and record["agent"] in self.agents:
            self.say(record)

    def conversation(self, record: Record) -> None:
        name = record["agent"]
        if name not in self.agents:
            return
        if "sequence" in record:  # it hears that another agent is lost
            self.say(record)
        elif record["what"] in ("open", "join"):
            self.branches[name, record["conversation"], record["participant"]] = record["branch"]

    def taken(self, record: Record) -> None:
        item = self.agents.get(record["agent"])
        if item is not None and item.until is None:
            found = self.input(record["agent"], _identity(record["input"]))
            if isinstance(found, Sample | AgentMessage):
                item.gone.append((record["label"], found))

    def changed(self, record: Record) -> None:
        item = self.agents.get(record.get("agent", ""))
        if item is None or item.until is not None:
            return
        if record.get("what", "done") == "done" and "reason" not in record:
            item.until = "then it changed its plan"

    # ---- the steps ---------------------------------------------------------------------------

    def step(self, record: Record) -> None:
        item = self.agents.get(record["agent"])
        if item is None or item.until is not None:
            return
        if self.most is not None and item.steps > self.most:
            item.until = "as many as were asked for"
            return
        name, number = record["agent"], item.steps + 1
        if record["step"] != number:
            item.until = f"the trace does not have step {number}"
            return
        inputs: list[Input] = []
        ahead: list[Sample] = []
        for identity in [*record["inputs"], *record.get("ahead", ())]:
            found = self.input(name, _identity(identity))
            if found is None:
                item.until = f"the trace does not say what input {identity} of step {number} was"
                return
            if len(inputs) < len(record["inputs"]):
                inputs.append(found)
            elif isinstance(found, Sample):
                ahead.append(found)
        given = Given(int(record["time"]), tuple(inputs), tuple(ahead), tuple(item.gone))
        item.gone.clear()
        item.steps = number
        outcome = item.recorder.play(given)
        if outcome is None:
            item.until = f"in step {number} it failed"
            return
        item.where = tuple(record.get("configuration", item.where))
        ways = [tuple(way["transitions"]) for way in record["taken"]]
        if item.recorder.trail[-1] != item.where or outcome.taken != ways:
            here, there = ", ".join(item.recorder.trail[-1]), ", ".join(item.where)
            for kept in (item.recorder.steps, item.recorder.trail):
                kept.pop()
            item.until = (
                f"step {number} does not go as it did in the run: it leads to {here}, and led to {there}"
                if here != there
                else f"step {number} takes other transitions than in the run"
            )

    def _type_of(self, agent: str, name: str) -> object:
        """The Python type of what a variable holds. Raises LookupError or TypeError if there is none."""
        chart = self.agents[agent].recorder.chart
        said = {item.name: item.type for item in chart.PLAN.variables}[name]
        element = said.removeprefix("list of ")
        if element != said:
            return GenericAlias(tuple, (self.messages.get(element) or TYPES[element][-1], ...))
        return self.messages.get(said) or type(chart.variable(name))

    def input(self, agent: str, identity: Identity) -> Input | None:
        """What an input of an agent was; None if the trace does not say."""
        record = self.brought.get((agent, identity)) or self.said.get(identity)
        if record is None:
            return None
        if record["kind"] == "agent_message" and record["agent"] == agent and agent not in record["to"]:
            branch = self.branches[agent, record["conversation"], record["participant"]]
            return Addressed(branch, record["receiver"], tuple(record["to"]), name_of(identity))
        match record["kind"]:
            case "message" | "radio_received" | "arrived":
                return self._message(agent, identity, record)
            case "agent_message" | "received":
                return self._mail(agent, identity, record)
            case "event":
                return Happened(record["event"])
            case "variable":
                value = record["value"]
                name = record["variable"]
                kind = self._type_of(agent, name)
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

    def _message(self, agent: str, identity: Identity, record: Record) -> Sample:
        channel = record["channel"]
        content = from_json(self.messages[channel.rpartition(".")[2]], record["message"])
        if record["kind"] == "arrived":
            return Sample(channel, content, identity[0], record["measured"], identity)
        own = record.get("region") if record["agent"] == agent else None
        sender = record.get("sender") or record["agent"]
        moment = record["measured"] if "measured" in record else record["time"]
        return Sample(channel, content, sender, moment, identity, own)

    def _mail(self, agent: str, identity: Identity, record: Record) -> AgentMessage:
        name = str(record["message"])
        content = from_json(self.messages[name], record["content"]) if name in self.messages else None
        branch = self.branches[agent, record["conversation"], record["receiver"]]
        part = record["participant"]
        answered = [name_of(_identity(item)) for item in record.get("answers", ()) if item[0] == agent]
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


def _identity(value: InputName) -> Identity:
    name, number = value
    return str(name), int(number)


__all__ = ["NobodyThere", "NotPlayable", "Recording", "recorded"]
