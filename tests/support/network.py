"""What a test has for itself of a machine's network, which other tests use at the same time."""

from __future__ import annotations

import secrets
import socket
import string
from collections.abc import Iterator
from contextlib import contextmanager


def own_name(name: str) -> str:
    """A name, beginning like this, that no other process uses for its team.

    The robots of teams of one name find each other, and take each other's places.
    """
    return name + "".join(secrets.choice(string.ascii_lowercase) for _ in range(8))


@contextmanager
def own_port() -> Iterator[int]:
    """A port of the loopback interface that nobody else is given meanwhile.

    It is bound and not listened on: who asks for it by its number and permits that it is used again
    (SO_REUSEADDR), as servers do, has it; who asks for any free port gets another.
    """
    with socket.socket() as held:
        held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        held.bind(("127.0.0.1", 0))
        yield int(held.getsockname()[1])
