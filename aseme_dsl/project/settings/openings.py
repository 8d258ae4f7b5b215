"""Openings: what the team and the tools of a project open on this machine and on its network, by platform."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.diagnostics.problems.settings import Unprotected
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.settings.deployment import network_mistakes, network_of
from aseme_dsl.project.settings.platform_settings import IN_PROCESS, MANGO, SPADE, ZENOH
from aseme_dsl.records import dataclass

MULTICAST = "224.0.0.224:7446"


@dataclass(frozen=True, slots=True)
class Opening:
    """Something that a team opens."""

    platform: str
    opens: str
    """A kind of socket with its place, such as `tls/192.168.1.10:7447`; or `nothing`."""
    reach: str
    """Who can reach it."""


def openings(configuration: Configuration) -> Iterator[Opening]:
    """What a run of this project would open, for each platform that it may use; and what tools open."""
    yield Opening(IN_PROCESS, "nothing on the network", "no TCP, no UDP")
    yield Opening("all", "a Unix socket for control, where a run listens for it", "only your user")
    yield from _zenoh(configuration)
    spade = configuration.spade
    if spade is None or spade.host is None:
        port = spade.port if spade is not None and spade.port else "any free port"
        yield Opening(SPADE, f"tcp/127.0.0.1, {port}", "every user of this machine (embedded XMPP server)")
    else:
        yield Opening(SPADE, "nothing", f"it connects to {spade.host}")
    if configuration.mango is None:
        yield Opening(MANGO, "tcp/127.0.0.1, any free port, for each agent", "every user of this machine")
    else:
        for name, place in configuration.mango.hosts.items():
            yield Opening(
                MANGO, f"tcp/{place}", f"every machine that reaches {name}'s address: there are no passwords"
            )
    yield Opening("asemec view", "tcp/127.0.0.1, any free port", "who knows the secret in its address")
    yield Opening(
        "asemec lsp",
        "tcp/127.0.0.1, the port of `--tcp`; nothing without it",
        "one editor, of any user of this machine",
    )


def _zenoh(configuration: Configuration) -> Iterator[Opening]:
    deploy = configuration.deploy
    hosts = deploy.hosts if deploy is not None else {}
    interface = deploy.interface if deploy is not None else None
    who = "every holder of a certificate of the team"
    if deploy is None or network_of(deploy, "").local:
        yield Opening(ZENOH, "Unix sockets in a folder with mode 0700", "only your user; no TCP, no UDP")
        return
    for _, mistake in network_mistakes(deploy):
        if isinstance(mistake, Unprotected):
            yield Opening(ZENOH, "nothing", f"no run starts: {mistake.message}")
            return
    for robot in hosts:
        for end in network_of(deploy, robot).listen:
            yield Opening(ZENOH, end, f"{who} ({robot})")
            yield Opening(ZENOH, f"udp/{end.partition('/')[2]}", f"heartbeats, for {who} ({robot})")
    if interface is not None:
        for end in network_of(deploy, "").listen:
            yield Opening(ZENOH, end, f"{who} (robots without a host)")
            yield Opening(ZENOH, f"udp/{interface}, any free port", f"heartbeats, for {who}")
        yield Opening(ZENOH, f"udp/{MULTICAST} on {interface}", "multicast, by which robots find each other")
    elif not hosts:
        yield Opening(ZENOH, "nothing", f"it connects to {', '.join(deploy.connect)}")
