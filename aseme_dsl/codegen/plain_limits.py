"""What a plain statechart cannot do, with each place: agents, and what only their runtime has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from aseme_dsl.amola.expression import (
    Age,
    Assign,
    At,
    Bound,
    Expired,
    Failed,
    Index,
    Lost,
    Mean,
    Member,
    Outcome,
    Publish,
    Random,
    ReadMessages,
    Received,
    Send,
    Sender,
    StartTimer,
    Value,
    VariableValue,
    values_of,
)
from aseme_dsl.amola.messages import AGENT, Comm
from aseme_dsl.amola.statechart import OriginKind, Statechart, Transition, TransitionKind
from aseme_dsl.source import Span

AGENT_MESSAGES = "the messages of agents"
AGENTS = "other agents"
PROTOCOLS = "what a participant of a protocol does"
PUBLISHING = "publishing"
SIGNALS = "signals (a program sends events)"
DATA = "data with its time of measurement, and looking back"
TIMERS = "timers (there is `after`)"
AGES = "how old a message is"
OUTCOMES = "the outcome of an activity"
FAILURES = "the failure of an activity"
NUMBERS = "the number of an agent"
CHANCE = "chance"
STAYING = "`on`"
RESUMING = "`resume`"
PACE = "`every`"
READING = "reading messages during a step"


@dataclass(frozen=True, slots=True)
class Limit:
    """Something that a plain statechart cannot do, and where it is asked for."""

    what: str
    span: Span


def limits(chart: Statechart) -> tuple[Limit, ...]:
    """Everything that is refused, in document order; a chart without any is generated."""
    found = {(limit.what, limit.span.source.path, limit.span.start): limit for limit in _limits(chart)}
    return tuple(sorted(found.values(), key=lambda limit: (limit.span.source.path, limit.span.start)))


def _limits(chart: Statechart) -> Iterator[Limit]:
    for node in chart.nodes:
        if node.origin.kind is OriginKind.PROTOCOL:
            yield Limit(PROTOCOLS, node.span)
    for transition in chart.transitions:
        yield from _of_transition(transition)
    for variable in chart.variables:
        if variable.type == AGENT:
            yield Limit(AGENTS, variable.span)


def _of_transition(transition: Transition) -> Iterator[Limit]:
    expression = transition.expression
    if transition.kind is TransitionKind.ON:
        yield Limit(STAYING, transition.span)
    if transition.resume:
        yield Limit(RESUMING, transition.span)
    if expression.every is not None:
        yield Limit(PACE, transition.span)
    for event in expression.events:
        match event:
            case Received() | Lost():
                yield Limit(AGENT_MESSAGES, event.span)
            case Failed():
                yield Limit(FAILURES, event.span)
    for action in expression.actions:
        match action:
            case Send():
                yield Limit(AGENT_MESSAGES, action.span)
            case Publish():
                yield Limit(PUBLISHING, action.span)
            case ReadMessages():
                yield Limit(READING, action.span)
            case StartTimer():
                yield Limit(TIMERS, action.span)
            case Assign(target=Member()):
                yield Limit(PUBLISHING, action.span)
    for value in values_of(expression):
        what = _of_value(value)
        if what is not None:
            yield Limit(what, value.span)


def _of_value(value: Value) -> str | None:
    match value:
        case Bound() | Sender():
            return AGENT_MESSAGES
        case Age():
            return AGES
        case At() | Mean():
            return DATA
        case Expired():
            return TIMERS
        case Index():
            return NUMBERS
        case Random():
            return CHANCE
        case Outcome():
            return OUTCOMES
        case VariableValue(type=kind) if kind == AGENT:
            return AGENTS
        case Member(channel=channel):
            if channel.comm is Comm.SIGNAL:
                return SIGNALS
            if channel.comm is Comm.DATA:
                return DATA
    return None


__all__ = ["Limit", "limits"]
