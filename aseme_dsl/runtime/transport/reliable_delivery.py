"""Reliable delivery: the transport of a team whose agents run in several processes.

- Signals, states and agent messages go in a stream from each agent to each other one (`stream`). While both
  agents run, none is lost, duplicated or reordered, even if the link between them breaks for a time.
- Data is sent once. The receiver counts the samples that the network drops.
- An agent that appears receives the latest value of each `state` that it reads, and the data that is retained
  for it.
- Messages to an agent that is absent wait for it. All agent messages and queued signals are kept in order; of
  any other signal only the newest, as on the blackboard of an agent that does not read it.
- Messages that were on their way to an agent when it crashed are lost, and recorded in the trace.

Times are those of the machine's monotonic clock, which all processes of one machine share. For another
machine the clock difference is measured as in NTP (RFC 5905, section 8): the quickest one of the last few
pings and answers decides.
"""

from __future__ import annotations

import contextlib
import json
import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.runtime.chart.inputs import LOST, Identity
from aseme_dsl.runtime.message.acl import JSON, AclMessage, AgentIdentifier, FipaMessage, name_of
from aseme_dsl.runtime.message.contract import contract_of
from aseme_dsl.runtime.message.wire import Schema, WireError
from aseme_dsl.runtime.time.clock import Clock, RealClock
from aseme_dsl.runtime.time.synchronised import synchronised
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.delivery.builds import compare_soon, contract_letter, reading_of
from aseme_dsl.runtime.transport.delivery.clocks import clock_identity, clock_record, difference_to, moment_of
from aseme_dsl.runtime.transport.delivery.codec import Codec
from aseme_dsl.runtime.transport.delivery.inbox import Inbox
from aseme_dsl.runtime.transport.delivery.records import Kept, Other, Sent, Way
from aseme_dsl.runtime.transport.delivery.reports import OVERFLOW, lose, tell, tell_losses
from aseme_dsl.runtime.transport.delivery.sending import (
    UNKNOWN,
    acknowledge_all,
    dispatch,
    encoded,
    ping,
    pump,
)
from aseme_dsl.runtime.transport.delivery.state import Delivery
from aseme_dsl.runtime.transport.delivery.upkeep import keep_up
from aseme_dsl.runtime.transport.delivery.watching import listen, watch_over
from aseme_dsl.runtime.transport.link import NOBODY, Link
from aseme_dsl.runtime.transport.port import Answer, Connected, Peer, Transport, TransportError
from aseme_dsl.runtime.transport.stream import Letter, Outgoing

if TYPE_CHECKING:
    from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan

LAST_WORDS = 0.3
"""How long, in seconds, what is on its way may take to arrive when a robot ends; on slower links longer."""
MOST_WORDS = 10
"""So many times as long as that is waited at the most, as long as something still arrives."""


