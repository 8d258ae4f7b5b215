"""Presence: which agents elsewhere are reachable, and which incarnation each of them is."""

from __future__ import annotations

import threading
import time

from aseme_dsl.runtime.chart.inputs import Reason
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.builds import contract_letters
from aseme_dsl.runtime.transport.delivery.records import Other
from aseme_dsl.runtime.transport.delivery.reports import count, lose, meet_stranger, tell
from aseme_dsl.runtime.transport.delivery.sending import (
    hurry,
    ping,
    pump,
    say,
)
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.stream import Incoming, Letter, Samples

MOST_HOPED = 4
"""So many incarnations of an agent are asked whether they are there."""
TWIN_SECONDS = 2.0
"""How long a newer incarnation of an agent may take to answer, and after how long it is asked again."""
MOST_TWINS = 16
"""So many newer incarnations of our own agents are remembered."""
OUTLIVED = 2
"""Whom others follow so many leases after its end, they take for ours."""
PINGS = 4
"""So many PINGs in each lease."""


def appeared(state: Delivery, agent: str, incarnation: int) -> None:
    """An agent elsewhere is there now."""
    state.gate.wait()
    if agent in state.here:
        if incarnation > state.incarnation:
            if state.lease is None:
                replaced(state, agent)
            elif incarnation not in state.twins:
                state.twins.add(incarnation)
                threading.Thread(
                    target=ask_twin, args=(state, agent, incarnation), name="aseme twin", daemon=True
                ).start()
        return
    if state.lease is None:
        end_before(state, agent, incarnation)
    with state.lock:
        other = state.others.get(agent)
        if other is None:
            meet_stranger(state, agent, "unknown")
            return
        other.present.add(incarnation)
        if incarnation != other.life and is_next(state, other, incarnation):
            if state.lease is None:
                begin_life(state, other, incarnation)
            else:
                knock(state, other)
                state.stir()
        elif incarnation == other.life:
            if other.alive:
                hurry(state, [key for key in state.ways if key[1] == agent])
            elif state.lease is None:
                come_back(state, other)
            else:
                ping(state, state.mine, other)
    if other.alive:
        state.team.conversations.appeared(agent, other.life)


def replaced(state: Delivery, agent: str) -> None:
    """One of our agents is played by a newer process: this one stops."""
    now = state.now()
    state.team.trace.write("peer", now, agent=agent, peer=agent, what="replaced")
    state.team.driver.stop("replaced")


def outlive(state: Delivery, life: int) -> None:
    """Stop if others still follow a newer incarnation of ours that has ended: they hear this one no more.

    Only its own certificate can have made its token, so no other agent can stop us. Called with the lock.
    """
    since = state.past_twins.get(life)
    if since is None or state.lease is None or time.monotonic_ns() - since < OUTLIVED * state.lease:
        return
    state.past_twins.clear()
    now = state.now()
    state.team.trace.write("peer", now, agent=state.mine, peer=state.mine, what="outlived")
    state.team.driver.stop("outlived")


def ask_twin(state: Delivery, agent: str, life: int) -> None:
    """Stop if a newer incarnation of one of our agents answers, as long as something reports it."""
    while not state.closing and life in state.twins:
        if state.link.ask(agent, "history", b"{}", TWIN_SECONDS, life):
            replaced(state, agent)
            return
        time.sleep(TWIN_SECONDS)


def has_returned(state: Delivery, other: Other) -> bool:
    """Whether an agent that was unreachable has heard us since. Called with the lock."""
    return not other.alive and state.lease is not None and other.heard_at > other.gone_at * 1e9


def come_back(state: Delivery, other: Other) -> None:
    """An agent that was unreachable is the same incarnation still. Called with the lock."""
    other.alive, other.doubted_at, other.linked_at = True, 0, time.monotonic_ns()
    if state.heartbeats is not None:
        state.heartbeats.ask(other.name, False)
    tell(state, other, "reconnected")
    hurry(state, [key for key in state.ways if key[1] == other.name])


def end_before(state: Delivery, agent: str, life: int) -> None:
    """Treat the earlier incarnation of an agent as lost: an agent has only one at a time.

    Called without the lock, since it notifies the conversations.
    """
    other = state.others.get(agent)
    if other is None or not other.alive or other.life is None:
        return
    if life > other.life and life not in other.ended:
        vanished(state, agent, other.life)


