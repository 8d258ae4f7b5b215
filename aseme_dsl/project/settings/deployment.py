"""Deployment: on which machines a team's robots are, and how they reach and trust each other."""

from __future__ import annotations

import contextlib
import ipaddress
import re
import socket
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.diagnostics import Problem
from aseme_dsl.diagnostics.problems.running import AgentWithoutHost, HostOfNobody
from aseme_dsl.diagnostics.problems.settings import (
    EndpointWithoutCertificates,
    NoCertificates,
    NoEffectWithoutHosts,
)
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.runtime.transport import Network

PORT = 7447
"""Where robots listen if nothing else is said."""
ROBOT = "ROBOT"
"""Stands for the robot's name in the names of its files."""


_LARGEST = 1 << 20
"""The largest file of hosts, in bytes."""


@dataclass(frozen=True, slots=True)
class TlsFiles:
    """The PEM files of `[tool.asemec.deploy.tls]`; ROBOT in their names stands for the robot's name."""

    authority: Path | None = None
    certificate: Path | None = None
    key: Path | None = None


class HostsOfFile(dict[str, str]):
    """Hosts that are in a file of their own."""

    def __init__(self, path: Path, hosts: Mapping[str, str]) -> None:
        super().__init__(hosts)
        self.path = path


def hosts_of(value: object) -> dict[str, str] | None:
    """The hosts that a table has, by the names of agents; None if it is not a table of hosts."""
    if not isinstance(value, dict) or not all(
        isinstance(host, str) and re.fullmatch(r"(\[[0-9A-Fa-f:.%\w]+\]|[\w.-]+)(:\d{1,5})?", host)
        for host in value.values()
    ):
        return None
    return dict(value)


def read_hosts(path: Path) -> dict[str, str]:
    """The hosts in a TOML file of their own: `robot1 = "192.168.1.11"`. Raises ValueError, saying why not."""
    import tomllib

    try:
        found = hosts_of(tomllib.loads(outside.read_bytes(path, _LARGEST).decode("utf-8")))
    except OSError as problem:
        raise ValueError(f"cannot be read: {problem.strerror or problem}") from problem
    except (ValueError, RecursionError) as problem:
        raise ValueError(f"is not valid TOML: {problem}") from problem
    if found is None:
        raise ValueError("is not a table of hosts")
    return found


class HostsNow:
    """The endpoints of the other agents by their file of hosts, which is read again when it has changed."""

    def __init__(self, hosts: HostsOfFile, robot: str, protocol: str) -> None:
        self._path = hosts.path
        self._robot = robot
        self._protocol = protocol
        self._seen = self._state()
        self._found = self._endpoints(hosts)

    def __call__(self) -> Mapping[str, str]:
        """The endpoint of each other agent. Raises ValueError, saying why, if the file cannot be used."""
        state = self._state()
        if state != self._seen:
            try:
                self._found = self._endpoints(read_hosts(self._path))
            except ValueError as problem:
                raise ValueError(f"{self._path} {problem}") from problem
            self._seen = state
        return self._found

    def _endpoints(self, hosts: Mapping[str, str]) -> Mapping[str, str]:
        others = ((name, host) for name, host in hosts.items() if name != self._robot)
        return {name: f"{self._protocol}/{_with_port(host)}" for name, host in others}

    def _state(self) -> tuple[int, ...]:
        try:
            found = self._path.stat()
        except OSError:
            return ()
        return found.st_ino, found.st_mtime_ns, found.st_size


@dataclass(frozen=True, slots=True)
class Deployment:
    """What `[tool.asemec.deploy]` says. Without it, everything stays on this machine."""

    hosts: Mapping[str, str] = field(default_factory=dict)
    """The address of each robot, with its port if that is not 7447: they connect to each other there."""
    interface: str | None = None
    """The network interface on which the team is looked for by multicast."""
    connect: tuple[str, ...] = ()
    """Further endpoints to connect to, such as that of a router: `tcp/10.0.0.1:7447`."""
    lease: int | None = None
    """After how long a silent robot counts as gone, in ns."""
    access: Path | None = None
    """A file with zenoh's access control, in JSON; ROBOT in its name stands for the robot's name."""
    control: Path | None = None
    """The file of the operators' keys (`runtime.operator_key`) that a robot accepts; ROBOT in its name stands
    for the robot's name. Without it, no operator controls robots over the network."""
    tls: TlsFiles | None = None
    include: tuple[str, ...] = ()
    """Patterns of further files of the project that a bundle needs."""

    @property
    def hosts_file(self) -> Path | None:
        """The file that has the hosts, if it is not the pyproject.toml."""
        return self.hosts.path if isinstance(self.hosts, HostsOfFile) else None


