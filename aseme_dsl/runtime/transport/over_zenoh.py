"""The link over Eclipse Zenoh.

Its keys, each below `asemec/SYSTEM`:

    to/RECEIVER/SENDER/WAY     a message between two agents; WAY is TOPIC/KIND/MESSAGE, or `mail`, …
    here/AGENT/INCARNATION     a liveliness token: this agent is present; with a secret, `-PROOF` follows
    WHAT/AGENT                 questions: `history` and `control`
"""

from __future__ import annotations

import contextlib
import hmac
import itertools
import json
import os
import re
import secrets
import socket
import threading
import time
import weakref
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.heartbeats.addresses import own_addresses
from aseme_dsl.runtime.transport.link import NOBODY
from aseme_dsl.runtime.transport.meeting import Meeting, joining
from aseme_dsl.runtime.transport.port import TransportError
from aseme_dsl.runtime.transport.settings import LARGEST
from aseme_dsl.runtime.transport.stream import PATIENCE, Samples

if TYPE_CHECKING:
    from aseme_dsl.runtime.message.acl import FipaMessage
    from aseme_dsl.runtime.transport.link import Answer, Hears, Stamp
    from aseme_dsl.runtime.transport.settings import Network

MISSING = (
    'robots in several processes talk over Zenoh, which is not installed: pip install "aseme-dsl[zenoh]"'
)


QUESTIONS = ("history", "control")
_RUNTIME = "ZENOH_RUNTIME"
CLOSINGS = 3
MOST_THREADS = 32
"""Each part of zenoh has so many threads at most."""
_DESCRIPTORS = Path("/proc/self/fd")
_LIFE = re.compile("[0-9a-f]{1,16}")
_NONCE_BYTES = 16
FOLLOW = 1.0
"""So often, in seconds, it is looked whether absent agents are at other hosts now."""
_ASKERS = 256
"""Of so many sessions that have asked it is remembered which of their questions have come."""


def import_zenoh() -> Any:
    """The module. Raises TransportError, saying how to install it, where it is not."""
    try:
        import zenoh
    except ImportError as problem:
        raise TransportError(MISSING) from problem
    return zenoh


def meeting_settings(meeting: Meeting) -> Iterator[tuple[str, str]]:
    """The entries of zenoh's configuration by which a process takes part in a meeting on one machine."""
    yield "listen/endpoints", json.dumps([f"unixsock-stream/{meeting.own}"])
    yield "connect/endpoints", json.dumps([f"unixsock-stream/{path}" for path in meeting.others])
    yield "transport/link/protocols", '["unixsock-stream"]'


@contextmanager
def threads(robots: int) -> Iterator[None]:
    """Inside, zenoh begins with so many threads that no link of a team of so many waits for another one.

    When zenoh closes a TCP connection to a robot that does not acknowledge any more, its thread waits for
    10 s in the system call (SO_LINGER). All links of that thread wait with it. By default zenoh has one or
    two threads for all links (eclipse-zenoh/zenoh, issues 2718 and 1101). A link that breaks again and again
    is closed up to `CLOSINGS` times in these 10 s. Zenoh takes the number from its environment when it is
    first used in a process. A value that the user has set stays.
    """
    if _RUNTIME in os.environ:
        yield
        return
    number = min(MOST_THREADS, 2 + CLOSINGS * max(1, robots - 1))
    parts = ", ".join(f"{part}: (worker_threads: {number})" for part in ("rx", "tx", "net", "acc"))
    os.environ[_RUNTIME] = f"({parts})"
    try:
        yield
    finally:
        os.environ.pop(_RUNTIME, None)