def vanished(state: Delivery, agent: str, incarnation: int, reason: Reason = "crashed") -> None:
    """An agent elsewhere is not there any more, for a reason."""
    state.gate.wait()
    if agent in state.here and incarnation in state.twins:
        state.twins.discard(incarnation)
        state.past_twins[incarnation] = time.monotonic_ns()
        while len(state.past_twins) > MOST_TWINS:
            del state.past_twins[next(iter(state.past_twins))]
    with state.lock:
        other = state.others.get(agent)
        if other is None or state.closing:
            return
        other.present.discard(incarnation)
        if state.lease is not None and other.life == incarnation:
            other.ended.add(incarnation)
        if other.life != incarnation or not other.alive:
            return
        other.alive, other.gone_at, other.doubted_at = False, time.monotonic(), 0
        if state.heartbeats is not None:
            state.heartbeats.ask(agent, True)
        tell(state, other, "gone")
    state.team.conversations.vanished(agent, reason)
    with state.lock:
        others = other.present - other.ended
        if other.alive or not others:
            return
        if state.lease is not None:
            knock(state, other)
            return
        begin_life(state, other, max(others))
    state.team.conversations.appeared(agent, other.life)


def begin_life(state: Delivery, other: Other, life: int) -> None:
    """An agent is there for the first time, or again after it had ended. Called with the lock."""
    first = other.life is None
    other.life, other.alive, other.clock = life, True, None
    other.measured.clear()
    other.is_timed = False
    other.heard_at = other.linked_at = time.monotonic_ns()
    other.ask_at = 0
    other.beats, other.doubted_at, other.parted = False, 0, False
    other.contracts.clear()
    other.readings.clear()
    other.unread.clear()
    other.model, other.incompatible, other.said, other.compare_at = "", (), "", 0
    other.knows_us = True
    tell(state, other, "connected" if first else "restarted")
    for (mine, name), way in state.ways.items():
        if name != other.name:
            continue
        flying, waiting = way.out.restart()
        lose(state, name, flying, "it ended while this was on its way")
        way.into, way.samples, way.owed, way.sample = Incoming(), Samples(), 0, 0
        way.pinged = 0  # what was asked stays: the answer may be how this incarnation began
        for letter in contract_letters(state, mine):
            way.out.put(letter)
        for kept in state.archive.news_for(mine, name):
            way.out.put(Letter(kept.sent, len(kept.sent.payload), kept.replaces))
        for letter in waiting:
            if letter.item.what not in ("state", "contract", "refused"):
                way.out.put(Letter(letter.item, letter.size))
        pump(state, way, other)
    state.stir()


def hoped(state: Delivery, other: Other) -> list[int]:
    """The incarnations of an agent that may be its next one, and have said nothing to us yet."""
    found = [life for life in other.present if life != other.life and is_next(state, other, life)]
    return sorted(found)[-MOST_HOPED:]


def knock(state: Delivery, other: Other) -> None:
    """Have incarnations say themselves that they are there: tokens may be copies. Called with the lock."""
    mine = state.mine
    for life in hoped(state, other):
        envelope = state.envelope(envelopes.PING)
        state.ways[mine, other.name].asked.append(envelope.time)
        say(state, mine, other.name, "ping", envelope, life)


def is_next(state: Delivery, other: Other, life: int) -> bool:
    """Whether this incarnation comes after the one that is known.

    A robot whose clock was set back begins one with a lower number: it counts when the other has ended.
    """
    if life in other.ended:
        return False
    return other.life is None or life > other.life or (not other.alive and life in other.present)


def is_fresh(state: Delivery, envelope: Envelope) -> bool:
    """Whether an envelope was made for this incarnation of ours: a replayed one may be for an earlier."""
    return envelope.addressee == state.incarnation or (state.lease is None and envelope.addressee == 0)


def is_current(state: Delivery, other: Other, envelope: Envelope) -> bool:
    """Whether an envelope is from the incarnation of its sender, and for ours. Called with the lock."""
    life = envelope.incarnation
    if life != other.life and not is_next(state, other, life):
        count(state, other, "late", "it is of an earlier incarnation of its sender")
        return False
    if not is_fresh(state, envelope):
        outlive(state, envelope.addressee)
        if envelope.kind == envelopes.PING:  # a search for another incarnation of ours does not concern us
            other.counts["late"] = other.counts.get("late", 0) + 1
        else:
            count(state, other, "late", "it is for an earlier incarnation of its receiver")
        return False
    if life != other.life:
        begin_life(state, other, life)
    return True