class Post(Transport):
    """The transport of one process of a team that runs in several. Used by one team, once."""

    networked = True

    def __init__(self, link: Link, schema: Schema, model: str, plans: Iterable[Plan]) -> None:
        """`model` is the MODEL of the generated package, `plans` are those of all its roles."""
        incarnation = time.time_ns()
        codec = Codec(schema, contract_of(schema, plans, model), link.readable, link.largest)
        self.state = Delivery(link, codec, incarnation, clock_identity())
        self.inbox = Inbox(self.state)
        self.life = f"{incarnation:x}-"
        # In microseconds: no incarnation has more identities than that, and they stay exact as JSON numbers.
        self.behind = incarnation // 1000
        self._thread: threading.Thread | None = None

    @property
    def contract(self) -> int:
        """The number of the contract of the version that the agents of this process follow."""
        return self.state.codec.number

    @property
    def incarnation(self) -> int:
        """What tells this incarnation of our agents from earlier ones."""
        return self.state.incarnation

    def machine(self, clock: Clock) -> dict[str, int] | None:
        if not isinstance(clock, RealClock):
            return None
        is_right = synchronised()
        known = {} if is_right is None else {"synchronised": is_right}
        return {"clock": self.state.clock, "origin": clock.origin, **known}

    def begin(self, team: Connected) -> None:
        state = self.state
        state.team = team
        state.here = {agent.name: agent for agent in team.agents}
        state.others = {name: Other(name) for name in team.elsewhere}
        patience = state.link.patience
        state.ways = {(mine, other): Way(Outgoing(patience)) for mine in state.here for other in state.others}
        clock = team.driver.clock
        assert isinstance(clock, RealClock)  # the team has seen to that
        state.origin = clock.origin
        state.archive.learn((*team.elsewhere.values(), *(agent.plan for agent in team.agents)))
        listen(state)
        try:
            state.link.open(tuple(state.here), state.incarnation, self.inbox)
        except TransportError:
            if state.heartbeats is not None:
                state.heartbeats.close()
            raise
        self._thread = threading.Thread(target=keep_up, args=(state,), name="aseme transport", daemon=True)
        self._thread.start()
        if state.heartbeats is not None:
            state.heartbeats.start()
            threading.Thread(target=watch_over, args=(state,), name="aseme presence", daemon=True).start()

    def go(self) -> None:
        self.state.gate.set()

    def close(self) -> None:
        state = self.state
        if self._thread is None:
            return
        state.gate.set()
        with state.lock:
            acknowledge_all(state)
            if state.delay:
                for (mine, name), way in state.ways.items():
                    if way.out.flying and state.others[name].alive:  # the answer comes after acknowledgements
                        ping(state, mine, state.others[name])
        self._wait_for_last_words()
        with state.lock:
            state.closing = True
            state.rest.notify()
            acknowledge_all(state)
        self._thread.join()
        if state.heartbeats is not None:
            state.heartbeats.close()
        state.link.close()
        with state.lock:
            for (_, name), way in state.ways.items():
                flying, waiting = way.out.restart()
                lose(state, name, (*flying, *waiting), "the run ended before it could be brought")
            tell_losses(state, 0)
            for other in state.others.values():
                if other.life is not None or other.counts:
                    counts = dict(sorted(other.counts.items())) or None
                    tell(state, other, "count", counts=counts, **clock_record(state, other))
            late = 0 if state.heartbeats is None else state.heartbeats.late
            counts = {"refused": state.strange, "late": late}
            if any(counts.values()):
                tell(state, Other(NOBODY), "count", counts={what: n for what, n in counts.items() if n})

    def _wait_for_last_words(self) -> None:
        """Wait until all has arrived that is on its way, as long as something still does."""
        words = max(LAST_WORDS, self.state.delay / 1e9)
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
        """How many messages may still be acknowledged.

        An agent that was lost after `recently` may have had them all: its acknowledgement may come after the
        news of the loss, by another connection.
        """
        state = self.state
        with state.lock:
            return sum(
                len(way.out) if other.alive else way.out.flying if other.gone_at > recently else 0
                for (_, name), way in state.ways.items()
                for other in (state.others[name],)
            )

    def publish(
        self,
        identity: Identity,
        rules: ChannelInfo | None,
        channel: str,
        message: object,
        to: Sequence[str],
        moment: int,
        host: str | None,
    ) -> None:
        state = self.state
        sender, sequence = identity
        what = channel.split(".", 2)[1]
        found = encoded(state, sender, channel, message, in_order=what != "data")
        if found is None:
            return
        payload, contract = found
        envelope = state.envelope(
            envelopes.MESSAGE, sequence, state.origin + moment, channel=channel, host=host or ""
        )._replace(contract=contract)
        sent = Sent(channel.replace(".", "/"), envelope, payload, sender, what)
        key = (what, channel, host or "")
        with state.lock:
            if state.closing:
                return
            kept = Kept(sent, tuple(to), key if what == "state" else None)
            if what == "state":
                state.archive.states[sender, channel, host or ""] = kept
            elif what == "data":
                state.archive.keep_sample(sender, channel, kept)
            for name in to:
                dispatch(state, state.ways[sender, name], state.others[name], sent, rules, key)

    def carry(self, message: AclMessage, to: str, members: Mapping[str, Sequence[str]]) -> None:
        state = self.state
        sender, sequence = message.identity
        is_loss = message.performative == LOST
        what = f"{message.performative} {message.message}"
        found = (b"", state.codec.number) if is_loss else encoded(state, sender, what, message.content)
        if found is None:
            return
        payload, contract = found
        envelope = state.envelope(
            envelopes.LOSS if is_loss else envelopes.MAIL,
            sequence,
            state.origin + state.now(),
            performative="" if is_loss else message.performative,
            message=message.message,
            protocol=message.protocol,
            conversation=message.conversation,
            participant=message.participant,
            to=message.to,
            parts=tuple((part, tuple(names)) for part, names in members.items()),
            receivers=message.receivers,
            in_reply_to=message.in_reply_to,
            reply_with=message.reply_with if message.reply_with != name_of(message.identity) else "",
            reply_by=0 if message.reply_by is None else state.origin + message.reply_by,
            reply_to=message.reply_to,
            language=message.language if message.language != JSON else "",
            encoding=message.encoding,
            ontology=message.ontology if message.ontology != state.team.system else "",
        )._replace(contract=contract)
        sent = Sent("mail", envelope, payload, sender, "mail")
        with state.lock:
            if state.closing:
                return
            way, other = state.ways[sender, to], state.others[to]
            if not other.knows_us:
                lose(state, to, [Letter(sent, 0)], UNKNOWN)
                return
            lose(state, to, way.out.put(Letter(sent, len(payload))), OVERFLOW)
            pump(state, way, other)

    def carry_outside(self, message: FipaMessage, to: AgentIdentifier) -> bool:
        if self.state.closing or message.sender is None:
            return False
        addresses = (*to.addresses, to.name)
        return any(self.state.link.say(address, message.sender.name, message) for address in addresses)

    def peers(self) -> dict[str, Peer]:
        # Without the lock: a listener of the trace may call this, and writing a trace must not wait.
        state = self.state
        found: dict[str, Peer] = {}
        for name, other in state.others.items():
            waiting = sum(len(way.out) for (_, to), way in state.ways.items() if to == name)
            quickest = min(tuple(other.measured), default=None)
            same = other.clock in (None, state.clock)
            uncertainty = 0 if same else (quickest[0] // 2 if quickest else None)
            found[name] = Peer(
                name,
                other.alive,
                other.life,
                unacknowledged=waiting,
                uncertainty=uncertainty,
                model=other.model,
                incompatible=other.incompatible,
                difference=0 if same else (quickest[1] if quickest else None),
                **dict(other.counts),
            )
        return found

    def is_there(self, name: str) -> bool:
        other = self.state.others.get(name)
        return other is not None and other.alive and other.knows_us

    def history(
        self, sender: str, channel: str, since: int, until: int, timeout: float = 1.0
    ) -> list[tuple[int, object]]:
        state = self.state
        other = state.others.get(sender)
        kind = state.codec.schema.channels.get(channel)
        if other is None or kind is None:
            raise TransportError(f"there is no agent {sender} elsewhere with a channel {channel}")
        shift = state.origin - (difference_to(state, other) or 0)
        question = json.dumps({"channel": channel, "since": since + shift, "until": until + shift})
        found: list[tuple[int, object]] = []
        answers = state.link.ask(sender, "history", question.encode(), timeout, other.life)
        for envelope, payload in answers:
            if envelope.kind == envelopes.ACKNOWLEDGE:
                continue
            view = None
            if envelope.contract != state.codec.number:
                view = reading_of(state, other, envelope.contract)
                reason = "nothing is known of it" if view is None else view.channels.get(channel)
                if reason:
                    raise TransportError(f"{sender} is of another build: {reason}")
            try:
                found.append((moment_of(state, other, envelope), state.codec.read(kind, payload, view)))
            except WireError as problem:
                raise TransportError(f"the answer of {sender} cannot be read: {problem}") from problem
        if not answers:
            raise TransportError(f"{sender} does not answer")
        return sorted(found, key=lambda item: item[0])

    def ask_epoch(self, name: str, timeout: float = 1.0) -> object:
        other = self.state.others.get(name)
        life = None if other is None else other.life
        for _, payload in self.state.link.ask(name, "history", b'{"epoch": true}', timeout, life):
            with contextlib.suppress(ValueError):
                answer = outside.loads(payload, 1 << 16)
                return answer.get("epoch") if isinstance(answer, dict) else None
        raise TransportError(f"{name} does not answer")

    def tell_epoch(self, tell: Callable[[], Mapping[str, object]]) -> None:
        self.inbox.epoch = tell

    def ask(self, name: str, request: dict[str, object], timeout: float = 1.0) -> dict[str, object]:
        for _, payload in self.state.link.ask(name, "control", json.dumps(request).encode(), timeout):
            with contextlib.suppress(ValueError):
                answer = outside.loads(payload)
                if isinstance(answer, dict):
                    return answer
        raise TransportError(f"{name} does not answer")

    def renew(self, schema: Schema, model: str, plans: Sequence[Plan]) -> None:
        """The agents of this process continue with another version of the model.

        Agents of other versions learn its contract before the first message of it.
        """
        state = self.state
        contract = contract_of(schema, plans, model)
        with state.lock:
            state.codec = Codec(schema, contract, state.codec.readable, state.codec.largest)
            state.contracts.pop(contract.number, None)
            state.contracts[contract.number] = contract
            for (mine, name), way in state.ways.items():
                other = state.others[name]
                if other.life is not None:
                    way.out.put(contract_letter(state, mine, contract))
                    pump(state, way, other)
            for other in state.others.values():
                compare_soon(state, other)

    def answer(self, answer: Answer) -> None:
        self.inbox.answer = answer
