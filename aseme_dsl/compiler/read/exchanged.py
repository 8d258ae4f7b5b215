"""Exchanged: what participants that list no agent messages send and receive, by their lines."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from aseme_dsl.grammar.text import tree


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


__all__ = ["lists", "with_exchange"]
