"""Talks: follows the conversations in a log, and says where one of them leaves its protocol."""

from __future__ import annotations

import heapq
import itertools
from collections import Counter, deque
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from typing import NamedTuple

from aseme_dsl.project.observing.beliefs import Belief, Beliefs, Said, TooMany
from aseme_dsl.project.observing.contract import Contract, Kind
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

TOLD = 200
"""So many of the last messages of a conversation are kept for its story."""
CONVERSATIONS = 200_000
"""So many conversations are followed at once; the one that has been silent longest is let go."""
OTHERS = 1000
"""So many names of protocols that are not checked are counted."""
NOT_UNDERSTOOD = "not_understood"


class Message(NamedTuple):
    """A message in a log. Where `message` is None, `performative` and `content` say what it may be.

    `parts` are the participants that the sender and the receivers are, as far as the log says. `is_one`: the
    line tells of all the receivers. `moment` is when it was sent, `received` when it arrived, in ns.
    """

    moment: int
    conversation: str
    protocol: str
    sender: str
    to: tuple[str, ...]
    performative: str
    message: str | None
    content: object
    parts: tuple[str, str] = ("", "")
    is_one: bool = False
    name: str = ""
    """What the message is called: lines that call it the same tell of one message."""
    received: int | None = None

    @property
    def text(self) -> str:
        return f"{self.performative} {self.message or ''}".rstrip()


@dataclass(frozen=True, slots=True)
class Deviation:
    """The first message of a conversation that its protocol does not allow there, and why.

    `story` has the messages of the conversation up to it, this one included, without the first `earlier`.
    """

    message: Message
    part: str
    reason: str
    allowed: tuple[str, ...]
    awaited: tuple[str, ...]
    span: Span
    story: tuple[Message, ...]
    earlier: int = 0

    @property
    def text(self) -> str:
        """`bob (contractor) sends refuse Job to ann: …`."""
        who = f"{self.message.sender} ({self.part})" if self.part else self.message.sender
        return f"{who} sends {self.message.text} to {', '.join(self.message.to) or 'no agent'}: {self.reason}"

    @property
    def instead(self) -> str:
        """What was allowed instead."""
        said = f"allowed there: {', '.join(self.allowed) or 'nothing'}"
        return f"{said}; it may take {', '.join(self.awaited)}" if self.awaited else said


@dataclass(slots=True)
class ProtocolSum:
    """What was seen of a protocol."""

    conversations: int = 0
    messages: int = 0
    broken: int = 0
    from_the_middle: int = 0
    early: int = 0
    """How often an agent has left early, and said so."""
    unchecked: int = 0
    """Conversations with more explanations than are followed."""


class _Last(NamedTuple):
    """What an agent has sent last, and to whom: several lines may tell of one message."""

    message: Message
    to: tuple[str, ...]
    said: Said

    def may_be(self, message: Message) -> bool:
        """Whether another line may be about the same message, to other agents."""
        last = self.message
        return (
            last.message == message.message
            and last.performative == message.performative
            and last.content == message.content
            and not any(name in self.to for name in message.to)
        )


_Step = tuple[tuple[str, "str | None", tuple[str, str], int], Belief, Belief]
"""A performative, a type, the parts, how many receivers; beliefs about the sender and about each receiver."""


@dataclass(slots=True)
class _Talk:
    """A conversation."""

    beliefs: Beliefs
    start: Belief
    """What is believed of an agent that is new in it."""
    sum: ProtocolSum
    agents: dict[tuple[str, str], Belief] = field(default_factory=dict)
    story: deque[Message] = field(default_factory=lambda: deque(maxlen=TOLD))
    last: dict[str, _Last] = field(default_factory=dict)
    names: dict[str, set[str]] = field(default_factory=dict)
    """Who has been sent the messages that have names."""
    early: dict[str, set[str]] = field(default_factory=dict)
    """Where messages have arrived of which it was not seen that they were sent."""
    count: int = 0
    is_followed: bool = True


