"""Recorded: the courses that agents of some roles went in a run, read from its trace.

The inputs of a step stand in the trace by their identities; the line of the step names those that it took. A
chart of the present model is led along while the trace is read, to make sure that it takes the same steps.
Where it does not, or where the trace does not say enough, the course ends, and says why.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl.play.inputs import RecordedInputs, identity_of
from aseme_dsl.project.studying.course import Course, Given, Recorder, begun
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Input,
    Sample,
)
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
        self.reads = {channel for kind in kinds.values() for channel in kind.READERS}
        self.inputs = RecordedInputs(self.agents, self.reads)
        self.kinds_of_lines: dict[str, Callable[[Record], None]] = {
            "header": self.header,
            "consumed": self.taken,
            "swap": self.changed,
            "select": self.changed,
            "step": self.step,
        }

    def line(self, record: Record) -> None:
        """A line; those of other kinds say nothing of what agents got."""
        self.inputs.line(record)
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

    def taken(self, record: Record) -> None:
        item = self.agents.get(record["agent"])
        if item is not None and item.until is None:
            found = self.input(item, record["input"])
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
        number = item.steps + 1
        if record["step"] != number:
            item.until = f"the trace does not have step {number}"
            return
        inputs: list[Input] = []
        ahead: list[Sample] = []
        for identity in [*record["inputs"], *record.get("ahead", ())]:
            found = self.input(item, identity)
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

    def input(self, item: _Agent, identity: InputName) -> Input | None:
        """What an input of an agent was; None if the trace does not say."""
        return self.inputs.input(item.recorder.chart, self.messages, identity_of(identity))


__all__ = ["NobodyThere", "NotPlayable", "Recording", "recorded"]
