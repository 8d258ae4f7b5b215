"""Signal readers: where one reader of a signal leaves nothing of it to another one in the same region."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.messages import Channel, ChannelKind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType, Transition
from aseme_dsl.compiler.checks.message_use import members_of, read_channels
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import SignalAlreadyConsumed, SignalConsumedBeforeActivity
from aseme_dsl.source import Span

Asked = dict[Channel, Span]
"""The signals that a transition names, each with its first place."""


def check_signals(
    chart: Statechart, activities: Mapping[str, Activity], symbols: Symbols
) -> Iterator[Diagnostic]:
    """W521: a signal that is consumed before its reader can use it.

    - A transition that is taken consumes the signals that it names. So a choice in the target state does not
      find them.
    - A `when` reads each signal as it arrives, and the step then consumes it. So the activity of the state
      does not get it.

    Queued signals are not reported: the next one may be waiting.
    """
    asking = [(item, signals) for item in chart.transitions if (signals := _signals(item, symbols))]
    if not asking:
        return
    incoming: dict[str, list[tuple[Transition, Asked]]] = {}
    for item in chart.transitions:
        if not item.changes_state or item.reactive:
            continue
        incoming.setdefault(item.target, []).append((item, _signals(item, symbols)))
    for transition, signals in asking:
        yield from _taken_on_the_way(chart, transition, signals, incoming)
        if transition.expression.when:
            yield from _looked_at_first(chart, transition, signals, activities, symbols)


def _signals(transition: Transition, symbols: Symbols) -> Asked:
    found: Asked = {}
    for member, span in members_of(transition.expression):
        if member.channel.comm is ChannelKind.SIGNAL:
            rules = symbols.channel(member.channel)
            if rules is None or not rules.queued:
                found.setdefault(member.channel, span)
    return found


def _taken_on_the_way(
    chart: Statechart,
    transition: Transition,
    signals: Asked,
    incoming: Mapping[str, Sequence[tuple[Transition, Asked]]],
) -> Iterator[Diagnostic]:
    """What every entry transition of the state around has taken, in the same step."""
    source = chart.by_label[transition.source]
    while source.type is StateType.CONDITION:
        ways = incoming.get(source.label, [])
        if len(ways) != 1:
            return
        source = chart.by_label[ways[0][0].source]
    if source.type is not StateType.START or source.parent is None or chart.is_region(source.parent):
        return
    ways = incoming.get(source.parent, [])
    for channel, span in signals.items():
        first = [_taken_by(chart, way, taken, incoming).get(channel) for way, taken in ways]
        if first and all(place is not None for place in first) and first[0] is not None:
            around = chart.by_label[source.parent]
            related = (Related(first[0], f"the entry transition of `{cut(around.name)}` has taken it"),)
            yield Diagnostic(SignalAlreadyConsumed(str(channel)), span, related)


def _taken_by(
    chart: Statechart,
    way: Transition,
    taken: Asked,
    incoming: Mapping[str, Sequence[tuple[Transition, Asked]]],
) -> Asked:
    """What a transition consumes, the one into its choice included."""
    before = incoming.get(way.source, ())
    if chart.by_label[way.source].type is StateType.CONDITION and len(before) == 1:
        return {**before[0][1], **taken}
    return taken


def _looked_at_first(
    chart: Statechart,
    transition: Transition,
    signals: Asked,
    activities: Mapping[str, Activity],
    symbols: Symbols,
) -> Iterator[Diagnostic]:
    """The activities of the same region that want a signal which a `when` looks at while they run."""
    region = chart.region_of(transition.source)
    inside = transition.source + "."
    for node in chart.states:
        said = activities.get(node.activity) if node.activity is not None else None
        if said is None or not (node.label == transition.source or node.label.startswith(inside)):
            continue
        if chart.region_of(node.label) != region:
            continue
        for channel, subscription in read_channels(said, symbols):
            if channel in signals:
                yield Diagnostic(
                    SignalConsumedBeforeActivity(str(channel), said.name),
                    signals[channel],
                    (Related(subscription.span, f"`{said.name}` reads it"),),
                )


__all__ = ["check_signals"]
