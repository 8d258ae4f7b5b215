"""Heartbeats: what they prove, between whom, and what of strangers, doubles and floods is not taken."""

from __future__ import annotations

import random
import socket
import time
from collections.abc import Iterator

import pytest

from aseme_dsl.runtime.transport import TransportError
from aseme_dsl.runtime.transport.heartbeats import datagram
from aseme_dsl.runtime.transport.heartbeats.addresses import addresses_of, own_addresses
from aseme_dsl.runtime.transport.heartbeats.datagram import (
    BEAT,
    SIZE,
    Beat,
    Introduction,
    introduced,
    introduction_in,
    tag_of,
    written,
)
from aseme_dsl.runtime.transport.heartbeats.heartbeats import Heartbeats
from tests.support.waiting import wait_until

SECOND = 1_000_000_000
LEASE = 400_000_000
LIFE = {"ann": 0xA, "bob": 0xB}


class End:
    """An agent that sends and hears heartbeats."""

    def __init__(self, name: str, other: str, host: str = "127.0.0.1") -> None:
        self.name, self.other = name, other
        self.proofs: list[int] = []
        self.farewells: list[tuple[str, int]] = []
        self.beats = Heartbeats([(host, 0)], LEASE, self.heard, lambda *who: self.farewells.append(who))

    def heard(self, name: str, life: int, moment: int) -> None:
        assert (name, life) == (self.other, LIFE[self.other])
        self.proofs.append(moment)

    def learn(self, end: End) -> None:
        """Take the introduction of another end."""
        given = end.beats.introduction(end.name, self.name, LIFE[self.name])
        self.beats.learn(self.name, end.name, LIFE[end.name], given)


def ends(host: str) -> tuple[End, End]:
    ann, bob = End("ann", "bob", host), End("bob", "ann", host)
    ann.learn(bob)
    bob.learn(ann)
    return ann, bob


@pytest.fixture(params=["127.0.0.1", "::1"])
def pair(request: pytest.FixtureRequest) -> Iterator[tuple[End, End]]:
    try:
        ann, bob = ends(request.param)
    except TransportError:
        pytest.skip(f"NOT TESTED: this machine has no {request.param}")
    for end in (ann, bob):
        end.beats.start()
    yield ann, bob
    for end in (ann, bob):
        end.beats.close()


def test_each_proves_to_the_other_that_it_hears_it(pair: tuple[End, End]) -> None:
    begun = time.monotonic_ns()
    for end in pair:
        wait_until(lambda end=end: len(end.proofs) > 10)
        assert end.proofs == sorted(end.proofs)
        assert begun - SECOND < end.proofs[0] and end.proofs[-1] <= time.monotonic_ns()
        assert end.beats.refused == end.beats.late == 0


def test_who_ends_says_farewell(pair: tuple[End, End]) -> None:
    ann, bob = pair
    wait_until(lambda: ann.proofs and bob.proofs)
    bob.beats.close()
    wait_until(lambda: ann.farewells)
    assert ann.farewells[0] == ("bob", LIFE["bob"])


def test_one_direction_proves_nothing() -> None:
    """Bob hears ann, and says so to nobody: neither knows that it is heard."""
    ann, bob = End("ann", "bob"), End("bob", "ann")
    ann.learn(bob)
    for end in (ann, bob):
        end.beats.start()
    wait_until(lambda: next(iter(bob.beats._peers.values())).newest)
    time.sleep(0.1)
    for end in (ann, bob):
        end.beats.close()
        assert not end.proofs


def test_heartbeats_of_strangers_and_doubles_are_counted_and_prove_nothing() -> None:
    ann = End("ann", "bob")
    given = introduction_in(ann.beats.introduction("ann", "bob", LIFE["bob"]))
    assert given is not None and given.addresses == ann.beats.addresses
    ann.beats.start()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as bob:
        bob.bind(("127.0.0.1", 0))
        known = Introduction(b"b" * 8, b"k" * 32, (bob.getsockname(),))
        ann.beats.learn("ann", "bob", LIFE["bob"], introduced(known))
        bob.settimeout(30)
        beat = datagram.read(bob.recv(1000), known.key)
        assert beat is not None and beat.tag == known.tag and beat.heard == 0

        def send(data: bytes) -> None:
            bob.sendto(data, given.addresses[0])

        right = Beat(BEAT, given.tag, 7, beat.sent)
        whole = written(right, given.key)
        send(b"")
        send(b"\0" * SIZE)
        send(whole + b"\0")
        send(whole[:-1])
        send(written(right, b"x" * 32))  # another key
        send(whole[:-1] + bytes((whole[-1] ^ 1,)))
        wait_until(lambda: ann.beats.refused == 6)
        send(written(right._replace(tag=b"?" * 8), given.key))
        wait_until(lambda: ann.beats.late == 1)
        assert not ann.proofs
        send(whole)
        wait_until(lambda: ann.proofs == [beat.sent])
        send(whole)
        send(written(right._replace(sent=6), given.key))
        wait_until(lambda: ann.beats.late == 3)
        send(written(right._replace(sent=8, heard=time.monotonic_ns() + SECOND), given.key))  # not yet sent
        send(written(right._replace(sent=9, heard=0), given.key))
        send(b"")
        wait_until(lambda: ann.beats.refused == 7)
        assert ann.proofs == [beat.sent]
    ann.beats.close()


