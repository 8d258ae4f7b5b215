"""Datagram: what a heartbeat looks like, and the introduction that allows another agent to send some.

A heartbeat is one UDP datagram of 58 bytes, with numbers in network byte order:

    1   format: 1
    1   kind: BEAT, ASKING (answer at once) or FAREWELL
    8   tag, of the introduction of its receiver
    8   sent: ns of the sender's monotonic clock; it grows with each heartbeat
    8   heard: `sent` of the newest heartbeat that the sender has from the receiver; 0: none
    32  HMAC-SHA-256 of all before it, with the key of the introduction

An introduction is part of a PING or PONG of the link, which protects it. It has 8 bytes of tag, 32 bytes of
key, and the addresses of the agent that introduces itself, as ASCII (`10.0.0.1 7447,fd00::1 7447`).
"""

from __future__ import annotations

import hmac
import ipaddress
import struct
from collections.abc import Iterable
from typing import NamedTuple

BEAT, ASKING, FAREWELL = range(3)
FORMAT = 1
TAG_BYTES = 8
KEY_BYTES = 32
MOST_ADDRESSES = 4
_HEAD = struct.Struct(">BB8sQQ")
SIZE = _HEAD.size + KEY_BYTES
"""Each heartbeat has so many bytes."""
_LARGEST = TAG_BYTES + KEY_BYTES + 64 * MOST_ADDRESSES

Address = tuple[str, int]
"""A numeric address, and a port."""


class Beat(NamedTuple):
    """The members are those of the module's docstring."""

    kind: int
    tag: bytes
    sent: int
    heard: int


class Introduction(NamedTuple):
    """How an agent may be sent heartbeats: with which tag and key, and to which addresses."""

    tag: bytes
    key: bytes
    addresses: tuple[Address, ...]


def written(beat: Beat, key: bytes) -> bytes:
    """A heartbeat as a datagram."""
    head = _HEAD.pack(FORMAT, *beat)
    return head + hmac.digest(key, head, "sha256")


def tag_of(data: bytes) -> bytes | None:
    """The tag that a datagram has if it is a heartbeat; None if it cannot be one."""
    if len(data) != SIZE or data[0] != FORMAT or data[1] not in (BEAT, ASKING, FAREWELL):
        return None
    return data[2 : 2 + TAG_BYTES]


def read(data: bytes, key: bytes) -> Beat | None:
    """The heartbeat in a datagram that has a tag; None if it was not made with this key."""
    head, proof = data[: _HEAD.size], data[_HEAD.size :]
    if not hmac.compare_digest(proof, hmac.digest(key, head, "sha256")):
        return None
    return Beat(*_HEAD.unpack(head)[1:])


def introduced(introduction: Introduction) -> bytes:
    """An introduction as bytes."""
    places = ",".join(f"{host} {port}" for host, port in introduction.addresses)
    return introduction.tag + introduction.key + places.encode("ascii")


def introduction_in(data: bytes) -> Introduction | None:
    """The introduction that these bytes are; None if they are none."""
    if not TAG_BYTES + KEY_BYTES <= len(data) <= _LARGEST:
        return None
    tag, key, places = data[:TAG_BYTES], data[TAG_BYTES:][:KEY_BYTES], data[TAG_BYTES + KEY_BYTES :]
    try:
        found = tuple(usable(place.split(" ") for place in places.decode("ascii").split(",") if place))
    except ValueError:
        return None
    return Introduction(tag, key, found[:MOST_ADDRESSES])


def usable(places: Iterable[list[str]]) -> Iterable[Address]:
    """The addresses of one agent each. Raises ValueError for others, such as those of many."""
    for host, port in places:
        address = ipaddress.ip_address(host)
        if address.is_multicast or address.is_unspecified or not 0 < int(port) < 65536:
            raise ValueError(f"no heartbeat can be sent to {host} {port}")
        yield str(address), int(port)
