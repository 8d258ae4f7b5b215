"""Message lifetime: published and never read, read and never published, or of several agents at once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.expression import At, Literal, Mean, duration_text, values_of
from aseme_dsl.amola.messages import Channel, ChannelKind, ChannelRules, Topic
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.amola.system import Team
from aseme_dsl.compiler.checks.message_use import MessageUse, Use, members_in
from aseme_dsl.compiler.checks.presence import there_if_holds
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import (
    ChangesUnseen,
    ExitWaitsForUndeclared,
    MessageNotPublished,
    MessageNotRead,
    PublishedBySeveral,
    PublishersNotDeclared,
    SignalNotRead,
    WindowTooShort,
)
from aseme_dsl.source import Source, Span

_SHOWN = 4
"""How many related places a problem shows at most."""


SELECT_PLAN = "runtime.signal.SelectPlan"
"""The signal of `import runtime` that the runtime itself reads."""


def check_life(
    roles: Sequence[Statechart],
    use: MessageUse,
    activities: Mapping[str, Activity],
    symbols: Symbols,
    memory: Memory,
) -> InPieces[list[Diagnostic]]:
    """Everything about messages between those who publish and those who read them.

    `use` is that of the roles and of the protocols; `activities` is what is said of those that the roles
    perform.
    """
    readers = _by_channel(use.reads)
    writers = _by_channel(use.writes)
    topics = {topic.name: topic for topic in symbols.topics}
    home = symbols.system.name.span.source if symbols.system is not None else None
    found = [
        *_unread(writers, readers, topics, home),
        *_unwritten(roles, readers, writers, activities, topics, home),
    ]
    for team in symbols.teams:
        found += _of_many(team, use, topics)
    for problems in (yield from memory.each_in_pieces(_windows, zip(roles), writers, activities, symbols)):
        found += problems
    return found


def _is_in(span: Span, home: Source | None) -> bool:
    """Whether it is in the file of the system (read as a whole or in parts)."""
    return home is not None and span.source.path == home.path


def _by_channel(uses: Iterable[Use]) -> dict[Channel, list[Use]]:
    found: dict[Channel, list[Use]] = {}
    for item in uses:
        found.setdefault(item.channel, []).append(item)
    return found


# ---- published, never read -----------------------------------------------------------------------


def _unread(
    writers: Mapping[Channel, Sequence[Use]],
    readers: Mapping[Channel, Sequence[Use]],
    topics: Mapping[str, Topic],
    home: Source | None,
) -> Iterator[Diagnostic]:
    """W520 for a signal without a reader; W422 for a state or data without one that an action publishes.

    Not reported, since they may have readers elsewhere: a state or data that an activity publishes, messages
    by radio, topics that another file declares, and signals of the standard library.
    """
    for channel, uses in writers.items():
        if channel in readers or str(channel) == SELECT_PLAN:
            continue
        topic = topics[channel.topic]
        if channel.comm is ChannelKind.SIGNAL:
            if topic.radio is None and not is_of_library(topic.span.source):
                declared = Related(_declared(topic, channel), "declared here")
                others = _others(uses, "also published here")
                yield Diagnostic(SignalNotRead(str(channel)), uses[0].span, (declared, *others))
            continue
        if topic.radio is not None or not _is_in(topic.span, home):
            continue
        for item in uses:
            if item.activity is None:
                declared = Related(_declared(topic, channel), "declared here")
                yield Diagnostic(MessageNotRead(str(channel)), item.span, (declared,))


def _declared(topic: Topic, channel: Channel) -> Span:
    return next((rules.span for rules in topic.channels if rules.channel == channel), topic.span)


def _others(uses: Sequence[Use], what: str) -> tuple[Related, ...]:
    spans = dict.fromkeys(item.span for item in uses if item.span != uses[0].span)
    return tuple(Related(span, what) for span in list(spans)[:_SHOWN])


# ---- read, never published -----------------------------------------------------------------------


def _unwritten(
    roles: Sequence[Statechart],
    readers: Mapping[Channel, Sequence[Use]],
    writers: Mapping[Channel, Sequence[Use]],
    activities: Mapping[str, Activity],
    topics: Mapping[str, Topic],
    home: Source | None,
) -> Iterator[Diagnostic]:
    """W522, or N722 where an activity that says nothing of messages may be the one that publishes.

    Only for topics of the system's own file: another file's may be written by those who share it. A topic
    that says `from` whom it comes is not asked after; nor is anything in a system that says of no activity
    what it writes.
    """
    silent, told = False, False
    coded: dict[str, None] = {}  # of the silent ones
    for chart in roles:
        for node in chart.states:
            if node.type is StateType.BASIC and node.activity is not None:
                said = activities.get(node.activity)
                if said is None or not (
                    said.reads or said.writes or said.reads_variables or said.writes_variables
                ):
                    silent = True
                    if said is None or said.has_code:
                        coded.setdefault(node.activity)
                else:
                    told = told or bool(said.writes)
    if silent and not told:
        yield from _awaited_in_vain(roles, writers, topics, home, coded)
        return
    doubtful: list[Use] = []
    for channel, found in readers.items():
        topic = topics[channel.topic]
        uses = [use for use in found if not use.whole]
        if not uses or channel in writers or not _is_in(topic.span, home) or _rules(topic, channel).sources:
            continue
        if silent:
            doubtful.append(uses[0])
            continue
        yield Diagnostic(
            MessageNotPublished(str(channel)),
            uses[0].span,
            (Related(_declared(topic, channel), "declared here"), *_others(uses, "also read here")),
        )
    if doubtful:
        yield Diagnostic(
            PublishersNotDeclared(tuple(str(use.channel) for use in doubtful), tuple(coded)),
            doubtful[0].span,
            tuple(Related(use.span, f"`{use.channel}` is read here") for use in doubtful[1 : _SHOWN + 1]),
        )


def _awaited_in_vain(
    roles: Sequence[Statechart],
    writers: Mapping[Channel, Sequence[Use]],
    topics: Mapping[str, Topic],
    home: Source | None,
    silent: Iterable[str],
) -> Iterator[Diagnostic]:
    """N722 where no activity is described: only for what the one outgoing transition of a state waits for.

    While nothing comes there, the agent stays for good.
    """
    found: dict[Channel, tuple[Span, State]] = {}
    for chart in roles:
        for transition in chart.transitions:
            condition = transition.expression.condition
            if condition is None or not _is_only_way(chart, transition):
                continue
            needed = there_if_holds(condition)
            for member, span in members_in([condition]):
                channel = member.channel
                topic = topics[channel.topic]
                if channel not in needed or channel in writers or not _is_in(topic.span, home):
                    continue
                if topic.radio is None and not _rules(topic, channel).sources:
                    found.setdefault(channel, (span, chart.node(transition.source)))
    if not found:
        return
    (channel, (span, source)), *others = found.items()
    yield Diagnostic(
        ExitWaitsForUndeclared(str(channel), cut(source.name), tuple(silent)),
        span,
        (
            Related(_declared(topics[channel.topic], channel), "declared here"),
            *(Related(place, f"`{other}` is waited for here") for other, (place, _) in others[:_SHOWN]),
        ),
    )


def _is_only_way(chart: Statechart, transition: Transition) -> bool:
    """Whether nothing else leads out of the source of a transition, or of a state around it."""
    if not transition.changes_state or transition.expression.events or transition.source == transition.target:
        return False
    if len(chart.outgoing_edges(transition.source)) > 1:
        return False
    return not any(
        way.expression.events or way.expression.when
        for around in chart.ancestors(transition.source)
        for way in chart.outgoing_edges(around.label)
    )


def _rules(topic: Topic, channel: Channel) -> ChannelRules:
    return next(rules for rules in topic.channels if rules.channel == channel)


# ---- published by several agents -----------------------------------------------------------------


def _of_many(team: Team, use: MessageUse, topics: Mapping[str, Topic]) -> Iterator[Diagnostic]:
    """N723: a role hears of several agents mixed what it publishes not itself, without a word about it.

    A message stays with its agent unless the reader never publishes on its channel. The topic says that it is
    the team's by `radio` or `from`, the reader that it wants one agent's by its name.
    """
    agents: dict[str, list[str]] = {}
    for agent in team.agents:
        agents.setdefault(agent.role, []).append(agent.name)
    publishing: dict[Channel, dict[str, None]] = {}
    for item in use.writes:
        if item.chart in agents:
            publishing.setdefault(item.channel, {})[item.chart] = None
    done: set[tuple[str, Channel]] = set()
    for item in use.reads:
        roles = publishing.get(item.channel, {})
        if item.host is not None or item.whole or item.chart not in agents or item.chart in roles:
            continue
        topic = topics[item.channel.topic]
        names = [name for role in roles for name in agents[role]]
        if len(names) < 2 or topic.radio is not None or _rules(topic, item.channel).sources:
            continue
        if (item.chart, item.channel) in done:
            continue
        done.add((item.chart, item.channel))
        yield Diagnostic(
            PublishedBySeveral(item.chart, str(item.channel), tuple(names), next(iter(roles))),
            item.span,
            (Related(_declared(topic, item.channel), "declared here"),),
        )


# ---- histories -----------------------------------------------------------------------------------


def _windows(
    chart: Statechart,
    writers: Mapping[Channel, Sequence[Use]],
    activities: Mapping[str, Activity],
    symbols: Symbols,
) -> tuple[Diagnostic, ...]:
    """W523 for a mean over a window shorter than the period; N721 for a change that no step evaluates.

    A condition over a history is evaluated when a message arrives, not when old values leave the window. So
    the step is in time only if messages arrive regularly, or if the state is exited at once anyway (`else`).
    """
    found: list[Diagnostic] = []
    for transition in chart.transitions:
        if transition.expression.condition is None:
            continue
        values = values_of(transition.expression)
        for value in (item for item in values if isinstance(item, At | Mean)):
            channel = value.message.channel
            period = _period(channel, writers, activities, symbols)
            if isinstance(value, Mean) and period is not None:
                window = value.window.value if isinstance(value.window, Literal) else None
                if isinstance(window, int) and window < period[0]:
                    often = duration_text(period[0])
                    problem = WindowTooShort(str(channel), duration_text(window), often)
                    found.append(Diagnostic(problem, value.span, (Related(period[1], f"every {often}"),)))
            decided = any(other.expression.otherwise for other in chart.outgoing(transition.source))
            if period is None and not decided:
                unseen = ChangesUnseen("at" if isinstance(value, At) else "mean", str(channel))
                found.append(Diagnostic(unseen, value.span))
                break
    return tuple(found)


def _period(
    channel: Channel,
    writers: Mapping[Channel, Sequence[Use]],
    activities: Mapping[str, Activity],
    symbols: Symbols,
) -> tuple[int, Span] | None:
    """How often values come on a channel, as its topic or the activity that publishes it says."""
    rules = symbols.channel(channel)
    if rules is not None and rules.every is not None:
        return rules.every, rules.span
    periods = []
    for item in writers.get(channel, ()):
        said = activities.get(item.activity) if item.activity is not None else None
        if said is None or said.every is None:
            return None
        periods.append((said.every, said.span))
    return max(periods, key=lambda item: item[0], default=None)


__all__ = ["check_life"]
