"""Heartbeats: the thread that sends and receives them, and what it knows of each agent elsewhere.

Each agent sends each other one a datagram in each period, and says in it which one of the other is the newest
that it has. So an answer proves that at a moment of our clock the other one could hear us, and we it. Of a
link that works in one direction only, neither side has such proofs.

A datagram over UDP is lost or arrives. So it waits neither for what was lost before it, as over TCP, nor for
other links. Its sender must know a key, which the receiver gives to it over the link.
"""

from __future__ import annotations

import contextlib
import hmac
import secrets
import selectors
import socket
import threading
import time
from collections.abc import Callable, Sequence

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.transport.heartbeats.datagram import (
    ASKING,
    BEAT,
    FAREWELL,
    KEY_BYTES,
    SIZE,
    TAG_BYTES,
    Address,
    Beat,
    Introduction,
    introduced,
    introduction_in,
    read,
    tag_of,
    written,
)
from aseme_dsl.runtime.transport.port import TransportError

BEATS = 20
"""So many heartbeats are sent in each lease."""
SHORTEST = 5_000_000
"""A period has at least so many ns."""
HURRIED = 4
"""So many times as often heartbeats go to an agent that is doubted."""
MOST = 1000
"""So many datagrams are looked at in a period; what comes beyond that is lost, if anything is."""

Flow = tuple[str, str]
"""From one of our agents to one elsewhere."""


@dataclass(slots=True)
class _Peer:
    """An agent elsewhere, in one incarnation, as one of ours knows it."""

    life: int
    given: Introduction
    """By which it sends heartbeats to us."""
    known: Introduction | None = None
    """By which we send some to it."""
    source: tuple[socket.socket, tuple[object, ...]] | None = None
    """From where its newest one came, and on which socket."""
    newest: int = 0
    """When that was sent, in ns of its clock."""
    sent: int = 0
    """When the newest one of ours was sent."""
    asking: bool = False
    """Whether it is unreachable, or doubted: it shall answer at once."""
    hurried: bool = False
    """Whether it is doubted: it is asked more often."""


