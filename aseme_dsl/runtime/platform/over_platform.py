"""The link over an agent platform: messages travel as notes, and processes announce their own presence.

A process sends its incarnation and its agents' addresses to all other processes of the team, and repeats this
`BEATS` times in each lease. A process that is silent for a lease counts as unreachable. The link looks for an
agent that has not announced itself at the fixed address of that agent. Notes from an address outside the team
are handed on as messages of external agents.
"""

from __future__ import annotations

import contextlib
import itertools
import json
import threading
import time
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, performative_of
from aseme_dsl.runtime.platform import acl_headers
from aseme_dsl.runtime.platform.acl_headers import OURS
from aseme_dsl.runtime.platform.platform import Headers, Platform
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.link import Answer, Stamp

if TYPE_CHECKING:
    from aseme_dsl.runtime.message.acl import FipaMessage
    from aseme_dsl.runtime.transport.link import Hears

PATIENCE = 3_000_000_000
"""After how many ns something is sent again: a platform loses nothing while its connections last."""
LEASE = 4.0
"""How long, in seconds, a process may be silent before its agents count as gone."""
BEATS = 4
"""So often in a lease a process says that it is there."""
FIRST, LAST = 0.25, 4.0
"""Seconds after which the link looks again for an agent that has not announced itself: first, and longest."""


@dataclass(frozen=True, slots=True)
class _Known:
    """Where an agent elsewhere is, and which incarnation it is."""

    life: int
    address: str


@dataclass(slots=True)
class _Question:
    """A question that was put; its answers so far."""

    answers: list[Answer] = field(default_factory=list)
    over: threading.Event = field(default_factory=threading.Event)


