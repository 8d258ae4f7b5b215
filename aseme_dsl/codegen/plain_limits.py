"""What a plain statechart cannot do, with each place: agents, and what only their runtime has."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from aseme_dsl.amola.expression import (
    Age,
    Assign,
    At,
    Bound,
    Failed,
    Index,
    LossReason,
    Lost,
    Mean,
    Member,
    Publish,
    Raise,
    Raised,
    ReadMessages,
    Received,
    RoundValue,
    Send,
    Sender,
    Value,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import AGENT, ChannelKind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import OriginKind, Statechart, Transition, TransitionKind
from aseme_dsl.codegen.code.values import may_fail
from aseme_dsl.diagnostics.problems.running import AgentFeature, SingleFeature
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Limit:
    """Something that a plain statechart cannot do, and where it is asked for."""

    what: AgentFeature | SingleFeature
    span: Span


def limits(chart: Statechart, activities: Iterable[Activity] = ()) -> tuple[Limit, ...]:
    """Everything that is refused, in document order; a chart without any is generated.

    `activities` are those of the system.
    """
    found = {(item.what, item.span.source.path, item.span.start): item for item in _limits(chart, activities)}
    return tuple(sorted(found.values(), key=lambda limit: (limit.span.source.path, limit.span.start)))


def _limits(chart: Statechart, activities: Iterable[Activity]) -> Iterator[Limit]:
    used = {node.activity for node in chart.states}
    for said in activities:
        if said.name in used and said.within is not None:
            yield Limit(AgentFeature.DEADLINES, said.span)
    for node in chart.states:
        for argument in node.arguments:
            for value in walk(argument.value):
                what = AgentFeature.GIVEN if may_fail(value) else _of_value(value)
                if what is not None:
                    yield Limit(what, value.span)
        if node.origin.kind is OriginKind.PROTOCOL:
            yield Limit(AgentFeature.PROTOCOLS, node.span)
    for transition in chart.transitions:
        if chart.acts_in(transition) != chart.region_of(transition.source):
            yield Limit(AgentFeature.LEAVING, transition.span)
        elif transition.into or chart.region_of(transition.target) != chart.region_of(transition.source):
            yield Limit(AgentFeature.ENTERING, transition.span)
        elif transition.kind is TransitionKind.ON and chart.is_region(transition.source):
            yield Limit(AgentFeature.STAYING, transition.span)
        yield from _of_transition(transition)
    has_error = any(isinstance(e, Failed) for item in chart.transitions for e in item.expression.events)
    for variable in chart.variables:
        if variable.type == AGENT:
            yield Limit(AgentFeature.AGENTS, variable.span)
        if variable.is_limited and has_error:
            yield Limit(AgentFeature.BOUNDS, variable.span)


def _of_transition(transition: Transition) -> Iterator[Limit]:
    expression = transition.expression
    if transition.kind is TransitionKind.ON and (
        expression.when or not expression.events or not all(isinstance(e, Raised) for e in expression.events)
    ):
        yield Limit(AgentFeature.STAYING, transition.span)
    if transition.resume:
        yield Limit(AgentFeature.RESUMING, transition.span)
    for event in expression.events:
        match event:
            case Received() | Lost():
                yield Limit(AgentFeature.AGENT_MESSAGES, event.span)
    for action in expression.actions:
        match action:
            case Send():
                yield Limit(AgentFeature.AGENT_MESSAGES, action.span)
            case Publish():
                yield Limit(AgentFeature.PUBLISHING, action.span)
            case Raise():
                yield Limit(AgentFeature.RAISING, action.span)
            case ReadMessages():
                yield Limit(AgentFeature.READING, action.span)
            case Assign(target=Member()):
                yield Limit(AgentFeature.PUBLISHING, action.span)
    for value in values_of(expression):
        what = _of_value(value)
        if what is not None:
            yield Limit(what, value.span)


def _of_value(value: Value) -> AgentFeature | None:
    match value:
        case Bound() | Sender() | LossReason() | RoundValue():
            return AgentFeature.AGENT_MESSAGES
        case Age():
            return AgentFeature.AGES
        case At() | Mean():
            return AgentFeature.DATA
        case Index():
            return AgentFeature.NUMBERS
        case VariableValue(type=kind) if kind == AGENT:
            return AgentFeature.AGENTS
        case Member(channel=channel):
            if channel.comm is ChannelKind.SIGNAL:
                return AgentFeature.SIGNALS
            if channel.comm is ChannelKind.DATA:
                return AgentFeature.DATA
    return None


__all__ = ["Limit", "limits"]
