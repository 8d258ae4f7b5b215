"""The platform SPADE: every agent is a SPADE agent with an account of its own on an XMPP server.

All agents of a process are on SPADE's one event loop, in a thread of its own: what activities do in their
threads holds up none of them. A connection that is lost is made again, after pauses that double; SPADE itself
would let its agents believe that they are connected, and drop what they send.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import logging
import random
import threading
import time
from collections import deque
from collections.abc import Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.platform import stanza
from aseme_dsl.runtime.platform.platform import Headers, Refused
from aseme_dsl.runtime.transport.port import TransportError

if TYPE_CHECKING:
    from aseme_dsl.runtime.platform.platform import Receives
    from aseme_dsl.runtime.transport.settings import Xmpp

MISSING = 'SPADE is not installed, or not whole ({}): pip install "aseme-dsl[spade]"'
START, EACH = 30.0, 2.0
"""How long, in seconds, the server may take to be there when a robot begins, and longer for each agent."""
AT_ONCE = 3
"""So many agents of a process connect at once: each takes a server some hundred ms, for its password."""
FIRST, CONNECT = 5.0, 20.0
"""How long, in seconds, the first attempt to connect may take, and any: servers forget one now and then."""
SHORTEST, LONGEST = 0.1, 5.0
"""After how many seconds it is tried again, at first and at most."""
UNSENT = 4_000_000
"""While so many bytes wait to be sent, what is not kept is dropped."""
KEPT = 1000
"""So many notes wait at the most for a connection; then the oldest comes back."""
LARGEST = 150_000
"""Largest message, in bytes: Prosody closes a connection on which a client sends more than 256 kB at once."""


def import_spade() -> object:
    """The module. Raises TransportError, saying how to install it, where it is not (or not all it needs)."""
    try:
        import greenlet  # which SPADE needs, and does not ask for
        import spade.agent
    except Exception as problem:  # SQLAlchemy raises a ValueError of its own
        raise TransportError(MISSING.format(problem)) from problem
    del greenlet
    for name in ("slixmpp", "spade"):  # the trace records connections that fail
        logging.getLogger(name).addHandler(logging.NullHandler())
    return spade


class SpadePlatform:
    """The SPADE agents of one process."""

    name = "SPADE"
    largest = LARGEST

    def __init__(self, settings: Xmpp, team: Sequence[str]) -> None:
        """`team` are all its agents.

        Raises TransportError if SPADE is missing, or if two agents would have one account.
        """
        import_spade()
        self._settings = settings
        self._accounts = {name: settings.account_of(name) for name in team}
        self._agents_at: dict[str, str] = {}
        for name, account in self._accounts.items():
            other = self._agents_at.setdefault(self._bare(account), name)
            if other != name:
                raise TransportError(
                    f"{other} and {name} would have one account, {self._bare(account)}: XMPP does not tell"
                    " capital letters from small ones"
                )
        self._connections: dict[str, _Connection] = {}
        self._receives: Receives

    def _bare(self, account: str) -> str:
        return f"{account}@{self._settings.domain}".lower()

    def start(self, agents: Sequence[str], receives: Receives) -> None:
        """Connect all, and wait until they are."""
        self._receives = receives
        _LOOP.enter()
        until = time.monotonic() + START + EACH * len(agents)
        self._connections = {
            name: _Connection(name, self._bare(self._accounts[name]), self._settings, receives)
            for name in agents
        }
        for connection in self._connections.values():
            connection.begin()
        for connection in self._connections.values():
            if not connection.ready.wait(max(0.0, until - time.monotonic())) or connection.refusal:
                reason = connection.refusal or connection.problem or "it does not answer"
                self.close()
                raise TransportError(
                    f"{connection.agent} cannot be connected with the XMPP server"
                    f" {self._settings.host}:{self._settings.port}: {reason}"
                )

    def address_of(self, agent: str) -> str:
        """The address of the agent's account: each client that is connected to it receives the note."""
        return self._bare(self._accounts[agent])

    def agent_at(self, address: str) -> str | None:
        """Which of the team has this account; the server vouches for it."""
        return self._agents_at.get(address.partition("/")[0].lower())

    def is_address(self, text: str) -> bool:
        """Whether it is written like an account: name@domain."""
        name, _, domain = text.partition("@")
        return bool(name and domain)

    def name_at(self, address: str) -> str:
        """The account."""
        return address.partition("/")[0]

    def here(self) -> dict[str, str]:
        """Where each of our agents is connected."""
        return {name: item.address for name, item in self._connections.items() if item.address is not None}

    def send(self, sender: str, address: str, headers: Headers, body: str, *, kept: bool) -> None:
        """Send a note. A note that is not `kept` is an XMPP headline, which no server stores for later."""
        if kept:
            name = headers.get("reply-with", "")
            text = stanza.written(address, headers, body, "chat", name)
            self._connections[sender].send(text, (address, name))
        else:
            self._connections[sender].send(stanza.written(address, headers, body, "headline"), None)

    def meet(self, address: str) -> None:
        """Show ourselves to it: the server then tells it when we are unreachable (RFC 6121, section 4.6)."""
        to = quoteattr(address)
        for connection in self._connections.values():
            connection.send(f"<presence to={to}/>", None)

    def close(self) -> None:
        """Disconnect all."""
        connections, self._connections = self._connections, {}
        for connection in connections.values():
            connection.end()
        for connection in connections.values():
            connection.over.wait(3.0)
        if connections:
            _LOOP.leave()


