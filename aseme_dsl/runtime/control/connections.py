"""Connections: what others may open at once, and how slowly they may ask.

A client that opens many connections and sends nothing, or sends it byte by byte, keeps no other client out.
"""

from __future__ import annotations

import contextlib
import io
import socket
import threading
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

MOST = 64
"""So many connections there are at once."""
IDLE_SECONDS = 60.0
"""A connection on which nothing is asked for so long is closed."""
REQUEST_SECONDS = 10.0
"""A request has come as a whole so long after its first bytes, or its connection is closed."""


class Places:
    """The places of the connections, `MOST`. May be used from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._waiting: dict[socket.socket, int] = {}
        """Those that wait for who has opened them, the longest first; and what of each is shut to end it."""
        self._answered: set[socket.socket] = set()

    def take(self, connection: socket.socket, how: int = socket.SHUT_RD) -> bool:
        """Take a place: if none is free, that of the connection that has waited longest.

        A connection that loses its place is shut, in the way that was given for it: who reads from it is at
        its end. False if none can be had: all are being answered.
        """
        with self._lock:
            if len(self._waiting) + len(self._answered) >= MOST:
                if not self._waiting:
                    return False
                longest = next(iter(self._waiting))
                how = self._waiting.pop(longest)
                with contextlib.suppress(OSError):  # it has just been closed
                    longest.shutdown(how)
            self._waiting[connection] = how
            return True

    def answer(self, connection: socket.socket) -> bool:
        """Something was asked, and is answered now: the place is kept. False if it has been lost."""
        with self._lock:
            if self._waiting.pop(connection, None) is None:
                return False
            self._answered.add(connection)
            return True

    def wait(self, connection: socket.socket, how: int = socket.SHUT_RD) -> None:
        """From now on it waits again: that more is asked, or that the answer is taken (`SHUT_RDWR`)."""
        with self._lock:
            if connection in self._answered or connection in self._waiting:
                self._answered.discard(connection)
                self._waiting[connection] = how

    def leave(self, connection: socket.socket) -> bool:
        """Give the place back; False if it has been lost."""
        with self._lock:
            had = connection in self._answered
            self._answered.discard(connection)
            return self._waiting.pop(connection, None) is not None or had


class Timely(io.RawIOBase):
    """What comes by a connection. Reading raises TimeoutError if a request takes too long.

    A timeout of a socket counts from its last byte: who sends one now and then would never be too late.
    """

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._last: float | None = None
        connection.settimeout(IDLE_SECONDS)

    def next(self) -> None:
        """What comes from now on is another request."""
        self._last = None

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: WriteableBuffer, /) -> int:
        left = IDLE_SECONDS if self._last is None else self._last - time.monotonic()
        if left <= 0:
            raise TimeoutError
        self._connection.settimeout(left)
        count = self._connection.recv_into(buffer)
        self._connection.settimeout(IDLE_SECONDS)  # for the answer
        if self._last is None:
            self._last = time.monotonic() + REQUEST_SECONDS
        return count


__all__ = ["IDLE_SECONDS", "MOST", "REQUEST_SECONDS", "Places", "Timely"]
