"""Topics: what is published where, the tree that topics form, and what fits the bodies' radio."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.messages import Channel, ChannelKind, ChannelRules, Message, Topic
from aseme_dsl.codegen.radio import KIND_BYTES, MOST_KINDS, Unfit, parts
from aseme_dsl.compiler.names.inclusion import includers
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.builtins import COMM_TYPES, reserved
from aseme_dsl.compiler.read.collector import Collector
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import declared_twice, unknown
from aseme_dsl.diagnostics import Related
from aseme_dsl.diagnostics.problems import names as problems
from aseme_dsl.diagnostics.problems.absences import NoCommunicationClass, NoMessage, NoPublisher, NoTopic
from aseme_dsl.diagnostics.problems.expressions.paths import NotExpiring, NotKept, NotQueued
from aseme_dsl.grammar.text import tree

OUTSIDE = "outside"
"""Who publishes what comes from outside the system, if nothing else is called so."""


def topics(collector: Collector, symbols: Symbols) -> tuple[Topic, ...]:
    """The topics with their channels; `symbols` has the messages and teams already."""
    found: dict[str, Topic] = {}
    declared = list(collector.every(tree.Topic))
    declared_names = {item.name.text for item in declared}
    kept: list[tree.Topic] = []
    limited = any(entry.sources for item in declared for entry in item.entries)
    publishers = symbols.agents | _publishers(collector) if limited else frozenset()
    including = includers(collector.every(tree.Srm)) if limited else {}
    for item in declared:
        name = item.name.text
        reason = "class" if name in COMM_TYPES else reserved(name)
        if reason is not None:
            collector.report(problems.ReservedName("topic", name, reason), item.name.span)
        if name in found:
            collector.diagnostics.append(declared_twice("topic", item.name, found[name].span))
            continue
        if (
            item.under is not None
            and item.under.text not in declared_names
            and not collector.is_excused(item.under.text)
        ):
            collector.diagnostics.append(unknown(NoTopic, item.under, declared_names - {name}))
        found[name] = Topic(
            name,
            item.under.text if item.under is not None and item.under.text in declared_names else None,
            None if item.radio is None else int(item.radio.value),
            _channels(collector, item, symbols, publishers, including),
            item.name.span,
            None if item.delay is None else item.delay.nanoseconds,
        )
        if item.delay is not None and item.radio is None:
            collector.report(problems.DelayWithoutRadio(name), item.delay.span)
        kept.append(item)
    _check_tree(collector, kept, found)
    return tuple(found.values())


def _activities(formulas: tuple[tree.NamedFormula, ...]) -> set[str]:
    return {item.name for formula in formulas for item in names(formula.formula)}


def _publishers(collector: Collector) -> set[str]:
    """Roles and activities: those who may be said to publish, besides the agents.

    Roles outside the system (people, and systems that are there already) are those of the use cases, or
    `outside` where it does not matter which.
    """
    found = {OUTSIDE} | {
        name.text
        for suc in collector.every(tree.Suc)
        for group in suc.roles
        if group.type is not None and group.type.text in ("human", "legacy", "external")
        for name in group.names
    }
    for role in collector.every(tree.Srm):
        found.add(role.name.text)
        found |= _activities(role.formulas)
        found |= {item.name.text for item in role.activities}
        found |= {item.name.text for item in role.modules}
        found |= {
            binding.own.text for item in role.plays for binding in item.bindings if binding.own is not None
        }
    for protocol in collector.every(tree.Aip):
        for participant in protocol.participants:
            found |= _activities(participant.formulas)
    for chart in collector.every(tree.Statechart):
        found.add(chart.name.text)
        found |= {item.name.text for item in chart.modules}
        found |= {node.activity.text for node in chart.nodes if node.activity is not None}
        found |= {node.name.text for node in chart.nodes if node.name is not None}
    return found


def _with_includers(sources: Iterable[tree.Name], including: Mapping[str, Sequence[str]]) -> Iterator[str]:
    for source in sources:
        yield source.text
        yield from including.get(source.text, ())


def _check_tree(collector: Collector, declared: list[tree.Topic], found: dict[str, Topic]) -> None:
    """No topic is below itself; the circle is cut where it is reported."""
    for item in declared:
        seen = [item.name.text]
        upper = found[item.name.text].under
        while upper is not None and upper not in seen:
            seen.append(upper)
            upper = found[upper].under
        if upper == item.name.text:
            assert item.under is not None
            collector.report(problems.TopicBelowItself((*seen, upper)), item.under.span)
            found[upper] = replace(found[upper], under=None)


def _channels(
    collector: Collector,
    topic: tree.Topic,
    symbols: Symbols,
    publishers: Collection[str],
    including: Mapping[str, Sequence[str]],
) -> tuple[ChannelRules, ...]:
    """The channels of a topic. Who includes a role publishes as it: `including` gives each its includers."""
    found: dict[Channel, ChannelRules] = {}
    for entry in topic.entries:
        if entry.comm.text not in COMM_TYPES:
            collector.diagnostics.append(unknown(NoCommunicationClass, entry.comm, COMM_TYPES))
            continue
        comm = ChannelKind(entry.comm.text)
        if entry.queued and comm is not ChannelKind.SIGNAL:
            collector.report(NotQueued(str(comm)), entry.span)
        for source in entry.sources:
            if source.text not in publishers and not symbols.is_excused(source.text):
                collector.diagnostics.append(unknown(NoPublisher, source, publishers))
        if entry.persist and comm is not ChannelKind.STATE:
            collector.report(NotKept(str(comm)), entry.span)
        if entry.expires is not None and (comm is not ChannelKind.SIGNAL or not entry.expires.nanoseconds):
            collector.report(NotExpiring(str(comm)), entry.expires.span)
        for name in entry.messages:
            if symbols.message(name.text) is None:
                if not symbols.is_excused(name.text):
                    pool = [item.name for item in symbols.messages]
                    is_enum, libraries = symbols.enum(name.text) is not None, providers(name.text, "message")
                    collector.diagnostics.append(unknown(NoMessage, name, pool, is_enum, libraries=libraries))
                    collector.wrong.add(name.text)
                continue
            channel = Channel(topic.name.text, comm, name.text)
            if channel in found:
                related = Related(found[channel].span, "first declared here")
                collector.report(problems.CarriedTwice(str(comm), name.text), name.span, related)
                continue
            found[channel] = ChannelRules(
                channel,
                tuple(dict.fromkeys(_with_includers(entry.sources, including))),
                None if entry.every is None else entry.every.nanoseconds,
                entry.queued,
                entry.persist,
                name.span,
                None if entry.expires is None else entry.expires.nanoseconds,
            )
    return tuple(found.values())


def check_radio(collector: Collector, symbols: Symbols) -> None:
    """What travels by radio fits it (E211 names the member with which it no longer does)."""
    limits = {item.name.text: item.radio for item in reversed(list(collector.every(tree.Topic)))}
    on_air = [topic for topic in symbols.topics if topic.radio is not None]
    for topic in on_air:
        written = limits[topic.name]
        assert written is not None
        for rules in topic.channels:
            message = symbols.message(rules.channel.message)
            if message is not None and message.name not in symbols.wrong:
                _check_size(collector, symbols, message, rules, written)
    if sum(len(topic.channels) for topic in on_air) > MOST_KINDS:
        collector.report(problems.TooManyRadioMessages(MOST_KINDS), on_air[-1].span)


def _check_size(
    collector: Collector, symbols: Symbols, message: Message, rules: ChannelRules, limit: tree.Number
) -> None:
    plural = "" if limit.value == 1 else "s"
    sent = parts(message, symbols.message, symbols.enum)
    carries = Related(limit.span, f"the radio of `{rules.channel.topic}` carries {limit.value} byte{plural}")
    size = KIND_BYTES
    for part in sent:
        this = Related(part.path[-1].span, "this field")
        if isinstance(part, Unfit):
            unfit = problems.UnfitForRadio(message.name, part.name, part.why, str(part.path[-1].type))
            collector.report(unfit, rules.span, this, carries)
            return
        size += part.size
        if size > limit.value:
            whole = KIND_BYTES + sum(item.size for item in sent if not isinstance(item, Unfit))
            long = problems.TooLongForRadio(message.name, part.name, whole, int(limit.value))
            collector.report(long, rules.span, this, carries)
            return
