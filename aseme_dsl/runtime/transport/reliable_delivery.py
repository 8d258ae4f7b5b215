"""Post: the transport of a team whose agents run in several processes.

Signals, states and agent messages go in a stream from each agent to each other one (`stream`): none is
lost, doubled or overtaken while both live, also if the link between them breaks and comes back. Data is sent
once, and what is dropped on the way is counted. Whoever comes is told the latest states of everybody that
concern it, and the data that its program still asks for. What is meant for an agent that is not there waits
for it: agent messages and queued signals in order, of other signals the newest, as on the board of an agent
that does not look. What was on its way to an agent when it died is lost, and told so in the trace.

Times are those of the machine's monotonic clock, which all processes of one machine share. Of another
machine's the difference is measured, as in NTP (RFC 5905, section 8), by the quickest of the last few
questions and answers.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import threading
import time
import zlib
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from aseme_dsl import outside
from aseme_dsl.runtime.chart.inputs import Identity
from aseme_dsl.runtime.message.acl import JSON, AclMessage, AgentIdentifier, FipaMessage, name_of
from aseme_dsl.runtime.message.wire import Schema, WireError
from aseme_dsl.runtime.time.clock import RealClock
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import NOBODY, Link, Stamp
from aseme_dsl.runtime.transport.port import Answer, Connected, Peer, Transport, TransportError
from aseme_dsl.runtime.transport.stream import Incoming, Letter, Outgoing, Samples

if TYPE_CHECKING:
    from aseme_dsl.runtime.chart.plan import ChannelInfo
    from aseme_dsl.runtime.ports import Receiver

BEAT = 0.02
"""How often, in seconds, acknowledgements are sent and what is overdue is looked for."""
OWED = 64
"""After so many letters an acknowledgement is sent at once."""
SOON = 33_000_000
"""An acknowledgement is not put off where it would be by less than so many ns: the beat puts it off, too."""
LAST_WORDS = 0.3
"""How long, in seconds, what is on its way may take to arrive when a robot ends; on slower links longer."""
MOST_WORDS = 10
"""So many times as long as that is waited at the most, as long as something still arrives."""
SAMPLES = 4096
"""How much data of each channel is kept for those who ask for it."""
MOST_HOPED = 4
"""So many lives of an agent are asked whether they are there."""
TWIN_SECONDS = 2.0
"""How long a newer life of an agent may take to answer, and after how long it is asked again."""
QUESTIONS = 8
"""Of so many measurements of another clock the quickest counts."""
ASK_AGAIN = 5_000_000_000
"""How often, in ns, another machine's clock is measured again."""
LONGEST_NAME = 100
"""So many characters of what somebody else has named are told."""
PINGS = 4
"""So many PINGs in each lease; who answers none of so many is gone."""


@dataclass(frozen=True, slots=True)
class _Sent:
    """What a letter is about: enough to send it, and to tell of it if it is lost."""

    way: str
    envelope: Envelope
    payload: bytes
    sender: str
    what: str
    """signal, state, data or mail."""

    @property
    def identity(self) -> Identity:
        return self.sender, self.envelope.sequence


_Got = tuple[Envelope, bytes]
"""What has come, with its payload."""


@dataclass(slots=True)
class _Way:
    """Between one of our agents and one elsewhere."""

    out: Outgoing[_Sent] = field(default_factory=Outgoing)
    into: Incoming[_Got] = field(default_factory=Incoming)
    owed: int = 0
    """How many letters have come since the last acknowledgement."""
    owed_since: int = 0
    """When the first of them came, in ns."""
    sample: int = 0
    """The number of the last sample that was sent."""
    samples: Samples = field(default_factory=Samples)
    """Those that came."""
    pinged: int = 0
    """The time of the newest PING that came, in the sender's clock."""
    asked: deque[int] = field(default_factory=lambda: deque(maxlen=16))
    """The times of our PINGs that have no answer yet."""


@dataclass(slots=True)
class _Other:
    """An agent elsewhere: which life it leads, and what came from it."""

    name: str
    alive: bool = False
    life: int | None = None
    present: set[int] = field(default_factory=set)
    """The lives that say that they are there; there may be two for a while."""
    ended: set[int] = field(default_factory=set)
    """The lives that were gone: where links have a lease, only the answer to a PING brings one back."""
    unanswered: int = 0
    """How many PINGs were sent since the last answer."""
    answered_at: int = 0
    """When that came, in ns."""
    gone_at: float = -math.inf
    """When it was told last that it is not there any more, in seconds."""
    clock: int | None = None
    measured: deque[tuple[int, int]] = field(default_factory=lambda: deque(maxlen=QUESTIONS))
    """(round trip, difference) of the last measurements of its clock."""
    ask_at: int = 0
    counts: dict[str, int] = field(default_factory=dict)
    told: set[tuple[str, str]] = field(default_factory=set)


@dataclass(frozen=True, slots=True)
class _Kept:
    """A state or a sample that is kept for those who come later."""

    sent: _Sent
    to: tuple[str, ...]
    replaces: tuple[str, ...] | None


