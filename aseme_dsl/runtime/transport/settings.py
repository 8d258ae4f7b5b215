"""Which network a robot uses, who may use it with it, and how that is proven.

Without a word about it nothing leaves the machine, and nothing listens on a port: the robots of one user meet
in a folder (`meeting`). A process that communicates beyond this machine proves by a certificate who it is.
"""

from __future__ import annotations

import ipaddress
import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.transport.access import access_rules
from aseme_dsl.runtime.transport.port import TransportError

_LARGEST = 1 << 20
"""The largest file of a certificate, a key, a password or rules, in bytes."""
LARGEST = 8 << 20
"""The largest message that travels between robots, in bytes: a larger one is not sent, nor put together.

It is data, which goes after what others wait for. Where the link is too slow for it, it does not arrive."""
LARGEST_IN_ORDER = 64 << 10
"""The largest of those that others wait for: of signals, states and agent messages.

At 10 Mbit/s they wait 0.06 s for one of this size. Zenoh has two batches of so many bytes for each priority.
It would drop each larger one over a slow link, and what follows would wait for ever."""
_ENVELOPE = 1 << 20
LEASE_MS = 2000
"""How long, in ms, a peer may be silent before it counts as gone."""


@dataclass(frozen=True, slots=True)
class Tls:
    """The PEM files with which agent processes authenticate each other.

    `authority` is the certificate of the authority that signed the team's certificates. `certificate` and
    `key` are those of this process. A process without a certificate of that authority cannot connect.
    """

    authority: Path
    certificate: Path
    key: Path


@dataclass(frozen=True, slots=True)
class Access:
    """A file with zenoh's `access_control`, in JSON: which certificate may use which keys."""

    file: Path


@dataclass(frozen=True, slots=True)
class Network:
    """How a robot reaches its team.

    `listen` and `connect` are endpoints, such as `tls/192.168.1.10:7447`; a port 0 is any free one. Without
    any, the team meets on this machine. `interface` is where the team is looked for by multicast: its name or
    address, or None for no looking.
    """

    listen: tuple[str, ...] = ()
    connect: tuple[str, ...] = ()
    interface: str | None = None
    lease_ms: int = LEASE_MS
    tls: Tls | None = None
    access: Access | None = None
    robot: str = ""
    team: tuple[str, ...] = ()
    """Of these names access rules are made, where there are certificates and no `access`."""
    controlled: bool = False
    """Whether the team has operators, who may ask for control and nothing else."""

    seeks: bool = True
    """Whether it connects to those whom it finds by multicast, rather than let them connect.

    Zenoh makes a broken connection again within a second where its address is one of `connect`, else when it
    looks by multicast again: every 8 s. So a robot with a host waits for those without.
    """
    places: Callable[[], Mapping[str, str]] | None = None
    """The endpoints of other robots now: they may have moved. Raises ValueError if that is not known."""

    @property
    def local(self) -> bool:
        """Whether the team meets on this machine, without ports."""
        return not (self.listen or self.connect or self.interface)

    def settings(self) -> Iterator[tuple[str, str]]:
        """The entries of zenoh's configuration, as (key, JSON).

        Raises:
            TransportError: a file is unreadable or has the wrong contents, or the settings would let
                processes of the network connect without a certificate.
        """
        for end in (*self.listen, *self.connect):
            if not _is_safe(end):
                raise TransportError(f"{end} is beyond this machine, and only tls/ proves who is there")
        if self.interface is not None and self.tls is None:
            raise TransportError(f"the team cannot be looked for on {self.interface} without certificates")
        yield "mode", '"peer"'
        yield "listen/endpoints", json.dumps([_bare(end) for end in self.listen])
        yield "connect/endpoints", json.dumps([_bare(end) for end in self.connect])
        # What is not there yet is looked for again soon: robots are switched on one after the other.
        yield "connect/retry", '{"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}'
        if self.interface is None:
            yield "scouting/multicast/enabled", "false"
        else:
            yield "scouting/multicast/interface", json.dumps(self.interface)
            if not self.seeks:
                yield "scouting/multicast/autoconnect", '{"peer": []}'
        # No other process may make us connect to an address, or change our settings.
        yield "scouting/gossip/enabled", "false"
        yield "adminspace/enabled", "false"
        yield "transport/shared_memory/enabled", "false"
        yield "transport/link/tx/lease", json.dumps(self.lease_ms)
        yield "transport/link/rx/max_message_size", json.dumps(LARGEST + _ENVELOPE)
        if self.tls is not None:
            for path in (self.tls.authority, self.tls.certificate, self.tls.key):
                _readable(path)
            _check_secret(self.tls.key)
            yield "transport/link/tls/root_ca_certificate", json.dumps(str(self.tls.authority))
            yield "transport/link/tls/listen_certificate", json.dumps(str(self.tls.certificate))
            yield "transport/link/tls/listen_private_key", json.dumps(str(self.tls.key))
            yield "transport/link/tls/connect_certificate", json.dumps(str(self.tls.certificate))
            yield "transport/link/tls/connect_private_key", json.dumps(str(self.tls.key))
            yield "transport/link/tls/enable_mtls", "true"
            if self.interface is not None and self.access is None and self.team:
                # Agents that are found have any address. The name in their certificates counts, and access
                # rules go by that, on both sides of a connection.
                yield "transport/link/tls/verify_name_on_connect", "false"
        if self.access is not None:
            text = _readable(self.access.file)
            try:
                outside.loads(text)
            except ValueError as problem:
                raise TransportError(f"{self.access.file} is not JSON: {problem}") from problem
            yield "access_control", text
        elif self.tls is not None and self.team:
            yield "access_control", json.dumps(access_rules(self.robot, self.team, self.controlled))


