"""Random charts without what the plain face refuses."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from aseme_dsl.amola.expression import (
    After,
    Age,
    Assign,
    At,
    Changed,
    Evaluate,
    Event,
    Expired,
    Failed,
    Index,
    Literal,
    Mean,
    Member,
    Outcome,
    Raised,
    Random,
    StartTimer,
    Value,
    VariableValue,
    rewritten_expression,
    values_of,
)
from aseme_dsl.amola.messages import Channel, ChannelKind, Kind
from aseme_dsl.amola.statechart import OriginKind, Statechart, Transition, TransitionKind
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.plain_limits import limits


def without_limits(system: System, *, simple: bool = True) -> System | None:
    """The system with something else wherever the plain face would refuse; None for one with protocols.

    A `simple` one has no timers, failures, paces and chance, either.
    """
    if any(node.origin.kind is OriginKind.PROTOCOL for chart in system.iacs for node in chart.states):
        return None
    changed = replace(system, iacs=tuple(_tamed(chart, simple) for chart in system.iacs))
    assert not any(limits(chart) for chart in changed.iacs)
    return changed


def _tamed(chart: Statechart, simple: bool) -> Statechart:
    transitions = tuple(
        _tame(item, simple)
        for item in chart.transitions
        if (item.kind is not TransitionKind.ON or item.expression.events)
        and not item.into
        and chart.acts_in(item) == chart.region_of(item.source) == chart.region_of(item.target)
        and not (item.kind is TransitionKind.ON and chart.is_region(item.source))
    )
    channels = {value.channel for value in _members(transitions)}
    reads = tuple(sorted(channels, key=str))
    regions = tuple(replace(region, reads=reads, writes=()) for region in chart.regions)
    variables = chart.variables
    if any(isinstance(event, Failed) for item in transitions for event in item.expression.events):
        variables = tuple(replace(item, bounds=None, length=None) for item in variables)
        transitions = tuple(map(_without_places, transitions))
    return replace(chart, transitions=transitions, regions=regions, variables=variables)


def _without_places(transition: Transition) -> Transition:
    """Without actions that change an element, which may not be there."""
    expression = transition.expression
    actions = tuple(
        action
        for action in expression.actions
        if not (isinstance(action, Assign) and isinstance(action.value, Changed) and action.value.index)
    )
    return replace(transition, expression=replace(expression, actions=actions))


def _members(transitions: tuple[Transition, ...]) -> list[Member]:
    return [v for item in transitions for v in values_of(item.expression) if isinstance(v, Member)]


def _tame(transition: Transition, simple: bool) -> Transition:
    expression = rewritten_expression(transition.expression, _simple_value if simple else _plain_value)
    events = tuple(dict.fromkeys(_plain_event(event, simple) for event in expression.events))
    kept = Evaluate if simple else Evaluate | StartTimer
    actions = tuple(
        action
        for action in expression.actions
        if isinstance(action, kept)
        or (isinstance(action, Assign) and isinstance(action.target, VariableValue))
    )
    every = None if simple else expression.every
    expression = replace(expression, events=events, actions=actions, every=every)
    if expression == replace(transition.expression):
        expression = transition.expression  # what is NEVER stays it
    if transition.kind is TransitionKind.ON:
        raised = (e if isinstance(e, Raised) else Raised("fail", e.span) for e in expression.events)
        expression = replace(expression, when=False, events=tuple(dict.fromkeys(raised)))
    return replace(transition, expression=expression, resume=False)


def _plain_event(event: Event, simple: bool) -> Event:
    if isinstance(event, Raised | After) or (isinstance(event, Failed) and not simple):
        return event
    return Raised("fail", event.span)


def _simple_value(value: Value) -> Value:
    if isinstance(value, Expired | Random):
        return _something(value.type.kind, value)
    return _plain_value(value)


def _plain_value(value: Value) -> Value:
    match value:
        case Member(channel=channel) if channel.comm is not ChannelKind.STATE:
            return replace(value, channel=Channel("t", ChannelKind.STATE, channel.message))
        case At(message=message, type=kind) | Mean(message=message, type=kind):
            return _something(kind.kind, value) if kind != message.type else message
        case Age() | Index() | Outcome():
            return _something(value.type.kind, value)
    return value


def _something(kind: Kind, value: Value) -> Value:
    """A constant of a type, another for another place."""
    chance = value.span.start % 4
    constants: dict[Kind, Any] = {
        Kind.BOOL: chance % 2 == 0,
        Kind.INT: chance,
        Kind.DOUBLE: chance / 2,
        Kind.DURATION: chance * 5_000_000,
        Kind.STRING: "ab"[chance % 2],
    }
    return Literal(constants[kind], value.type, value.span)