class Heartbeats:
    """The heartbeats between the agents of this process and those elsewhere."""

    def __init__(
        self,
        addresses: Sequence[Address],
        lease: int,
        heard: Callable[[str, int, int], None],
        parted: Callable[[str, int], None],
    ) -> None:
        """Begin to listen at these addresses; `start` lets it begin.

        A thread of its own calls the callbacks, which must not wait: `heard(name, life, moment)` when an
        agent has proven that it heard us at a moment of our monotonic clock. `parted(name, life)` is called
        when it has said farewell.

        Raises:
            TransportError: an address cannot be used.
        """
        self.period = max(SHORTEST, lease // BEATS)
        self.refused = 0
        """How many datagrams have come that are not heartbeats, or were not made with their key."""
        self.late = 0
        """How many have come that are for an earlier incarnation, or came before."""
        self._heard, self._parted = heard, parted
        self._secret = secrets.token_bytes(KEY_BYTES)
        self._lock = threading.Lock()
        self._peers: dict[Flow, _Peer] = {}
        self._tags: dict[bytes, Flow] = {}
        self._sockets = list(_bound(addresses))
        self.addresses: tuple[Address, ...] = tuple(one.getsockname()[:2] for one in self._sockets)
        self._waker, self._woken = socket.socketpair()
        self._waker.setblocking(False)
        self._ending = False
        self._thread = threading.Thread(target=self._run, name="aseme heartbeats", daemon=True)

    def start(self) -> None:
        self._thread.start()

    def introduction(self, mine: str, name: str, life: int) -> bytes:
        """What an incarnation of an agent elsewhere needs to send heartbeats to one of ours."""
        with self._lock:
            return introduced(self._peer(mine, name, life).given)

    def learn(self, mine: str, name: str, life: int, data: bytes) -> None:
        """Take the introduction of an incarnation of an agent elsewhere."""
        known = introduction_in(data)
        if known is None:
            return
        with self._lock:
            peer = self._peer(mine, name, life)
            is_new = peer.known is None
            peer.known = known
        if is_new:
            self._wake()

    def ask(self, name: str, asking: bool, hurried: bool = False) -> None:
        """Whether an agent elsewhere shall answer at once, and whether it is asked more often."""
        with self._lock:
            for (_, other), peer in self._peers.items():
                if other == name:
                    peer.asking, peer.hurried = asking, hurried
        if asking:
            self._wake()

    def close(self) -> None:
        """Say farewell, and end."""
        self._ending = True
        self._wake()
        if self._thread.ident is not None:
            self._thread.join()
        for one in (*self._sockets, self._waker, self._woken):
            one.close()

    def _peer(self, mine: str, name: str, life: int) -> _Peer:
        """An incarnation of an agent elsewhere; called with the lock."""
        found = self._peers.get((mine, name))
        if found is not None and found.life == life:
            return found
        if found is not None:
            self._tags.pop(found.given.tag, None)
        secret = hmac.digest(self._secret, f"{mine} {name} {life:x}".encode(), "sha256")
        tag = hmac.digest(secret, b"tag", "sha256")[:TAG_BYTES]
        made = self._peers[mine, name] = _Peer(life, Introduction(tag, secret, self.addresses))
        self._tags[tag] = mine, name
        return made

    def _wake(self) -> None:
        with contextlib.suppress(OSError):
            self._waker.send(b" ")

    def _run(self) -> None:
        with selectors.DefaultSelector() as selector:
            for one in (*self._sockets, self._woken):
                one.setblocking(False)
                selector.register(one, selectors.EVENT_READ)
            due = time.monotonic_ns()
            left = MOST
            while not self._ending:
                now = time.monotonic_ns()
                if now >= due:
                    due, left = now + self._beat(now), MOST
                for key, _ in selector.select(max(0, due - time.monotonic_ns()) / 1e9 if left else 0):
                    if key.fileobj is self._woken:
                        self._woken.recv(4096)
                        due = 0
                    elif isinstance(key.fileobj, socket.socket):
                        left -= self._receive(key.fileobj, left)
                if not left:
                    time.sleep(max(0, due - time.monotonic_ns()) / 1e9)
        for _ in range(2):  # one may be lost
            self._beat(time.monotonic_ns(), FAREWELL)

    def _beat(self, now: int, kind: int | None = None) -> int:
        """Send what is due; in how many ns something is due again."""
        with self._lock:
            peers = list(self._peers.values())
        hurried = self.period // HURRIED
        for peer in peers:
            pause = hurried if peer.hurried else self.period
            if kind is not None or now - peer.sent >= pause - hurried // 2:
                self._send(peer, (ASKING if peer.asking else BEAT) if kind is None else kind)
        return hurried if any(peer.hurried for peer in peers) else self.period

    def _send(self, peer: _Peer, kind: int) -> None:
        known = peer.known
        if known is None:
            return
        peer.sent = max(peer.sent + 1, time.monotonic_ns())
        data = written(Beat(kind, known.tag, peer.sent, peer.newest), known.key)
        targets = []
        if peer.source is not None:
            targets.append(peer.source)
        if peer.source is None or peer.asking:
            for address in known.addresses:
                six = ":" in address[0]
                for one in self._sockets:
                    if (one.family == socket.AF_INET6) == six:
                        targets.append((one, address))
                        break
        for one, target in targets:
            with contextlib.suppress(OSError):  # there is no way to it now
                one.sendto(data, target)

    def _receive(self, one: socket.socket, most: int) -> int:
        """Take what has come; how many datagrams that were."""
        for number in range(most):
            try:
                data, source = one.recvfrom(SIZE + 1)
            except BlockingIOError:
                return number
            except OSError:  # what was sent before could not be delivered
                continue
            self._take(data, (one, source))
        return most

    def _take(self, data: bytes, source: tuple[socket.socket, tuple[object, ...]]) -> None:
        tag = tag_of(data)
        if tag is None:
            self.refused += 1
            return
        flow = self._tags.get(tag)
        if flow is None:  # who made it does not know that we have been started again, say
            self.late += 1
            return
        peer = self._peers[flow]
        beat = read(data, peer.given.key)
        if beat is None:
            self.refused += 1
            return
        if beat.sent <= peer.newest:
            self.late += 1
            return
        peer.newest, peer.source = beat.sent, source
        if beat.kind == FAREWELL:
            self._parted(flow[1], peer.life)
            return
        if 0 < beat.heard <= peer.sent:
            self._heard(flow[1], peer.life, beat.heard)
        if beat.kind == ASKING:
            self._send(peer, ASKING if peer.asking and beat.heard != peer.sent else BEAT)


def _bound(addresses: Sequence[Address]) -> Sequence[socket.socket]:
    found: list[socket.socket] = []
    for host, port in addresses:
        one = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM)
        try:
            one.bind((host, port))
        except OSError as problem:
            for other in (one, *found):
                other.close()
            raise TransportError(
                f"heartbeats cannot be received at {host}, UDP port {port}: {problem.strerror}"
            ) from problem
        found.append(one)
    return found