@dataclass(slots=True)
class _Kept:
    """A note that waits for a connection, and whom to tell of it if that is in vain."""

    text: str
    about: tuple[str, str]


@dataclass(eq=False)
class _Connection:
    """One agent's connection. Its methods are called from any thread, the coroutines run on SPADE's loop."""

    agent: str
    account: str
    settings: Xmpp
    receives: Receives
    address: str | None = None
    """The full JID while there is a connection."""
    problem: str = ""
    """Why the last attempt failed."""
    refusal: str = ""
    """Why no further attempt would succeed."""
    ready: threading.Event = field(default_factory=threading.Event)
    over: threading.Event = field(default_factory=threading.Event)

    def __post_init__(self) -> None:
        self._out: deque[str] = deque()
        self._kept: deque[_Kept] = deque()
        self._scheduled = False
        self._lock = threading.Lock()
        self._spade: Any = None
        self._numbers = itertools.count(1)
        self._ending = False
        self._keeper: Any = None

    def begin(self) -> None:
        """Connect, and stay connected."""
        self._keeper = asyncio.run_coroutine_threadsafe(self._keep(), _LOOP.loop)

    def end(self) -> None:
        """Disconnect."""
        self._ending = True
        asyncio.run_coroutine_threadsafe(self._stop(), _LOOP.loop)

    # ---- sending -----------------------------------------------------------------------------

    def send(self, text: str, kept: tuple[str, str] | None) -> None:
        """Send a stanza; it waits for a connection if it is `kept`: for that address, under that name."""
        with self._lock:
            if self._ending:
                return
            if kept is not None:
                self._kept.append(_Kept(text, kept))
            elif self.address is not None:
                self._out.append(text)
            else:
                return
            if self._scheduled:
                return
            self._scheduled = True
        if threading.get_ident() == _LOOP.thread:
            _LOOP.loop.call_soon(self._flush)  # an answer to what has just come
        else:
            _LOOP.loop.call_soon_threadsafe(self._flush)

    def _flush(self) -> None:
        """Send what waits, all at once."""
        gone: list[_Kept] = []
        with self._lock:
            self._scheduled = False
            transport = self._spade.client.transport if self.address is not None else None
            pieces = list(self._out)
            self._out.clear()
            if transport is not None:
                if transport.get_write_buffer_size() > UNSENT:
                    pieces.clear()
                pieces += [item.text for item in self._kept]
                self._kept.clear()
            else:
                pieces.clear()
                while len(self._kept) > KEPT:
                    gone.append(self._kept.popleft())
        if transport is not None and pieces:
            transport.write("".join(pieces).encode())
        for item in gone:
            self.receives.returned(
                self.agent, *item.about, "there is no connection, and too many wait for it"
            )

    # ---- hearing -----------------------------------------------------------------------------

    def heard(self, xml: Any) -> bool:
        """A stanza has come; whether it is ours to handle."""
        origin = xml.get("from") or ""
        if xml.tag == stanza.MESSAGE:
            if xml.get("type") == "error":
                name, reason = xml.get("id"), stanza.condition(xml)
                if name:
                    self.receives.returned(self.agent, origin, name, reason)
                self.receives.unreachable(origin)
                return True
            headers, body = stanza.read(xml)
            if headers or body:
                self.receives.came(self.agent, origin, headers, body)
            return True
        if xml.tag == stanza.PRESENCE and xml.get("type") == "unavailable" and origin != self.address:
            self.receives.unreachable(origin)
        return False

    # ---- the connection ----------------------------------------------------------------------

    async def _keep(self) -> None:
        try:
            pause, patience, told = SHORTEST, FIRST, False
            while not self._ending:
                try:
                    async with _LOOP.turn():
                        await asyncio.wait_for(self._connect(), patience)
                except Exception as problem:  # also of SPADE, slixmpp and OpenSSL: it is tried again
                    self.problem = str(problem) or type(problem).__name__
                    await self._drop()
                    if isinstance(problem, Refused) and not self.ready.is_set():
                        self.refusal = self.problem
                        self.ready.set()
                        return
                    await asyncio.sleep(pause * random.uniform(0.7, 1.3))
                    pause, patience = min(LONGEST, 2 * pause), min(CONNECT, 2 * patience)
                    continue
                pause, patience = SHORTEST, FIRST
                self.ready.set()
                if told:
                    self.receives.connected(self.agent, self._server)
                self._flush()
                reason = await self._spade.client.watch()
                self.address = None
                await self._drop()
                if not self._ending:
                    told = True
                    self.receives.disconnected(self.agent, f"{self._server}: {reason}")
        finally:
            self.over.set()

    @property
    def _server(self) -> str:
        return f"the XMPP server {self.settings.host}:{self.settings.port}"

    async def _connect(self) -> None:
        """One attempt. Raises Refused where a further one would fail, too."""
        import_spade()
        from aseme_dsl.runtime.platform.spade_agent import SpadeAgent

        jid = f"{self.account}/aseme-{time.time_ns():x}-{next(self._numbers)}"
        self._spade = SpadeAgent(jid, self)
        await self._spade.start(self.settings.register)
        self.address = self._spade.client.boundjid.full

    async def _drop(self) -> None:
        """Give up the connection that there is, if there is one."""
        agent = self._spade
        if agent is None:
            return
        agent._alive.clear()
        agent.container.unregister(str(agent.jid))
        if agent.client is not None:
            agent.client.give_up()

    async def _stop(self) -> None:
        self._flush()
        agent = self._spade
        if agent is not None and agent.client is not None and agent.client.transport is not None:
            with contextlib.suppress(Exception):
                await asyncio.wait_for(agent.client.disconnect(wait=0.5), 1.0)
        self.address = None
        await self._drop()
        if self._keeper is not None:
            self._keeper.cancel()
        self.over.set()


