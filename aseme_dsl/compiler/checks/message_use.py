"""Message use: which role reads and publishes which channel, where it says so, and in which region."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.expression import (
    Assign,
    Evaluate,
    Member,
    Named,
    Publish,
    Send,
    StartTimer,
    TransitionExpression,
    Value,
    operands,
)
from aseme_dsl.amola.messages import Channel
from aseme_dsl.amola.srm import Activity, Subscription
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Use:
    """A place where a channel is read or published: by a transition, or (`activity`) an activity or module.

    `host` is the sender that is asked for, None for any; `whole` where a whole topic is read.
    """

    channel: Channel
    chart: str
    region: str
    host: str | None
    activity: str | None
    span: Span
    whole: bool = False


@dataclass(frozen=True, slots=True)
class MessageUse:
    """Every use in some charts, in document order."""

    reads: tuple[Use, ...]
    writes: tuple[Use, ...]


def message_use(
    charts: Iterable[Statechart],
    activities: Mapping[str, Activity],
    written: Iterable[tree.Activity],
    symbols: Symbols,
    memory: Memory,
) -> InPieces[MessageUse]:
    """What the charts' transitions, the activities in them and the modules beside them read and publish.

    `activities` is what is said of each, `written` where it is said.
    """
    places = _places(written)
    found = yield from memory.each_in_pieces(_use_in, zip(charts), activities, places, symbols)
    return MessageUse(
        tuple(item for use in found for item in use.reads),
        tuple(item for use in found for item in use.writes),
    )


def _use_in(
    chart: Statechart,
    activities: Mapping[str, Activity],
    places: Mapping[tuple[str, str], Span],
    symbols: Symbols,
) -> MessageUse:
    """The use in one chart."""
    reads: list[Use] = []
    writes: list[Use] = []
    done: set[tuple[str, str]] = set()
    regions: dict[str, str] = {}  # of each state: the innermost region around it
    for node in chart.states:
        inner = node.parent is None or chart.by_label[node.parent].type is StateType.AND
        regions[node.label] = node.label if inner or node.parent is None else regions[node.parent]
        region, name = regions[node.label], node.activity
        if node.type is StateType.BASIC:
            for member, span in members_in([argument.value for argument in node.arguments]):
                reads.append(Use(member.channel, chart.name, region, member.host, None, span))
        said = activities.get(name) if name is not None and (region, name) not in done else None
        if name is None or said is None:
            continue
        done.add((region, name))
        for channel, subscription in read_channels(said, symbols):
            whole = subscription.channel is None
            host, span = subscription.host, subscription.span
            reads.append(Use(channel, chart.name, region, host, name, span, whole))
        for channel in said.writes:
            span = places.get((name, str(channel)), said.span)
            writes.append(Use(channel, chart.name, region, None, name, span))
    for module in chart.modules:
        said, root = module.statement, chart.root.label
        for channel, subscription in read_channels(said, symbols):
            whole, host = subscription.channel is None, subscription.host
            reads.append(Use(channel, chart.name, root, host, module.name, subscription.span, whole))
        for channel in said.writes:
            span = places.get((module.name, str(channel)), said.span)
            writes.append(Use(channel, chart.name, root, None, module.name, span))
    for transition in chart.transitions:
        if transition.expression.condition is None and not transition.expression.actions:
            continue
        region = regions[transition.source]
        for member, span in members_of(transition.expression):
            reads.append(Use(member.channel, chart.name, region, member.host, None, span))
        for action in transition.expression.actions:
            if isinstance(action, Publish):
                writes.append(Use(action.channel, chart.name, region, None, None, action.span))
    return MessageUse(tuple(reads), tuple(writes))


def members_of(expression: TransitionExpression) -> Iterator[tuple[Member, Span]]:
    """The messages that the condition and the actions read, each with its place there: a let's is its use."""
    values = [] if expression.condition is None else [expression.condition]
    for action in expression.actions:
        match action:
            case Assign(value=value) | Evaluate(value=value) | StartTimer(duration=value):
                values.append(value)
            case Send():
                values += action.values
    return members_in(values)


def members_in(values: Sequence[Value]) -> Iterator[tuple[Member, Span]]:
    """The messages that values read, each with its place: where a let is used, that of its name."""
    stack: list[tuple[Value, Span | None]] = [(value, None) for value in reversed(values)]
    while stack:
        value, place = stack.pop()
        if isinstance(value, Member):
            yield value, place or value.span
        elif isinstance(value, Named):
            stack.append((value.expression, place or value.span))
        else:
            stack += [(part, place) for part in reversed(operands(value))]


def read_channels(activity: Activity, symbols: Symbols) -> Iterator[tuple[Channel, Subscription]]:
    """The channels that an activity says it reads, each with the clause that says so."""
    for item in activity.reads:
        if item.channel is not None:
            yield item.channel, item
        else:
            for topic in symbols.topics_reached(item.topic, item.reach):
                for rules in topic.channels:
                    yield rules.channel, item


def _places(written: Iterable[tree.Activity]) -> dict[tuple[str, str], Span]:
    found: dict[tuple[str, str], Span] = {}
    for item in written:
        for path in item.writes:
            found.setdefault((item.name.text, path.text), path.span)
    return found


__all__ = ["MessageUse", "Use", "members_in", "members_of", "message_use", "read_channels"]
