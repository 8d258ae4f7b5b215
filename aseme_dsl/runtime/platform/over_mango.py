"""The platform mango: every agent is an agent of a mango container, which reaches others over TCP.

There is no server, and senders are not authenticated: use it only on networks where every agent is trusted.
Texts travel as JSON, never as pickles. Each note has a connection of its own: over a connection that stays
open, mango loses all notes silently after the other end restarts. Notes to one address arrive in order.
"""

from __future__ import annotations

import asyncio
import json
import logging
import re
import threading
from collections import deque
from collections.abc import Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import fipa_name, performative_of
from aseme_dsl.runtime.platform.acl_headers import OURS
from aseme_dsl.runtime.platform.platform import Headers
from aseme_dsl.runtime.transport.port import TransportError

if TYPE_CHECKING:
    from aseme_dsl.runtime.platform.platform import Receives
    from aseme_dsl.runtime.transport.settings import Mango

MISSING = 'mango is not installed: pip install "aseme-dsl[mango]"'
CONNECT = 3.0
"""How long, in seconds, a connection may take to be made."""
WAITING = 5000
"""So many notes wait at the most for one address; what comes then is dropped, or comes back if it is kept."""
LARGEST = 1_000_000
_ADDRESS = re.compile(r"(?P<host>.+):(?P<port>\d{1,5})/(?P<name>[^/]+)")
_TAKEN = re.compile(r"agent\d+")
"""Names that mango keeps for itself."""
_PERFORMATIVE = "performative"


def import_mango() -> Any:
    """The module. Raises TransportError, saying how to install it, where it is not."""
    try:
        import mango
    except ImportError as problem:
        raise TransportError(MISSING) from problem
    # The trace records connections that fail; mango need not log them.
    logging.getLogger("mango").addHandler(logging.NullHandler())
    return mango


@dataclass(slots=True)
class _Note:
    """A note on its way."""

    sender: str
    headers: Headers
    body: str
    kept: bool


@dataclass(slots=True)
class _Target:
    """What waits for an address, and who sends it, one after the other."""

    waiting: deque[_Note] = field(default_factory=deque)
    task: asyncio.Task[None] | None = None


