"""Blocks: the declarations that become models, from all files, in document order."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from aseme_dsl.compiler.read.homonyms import told_apart
from aseme_dsl.compiler.read.names import declared_twice
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Blocks:
    """Of two protocols, roles or statecharts of one name the first counts."""

    sags: tuple[tree.Sag, ...]
    sucs: tuple[tree.Suc, ...]
    aips: tuple[tree.Aip, ...]
    roles: tuple[tree.Srm | tree.Statechart, ...]

    @property
    def srms(self) -> tuple[tree.Srm, ...]:
        return tuple(item for item in self.roles if isinstance(item, tree.Srm))

    @property
    def statecharts(self) -> tuple[tree.Statechart, ...]:
        return tuple(item for item in self.roles if isinstance(item, tree.Statechart))


def blocks_of(files: Iterable[tree.File]) -> tuple[Blocks, tuple[Diagnostic, ...]]:
    """The blocks of the files, and those declared twice (E201). A statechart is a role as an `srm` is."""
    sags: list[tree.Sag] = []
    sucs: list[tree.Suc] = []
    aips: dict[str, tree.Aip] = {}
    roles: dict[str, tree.Srm | tree.Statechart] = {}
    found: list[Diagnostic] = []
    for file in files:
        for item in file.declarations:
            match item:
                case tree.Sag():
                    sags.append(item)
                case tree.Suc():
                    sucs.append(item)
                case tree.Aip():
                    item = with_exchange(item)
                    protocol = aips.setdefault(item.name.text, item)
                    if protocol is not item:
                        found.append(declared_twice("protocol", item.name, protocol.name.span))
                case tree.Srm() | tree.Statechart():
                    item = told_apart(item) if isinstance(item, tree.Srm) else item
                    role = roles.setdefault(item.name.text, item)
                    if role is not item:
                        found.append(declared_twice("role", item.name, role.name.span))
    return Blocks(tuple(sags), tuple(sucs), tuple(aips.values()), tuple(roles.values())), tuple(found)


def participants_of(written: tree.Aip) -> Sequence[tree.Participant]:
    """The participants of a protocol; of two with one name the first."""
    found: dict[str, tree.Participant] = {}
    for item in written.participants:
        found.setdefault(item.name.text, item)
    return tuple(found.values())


# ---- what participants exchange ------------------------------------------------------------------


def with_exchange(protocol: tree.Aip) -> tree.Aip:
    """The protocol in which a participant without `sends` and `receives` has what the lines say.

    It receives what its own lines take. It sends what they send, and what lines of others take from it: that
    comes from an activity, or from a role that is busy.
    """
    if all(map(lists, protocol.participants)):
        return protocol
    return replace(
        protocol,
        participants=tuple(
            item if lists(item) else _listing(protocol, item) for item in protocol.participants
        ),
    )


def lists(participant: tree.Participant) -> bool:
    """Whether a participant says itself what it exchanges: then it says all of it."""
    whole = participant.span
    return any(
        item.span.source is whole.source and whole.start <= item.span.start < whole.end
        for item in (*participant.sends, *participant.receives)
    )


def _listing(protocol: tree.Aip, participant: tree.Participant) -> tree.Participant:
    """The participant with lists, in the order of the lines."""
    own = {participant.name.text, *(item.name.text for item in participant.formulas)}
    sent: list[tree.Send | tree.Received] = []
    taken: list[tree.Received] = []
    for control in protocol.controls:
        for entry in control.entries:
            events = [item for item in entry.expression.events if isinstance(item, tree.Received)]
            if control.name.text in own:
                sent += [item for item in entry.expression.actions if isinstance(item, tree.Send)]
                taken += events
            else:
                sent += [item for item in events if item.participant.text == participant.name.text]
    return replace(participant, sends=_messages(sent), receives=_messages(taken))


def _messages(said: Iterable[tree.Send | tree.Received]) -> tuple[tree.AgentMessage, ...]:
    found: dict[tuple[str, str], tree.AgentMessage] = {}
    for item in said:
        place = item.performative.span.to(item.message.span)
        message = tree.AgentMessage(item.performative, item.message, place)
        found.setdefault((item.performative.text, item.message.text), message)
    return tuple(found.values())


__all__ = ["Blocks", "blocks_of", "lists", "participants_of", "with_exchange"]