class Talks:
    """Follows conversations by their messages, in the order in which these are sent.

    A message arrives when the log says so, else at any time after it was sent. It is taken at any time after
    that, or never.
    """

    def __init__(self, contracts: Mapping[str, Contract | None], *, from_start: bool = False) -> None:
        """`from_start`: no conversation has begun before the log."""
        self._beliefs = {name: None if item is None else Beliefs(item) for name, item in contracts.items()}
        self._from_start = from_start
        self._talks: dict[tuple[str, str], _Talk] = {}
        self._opened: set[str] = set()
        self._kinds: dict[tuple[str, str, str], tuple[Kind, ...]] = {}
        self._steps: dict[_Step, tuple[Belief, Belief, Said]] = {}
        """What was worked out of messages to one agent, or to several of which the same is believed."""
        self.sums: dict[str, ProtocolSum] = {}
        self.others: Counter[str] = Counter()
        """How many messages are of protocols that the model does not have."""
        self.too_large: Counter[str] = Counter()
        """How many messages are of protocols whose automaton is too large."""
        self._under_way: list[tuple[int, int, _Talk, Message, tuple[Kind, ...], Said]] = []
        self._number = itertools.count()
        self.has_let_go = False
        """Whether a conversation was let go."""

    def renew(self, contracts: Mapping[str, Contract | None]) -> None:
        """Conversations that begin from now on follow these protocols."""
        self._beliefs |= {name: None if item is None else Beliefs(item) for name, item in contracts.items()}
        self._kinds.clear()

    def opened(self, conversation: str) -> None:
        """The log shows that this conversation begins now."""
        if len(self._opened) < CONVERSATIONS:
            self._opened.add(conversation)

    def see(self, message: Message) -> Sequence[Deviation]:
        """The next message; each message that is the first of its conversation which is not allowed."""
        found: Sequence[Deviation] = ()
        if self._under_way and self._under_way[0][0] <= message.moment:
            found = self._arrive(message.moment)
        key = message.protocol, message.conversation
        talk = self._talks.get(key)
        if talk is None:
            talk = self._begin(message)
            if talk is None:
                return found
        elif len(self._talks) > CONVERSATIONS // 2:
            self._talks[key] = self._talks.pop(key)  # the newest comes last
        talk.sum.messages += 1
        if not talk.is_followed:
            return found
        talk.count += 1
        talk.story.append(message)
        if self._is_known(talk, message):
            return found
        try:
            deviation = self._follow(talk, message)
        except TooMany:
            talk.is_followed = False
            talk.sum.unchecked += 1
            return found
        return found if deviation is None else (*found, deviation)

    def arrived(self, message: Message) -> None:
        """A message has arrived at `to`, by the log of that agent.

        Where clocks differ, this may be seen before that it was sent.
        """
        talk = self._talks.get((message.protocol, message.conversation)) or self._begin(message)
        if talk is None or not talk.is_followed or message.name in talk.names:
            return
        parts, kinds = talk.beliefs.contract.parts, self._kinds_of(message, talk)
        if kinds and message.parts[0] in parts and message.parts[1] in parts:
            talk.early.setdefault(message.name, set()).update(message.to)
            said = Said(talk.start, frozenset(message.parts[:1]), frozenset(message.parts[1:]))
            with suppress(TooMany):  # this shows again when the message was sent
                self._hear(talk, message, message.to, kinds, said)

    def end(self) -> Sequence[Deviation]:
        """The log has ended: what is still under way arrives."""
        return self._arrive(None)

    def _arrive(self, moment: int | None) -> Sequence[Deviation]:
        found = []
        while self._under_way and (moment is None or self._under_way[0][0] <= moment):
            _, _, talk, message, kinds, said = heapq.heappop(self._under_way)
            if talk.is_followed:
                try:
                    deviation = self._heard(talk, message, kinds, said)
                except TooMany:
                    talk.is_followed = False
                    talk.sum.unchecked += 1
                else:
                    found += [] if deviation is None else [deviation]
        return found

    # ---- conversations ---------------------------------------------------------------------------

    def _begin(self, message: Message) -> _Talk | None:
        beliefs = self._beliefs.get(message.protocol)
        if beliefs is None:
            counts = self.too_large if message.protocol in self._beliefs else self.others
            if message.protocol in counts or len(counts) < OTHERS:
                counts[message.protocol] += 1
            return None
        found = self.sums.setdefault(message.protocol, ProtocolSum())
        found.conversations += 1
        is_whole = self._from_start or message.conversation in self._opened
        self._opened.discard(message.conversation)
        talk = _Talk(beliefs, beliefs.first, found)
        if not is_whole and not self._may_begin(talk, message):
            found.from_the_middle += 1
            talk.start = beliefs.anywhere
        if len(self._talks) >= CONVERSATIONS:
            self._talks.pop(next(iter(self._talks)))
            self.has_let_go, self._from_start = True, False
        self._talks[message.protocol, message.conversation] = talk
        return talk

    def _may_begin(self, talk: _Talk, message: Message) -> bool:
        """Whether a conversation may begin with this message; one that is never sent tells nothing."""
        beliefs, kinds = talk.beliefs, self._kinds_of(message, talk)
        names = frozenset(beliefs.contract.parts)
        parts = frozenset(message.parts[:1]) & names or names
        return not kinds or (
            beliefs.said(beliefs.narrowed(beliefs.first, parts), kinds, names, is_ours=message.is_one)
            is not None
        )

    def _kinds_of(self, message: Message, talk: _Talk) -> tuple[Kind, ...]:
        """What a message may be, of what its protocol has; nothing if it has no such message."""
        contract = talk.beliefs.contract
        if message.message is None:
            return contract.kinds_of(message.performative, message.content)
        key = message.protocol, message.performative, message.message
        found = self._kinds.get(key)
        if found is None:
            kind = key[1:]
            found = (kind,) if contract.said_by(kind) else ()
            if len(self._kinds) < CONVERSATIONS:
                self._kinds[key] = found
        return found

    def _is_known(self, talk: _Talk, message: Message) -> bool:
        """Follow a message if it is one as there were others before: most are."""
        to, sender = message.to, message.sender
        if not to or message.name or message.received is not None or sender in to:
            return False
        agents, start, last = talk.agents, talk.start, talk.last
        part, other = message.parts if message.is_one else ("", "")
        own, theirs = (sender, part), (to[0], other)
        belief = agents.get(theirs, start)
        kind = message.performative, message.message, message.parts, len(to)
        step = self._steps.get((kind, agents.get(own, start), belief))
        if step is None:
            return False
        if len(to) > 1 and any(agents.get((name, other), start) is not belief for name in to):
            return False
        if not message.is_one:
            before = last.get(sender)
            if before is not None and before.may_be(message):
                return False
            last[sender] = _Last(message, to, step[2])
        agents[own], agents[theirs] = step[0], step[1]
        if len(to) > 1:
            for name in to:
                agents[name, other] = step[1]
        return True

    # ---- messages --------------------------------------------------------------------------------

    def _follow(self, talk: _Talk, message: Message) -> Deviation | None:
        beliefs, is_answer = talk.beliefs, message.performative == NOT_UNDERSTOOD
        if message.name and message.name in talk.names:
            return self._again(talk, message)
        kinds = self._kinds_of(message, talk)
        if not kinds:
            if is_answer:
                return None
            return self._deviation(talk, message, None, f"{beliefs.contract.name} has no such message")
        strange = next((name for name in message.parts if name and name not in beliefs.contract.parts), "")
        if strange:
            reason = f"{beliefs.contract.name} has no participant `{strange}`"
            return self._deviation(talk, message, None, reason)
        own = self._key(message, message.sender, 0)
        before = talk.agents.get(own, talk.start), self._belief(talk, message, message.to[:1])
        is_alike = all(self._belief(talk, message, (name,)) is before[1] for name in message.to[1:])
        to = self._parts_of(talk, message)
        belief = self._as(beliefs, before[0], message.parts[0])
        said = beliefs.said(belief, kinds, to, is_ours=message.is_one)
        again = None if message.is_one or message.name else self._same(talk, message)
        is_plain = again is None and not is_answer and message.message is not None
        is_plain = is_plain and said is not None and not said.is_early
        if again is not None:
            joined = beliefs.joined(belief, said.belief) if said is not None else belief
            senders = again.said.senders | (said.senders if said is not None else frozenset())
            receivers = again.said.receivers | (said.receivers if said is not None else frozenset())
            said = Said(joined, senders, receivers, again.said.is_early)
        elif said is None:
            if is_answer:
                return None
            return self._deviation(talk, message, belief, self._why_not(talk, message, belief, kinds, to))
        if len(message.to) > 1 and (wrong := self._too_many(beliefs, said, message)) is not None:
            return self._deviation(talk, message, belief, wrong)
        talk.sum.early += said.is_early and again is None
        talk.agents[own] = beliefs.joined(belief, said.belief) if is_answer else said.belief
        if message.name:
            talk.names[message.name] = set()
            talk.last.pop(message.sender, None)
        elif not message.is_one:
            self._remember(talk, message, said)
        if message.received is not None and message.received > message.moment:
            place = message.received, next(self._number), talk, message, kinds, said
            heapq.heappush(self._under_way, place)
            return None
        deviation = self._heard(talk, message, kinds, said)
        if deviation is None and is_plain and is_alike and not message.name:
            self._learn(talk, message, before, said)
        return deviation

    def _learn(self, talk: _Talk, message: Message, before: tuple[Belief, Belief], said: Said) -> None:
        """Remember what follows from a message, for those that are like it."""
        if len(self._steps) >= CONVERSATIONS:
            self._steps.clear()
        after = self._belief(talk, message, message.to)
        kind = message.performative, message.message, message.parts, len(message.to)
        self._steps[kind, *before] = said.belief, after, said

    def _belief(self, talk: _Talk, message: Message, names: Sequence[str]) -> Belief:
        """What is believed of the first of some receivers."""
        return talk.agents.get(self._key(message, names[0], 1), talk.start) if names else talk.start

    def _heard(self, talk: _Talk, message: Message, kinds: tuple[Kind, ...], said: Said) -> Deviation | None:
        """What the receivers may do now."""
        early = talk.early.pop(message.name, None) if message.name else None
        names = message.to if early is None else tuple(name for name in message.to if name not in early)
        wrong = self._hear(talk, message, names, kinds, said)
        if message.name:
            talk.names[message.name].update(message.to)
        if wrong is None or message.performative == NOT_UNDERSTOOD:
            return None
        key = self._key(message, wrong, 1)
        part = _one(talk.agents[key].parts) if key in talk.agents else ""
        reason = f"{wrong} takes part{f' as {part}' if part else ''}, which is not sent that"
        own = self._key(message, message.sender, 0)
        return self._deviation(talk, message, talk.agents[own], reason, is_sent=True)

    def _hear(
        self, talk: _Talk, message: Message, names: Sequence[str], kinds: tuple[Kind, ...], said: Said
    ) -> str | None:
        """Agents are sent a message; gives the first of them that cannot be meant."""
        wrong = None
        for name in names:
            key = self._key(message, name, 1)
            belief = talk.beliefs.heard(talk.agents.get(key, talk.start), kinds, said.senders, said.receivers)
            if belief is not None:
                talk.agents[key] = belief
            elif wrong is None:
                wrong = name
        return wrong

    def _again(self, talk: _Talk, message: Message) -> Deviation | None:
        """Another line about a message that was seen: only its receivers are new."""
        new = tuple(name for name in message.to if name not in talk.names[message.name])
        kinds, own = self._kinds_of(message, talk), self._key(message, message.sender, 0)
        belief = talk.agents.get(own)
        if not new or not kinds or belief is None:
            return None
        parts = frozenset(talk.beliefs.contract.parts)
        said = Said(belief, belief.parts, self._parts_of(talk, message) or parts)
        return self._heard(talk, message, kinds, said)

    def _same(self, talk: _Talk, message: Message) -> _Last | None:
        """What the sender has said last, if this line may be about the same message to another agent."""
        last = talk.last.get(message.sender)
        return last if last is not None and last.may_be(message) else None

    def _remember(self, talk: _Talk, message: Message, said: Said) -> None:
        last = talk.last.get(message.sender)
        to = message.to
        if last is not None and last.may_be(message):
            to = (*last.to, *to)
        talk.last[message.sender] = _Last(message, to, said)

    def _key(self, message: Message, agent: str, side: int) -> tuple[str, str]:
        """Where the belief about an agent is: a trace says in each line which participant it is there."""
        return (agent, message.parts[side]) if message.is_one else (agent, "")

    def _as(self, beliefs: Beliefs, belief: Belief, part: str) -> Belief:
        """The belief about an agent that plays this participant, if it is said and there is one."""
        if part in beliefs.contract.parts and belief.parts != {part}:
            return beliefs.narrowed(belief, frozenset((part,)))
        return belief

    def _parts_of(self, talk: _Talk, message: Message) -> frozenset[str]:
        """The participants that all the receivers may be."""
        contract = talk.beliefs.contract
        if message.parts[1] in contract.parts:
            return frozenset((message.parts[1],))
        found = frozenset(contract.parts)
        for name in message.to:
            belief = talk.agents.get(self._key(message, name, 1))
            if belief is not None:
                found &= belief.parts
        return found

    # ---- what is wrong ---------------------------------------------------------------------------

    def _too_many(self, beliefs: Beliefs, said: Said, message: Message) -> str | None:
        name = _one(said.receivers)
        most = beliefs.contract.parts[name].most if name else None
        if most is None or len(message.to) <= most:
            return None
        return f"the protocol has at most {most} {name}"

    def _why_not(
        self, talk: _Talk, message: Message, belief: Belief, kinds: tuple[Kind, ...], to: frozenset[str]
    ) -> str:
        beliefs = talk.beliefs
        everyone = frozenset(beliefs.contract.parts)
        if to != everyone and beliefs.said(belief, kinds, everyone, is_ours=message.is_one) is not None:
            others = ", ".join(sorted(to)) or "different participants"
            return f"it is not sent to {others}"
        part = _one(belief.parts)
        senders = {name for kind in kinds for name in beliefs.contract.said_by(kind)}
        if part and part not in senders:
            return f"{' or '.join(sorted(senders))} sends that, not {part}"
        if all(state == -1 for _, state, _ in belief.places):
            return "it has left the conversation before"
        return "the protocol does not allow it there"

    def _deviation(
        self, talk: _Talk, message: Message, belief: Belief | None, reason: str, *, is_sent: bool = False
    ) -> Deviation:
        talk.is_followed = False
        talk.sum.broken += 1
        contract = talk.beliefs.contract
        part = message.parts[0] or (_one(belief.parts) if belief is not None else "")
        span = contract.parts[part].span if part in contract.parts else contract.span
        shows = belief is not None and not is_sent
        allowed = talk.beliefs.sends(belief) if shows and belief is not None else ()
        awaited = talk.beliefs.awaits(belief) if shows and belief is not None else ()
        story = tuple(talk.story)
        return Deviation(message, part, reason, allowed, awaited, span, story, talk.count - len(story))


def _one(names: frozenset[str]) -> str:
    """The only one of some names; nothing if there are several."""
    return next(iter(names)) if len(names) == 1 else ""


__all__ = ["Deviation", "Message", "ProtocolSum", "Talks"]