class PlatformLink:
    """A link over a platform, for the agents of one process."""

    readable = True
    patience = PATIENCE
    datagrams = ()
    lease = None

    def __init__(self, platform: Platform, system: str, team: Sequence[str], lease: float = LEASE) -> None:
        """`team` are the names of all its agents."""
        self.largest = platform.largest
        self._platform = platform
        self._system = system
        self._team = tuple(team)
        self._lease = lease
        self._agents: tuple[str, ...] = ()
        self._life = 0
        self._hears: Hears
        self._known: dict[str, _Known] = {}
        self._heard: dict[int, float] = {}
        """When something came from an incarnation last."""
        self._asked_at: dict[str, tuple[float, float]] = {}
        """When an agent is asked for next, and how long it is waited after that."""
        self._questions: dict[str, _Question] = {}
        self._early: deque[tuple[str, str, Headers, str]] | None = deque()
        """What comes before all are connected; None afterwards. Who hears it may wait until then."""
        self._numbers = itertools.count(1)
        self._lock = threading.RLock()
        self._over = threading.Event()
        self._thread: threading.Thread | None = None

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        """Connect, and ask for the others."""
        self._agents, self._life, self._hears = tuple(agents), incarnation, hears
        self._platform.start(self._agents, self)
        now = time.monotonic()
        self._asked_at = {name: (now, FIRST) for name in self._team if name not in self._agents}
        self._thread = threading.Thread(target=self._beat, name="aseme presence", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Take leave, and disconnect."""
        if self._thread is None:
            return
        self._over.set()
        self._thread.join()
        for address in self._processes().values():
            self._note(address, {"bye": self._life})
        self._platform.close()

    # ---- messages ----------------------------------------------------------------------------

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        """Send something to where its receiver is, if that is known."""
        known = self._known.get(to)
        if known is not None:
            headers = acl_headers.letter(envelope, stamp, payload, sender, self._system)
            self._platform.send(sender, known.address, headers, payload.decode(), kept=False)

    def renew(self, name: str, again: bool = False) -> None:
        """The platform does that."""

    def say(self, to: str, sender: str, message: FipaMessage) -> bool:
        """Send a message to the external agent at the address `to`; False if `to` is not an address."""
        if not self._platform.is_address(to):
            return False
        headers, body = acl_headers.said(message)
        self._platform.send(sender, to, headers, body, kept=True)
        return True

    def came(self, to: str, origin: str, headers: Headers, body: str) -> None:
        """A note has come for one of our agents. Raises nothing: a platform may hear no other after that."""
        if self._early is not None:
            with self._lock:
                if self._early is not None:
                    self._early.append((to, origin, headers, body))
                    return
        sender = self._platform.agent_at(origin)
        try:
            if sender is None or OURS not in headers:
                self._came_from_outside(to, origin, headers, body)
                return
            said = acl_headers.ours(headers)
            if "kind" in said:
                envelope = acl_headers.read_letter(said, headers, body.encode(), self._system)
                self._heard_of(envelope.incarnation)
                self._hears.arrived(to, sender, envelope, body.encode())
            else:
                self._heed(to, origin, said, headers, body)
        except EnvelopeError as problem:
            self._hears.unreadable(to, sender or origin, str(problem))
        except Exception as problem:
            self._hears.unreadable(to, sender or origin, f"{type(problem).__name__}: {problem}")

    def _came_from_outside(self, to: str, origin: str, headers: Headers, body: str) -> None:
        name = self._platform.name_at(origin)
        if OURS not in headers:
            self._hears.outside(to, acl_headers.heard(name, to, headers, body))
            return
        # An untrusted sender imitates the team: from its own address, or with a copy of a message.
        self._hears.unreadable(to, name, "it is none of the team's")
        if performative_of(headers.get("performative", "")) not in (NOT_UNDERSTOOD, None):
            answer = {"performative": "not-understood", "conversation-id": headers.get("conversation-id", "")}
            answer |= {"in-reply-to": headers.get("reply-with", ""), "language": "json"}
            reason = json.dumps({"reason": f"{name} is none of the team, and speaks as if it were"})
            self._platform.send(to, origin, answer, reason, kept=True)

    def returned(self, agent: str, address: str, name: str, reason: str) -> None:
        """What one of our agents sent to an external agent was not delivered."""
        if self._platform.agent_at(address) is None:
            self._hears.returned(agent, self._platform.name_at(address), name, reason)

    # ---- who is there ------------------------------------------------------------------------

    def _beat(self) -> None:
        """Say that we are there, and find out who is not any more."""
        with self._lock:
            early, self._early = self._early or (), None
            for note in early:
                self.came(*note)
        said = 0.0
        while not self._over.wait(FIRST):
            now = time.monotonic()
            if now - said >= self._lease / BEATS:
                said = now
                self._say_here()
                for life in [life for life, heard in tuple(self._heard.items()) if now - heard > self._lease]:
                    self._gone(life)
            self._ask_for_others(now)

    def _say_here(self) -> None:
        for address in self._processes().values():
            self._note(address, self._here())

    def _here(self, **members: object) -> dict[str, object]:
        return {"here": self._platform.here(), "life": self._life, **members}

    def _ask_for_others(self, now: float) -> None:
        for name, (due, pause) in tuple(self._asked_at.items()):
            if name not in self._known and due <= now:
                self._asked_at[name] = (now + pause, min(LAST, 2 * pause))
                self._note(self._platform.address_of(name), self._here(asked=True))

    def _processes(self) -> dict[int, str]:
        """An address in each other process, by its incarnation."""
        with self._lock:
            return {known.life: known.address for known in reversed(tuple(self._known.values()))}

    def _note(
        self, address: str, said: Mapping[str, object], body: str = "", sender: str | None = None
    ) -> None:
        headers = {"performative": "inform", "protocol": acl_headers.PROTOCOL, OURS: json.dumps(said)}
        self._platform.send(sender or self._agents[0], address, headers, body, kept=False)

    def _heard_of(self, life: int) -> None:
        if life in self._heard:
            self._heard[life] = time.monotonic()

    def _heed(self, to: str, origin: str, said: Mapping[str, object], headers: Headers, body: str) -> None:
        """Something that links say to each other."""
        here, life = said.get("here"), said.get("life")
        if isinstance(here, dict) and isinstance(life, int):
            self._there(here, life, origin, answered="asked" in said)
        elif "bye" in said:
            if isinstance(bye := said["bye"], int):
                self._gone(bye)
        elif isinstance(said.get("question"), str) and isinstance(said.get("what"), str):
            arguments = (to, origin, said["question"], said["what"], body)
            threading.Thread(target=self._answer, args=arguments, name="aseme answer", daemon=True).start()
        elif isinstance(said.get("answer"), str):
            self._take_answer(said, headers, body)
        else:
            raise EnvelopeError("it says nothing that is understood")

    def _there(self, here: Mapping[str, object], life: int, origin: str, *, answered: bool) -> None:
        """A process says that it is there, with its agents and their addresses."""
        news: list[str] = []
        with self._lock:
            fresh = life not in self._heard
            self._heard[life] = time.monotonic()
            for name, address in here.items():
                if not isinstance(address, str) or self._platform.agent_at(address) != name:
                    raise EnvelopeError(f"it says that {name} is at {address}, where it is not")
                known = self._known.get(name)
                if known is not None and known.life > life and known.life in self._heard:
                    continue  # it is of an incarnation that another has followed
                self._known[name] = _Known(life, address)
                if known != self._known[name]:
                    news.append(name)  # also of a new address: what went to the old one is lost
        if fresh or answered:
            self._platform.meet(origin)
            self._note(origin, self._here())
        for name in news:
            self._hears.appeared(name, life)

    def _gone(self, life: int) -> None:
        """The process of an incarnation is not there any more."""
        with self._lock:
            self._heard.pop(life, None)
            gone = [name for name, known in self._known.items() if known.life == life]
            for name in gone:
                self._lose(name)
        for name in gone:
            self._hears.vanished(name, life)

    def _lose(self, name: str) -> None:
        """An agent is to be asked for again. Called with the lock."""
        del self._known[name]
        if name in self._asked_at:
            self._asked_at[name] = (time.monotonic(), FIRST)

    def unreachable(self, address: str) -> None:
        """The agents at this address are no longer reachable."""
        with self._lock:
            gone = [(name, known.life) for name, known in self._known.items() if known.address == address]
            for name, life in gone:
                self._lose(name)
                if not any(known.life == life for known in self._known.values()):
                    self._heard.pop(life, None)
        for name, life in gone:
            self._hears.vanished(name, life)

    def disconnected(self, agent: str, reason: str) -> None:
        """Hand on what people should know."""
        self._hears.disconnected(agent, reason)

    def connected(self, agent: str, reason: str) -> None:
        """One of our agents has another address: announce it to the team, and look for all agents again."""
        self._hears.connected(agent, reason)
        if not self._over.is_set():
            self._say_here()
            now = time.monotonic()
            self._asked_at = {name: (now, FIRST) for name in self._asked_at}

    # ---- questions ---------------------------------------------------------------------------

    def ask(
        self, to: str, what: str, question: bytes, timeout: float, life: int | None = None
    ) -> list[Answer]:
        """Put a question and wait for the answers."""
        known = self._known.get(to)
        if known is None:
            return []
        name = f"{self._life:x}-{next(self._numbers)}"
        put = self._questions[name] = _Question()
        try:
            self._note(known.address, {"question": name, "what": what}, question.decode())
            put.over.wait(timeout)
            return [answer for answer in put.answers if life in (None, answer[0].incarnation)]
        finally:
            del self._questions[name]

    def _answer(self, to: str, origin: str, name: str, what: str, question: str) -> None:
        """Answer a question; in a thread of its own, since that may take long."""
        for envelope, payload in self._hears.asked(to, what, question.encode()):
            headers = dict(acl_headers.letter(envelope, Stamp(), payload, to, self._system))
            headers[OURS] = json.dumps({"answer": name, "envelope": json.loads(headers[OURS])})
            self._platform.send(to, origin, headers, payload.decode(), kept=False)
        self._note(origin, {"answer": name}, sender=to)

    def _take_answer(self, said: Mapping[str, object], headers: Headers, body: str) -> None:
        put = self._questions.get(str(said["answer"]))
        if put is None:
            return  # the question has timed out
        envelope = said.get("envelope")
        if envelope is None:
            put.over.set()
        elif isinstance(envelope, dict):
            with contextlib.suppress(EnvelopeError):  # the question is then answered without it
                payload = body.encode()
                put.answers.append(
                    (acl_headers.read_letter(envelope, headers, payload, self._system), payload)
                )
