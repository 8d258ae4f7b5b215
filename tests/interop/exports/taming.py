"""Random charts without what no export can say."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    Assign,
    Bound,
    Call,
    Compare,
    Conditional,
    Contains,
    Element,
    EnumConstant,
    Evaluate,
    Event,
    Find,
    Has,
    Index,
    ListValue,
    Literal,
    LossReason,
    Member,
    Publish,
    Raise,
    Raised,
    Random,
    RoundValue,
    Sender,
    Size,
    StartTimer,
    StateValue,
    Value,
    VariableValue,
    rewritten_expression,
    values_of,
    walk,
)
from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.messages import Channel, ChannelKind, Kind
from aseme_dsl.amola.statechart import Statechart, StateType, Transition, TransitionKind
from aseme_dsl.amola.system import System

PLAIN = (Kind.BOOL, Kind.INT, Kind.DOUBLE, Kind.STRING, Kind.DURATION, Kind.ENUM)


def tamed(system: System) -> System:
    """The system with something else wherever an export would refuse."""
    return replace(
        system,
        iacs=tuple(_chart(chart) for chart in system.iacs),
        activities=tuple(replace(item, within=None) for item in system.activities),
    )


def _chart(chart: Statechart) -> Statechart:
    kept = tuple(item for item in chart.transitions if _is_kept(chart, item))
    changed = frozenset(
        action.target.name
        for item in kept
        for action in item.expression.actions
        if isinstance(action, Assign) and isinstance(action.target, VariableValue)
    )
    owner: dict[str, str] = {}
    transitions = tuple(_transition(chart, item, changed, owner) for item in kept)
    reads = {v.channel for t in transitions for v in values_of(t.expression) if isinstance(v, Member)}
    reads |= {
        part.channel
        for state in chart.states
        for item in state.arguments
        for part in walk(item.value)
        if isinstance(part, Member)
    }
    ordered = tuple(sorted(reads, key=str))
    return replace(
        chart,
        transitions=transitions,
        regions=tuple(replace(region, reads=ordered) for region in chart.regions),
        variables=tuple(replace(item, bounds=None, length=None) for item in chart.variables),
    )


def _is_kept(chart: Statechart, item: Transition) -> bool:
    if item.kind is TransitionKind.ABANDON:
        return False
    if item.kind is TransitionKind.ON:
        inside = [s for s in chart.states if s.label == item.source or s.label.startswith(f"{item.source}.")]
        is_event = bool(item.expression.events) and not item.expression.when
        beyond = chart.ancestors(chart.region_of(item.source))
        leaving = [way.expression for state in beyond for way in chart.outgoing(state.label)]
        overtaken = any(expression.events or expression.when for expression in leaving)
        return is_event and not overtaken and not any(state.type is StateType.AND for state in inside)
    if not item.changes_state:
        return True
    scope = chart.scope_of(item)
    around = [item.source, *(state.label for state in chart.ancestors(item.source))]
    for label, parent in pairwise(around):
        if label == scope:
            break
        if chart.node(parent).type is StateType.AND and chart.children(parent)[0].label != label:
            return False
    return chart.acts_in(item) == chart.region_of(item.source)


def _transition(
    chart: Statechart, item: Transition, changed: frozenset[str], owner: dict[str, str]
) -> Transition:
    region = chart.region_of(item.source)

    def simple(value: Value) -> Value:
        return _value(value, chart, item.source, changed, owner)

    expression = rewritten_expression(item.expression, simple)
    actions = []
    for action in expression.actions:
        if any(_asks(value) for value in values_of(replace(expression, condition=None, actions=(action,)))):
            continue
        match action:
            case Assign(target=VariableValue(name=name, path=(), type=kind), value=value):
                plain = kind.kind in PLAIN and value.type.kind in PLAIN
                if plain and owner.setdefault(name, region) == region:
                    actions.append(action)
            case StartTimer() | Evaluate() | Raise():
                actions.append(action)
            case Publish(channel=channel) if channel.comm is ChannelKind.SIGNAL:
                actions.append(action)
    if expression == item.expression:
        expression = item.expression  # what is NEVER stays it
    events = tuple(dict.fromkeys(_event(event, item) for event in expression.events))
    changed_expression = replace(
        expression,
        events=events,
        actions=tuple(actions),
        weight=None,
        draw=None,
        condition=expression.condition,
    )
    if changed_expression == item.expression:
        changed_expression = item.expression
    return replace(item, expression=changed_expression, resume=False)


def _event(event: Event, item: Transition) -> Event:
    if isinstance(event, Raised) or (type(event).__name__ == "After" and item.kind is not TransitionKind.ON):
        return event
    return Raised("hop", event.span)


def _value(
    value: Value, chart: Statechart, source: str, changed: frozenset[str], owner: dict[str, str]
) -> Value:
    match value:
        case Compare() | Conditional() if _asks(value):
            return _something(value)
        case Member(channel=channel, type=kind):
            if kind.kind not in (*PLAIN, Kind.MESSAGE):
                return value
            if channel.comm is ChannelKind.SIGNAL:
                return replace(value, channel=Channel("t", ChannelKind.STATE, channel.message))
        case Compare(left=left) if left.type.kind not in PLAIN:
            return _something(value)
        case VariableValue(name=name, path=path, type=kind):
            if path or kind.kind not in PLAIN:
                return _something(value)
            if name in changed and owner.setdefault(name, chart.region_of(source)) != chart.region_of(source):
                return _something(value)
        case Has(message=message) if not isinstance(message, Member):
            return _something(value)
        case Age(message=message) if not isinstance(message, Member):
            return _something(value)
        case StateValue(question="count"):
            return _something(value)
        case StateValue(state=state):
            here = chart.region_of(source)
            for meant in states_meant(chart, source, state):
                other = chart.region_of(meant.label)
                if not (here == other or here.startswith(f"{other}.") or other.startswith(f"{here}.")):
                    return _something(value)
        case Bound() | Sender() | LossReason() | RoundValue() | Random() | Index():
            return _something(value)
        case Element() | Size() | Contains() | Find() | ListValue():
            return _something(value)
        case Arithmetic(operator=operator, right=right):
            if operator in ("/", "%") and not (isinstance(right, Literal) and right.value):
                return value.left if value.left.type == value.type else _something(value)
        case Call(function=function):
            if function.target.startswith("builtin:"):
                return value
            asks = {v.name for v in walk(value) if isinstance(v, VariableValue)}
            inside = any(type(v).__name__ in ("Random",) for v in walk(value))
            unsteady = any(
                type(v).__name__ in ("StateValue", "Outcome", "Expired", "Holds") for v in walk(value)
            )
            if function.name in ("shy", "inverse") or asks & changed or unsteady or inside:
                return _something(value)
    return value


def _asks(value: Value) -> bool:
    """Whether a value inside asks for states."""
    return any(isinstance(part, StateValue) for part in walk(value))


def _something(value: Value) -> Value:
    """A constant of its type, another for another place; what has no constants stays, for what is around it
    to go."""
    chance = value.span.start % 4
    constants: dict[Kind, bool | int | float | str] = {
        Kind.BOOL: chance % 2 == 0,
        Kind.INT: chance,
        Kind.DOUBLE: chance / 2,
        Kind.DURATION: chance * 5_000_000,
        Kind.STRING: "ab"[chance % 2],
    }
    if value.type.kind is Kind.ENUM:
        return EnumConstant(("RED", "GREEN", "BLUE")[chance % 3], chance % 3, value.type, value.span)
    if value.type.kind not in constants:
        return value
    return Literal(constants[value.type.kind], value.type, value.span)


__all__ = ["tamed"]
