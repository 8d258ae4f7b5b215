"""Addresses: where an agent receives heartbeats: at the addresses at which its link listens."""

from __future__ import annotations

import contextlib
import ipaddress
import re
import socket
import struct
from collections.abc import Iterable, Iterator
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.runtime.transport.heartbeats.datagram import MOST_ADDRESSES, Address

_ENDPOINT = re.compile(
    r"(?:tls|tcp|quic|udp)/(?:\[(?P<six>[^]]+)\]|(?P<host>[^:]+)):(?P<port>\d+)(?P<more>[#?].*)?$"
)
_SIOCGIFADDR = 0x8915


def own_addresses(endpoints: Iterable[str]) -> tuple[Address, ...]:
    """The numeric addresses and ports of endpoints such as `tls/10.0.0.1:7447`; a port 0 is any free one.

    An endpoint for all addresses of an interface (`tls/0.0.0.0:0#iface=wlan0`) has those of the interface. An
    endpoint for all addresses of the machine has none: which of them others reach is not known.
    """
    found: list[Address] = []
    for endpoint in endpoints:
        parts = _ENDPOINT.match(endpoint)
        if parts is None:
            continue
        host, port = parts["six"] or parts["host"], int(parts["port"])
        interface = re.search("iface=([^;]+)", parts["more"] or "")
        hosts = addresses_of(interface[1]) if interface and _is_any(host) else _numeric(host)
        found += [(one, port) for one in hosts if not _is_any(one) and (one, port) not in found]
    return tuple(found[:MOST_ADDRESSES])


def addresses_of(interface: str) -> Iterator[str]:
    """The addresses of an interface, which is given by its name or its address."""
    with contextlib.suppress(ValueError):
        yield str(ipaddress.ip_address(interface))
        return
    with contextlib.suppress(OSError, ImportError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        import fcntl

        name = interface.encode()[:15]
        answer = fcntl.ioctl(asked.fileno(), _SIOCGIFADDR, struct.pack("256s", name))
        yield socket.inet_ntoa(answer[20:24])
    with contextlib.suppress(OSError, ValueError):
        for line in outside.read_text(Path("/proc/net/if_inet6")).splitlines():
            digits, _, _, scope, _, name_of_it = line.split()
            if name_of_it == interface and scope == "00":  # a global one: others need no name of an interface
                yield socket.inet_ntop(socket.AF_INET6, bytes.fromhex(digits))


def _numeric(host: str) -> Iterator[str]:
    with contextlib.suppress(OSError, UnicodeError):
        for family, _, _, _, address in socket.getaddrinfo(host, 0, type=socket.SOCK_DGRAM):
            if family in (socket.AF_INET, socket.AF_INET6):
                yield str(address[0]).partition("%")[0]


def _is_any(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_unspecified
    except ValueError:
        return False