def test_a_new_incarnation_has_another_key() -> None:
    ann, bob = ends("127.0.0.1")
    old = introduction_in(ann.beats.introduction("ann", "bob", LIFE["bob"]))
    assert old == introduction_in(ann.beats.introduction("ann", "bob", LIFE["bob"]))
    new = introduction_in(ann.beats.introduction("ann", "bob", 0xB0))
    assert old is not None and new is not None and (old.tag, old.key) != (new.tag, new.key)
    ann.beats._take(written(Beat(BEAT, old.tag, 1, 1), old.key), (None, ()))  # type: ignore[arg-type]
    assert ann.beats.late == 1
    for end in (ann, bob):
        end.beats.close()


def test_in_a_flood_the_others_are_still_heard(pair: tuple[End, End]) -> None:
    ann, bob = pair
    host, port = bob.beats.addresses[0]
    wait_until(lambda: ann.proofs and bob.proofs)
    until = time.monotonic() + 1.0
    with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM) as flood:
        while time.monotonic() < until:
            for _ in range(100):
                flood.sendto(b"\1\0" + b"x" * (SIZE - 2), (host, port))
            time.sleep(0.002)
        before = len(ann.proofs)
    wait_until(lambda: len(ann.proofs) > before + 3)
    assert bob.beats.late > 100


def test_any_bytes_are_no_heartbeat_and_no_introduction() -> None:
    chance = random.Random(3)
    ann = End("ann", "bob")
    for length in [*range(150), SIZE, 500]:
        data = chance.randbytes(length)
        assert tag_of(data) is None or length == SIZE
        ann.beats._take(data, (None, ()))  # type: ignore[arg-type]
        found = introduction_in(data)
        assert found is None or length == 40
    assert ann.beats.refused + ann.beats.late == 152
    ann.beats.close()


@pytest.mark.parametrize(
    "places",
    [
        "224.0.0.1 7447",
        "0.0.0.0 7447",
        "10.0.0.1 0",
        "10.0.0.1 65536",
        "robot 7447",
        "10.0.0.1",
        "::1",
        "x",
        "ff02::1 1",
    ],
)
def test_heartbeats_are_sent_to_single_addresses_only(places: str) -> None:
    assert introduction_in(b"t" * 8 + b"k" * 32 + places.encode()) is None


def test_an_introduction_comes_as_it_went() -> None:
    given = Introduction(b"t" * 8, b"k" * 32, (("10.0.0.1", 7447), ("fd00::1", 7448)))
    assert introduction_in(introduced(given)) == given


@pytest.mark.parametrize(
    ("endpoints", "addresses"),
    [
        (["tls/10.0.0.1:7447"], [("10.0.0.1", 7447)]),
        (["tcp/127.0.0.1:0", "tls/[fd00::1]:7448"], [("127.0.0.1", 0), ("fd00::1", 7448)]),
        (["tls/0.0.0.0:0#iface=127.0.0.1"], [("127.0.0.1", 0)]),
        (["tls/0.0.0.0:7447"], []),
        (["tls/[::]:7447"], []),
        (["unixsock-stream/tmp/x.sock"], []),
        ([], []),
    ],
)
def test_heartbeats_use_the_addresses_of_the_link(
    endpoints: list[str], addresses: list[tuple[str, int]]
) -> None:
    assert list(own_addresses(endpoints)) == addresses


def test_the_addresses_of_an_interface() -> None:
    assert "127.0.0.1" in set(addresses_of("lo"))
    assert not set(addresses_of("no-such-one"))


def test_an_address_that_is_taken_is_told() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        with pytest.raises(TransportError, match=f"UDP port {other.getsockname()[1]}"):
            Heartbeats([other.getsockname()], LEASE, lambda *_: None, lambda *_: None)
