"""Receiving: what has come for one of our agents, put in order and handed on."""

from __future__ import annotations

import time
from collections.abc import Sequence

from aseme_dsl.runtime.chart.inputs import LOST
from aseme_dsl.runtime.message.acl import JSON, NOT_UNDERSTOOD, AclMessage, name_of
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.builds import be_unknown, decoded, turn_away
from aseme_dsl.runtime.transport.delivery.clocks import clock_record, deadline_of, moment_of, sent_at
from aseme_dsl.runtime.transport.delivery.presence import (
    come_back,
    has_returned,
)
from aseme_dsl.runtime.transport.delivery.records import QUESTIONS, Got, Other, Way
from aseme_dsl.runtime.transport.delivery.reports import count, meet_stranger, tell, tell_once
from aseme_dsl.runtime.transport.delivery.sending import (
    acknowledge,
    hand_over,
    introduction,
    pump,
    say,
)
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.envelope import Envelope

OWED = 64
"""After so many messages an acknowledgement is sent at once."""


def accepted(
    state: Delivery, to: str, other: Other, read: Envelope, payload: bytes, came: int
) -> Sequence[tuple[Envelope, object] | None]:
    """What can be handed on after something has come. Called with the lock."""
    way = state.ways[to, other.name]
    if read.kind == envelopes.ACKNOWLEDGE:
        for place, letter in way.out.acknowledge(read.upto, read.missing, came):
            hand_over(state, other, letter.item, place=place)
        pump(state, way, other)
        return ()
    if read.kind == envelopes.PING:
        if read.time <= way.pinged:
            count(state, other, "duplicated", "one came twice; the second was dropped")
            return ()
        way.pinged = read.time
        if way.owed:
            acknowledge(state, to, other.name, way)
        learn(state, to, other, read, payload)
        pong = state.envelope(envelopes.PONG, asked=read.time, heard=came)
        say(state, to, other.name, "pong", pong, payload=introduction(state, to, other))
        return ()
    if read.kind == envelopes.PONG:
        if read.asked not in way.asked:
            count(state, other, "duplicated", "one came twice; the second was dropped")
            return ()
        way.asked.remove(read.asked)
        learn(state, to, other, read, payload)
        other.heard_at = max(other.heard_at, read.asked)
        trip = (came - read.asked) - (read.time - read.heard)
        other.measured.append((trip, ((read.asked - read.heard) + (came - read.time)) // 2))
        if len(other.measured) == QUESTIONS and not other.is_timed:
            other.is_timed = True
            if measured := clock_record(state, other):
                tell(state, other, "clock", **measured)
        if has_returned(state, other) and not state.closing:
            come_back(state, other)
        return ()
    if read.kind == envelopes.REFUSED and not read.place:
        be_unknown(state, to, other, read.reason)
        return ()
    # Not before its turn: what comes twice is looked into once.
    return [decoded(state, to, other, *item) for item in in_order(state, to, other, way, read, payload)]


def learn(state: Delivery, to: str, other: Other, read: Envelope, payload: bytes) -> None:
    """Take the introduction in a PING or PONG, if heartbeats are sent. Called with the lock."""
    if payload and state.heartbeats is not None:
        state.heartbeats.learn(to, other.name, read.incarnation, payload)


def sender_of(state: Delivery, to: str, sender: str, envelope: Envelope | None = None) -> Other | None:
    """The sender of something to one of ours; None for one that is not known, recorded. Called with the lock.

    One with an `envelope` is of the team: another build has it, ours does not. We notify it of that.
    """
    if state.closing or to not in state.here:
        return None
    other = state.others.get(sender)
    if other is None:
        meet_stranger(state, sender, "untrusted" if envelope is None else "unknown")
        if envelope is not None:
            turn_away(state, to, sender, envelope)
    return other


def in_order(
    state: Delivery, to: str, other: Other, way: Way, envelope: Envelope, payload: bytes
) -> list[Got]:
    """What is to be handed on now that this has come. Called with the lock."""
    if envelope.place == 0:
        return sampled(state, other, way, envelope, payload)
    if envelope.addressee != state.incarnation:
        count(state, other, "late", "it is for an earlier incarnation of its receiver")
        return []
    if envelope.place > way.into.upto + 1:
        count(state, other, "reordered", "one came before its predecessor")
    had_gap = way.into.has_gap
    found = way.into.take(envelope.place, (envelope, payload), len(payload))
    if not way.owed:
        way.owed_since = time.monotonic_ns()
    way.owed += 1
    if found is None:
        count(state, other, "duplicated", "one came twice; the second was dropped")
    if way.owed >= OWED or (way.into.has_gap and not had_gap):
        acknowledge(state, to, other.name, way)
    else:
        state.stir()
    return found or []


def sampled(state: Delivery, other: Other, way: Way, envelope: Envelope, payload: bytes) -> list[Got]:
    """Data, which comes once or not at all."""
    number = envelope.sample
    if envelope.kind != envelopes.MESSAGE or not number or ".data." not in envelope.channel:
        count(state, other, "unreadable", "it has no place in the stream", about=envelope.channel)
        return []
    missed = way.samples.take(number)
    if missed is None:
        count(state, other, "duplicated", "one came twice; the second was dropped")
        return []
    if missed < 0:
        count(state, other, "reordered", "one came before its predecessor")
    elif missed:
        tell_once(state, other, "dropped", "data did not come: too much was sent at once, or the link broke")
    if missed:
        other.counts["dropped"] = other.counts.get("dropped", 0) + missed
    return [(envelope, payload)]


def hand_on(state: Delivery, to: str, other: Other, envelope: Envelope, message: object) -> None:
    """Give a message to the agent that it is for. Called without the lock."""
    agent = state.here[to]
    team = state.team
    if envelope.kind != envelopes.REFUSED:
        other.counts["taken"] = other.counts.get("taken", 0) + 1
    identity = (other.name, envelope.sequence)
    try:
        if envelope.kind in (envelopes.MAIL, envelopes.LOSS):
            acl = AclMessage(
                LOST if envelope.kind == envelopes.LOSS else envelope.performative,
                other.name,
                envelope.receivers,
                envelope.message,
                message,
                envelope.protocol,
                envelope.conversation,
                envelope.participant,
                envelope.to,
                identity,
                ontology=envelope.ontology or team.system,
                reply_with=envelope.reply_with or name_of(identity),
                in_reply_to=envelope.in_reply_to,
                reply_by=deadline_of(state, other, envelope),
                reply_to=envelope.reply_to,
                language=envelope.language or JSON,
                encoding=envelope.encoding,
                sent=sent_at(state, other, envelope),
            )
            team.conversations.arrived(agent, acl, dict(envelope.parts))
        elif envelope.kind == envelopes.REFUSED:
            team.conversations.refused(agent, refusal_of(other, envelope, message), envelope.reason)
        else:
            moment = moment_of(state, other, envelope)
            host = envelope.host or None
            channel = envelope.channel
            reason = team.bus.arrived(agent, channel, message, other.name, identity, moment, host)
            if reason is not None:
                count(state, other, "refused", reason, about=channel)
    except Exception as problem:  # no caller on the link's thread would report it
        reason = f"what {other.name} sent could not be taken: {type(problem).__name__}: {problem}"
        team.trace.fault(team.driver.clock.now(), to, reason)


def refusal_of(other: Other, envelope: Envelope, content: object) -> AclMessage:
    """What an agent would answer that does not understand a message, since it is of another build."""
    identity = (other.name, envelope.sequence)
    return AclMessage(
        NOT_UNDERSTOOD,
        other.name,
        (),
        envelope.message,
        content,
        envelope.protocol,
        envelope.conversation,
        envelope.participant,
        envelope.to,
        identity,
        reply_with=name_of(identity),
        in_reply_to=envelope.in_reply_to,
    )
