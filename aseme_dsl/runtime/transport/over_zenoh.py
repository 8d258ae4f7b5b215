"""The link over Eclipse Zenoh. Keys, each below `asemec/SYSTEM`:

to/RECEIVER/SENDER/WAY     what goes from one agent to another; WAY is TOPIC/KIND/MESSAGE, or `mail`, …
here/AGENT/INCARNATION     a liveliness token: this agent is there
WHAT/AGENT                 questions: `history` and `control`
"""

from __future__ import annotations

import contextlib
import re
import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.port import TransportError
from aseme_dsl.runtime.transport.stream import PATIENCE

if TYPE_CHECKING:
    from aseme_dsl.runtime.acl import FipaMessage
    from aseme_dsl.runtime.transport.link import Answer, Hears, Stamp
    from aseme_dsl.runtime.transport.settings import Network

MISSING = (
    'robots in several processes talk over Zenoh, which is not installed: pip install "aseme-dsl[zenoh]"'
)


NOBODY = "?"
"""Stands for a sender whose name is missing in the key."""
QUESTIONS = ("history", "control")
_LIFE = re.compile("[0-9a-f]{1,16}")


def import_zenoh() -> Any:
    """The module. Raises TransportError, saying how to install it, where it is not."""
    try:
        import zenoh
    except ImportError as problem:
        raise TransportError(MISSING) from problem
    return zenoh


class ZenohLink:
    """A Zenoh session of its own."""

    readable = False
    patience = PATIENCE
    largest = None

    def __init__(self, system: str, network: Network) -> None:
        """Raises TransportError if zenoh is not installed, or the settings do not fit."""
        self._zenoh = import_zenoh()
        self._root = f"asemec/{system}"
        self._config = self._zenoh.Config()
        for key, value in network.settings():
            try:
                self._config.insert_json5(key, value)
            except self._zenoh.ZError as problem:
                raise TransportError(f"zenoh does not take {key} = {value}: {problem}") from problem
        self._session: Any = None
        self._kept: list[Any] = []
        """Tokens vanish when nobody refers to them."""
        self._publishers: dict[str, Any] = {}
        self._lock = threading.Lock()

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        """Connect and say that these agents are here."""
        zenoh = self._zenoh
        try:
            session = zenoh.open(self._config)
        except zenoh.ZError as problem:
            raise TransportError(f"the network cannot be used: {_first_line(problem)}") from problem
        self._session = session
        # A process that ends with a subscriber in it waits for ever, unless this runs before its threads
        # are waited for; `atexit` is too late for that.
        register = getattr(threading, "_register_atexit", None)
        if register is not None:
            with contextlib.suppress(RuntimeError):  # the interpreter is ending already
                register(self.close)
        put = zenoh.SampleKind.PUT

        def arrived(sample: Any) -> None:
            _, _, _, to, *further = str(sample.key_expr).split("/")
            sender = further[0] if further else NOBODY
            attachment = sample.attachment
            data = b"" if attachment is None else attachment.to_bytes()
            payload = sample.payload.to_bytes()
            try:
                envelope = envelopes.read(data, payload)
            except EnvelopeError as problem:
                hears.unreadable(to, sender, str(problem))
            else:
                hears.arrived(to, sender, envelope, payload)

        def lives(sample: Any) -> None:
            *_, agent, life = str(sample.key_expr).split("/")
            if not _LIFE.fullmatch(life):
                agent, life = NOBODY, "0"
            (hears.appeared if sample.kind == put else hears.vanished)(agent, int(life, 16))

        def asked(query: Any) -> None:
            what, to = str(query.key_expr).split("/")[-2:]
            if to not in agents or what not in QUESTIONS:
                return  # a query for all that there is
            question = b"" if query.payload is None else query.payload.to_bytes()
            for envelope, payload in hears.asked(to, what, question):
                data = envelopes.written(envelope, payload)
                query.reply(f"{self._root}/{what}/{to}", payload, attachment=data)

        for agent in agents:
            self._kept.append(session.declare_subscriber(f"{self._root}/to/{agent}/**", arrived))
            self._kept.append(session.declare_queryable(f"{self._root}/*/{agent}", asked))
        liveliness = session.liveliness()
        self._kept.append(liveliness.declare_subscriber(f"{self._root}/here/*/*", lives, history=True))
        # Last: who sees the token may send at once.
        for agent in agents:
            self._kept.append(liveliness.declare_token(f"{self._root}/here/{agent}/{incarnation:x}"))

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        """Send something; it is dropped where the peer takes no more, and never waited for."""
        addressee, place, sample = stamp
        data = envelopes.written(envelope, payload, addressee=addressee, place=place, sample=sample)
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
            # Blocking would hold up the whole team for one robot that stands still; the streams send again
            # what is dropped, and never have so much on its way that it comes to that.
            found = self._publishers[key] = self._session.declare_publisher(
                key,
                congestion_control=zenoh.CongestionControl.DROP,
                priority=zenoh.Priority.INTERACTIVE_HIGH if sure else zenoh.Priority.DATA,
                express=sure,
            )
            return found

    def say(self, to: str, sender: str, message: FipaMessage) -> bool:
        """False: over Zenoh there is only the team."""
        return False

    def ask(self, to: str, what: str, question: bytes, timeout: float) -> list[Answer]:
        """Put a question and wait for the answers."""
        zenoh = self._zenoh
        session = self._session
        if session is None:
            return []
        replies = session.get(
            f"{self._root}/{what}/{to}",
            payload=question,
            timeout=timeout,
            # Otherwise of several answers on one key only the last one is kept.
            consolidation=zenoh.ConsolidationMode.NONE,
        )
        found: list[Answer] = []
        for reply in replies:
            if reply.ok is not None and reply.ok.attachment is not None:
                payload = reply.ok.payload.to_bytes()
                try:
                    found.append((envelopes.read(reply.ok.attachment.to_bytes(), payload), payload))
                except EnvelopeError as problem:
                    raise TransportError(f"the answer of {to} cannot be read: {problem}") from problem
        return found

    def close(self) -> None:
        """Disconnect."""
        with self._lock:
            session, self._session = self._session, None
            self._publishers.clear()
        if session is not None:
            session.close()
        self._kept.clear()


def _first_line(problem: Exception) -> str:
    return str(problem).partition("\n")[0]
