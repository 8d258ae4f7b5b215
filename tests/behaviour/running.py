"""A chart that a test plays with: inputs by the names of the text, effects as lines to read."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import fields, is_dataclass, replace
from enum import IntEnum
from typing import Any, Protocol

from aseme_dsl.runtime.chart.inputs import (
    LOST,
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Effect,
    Fault,
    FunctionResult,
    Happened,
    Input,
    Joined,
    Left,
    MailTaken,
    Outcome,
    Publication,
    Resumed,
    Sample,
    Sending,
    Start,
    Suspended,
    Written,
)
from aseme_dsl.runtime.chart.plan import Plan
from tests.support.generated import Generated

MS = 1_000_000


class Engine(Protocol):
    """What every engine can do."""

    pending: Any

    def step(self, now: int, inputs: Iterable[Input]) -> Outcome: ...
    def due(self, now: int) -> int | None: ...
    def configuration(self) -> tuple[str, ...]: ...
    def variable(self, name: str) -> Any: ...


class Run:
    """One agent, called `me`, with what its last step did."""

    def __init__(self, chart: Engine, plan: Plan, generated: Generated) -> None:
        self.chart = chart
        self.plan = plan
        self.generated = generated
        self.now = 0
        self.last = Outcome()
        self.tokens: dict[str, int] = {}
        self._numbers = itertools.count(1)

    # ---- inputs -----------------------------------------------------------------------------

    def step(self, *inputs: Input, ms: float = 0) -> Run:
        """One step, `ms` after the last one; what was heard is as old then as `heard` says."""
        wait = round(ms * MS)
        self.now += wait
        dated = [replace(i, time=i.time + wait) if isinstance(i, Sample) else i for i in inputs]
        self.last = self.chart.step(self.now, dated)
        for start in self.last.of(Start):
            self.tokens[start.label] = start.token
        return self

    def done(self, activity: str, token: int | None = None, outcome: str | None = None) -> Completed:
        """The activity has returned."""
        label = self.label(activity)
        return Completed(label, self.tokens[label] if token is None else token, outcome)

    def crashed(self, activity: str, reason: str = "no battery") -> Crashed:
        label = self.label(activity)
        return Crashed(label, self.tokens[label], reason)

    def heard(self, channel: str, sender: str = "ann", ms_ago: float = 0, **members: Any) -> Sample:
        """A message of another agent."""
        message = self.generated.message(channel.split(".")[2], **members)
        identity = (sender, next(self._numbers))
        return Sample(channel, message, sender, self.now - round(ms_ago * MS), identity)

    def came_back(self, number: int = 0) -> Sample:
        """A publication of the last step, as the bus brings it to the agent's own regions."""
        sent = list(self.last.of(Publication))[number]
        identity = ("me", next(self._numbers))
        return Sample(sent.channel, sent.message, "me", self.now, identity, sent.region)

    def event(self, name: str) -> Happened:
        return Happened(name)

    def wrote(self, variable: str, value: Any) -> Written:
        return Written(variable, value)

    def mail(
        self,
        performative: str,
        message: str,
        sender: str = "ann",
        at: str | None = None,
        ms_ago: float | None = None,
        **members: Any,
    ) -> AgentMessage:
        """An agent message of participant `b` for the branch of `a` (at a label, where there are several).

        Without `ms_ago` nothing says when it was sent.
        """
        branch = at or self.plan.branches[0].label
        content = self.generated.message(message, **members)
        sent = None if ms_ago is None else self.now - round(ms_ago * MS)
        identity = (sender, next(self._numbers))
        return AgentMessage(branch, performative, message, content, "b", sender, identity, sent=sent)

    def lost(self, agent: str, participant: str = "b") -> AgentMessage:
        """An agent that plays a participant is gone."""
        branch = self.plan.branches[0].label
        return AgentMessage(branch, LOST, "", None, participant, agent, (agent, next(self._numbers)))

    def label(self, name: str) -> str:
        """The label of a BASIC state by its activity; a label is its own."""
        found = [state.label for state in self.plan.states if state.activity == name]
        return found[0] if found else name

    # ---- what happened ----------------------------------------------------------------------

    @property
    def active(self) -> list[str]:
        """Where every region stands: an activity, or the label of another leaf; AND states left out."""
        states = [self.plan.by_label[label] for label in self.chart.configuration()]
        return [state.activity or state.label for state in states if state.type != "AND"]

    @property
    def did(self) -> list[str]:
        """The effects of the last step."""
        return [self._line(effect) for effect in self.last.effects]

    @property
    def taken(self) -> list[str]:
        """The transitions of the last step, those of a compound one together."""
        ways = [[self.plan.transitions[number] for number in way] for way in self.last.taken]
        return [" -> ".join([way[0].source, *(step.target for step in way)]) for way in ways]

    @property
    def due(self) -> float | None:
        """After how many milliseconds from now the chart wants to be looked at again."""
        moment = self.chart.due(self.now)
        return None if moment is None else (moment - self.now) / MS

    @property
    def started(self) -> list[str]:
        return [effect.activity for effect in self.last.of(Start)]

    def variable(self, name: str) -> Any:
        """A variable of the role, or of the first branch that has one of that name."""
        keys = [v.name for v in self.plan.variables if v.name.partition("@")[0] == name]
        return self.chart.variable(keys[0])

    def _line(self, effect: Effect) -> str:
        match effect:
            case Start(activity=activity, arguments=arguments):
                given = ", ".join(f"{name}={_told(value)}" for name, value in arguments)
                return f"start {activity}({given})" if given else f"start {activity}"
            case Cancel(activity=activity):
                return f"cancel {activity}"
            case Publication(channel=channel, message=message, host=host):
                return f"publish {channel} {said(message)}" + (f" to {host}" if host else "")
            case Sending(performative=performative, message=message, participant=participant, to=to):
                content = f" {said(effect.content)}" if effect.filled else ""
                others = f" except {', '.join(effect.excepts)}" if effect.excepts else ""
                return f"send {performative} {message}{content} to {to or participant}{others}"
            case MailTaken(identity=identity):
                return f"take mail of {identity[0]}"
            case Joined(branch=branch):
                return f"join {branch}"
            case Left(branch=branch, completed=completed):
                return f"{'complete' if completed else 'part'} {branch}"
            case Suspended(branch=branch):
                return f"suspend {branch}"
            case Resumed(branch=branch):
                return f"resume {branch}"
            case FunctionResult(function=function, value=value):
                return f"{function} is {value}"
            case Fault(transition=number):
                transition = self.plan.transitions[number]
                return f"fault {transition.source} -> {transition.target}"


def _told(value: Any) -> str:
    return value.name if isinstance(value, IntEnum) else said(value)


def said(message: Any) -> str:
    """The members of a message that are not the defaults: `{x=1 on=True}`."""
    if not is_dataclass(message):
        return repr(message)
    default: Any = type(message)()
    parts = []
    for item in fields(message):
        value = getattr(message, item.name)
        if value != getattr(default, item.name):
            shown = (
                value.name if isinstance(value, IntEnum) else said(value) if is_dataclass(value) else value
            )
            parts.append(f"{item.name}={shown}")
    return "{" + " ".join(parts) + "}"