def keys_of(deployment: Deployment | None, robot: str) -> Path | None:
    """The file of the operators' keys that a robot accepts."""
    return None if deployment is None or deployment.control is None else file_of(deployment.control, robot)


def network_of(deployment: Deployment | None, robot: str, team: Iterable[str] = ()) -> Network:
    """The network of a robot of a team, or of its `OPERATOR`, as the project deploys it."""
    from aseme_dsl.runtime.transport import Access, Network, Tls
    from aseme_dsl.runtime.transport.access import OPERATOR
    from aseme_dsl.runtime.transport.settings import LEASE_MS

    if deployment is None:
        return Network()
    secure = deployment.tls
    protocol = "tls" if secure is not None else "tcp"
    own = deployment.hosts.get(robot)
    interface = deployment.interface
    listen: tuple[str, ...] = ()
    if own is not None:
        listen = (f"{protocol}/{_listening(_with_port(own))}",)
    elif interface is not None and robot != OPERATOR:
        listen = (f"{protocol}/0.0.0.0:0#iface={interface}",)
    others = [f"{protocol}/{_with_port(host)}" for name, host in deployment.hosts.items() if name != robot]
    hosts = deployment.hosts
    tls = None
    if secure is not None and secure.authority and secure.certificate and secure.key:
        tls = Tls(*(file_of(path, robot) for path in (secure.authority, secure.certificate, secure.key)))
    if not (listen or others or deployment.connect or interface):
        tls = None
    return Network(
        listen,
        (*others, *deployment.connect),
        interface,
        LEASE_MS if deployment.lease is None else max(1, deployment.lease // 1_000_000),
        tls,
        Access(file_of(deployment.access, robot)) if deployment.access is not None else None,
        robot,
        tuple(team),
        deployment.control is not None,
        seeks=own is None,
        places=HostsNow(hosts, robot, protocol) if isinstance(hosts, HostsOfFile) else None,
    )


def network_mistakes(deployment: Deployment) -> Iterator[tuple[str, Problem]]:
    """Settings that would let any process on the network in, or have no effect, each with its key."""
    beyond = [key for key in ("hosts", "interface") if getattr(deployment, key)]
    if any(not end.startswith("tls/") for end in deployment.connect):
        beyond.append("connect")
    if beyond and deployment.tls is None:
        yield beyond[0], NoCertificates(beyond[0])
    elif "connect" in beyond:
        yield "connect", EndpointWithoutCertificates()
    if not deployment.hosts:
        idle = [key for key in ("interface", "tls", "access") if getattr(deployment, key) is not None]
        if deployment.connect:
            idle = [key for key in idle if key == "interface"]
        for key in idle:
            yield key, NoEffectWithoutHosts(key)


def misfits(deployment: Deployment, agents: Iterable[str], path: str) -> Iterator[Problem]:
    """How a deployment, which stands in the file `path`, does not fit these agents."""
    names = list(agents)
    for robot in deployment.hosts:
        if robot not in names:
            yield HostOfNobody(path, robot, tuple(names))
    if deployment.hosts and deployment.interface is None:
        for robot in names:
            if robot not in deployment.hosts:
                yield AgentWithoutHost(path, robot)


def _listening(end: str) -> str:
    """Where a robot listens whose host is `end`: a name stands for its address that this machine has.

    A machine often takes its own name for a loopback address, or does not know it. It then listens on all of
    its addresses.
    """
    host, _, port = end.rpartition(":")
    if host.startswith("[") or host == "localhost" or re.fullmatch(r"[\d.]+", host):
        return end
    with contextlib.suppress(OSError, UnicodeError):
        for family, kind, _, _, (address, *_) in socket.getaddrinfo(host, 0, type=socket.SOCK_DGRAM):
            if not ipaddress.ip_address(address).is_loopback:
                with contextlib.suppress(OSError), socket.socket(family, kind) as tried:
                    tried.bind((address, 0))
                    return f"[{address}]:{port}" if ":" in str(address) else f"{address}:{port}"
    return f"0.0.0.0:{port}"


def host_of(host: str) -> str:
    """The address or the name in an entry of `hosts`, without its port and brackets."""
    return _with_port(host).rpartition(":")[0].strip("[]")


def _with_port(host: str) -> str:
    bracketed = host.rpartition("]")[2] if "]" in host else host
    return host if ":" in bracketed else f"{host}:{PORT}"


def file_of(path: Path, robot: str) -> Path:
    """The file of a robot: ROBOT in its name stands for the robot's name."""
    return path.with_name(path.name.replace(ROBOT, robot))
