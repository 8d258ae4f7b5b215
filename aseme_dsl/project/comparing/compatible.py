"""Compatible: whether robots of two versions of a system understand each other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain

from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.plan import protocol_versions
from aseme_dsl.codegen.proto import descriptor_set, full_name
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.contract import Contract, Exchange, Reading, reading, types_of
from aseme_dsl.source import Span

NEW_TO_OLD, OLD_TO_NEW, BOTH = "new to old", "old to new", "both"


@dataclass(frozen=True, slots=True)
class Incompatible:
    """A channel or protocol of which robots of two versions refuse messages.

    `kind` is channel or protocol; in `reason`, *here* is the version of the receiver. `way` says which
    messages are refused. The places are those of what differs.
    """

    kind: str
    name: str
    way: str
    reason: str
    old: Span
    new: Span


@dataclass(frozen=True, slots=True)
class Compatibility:
    """What robots of two versions can and cannot exchange."""

    incompatible: tuple[Incompatible, ...]
    only_old: tuple[str, ...]
    """Channels, protocols and agents that only the old version has: `channel team.signal.Call`."""
    only_new: tuple[str, ...]


def compatibility(old: System, new: System) -> Compatibility:
    """Compare the contracts of two versions."""
    before, after = contract_of(old), contract_of(new)
    by_old, by_new = reading(before, after), reading(after, before)
    found = (*_channels(old, new, by_old, by_new, before), *_protocols(old, new, by_new, before, after))
    names, others = set(_names(old, before)), set(_names(new, after))
    return Compatibility(found, tuple(sorted(names - others)), tuple(sorted(others - names)))


def contract_of(system: System) -> Contract:
    """What a system says of its messages and protocols."""
    messages, enums = types_of(
        descriptor_set(system),
        {item.name: full_name(system, item) for item in system.messages},
        (
            f"{item.name}.{field.name}"
            for item in system.messages
            for field in item.fields
            if field.type.kind is Kind.DURATION
        ),
    )
    channels = {
        str(rules.channel): (rules.channel.message, rules.queued)
        for topic in system.topics
        for rules in topic.channels
    }
    versions = protocol_versions(system)
    protocols = {}
    for aip in system.aips:
        named = {item.message for part in aip.participants for item in (*part.sends, *part.receives)}
        half = len(versions[aip.name]) // 2
        protocols[aip.name] = Exchange(versions[aip.name][:half], tuple(sorted(named & messages.keys())))
    return Contract(messages, enums, channels, protocols)


def _channels(
    old: System, new: System, by_old: Reading, by_new: Reading, before: Contract
) -> Iterator[Incompatible]:
    for name, (message, _) in before.channels.items():
        there, here = by_old.channels.get(name), by_new.channels.get(name)
        if name not in _channel_spans(new) or not (there or here):
            continue
        way = BOTH if there and here else NEW_TO_OLD if there else OLD_TO_NEW
        reader = by_new if here else by_old
        objection = reader.objections.get(message)
        if objection is None:
            places = _channel_spans(old)[name], _channel_spans(new)[name]
        else:
            names = (objection.theirs, objection.mine) if here else (objection.mine, objection.theirs)
            places = _place(old, names[0], objection.field), _place(new, names[1], objection.field)
        yield Incompatible("channel", name, way, here or there or "", *places)


def _protocols(
    old: System, new: System, by_new: Reading, before: Contract, after: Contract
) -> Iterator[Incompatible]:
    for name in before.protocols:
        if name in after.protocols and name in by_new.protocols:
            places = (next(aip.span for aip in system.aips if aip.name == name) for system in (old, new))
            yield Incompatible("protocol", name, BOTH, by_new.protocols[name], *places)


def _channel_spans(system: System) -> dict[str, Span]:
    return {str(rules.channel): rules.span for topic in system.topics for rules in topic.channels}


def _place(system: System, message: str, field: str) -> Span:
    """Where a field stands; its message if there is no such field."""
    found = next(item for item in system.messages if item.name == message)
    member = found.field(field)
    return found.span if member is None else member.span


def _names(system: System, contract: Contract) -> Iterable[str]:
    agents = (agent.name for team in system.teams for agent in team.agents)
    return chain(
        (f"channel {name}" for name in contract.channels),
        (f"protocol {name}" for name in contract.protocols),
        (f"agent {name}" for name in agents),
    )


def lines(found: Compatibility, old: str) -> Iterator[str]:
    """What people read: what is refused, with the places, then what only one version has."""
    for item in found.incompatible:
        way = {BOTH: "not compatible", NEW_TO_OLD: "old robots refuse it", OLD_TO_NEW: "new robots refuse it"}
        yield f"{item.new}: {item.kind} {item.name}: {way[item.way]}: {item.reason}"
        yield f"   {item.old}: in {old}"
    for only, which in ((found.only_old, old), (found.only_new, "the new version")):
        if only:
            yield f"only in {which}: {', '.join(only)}"
    if not found.incompatible:
        yield f"compatible with {old}"


def as_json(found: Compatibility) -> dict[str, object]:
    """The same for programs."""
    return {
        "incompatible": [
            {
                "kind": item.kind,
                "name": item.name,
                "refused": item.way,
                "reason": item.reason,
                "old": str(item.old),
                "new": str(item.new),
            }
            for item in found.incompatible
        ],
        "only_old": list(found.only_old),
        "only_new": list(found.only_new),
    }


__all__ = ["Compatibility", "Incompatible", "as_json", "compatibility", "lines"]
