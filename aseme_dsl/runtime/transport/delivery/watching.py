"""Watching: which agents elsewhere have become unreachable, and which are reachable again.

With a lease, an agent is unreachable when nothing proves any more that it has heard us within the lease:
neither the answer to a PING nor a heartbeat. Both ends of a link see that, also if it works in one
direction only. A token alone proves nothing: any process may hold a copy of it. A token that is withdrawn
proves nothing either, as long as heartbeats come: the link may have been too slow.
"""

from __future__ import annotations

import time

from aseme_dsl.runtime.transport.delivery.presence import come_back, has_returned, vanished
from aseme_dsl.runtime.transport.delivery.reports import meet_stranger
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.heartbeats.heartbeats import Heartbeats
from aseme_dsl.runtime.transport.link import NOBODY

DOUBT = 4
"""An agent whose token was withdrawn is unreachable after this part of a lease without a heartbeat."""


def listen(state: Delivery) -> None:
    """Listen for heartbeats, if the link has addresses for them. Raises TransportError if that cannot be."""
    addresses = state.link.datagrams
    if state.lease is None or not addresses:
        return

    def heard(name: str, life: int, moment: int) -> None:
        other = state.others[name]
        if other.life == life:
            other.beats, other.heard_at = True, max(other.heard_at, moment)
            if not other.alive:
                state.watching.set()

    def parted(name: str, life: int) -> None:
        other = state.others[name]
        if other.life == life:
            other.parted = True
            state.watching.set()

    state.heartbeats = Heartbeats(addresses, state.lease, heard, parted)


def watch_over(state: Delivery) -> None:
    """Look after heartbeats until the delivery closes. Runs in a thread of its own."""
    assert state.heartbeats is not None
    while not state.closing:
        state.watching.wait(state.heartbeats.period / 1e9)
        state.watching.clear()
        watch(state)
        if state.heartbeats.refused > state.refused:
            with state.lock:
                state.strange += state.heartbeats.refused - state.refused - 1
                state.refused = state.heartbeats.refused
                meet_stranger(state, NOBODY)


def departed(state: Delivery, agent: str, incarnation: int) -> None:
    """The link says that an agent is not there any more. Called without the lock."""
    with state.lock:
        other = state.others.get(agent)
        if (
            state.heartbeats is not None
            and other is not None
            and other.life == incarnation
            and other.alive
            and other.beats
        ):
            other.present.discard(incarnation)
            other.doubted_at = other.doubted_at or time.monotonic_ns()
            state.heartbeats.ask(agent, True, hurried=True)
            state.watching.set()
            return
    vanished(state, agent, incarnation)


def watch(state: Delivery) -> None:
    """Tell which agents have become unreachable, and which are reachable again. Called without the lock."""
    if state.lease is None:
        return
    now = time.monotonic_ns()
    missed, state.watched_at = now - (state.watched_at or now), now
    for other in state.others.values():
        life = other.life
        if life is None:
            continue
        if missed > state.lease // 2:  # we were suspended: meanwhile no agent could prove anything
            other.heard_at += missed
        if has_returned(state, other):
            with state.lock:
                comes = has_returned(state, other) and other.life == life and not state.closing
                if comes:
                    come_back(state, other)
            if comes:
                state.team.conversations.appeared(other.name, life)
        elif not other.alive:
            continue
        elif other.heard_at < now - state.lease:
            vanished(state, other.name, life, "timed_out")
        elif other.doubted_at:
            _doubt(state, other.name, life, now)


def _doubt(state: Delivery, name: str, life: int, now: int) -> None:
    other = state.others[name]
    assert state.lease is not None and state.heartbeats is not None
    if other.parted or (other.heard_at < other.doubted_at < now - state.lease // DOUBT):
        vanished(state, name, life)
    elif other.heard_at >= other.doubted_at:
        other.doubted_at = 0
        state.heartbeats.ask(name, False)