ROBOT = "ROBOT"
"""Stands for an agent's name in the names of its account and of its files."""


@dataclass(frozen=True, slots=True)
class Xmpp:
    """The XMPP server of a team whose agents are SPADE agents, and their accounts there.

    `password` is one text for all, or a file whose first line it is; ROBOT in the file's name, and in
    `account`, stands for the agent's name. With `register` accounts that are not there are made.
    """

    host: str = "127.0.0.1"
    port: int = 5222
    domain: str = "localhost"
    account: str = ROBOT
    password: str | Path = ""
    register: bool = False
    verify: bool = True
    """Whether the server must prove, by a certificate, that it is that of the domain."""
    authority: Path | None = None
    """The certificate of who has signed the server's; None: whom this machine trusts."""

    def account_of(self, agent: str) -> str:
        """The name of an agent's account."""
        return self.account.replace(ROBOT, agent)

    def password_of(self, agent: str) -> str:
        """The password of its account. Raises TransportError if its file cannot be read, or by every user."""
        if isinstance(self.password, str):
            return self.password
        path = self.password.with_name(self.password.name.replace(ROBOT, agent))
        text = _readable(path)
        _check_secret(path)
        return text.partition("\n")[0].strip()


@dataclass(frozen=True, slots=True)
class Mango:
    """Where the agents of a team listen, by their names, as (host, port)."""

    hosts: Mapping[str, tuple[str, int]] = field(default_factory=dict)


def _bare(endpoint: str) -> str:
    """An endpoint as zenoh needs it: over TLS it takes the brackets of an IPv6 address for a part of it."""
    return re.sub(r"^tls/\[([0-9A-Fa-f:.]+)\]", r"tls/\1", endpoint)


def _is_safe(endpoint: str) -> bool:
    """Whether only processes of this machine, or with a certificate of the team, can use an endpoint."""
    protocol, slash, address = endpoint.partition("/")
    if not slash or protocol in ("tls", "quic", "unixsock-stream"):
        return True
    host = re.sub(r":\d+([#?].*)?$", "", address).strip("[]")
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return False


def _check_secret(path: Path) -> None:
    """Raises TransportError if any user of this machine may read or write a file, and so be the robot."""
    if os.name == "posix" and path.stat().st_mode & 0o006:
        raise TransportError(f"{path} is open to all users of this machine: run `chmod 600` on it")


def _readable(path: Path) -> str:
    try:
        return outside.read_text(path, _LARGEST)
    except (OSError, UnicodeDecodeError) as problem:
        raise TransportError(
            f"{path} cannot be read: {getattr(problem, 'strerror', None) or problem}"
        ) from problem