class ZenohLink:
    """A Zenoh session of its own."""

    readable = False
    patience = PATIENCE
    largest = LARGEST

    def __init__(self, system: str, network: Network) -> None:
        """Raises TransportError if zenoh is not installed, or the settings do not fit."""
        self._zenoh = import_zenoh()
        self._system = system
        self._network = network
        self.lease = network.lease_ms * 1_000_000
        self._root = f"asemec/{system}"
        self._config = self._configured(network)
        try:
            known = {} if network.places is None else network.places()
        except ValueError as problem:
            raise TransportError(str(problem)) from problem
        self._further = tuple(end for end in network.connect if end not in known.values())
        """The endpoints that are not of robots."""
        self._secret: bytes | None = None
        """Who knows it is of the team; None where certificates say so."""
        self._asker = secrets.token_bytes(_NONCE_BYTES - 8)
        self._questions = itertools.count(1)
        self._askers: dict[bytes, Samples] = {}
        self._session: Any = None
        self._kept: list[Any] = []
        """References to our tokens and subscribers: zenoh withdraws a token that is garbage-collected."""
        self._publishers: dict[str, Any] = {}
        self._lock = threading.Lock()
        self._present: set[tuple[str, int]] = set()
        """The incarnations whose tokens are there."""
        self._opened: tuple[Sequence[str], int, Hears] | None = None
        """What `open` was given."""
        self._anew = 0.0
        """Until this moment no further session is begun for agents that bring nothing."""
        self._closed = threading.Event()
        self._opening = threading.Lock()
        """Held while a session is opened or closed after the first one."""

    def _configured(self, network: Network) -> Any:
        config = self._zenoh.Config()
        for key, value in network.settings():
            try:
                config.insert_json5(key, value)
            except self._zenoh.ZError as problem:
                raise TransportError(f"zenoh does not take {key} = {value}: {problem}") from problem
        return config

    @property
    def datagrams(self) -> Sequence[tuple[str, int]]:
        """The same addresses and port numbers as for TCP."""
        return own_addresses(self._network.listen)

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        """Connect and say that these agents are here."""
        self._opened = agents, incarnation, hears
        self._join(agents, incarnation, hears)
        if self._network.places is not None and not self._network.local:
            threading.Thread(
                target=self._follow,
                args=(self._network.places, agents, hears),
                name="aseme hosts",
                daemon=True,
            ).start()
        # A process that ends with a subscriber in it waits for ever, unless this runs before its threads
        # are waited for; `atexit` is too late for that.
        register = getattr(threading, "_register_atexit", None)
        if register is not None:
            closing = weakref.WeakMethod(self.close)  # what is registered stays until the process ends

            def close() -> None:
                still = closing()
                if still is not None:
                    still()

            with contextlib.suppress(RuntimeError):  # the interpreter is ending already
                register(close)

    def _follow(self, places: Callable[[], Mapping[str, str]], agents: Sequence[str], hears: Hears) -> None:
        """Connect to where absent agents are now. Zenoh connects to new endpoints only with a new session."""
        while not self._closed.wait(FOLLOW):
            try:
                found = places()
                there = {name for name, _ in tuple(self._present)}
                moved = [n for n, end in found.items() if n not in there and end not in self._network.connect]
                if not moved:
                    continue
                network = replace(self._network, connect=(*found.values(), *self._further))
                self._config, self._network = self._configured(network), network
                self._begin_anew(f"other hosts: {', '.join(moved)}")
            except (ValueError, TransportError) as problem:
                hears.fault(agents[0], str(problem))

    def _begin_anew(self, reason: str) -> None:
        """Begin with a new session."""
        assert self._opened is not None
        (mine, *_), _, hears = self._opened
        with self._opening:
            if self._closed.is_set():
                return
            self._leave()
            hears.disconnected(mine, reason)
            while True:
                try:
                    self._join(*self._opened)
                except TransportError as problem:
                    hears.fault(mine, str(problem))
                    if self._closed.wait(FOLLOW):
                        return
                else:
                    hears.connected(mine, "with a new session")
                    return

    def _join(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        zenoh = self._zenoh
        session = self._session = self.connected(agents[0])
        put = zenoh.SampleKind.PUT

        def arrived(sample: Any) -> None:
            _, _, _, to, *further = str(sample.key_expr).split("/")
            sender = further[0] if further else NOBODY
            attachment = sample.attachment
            data = b"" if attachment is None else attachment.to_bytes()
            payload = sample.payload.to_bytes()
            try:
                if self._secret is not None:
                    data = envelopes.unproven(data, payload, self._secret, f"{self._root} {to} {sender}")
                envelope = envelopes.read(data, payload)
            except EnvelopeError as problem:
                hears.unreadable(to, sender, str(problem))
            else:
                hears.arrived(to, sender, envelope, payload)

        def lives(sample: Any) -> None:
            *_, agent, life = str(sample.key_expr).split("/")
            life, _, proof = life.partition("-")
            if not _LIFE.fullmatch(life):
                agent, life = NOBODY, "0"
            elif not hmac.compare_digest(proof.encode(), self._token_proof(agent, int(life, 16)).encode()):
                if sample.kind == put:
                    hears.unreadable(agents[0], agent, "its token does not prove that it is of the team")
                return
            (self._present.add if sample.kind == put else self._present.discard)((agent, int(life, 16)))
            (hears.appeared if sample.kind == put else hears.vanished)(agent, int(life, 16))

        def asked(to: str, query: Any) -> None:
            *_, what, name = ("", *str(query.key_expr).split("/"))
            if name != to or what not in QUESTIONS:  # it asks for all that there is, say
                hears.unreadable(to, NOBODY, "it asks for nothing that there is")
                return
            question = b"" if query.payload is None else query.payload.to_bytes()
            mark = b"" if query.attachment is None else query.attachment.to_bytes()
            # Control has proofs of its own, and tells of each request.
            if self._secret is not None and what != "control":
                reason = self._improper(what, to, question, mark)
                if reason is not None:
                    hears.unreadable(to, NOBODY, reason)
                    return
            nonce = mark[:_NONCE_BYTES].hex()
            for envelope, payload in hears.asked(to, what, question):
                data = envelopes.written(envelope, payload)
                if self._secret is not None:
                    data = envelopes.proven(data, payload, self._secret, f"{self._root} {what} {to} {nonce}")
                query.reply(f"{self._root}/{what}/{to}", payload, attachment=data)

        for agent in agents:
            self._kept.append(session.declare_subscriber(f"{self._root}/to/{agent}/**", arrived))
            self._kept.append(session.declare_queryable(f"{self._root}/*/{agent}", partial(asked, agent)))
        liveliness = session.liveliness()
        self._kept.append(liveliness.declare_subscriber(f"{self._root}/here/*/*", lives, history=True))
        # Last: who sees the token may send at once.
        for agent in agents:
            self._kept.append(liveliness.declare_token(self.token(agent, incarnation)))

    def visit(self, name: str) -> None:
        """Connect only to ask questions, without announcing an agent. Raises TransportError."""
        self._session = self.connected(name)

    def token(self, agent: str, incarnation: int) -> str:
        """The key of the token that says that an agent is there."""
        proof = self._token_proof(agent, incarnation)
        return f"{self._root}/here/{agent}/{incarnation:x}{'-' if proof else ''}{proof}"

    def _token_proof(self, agent: str, incarnation: int) -> str:
        if self._secret is None:
            return ""
        return hmac.digest(self._secret, f"{self._root} {agent} {incarnation:x}".encode(), "sha256").hex()

    def connected(self, name: str) -> Any:
        """A session with the team; `name` says to people whose it is. Raises TransportError."""
        zenoh = self._zenoh
        with joining(self._system, name) if self._network.local else nullcontext() as meeting:
            if meeting is not None:
                self._secret = meeting.secret
                for key, value in meeting_settings(meeting):
                    self._config.insert_json5(key, value)
            try:
                with nullcontext() if meeting is not None else threads(len(self._network.team)):
                    return zenoh.open(self._config)
            except zenoh.ZError as problem:
                raise TransportError(f"the network cannot be used: {_first_line(problem)}") from problem

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        """Send something; it is dropped where the peer takes no more, and never waited for."""
        addressee, place, sample = stamp
        data = envelopes.written(envelope, payload, addressee=addressee, place=place, sample=sample)
        if self._secret is not None:
            data = envelopes.proven(data, payload, self._secret, f"{self._root} {to} {sender}")
        key = f"{self._root}/to/{to}/{sender}/{way}"
        publisher = self._publishers.get(key)
        if publisher is None:
            publisher = self._publisher(key, sure)
        if publisher is not None:
            with contextlib.suppress(self._zenoh.ZError):  # the session is being closed
                publisher.put(payload, attachment=data)

    def _publisher(self, key: str, sure: bool) -> Any:
        zenoh = self._zenoh
        with self._lock:
            if self._session is None:
                return None
            # Blocking would delay the whole team for one agent that does not read. The streams repeat dropped
            # messages, and limit what is on its way so that zenoh hardly ever drops one. It would if they
            # were `express`: each would fill one of the two places in its queue.
            found = self._publishers[key] = self._session.declare_publisher(
                key,
                congestion_control=zenoh.CongestionControl.DROP,
                priority=zenoh.Priority.INTERACTIVE_HIGH if sure else zenoh.Priority.DATA,
            )
            return found

    def renew(self, name: str, again: bool = False) -> None:
        """Shut down the TCP connections to the agent with this certificate; zenoh makes them again.

        Where a connection breaks while the one before it is still being closed, zenoh may keep one over which
        it sends nothing (eclipse-zenoh/zenoh, issue 1886). It has no call by which to end that.

        Sometimes it does not make a connection at all. Then one of the two sides begins with a new session:
        the one without a host, or the one whose name is the later in the alphabet.
        """
        if again and (self._network.seeks or self._network.robot > name):
            if time.monotonic() >= self._anew:  # else one is for several agents
                self._anew = time.monotonic() + self.lease / 1e9
                reason = f"{name} brings nothing"
                threading.Thread(
                    target=self._begin_anew, args=(reason,), name="aseme session", daemon=True
                ).start()
            return
        session = self._session
        if session is None or not _DESCRIPTORS.is_dir():
            return
        with contextlib.suppress(self._zenoh.ZError):
            links = [link for link in session.info.links() if link.auth_identifier == name]
            ends = {(_place(link.src), _place(link.dst)) for link in links}
            for descriptor in _DESCRIPTORS.iterdir() if ends else ():
                with contextlib.suppress(OSError), socket.socket(fileno=os.dup(int(descriptor.name))) as one:
                    if (one.getsockname()[:2], one.getpeername()[:2]) in ends:
                        one.shutdown(socket.SHUT_RDWR)

    def say(self, to: str, sender: str, message: FipaMessage) -> bool:
        """False: over Zenoh there is only the team."""
        return False

    def _improper(self, what: str, to: str, question: bytes, mark: bytes) -> str | None:
        """Why a question is not answered; None if it proves that it is one of the team's, and a new one."""
        nonce, proof = mark[:_NONCE_BYTES], mark[_NONCE_BYTES:]
        if not hmac.compare_digest(proof, self._question_proof(what, to, question, nonce)):
            return "a question does not prove that it is of the team"
        with self._lock:
            asker = nonce[:-8]
            known = self._askers.get(asker)
            if known is None:
                while len(self._askers) >= _ASKERS:
                    del self._askers[next(iter(self._askers))]
                known = self._askers[asker] = Samples()
            if known.take(int.from_bytes(nonce[-8:], "big")) is None:
                return "a question came twice"
        return None

    def _question_proof(self, what: str, to: str, question: bytes, nonce: bytes) -> bytes:
        assert self._secret is not None
        head = f"question {len(question)} {self._root} {what} {to} ".encode()
        return envelopes.mac(self._secret, head, nonce, question)

    def ask(
        self, to: str, what: str, question: bytes, timeout: float, life: int | None = None
    ) -> list[Answer]:
        """Put a question and wait for the answers."""
        zenoh = self._zenoh
        session = self._session
        if session is None:
            return []
        nonce = self._asker + next(self._questions).to_bytes(8, "big")
        mark = nonce
        if self._secret is not None:
            mark += self._question_proof(what, to, question, nonce)
        try:
            replies = session.get(
                f"{self._root}/{what}/{to}",
                payload=question,
                attachment=mark,
                timeout=timeout,
                # By default zenoh asks only one queryable that claims to be complete, if there is one.
                target=zenoh.QueryTarget.ALL,
                # Otherwise of several answers on one key only the last one is kept.
                consolidation=zenoh.ConsolidationMode.NONE,
            )
        except zenoh.ZError:  # the session is being closed
            return []
        found: list[Answer] = []
        pieces = 0
        for reply in replies:
            if reply.ok is not None and reply.ok.attachment is not None:
                payload = reply.ok.payload.to_bytes()
                data = reply.ok.attachment.to_bytes()
                try:
                    if self._secret is not None:
                        way = f"{self._root} {what} {to} {nonce.hex()}"
                        data = envelopes.unproven(data, payload, self._secret, way)
                    envelope = envelopes.read(data, payload)
                except EnvelopeError as problem:
                    if self._secret is not None:
                        continue  # the answer of an untrusted sender
                    raise TransportError(f"the answer of {to} cannot be read: {problem}") from problem
                if life is None or envelope.incarnation == life:
                    found.append((envelope, payload))
                    if envelope.kind == envelopes.ACKNOWLEDGE:
                        pieces = envelope.upto
                    if len(found) == pieces:  # others may hold the question until its time is over
                        break
        return found

    def close(self) -> None:
        """Disconnect."""
        self._closed.set()
        with self._opening:
            self._leave()

    def _leave(self) -> None:
        with self._lock:
            session, self._session = self._session, None
            self._publishers.clear()
        if session is not None:
            session.close()
        self._kept.clear()
        self._present.clear()


def _place(locator: object) -> tuple[str, int]:
    """The address and port of one end of a link."""
    host, _, port = str(locator).partition("/")[2].partition("#")[0].partition("?")[0].rpartition(":")
    return host.strip("[]"), int(port)


def _first_line(problem: Exception) -> str:
    return str(problem).partition("\n")[0]
