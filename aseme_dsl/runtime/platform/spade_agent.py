"""SPADE's agent, made ours: its connection is watched, and its messages are handed on.

Import it only after `import_spade` of `over_spade`: without SPADE, that says how to install it.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import ssl
import time
from functools import cache
from typing import TYPE_CHECKING, Any, Protocol
from xml.sax.saxutils import quoteattr

from slixmpp import ClientXMPP
from slixmpp.exceptions import IqError, IqTimeout
from spade.agent import Agent
from spade.presence import PresenceManager

from aseme_dsl.runtime.platform.acl_headers import OURS
from aseme_dsl.runtime.platform.platform import Refused

if TYPE_CHECKING:
    from aseme_dsl.runtime.platform.platform import Receives
    from aseme_dsl.runtime.transport.settings import Xmpp

REGISTRATION = 20.0
"""How long, in seconds, a server may take to register an account."""
SILENCE = 8.0
"""A server that has said nothing for so many seconds is asked for a sign, and given as long to answer."""


class Connection(Protocol):
    """The connection that an agent has, as the agent sees it."""

    agent: str
    settings: Xmpp
    receives: Receives

    def heard(self, xml: Any) -> bool: ...


@cache
def _context(verify: bool, authority: str | None) -> ssl.SSLContext:
    """One for all agents of the process: loading the machine's authorities takes long."""
    if verify:
        return ssl.create_default_context(cafile=authority)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    return context


class _Client(ClientXMPP):  # type: ignore[misc]
    """An XMPP connection that is watched, and whose stanzas are shown to a connection of ours first."""

    def __init__(self, jid: str, connection: Connection, password: str, register: bool) -> None:
        settings = connection.settings
        context = _context(settings.verify, str(settings.authority) if settings.authority else None)
        super().__init__(jid, password, ssl_context=context)
        self.enable_direct_tls = False
        self.enable_plaintext = False
        self.connection = connection
        self.last = time.monotonic()
        self.refused = ""
        self.ended: asyncio.Future[str] = self.loop.create_future()
        if register:
            self.register_plugin("xep_0077")
            self.add_event_handler("register", self.register_account)
        self.add_event_handler("disconnected", self.has_ended)
        self.add_event_handler("connection_failed", self.has_ended)
        self.add_event_handler("ssl_invalid_chain", self.is_not_trusted)

    def has_ended(self, reason: object) -> None:
        if not self.ended.done():
            self.ended.set_result(str(reason or "it was closed"))

    def is_not_trusted(self, problem: object) -> None:
        self.refused = f"its certificate is not trusted: {problem}"
        self.has_ended(self.refused)

    async def register_account(self, event: object) -> None:
        request = self.Iq()
        request["type"] = "set"
        request["register"]["username"] = self.boundjid.user
        request["register"]["password"] = self.password
        try:
            await request.send(timeout=REGISTRATION)
        except IqError as problem:
            reason = problem.iq["error"]["condition"]
            if reason != "conflict":  # else there is the account already
                self.refused = f"it does not register {self.boundjid.bare}: {reason}"
        except IqTimeout:
            self.refused = f"it does not answer when {self.boundjid.bare} is to be registered"

    def data_received(self, data: bytes) -> None:
        self.last = time.monotonic()
        super().data_received(data)

    def _spawn_event(self, xml: Any) -> None:
        if not self.connection.heard(xml):
            super()._spawn_event(xml)

    async def begin(self) -> None:
        """Connect. Raises Refused, or OSError."""
        began = self.loop.create_future()
        failed = self.loop.create_future()
        self.add_event_handler("session_start", lambda _: began.done() or began.set_result(None))
        self.add_event_handler("failed_all_auth", lambda _: failed.done() or failed.set_result(None))
        self.connect(self.connection.settings.host, self.connection.settings.port)
        await asyncio.wait({began, failed, self.ended}, return_when=asyncio.FIRST_COMPLETED)
        if failed.done():
            text = f"it does not let {self.boundjid.bare} in with this password"
            raise Refused(self.refused or text)
        if self.refused:
            raise Refused(self.refused)
        if not began.done():
            raise OSError(self.ended.result())
        self.send_presence()

    def give_up(self) -> None:
        """End all that the client does."""
        self.cancel_connection_attempt()
        self.abort()
        if self._run_out_filters is not None:
            self._run_out_filters.cancel()

    async def watch(self) -> str:
        """Wait for the end of the connection, and find out that it has ended; gives the reason."""
        domain = quoteattr(self.boundjid.host)
        number = itertools.count(1)
        asked = 0.0
        while True:
            with contextlib.suppress(asyncio.TimeoutError):
                return await asyncio.wait_for(asyncio.shield(self.ended), SILENCE / 2)
            silent = time.monotonic() - self.last
            if silent < SILENCE:
                asked = 0.0
            elif not asked:
                asked = time.monotonic()
                ping = "<ping xmlns='urn:xmpp:ping'/>"
                with contextlib.suppress(Exception):  # the connection has just been lost
                    self.send_raw(f"<iq type='get' id='aseme-{next(number)}' to={domain}>{ping}</iq>")
            elif time.monotonic() - asked > SILENCE:
                return f"it has said nothing for {silent:.0f} s"


class SpadeAgent(Agent):  # type: ignore[misc]
    """What SPADE hands to its behaviours goes to the connection: the chart decides what it means."""

    def __init__(self, jid: str, connection: Connection) -> None:
        super().__init__(jid, connection.settings.password_of(connection.agent))
        self.connection = connection

    async def _async_start(self, auto_register: bool = True) -> None:
        self.client = _Client(str(self.jid), self.connection, self.password, auto_register)
        self.presence = PresenceManager(agent=self, approve_all=False)
        await self.client.begin()
        self._alive.set()

    def dispatch(self, msg: Any) -> list[Any]:
        """A message of a SPADE agent of this process, which its container hands over."""
        headers = {str(key): str(value) for key, value in msg._metadata.items() if key != OURS}
        self.connection.receives.came(self.connection.agent, str(msg.sender), headers, msg.body or "")
        return []


__all__ = ["SpadeAgent"]
