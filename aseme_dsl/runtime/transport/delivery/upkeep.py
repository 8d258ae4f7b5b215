"""Upkeep: the thread that acknowledges, sends again, measures clocks and notices silence."""

from __future__ import annotations

import time

from aseme_dsl.runtime.transport.delivery.builds import compare, tell_numbers
from aseme_dsl.runtime.transport.delivery.presence import PINGS, knock
from aseme_dsl.runtime.transport.delivery.records import QUESTIONS, Other
from aseme_dsl.runtime.transport.delivery.reports import tell_losses
from aseme_dsl.runtime.transport.delivery.sending import (
    acknowledge,
    hand_over,
    ping,
    pump_quietly,
)
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.delivery.watching import watch

BEAT = 0.02
"""How often, in seconds, acknowledgements are sent and what is overdue is looked for."""
STALLED = 2
"""A link over which nothing comes for so many leases, although heartbeats do, is renewed."""
ASK_AGAIN = 5_000_000_000
"""How often, in ns, another machine's clock is measured again."""


def keep_up(state: Delivery) -> None:
    """Look after all that is on its way, until the delivery closes. Runs in a thread of its own."""
    while True:
        with state.lock:
            if state.closing:
                return
            try:
                busy = look_after(state)
            except Exception as problem:  # without this thread nothing would be sent again
                now = state.now()
                reason = f"the transport failed: {type(problem).__name__}: {problem}"
                state.team.trace.remark(now, state.mine, reason)
                busy = True
            if busy:
                state.rest.wait(BEAT)
            else:
                state.resting = True
                state.rest.wait(1.0 if state.lease is None else min(1.0, state.lease / PINGS / 1e9))
                if state.resting:
                    state.resting = False
                else:
                    # What was just sent or came is looked after in a moment, not while it is answered.
                    state.rest.wait(BEAT)
            stalled = [] if state.heartbeats is None else _stalled(state)
        if state.heartbeats is None:
            watch(state)
        for name, again in stalled:
            state.link.renew(name, again)


def _stalled(state: Delivery) -> list[tuple[str, bool]]:
    """The agents whose heartbeats come, but nothing over the link although they are asked.

    Each with whether nothing has come since the link was renewed. Called with the lock.
    """
    assert state.lease is not None
    now = time.monotonic_ns()
    before = now - STALLED * state.lease
    found = [one for one in state.others.values() if one.alive and one.beats and one.linked_at < before]
    stalled = [(other.name, other.linked_at == other.renewed_at) for other in found]
    for other in found:
        other.linked_at = other.renewed_at = now
    return stalled


def look_after(state: Delivery) -> bool:
    """Acknowledge, send again, measure clocks; whether that will soon be needed again."""
    busy = tell_losses(state)
    now = time.monotonic_ns()
    for (mine, name), way in state.ways.items():
        other = state.others[name]
        if way.owed and now - way.owed_since >= state.delay:
            acknowledge(state, mine, name, way)
        busy = busy or way.owed > 0
        few = other.alive and other.clock != state.clock and len(other.measured) < QUESTIONS
        if now >= other.ask_at and is_asked(state, other):
            pause = ASK_AGAIN if state.lease is None else min(ASK_AGAIN, state.lease // PINGS)
            other.ask_at = now + (50_000_000 if few else pause)
            if other.life is not None:
                ping(state, mine, other)
            if state.lease is not None:
                knock(state, other)
        busy = busy or few
        if not other.alive:
            continue
        for place, letter in way.out.overdue(now):
            hand_over(state, other, letter.item, place=place)
        busy = tell_numbers(state, other, now) or busy
        busy = compare(state, other, now) or busy
        pump_quietly(state, way, other)
        busy = busy or way.out.flying > 0
    return busy


def is_asked(state: Delivery, other: Other) -> bool:
    """Whether another agent is sent PINGs: for its clock, or to prove that it is there."""
    if state.lease is not None:
        return (other.life is not None or bool(other.present)) and state.gate.is_set()
    return other.alive and other.clock != state.clock
