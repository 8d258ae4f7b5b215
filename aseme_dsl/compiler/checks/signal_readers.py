"""Signal readers: where one leaves nothing of a signal to another in its region, and where one comes late."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from aseme_dsl.amola.messages import Channel, ChannelKind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.compiler.checks.message_use import MessageUse, Use, members_of, read_channels
from aseme_dsl.compiler.checks.presence import there_if_holds
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import (
    SignalAlreadyConsumed,
    SignalConsumedBeforeActivity,
    SignalTakenLate,
)
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
        for label in (item.target, *item.into):
            incoming.setdefault(label, []).append((item, _signals(item, symbols)))
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


# ---- signals that are taken late -----------------------------------------------------------------

_SHOWN = 3
"""How many states are named at most."""

_RESTING = (StateType.BASIC, StateType.AND)
"""Where time passes, also if no transition waits."""

Way = tuple[Transition | None, str]
"""How a state is left or entered, and what is active next."""


def check_stale(
    chart: Statechart, use: MessageUse, activities: Mapping[str, Activity], symbols: Symbols
) -> tuple[Diagnostic, ...]:
    """W525: a state waits for a signal that may have come while another state was active.

    Nothing is said of a signal that expires or is queued, nor of one that only comes when this role has
    published something: what is asked for comes in time.
    """
    found: list[Diagnostic] = []
    for region in chart.regions:
        for channel in _waited_for(chart, region.label, symbols):
            if _comes_at_any_time(chart, region.label, channel, use):
                found += _Region(chart, region.label, channel, activities, symbols).late()
    return tuple(found)


def _waited_for(chart: Statechart, region: str, symbols: Symbols) -> list[Channel]:
    """The signals that conditions in a region name, and that stay until they are taken."""
    found: dict[Channel, None] = {}
    for transition in chart.transitions:
        if chart.region_of(transition.source) != region:
            continue
        for member, _ in members_of(transition.expression):
            rules = symbols.channel(member.channel)
            topic = symbols.topic(member.channel.topic)
            if member.channel.comm is not ChannelKind.SIGNAL or rules is None or topic is None:
                continue
            if not rules.queued and rules.expires is None and not is_of_library(topic.span.source):
                found[member.channel] = None
    return list(found)


def _comes_at_any_time(chart: Statechart, region: str, channel: Channel, use: MessageUse) -> bool:
    """Whether an agent or the environment publishes a signal without waiting for this role."""
    writers = [item for item in use.writes if item.channel == channel]
    modules = {module.name for module in chart.modules}

    def is_beside(item: Use) -> bool:
        return item.chart != chart.name or item.region != region or item.activity in modules

    others = [item for item in writers if is_beside(item)]
    said = {item.channel for item in use.writes if item.chart == chart.name and not is_beside(item)}
    answering = {item.chart for item in use.reads if item.chart != chart.name and item.channel in said}
    return not writers or any(item.chart not in answering for item in others)


class _Region:
    """One region of a role, and one signal that it may take."""

    def __init__(
        self,
        chart: Statechart,
        region: str,
        channel: Channel,
        activities: Mapping[str, Activity],
        symbols: Symbols,
    ) -> None:
        self.chart = chart
        self.region = region
        self.channel = channel
        self.activities = activities
        self.symbols = symbols
        self.states = [node for node in chart.states if chart.region_of(node.label) == region]
        self.leading_out = self._leading_out()

    def late(self) -> Iterator[Diagnostic]:
        """The transitions that wait for the signal, with the states that cannot take it before."""
        found: dict[int, tuple[Span, dict[str, State]]] = {}
        for gap in self.states:
            if gap.type not in _RESTING or self._attends(gap):
                continue
            for place in self._taken_after(gap):
                known = found.setdefault(place.start, (place, {}))
                known[1].setdefault(cut(self._called(gap)), gap)
        for place, gaps in found.values():
            names = tuple(gaps)[:_SHOWN]
            related = tuple(Related(gaps[name].span, "it may come here") for name in names)
            yield Diagnostic(SignalTakenLate(str(self.channel), names), place, related)

    def _called(self, gap: State) -> str:
        """What a state is called in the file: parallel parts by the formula that they are."""
        around = None if gap.parent is None else self.chart.node(gap.parent)
        is_formula = around is not None and around.label != self.region and around.name.isidentifier()
        return around.name if gap.type is StateType.AND and around is not None and is_formula else gap.name

    def _taken_after(self, gap: State) -> Iterator[Span]:
        """Where a signal that has come in a state is taken afterwards."""
        seen: set[str] = set()
        waiting = [target for _, target in self._ways(gap)]
        while waiting:
            node = self.chart.node(waiting.pop())
            if node.label in seen:
                continue
            seen.add(node.label)
            ways = self._ways(node)
            place = next((found for way, _ in ways if (found := self._needs(way)) is not None), None)
            if place is not None and node.type is not StateType.CONDITION:
                yield place
            elif not self._attends(node):
                waiting += [target for _, target in ways]

    def _attends(self, node: State) -> bool:
        """Whether a signal that comes while the state is active is looked at there."""
        said = self.activities.get(node.activity) if node.activity is not None else None
        if said is not None and any(
            channel == self.channel for channel, _ in read_channels(said, self.symbols)
        ):
            return True
        around = [node, *(item for item in self.chart.ancestors(node.label) if item in self.states)]
        return any(self._names(way) for item in around for way in self.chart.outgoing(item.label))

    def _names(self, way: Transition) -> bool:
        return any(member.channel == self.channel for member, _ in members_of(way.expression))

    def _needs(self, way: Transition | None) -> Span | None:
        """The place where a transition names the signal, if it waits for it."""
        condition = None if way is None else way.expression.condition
        if way is None or condition is None or self.channel not in there_if_holds(condition):
            return None
        if way.expression.events:
            return None  # it is looked at when the event comes: what has come before is meant, too
        return next(span for member, span in members_of(way.expression) if member.channel == self.channel)

    # ---- ways ------------------------------------------------------------------------------------

    def _ways(self, node: State) -> Sequence[Way]:
        """What may be active next in the region, and by which transition."""
        chart = self.chart
        if node.type is StateType.OR:
            start = chart.start_of(node.label)
            return [(None, start.label)] if start is not None else []
        ways: list[Way] = list(self.leading_out.get(node.label, ()))
        inner: State | None = node
        while inner is not None and inner.label != self.region and inner.parent is not None:
            around = chart.node(inner.parent)
            completes = inner.type is StateType.END
            for way, target in self.leading_out.get(around.label, ()):
                assert way is not None
                if completes or way.expression.events or way.expression.when or way.first:
                    ways.append((way, target))
            inner = around if around.label != self.region else None
        return ways

    def _leading_out(self) -> dict[str, list[Way]]:
        """The transitions of the region by their sources; those out of an AND as if they left all of it."""
        found: dict[str, list[Way]] = {}
        own = {node.label for node in self.states}
        for transition in self.chart.transitions:
            if not transition.changes_state or transition.reactive or transition.target not in own:
                continue
            source: str | None = transition.source
            while source is not None and source not in own:
                source = self.chart.node(source).parent
            if source is not None:
                found.setdefault(source, []).append((transition, transition.target))
        return found


__all__ = ["check_signals", "check_stale"]
