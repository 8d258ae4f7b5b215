"""Reports: what is counted and traced of agents elsewhere."""

from __future__ import annotations

import time
from collections.abc import Iterable

from aseme_dsl.runtime.transport.delivery.records import Losses, Other, Sent
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.stream import WAITING, Letter

OVERFLOW = "too many messages wait for it"
SUMMARY = 1_000_000_000
"""The number of lost signals is recorded at most once in so many ns."""
LONGEST_NAME = 100
"""The trace has at most so many characters of a name that an untrusted sender gives."""


def count(state: Delivery, other: Other, what: str, reason: str, about: str = "") -> None:
    """Count a fault of a received message, and record the first one of its kind in the trace."""
    other.counts[what] = other.counts.get(what, 0) + 1
    tell_once(state, other, what, reason, about)


def tell_once(state: Delivery, other: Other, what: str, reason: str, about: str = "") -> None:
    """Trace something of an agent elsewhere, the first time that it happens."""
    if (what, about) not in other.told and len(other.told) < 1000:
        other.told.add((what, about))
        tell(state, other, what, reason=reason)


def tell(state: Delivery, other: Other, what: str, **members: object) -> None:
    """Trace what has become of an agent elsewhere."""
    mine = state.mine
    now = state.now()
    state.team.trace.write("peer", now, agent=mine, peer=other.name, what=what, **members)


def tell_own(state: Delivery, agent: str, what: str, reason: str) -> None:
    """Trace what has become of the connection of one of our agents."""
    now = state.now()
    state.team.trace.write("peer", now, agent=agent, peer=agent, what=what, reason=reason)


def lose(state: Delivery, name: str, letters: Iterable[Letter[Sent]], reason: str) -> None:
    """Tell what will not be brought to an agent. A state that a newer one replaces is none of it.

    Of the signals of one channel, which may be many, the first is recorded, then their number. Called
    with the lock.
    """
    other = state.others[name]
    for letter in letters:
        sent = letter.item
        if sent.what in ("state", "data", "contract", "refused"):
            continue
        other.counts["lost"] = other.counts.get("lost", 0) + 1
        key = (sent.sender, name, sent.envelope.channel, reason)
        losses = state.losses.get(key)
        if losses is None:
            state.losses[key] = Losses(sent, time.monotonic_ns())
            if reason == OVERFLOW:
                what = sent.envelope.channel or "agent messages"
                text = f"{WAITING} messages wait for {name}: of {what}, the oldest are dropped"
                state.team.trace.fault(state.now(), sent.sender, text)
        if losses is None or sent.what != "signal":
            _tell_lost(state, name, sent, reason)
        else:
            losses.latest, losses.number = sent, losses.number + 1
            state.stir()


def tell_losses(state: Delivery, pause: int = SUMMARY) -> bool:
    """Tell how many signals were lost since it was told last; whether some are left. Called with the lock."""
    now = time.monotonic_ns()
    left = False
    for (_, name, _, reason), losses in state.losses.items():
        if losses.number and now - losses.told >= pause:
            _tell_lost(state, name, losses.latest, reason, losses.number)
            losses.told, losses.number = now, 0
        left = left or losses.number > 0
    return left


def _tell_lost(state: Delivery, name: str, sent: Sent, reason: str, number: int = 1) -> None:
    envelope = sent.envelope
    state.team.trace.write(
        "lost",
        state.now(),
        agent=sent.sender,
        input=list(sent.identity),
        peer=name,
        channel=envelope.channel or None,
        conversation=envelope.conversation or None,
        reason=reason,
        number=number if number > 1 else None,
    )


def meet_stranger(state: Delivery, name: str, what: str = "untrusted") -> None:
    """Record a sender that uses the team's name on the network and is not known, once for each `name`."""
    state.strange += 1
    name = name[:LONGEST_NAME]
    if name in state.strangers or len(state.strangers) > 100:
        return
    state.strangers[name] = 0
    now = state.now()
    state.team.trace.write("peer", now, agent=state.mine, peer=name, what=what)
