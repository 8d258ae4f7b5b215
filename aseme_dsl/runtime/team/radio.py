"""Radio: channels whose messages travel as a few bytes through the robots' bodies, and may get lost there.

A message begins with one byte: its channel's number, and for a message to one robot that robot's place in
the team as well. Both follow from the document, so that all robots of one build agree.

What the radio refuses because of its rate is sent later. Of states, signals and data that is the newest; of
signals of a topic that is `queued` it is each one.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING

from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.time.clock import MILLISECOND
from aseme_dsl.runtime.world.body import BodyConnectionError

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent.agent import Agent
    from aseme_dsl.runtime.channel.bus import Bus
    from aseme_dsl.runtime.message.wire import Schema

LISTEN = 10 * MILLISECOND
"""How often a robot without a simulated world listens."""
KINDS = 256


class Radio:
    """One robot's end of the radio."""

    def __init__(
        self,
        agent: Agent,
        bus: Bus,
        schema: Schema,
        team: Sequence[str],
    ) -> None:
        self._agent = agent
        self._bus = bus
        self._schema = schema
        self._team = list(team)
        self._rules = {info.name: info for info in agent.plan.channels}
        self._waiting: list[tuple[str, str | None, object, Identity]] = []
        self._every = LISTEN
        self._lost = False
        self._lock = threading.RLock()
        """Held while something is said: by who publishes, and by the timer that says what was refused."""

    def renew(self, schema: Schema) -> None:
        """The agent follows another plan: say and hear its channels, with the numbers of this schema."""
        with self._lock:
            self._schema = schema
            self._rules = {info.name: info for info in self._agent.plan.channels}
            for entry in [entry for entry in self._waiting if entry[0] not in self._rules]:
                self._waiting.remove(entry)
                self._tell("radio_failed", entry[0], entry[2], entry[3], "its channel is not in the new plan")

    def begin(self, step: int | None) -> None:
        """Listen from now on: after every step of the world, which lasts `step` ns."""
        self._every = step or LISTEN
        self._next()

    def _next(self) -> None:
        driver = self._agent.driver
        now = driver.clock.now()
        driver.at(now - now % self._every + self._every, self._tick, background=True)

    def _tick(self) -> None:
        if self._lost or self._agent.over:
            return
        body = self._agent.body
        assert body is not None
        try:
            heard = body.hear()
            with self._lock:
                self._say_waiting()
        except BodyConnectionError as error:
            self._lose(error)
            return
        for item in heard:
            self._hear(item.sender, item.payload)
        self._next()

    # ---- sending -----------------------------------------------------------------------------

    def send(self, channel: str, message: object, host: str | None, identity: Identity) -> None:
        """Say a message, now or as soon as the radio takes it."""
        with self._lock:
            if self._lost:
                self._tell("radio_failed", channel, message, identity, "the body is lost")
                return
            self._wait(channel, message, host, identity)
            try:
                self._say_waiting()
            except BodyConnectionError as error:
                self._lose(error)
                return
            if self._waiting and self._waiting[-1][3] == identity:
                self._tell("delayed", channel, message, identity, "the radio takes no more at the moment")

    def _wait(self, channel: str, message: object, host: str | None, identity: Identity) -> None:
        """Put a message at the end of those to be said; it replaces one of its kind that waits."""
        queued = channel.split(".", 2)[1] == "signal" and self._rules[channel].queued
        if not queued:
            for place, (other, to, old, old_identity) in enumerate(self._waiting):
                if (other, to) == (channel, host):
                    del self._waiting[place]
                    self._tell("replaced", channel, old, old_identity, "a newer one came before it was said")
                    break
        self._waiting.append((channel, host, message, identity))

    def _say_waiting(self) -> None:
        """Say what waits, in order, until the radio takes no more."""
        body = self._agent.body
        assert body is not None
        while self._waiting:
            channel, host, message, identity = self._waiting[0]
            try:
                payload = self._packed(channel, host, message)
                taken = body.say(payload)
            except ValueError as error:
                self._tell("radio_failed", channel, message, identity, str(error))
                taken = True
            if not taken:
                return
            self._waiting.pop(0)

    def _packed(self, channel: str, host: str | None, message: object) -> bytes:
        payload = self._schema.pack(channel, self._agent.understood(message))
        place = 0 if host is None else self._team.index(host) + 1
        number = place * len(self._schema.radio) + payload[0]
        if number >= KINDS:
            size = f"{len(self._schema.radio)} radio channels and a team of {len(self._team)}"
            raise ValueError(f"{size} are too many to name in one byte")
        return bytes([number]) + payload[1:]

    # ---- hearing -----------------------------------------------------------------------------

    def _hear(self, sender: str, payload: bytes) -> None:
        agent = self._agent
        place, number = divmod(payload[0], len(self._schema.radio)) if payload else (0, 0)
        try:
            if place > len(self._team):
                raise ValueError("it is for a robot that is not in the team")
            channel, message = self._schema.unpack(bytes([number]) + payload[1:])
        except ValueError as error:
            text = f"a radio message from {sender or 'somebody'} cannot be read: {error} ({payload.hex(' ')})"
            agent.trace.fault(agent.driver.clock.now(), agent.name, text)
            return
        if place == 0 or self._team[place - 1] == agent.name:
            self._bus.heard(agent, channel, message, sender)

    # ---- the trace ---------------------------------------------------------------------------

    def _lose(self, error: BodyConnectionError) -> None:
        with self._lock:
            if self._lost:
                return
            self._lost = True
            agent = self._agent
            agent.trace.fault(
                agent.driver.clock.now(), agent.name, f"the radio is silent: BodyConnectionError: {error}"
            )
            for channel, _, message, identity in self._waiting:
                self._tell("radio_failed", channel, message, identity, "the body is lost")
            self._waiting.clear()

    def _tell(self, kind: str, channel: str, message: object, identity: Identity, reason: str) -> None:
        agent = self._agent
        if agent.trace.active:
            agent.trace.write(
                kind,
                agent.driver.clock.now(),
                agent=agent.name,
                input=list(identity),
                channel=channel,
                message=to_json(message),
                reason=reason,
            )