class MangoPlatform:
    """The mango agents of one process."""

    name = "mango"
    largest = LARGEST

    def __init__(self, settings: Mango, team: Sequence[str]) -> None:
        """`team` are all its agents. Raises TransportError if mango is missing."""
        self._mango = import_mango()
        self._settings = settings
        self._team = {_aid(name): name for name in team}
        self._receives: Receives
        self._loop: asyncio.AbstractEventLoop
        self._thread: threading.Thread | None = None
        self._container: Any = None
        self._agents: tuple[str, ...] = ()
        self._place = ""
        self._targets: dict[str, _Target] = {}

    def start(self, agents: Sequence[str], receives: Receives) -> None:
        """Listen at the address of these agents."""
        self._receives, self._agents = receives, tuple(agents)
        places = {self._settings.hosts[name] for name in agents if name in self._settings.hosts}
        if len(places) > 1:
            raise TransportError(
                f"{', '.join(agents)} are in one process, and have different addresses: start each in one of"
                " its own (`asemec run --process-per-agent`), or give them one address"
            )
        host, port = next(iter(places), ("127.0.0.1", 0))
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="aseme mango", daemon=True)
        self._thread.start()
        try:
            asyncio.run_coroutine_threadsafe(self._begin(host, port), self._loop).result(10.0)
        except OSError as problem:
            self.close()
            raise TransportError(f"{host}:{port} cannot be listened at: {problem.strerror}") from problem

    async def _begin(self, host: str, port: int) -> None:
        mango = self._mango
        self._container = mango.create_tcp_container(
            addr=(host, port), codec=mango.JSON(), auto_port=port == 0, tcp_connection_ttl=-1
        )
        kind = _agent_class()
        for name in self._agents:
            agent = self._container.register(kind(self, name), suggested_aid=_aid(name))
            assert agent.aid == _aid(name)
        await self._container.start()
        self._place = "{}:{}".format(*self._container.addr)

    def address_of(self, agent: str) -> str:
        """Where the project says that it is."""
        host, port = self._settings.hosts.get(agent, ("", 0))
        return f"{host}:{port}/{_aid(agent)}"

    def agent_at(self, address: str) -> str | None:
        """Which of the team is there, by what the project says."""
        place, _, aid = address.rpartition("/")
        name = self._team.get(aid)
        if name is None:
            return None
        host, port = self._settings.hosts.get(name, ("", 0))
        mine = name in self._agents and place == self._place
        return name if mine or place == f"{host}:{port}" else None

    def is_address(self, text: str) -> bool:
        """Whether it is written like one: host:port/name."""
        return _ADDRESS.fullmatch(text) is not None

    def name_at(self, address: str) -> str:
        """The address: mango knows no other names."""
        return address

    def here(self) -> dict[str, str]:
        """Where our agents are."""
        return {name: f"{self._place}/{_aid(name)}" for name in self._agents}

    def send(self, sender: str, address: str, headers: Headers, body: str, *, kept: bool) -> None:
        """Send a note, after those for the same address."""
        self._loop.call_soon_threadsafe(self._queue, address, _Note(sender, headers, body, kept))

    def meet(self, address: str) -> None:
        """Do nothing: mango has no presence service."""

    def close(self) -> None:
        """Let what waits be sent, as far as that is quick, and stop listening."""
        if self._thread is None:
            return
        asyncio.run_coroutine_threadsafe(self._end(), self._loop).result(10.0)
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()
        self._thread = None

    async def _end(self) -> None:
        tasks = [target.task for target in self._targets.values() if target.task is not None]
        if tasks:
            await asyncio.wait(tasks, timeout=0.5)
        for task in tasks:
            task.cancel()
        if self._container is not None and self._container.running:
            await self._container.shutdown()

    # ---- on the loop -------------------------------------------------------------------------

    def _queue(self, address: str, note: _Note) -> None:
        target = self._targets.setdefault(address, _Target())
        if len(target.waiting) >= WAITING:
            if note.kept:
                self._return(address, note, "too many wait for it")
            return
        target.waiting.append(note)
        if target.task is None:
            target.task = self._loop.create_task(self._send_all(address, target))

    async def _send_all(self, address: str, target: _Target) -> None:
        try:
            while target.waiting:
                note = target.waiting.popleft()
                try:
                    sent = await asyncio.wait_for(self._send(address, note), CONNECT)
                except Exception:  # any error means that the note was not sent
                    sent = False
                if not sent:
                    if note.kept:
                        self._return(address, note, "no agent listens there")
                    self._receives.unreachable(address)
        finally:
            target.task = None
            if not target.waiting:
                self._targets.pop(address, None)

    async def _send(self, address: str, note: _Note) -> bool:
        found = _ADDRESS.fullmatch(address)
        if found is None:
            return False
        to = self._mango.AgentAddress((found["host"], int(found["port"])), found["name"])
        meta = {_key(name): value for name, value in note.headers.items()}
        known = performative_of(note.headers.get(_PERFORMATIVE, ""))
        if known is not None:
            meta[_PERFORMATIVE] = self._mango.Performatives[known]
        sent: bool = await self._container.send_message(note.body, to, _aid(note.sender), **meta)
        return sent

    def _return(self, address: str, note: _Note, reason: str) -> None:
        self._receives.returned(note.sender, address, note.headers.get("reply-with", ""), reason)

    def heard(self, agent: str, content: Any, meta: dict[str, Any]) -> None:
        """A message has come for one of ours. Raises nothing: mango would not hand it another one."""
        try:
            host, port = meta.get("sender_addr") or ("", 0)
            origin = f"{host}:{port}/{meta.get('sender_id') or ''}"
            headers = {
                _name(key): _text(key, value)
                for key, value in meta.items()
                if key not in _OF_MANGO and value is not None
            }
            body = content if isinstance(content, str) else _json(content)
        except (TypeError, ValueError):
            return  # its own description makes no sense, and whom to answer is not said
        self._receives.came(agent, origin, headers, body)


_OF_MANGO = frozenset(
    ("sender_addr", "sender_id", "receiver_addr", "receiver_id", "network_protocol", "priority")
)
_FURTHER = ("X-", OURS)


def _aid(agent: str) -> str:
    """What an agent is called in its container."""
    return f"{agent}_" if _TAKEN.fullmatch(agent) else agent


def _key(header: str) -> str:
    """A header as mango has it: `conversation_id`."""
    return header if header.startswith(_FURTHER) else header.replace("-", "_")


def _name(key: object) -> str:
    text = str(key)
    return text if text.startswith(_FURTHER) else text.replace("_", "-")


def _text(key: str, value: Any) -> str:
    if key == _PERFORMATIVE and not isinstance(value, str):
        name = str(getattr(value, "name", value))  # of mango's Performatives
        return fipa_name("cfp" if name == "call_for_proposal" else name)
    return str(value) if isinstance(value, str) else _json(value)


def _json(value: object) -> str:
    return "" if value is None else json.dumps(value)


def _agent_class() -> Any:
    from mango import Agent

    class Ours(Agent):  # type: ignore[misc]
        """What comes is handed to the platform: the chart decides what it means."""

        def __init__(self, platform: MangoPlatform, name: str) -> None:
            super().__init__()
            self.platform = platform
            self.called = name

        def handle_message(self, content: object, meta: dict[str, object]) -> None:
            self.platform.heard(self.called, content, meta)

    return Ours