class _Loop:
    """SPADE's event loop, which all agents of a process share, in a thread of its own while it is needed."""

    def __init__(self) -> None:
        self._users = 0
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        self._turns: asyncio.Semaphore | None = None
        self.thread = 0
        """Which thread runs the loop, as far as that is known."""
        self.loop: asyncio.AbstractEventLoop

    def turn(self) -> asyncio.Semaphore:
        """Whose turn it is to connect. Called on the loop."""
        if self._turns is None:
            self._turns = asyncio.Semaphore(AT_ONCE)
        return self._turns

    def enter(self) -> None:
        """Run the event loop, unless SPADE agents of the user's own run it already."""
        with self._lock:
            self._users += 1
            if self._users > 1:
                return
            import_spade()
            from spade.container import Container

            policy = asyncio.get_event_loop_policy()
            self.loop = Container().loop
            asyncio.set_event_loop_policy(policy)  # SPADE sets uvloop's for the whole process
            if not self.loop.is_running():
                self._thread = threading.Thread(target=self.loop.run_forever, name="aseme spade", daemon=True)
                self._thread.start()
                self.thread = self._thread.ident or 0

    def leave(self) -> None:
        """Stop the loop if this was its last user."""
        with self._lock:
            self._users -= 1
            if self._users == 0 and self._thread is not None:
                self.loop.call_soon_threadsafe(self.loop.stop)
                self._thread.join(5.0)
                self._thread, self.thread = None, 0


_LOOP = _Loop()
