"""Inbox: what a link tells us: envelopes, who is there, and questions."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable, Mapping

from aseme_dsl import outside
from aseme_dsl.runtime.message.acl import FipaMessage
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.presence import (
    appeared,
    end_before,
    is_current,
    is_fresh,
)
from aseme_dsl.runtime.transport.delivery.receiving import (
    accepted,
    hand_on,
    sender_of,
)
from aseme_dsl.runtime.transport.delivery.reports import count, tell_own
from aseme_dsl.runtime.transport.delivery.sending import (
    hurry,
)
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.delivery.watching import departed
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.port import Answer


class Inbox:
    """What hears a link for the agents of this process."""

    def __init__(self, state: Delivery) -> None:
        self._state = state
        self.answer: Answer | None = None
        """What answers control requests."""
        self.epoch: Callable[[], Mapping[str, object]] | None = None
        """What says which epoch the agents here follow."""

    def arrived(self, to: str, sender: str, envelope: Envelope, payload: bytes) -> None:
        """Something has come for one of our agents."""
        if not self._state.gate.is_set():
            self._state.gate.wait()
        came = time.monotonic_ns()
        if is_fresh(self._state, envelope):
            end_before(self._state, sender, envelope.incarnation)
        with self._state.lock:
            other = sender_of(self._state, to, sender, envelope)
            if other is None:
                return
            life, alive, knows = other.life, other.alive, other.knows_us
            if not is_current(self._state, other, envelope):
                return
            other.linked_at, other.clock = came, envelope.clock
            ready = accepted(self._state, to, other, envelope, payload, came)
            comes = other.alive and (not alive or other.life != life)
            turns_away = knows and not other.knows_us
        if comes:
            self._state.team.conversations.appeared(sender, other.life)
        if turns_away:
            self._state.team.conversations.vanished(sender, "incompatible")
        for item in ready:
            if item is not None:
                hand_on(self._state, to, other, *item)

    def unreadable(self, to: str, sender: str, reason: str) -> None:
        """Count a message for one of our agents that has no valid envelope, or one that does not fit it."""
        self._state.gate.wait()
        with self._state.lock:
            other = sender_of(self._state, to, sender)
            if other is not None:
                count(self._state, other, "unreadable", reason)

    def outside(self, to: str, message: FipaMessage) -> None:
        """Hand on a message from an external agent to one of our agents."""
        self._state.gate.wait()
        if self._state.closing or to not in self._state.here:
            return
        try:
            self._state.team.conversations.receive_external(to, message)
        except Exception as problem:  # no caller on the link's thread would report it
            sender = message.sender.name if message.sender is not None else "somebody"
            reason = f"what {sender} said could not be taken: {type(problem).__name__}: {problem}"
            self._state.team.trace.fault(self._state.now(), to, reason)

    def appeared(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is there now."""
        appeared(self._state, agent, incarnation)

    def vanished(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is not there any more."""
        departed(self._state, agent, incarnation)

    def returned(self, agent: str, to: str, name: str, reason: str) -> None:
        """What one of our agents sent to an external agent was not delivered; `name` is its `reply-with`."""
        text = f"{name or 'a message'} could not be brought to {to}: {reason}"
        self._state.team.trace.fault(self._state.now(), agent, text)
        self._state.team.conversations.vanished(to)

    def disconnected(self, agent: str, reason: str) -> None:
        """One of our agents has lost its connection, which is made again."""
        tell_own(self._state, agent, "disconnected", reason)

    def connected(self, agent: str, reason: str) -> None:
        """It has a connection again."""
        tell_own(self._state, agent, "connected", reason)
        with self._state.lock:
            hurry(self._state, [key for key in self._state.ways if key[0] == agent])

    def fault(self, agent: str, reason: str) -> None:
        """Something could not be done for one of our agents."""
        self._state.team.trace.remark(self._state.now(), agent, reason)

    def asked(self, to: str, what: str, question: bytes) -> Iterable[tuple[Envelope, bytes]]:
        """A question to one of our agents; the answers."""
        if what == "control":
            if self.answer is None:
                return [_json_answer(self._state, {"error": f"{to} takes no control requests"})]
            return [_json_answer(self._state, self.answer(to, question))]
        try:
            request = outside.loads(question)
            if not isinstance(request, dict):
                raise ValueError("a JSON object is wanted")
        except ValueError as problem:
            return [_json_answer(self._state, {"error": f"the question cannot be read: {problem}"})]
        if what == "history" and "epoch" in request:
            return [_json_answer(self._state, {} if self.epoch is None else {"epoch": self.epoch()})]
        if what == "history":
            return _history_of(self._state, to, request)
        return []


def _json_answer(state: Delivery, answer: Mapping[str, object], further: int = 0) -> tuple[Envelope, bytes]:
    """The first piece of an answer, after which `further` ones come."""
    return state.envelope(envelopes.ACKNOWLEDGE, upto=1 + further), json.dumps(answer).encode()


def _history_of(state: Delivery, mine: str, request: dict[str, object]) -> list[tuple[Envelope, bytes]]:
    channel, since, until = request.get("channel"), request.get("since"), request.get("until")
    if not isinstance(channel, str) or not isinstance(since, int) or not isinstance(until, int):
        return [_json_answer(state, {})]
    with state.lock:
        samples = list(state.archive.samples.get((mine, channel), ()))
    found = [
        (kept.sent.envelope, kept.sent.payload)
        for kept in samples
        if since <= kept.sent.envelope.time <= until
    ]
    # The first piece shows that the agent is reachable, even if it has no data.
    return [_json_answer(state, {}, len(found)), *found]