class Post(Transport):
    """The transport of one process of a team that runs in several. Used by one team, once."""

    networked = True

    def __init__(self, link: Link, schema: Schema, model: str) -> None:
        """`model` is the MODEL of the generated package; messages of another one are refused."""
        self.model = model
        self.incarnation = time.time_ns()
        self.life = f"{self.incarnation:x}-"
        # In microseconds: no life has more identities than that, and they stay exact as JSON numbers.
        self.behind = self.incarnation // 1000
        self._link = link
        self._readable = link.readable
        self._delay = max(0, link.patience // 3 - SOON)
        """How long an acknowledgement waits for others, in ns."""
        self._lease = link.lease
        self._schema = schema
        self._clock = clock_identity()
        self._team: Connected
        self._here: dict[str, Receiver] = {}
        self._others: dict[str, _Other] = {}
        self._ways: dict[tuple[str, str], _Way] = {}
        self._states: dict[tuple[str, str, str], _Kept] = {}
        self._samples: dict[tuple[str, str], deque[_Kept]] = {}
        self._retention: dict[str, int] = {}
        self._origin = 0
        self._answer: Answer | None = None
        self._lock = threading.RLock()
        self._rest = threading.Condition(self._lock)
        self._resting = False
        self._closing = False
        self._strangers: set[str] = set()
        self._strange = 0
        """How much has come from strangers, and from nobody who says a name."""
        self._twins: set[int] = set()
        """Newer lives of our own agents of which something says that they are there."""
        self._thread: threading.Thread | None = None
        self._gate = threading.Event()

    # ---- the transport -----------------------------------------------------------------------

    def begin(self, team: Connected) -> None:
        self._team = team
        self._here = {agent.name: agent for agent in team.agents}
        self._others = {name: _Other(name) for name in team.elsewhere}
        patience = self._link.patience
        self._ways = {
            (mine, other): _Way(Outgoing(patience)) for mine in self._here for other in self._others
        }
        clock = team.driver.clock
        assert isinstance(clock, RealClock)  # the team has seen to that
        self._origin = clock.origin
        for plan in (*team.elsewhere.values(), *(agent.plan for agent in team.agents)):
            for info in plan.channels:
                self._retention[info.name] = max(info.retention, self._retention.get(info.name, 0))
        self._link.open(tuple(self._here), self.incarnation, self)
        self._thread = threading.Thread(target=self._beat, name="aseme transport", daemon=True)
        self._thread.start()

    def go(self) -> None:
        self._gate.set()

    def close(self) -> None:
        if self._thread is None:
            return
        self._gate.set()
        with self._lock:
            self._acknowledge_all()
            if self._delay:
                for (mine, name), way in self._ways.items():
                    if way.out.flying and self._others[name].alive:  # the answer comes after acknowledgements
                        self._ping(mine, self._others[name])
        self._wait_for_last_words()
        with self._lock:
            self._closing = True
            self._rest.notify()
            self._acknowledge_all()
        self._thread.join()
        self._link.close()
        with self._lock:
            for (_, name), way in self._ways.items():
                flying, waiting = way.out.restart()
                self._lose(name, (*flying, *waiting), "the run ended before it could be brought")
            for other in self._others.values():
                if other.life is not None or other.counts:
                    self._tell(other, "count", counts=dict(sorted(other.counts.items())) or None)
            if self._strange:
                self._tell(_Other(NOBODY), "count", counts={"refused": self._strange})

    def _acknowledge_all(self) -> None:
        """Called with the lock."""
        for (mine, name), way in self._ways.items():
            if way.owed and self._others[name].alive:
                self._acknowledge(mine, name, way)

    def _wait_for_last_words(self) -> None:
        """Wait until all has arrived that is on its way, as long as something still does."""
        words = max(LAST_WORDS, self._delay / 1e9)
        now = time.monotonic()
        until, latest = now + words, now + MOST_WORDS * words
        left = self._unfinished(now - words)
        while left and now < min(until, latest):
            time.sleep(0.005)
            now = time.monotonic()
            before, left = left, self._unfinished(now - words)
            if left < before:
                until = now + words

    def _unfinished(self, recently: float) -> int:
        """How many letters may still be acknowledged.

        Who has gone since `recently` may have had them all: what says so may come after the news that it is
        gone, by another connection.
        """
        with self._lock:
            return sum(
                len(way.out) if other.alive else way.out.flying if other.gone_at > recently else 0
                for (_, name), way in self._ways.items()
                for other in (self._others[name],)
            )

    def publish(
        self,
        identity: Identity,
        rules: ChannelInfo | None,
        channel: str,
        message: Any,
        to: Sequence[str],
        moment: int,
        host: str | None,
    ) -> None:
        sender, sequence = identity
        payload = self._encoded(sender, channel, message)
        if payload is None:
            return
        envelope = self._envelope(
            envelopes.MESSAGE, sequence, self._origin + moment, channel=channel, host=host or ""
        )
        what = channel.split(".", 2)[1]
        sent = _Sent(channel.replace(".", "/"), envelope, payload, sender, what)
        key = (what, channel, host or "")
        with self._lock:
            if self._closing:
                return
            kept = _Kept(sent, tuple(to), key if what == "state" else None)
            if what == "state":
                self._states[sender, channel, host or ""] = kept
            elif what == "data":
                self._keep_sample(sender, channel, kept)
            for name in to:
                self._dispatch(self._ways[sender, name], self._others[name], sent, rules, key)

    def _dispatch(
        self, way: _Way, other: _Other, sent: _Sent, rules: ChannelInfo | None, key: tuple[str, ...]
    ) -> None:
        """Send a message to one agent, now or when that is possible. Called with the lock."""
        if sent.what == "data":
            if other.alive:
                way.sample += 1
                self._hand_over(other, sent, sample=way.sample)
            return
        if other.life is None and sent.what == "state":
            return  # it gets the latest when it comes
        replaces = key if sent.what == "state" else None
        if sent.what == "signal" and not other.alive and not (rules is not None and rules.queued):
            replaces = key
        given_up = way.out.put(Letter(sent, len(sent.payload), replaces))
        self._lose(other.name, given_up, "a newer one took its place before it could be sent")
        self._pump(way, other)

    def _keep_sample(self, sender: str, channel: str, kept: _Kept) -> None:
        samples = self._samples.setdefault((sender, channel), deque(maxlen=SAMPLES))
        samples.append(kept)

    def carry(self, message: AclMessage, to: str, members: Mapping[str, Sequence[str]]) -> None:
        sender, sequence = message.identity
        payload = self._encoded(sender, f"{message.performative} {message.message}", message.content)
        if payload is None:
            return
        envelope = self._envelope(
            envelopes.MAIL,
            sequence,
            self._origin + self._team.driver.clock.now(),
            performative=message.performative,
            message=message.message,
            protocol=message.protocol,
            conversation=message.conversation,
            participant=message.participant,
            to=message.to,
            parts=tuple((part, tuple(names)) for part, names in members.items()),
            receivers=message.receivers,
            in_reply_to=message.in_reply_to,
            reply_with=message.reply_with if message.reply_with != name_of(message.identity) else "",
            reply_by=0 if message.reply_by is None else self._origin + message.reply_by,
            reply_to=message.reply_to,
            language=message.language if message.language != JSON else "",
            encoding=message.encoding,
            ontology=message.ontology if message.ontology != self._team.system else "",
        )
        sent = _Sent("mail", envelope, payload, sender, "mail")
        with self._lock:
            if self._closing:
                return
            way, other = self._ways[sender, to], self._others[to]
            self._lose(to, way.out.put(Letter(sent, len(payload))), "too many wait for it")
            self._pump(way, other)

    def carry_outside(self, message: FipaMessage, to: AgentIdentifier) -> bool:
        if self._closing or message.sender is None:
            return False
        addresses = (*to.addresses, to.name)
        return any(self._link.say(address, message.sender.name, message) for address in addresses)

    def peers(self) -> dict[str, Peer]:
        # Without the lock: who listens to the trace may ask, while the trace waits for nobody.
        found: dict[str, Peer] = {}
        for name, other in self._others.items():
            waiting = sum(len(way.out) for (_, to), way in self._ways.items() if to == name)
            quickest = min(tuple(other.measured), default=None)
            same = other.clock in (None, self._clock)
            uncertainty = 0 if same else (quickest[0] // 2 if quickest else None)
            found[name] = Peer(
                name,
                other.alive,
                other.life,
                unacknowledged=waiting,
                uncertainty=uncertainty,
                **dict(other.counts),
            )
        return found

    def is_there(self, name: str) -> bool:
        other = self._others.get(name)
        return other is not None and other.alive

    def history(
        self, sender: str, channel: str, since: int, until: int, timeout: float = 1.0
    ) -> list[tuple[int, Any]]:
        other = self._others.get(sender)
        kind = self._schema.channels.get(channel)
        if other is None or kind is None:
            raise TransportError(f"there is no agent {sender} elsewhere with a channel {channel}")
        shift = self._origin - (self._difference(other) or 0)
        question = json.dumps({"channel": channel, "since": since + shift, "until": until + shift})
        found: list[tuple[int, Any]] = []
        answers = self._link.ask(sender, "history", question.encode(), timeout, other.life)
        for envelope, payload in answers:
            if envelope.kind == envelopes.ACKNOWLEDGE:
                continue
            if envelope.model != self.model:
                raise TransportError(f"{sender} has another model ({envelope.model})")
            try:
                found.append((self._moment(other, envelope), self._read(kind, payload)))
            except WireError as problem:
                raise TransportError(f"the answer of {sender} cannot be read: {problem}") from problem
        if not answers:
            raise TransportError(f"{sender} does not answer")
        return sorted(found, key=lambda item: item[0])

    def ask(self, name: str, request: dict[str, Any], timeout: float = 1.0) -> dict[str, Any]:
        for _, payload in self._link.ask(name, "control", json.dumps(request).encode(), timeout):
            with contextlib.suppress(ValueError):
                answer = outside.loads(payload)
                if isinstance(answer, dict):
                    return answer
        raise TransportError(f"{name} does not answer")

    def renew(self, schema: Schema, model: str) -> None:
        """The agents of this process go on under another version of the model.

        What is on its way to or from an agent of the other version is refused when it arrives, and told.
        """
        self._schema = schema
        self.model = model

    def answer(self, answer: Answer) -> None:
        self._answer = answer

    # ---- sending -----------------------------------------------------------------------------

    def _encoded(self, sender: str, what: str, message: Any) -> bytes | None:
        try:
            payload = self._schema.encode_json(message) if self._readable else self._schema.encode(message)
            largest = self._link.largest
            if largest is not None and len(payload) > largest:
                raise WireError(f"it has {len(payload)} bytes, and at the most {largest} travel here")
        except WireError as problem:
            now = self._team.driver.clock.now()
            self._team.trace.fault(now, sender, f"{what} cannot be sent to other robots: {problem}")
            return None
        return payload

    def _read(self, kind: type[Any], payload: bytes) -> Any:
        """The message that a payload is. Raises WireError."""
        if self._readable:
            return self._schema.decode_json(kind, payload)
        return self._schema.decode(kind, payload)

    def _envelope(self, kind: int, sequence: int = 0, moment: int = 0, **members: Any) -> Envelope:
        return Envelope(
            kind,
            self.model,
            self.incarnation,
            sequence=sequence,
            time=moment or time.monotonic_ns(),
            clock=self._clock,
            **members,
        )

    def _pump(self, way: _Way, other: _Other) -> None:
        """Send what may be sent. Called with the lock."""
        if not other.alive:
            return
        for place, letter in way.out.ready(time.monotonic_ns()):
            self._hand_over(other, letter.item, place=place)
        if way.out.flying:
            self._stir()

    def _hand_over(self, other: _Other, sent: _Sent, place: int = 0, sample: int = 0) -> None:
        """Give something to the link."""
        stamp = Stamp(other.life or 0, place, sample)
        self._link.send(other.name, sent.sender, sent.way, sent.envelope, stamp, sent.payload, place > 0)

    def _say(self, mine: str, name: str, way: str, envelope: Envelope, life: int | None = None) -> None:
        """Send something of the post's own, to the life that the other one leads or to another."""
        stamp = Stamp(self._others[name].life or 0 if life is None else life)
        self._link.send(name, mine, way, envelope, stamp, b"", True)

    def _acknowledge(self, mine: str, name: str, way: _Way) -> None:
        way.owed = 0
        envelope = self._envelope(envelopes.ACKNOWLEDGE, upto=way.into.upto, missing=way.into.missing())
        self._say(mine, name, "ack", envelope)

    def _lose(self, name: str, letters: Iterable[Letter[_Sent]], reason: str) -> None:
        """Tell what will not be brought to an agent. A state that a newer one replaces is none of it."""
        now = self._team.driver.clock.now()
        other = self._others[name]
        for letter in letters:
            sent = letter.item
            if sent.what in ("state", "data"):
                continue
            other.counts["lost"] = other.counts.get("lost", 0) + 1
            envelope = sent.envelope
            self._team.trace.write(
                "lost",
                now,
                agent=sent.sender,
                input=list(sent.identity),
                peer=name,
                channel=envelope.channel or None,
                conversation=envelope.conversation or None,
                reason=reason,
            )

    # ---- the beat ----------------------------------------------------------------------------

    def _stir(self) -> None:
        """There is something to look after. Called with the lock."""
        if self._resting:
            self._resting = False
            self._rest.notify()

    def _beat(self) -> None:
        while True:
            with self._lock:
                if self._closing:
                    return
                try:
                    busy = self._look_after()
                except Exception as problem:  # without this thread nothing would be sent again
                    now = self._team.driver.clock.now()
                    reason = f"the transport failed: {type(problem).__name__}: {problem}"
                    self._team.trace.remark(now, next(iter(self._here)), reason)
                    busy = True
                if busy:
                    self._rest.wait(BEAT)
                else:
                    self._resting = True
                    self._rest.wait(1.0 if self._lease is None else min(1.0, self._lease / PINGS / 1e9))
                    if self._resting:
                        self._resting = False
                    else:
                        # What was just sent or came is looked after in a moment, not while it is answered.
                        self._rest.wait(BEAT)
                silent = self._silent()
            for name, life in silent:  # without the lock, since conversations are told
                self.vanished(name, life)

    def _silent(self) -> list[tuple[str, int]]:
        """Who has not answered for a lease, though its token is there: anybody may hold a copy of that."""
        if self._lease is None:
            return []
        before = time.monotonic_ns() - self._lease
        return [
            (other.name, other.life)
            for other in self._others.values()
            # Not by time alone: we may have been suspended ourselves.
            if other.alive
            and other.life is not None
            and other.unanswered >= PINGS
            and other.answered_at < before
        ]

    def _ping(self, mine: str, other: _Other) -> None:
        """Called with the lock."""
        envelope = self._envelope(envelopes.PING)
        self._ways[mine, other.name].asked.append(envelope.time)
        other.unanswered += 1
        self._say(mine, other.name, "ping", envelope)

    def _hoped(self, other: _Other) -> list[int]:
        """The lives of an agent that may be its next one, and have said nothing to us yet."""
        found = [life for life in other.present if life != other.life and self._is_next(other, life)]
        return sorted(found)[-MOST_HOPED:]

    def _knock(self, other: _Other) -> None:
        """Have lives say themselves that they are there: tokens may be copies. Called with the lock."""
        mine = next(iter(self._here))
        for life in self._hoped(other):
            envelope = self._envelope(envelopes.PING)
            self._ways[mine, other.name].asked.append(envelope.time)
            self._say(mine, other.name, "ping", envelope, life)

    def _look_after(self) -> bool:
        """Acknowledge, send again, measure clocks; whether that will soon be needed again."""
        busy = False
        now = time.monotonic_ns()
        for (mine, name), way in self._ways.items():
            other = self._others[name]
            if way.owed and now - way.owed_since >= self._delay:
                self._acknowledge(mine, name, way)
            busy = busy or way.owed > 0
            few = other.alive and other.clock != self._clock and len(other.measured) < QUESTIONS
            if now >= other.ask_at and self._is_asked(other):
                pause = ASK_AGAIN if self._lease is None else min(ASK_AGAIN, self._lease // PINGS)
                other.ask_at = now + (50_000_000 if few else pause)
                if other.life is not None:
                    self._ping(mine, other)
                if self._lease is not None:
                    self._knock(other)
            busy = busy or few
            if not other.alive:
                continue
            for place, letter in way.out.overdue(now):
                self._hand_over(other, letter.item, place=place)
            self._pump_quietly(way, other)
            busy = busy or way.out.flying > 0
        return busy

    def _is_asked(self, other: _Other) -> bool:
        """Whether another agent is sent PINGs: for its clock, or to prove that it is there."""
        if self._lease is not None:
            return (other.life is not None or bool(other.present)) and self._gate.is_set()
        return other.alive and other.clock != self._clock

    def _pump_quietly(self, way: _Way, other: _Other) -> None:
        for place, letter in way.out.ready(time.monotonic_ns()):
            self._hand_over(other, letter.item, place=place)

    # ---- hearing -----------------------------------------------------------------------------

    def arrived(self, to: str, sender: str, envelope: Envelope, payload: bytes) -> None:
        """Something has come for one of our agents."""
        if not self._gate.is_set():
            self._gate.wait()
        came = time.monotonic_ns()
        if self._is_fresh(envelope):
            self._end_before(sender, envelope.incarnation)
        with self._lock:
            other = self._sender(to, sender)
            if other is None:
                return
            life, alive = other.life, other.alive
            if not self._is_current(other, envelope):
                return
            other.clock = envelope.clock
            ready = self._taken(to, other, envelope, payload, came)
            comes = other.alive and (not alive or other.life != life)
        if comes:
            self._team.conversations.appeared(sender)
        for item in ready:
            if item is not None:
                self._hand_on(to, other, *item)

    def _taken(
        self, to: str, other: _Other, read: Envelope, payload: bytes, came: int
    ) -> Sequence[tuple[Envelope, Any] | None]:
        """What can be handed on after something has come. Called with the lock."""
        way = self._ways[to, other.name]
        if read.kind == envelopes.ACKNOWLEDGE:
            for place, letter in way.out.acknowledge(read.upto, read.missing, came):
                self._hand_over(other, letter.item, place=place)
            self._pump(way, other)
            return ()
        if read.kind == envelopes.PING:
            if read.time <= way.pinged:
                self._count(other, "duplicated", "one came twice; the second was dropped")
                return ()
            way.pinged = read.time
            if way.owed:
                self._acknowledge(to, other.name, way)
            self._say(to, other.name, "pong", self._envelope(envelopes.PONG, asked=read.time, heard=came))
            return ()
        if read.kind == envelopes.PONG:
            if read.asked not in way.asked:
                self._count(other, "duplicated", "one came twice; the second was dropped")
                return ()
            way.asked.remove(read.asked)
            other.unanswered, other.answered_at = 0, came
            trip = (came - read.asked) - (read.time - read.heard)
            other.measured.append((trip, ((read.asked - read.heard) + (came - read.time)) // 2))
            if not other.alive and self._lease is not None and not self._closing:
                self._come_back(other)
            return ()
        # Not before its turn: what comes twice is looked into once.
        return [self._decoded(other, *item) for item in self._sorted(to, other, way, read, payload)]

    def unreadable(self, to: str, sender: str, reason: str) -> None:
        """Something has come for one of our agents that is no envelope, or not that of what came in it."""
        self._gate.wait()
        with self._lock:
            other = self._sender(to, sender)
            if other is not None:
                self._count(other, "unreadable", reason)

    def _sender(self, to: str, sender: str) -> _Other | None:
        """Who has sent something to one of ours; None for a stranger, told. Called with the lock."""
        if self._closing or to not in self._here:
            return None
        other = self._others.get(sender)
        if other is None:
            self._meet_stranger(sender)
        return other

    def outside(self, to: str, message: FipaMessage) -> None:
        """Somebody who is not of the team has said something to one of our agents."""
        self._gate.wait()
        if self._closing or to not in self._here:
            return
        try:
            self._team.conversations.receive_external(to, message)
        except Exception as problem:  # the link's thread has nobody above who would tell
            sender = message.sender.name if message.sender is not None else "somebody"
            reason = f"what {sender} said could not be taken: {type(problem).__name__}: {problem}"
            self._team.trace.fault(self._team.driver.clock.now(), to, reason)

    def returned(self, agent: str, to: str, name: str, reason: str) -> None:
        """What one of our agents said to an outsider was not delivered; `name` is its `reply-with`."""
        text = f"{name or 'a message'} could not be brought to {to}: {reason}"
        self._team.trace.fault(self._team.driver.clock.now(), agent, text)
        self._team.conversations.vanished(to)

    def disconnected(self, agent: str, reason: str) -> None:
        """One of our agents has lost its connection, which is made again."""
        self._tell_own(agent, "disconnected", reason)

    def connected(self, agent: str, reason: str) -> None:
        """It has a connection again."""
        self._tell_own(agent, "connected", reason)
        with self._lock:
            self._hurry([key for key in self._ways if key[0] == agent])

    def _tell_own(self, agent: str, what: str, reason: str) -> None:
        now = self._team.driver.clock.now()
        self._team.trace.write("peer", now, agent=agent, peer=agent, what=what, reason=reason)

    def _is_current(self, other: _Other, envelope: Envelope) -> bool:
        """Whether an envelope is from the life that its sender leads, and for ours. Called with the lock."""
        life = envelope.incarnation
        if life != other.life and not self._is_next(other, life):
            self._count(other, "late", "it is of an earlier life of its sender")
            return False
        if not self._is_fresh(envelope):
            if envelope.kind == envelopes.PING:  # who looks for another life of ours is none of our business
                other.counts["late"] = other.counts.get("late", 0) + 1
            else:
                self._count(other, "late", "it is for an earlier life of its receiver")
            return False
        if life != other.life:
            self._begin_life(other, life)
        return True

    def _is_fresh(self, envelope: Envelope) -> bool:
        """Whether an envelope was made for this life of ours: what is replayed may be for an earlier one."""
        return envelope.addressee == self.incarnation or (self._lease is None and envelope.addressee == 0)

    def _is_next(self, other: _Other, life: int) -> bool:
        """Whether this life comes after the one that is known.

        A robot whose clock was set back begins one with a lower number: it counts when the other has ended.
        """
        if life in other.ended:
            return False
        return other.life is None or life > other.life or (not other.alive and life in other.present)

    def _decoded(self, other: _Other, envelope: Envelope, payload: bytes) -> tuple[Envelope, Any] | None:
        """The message in an envelope; None, after telling why, if it is none for us."""
        mail = envelope.kind == envelopes.MAIL
        name = envelope.message if mail else envelope.channel
        if envelope.model != self.model:
            reason = f"{name} is of the model {envelope.model or '(none)'}; ours is {self.model}"
            self._count(other, "refused", reason, about=name)
            return None
        kind: Any = self._schema.channels.get(name)
        if mail:
            kind = next((k for k in self._schema.classes if k.__name__ == name), None)
        if kind is None:
            self._count(
                other, "refused", f"there is no {'message' if mail else 'channel'} {name}", about=name
            )
            return None
        try:
            return envelope, self._read(kind, payload)
        except WireError as problem:
            self._count(other, "unreadable", f"{name}: {problem}", about=name)
            return None

    def _sorted(self, to: str, other: _Other, way: _Way, envelope: Envelope, payload: bytes) -> list[_Got]:
        """What is to be handed on now that this has come. Called with the lock."""
        if envelope.place == 0:
            return self._sampled(other, way, envelope, payload)
        if envelope.addressee != self.incarnation:
            self._count(other, "late", "it is for an earlier life of its receiver")
            return []
        if envelope.place > way.into.upto + 1:
            self._count(other, "reordered", "one came before its predecessor")
        had_gap = way.into.has_gap
        found = way.into.take(envelope.place, (envelope, payload), len(payload))
        if not way.owed:
            way.owed_since = time.monotonic_ns()
        way.owed += 1
        if found is None:
            self._count(other, "duplicated", "one came twice; the second was dropped")
        if way.owed >= OWED or (way.into.has_gap and not had_gap):
            self._acknowledge(to, other.name, way)
        else:
            self._stir()
        return found or []

    def _sampled(self, other: _Other, way: _Way, envelope: Envelope, payload: bytes) -> list[_Got]:
        """Data, which comes once or not at all."""
        number = envelope.sample
        if envelope.kind != envelopes.MESSAGE or not number or ".data." not in envelope.channel:
            self._count(other, "unreadable", "it has no place in the stream", about=envelope.channel)
            return []
        missed = way.samples.take(number)
        if missed is None:
            self._count(other, "duplicated", "one came twice; the second was dropped")
            return []
        if missed < 0:
            self._count(other, "reordered", "one came before its predecessor")
        elif missed:
            self._tell_once(
                other, "dropped", "data did not come: too much was sent at once, or the link broke"
            )
        if missed:
            other.counts["dropped"] = other.counts.get("dropped", 0) + missed
        return [(envelope, payload)]

    def _hand_on(self, to: str, other: _Other, envelope: Envelope, message: Any) -> None:
        """Give a message to the agent that it is for. Called without the lock."""
        agent = self._here[to]
        team = self._team
        other.counts["taken"] = other.counts.get("taken", 0) + 1
        identity = (other.name, envelope.sequence)
        try:
            if envelope.kind == envelopes.MAIL:
                acl = AclMessage(
                    envelope.performative,
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
                    reply_by=self._deadline(other, envelope),
                    reply_to=envelope.reply_to,
                    language=envelope.language or JSON,
                    encoding=envelope.encoding,
                )
                team.conversations.arrived(agent, acl, dict(envelope.parts))
            else:
                moment = self._moment(other, envelope)
                host = envelope.host or None
                channel = envelope.channel
                reason = team.bus.arrived(agent, channel, message, other.name, identity, moment, host)
                if reason is not None:
                    self._count(other, "refused", reason, about=channel)
        except Exception as problem:  # the link's thread has nobody above who would tell
            reason = f"what {other.name} sent could not be taken: {type(problem).__name__}: {problem}"
            team.trace.fault(team.driver.clock.now(), to, reason)

    def _moment(self, other: _Other, envelope: Envelope) -> int:
        """When something was measured, in the time of our run: never later than now."""
        now = self._team.driver.clock.now()
        if envelope.clock == self._clock:
            return min(now, envelope.time - self._origin)
        difference = self._difference(other)
        return now if difference is None else min(now, envelope.time + difference - self._origin)

    def _deadline(self, other: _Other, envelope: Envelope) -> int | None:
        """Until when an answer is wanted, in our run's time; None while the clocks cannot be compared."""
        if not envelope.reply_by:
            return None
        difference = 0 if envelope.clock == self._clock else self._difference(other)
        return None if difference is None else envelope.reply_by + difference - self._origin

    def _difference(self, other: _Other) -> int | None:
        """What is to be added to another machine's time; None while that is not known."""
        if other.clock in (None, self._clock):
            return 0
        return min(other.measured)[1] if other.measured else None

    # ---- who is there ------------------------------------------------------------------------

    def appeared(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is there now."""
        self._gate.wait()
        if agent in self._here:
            if incarnation > self.incarnation:
                if self._lease is None:
                    self._replaced(agent)
                elif incarnation not in self._twins:
                    self._twins.add(incarnation)
                    threading.Thread(
                        target=self._ask_twin, args=(agent, incarnation), name="aseme twin", daemon=True
                    ).start()
            return
        if self._lease is None:
            self._end_before(agent, incarnation)
        with self._lock:
            other = self._others.get(agent)
            if other is None:
                self._meet_stranger(agent)
                return
            other.present.add(incarnation)
            if incarnation != other.life and self._is_next(other, incarnation):
                if self._lease is None:
                    self._begin_life(other, incarnation)
                else:
                    self._knock(other)
                    self._stir()
            elif incarnation == other.life:
                if other.alive:
                    self._hurry([key for key in self._ways if key[1] == agent])
                elif self._lease is None:
                    self._come_back(other)
                else:
                    self._ping(next(iter(self._here)), other)
        if other.alive:
            self._team.conversations.appeared(agent)

    def _replaced(self, agent: str) -> None:
        """One of our agents is played by a newer process: this one stops."""
        now = self._team.driver.clock.now()
        self._team.trace.write("peer", now, agent=agent, peer=agent, what="replaced")
        self._team.driver.stop("replaced")

    def _ask_twin(self, agent: str, life: int) -> None:
        """Stop if a newer life of one of our agents answers, as long as something says that it is there."""
        while not self._closing and life in self._twins:
            if self._link.ask(agent, "history", b"{}", TWIN_SECONDS, life):
                self._replaced(agent)
                return
            time.sleep(TWIN_SECONDS)

    def _come_back(self, other: _Other) -> None:
        """An agent that was gone leads the same life still. Called with the lock."""
        other.alive = True
        self._tell(other, "reconnected")
        self._hurry([key for key in self._ways if key[1] == other.name])

    def _end_before(self, agent: str, life: int) -> None:
        """An agent leads one life: the one before has ended, also if it was not seen to. Called without the
        lock, since conversations are told."""
        other = self._others.get(agent)
        if other is None or not other.alive or other.life is None:
            return
        if life > other.life and life not in other.ended:
            self.vanished(agent, other.life)

    def _hurry(self, ways: Iterable[tuple[str, str]]) -> None:
        """A link was broken: what was on its way is sent again at once. Called with the lock."""
        for key in ways:
            self._ways[key].out.hurry()
            self._pump(self._ways[key], self._others[key[1]])
        self._stir()

    def vanished(self, agent: str, incarnation: int) -> None:
        """An agent elsewhere is not there any more."""
        self._gate.wait()
        if agent in self._here:
            self._twins.discard(incarnation)
        with self._lock:
            other = self._others.get(agent)
            if other is None or self._closing:
                return
            other.present.discard(incarnation)
            if self._lease is not None and other.life == incarnation:
                other.ended.add(incarnation)
            if other.life != incarnation or not other.alive:
                return
            other.alive, other.gone_at = False, time.monotonic()
            self._tell(other, "gone")
        self._team.conversations.vanished(agent)
        with self._lock:
            others = other.present - other.ended
            if other.alive or not others:
                return
            if self._lease is not None:
                self._knock(other)
                return
            self._begin_life(other, max(others))
        self._team.conversations.appeared(agent)

    def _begin_life(self, other: _Other, life: int) -> None:
        """An agent is there for the first time, or again after it had ended. Called with the lock."""
        first = other.life is None
        other.life, other.alive, other.clock = life, True, None
        other.measured.clear()
        other.unanswered, other.answered_at, other.ask_at = 0, time.monotonic_ns(), 0
        self._tell(other, "connected" if first else "restarted")
        for (mine, name), way in self._ways.items():
            if name != other.name:
                continue
            flying, waiting = way.out.restart()
            self._lose(name, flying, "it ended while this was on its way")
            way.into, way.samples, way.owed, way.sample = Incoming(), Samples(), 0, 0
            way.pinged = 0  # what was asked stays: the answer may be how this life began
            for kept in self._news_for(mine, name):
                way.out.put(Letter(kept.sent, len(kept.sent.payload), kept.replaces))
            for letter in waiting:
                if letter.item.what != "state":
                    way.out.put(Letter(letter.item, letter.size))
            self._pump(way, other)
        self._stir()

    def _news_for(self, mine: str, name: str) -> Iterator[_Kept]:
        """What somebody who comes has to know of one of our agents: data still asked for, then states."""
        now = time.monotonic_ns()
        for (sender, channel), samples in self._samples.items():
            oldest = now - self._retention.get(channel, 0)
            recent = [kept for kept in samples if kept.sent.envelope.time >= oldest] or list(samples)[-1:]
            yield from (kept for kept in recent if sender == mine and name in kept.to)
        yield from (
            kept for (sender, _, _), kept in self._states.items() if sender == mine and name in kept.to
        )

    def _meet_stranger(self, name: str) -> None:
        """Somebody who is not of the team uses its name on the network."""
        self._strange += 1
        name = name[:LONGEST_NAME]
        if name in self._strangers or len(self._strangers) > 100:
            return
        self._strangers.add(name)
        mine = next(iter(self._here))
        now = self._team.driver.clock.now()
        self._team.trace.write("peer", now, agent=mine, peer=name, what="untrusted")

    # ---- the trace ---------------------------------------------------------------------------

    def _count(self, other: _Other, what: str, reason: str, about: str = "") -> None:
        """Count what is wrong with something that came; the first of its kind is told."""
        other.counts[what] = other.counts.get(what, 0) + 1
        self._tell_once(other, what, reason, about)

    def _tell_once(self, other: _Other, what: str, reason: str, about: str = "") -> None:
        if (what, about) not in other.told and len(other.told) < 1000:
            other.told.add((what, about))
            self._tell(other, what, reason=reason)

    def _tell(self, other: _Other, what: str, **members: Any) -> None:
        mine = next(iter(self._here))
        now = self._team.driver.clock.now()
        self._team.trace.write("peer", now, agent=mine, peer=other.name, what=what, **members)

    # ---- questions ---------------------------------------------------------------------------

    def asked(self, to: str, what: str, question: bytes) -> Iterable[tuple[Envelope, bytes]]:
        """A question to one of our agents; the answers."""
        if what == "control":
            if self._answer is None:
                return [self._json_answer({"error": f"{to} takes no control requests"})]
            return [self._json_answer(self._answer(to, question))]
        try:
            request = outside.loads(question)
            if not isinstance(request, dict):
                raise ValueError("a JSON object is wanted")
        except ValueError as problem:
            return [self._json_answer({"error": f"the question cannot be read: {problem}"})]
        if what == "history":
            return self._history_of(to, request)
        return []

    def _json_answer(self, answer: dict[str, Any], further: int = 0) -> tuple[Envelope, bytes]:
        """The first piece of an answer, after which `further` ones come."""
        return self._envelope(envelopes.ACKNOWLEDGE, upto=1 + further), json.dumps(answer).encode()

    def _history_of(self, mine: str, request: dict[str, Any]) -> list[tuple[Envelope, bytes]]:
        channel, since, until = request.get("channel"), request.get("since"), request.get("until")
        if not isinstance(channel, str) or not isinstance(since, int) or not isinstance(until, int):
            return [self._json_answer({})]
        with self._lock:
            samples = list(self._samples.get((mine, channel), ()))
        found = [
            (kept.sent.envelope, kept.sent.payload)
            for kept in samples
            if since <= kept.sent.envelope.time <= until
        ]
        # The first says that there is somebody, also if there is no data.
        return [self._json_answer({}, len(found)), *found]


@cache
def clock_identity() -> int:
    """A number that all processes have in common that share the monotonic clock, and no others."""
    try:
        boot = Path("/proc/sys/kernel/random/boot_id").read_text("ascii")
        namespace = str(Path("/proc/self/ns/time").readlink()) if Path("/proc/self/ns/time").exists() else ""
    except OSError:  # not Linux: each process has a clock of its own, whose difference is measured
        boot, namespace = f"{os.getpid()} {time.time_ns()}", ""
    return zlib.crc32(f"{boot} {namespace}".encode()) + 1
