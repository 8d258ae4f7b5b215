"""Regions: what each concurrent part of a chart reads from and writes to its blackboard."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.expression import Assign, Member, Publish, TransitionExpression, values_of, walk
from aseme_dsl.amola.messages import Channel, ChannelKind
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import Region, State, StateType, Transition
from aseme_dsl.compiler.names.resolve import Symbols


def regions_of(
    nodes: Sequence[State],
    transitions: Sequence[Transition],
    activities: Mapping[str, Activity],
    modules: Sequence[Module],
    symbols: Symbols,
) -> tuple[Region, ...]:
    """The root and the children of every AND, in document order, with their channels.

    A region reads the channels of its conditions, actions and activities. It also reads the `state` and
    `data` channels of the regions inside it, since these start with a copy of its blackboard. The root also
    has the channels of the modules.
    """
    region: dict[str, str] = {}  # of each state: the innermost region that it is, or is in
    around: dict[str, str] = {}  # of each state: the innermost region that holds it
    types: dict[str, StateType] = {}
    reads: dict[str, set[Channel]] = {}
    writes: dict[str, set[Channel]] = {}
    for node in nodes:
        types[node.label] = node.type
        outer = node.parent
        if outer is None or types[outer] is StateType.AND:
            region[node.label] = node.label
            around[node.label] = region[outer] if outer is not None else node.label
            reads[node.label], writes[node.label] = set(), set()
        else:
            region[node.label] = around[node.label] = region[outer]
        reads[region[node.label]].update(_given(node))
        activity = activities.get(node.activity) if node.activity is not None else None
        if activity is not None:
            reads[region[node.label]].update(_read_by(activity, symbols))
            writes[region[node.label]].update(activity.writes)
    for module in modules:
        reads[nodes[0].label].update(_read_by(module.statement, symbols))
        writes[nodes[0].label].update(module.statement.writes)
    for transition in transitions:
        inside = region[transition.source]
        reads[inside].update(channels_read(transition.expression))
        writes[inside].update(channels_written(transition.expression))
    for label in reversed(reads):
        if around[label] != label:
            reads[around[label]].update(c for c in reads[label] if c.comm is not ChannelKind.SIGNAL)
    return tuple(Region(label, tuple(sorted(reads[label])), tuple(sorted(writes[label]))) for label in reads)


def _given(node: State) -> Iterator[Channel]:
    """The channels that are read for what an activity is given."""
    if node.type is StateType.BASIC:
        for argument in node.arguments:
            yield from (value.channel for value in walk(argument.value) if isinstance(value, Member))


def channels_read(expression: TransitionExpression) -> Iterator[Channel]:
    """The channels that the condition and the actions read."""
    return (value.channel for value in values_of(expression) if isinstance(value, Member))


def channels_written(expression: TransitionExpression) -> Iterator[Channel]:
    """The channels whose drafts the actions fill or publish."""
    for action in expression.actions:
        match action:
            case Publish(channel=channel) | Assign(target=Member(channel=channel)):
                yield channel


def _read_by(activity: Activity, symbols: Symbols) -> Iterator[Channel]:
    for subscription in activity.reads:
        if subscription.channel is not None:
            yield subscription.channel
        else:
            for topic in symbols.topics_reached(subscription.topic, subscription.reach):
                yield from (rules.channel for rules in topic.channels)


__all__ = ["channels_read", "channels_written", "regions_of"]
