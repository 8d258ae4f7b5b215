"""Deployment: on which machines a team's robots are, and how they reach and trust each other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from aseme_dsl.runtime.transport import Network

PORT = 7447
"""Where robots listen if nothing else is said."""
ROBOT = "ROBOT"
"""Stands for the robot's name in the names of its files."""


@dataclass(frozen=True, slots=True)
class TlsFiles:
    """The PEM files of `[tool.asemec.deploy.tls]`; ROBOT in their names stands for the robot's name."""

    authority: Path | None = None
    certificate: Path | None = None
    key: Path | None = None


@dataclass(frozen=True, slots=True)
class Deployment:
    """What `[tool.asemec.deploy]` says. Without it, everything stays on this machine's loopback interface."""

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
    tls: TlsFiles | None = None


def network_of(deployment: Deployment | None, robot: str) -> Network:
    """The network of a robot, as the project deploys it."""
    from aseme_dsl.runtime.transport import Access, Network, Tls
    from aseme_dsl.runtime.transport.settings import LEASE_MS

    if deployment is None:
        return Network()
    secure = deployment.tls
    protocol = "tls" if secure is not None else "tcp"
    own = deployment.hosts.get(robot)
    interface = deployment.interface
    if own is not None:
        listen = (f"{protocol}/{_with_port(own)}",)
    elif interface is not None:
        listen = (f"{protocol}/0.0.0.0:0#iface={interface}",)
    else:
        listen = (f"{protocol}/127.0.0.1:0",)
    others = [f"{protocol}/{_with_port(host)}" for name, host in deployment.hosts.items() if name != robot]
    tls = None
    if secure is not None and secure.authority and secure.certificate and secure.key:
        tls = Tls(_of(secure.authority, robot), _of(secure.certificate, robot), _of(secure.key, robot))
    if interface is None and not deployment.hosts:
        interface = "lo"
    return Network(
        listen,
        (*others, *deployment.connect),
        interface,
        LEASE_MS if deployment.lease is None else max(1, deployment.lease // 1_000_000),
        tls,
        Access(_of(deployment.access, robot)) if deployment.access is not None else None,
    )


def misfits(deployment: Deployment, agents: Iterable[str]) -> Iterator[tuple[str | None, str]]:
    """What is wrong with a deployment of these agents, as (the robot that it is about, why)."""
    names = list(agents)
    for robot in deployment.hosts:
        if robot not in names:
            yield robot, f"there is no agent {robot} in the team; there are {', '.join(names)}"
    if deployment.hosts and deployment.interface is None:
        for robot in names:
            if robot not in deployment.hosts:
                yield None, f"nobody would find {robot}: it has no host, and there is no interface to look on"


def _with_port(host: str) -> str:
    bracketed = host.rpartition("]")[2] if "]" in host else host
    return host if ":" in bracketed else f"{host}:{PORT}"


def _of(path: Path, robot: str) -> Path:
    return path.with_name(path.name.replace(ROBOT, robot))
