"""Sending: what goes to the agents elsewhere, now or when that is possible."""

from __future__ import annotations

import time
from collections.abc import Iterable
from typing import TYPE_CHECKING

from aseme_dsl.runtime.message.wire import WireError
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.records import Other, Sent, Way
from aseme_dsl.runtime.transport.delivery.reports import OVERFLOW, lose
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Stamp
from aseme_dsl.runtime.transport.settings import LARGEST_IN_ORDER
from aseme_dsl.runtime.transport.stream import Letter

if TYPE_CHECKING:
    from aseme_dsl.runtime.chart.plan import ChannelInfo


UNKNOWN = "it is of another build, which does not have its sender"
REPLACED = "a newer one took its place before it could be sent"


def encoded(
    state: Delivery, sender: str, what: str, message: object, in_order: bool = True
) -> tuple[bytes, int] | None:
    """The payload of a message and its contract; None, after telling why, if it cannot travel.

    What must arrive `in_order` is smaller: all that the sender says to the same receivers waits for it.
    """
    codec = state.codec  # a swap may put another one in its place meanwhile
    try:
        payload = codec.encode(message)
    except WireError as problem:
        reason = str(problem)
    else:
        if not in_order or len(payload) <= LARGEST_IN_ORDER:
            return payload, codec.number
        reason = (
            f"it has {len(payload)} bytes, and at the most {LARGEST_IN_ORDER} travel here, unless as data"
        )
    state.team.trace.fault(state.now(), sender, f"{what} cannot be sent to other robots: {reason}")
    return None


def dispatch(
    state: Delivery, way: Way, other: Other, sent: Sent, rules: ChannelInfo | None, key: tuple[str, ...]
) -> None:
    """Send a message to one agent, now or when that is possible. Called with the lock."""
    if sent.what == "data":
        if other.alive and other.knows_us:
            way.sample += 1
            hand_over(state, other, sent, sample=way.sample)
        return
    if other.life is None and sent.what == "state":
        return  # it gets the latest when it comes
    if not other.knows_us:
        lose(state, other.name, [Letter(sent, 0)], UNKNOWN)
        return
    replaces = key if sent.what == "state" else None
    if sent.what == "signal" and not other.alive and not (rules is not None and rules.queued):
        replaces = key
    given_up = way.out.put(Letter(sent, len(sent.payload), replaces))
    for letter in given_up:
        replaced = letter.replaces is not None and letter.replaces == replaces
        lose(state, other.name, [letter], REPLACED if replaced else OVERFLOW)
    pump(state, way, other)


def pump(state: Delivery, way: Way, other: Other) -> None:
    """Send what may be sent. Called with the lock."""
    if not other.alive:
        return
    pump_quietly(state, way, other)
    if way.out.flying:
        state.stir()


def pump_quietly(state: Delivery, way: Way, other: Other) -> None:
    """Send what may be sent to an agent that is there."""
    for place, letter in way.out.ready(time.monotonic_ns()):
        hand_over(state, other, letter.item, place=place)


def hand_over(state: Delivery, other: Other, sent: Sent, place: int = 0, sample: int = 0) -> None:
    """Give something to the link."""
    stamp = Stamp(other.life or 0, place, sample)
    state.link.send(other.name, sent.sender, sent.way, sent.envelope, stamp, sent.payload, place > 0)


def say(
    state: Delivery,
    mine: str,
    name: str,
    way: str,
    envelope: Envelope,
    life: int | None = None,
    payload: bytes = b"",
) -> None:
    """Send something of the post's own, to the incarnation of the other one or to another."""
    stamp = Stamp(state.others[name].life or 0 if life is None else life)
    state.link.send(name, mine, way, envelope, stamp, payload, True)


def acknowledge(state: Delivery, mine: str, name: str, way: Way) -> None:
    """Acknowledge all that has come. Called with the lock."""
    way.owed = 0
    envelope = state.envelope(envelopes.ACKNOWLEDGE, upto=way.into.upto, missing=way.into.missing())
    say(state, mine, name, "ack", envelope)


def acknowledge_all(state: Delivery) -> None:
    """Called with the lock."""
    for (mine, name), way in state.ways.items():
        if way.owed and state.others[name].alive:
            acknowledge(state, mine, name, way)


def ping(state: Delivery, mine: str, other: Other) -> None:
    """Called with the lock."""
    envelope = state.envelope(envelopes.PING)
    state.ways[mine, other.name].asked.append(envelope.time)
    say(state, mine, other.name, "ping", envelope, payload=introduction(state, mine, other))


def introduction(state: Delivery, mine: str, other: Other) -> bytes:
    """What an agent elsewhere needs to send heartbeats to one of ours. Called with the lock."""
    if state.heartbeats is None or other.life is None:
        return b""
    return state.heartbeats.introduction(mine, other.name, other.life)


def hurry(state: Delivery, ways: Iterable[tuple[str, str]]) -> None:
    """A link was broken: what was on its way is sent again at once. Called with the lock."""
    for key in ways:
        state.ways[key].out.hurry()
        pump(state, state.ways[key], state.others[key[1]])
    state.stir()
